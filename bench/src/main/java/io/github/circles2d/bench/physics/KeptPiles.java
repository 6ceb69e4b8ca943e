package io.github.circles2d.bench.physics;

import static io.github.circles2d.bench.physics.Scenery.GRAVITY;
import static io.github.circles2d.bench.physics.Scenery.R;

import io.github.circles2d.scenes.Scene;
import io.github.circles2d.scenes.Scenes;
import java.util.Random;

/** Piles, columns and a piston that World settled well before. */
final class KeptPiles {
    private KeptPiles() {}

    static double[] packed(Physics physics, long seed, Effort effort) {
        Scene scene = Scenes.packed(1250, seed);
        try (Arena arena = Kept.load(scene, physics)) {
            arena.step(3000);
            State settled = arena.state();
            arena.step(effort.of(3000));
            double radius = 0.0125;
            return new double[] {
                settled.meanDepth() / radius,
                settled.deepest() / radius,
                arena.state().farthestFrom(settled) / radius
            };
        }
    }

    static double[] column(Physics physics, int n) {
        double width = 2.1 * R;
        try (Arena arena = physics.open(Setup.box(width, 100).withGravity(GRAVITY))) {
            for (int i = 0; i < n; i++) {
                arena.add(width / 2, R + 2 * R * i, R, Scenery.mass(R));
            }
            arena.step(4000);
            return new double[] {((2 * n - 1) * R - arena.state().y[n - 1]) / R};
        }
    }

    /** The piston is a circle as wide as the box. */
    static double[] piston(Physics physics, long seed, Effort effort) {
        Random random = new Random(seed);
        double width = 16;
        try (Arena arena = physics.open(Setup.box(width, 100).withGravity(GRAVITY))) {
            int columns = 12;
            for (int i = 0; i < 200; i++) {
                double x = (i % columns + 0.5) * width / columns + 0.05 * (random.nextDouble() - 0.5);
                double radius = Piles.anyRadius(random);
                arena.add(x, 0.7 + i / columns * 1.3, radius, Scenery.mass(R));
            }
            arena.add(width / 2, 35, width / 2 - 0.1, 1000 * Scenery.mass(R));
            arena.step(2000);
            State state = arena.state();
            return new double[] {state.meanDepth() / R, state.deepest() / R};
        }
    }

    static double[] scaled(Physics physics, double scale, long seed) {
        Random random = new Random(seed);
        double width = 40 * scale;
        try (Arena arena = physics.open(Setup.box(width, 3 * width).withGravity(GRAVITY * scale))) {
            for (int i = 0; i < 1250; i++) {
                double radius = Piles.anyRadius(random) * scale;
                double x = (i % 32 + 0.5) * 1.25 * scale;
                arena.add(x, (0.65 + i / 32 * 1.2) * scale, radius, Scenery.mass(radius / scale));
            }
            arena.step(1500);
            return new double[] {arena.state().meanDepth() / R / scale};
        }
    }
}
