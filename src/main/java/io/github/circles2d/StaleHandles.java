package io.github.circles2d;

import io.github.circles2d.world.model.Limits;

/** How a call with many handles treats stale ones: handles whose circles or bodies have been removed, and numbers that never were handles. */
public enum StaleHandles {
    /** It throws an IllegalArgumentException that names the handle, and changes nothing. */
    REFUSE,
    /** It leaves them out, with their values, and returns how many there were. */
    SKIP;

    static boolean areSkipped(StaleHandles stale) {
        return Limits.notNull("stale", stale) == SKIP;
    }
}
