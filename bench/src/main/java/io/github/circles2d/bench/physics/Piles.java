package io.github.circles2d.bench.physics;

import static io.github.circles2d.bench.physics.Scenery.GRAVITY;
import static io.github.circles2d.bench.physics.Scenery.R;

import java.util.Random;

/** Poured piles of circles whose radii differ by up to a fifth, so that they do not fall into even rows. */
final class Piles {
    /** Width of the box for 1,250 circles: the pile is about as high as three quarters of it. */
    private static final double WIDTH = 40;

    /** The greatest circles just have room side by side. */
    private static final double PITCH_X = 2.5 * R;

    private static final double PITCH_Y = 3 * R;
    private static final double JITTER_X = 0.1 * R;
    private static final double JITTER_Y = 0.6 * R;

    /** Steps after which any pile of 1,250 is at rest. */
    private static final int SETTLE = 3000;

    private Piles() {}

    /** The box in which n circles are poured: its width grows with the root of n, and it is open far above the pile. */
    static Setup box(int n) {
        return Setup.box(width(n), 10 * width(n)).withGravity(GRAVITY);
    }

    private static double width(int n) {
        return WIDTH * Math.sqrt(n / 1250.0);
    }

    /** Hangs n circles in rows above the floor, each a little off its place, for gravity to pour them. */
    static void hang(Arena arena, int n, long seed) {
        Random random = new Random(seed);
        int columns = (int) (width(n) / PITCH_X);
        for (int i = 0; i < n; i++) {
            double radius = anyRadius(random);
            double x = (i % columns + 0.5) * PITCH_X + JITTER_X * (random.nextDouble() - 0.5);
            double y = 1.5 * R + i / columns * PITCH_Y + JITTER_Y * (random.nextDouble() - 0.5);
            arena.add(x, y, radius, Scenery.mass(radius));
        }
    }

    /** A radius between 0.8 and 1.2 times the usual one. */
    static double anyRadius(Random random) {
        return R * (0.8 + 0.4 * random.nextDouble());
    }

    /** Pours 1,250 circles and waits until they are at rest. */
    static Arena settled(Physics physics, long seed) {
        Arena arena = physics.open(box(1250));
        hang(arena, 1250, seed);
        arena.step(SETTLE);
        return arena;
    }
}
