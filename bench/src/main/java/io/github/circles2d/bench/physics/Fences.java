package io.github.circles2d.bench.physics;

import static io.github.circles2d.bench.physics.Scenery.R;

import java.util.Random;

/** Fast balls against static circles that leave no way through. */
final class Fences {
    private static final double[] SPEEDS = {0.5, 1, 2, 5, 20, 64, 200};
    private static final int BALLS = 150;
    private static final int STEPS = 60;

    private Fences() {}

    static Row fine() {
        return Row.of(
                11,
                "fence of small static circles, one every r, 150 balls (e = 1) at each of 0.5 to 200 r a step",
                fence("posts of r / 20", R / 20, R, 1, 0.5).holds(),
                fence("posts of r / 50", R / 50, R, 1, 0.5).holds(),
                fence("posts of r / 200", R / 200, R, 1, 0.5).holds());
    }

    static Row narrow() {
        return Row.of(
                12,
                "gaps between static circles of the balls' size, 150 balls at each of 0.5 to 200 r a step",
                fence("gap of 0.9 diameters, e = 0", R, 2 * R * 1.9, 0, 0.15).holds(),
                fence("gap of 0.95 diameters, e = 0", R, 2 * R * 1.95, 0, 0.15),
                fence("gap of 0.9 diameters, e = 0.5", R, 2 * R * 1.9, 0.5, 0.15)
                        .holds(),
                fence("gap of 0.95 diameters, e = 0.5", R, 2 * R * 1.95, 0.5, 0.15)
                        .holds());
    }

    private static Case fence(String name, double post, double pitch, double restitution, double slope) {
        return Case.random(
                name,
                (physics, seed, effort) -> {
                    double passed = 0;
                    double worst = 0;
                    for (double speed : SPEEDS) {
                        Flight flight = new Flight(post, pitch, restitution, slope, speed * R / Scenery.TIME_STEP);
                        double share = flight.passed(physics, seed);
                        passed += share / SPEEDS.length;
                        worst = Math.max(worst, share);
                    }
                    return new double[] {passed, worst};
                },
                Measure.atMost("share that passes", 0),
                Measure.shown("share that passes at the worst speed"));
    }

    /**
     * Balls that fly to the right at a fence along x = 0, most of them near the middle between two posts.
     *
     * @param slope greatest slope of their paths
     */
    private record Flight(double post, double pitch, double restitution, double slope, double speed) {
        double passed(Physics physics, long seed) {
            Random random = new Random(seed);
            double lane = pitch * Math.ceil(4 * R / pitch);
            double half = lane * (BALLS + 2) / 2;
            try (Arena arena = physics.open(Setup.around(400 * R, half).withRestitution(restitution))) {
                for (int i = 0; i < BALLS; i++) {
                    // The middle of a gap, which is between two multiples of the pitch.
                    double gap = -half + lane * (i + 1) + pitch / 2;
                    double way = R + post + (0.1 + random.nextDouble()) * Math.min(speed * Scenery.TIME_STEP, 64 * R);
                    double rise = slope * (2 * random.nextDouble() - 1);
                    double aside = 0.5 * R * Math.pow(2 * random.nextDouble() - 1, 3) - rise * Math.min(way, 2 * R);
                    arena.add(-way, gap + aside, R, Scenery.mass(R), speed, rise * speed);
                }
                long posts = Math.round(2 * half / pitch);
                for (int i = 0; i <= posts; i++) {
                    arena.add(0, -half + i * pitch, post, Double.POSITIVE_INFINITY);
                }
                boolean[] passed = new boolean[BALLS];
                for (int step = 0; step < STEPS; step++) {
                    arena.step(1);
                    State state = arena.state();
                    for (int i = 0; i < BALLS; i++) {
                        passed[i] |= state.x[i] > R / 2 + post;
                    }
                }
                int count = 0;
                for (boolean one : passed) {
                    count += one ? 1 : 0;
                }
                return (double) count / BALLS;
            }
        }
    }
}
