package io.github.circles2d.bench.physics;

import java.util.List;

/**
 * One scene of a row.
 *
 * @param name what tells it from the other scenes of the row
 * @param random whether it draws random numbers, so that seeds make a difference
 * @param measures its figures, in the order in which the run gives them
 * @param run runs it
 */
record Case(String name, boolean random, List<Measure> measures, Run run) {
    /** Runs a scene. */
    interface Run {
        /** The figures, one for each measure. */
        double[] figures(Physics physics, long seed, Effort effort);
    }

    /** Runs a scene that draws no random numbers. */
    interface FixedRun {
        double[] figures(Physics physics, Effort effort);
    }

    static Case random(String name, Run run, Measure... measures) {
        return new Case(name, true, List.of(measures), run);
    }

    static Case fixed(String name, FixedRun run, Measure... measures) {
        return new Case(name, false, List.of(measures), (physics, seed, effort) -> run.figures(physics, effort));
    }
}
