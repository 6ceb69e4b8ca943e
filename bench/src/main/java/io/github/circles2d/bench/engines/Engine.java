package io.github.circles2d.bench.engines;

import io.github.circles2d.scenes.Scene;

/** A physics engine behind the few calls that a comparison needs. One thread at a time. */
public interface Engine extends AutoCloseable {
    /** Builds the scene anew, whatever the engine held before. */
    void load(Scene scene);

    /** Advances by the scene's time step. */
    void step();

    /** Waits until every step has been done; for engines that only enqueue them. */
    default void finish() {}

    /** Reads the state after the last step, in the scene's units and order. */
    void read(Motion motion);

    /** Whether the same start always gives the same end on this machine, to the bit. */
    boolean repeatable();

    @Override
    void close();
}
