package io.github.circles2d.world.model;

/**
 * When two circles that are only sensed touch in a step. Both move evenly from where they were at its start to where they are at its
 * end. They touch if they do so at any time in between, so a fast circle that flies through a small one is noticed.
 *
 * <p>The faster circle of a pair looks for the other, if it is fast: if its path is longer than its radius. Else the seeker does, by a
 * table of pairs of kinds. {@code kernels/world/stages/Sensing.cl} looks in the same way; the numbers of an event are computed here alone.
 *
 * <p>d: position of the circle of higher id minus that of the other, at the start; u: the same of the paths.
 */
public final class SensorRule {
    // ---- the table of pairs of kinds
    // ---------------------------------------------------------------------------------

    /** Nobody looks for a pair. */
    public static final int NONE = 0;

    /** The circle of the second kind looks for that of the first. */
    public static final int FOUND = 1;

    /** The circle of the first kind looks for that of the second. */
    public static final int SEEKS = 2;

    /** Both look, and the one of lower id counts. */
    public static final int BOTH_SEEK = 3;

    private SensorRule() {}

    /** Whether a circle looks for slow ones of any kind. */
    public static boolean isFast(float path, float r) {
        return path > r;
    }

    /**
     * How far around its path a circle looks for others of a level that are slow, or whose path is no longer than its own. With room for
     * what rounding takes, and for a gap in which a touch goes on.
     *
     * @param top greatest radius of the level
     */
    public static float margin(float r, float path, float top) {
        return 1.125f * ((r + top) + CircleMath.max(path, top));
    }

    /**
     * Whether a circle is the one of a pair that has to find it.
     *
     * @param row what the table has of its kind and that of the other
     * @param isFast whether its path is longer than its radius
     * @param otherIsFast the same of the other
     */
    public static boolean finds(
            int row, boolean isFast, float path, int id, boolean otherIsFast, float otherPath, int otherId) {
        if (isFast || otherIsFast) {
            return isFast && (!otherIsFast || path > otherPath || path == otherPath && id < otherId);
        }
        return row == SEEKS || row == BOTH_SEEK && id < otherId;
    }

    /** The share of the step after which two circles are closest. */
    public static float timeOfClosest(float dx, float dy, float ux, float uy) {
        float uu = ux * ux + uy * uy;
        return uu > 0f ? CircleMath.clamp(-(dx * ux + dy * uy) / uu, 0f, 1f) : 0f;
    }

    /** The separation after a share of the step. */
    public static float separation(float dx, float dy, float ux, float uy, float share, float sum) {
        return CircleMath.length(dx + share * ux, dy + share * uy) - sum;
    }

    /** The share of the step after which two circles touch first that do touch. */
    public static float timeOfTouch(float dx, float dy, float ux, float uy, float sum) {
        float b = -(dx * ux + dy * uy);
        float gap = (dx * dx + dy * dy) - sum * sum;
        float disc = CircleMath.max(b * b - (ux * ux + uy * uy) * gap, 0f);
        return gap > 0f && b > 0f ? CircleMath.min(gap / (b + (float) Math.sqrt(disc)), 1f) : 0f;
    }
}
