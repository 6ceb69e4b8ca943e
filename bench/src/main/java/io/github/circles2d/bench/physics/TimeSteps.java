package io.github.circles2d.bench.physics;

import static io.github.circles2d.bench.physics.Scenery.R;
import static io.github.circles2d.bench.physics.Scenery.TIME_STEP;

import java.util.Random;

/** A pile at rest whose time step changes. */
final class TimeSteps {
    private static final int STEPS = 600;

    private TimeSteps() {}

    static Row changed() {
        return Row.withBox2d(
                3,
                "pile of 1,250 at rest at 1/60 s, then 600 steps of another length",
                changed("1/240 s", random -> 1 / 240.0, Measure.shown("rms speed, m/s"))
                        .holds(),
                changed("1/120 s", random -> 1 / 120.0, Measure.shown("rms speed, m/s"))
                        .holds(),
                changed("1/30 s", random -> 1 / 30.0, Measure.shown("rms speed, m/s"))
                        .holds(),
                changed(
                                "1/60 s +-5 %",
                                random -> TIME_STEP * (0.95 + 0.1 * random.nextDouble()),
                                Measure.atMost("rms speed, m/s", 0.03))
                        .holds(),
                changed(
                        "random, 1/120 to 1/30 s",
                        random -> (1 + 3 * random.nextDouble()) / 120,
                        Measure.atMost("rms speed, m/s", 0.1)));
    }

    /** Draws the length of the next step. */
    private interface Lengths {
        double next(Random random);
    }

    private static Case changed(String name, Lengths lengths, Measure rms) {
        return Case.random(
                name,
                (physics, seed, effort) -> run(physics, lengths, seed, effort),
                Measure.atMost("rise of the centre of mass, r", 0.02),
                rms);
    }

    /** The greatest rise over all steps, and the mean of the rms speed over the second half of them. */
    private static double[] run(Physics physics, Lengths lengths, long seed, Effort effort) {
        Random random = new Random(seed);
        try (Arena arena = Piles.settled(physics, seed)) {
            double before = arena.state().centreOfMass();
            double rise = 0;
            double speeds = 0;
            int steps = effort.of(STEPS);
            for (int step = 0; step < steps; step++) {
                arena.step(lengths.next(random), 1);
                State state = arena.state();
                rise = Math.max(rise, state.centreOfMass() - before);
                speeds += step >= steps / 2 ? state.rmsSpeed() : 0;
            }
            return new double[] {rise / R, speeds / (steps - steps / 2)};
        }
    }
}
