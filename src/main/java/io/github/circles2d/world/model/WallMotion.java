package io.github.circles2d.world.model;

/**
 * How walls travel in a step: in over the sub-steps, out at once, since circles may have been put there. Lengths and speeds are
 * positive inwards. Arrays are by {@link #of}.
 */
public final class WallMotion {
    public static final int COUNT = 4;

    /** In the step. */
    public final float[] travel = new float[COUNT];

    /** In a sub-step; 0 outwards. */
    public final float[] advance = new float[COUNT];

    public final float[] speed = new float[COUNT];

    private boolean moves;
    private int subSteps;

    /** Of axis 0 or 1 and a {@link Walls#wallSide}. */
    public static int of(int axis, float side) {
        return 2 * axis + (side > 0f ? 0 : 1);
    }

    /** A bit of each wall that presses a circle with these wall impulses. */
    public static int pressing(float impulseX, float impulseY) {
        return (impulseX == 0f ? 0 : 1 << of(0, impulseX)) | (impulseY == 0f ? 0 : 1 << of(1, impulseY));
    }

    /** A wall that is set farther than any circle is large jumps. */
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

    /** Whether a wall is set farther in. */
    public static boolean movesIn(Bounds from, Bounds to) {
        return calm(from, to, 0f).differs(Bounds.EVERYWHERE);
    }

    /** Where nothing is as near to a wall that is set farther in. */
    public static Bounds calm(Bounds from, Bounds to, float far) {
        boolean walledX = to.edgeX() == AxisEdge.WALL;
        boolean walledY = to.edgeY() == AxisEdge.WALL;
        return new Bounds(
                walledX && from.minX() < to.minX() ? to.minX() + far : Float.NEGATIVE_INFINITY,
                walledY && from.minY() < to.minY() ? to.minY() + far : Float.NEGATIVE_INFINITY,
                walledX && from.maxX() > to.maxX() ? to.maxX() - far : Float.POSITIVE_INFINITY,
                walledY && from.maxY() > to.maxY() ? to.maxY() - far : Float.POSITIVE_INFINITY);
    }

    /** Whether a wall jumps that is to start somewhere. */
    public static boolean jumps(Bounds from, Bounds start) {
        return start.edgeX() == AxisEdge.WALL && (from.minX() != start.minX() || from.maxX() != start.maxX())
                || start.edgeY() == AxisEdge.WALL && (from.minY() != start.minY() || from.maxY() != start.maxY());
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
            speed[wall] = Velocity.limitSpeed(travel[wall] / dt);
            moves |= travel[wall] != 0f;
        }
    }

    public boolean any() {
        return moves;
    }

    /** From its last place, at the end of a sub-step. */
    public float behind(int wall, int subStep) {
        return advance[wall] * (subSteps - 1 - subStep);
    }

    /** For smaller circles it jumps, and they have been brought inside. */
    private boolean carries(int wall, float r) {
        return Math.abs(travel[wall]) <= r;
    }

    public float speedFor(int wall, float r) {
        return carries(wall, r) ? speed[wall] : 0f;
    }

    public float sweepFor(int wall, float r) {
        return carries(wall, r) ? advance[wall] : 0f;
    }

    public float travelFor(int wall, float r) {
        return carries(wall, r) ? CircleMath.max(travel[wall], 0f) : 0f;
    }
}
