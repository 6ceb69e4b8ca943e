package io.github.circles2d.world.joints;

/** What an end of a joint can be. Logs have these numbers. */
public final class JointEndType {
    public static final int CIRCLE = 0;

    /** A body that is pushed. */
    public static final int RIGID = 1;

    /** A place of the world, or of a body of terrain. */
    public static final int ANCHOR = 2;

    /** The world, without a place. */
    public static final int NOTHING = 3;

    private JointEndType() {}
}
