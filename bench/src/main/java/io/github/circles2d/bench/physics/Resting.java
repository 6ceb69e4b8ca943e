package io.github.circles2d.bench.physics;

import static io.github.circles2d.bench.physics.Scenery.GRAVITY;
import static io.github.circles2d.bench.physics.Scenery.R;

import io.github.circles2d.bench.results.Statistics;

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
                pile("poured pile of 1,250, median of three", 1250, 3, 400, 1500),
                pile("poured pile of 5,000", 5000, 1, 700, 2000).harnessOnly(),
                Case.fixed(
                                "column of 100 in a tube of 1.05 diameters",
                                (physics, effort) -> column(physics),
                                Measure.atMost("step of rest", 900))
                        .holds());
    }

    /** The median over some piles: a late slide of a few circles makes a single one rest hundreds of steps later. */
    private static Case pile(String name, int n, int piles, int bound, int limit) {
        return Case.random(
                name,
                (physics, seed, effort) -> {
                    double[] rests = new double[effort.of(piles)];
                    double[] depths = new double[rests.length];
                    for (int i = 0; i < rests.length; i++) {
                        try (Arena arena = physics.open(Piles.box(n))) {
                            Piles.hang(arena, n, piles * seed + i);
                            rests[i] = calmFrom(arena, limit);
                            depths[i] = arena.state().deepest() / R;
                        }
                    }
                    return new double[] {
                        Statistics.of(rests).median(), Statistics.of(depths).median()
                    };
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
