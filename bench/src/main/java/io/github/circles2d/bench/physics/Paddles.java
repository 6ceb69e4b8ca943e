package io.github.circles2d.bench.physics;

import static io.github.circles2d.bench.physics.Scenery.R;

import java.util.Random;

/**
 * Circles that the caller moves, against free balls. The balls are met at most half a sum of radii off the middle with
 * restitution 0.5, so whatever the speeds, a ball that is hit never comes behind what hits it.
 */
final class Paddles {
    private static final int LANES = 64;
    private static final double[] SPEEDS = {0, 0.5, 1, 2, 5, 10};
    private static final double[] DRAGS = {0.1, 0.2, 0.5, 1, 2};
    private static final double[] DRIVES = {0.2, 1, 2, 5, 10};
    private static final int POSTS = 20;
    private static final int BALLS = 120;

    private Paddles() {}

    static Row pushed() {
        return Row.withBox2d(
                13,
                "kinematic circles against free balls",
                paddle(0.05),
                paddle(0.1),
                paddle(0.3),
                paddle(1),
                dragged(0.4),
                dragged(1),
                crowd());
    }

    private static Case paddle(double ball) {
        return Case.random(
                        "paddle of r = 1 and balls of " + ball + ", each at up to 10 of the ball's radii a step",
                        (physics, seed, effort) -> {
                            Random random = new Random(seed);
                            double total = 0;
                            double worst = 0;
                            int pairs = 0;
                            for (double rising : SPEEDS) {
                                for (double falling : SPEEDS) {
                                    if (rising + falling > 0) {
                                        double passed = new Meeting(1, ball, rising * ball, falling * ball)
                                                .passed(physics, random);
                                        total += passed;
                                        worst = Math.max(worst, passed);
                                        pairs++;
                                    }
                                }
                            }
                            return new double[] {total / pairs, worst};
                        },
                        Measure.atMost("share that comes behind it", 0),
                        Measure.shown("at the worst speeds"))
                .holds();
    }

    private static Case dragged(double ratio) {
        return Case.random(
                "circle of r dragged by setPosition at up to 2 r a step through balls of " + ratio + " r",
                (physics, seed, effort) -> {
                    Random random = new Random(seed);
                    double total = 0;
                    double worst = 0;
                    for (double drag : DRAGS) {
                        double passed = new Meeting(R, ratio * R, drag * R, 0).dragged(physics, random);
                        total += passed / DRAGS.length;
                        worst = Math.max(worst, passed);
                    }
                    return new double[] {total, worst};
                },
                Measure.atMost("share that comes behind it", 0),
                Measure.shown("at the worst speed"));
    }

    private static Case crowd() {
        return Case.random(
                "20 circles of r side by side that drive 60 r through 120 balls, at 0.2 to 10 r a step",
                (physics, seed, effort) -> {
                    Random random = new Random(seed);
                    double total = 0;
                    double worst = 0;
                    for (double speed : DRIVES) {
                        double left = leftBehind(physics, random, speed);
                        total += left / DRIVES.length;
                        worst = Math.max(worst, left);
                    }
                    return new double[] {total, worst};
                },
                Measure.atMost("share that comes behind them", 0),
                Measure.shown("at the worst speed"));
    }

    private static double leftBehind(Physics physics, Random random, double radiiPerStep) {
        double way = radiiPerStep * R;
        try (Arena arena = physics.open(Setup.box(2 * R * POSTS, 200 * R).withFastCircles())) {
            for (int i = 0; i < POSTS; i++) {
                arena.add(R + 2 * R * i, 2 * R, R, Double.POSITIVE_INFINITY, 0, way / Scenery.TIME_STEP);
            }
            for (int i = 0; i < BALLS; i++) {
                double r = R * (0.8 + 0.4 * random.nextDouble());
                double x = R * (2.4 + 2.06 * (i % 18) + 0.1 * random.nextDouble());
                double y = R * (4.6 + 2.2 * (i / 18) + 0.2 * random.nextDouble());
                arena.add(x, y, r, Scenery.mass(r), 0, 0);
            }
            arena.step((int) Math.ceil(60 / radiiPerStep));
            State state = arena.state();
            double count = 0;
            for (int i = 0; i < BALLS; i++) {
                count += state.y[POSTS + i] < state.y[0] ? 1 : 0;
            }
            return count / BALLS;
        }
    }

    /**
     * Lanes with one moved circle and one ball each; the moved circle rises, the ball falls.
     *
     * @param rising how far the moved circle goes in a step
     * @param falling how far the ball goes in a step
     */
    private record Meeting(double moved, double ball, double rising, double falling) {
        double passed(Physics physics, Random random) {
            try (Arena arena = start(physics, rising / Scenery.TIME_STEP, random)) {
                arena.step(steps());
                return behind(arena.state());
            }
        }

        double dragged(Physics physics, Random random) {
            try (Arena arena = start(physics, 0, random)) {
                State start = arena.state();
                for (int step = 1; step <= steps(); step++) {
                    for (int lane = 0; lane < LANES; lane++) {
                        arena.setPosition(2 * lane, start.x[2 * lane], start.y[2 * lane] + step * rising);
                    }
                    arena.step(1);
                }
                return behind(arena.state());
            }
        }

        /** Enough for a ball that nothing stops to come out behind, and not enough to reach another lane. */
        private int steps() {
            return 4 + (int) Math.ceil(2.2 * (moved + ball) / (rising + falling));
        }

        private Arena start(Physics physics, double velocity, Random random) {
            double lane = 8 * (moved + ball + rising + falling);
            double height = 2 * (steps() + 4) * (rising + falling) + 10 * (moved + ball);
            Arena arena = physics.open(Setup.around(LANES * lane / 2, height).withFastCircles());
            for (int i = 0; i < LANES; i++) {
                double x = (i + 0.5 - LANES / 2) * lane;
                double aside = 0.5 * (moved + ball) * (2 * random.nextDouble() - 1);
                double gap = 0.01 * ball + 2 * random.nextDouble() * (rising + falling);
                arena.add(x, 0, moved, Double.POSITIVE_INFINITY, 0, velocity);
                double up = moved + ball + gap;
                arena.add(x + aside, up, ball, Scenery.mass(ball), 0, -falling / Scenery.TIME_STEP);
            }
            return arena;
        }

        private static double behind(State state) {
            double count = 0;
            for (int lane = 0; lane < LANES; lane++) {
                count += state.y[2 * lane + 1] < state.y[2 * lane] ? 1 : 0;
            }
            return count / LANES;
        }
    }
}
