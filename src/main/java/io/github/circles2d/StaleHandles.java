package io.github.circles2d;

import io.github.circles2d.world.model.Limits;

/** What a call with many handles does with those that name no circle: whose circles have been removed, or that never were handles. */
public enum StaleHandles {
    /** It throws an IllegalArgumentException that names the handle, and changes nothing. */
    REFUSE,
    /** It leaves them out, with their values, and returns how many they were. */
    SKIP;

    static boolean areSkipped(StaleHandles stale) {
        return Limits.notNull("stale", stale) == SKIP;
    }
}
