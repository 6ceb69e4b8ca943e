package io.github.circles2d.world.model;

/** Where the numbers of a circle lie in arrays of circles: four floats per circle, in some two. */
public final class CircleRow {
    public static final int STRIDE = 4;

    // circle
    public static final int X = 0;
    public static final int Y = 1;
    public static final int RADIUS = 2;
    public static final int MASS = 3;

    // motion: displacement since the start of the step, velocity
    public static final int DX = 0;
    public static final int DY = 1;
    public static final int VX = 2;
    public static final int VY = 3;

    // traits; the speed that a wall has given is positive if it is the lower one
    public static final int INVERSE_MASS = 0;
    public static final int RESTITUTION = 1;
    public static final int WALL_X = 2;
    public static final int WALL_Y = 3;

    // load, until the circle has moved: velocity before impulses
    public static final int BEFORE_X = 0;
    public static final int BEFORE_Y = 1;

    // load, once the circle has moved: sum of the contacts' impulses
    public static final int IMPULSE_X = 0;
    public static final int IMPULSE_Y = 1;

    // load: whether something carries the circle in this sub-step, and in the next (1, 0)
    public static final int LOADED = 2;
    public static final int LOADED_NEXT = 3;

    // motionClamp: the path that is free; how far the circle may leave it; and, for a circle that stands at a
    // static one, the share of the path that it may go
    public static final int PATH_X = 0;
    public static final int PATH_Y = 1;
    public static final int ALLOWANCE = 2;
    public static final int LIMIT = 3;

    private CircleRow() {}

    public static int of(int slot) {
        return STRIDE * slot;
    }

    public static int slot(int row) {
        return row >> 2;
    }

    /** In arrays of two floats a circle. */
    public static int vector(int slot) {
        return 2 * slot;
    }
}
