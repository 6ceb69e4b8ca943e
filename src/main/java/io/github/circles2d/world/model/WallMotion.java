package io.github.circles2d.world.model;

/**
 * How the walls travel in a step: from where they were in the step before to where they are now. A wall that comes in is swept
 * over the sub-steps. One that goes out is where it will be from the start, so that circles may be put there. Both have the velocity
 * of the way that they go in the step. Lengths and speeds are inward ones: positive if the wall comes in.
 *
 * <p>The arrays have an element per wall, by {@link #of}.
 */
public final class WallMotion {
    /** Walls. */
    public static final int COUNT = 4;

    /** What a wall moves in the step. */
    public final float[] travel = new float[COUNT];

    /** What a wall that comes in moves in a sub-step; 0 for others. */
    public final float[] advance = new float[COUNT];

    /** The speed of a wall. */
    public final float[] speed = new float[COUNT];

    private boolean moves;
    private int subSteps;

    WallMotion() {}

    /**
     * The number of a wall.
     *
     * @param axis 0 for x, 1 for y
     * @param side 1 for the lower wall, -1 for the upper, by {@link Walls#wallSide}
     */
    public static int of(int axis, float side) {
        return 2 * axis + (side > 0f ? 0 : 1);
    }

    /**
     * Where walls start that are set to new places. One that is set farther than any circle is large has no motion: it jumps.
     *
     * @param from where they were in the last step
     * @param to where they are now
     * @param greatestRadius of all circles; 0 if there is none
     * @return for each wall where it was, or where it is if it jumps
     */
    public static Bounds start(Bounds from, Bounds to, float greatestRadius) {
        boolean walledX = to.edgeX() == AxisEdge.WALL;
        boolean walledY = to.edgeY() == AxisEdge.WALL;
        return new Bounds(
                        walledX ? start(from.minX(), to.minX(), greatestRadius) : to.minX(),
                        walledY ? start(from.minY(), to.minY(), greatestRadius) : to.minY(),
                        walledX ? start(from.maxX(), to.maxX(), greatestRadius) : to.maxX(),
                        walledY ? start(from.maxY(), to.maxY(), greatestRadius) : to.maxY())
                .with(to.edgeX(), to.edgeY());
    }

    private static float start(float from, float to, float greatestRadius) {
        return from == to || Math.abs(to - from) > greatestRadius ? to : from;
    }

    void set(Bounds from, Bounds to, float dt, int steps) {
        subSteps = steps;
        travel[0] = to.minX() - from.minX();
        travel[1] = from.maxX() - to.maxX();
        travel[2] = to.minY() - from.minY();
        travel[3] = from.maxY() - to.maxY();
        moves = false;
        for (int wall = 0; wall < COUNT; wall++) {
            if (travel[wall] == 0f) {
                travel[wall] = 0f; // not -0, which would change the sign of a velocity of 0
            }
            advance[wall] = travel[wall] > 0f ? travel[wall] / steps : 0f;
            speed[wall] = Motion.limitSpeed(travel[wall] / dt);
            moves |= travel[wall] != 0f;
        }
    }

    /** Whether any wall moves in the step. */
    public boolean any() {
        return moves;
    }

    /** How far a wall is behind its last place at the end of a sub-step. */
    public float behind(int wall, int subStep) {
        return advance[wall] * (subSteps - 1 - subStep);
    }

    /** Whether a circle feels the velocity of a wall: for smaller ones the wall jumps, and they have been brought inside. */
    private boolean carries(int wall, float r) {
        return Math.abs(travel[wall]) <= r;
    }

    /** The speed of a wall for a circle. */
    public float speedFor(int wall, float r) {
        return carries(wall, r) ? speed[wall] : 0f;
    }

    /** What a wall moves in a sub-step, for a circle. */
    public float sweepFor(int wall, float r) {
        return carries(wall, r) ? advance[wall] : 0f;
    }

    /** What a wall that comes in moves in the step, for a circle; 0 for others. */
    public float travelFor(int wall, float r) {
        return carries(wall, r) ? CircleMath.max(travel[wall], 0f) : 0f;
    }
}
