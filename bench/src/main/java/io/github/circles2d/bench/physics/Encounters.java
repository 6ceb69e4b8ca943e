package io.github.circles2d.bench.physics;

import static io.github.circles2d.bench.physics.Scenery.R;

import java.util.Random;

/** Pairs of equal elastic circles that meet at all offsets without gravity. */
final class Encounters {
    private static final int SIDE = 20;

    /** Each pair has a square to itself. */
    private static final double CELL = 24 * R;

    private static final double[] SPEEDS = {0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1, 1.1};

    /** How far a mover goes altogether. */
    private static final double WAY = 10 * R;

    private Encounters() {}

    static Row meet() {
        return Row.withBox2d(
                4,
                "two equal elastic circles, 400 offsets, 0.3 to 1.1 r a step",
                Case.random(
                                "one flies, one is at rest",
                                (physics, seed, effort) -> worst(physics, false, seed),
                                measures())
                        .holds(),
                Case.random(
                                "both fly, each at this speed",
                                (physics, seed, effort) -> worst(physics, true, seed),
                                measures())
                        .holds());
    }

    private static Measure[] measures() {
        return new Measure[] {
            Measure.atMost("deepest overlap at any speed, r", 0.05),
            Measure.atMost("mean error of the push's angle at the worst speed, degrees", 0.7),
            Measure.shown("that speed, r a step"),
            Measure.shown("pairs that miss each other")
        };
    }

    private static double[] worst(Physics physics, boolean both, long seed) {
        double[] worst = new double[4];
        for (double speed : SPEEDS) {
            double[] figures = run(physics, speed * R / Scenery.TIME_STEP, both, new Random(seed));
            worst[0] = Math.max(worst[0], figures[0]);
            if (figures[1] > worst[1]) {
                worst[1] = figures[1];
                worst[2] = speed;
            }
            worst[3] += figures[2];
        }
        return worst;
    }

    private static double[] run(Physics physics, double speed, boolean both, Random random) {
        int pairs = SIDE * SIDE;
        double[] offsets = new double[pairs];
        double deepest = 0;
        try (Arena arena = physics.open(Setup.around(SIDE * CELL / 2, SIDE * CELL / 2)
                .withRestitution(1)
                .withFastCircles())) {
            for (int i = 0; i < pairs; i++) {
                double x = (i % SIDE - SIDE / 2 + 0.5) * CELL;
                double y = (i / SIDE - SIDE / 2 + 0.5) * CELL;
                offsets[i] = 1.9 * R * (2 * (i + 0.5) / pairs - 1);
                double gap = (2.2 + 1.2 * random.nextDouble()) * R;
                arena.add(x - gap - (both ? gap : R), y, R, 1, speed, 0);
                arena.add(both ? x + gap : x + R, y + offsets[i], R, 1, both ? -speed : 0, 0);
            }
            int steps = (int) Math.ceil(WAY / (speed * Scenery.TIME_STEP));
            for (int step = 0; step < steps; step++) {
                arena.step(1);
                deepest = Math.max(deepest, arena.state().deepest());
            }
            State end = arena.state();
            double errors = 0;
            int missed = 0;
            for (int i = 0; i < pairs; i++) {
                double pushX = end.vx[2 * i + 1] + (both ? speed : 0);
                double pushY = end.vy[2 * i + 1];
                boolean met = Math.hypot(pushX, pushY) > 1e-4 * speed;
                errors += met ? error(pushX, pushY, offsets[i]) : Math.PI / 2;
                missed += met ? 0 : 1;
            }
            return new double[] {deepest / R, Math.toDegrees(errors / pairs), missed};
        }
    }

    /** The angle between the push that the right circle got and the line of the centres when rigid circles meet. */
    private static double error(double pushX, double pushY, double offset) {
        double normalY = offset / (2 * R);
        double normalX = Math.sqrt(1 - normalY * normalY);
        return Math.abs(Math.atan2(pushX * normalY - pushY * normalX, pushX * normalX + pushY * normalY));
    }
}
