package io.github.circles2d.world.shared;

import io.github.circles2d.world.bodies.RigidLimits;
import io.github.circles2d.world.circles.Commands;
import io.github.circles2d.world.circles.KindTable;
import io.github.circles2d.world.joints.JointEnds;
import io.github.circles2d.world.joints.JointForm;
import io.github.circles2d.world.joints.JointSetting;
import io.github.circles2d.world.model.KindField;
import io.github.circles2d.world.model.Limits;
import io.github.circles2d.world.model.TerrainLimits;
import io.github.circles2d.world.model.WallMotion;
import io.github.circles2d.world.terrain.BodyTable;
import java.util.EnumSet;
import java.util.Set;

/**
 * The table of the calls that change a world, one row each: its number, its words and their ranges. A call is its number and its words, of
 * which the first is the id of what it is about. A log has calls in this form, and {@link Calls} makes them. A float is meant by its bits. The
 * ranges of calls on circles are in the methods that make them, which take numbers.
 */
public enum Call {
    /** A new circle, which gets the lowest free id: x, y, radius, mass, vx, vy, kind. */
    ADD(Commands.ADD, 7),

    /** A circle goes. */
    REMOVE(Commands.REMOVE, 1, Named.CIRCLE),

    /** A circle is at once somewhere else: the circle, x, y. */
    POSITION(Commands.POSITION, 3, Named.CIRCLE),

    /** The velocity of a circle: the circle, vx, vy. */
    VELOCITY(Commands.VELOCITY, 3, Named.CIRCLE),

    /** The radius of a circle: the circle, the radius. */
    RADIUS(Commands.RADIUS, 2, Named.CIRCLE),

    /** The mass of a circle: the circle, the mass. */
    MASS(Commands.MASS, 2, Named.CIRCLE),

    /** The restitution of a circle: the circle, the restitution. */
    RESTITUTION(Commands.RESTITUTION, 2, Named.CIRCLE),

    /** An impulse: the circle, x, y. */
    IMPULSE(Commands.IMPULSE, 3, Named.CIRCLE),

    /** The angle of a circle: the circle, the angle in units. */
    ANGLE(Commands.ANGLE, 2, Named.CIRCLE),

    /** The angular velocity of a circle: the circle, the velocity. */
    ANGULAR_VELOCITY(Commands.ANGULAR_VELOCITY, 2, Named.CIRCLE),

    /** An angular impulse: the circle, the impulse. */
    ANGULAR_IMPULSE(Commands.ANGULAR_IMPULSE, 2, Named.CIRCLE),

    /** Steps: length, how many. A replay makes them one by one. */
    STEP(64, 2),

    /** The hash of the state as of now, as two halves. It changes nothing. */
    HASH(65, 2),

    /** Gravity: x, y. */
    GRAVITY(66, 2, (w, settings) -> Limits.gravity(real(w[0]), real(w[1]))),

    /** Bounds: least x, least y, greatest x, greatest y. */
    BOUNDS(67, 4),

    /** A field of a circle: the circle, the field's number, the value as two halves. */
    FIELD(68, 4, Named.CIRCLE),

    /** A circle is put somewhere else, where a static one travels in the next step: the circle, x, y. */
    MOVE(69, 3, Named.CIRCLE),

    /** A force acts in the next step: the circle, x, y. */
    FORCE(70, 3, Named.CIRCLE),

    /** A field of a kind: the kind, the field's number, the value. */
    KIND(71, 3, (w, settings) -> {
        KindTable.check(w[0]);
        kindField(w[1]).check(w[2]);
    }),

    /** What the matrix of kinds has of two of them: both, and that. */
    PAIR_OF_KINDS(72, 3, (w, settings) -> {
        KindTable.check(w[0]);
        KindTable.check(w[1]);
        require(KindTable.isSetting(w[2]), "kinds cannot have the response ", w[2]);
    }),

    /** A circle is to grow: the circle, the radius, steps. */
    GROW(73, 3, Named.CIRCLE),

    /** All circles go. */
    CLEAR(74, 0),

    /** A torque acts in the next step: the circle, the torque. */
    TORQUE(75, 2, Named.CIRCLE),

    /** The surface of a wall: its number, friction, rolling resistance, belt speed. */
    WALL_SURFACE(76, 4, (w, settings) -> Limits.within("the number of the wall", w[0], 0, WallMotion.COUNT - 1)),

    /** A segment of terrain: the body, the kind, x and y of both ends, thickness. */
    SEGMENT(77, 7, Named.BODY, (w, settings) -> {
        KindTable.check(w[1]);
        TerrainLimits.segment(real(w[2]), real(w[3]), real(w[4]), real(w[5]), real(w[6]), settings.bounds());
    }),

    /** An arc, anticlockwise between two angles in radians: the body, the kind, x, y, radius, from, to, whether circles are inside. */
    ARC(78, 8, Named.BODY, (w, settings) -> {
        KindTable.check(w[1]);
        angle("from", w[5]);
        angle("to", w[6]);
        long opening = TerrainLimits.opening(real(w[5]), real(w[6]));
        TerrainLimits.arc(real(w[2]), real(w[3]), real(w[4]), (int) (opening >>> 1), settings.bounds());
        flag(w[7]);
    }),

    /** The first point of a chain, which the calls behind it complete: x, y. */
    CHAIN_START(79, 2),

    /** A line of the chain: x, y of its end. */
    CHAIN_LINE(80, 2),

    /** An arc of the chain: x, y of its centre, the units of its angle as two halves. */
    CHAIN_ARC(81, 4),

    /** The chain is added: the body, the kind, whether it is closed. */
    CHAIN(82, 3, Named.BODY, (w, settings) -> {
        KindTable.check(w[1]);
        flag(w[2]);
    }),

    /** A piece goes. */
    REMOVE_PIECE(83, 1, Named.PIECE),

    /** A piece gets a kind: the piece, the kind. */
    PIECE_KIND(84, 2, Named.PIECE, (w, settings) -> KindTable.check(w[1])),

    /** All terrain goes. */
    CLEAR_TERRAIN(85, 0),

    /** A body of terrain comes: x, y, angle in radians. */
    BODY(86, 3, (w, settings) -> place(w, 0)),

    /** A body goes. */
    REMOVE_BODY(87, 1, Named.BODY, (w, settings) -> movable(w[0], "be removed")),

    /** The velocity of a body: the body, x, y. */
    BODY_VELOCITY(88, 3, Named.BODY, (w, settings) -> {
        movable(w[0], "move");
        Limits.velocity(real(w[1]), real(w[2]));
    }),

    /** The angular velocity of a body: the body, the velocity. */
    BODY_ANGULAR_VELOCITY(89, 2, Named.BODY, (w, settings) -> {
        movable(w[0], "turn");
        Limits.within("the angular velocity", real(w[1]), -Limits.ANGULAR_VELOCITY, Limits.ANGULAR_VELOCITY);
    }),

    /** A body is to travel: the body, x, y, angle in radians. */
    MOVE_BODY(90, 4, Named.BODY, (w, settings) -> {
        movable(w[0], "move");
        place(w, 1);
    }),

    /** A body is put somewhere: the body, x, y, angle in radians. */
    TELEPORT_BODY(91, 4, Named.BODY, MOVE_BODY.range),

    /** What the joints behind it are, as {@link JointForm} has it. */
    JOINT_FORM(92, JointForm.WORDS),

    /** A joint between two circles: both. */
    JOINT(93, 2, Named.CIRCLE),

    /** A joint of a circle with a place: the circle, the body's id, x, y. */
    ANCHORED_JOINT(94, 4, Named.CIRCLE),

    /** A joint of a circle with no place: the circle. */
    JOINT_ALONE(95, 1, Named.CIRCLE),

    /** Something of a joint is set: the joint, the number of the setting, two values. */
    JOINT_SETTING(
            96,
            4,
            Named.JOINT,
            (w, settings) -> require(JointSetting.of(w[1]) != null, "no setting of a joint has the number ", w[1])),

    /** A joint goes. */
    REMOVE_JOINT(97, 1, Named.JOINT),

    /** All joints go. */
    CLEAR_JOINTS(98, 0),

    /** A circle wakes: the circle. */
    WAKE(Commands.WAKE, 1, Named.CIRCLE),

    /** All circles wake. */
    WAKE_ALL(99, 0),

    /**
     * A joint of which an end is a rigid body: of each end its type, an id, x and y. The type is a number of {@link JointEnds}; a body has a point
     * in its coordinates, an anchor the id of its body of terrain and a point of that, a circle no point.
     */
    RIGID_JOINT(100, 8),

    /** An outline that bodies behind it have: how many words it has, and the first of them. */
    OUTLINE(120, 16),

    /** Further words of the outline; those behind its last one are 0. */
    OUTLINE_WORDS(121, 16),

    /** A rigid body: the number of its outline among those of the log, the kind, x, y, angle in radians, mass. */
    RIGID(122, 6, (w, settings) -> {
        KindTable.check(w[1]);
        pose(w, 2, settings);
        RigidLimits.mass(real(w[5]));
    }),

    /** A rigid body goes. */
    REMOVE_RIGID(123, 1, Named.RIGID),

    /** All rigid bodies go. */
    CLEAR_RIGIDS(124, 0),

    /** The velocity of a rigid body: the body, x, y. */
    RIGID_VELOCITY(125, 3, Named.RIGID, (w, settings) -> Limits.velocity(real(w[1]), real(w[2]))),

    /** The angular velocity of a rigid body: the body, the velocity. */
    RIGID_ANGULAR_VELOCITY(
            126,
            2,
            Named.RIGID,
            (w, settings) -> Limits.within(
                    "the angular velocity", real(w[1]), -Limits.ANGULAR_VELOCITY, Limits.ANGULAR_VELOCITY)),

    /** An impulse on a rigid body: the body, x and y of the impulse, those of the point. */
    RIGID_IMPULSE(127, 5, Named.RIGID, (w, settings) -> {
        Limits.impulse(real(w[1]), real(w[2]));
        TerrainLimits.coordinate("x", real(w[3]));
        TerrainLimits.coordinate("y", real(w[4]));
    }),

    /** An angular impulse on a rigid body: the body, the impulse. */
    RIGID_ANGULAR_IMPULSE(
            128,
            2,
            Named.RIGID,
            (w, settings) -> Limits.within("impulse", real(w[1]), -Limits.ANGULAR_IMPULSE, Limits.ANGULAR_IMPULSE)),

    /** A force and a torque act on a rigid body in the next step: the body, x, y, the torque. */
    RIGID_FORCE(129, 4, Named.RIGID, (w, settings) -> {
        Limits.force(real(w[1]), real(w[2]));
        Limits.within("torque", real(w[3]), -Limits.TORQUE, Limits.TORQUE);
    }),

    /** A rigid body gets a kind: the body, the kind. */
    RIGID_KIND(130, 2, Named.RIGID, (w, settings) -> KindTable.check(w[1])),

    /** The tag of a rigid body: the body, the tag as two halves. */
    RIGID_TAG(131, 3, Named.RIGID),

    /** The restitution of a rigid body: the body, the restitution. */
    RIGID_RESTITUTION(132, 2, Named.RIGID, (w, settings) -> Limits.restitution(real(w[1]))),

    /** The moment of inertia of a rigid body: the body, the moment. */
    RIGID_INERTIA(133, 2, Named.RIGID),

    /** A rigid body is put somewhere: the body, x, y, angle in radians. */
    TELEPORT_RIGID(134, 4, Named.RIGID, (w, settings) -> pose(w, 1, settings)),

    /** A force on a rigid body in the next step: the body, x and y of the force, those of the point. */
    RIGID_FORCE_AT(135, 5, Named.RIGID, (w, settings) -> {
        Limits.force(real(w[1]), real(w[2]));
        TerrainLimits.coordinate("x", real(w[3]));
        TerrainLimits.coordinate("y", real(w[4]));
    }),

    /** The force on a rigid body that lasts: the body, x, y. */
    RIGID_LASTING_FORCE(136, 3, Named.RIGID, (w, settings) -> Limits.force(real(w[1]), real(w[2]))),

    /** The torque on a rigid body that lasts: the body, the torque. */
    RIGID_LASTING_TORQUE(
            137, 2, Named.RIGID, (w, settings) -> Limits.within("torque", real(w[1]), -Limits.TORQUE, Limits.TORQUE)),

    /** A rigid body is in an exclusion group: the body, the group. */
    RIGID_GROUP(138, 2, Named.RIGID),

    /** A rigid body wakes: the body. */
    WAKE_RIGID(139, 1, Named.RIGID);

    /** What the first word of a call may be the id of. */
    public enum Named {
        NOTHING,
        CIRCLE,
        PIECE,
        BODY,
        JOINT,
        RIGID
    }

    /** Throws {@link IllegalArgumentException} if a word is out of range. */
    private interface Range {
        void check(int[] words, WorldSettings settings);
    }

    /** Most words of a call. */
    public static final int MOST_WORDS = 16;

    private static final Call[] BY_NUMBER = new Call[256];

    private static final Set<Call> WAKING = EnumSet.of(
            SEGMENT, ARC, CHAIN, REMOVE_PIECE, PIECE_KIND, CLEAR_TERRAIN, REMOVE_BODY, TELEPORT_BODY, WAKE_ALL);

    static {
        for (Call call : values()) {
            BY_NUMBER[call.number] = call;
        }
    }

    /** A log knows the call by it, from 1 to 255: never changed, and never used again. Those below 64 are operations of {@link Commands}. */
    public final int number;

    /** How many there are. */
    public final int words;

    final Named named;
    private final Range range;

    Call(int number, int words, Named named, Range range) {
        this.number = number;
        this.words = words;
        this.named = named;
        this.range = range;
    }

    Call(int number, int words, Range range) {
        this(number, words, Named.NOTHING, range);
    }

    Call(int number, int words, Named named) {
        this(number, words, named, (w, settings) -> {});
    }

    Call(int number, int words) {
        this(number, words, Named.NOTHING);
    }

    /** The call of a number; null if there is none. */
    public static Call of(int number) {
        return BY_NUMBER[number];
    }

    /** Refuses words that are out of range in any state. */
    public void check(int[] w, WorldSettings settings) {
        range.check(w, settings);
    }

    /** Whether all circles wake that sleep: what carries them, or how they meet, may be another then. */
    boolean wakes() {
        return WAKING.contains(this);
    }

    /** The float that a word stands for. */
    public static float real(int word) {
        return Float.intBitsToFloat(word);
    }

    /** The value that two halves make. */
    public static long value(int low, int high) {
        return low & 0xFFFFFFFFL | (long) high << Integer.SIZE;
    }

    private static void require(boolean holds, String otherwise, int word) {
        if (!holds) {
            throw new IllegalArgumentException(otherwise + word);
        }
    }

    private static KindField kindField(int number) {
        KindField field = KindField.ofNumber(number);
        require(field != null, "no field of a kind has the number ", number);
        return field;
    }

    private static void flag(int word) {
        require(word == 0 || word == 1, "a yes or no is ", word);
    }

    private static void angle(String what, int word) {
        Limits.within(what, real(word), -Limits.ANGLE, Limits.ANGLE);
    }

    /** x, y and angle of a body. */
    private static void place(int[] w, int first) {
        TerrainLimits.coordinate("x", real(w[first]));
        TerrainLimits.coordinate("y", real(w[first + 1]));
        angle("angle", w[first + 2]);
    }

    /** x, y and angle of a rigid body, which is within walls. */
    private static void pose(int[] w, int first, WorldSettings settings) {
        Limits.position(real(w[first]), real(w[first + 1]), settings.bounds());
        angle("angle", w[first + 2]);
    }

    private static void movable(int body, String what) {
        if (body == BodyTable.GROUND) {
            throw new IllegalArgumentException("the ground cannot " + what);
        }
    }
}
