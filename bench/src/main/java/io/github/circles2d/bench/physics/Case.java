package io.github.circles2d.bench.physics;

import java.util.List;

/**
 * One scene of a row.
 *
 * @param name what tells it from the other scenes of the row
 * @param random whether it draws random numbers, so that seeds make a difference
 * @param measures its figures, in the order in which the run gives them
 * @param run runs it
 * @param check what the tests do with it
 */
record Case(String name, boolean random, List<Measure> measures, Run run, Check check) {
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
        return new Case(name, true, List.of(measures), run, Check.RUNS);
    }

    static Case fixed(String name, FixedRun run, Measure... measures) {
        return new Case(
                name, false, List.of(measures), (physics, seed, effort) -> run.figures(physics, effort), Check.RUNS);
    }

    /** This case, whose bounds the tests assert. */
    Case holds() {
        return new Case(name, random, measures, run, Check.HOLDS);
    }

    /** This case, which takes too long for the tests. */
    Case harnessOnly() {
        return new Case(name, random, measures, run, Check.HARNESS_ONLY);
    }
}
