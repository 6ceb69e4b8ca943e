package io.github.circles2d.bench.physics;

/**
 * A figure that a case gives.
 *
 * @param what the figure and its unit
 * @param bound what is asked of it
 */
record Measure(String what, Bound bound) {
    static Measure atMost(String what, double greatest) {
        return new Measure(what, Bound.atMost(greatest));
    }

    static Measure atLeast(String what, double least) {
        return new Measure(what, Bound.atLeast(least));
    }

    static Measure shown(String what) {
        return new Measure(what, Bound.NONE);
    }
}
