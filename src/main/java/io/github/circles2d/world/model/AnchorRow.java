package io.github.circles2d.world.model;

/** The motion of an anchor in a step: of each boundary of sub-steps, from 0 to their number. Row 0 is all zeros, for anchors at rest. */
public final class AnchorRow {
    public static final int DX = 0; // way since the step began
    public static final int DY = 1;
    public static final int VX = 2;
    public static final int VY = 3;
    private static final int STRIDE = 4;

    private AnchorRow() {}

    public static int of(int row, int boundary, int subSteps) {
        return STRIDE * (row * (subSteps + 1) + boundary);
    }
}
