package io.github.circles2d.bench.broadphase;

/** The work of a broad phase over some steps. */
final class Counts {
    /** Pairs whose distance was computed. */
    long tests;

    /** Elements that a sort moved by one place. */
    long swaps;

    /** Nodes of trees that were looked at. */
    long nodes;

    /** Bytes read and written, by each implementation's formula: an estimate, without what caches save or waste. */
    long bytes;

    /** What was counted since an earlier state. */
    Counts since(Counts earlier) {
        Counts difference = new Counts();
        difference.tests = tests - earlier.tests;
        difference.swaps = swaps - earlier.swaps;
        difference.nodes = nodes - earlier.nodes;
        difference.bytes = bytes - earlier.bytes;
        return difference;
    }

    /** The sum of both. */
    Counts plus(Counts other) {
        Counts sum = new Counts();
        sum.tests = tests + other.tests;
        sum.swaps = swaps + other.swaps;
        sum.nodes = nodes + other.nodes;
        sum.bytes = bytes + other.bytes;
        return sum;
    }

    Counts copy() {
        return plus(new Counts());
    }
}
