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
    WALL_SURFACE(76, 4),

    /** A segment of terrain: the body's id, the kind, x and y of both ends, thickness. */
    SEGMENT(77, 7),

    /** An arc: the body's id, the kind, x, y, radius, from, to, whether circles are inside. */
    ARC(78, 8),

    /** The first point of a chain, which the calls behind it complete: x, y. */
    CHAIN_START(79, 2),

    /** A line of the chain: x, y of its end. */
    CHAIN_LINE(80, 2),

    /** An arc of the chain: x, y of its centre, the units of its angle as two halves. */
    CHAIN_ARC(81, 4),

    /** The chain is added: the body's id, the kind, whether it is closed. */
    CHAIN(82, 3),

    /** A piece goes: its id. */
    REMOVE_PIECE(83, 1),

    /** A piece gets a kind: its id, the kind. */
    PIECE_KIND(84, 2),

    /** All terrain goes. */
    CLEAR_TERRAIN(85, 0),

    /** A body of terrain comes: x, y, angle. */
    BODY(86, 3),

    /** A body goes: its id. */
    REMOVE_BODY(87, 1),

    /** The velocity of a body: its id, x, y. */
    BODY_VELOCITY(88, 3),

    /** The angular velocity of a body: its id, the velocity. */
    BODY_ANGULAR_VELOCITY(89, 2),

    /** A body is to travel: its id, x, y, angle. */
    MOVE_BODY(90, 4),

    /** A body is put somewhere: its id, x, y, angle. */
    TELEPORT_BODY(91, 4),

    /** What the joints behind it are, as {@link io.github.circles2d.world.joints.JointForm} has it. */
    JOINT_FORM(92, 12),

    /** A joint between two circles: their ids. */
    JOINT(93, 2),

    /** A joint of a circle with a place: the circle's id, the body's id, x, y. */
    ANCHORED_JOINT(94, 4),

    /** A joint of a circle with no place: its id. */
    JOINT_ALONE(95, 1),

    /** Something of a joint is set: its id, the number of the setting, two values. */
    JOINT_SETTING(96, 4),

    /** A joint goes: its id. */
    REMOVE_JOINT(97, 1),

    /** All joints go. */
    CLEAR_JOINTS(98, 0);

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
