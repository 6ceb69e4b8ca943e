package io.github.circles2d.bench.physics;

/** An engine that the scenes run on. */
interface Physics {
    /** An empty world; the caller closes it. */
    Arena open(Setup setup);
}
