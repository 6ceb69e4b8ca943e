package io.github.circles2d.world.events;

/** The ints of an event, as a device writes them too, and its rank among those of a pair. */
public final class EventRow {
    // From the beginning of a row.
    public static final int LOWER = 0;

    /** The higher id, or the code of a wall. */
    public static final int HIGHER = 1;

    /** One of those below. */
    public static final int RANK = 2;

    /** Where a device writes the number of the step. */
    public static final int STEP = 3;

    /** The first of the values, as bits: approach speed, impulse, normal x, y, point x, y, speed along the surfaces. */
    public static final int FIRST_VALUE = 4;

    /** Ints of a row. */
    public static final int STRIDE = 12;

    // Ranks. Late events are those of a circle that has been removed.
    static final int LATE_HIT = 0;
    static final int LATE_END = 1;
    public static final int BEGIN = 2;
    public static final int HIT = 3;
    public static final int END = 4;

    private static final int[] TYPES = {
        SavedTouches.HIT, SavedTouches.END, ContactEvents.BEGIN, SavedTouches.HIT, SavedTouches.END
    };

    private EventRow() {}

    /** The type of a rank: one of those in {@link ContactEvents}. */
    static int type(int rank) {
        return TYPES[rank];
    }
}
