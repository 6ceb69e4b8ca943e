package io.github.circles2d.world.model;

/** The floats of a circle in arrays. */
public final class CircleRow {
    public static final int STRIDE = 4;

    // circle
    public static final int X = 0;
    public static final int Y = 1;
    public static final int RADIUS = 2;
    public static final int MASS = 3;

    // motion
    public static final int DX = 0;
    public static final int DY = 1;
    public static final int VX = 2;
    public static final int VY = 3;

    // traits; wall impulses are speeds, positive from the lower wall
    public static final int INVERSE_MASS = 0;
    public static final int RESTITUTION = 1;
    public static final int WALL_X = 2;
    public static final int WALL_Y = 3;

    // load, until the circle has moved: velocity before impulses
    public static final int BEFORE_X = 0;
    public static final int BEFORE_Y = 1;

    // load, once it has: sum of impulses
    public static final int IMPULSE_X = 0;
    public static final int IMPULSE_Y = 1;

    // load: 1 if something carries the circle, else 0
    public static final int LOADED = 2;
    public static final int LOADED_NEXT = 3;

    // motionClamp: free path; how far the circle may leave it; its share at a static circle
    public static final int PATH_X = 0;
    public static final int PATH_Y = 1;
    public static final int ALLOWANCE = 2;
    public static final int LIMIT = 3;

    // spin, within a step: surface speed; sum of impulses on it; sum of the surface speeds of sub-steps; inverse
    // inertia
    public static final int SURFACE_SPEED = 0;
    public static final int SPIN_IMPULSE = 1;
    public static final int TURNED = 2;
    public static final int INVERSE_INERTIA = 3;

    private CircleRow() {}

    public static int of(int slot) {
        return STRIDE * slot;
    }

    public static int slot(int row) {
        return row >> 2;
    }

    /** Where a circle has two floats. */
    public static int vector(int slot) {
        return 2 * slot;
    }
}
