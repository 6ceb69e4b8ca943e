package io.github.circles2d.bench.physics;

import static io.github.circles2d.bench.physics.Scenery.GRAVITY;
import static io.github.circles2d.bench.physics.Scenery.R;

import java.util.Random;

/** Boxes that are too full. */
final class Jams {
    private static final int N = 1000;

    /** Mean area of all circles together: their radii are uniform between 0.8 and 1.2 R. */
    private static final double AREA = N * Math.PI * R * R * (1 + 0.04 / 3);

    /** Closing speed of the walls, and the fills at which they start and stop. */
    private static final double CLOSING = 6 * R;

    private static final double FILL_OPEN = 0.4;
    private static final double FILL_CLOSED = 0.75;

    private Jams() {}

    static Row boiling() {
        return Row.withBox2d(
                1, "jam without gravity, fill 0.86, 4,000 steps", boiling(0.2), boiling(0.5), boiling(0.9));
    }

    private static Case boiling(double restitution) {
        return Case.random(
                        "e = " + restitution,
                        (physics, seed, effort) -> {
                            try (Arena arena = jam(physics, 0.86, 0, restitution, seed)) {
                                arena.step(effort.of(4000));
                                State state = arena.state();
                                return new double[] {state.rmsSpeed(), state.deepest() / R};
                            }
                        },
                        Measure.atMost("rms speed, m/s", 0.005),
                        Measure.shown("deepest pair, r"))
                .holds();
    }

    static Row deep() {
        return Row.withBox2d(
                2,
                "over-full box",
                Case.random(
                        "fill 1.1 with gravity, 2,000 steps",
                        Jams::overFull,
                        Measure.atMost("deepest pair, r", 0.4),
                        Measure.atMost("deepest in a wall, r", 0.001)),
                Case.random(
                                "walls close at 6 r/s without gravity",
                                Jams::closing,
                                Measure.atMost("deepest pair while they close, r", 0.4),
                                Measure.atMost("deepest in a wall while they close, r", 0.001),
                                Measure.shown("deepest pair a second later, r"))
                        .holds());
    }

    private static double[] overFull(Physics physics, long seed, Effort effort) {
        try (Arena arena = jam(physics, 1.1, GRAVITY, 0.5, seed)) {
            arena.step(effort.of(2000));
            State state = arena.state();
            return new double[] {state.deepest() / R, state.deepestInWall() / R};
        }
    }

    /** The walls to the left and right close at half the speed each. */
    private static double[] closing(Physics physics, long seed, Effort effort) {
        double height = Math.sqrt(AREA / FILL_CLOSED);
        double open = AREA / FILL_OPEN / height;
        double closed = AREA / FILL_CLOSED / height;
        int steps = (int) ((open - closed) / CLOSING / Scenery.TIME_STEP);
        try (Arena arena = physics.open(Setup.box(open, height))) {
            spread(arena, open, height, seed);
            arena.step(600);
            double deepest = 0;
            double inWall = 0;
            for (int step = 1; step <= steps; step++) {
                double moved = step * CLOSING * Scenery.TIME_STEP / 2;
                arena.setBounds(moved, 0, open - moved, height, Scenery.TIME_STEP);
                arena.step(1);
                State state = arena.state();
                deepest = Math.max(deepest, state.deepest());
                inWall = Math.max(inWall, state.deepestInWall());
            }
            arena.step(Scenery.SECOND);
            return new double[] {deepest / R, inWall / R, arena.state().deepest() / R};
        }
    }

    /** Circles of 0.4 to 0.6 at random places in a square: most overlap at first. */
    static Arena jam(Physics physics, double fill, double gravity, double restitution, long seed) {
        double side = Math.sqrt(AREA / fill);
        Arena arena = physics.open(Setup.box(side, side).withGravity(gravity).withRestitution(restitution));
        spread(arena, side, side, seed);
        return arena;
    }

    private static void spread(Arena arena, double width, double height, long seed) {
        Random random = new Random(seed);
        for (int i = 0; i < N; i++) {
            double x = R + random.nextDouble() * (width - 2 * R);
            double y = R + random.nextDouble() * (height - 2 * R);
            double radius = Piles.anyRadius(random);
            arena.add(x, y, radius, Scenery.mass(radius));
        }
    }
}
