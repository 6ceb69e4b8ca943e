package io.github.circles2d.bench.physics;

/** What the tests do with a case. */
enum Check {
    /** Nothing: it takes too long for a test. */
    HARNESS_ONLY,
    /** They run it, but its bounds are not all met yet. */
    RUNS,
    /** They hold it to its bounds. */
    HOLDS
}
