package io.github.circles2d.world.model;

/**
 * The numbers of a joint in arrays, by the joint's id. A joint holds a circle, A, to another one, B, or to an anchor: a place of the world or
 * of a body of terrain. It has a linear part, an angular part, or both.
 */
public final class JointRow {
    public static final int STRIDE = 12;

    // rows
    public static final int ANCHOR_X = 0; // as the step begins
    public static final int ANCHOR_Y = 1;
    public static final int LENGTH = 2;
    public static final int MIN_LENGTH = 3;
    public static final int MAX_LENGTH = 4;
    public static final int MAX_FORCE = 5; // infinite: no limit
    public static final int MAX_TORQUE = 6;
    public static final int SPEED = 7; // of A against B, radians per second
    public static final int BREAK_FORCE = 8; // infinite: never
    public static final int BREAK_TORQUE = 9;
    public static final int DIRECTION_X = 10; // from A to B, at the reference angles
    public static final int DIRECTION_Y = 11;

    /** Ints of a joint. */
    public static final int TRAITS = 8;

    // traits
    public static final int A = 0; // id
    public static final int B = 1; // id, or NONE
    public static final int FORM = 2;
    public static final int SPRING = 3; // row of JointSpring
    public static final int ANCHOR = 4; // row of AnchorRow; 0: at rest
    public static final int SERIAL = 5; // at least 1; differs from that of an earlier joint with the id
    public static final int REFERENCE_A = 6; // angle in units
    public static final int REFERENCE_B = 7;

    public static final int NONE = -1;

    // FORM: the linear part
    public static final int LINEAR = 3; // mask
    public static final int AXIAL = 1; // along the line from A to B
    public static final int POINT = 2; // in both axes
    public static final int DRAG = 3; // in both axes, on the velocity alone

    // FORM: flags
    public static final int RIGID = 1 << 2;
    public static final int ELASTIC = 1 << 3; // by its spring
    public static final int LOWER = 1 << 4; // has a least length
    public static final int UPPER = 1 << 5; // has a greatest length
    public static final int ACROSS = 1 << 6; // keeps its direction

    // FORM: the angular part
    public static final int ANGULAR = 3 << 7; // mask
    public static final int TURN_SPEED = 1 << 7; // a motor
    public static final int TURN_ANGLE = 2 << 7; // a servo, by its spring
    public static final int TURN_RIGID = 3 << 7;

    public static final int COLLIDE = 1 << 9;
    public static final int BREAKABLE = 1 << 10;

    /** The form of an id without a joint. */
    public static final int NO_JOINT = 0;

    private JointRow() {}

    public static int of(int joint) {
        return STRIDE * joint;
    }

    public static int traits(int joint) {
        return TRAITS * joint;
    }
}
