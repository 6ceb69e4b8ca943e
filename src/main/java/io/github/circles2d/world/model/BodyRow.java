package io.github.circles2d.world.model;

/** The motion of a body of terrain in a step: a row of floats for each that moves, from row 1 on. */
public final class BodyRow {
    public static final int PIVOT_X = 0;
    public static final int PIVOT_Y = 1;

    /** Velocity of the pivot. */
    public static final int VX = 2;

    public static final int VY = 3;

    /** Angular velocity. */
    public static final int OMEGA = 4;

    /** Where the first pose stands. */
    public static final int HEAD = 8;

    // of each boundary of sub-steps, from 0 to their number: the pose against that at the start of the step
    public static final int DX = 0;
    public static final int DY = 1;
    public static final int COS = 2;
    public static final int SIN = 3;

    /** Floats of a pose. */
    public static final int POSE = 4;

    private BodyRow() {}

    public static int stride(int subSteps) {
        return HEAD + POSE * (subSteps + 1);
    }

    public static int of(int row, int subSteps) {
        return row * stride(subSteps);
    }

    /** Where the pose of a boundary stands in a row. */
    public static int pose(int boundary) {
        return HEAD + POSE * boundary;
    }
}
