package io.github.circles2d.bench.physics;

import java.util.Random;

/** A large ball that flies into a field of pebbles. */
final class Pebbles {
    private static final double BALL = 1;
    private static final double PEBBLE = 0.1;
    private static final int LANES = 20;
    private static final double LANE = 8;
    private static final double FIELD = 10;
    private static final double[] SPEEDS = {0.5, 0.7, 0.9, 1.1};
    private static final double[] MOST = {0.04, 0.02, 0.02, 0.02};

    private Pebbles() {}

    static Row swallowed() {
        Case[] cases = new Case[SPEEDS.length];
        for (int i = 0; i < SPEEDS.length; i++) {
            double speed = SPEEDS[i];
            cases[i] = Case.random(
                            speed + " R a step",
                            (physics, seed, effort) -> run(physics, speed, seed),
                            Measure.atMost("pebbles in its way that were wholly inside it, share", MOST[i]))
                    .holds();
        }
        return Row.of(
                5, "ball of radius R into pebbles of R / 10 (one in each square of R), density 1, e = 0.5", cases);
    }

    private static double[] run(Physics physics, double speed, long seed) {
        Random random = new Random(seed);
        try (Arena arena = physics.open(Setup.box(60, LANES * LANE))) {
            for (int lane = 0; lane < LANES; lane++) {
                double x = 10 - BALL - 1.5 * random.nextDouble();
                arena.add(x, laneY(lane), BALL, Scenery.mass(BALL), speed * BALL / Scenery.TIME_STEP, 0);
            }
            for (int lane = 0; lane < LANES; lane++) {
                scatter(arena, laneY(lane), random);
            }
            boolean[] inside = new boolean[arena.state().size()];
            int perLane = (inside.length - LANES) / LANES;
            State start = arena.state();
            int steps = (int) (1.5 * FIELD / speed);
            for (int step = 0; step < steps; step++) {
                arena.step(1);
                State state = arena.state();
                for (int i = LANES; i < inside.length; i++) {
                    inside[i] |= state.distance(i, (i - LANES) / perLane) < BALL - PEBBLE;
                }
            }
            int met = 0;
            int swallowed = 0;
            for (int i = LANES; i < inside.length; i++) {
                if (Math.abs(start.y[i] - laneY((i - LANES) / perLane)) < BALL - PEBBLE) {
                    met++;
                    swallowed += inside[i] ? 1 : 0;
                }
            }
            return new double[] {(double) swallowed / met};
        }
    }

    private static double laneY(int lane) {
        return (lane + 0.5) * LANE;
    }

    /** One pebble at a random place of each square of side R. */
    private static void scatter(Arena arena, double middle, Random random) {
        for (double x = 10; x < 10 + FIELD; x += BALL) {
            for (double y = middle - 3 * BALL; y < middle + 3 * BALL; y += BALL) {
                double u = x + PEBBLE + (BALL - 2 * PEBBLE) * random.nextDouble();
                double v = y + PEBBLE + (BALL - 2 * PEBBLE) * random.nextDouble();
                arena.add(u, v, PEBBLE, Scenery.mass(PEBBLE));
            }
        }
    }
}
