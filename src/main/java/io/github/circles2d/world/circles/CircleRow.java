package io.github.circles2d.world.circles;

/** Where the numbers of a circle lie in arrays of circles: four floats per circle in each of three arrays. */
public final class CircleRow {
    /** Floats per circle in each array. */
    public static final int STRIDE = 4;

    // ---- circle
    // ------------------------------------------------------------------------------------------------------

    /** Circle: x of the centre. */
    public static final int X = 0;

    /** Circle: y of the centre. */
    public static final int Y = 1;

    /** Circle: radius. */
    public static final int RADIUS = 2;

    /** Circle: mass. */
    public static final int MASS = 3;

    // ---- motion
    // ------------------------------------------------------------------------------------------------------

    /** Motion: what rounding has left of x. */
    public static final int REMAINDER_X = 0;

    /** Motion: what rounding has left of y. */
    public static final int REMAINDER_Y = 1;

    /** Motion: velocity along x. */
    public static final int VX = 2;

    /** Motion: velocity along y. */
    public static final int VY = 3;

    // ---- traits
    // ------------------------------------------------------------------------------------------------------

    /** Traits: one over the mass; 0 for a fixed circle. */
    public static final int INVERSE_MASS = 0;

    /** Traits: restitution. */
    public static final int RESTITUTION = 1;

    /** Traits: speed that the left wall (positive) or the right wall has given. */
    public static final int WALL_X = 2;

    /** Traits: speed that the lower wall (positive) or the upper wall has given. */
    public static final int WALL_Y = 3;

    private CircleRow() {}
}
