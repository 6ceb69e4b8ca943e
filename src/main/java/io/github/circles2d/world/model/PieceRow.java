package io.github.circles2d.world.model;

/**
 * The numbers of a piece of terrain in arrays, in the coordinates of the world as a step begins. A line has a start, an end and a front, which is
 * its right; an arc has a centre. (X, Y) is the start of a line and the centre of an arc; ends are relative to it.
 */
public final class PieceRow {
    public static final int STRIDE = 20;

    public static final int X = 0;
    public static final int Y = 1;

    /** Unit direction: of a line, from its start to its end; of an arc, from the centre to the middle. */
    public static final int TX = 2;

    public static final int TY = 3;

    /** Of a line; the radius of an arc. */
    public static final int LENGTH = 4;

    /** Of an arc: the cosine of half its opening, {@link #ALL_AROUND} for a circle. */
    public static final int SPREAD = 5;

    /** Radius around a segment. */
    public static final int THICKNESS = 6;

    /** How far a point of the piece moves at most in the step. */
    public static final int MOST = 7;

    public static final int START_X = 8;
    public static final int START_Y = 9;
    public static final int END_X = 10;
    public static final int END_Y = 11;

    /** Unit direction in which the next piece of a chain leaves the end. */
    public static final int NEXT_X = 12;

    public static final int NEXT_Y = 13;

    /** Middle of the box. */
    public static final int MID_X = 14;

    public static final int MID_Y = 15;

    /** Half the extent of the box, with the thickness, without the motion in the step. */
    public static final int HALF_X = 16;

    public static final int HALF_Y = 17;

    /** What the body turns around, against (X, Y): on an axis that wraps, where the piece is. */
    public static final int PIVOT_X = 18;

    public static final int PIVOT_Y = 19;

    /** Less than any cosine. */
    public static final float ALL_AROUND = -2f;

    // the whole numbers of a piece
    public static final int TRAITS = 4;

    /** Form and joints. */
    public static final int SHAPE = 0;

    /** The row of its body in {@link BodyRow}, in this step; 0 at rest. */
    public static final int MOTION = 1;

    public static final int KIND = 2;

    /** Another one once the piece of the id is another, or has jumped. */
    public static final int SERIAL = 3;

    // SHAPE: form
    public static final int FORM = 3;
    public static final int NO_PIECE = 0;

    /** Solid on both sides. */
    public static final int SEGMENT = 1;

    /** Line of a chain. */
    public static final int LINE = 2;

    public static final int ARC = 3;

    /** Of an arc: circles are inside. */
    public static final int SOLID_OUTSIDE = 4;

    // SHAPE: joints, of the start and of the end
    public static final int START_LOG = 3;
    public static final int END_LOG = 5;
    public static final int JOINT = 3;
    public static final int FREE = 0;

    /** Or straight. */
    public static final int CONVEX = 1;

    public static final int CONCAVE = 2;

    private PieceRow() {}

    public static int of(int piece) {
        return STRIDE * piece;
    }

    public static int traits(int piece) {
        return TRAITS * piece;
    }

    public static int form(int shape) {
        return shape & FORM;
    }

    public static int startJoint(int shape) {
        return shape >> START_LOG & JOINT;
    }

    public static int endJoint(int shape) {
        return shape >> END_LOG & JOINT;
    }
}
