package io.github.circles2d.bench.physics;

import static io.github.circles2d.bench.physics.Scenery.R;

/** Circles that grow within a pile, as those of a merge game do. */
final class Growth {
    private static final double GROWN = 0.8;

    private Growth() {}

    static Row sudden() {
        return Row.withBox2d(
                7,
                "pile of 1,250 at rest, every tenth radius 0.5 -> 0.8 at once",
                Case.random(
                                "300 steps",
                                Growth::run,
                                Measure.atMost("rise of the centre of mass, r", 8),
                                Measure.atMost("deepest pair after 2 s, r", 0.1),
                                Measure.shown("rise that stays, r"))
                        .holds());
    }

    private static double[] run(Physics physics, long seed, Effort effort) {
        try (Arena arena = Piles.settled(physics, seed)) {
            double before = arena.state().centreOfMass();
            for (int i = 0; i < arena.state().size(); i += 10) {
                arena.setRadius(i, GROWN);
            }
            double rise = 0;
            double deepest = 0;
            for (int step = 1; step <= 300; step++) {
                arena.step(1);
                rise = Math.max(rise, arena.state().centreOfMass() - before);
                if (step == 2 * Scenery.SECOND) {
                    deepest = arena.state().deepest();
                }
            }
            arena.step(effort.of(1200));
            return new double[] {rise / R, deepest / R, (arena.state().centreOfMass() - before) / R};
        }
    }
}
