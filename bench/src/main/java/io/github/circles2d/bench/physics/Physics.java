package io.github.circles2d.bench.physics;

/** An engine that the scenes run on. */
interface Physics {
    /** Its name in tables. */
    String name();

    /**
     * Opens an empty world, which the caller closes.
     *
     * @throws UnsupportedOperationException if a scene with this setup says nothing about the engine
     */
    Arena open(Setup setup);
}
