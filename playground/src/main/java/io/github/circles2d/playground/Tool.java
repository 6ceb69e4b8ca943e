package io.github.circles2d.playground;

import java.util.List;

/** What a mouse does to a world. Places are in the coordinates of the world, and may lie outside the walls. */
interface Tool {
    void press(Sandbox sandbox, float x, float y, float brush);

    /** The mouse has moved with its button down. */
    void drag(Sandbox sandbox, float x, float y);

    void release(Sandbox sandbox);

    /** Runs before each step. */
    default void beforeStep(Sandbox sandbox) {}

    /** Lets go without a look at the world, which has failed. */
    default void forget() {}

    /** The world has gone back in time. */
    default void wentBack(Sandbox sandbox) {}

    /** Adds what is to be seen of the tool; once a frame. */
    default void mark(Sandbox sandbox, List<Mark> marks) {}

    /** How far the tool reaches, for a brush of 1. */
    default float reach(Grain grain) {
        return 0;
    }
}
