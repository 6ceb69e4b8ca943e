package io.github.circles2d;

/** What a call with many handles does with those that name no circle: whose circles have been removed, or that never were handles. */
public enum StaleHandles {
    /** It throws an IllegalArgumentException that names the handle, and changes nothing. */
    REFUSE,
    /** It leaves them out, with their values, and returns how many they were. */
    SKIP;

    boolean skips() {
        return this == SKIP;
    }
}
