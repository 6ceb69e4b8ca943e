package io.github.circles2d.world.shared;

/**
 * The table of the calls of a log that are no {@link io.github.circles2d.world.circles.Commands}, one row each. Commands are in the log
 * with their operations for numbers, and need no row.
 */
public enum LoggedCall {
    /** Steps: length, how many. {@link LogPlayer} makes them one by one. */
    STEP(64, 2),

    /** The hash of the state as of now, as two halves. */
    HASH(65, 2),

    /** Gravity: x, y. */
    GRAVITY(66, 2),

    /** Bounds: least x, least y, greatest x, greatest y. */
    BOUNDS(67, 4),

    /** A field of a circle: the field's number, the circle's id, the value as two halves. */
    FIELD(68, 4),

    /** A static circle is to travel: the circle's id, x, y. */
    TRAVEL(69, 3),

    /** A force acts in the next step: the circle's id, x, y. */
    FORCE(70, 3),

    /** A field of a kind: the kind, the field's number, the value. */
    KIND(71, 3),

    /** What the matrix of kinds has of two of them: both, and that. */
    PAIR_OF_KINDS(72, 3),

    /** A circle is to grow: the circle's id, the radius, steps. */
    GROW(73, 3),

    /** All circles go. */
    CLEAR(74, 0),

    /** A torque acts in the next step: the circle's id, the torque. */
    TORQUE(75, 2),

    /** The surface of a wall: its number, friction, rolling resistance, belt speed. */
    WALL_SURFACE(76, 4);

    /** Numbers from here on are those of this table; lower ones are operations of commands. */
    public static final int FIRST = 64;

    /** Most words of a call. */
    public static final int MOST_WORDS = 16;

    private static final LoggedCall[] BY_NUMBER = new LoggedCall[256];

    static {
        for (LoggedCall call : values()) {
            BY_NUMBER[call.number] = call;
        }
    }

    public final int number;
    public final int words;

    /** A log knows the call by its number, from {@link #FIRST} to 255: never changed, and never used again. It has so many ints. */
    LoggedCall(int number, int words) {
        this.number = number;
        this.words = words;
    }

    /** The call of a number; null if there is none. */
    public static LoggedCall of(int number) {
        return BY_NUMBER[number];
    }

    /** The value that two halves make. */
    public static long value(int low, int high) {
        return low & 0xFFFFFFFFL | (long) high << Integer.SIZE;
    }
}
