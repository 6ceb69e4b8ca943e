package io.github.circles2d.bench.physics;

import static io.github.circles2d.bench.physics.Scenery.GRAVITY;
import static io.github.circles2d.bench.physics.Scenery.R;

/** A tube that leaves its circles no room at all. */
final class Tubes {
    private Tubes() {}

    static Row oneDiameter() {
        return Row.of(
                15,
                "tube of exactly one diameter, 2,000 steps",
                tube("one circle, upright", 1, true),
                tube("ten circles, upright", 10, true),
                tube("one circle, lying", 1, false),
                tube("ten circles, lying", 10, false));
    }

    private static Case tube(String name, int n, boolean upright) {
        return Case.fixed(
                        name,
                        (physics, effort) -> run(physics, n, upright, effort.of(2000)),
                        Measure.atMost("greatest speed at the end, m/s", 0.001))
                .holds();
    }

    /** The circles start at 1 r/s towards a wall, with gaps of a tenth of a radius. */
    private static double[] run(Physics physics, int n, boolean upright, int steps) {
        double length = 3 * R * n;
        Setup setup = upright ? Setup.box(2 * R, length) : Setup.box(length, 2 * R);
        try (Arena arena = physics.open(setup.withGravity(GRAVITY))) {
            for (int i = 0; i < n; i++) {
                double along = R + 2.1 * R * i;
                if (upright) {
                    arena.add(R, along, R, Scenery.mass(R), R, 0);
                } else {
                    arena.add(along, R, R, Scenery.mass(R), 0, R);
                }
            }
            arena.step(steps);
            return new double[] {arena.state().greatestSpeed()};
        }
    }
}
