package io.github.circles2d.bench.physics;

import static io.github.circles2d.bench.physics.Scenery.GRAVITY;
import static io.github.circles2d.bench.physics.Scenery.R;

/** How soon what falls lies still. */
final class Resting {
    /** A pile is at rest from the step on after which its rms speed stays below this. */
    static final double CALM = 0.01;

    /** Nothing stirs a pile that has been calm for this many steps. */
    private static final int LONG = 600;

    private Resting() {}

    static Row soon() {
        return Row.withBox2d(
                10,
                "steps until the rms speed stays below 0.01 m/s",
                pile("poured pile of 1,250", 1250, 400, 1500),
                pile("poured pile of 5,000", 5000, 700, 2000).harnessOnly(),
                Case.fixed(
                        "column of 100 in a tube of 1.05 diameters",
                        (physics, effort) -> column(physics),
                        Measure.atMost("step of rest", 900)));
    }

    private static Case pile(String name, int n, int bound, int limit) {
        return Case.random(
                name,
                (physics, seed, effort) -> {
                    try (Arena arena = physics.open(Piles.box(n))) {
                        Piles.hang(arena, n, seed);
                        return new double[] {
                            calmFrom(arena, limit), arena.state().deepest() / R
                        };
                    }
                },
                Measure.atMost("step of rest", bound),
                Measure.shown("deepest pair at the end, r"));
    }

    private static double[] column(Physics physics) {
        double width = 2.1 * R;
        try (Arena arena = physics.open(Setup.box(width, 150).withGravity(GRAVITY))) {
            for (int i = 0; i < 100; i++) {
                arena.add(width / 2, R + 2 * R * i, R, Scenery.mass(R));
            }
            return new double[] {calmFrom(arena, 4000)};
        }
    }

    /** The step after which the rms speed stays low; the limit if it does not before. */
    private static int calmFrom(Arena arena, int limit) {
        int calm = 0;
        for (int step = 1; step <= limit && step - calm < LONG; step++) {
            arena.step(1);
            if (arena.state().rmsSpeed() >= CALM) {
                calm = step;
            }
        }
        return calm;
    }
}
