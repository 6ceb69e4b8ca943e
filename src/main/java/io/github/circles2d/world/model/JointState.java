package io.github.circles2d.world.model;

/** What a joint keeps from step to step, by its id: impulses on B; on A they are the opposite. */
public final class JointState {
    public static final int STRIDE = 8;

    public static final int AXIAL = 0; // along the line from A to B, or along x
    public static final int ACROSS = 1; // along the tangent, or along y
    public static final int LOWER = 2; // at the least length
    public static final int UPPER = 3; // at the greatest length, positive if it pulls
    public static final int ANGULAR = 4; // on A

    // sums over the sub-steps of the last step
    public static final int SUM_X = 5;
    public static final int SUM_Y = 6;
    public static final int SUM_ANGULAR = 7;

    private JointState() {}

    public static int of(int joint) {
        return STRIDE * joint;
    }
}
