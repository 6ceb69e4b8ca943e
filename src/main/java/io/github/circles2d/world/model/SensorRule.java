package io.github.circles2d.world.model;

/**
 * When two circles that are only sensed touch in a step, if both move evenly. A fast one looks for the other, else the seeker by kinds
 * does. d is the position of the higher id minus the lower's, u the same of the paths.
 */
public final class SensorRule {
    public static final int NONE = 0;

    /** The second kind looks for the first. */
    public static final int FOUND = 1;

    public static final int SEEKS = 2;

    /** Of lower id. */
    public static final int BOTH_SEEK = 3;

    private SensorRule() {}

    public static boolean isFastSensed(float path, float r) {
        return path > r;
    }

    /** Around its path, for slower ones; top is their greatest radius. */
    public static float sensorMargin(float r, float path, float top) {
        return 1.125f * ((r + top) + CircleMath.max(path, top));
    }

    public static boolean findsSensed(
            int row, boolean isFast, float path, int id, boolean otherIsFast, float otherPath, int otherId) {
        if (isFast || otherIsFast) {
            return isFast && (!otherIsFast || path > otherPath || path == otherPath && id < otherId);
        }
        return row == SEEKS || row == BOTH_SEEK && id < otherId;
    }

    public static float timeOfClosest(float dx, float dy, float ux, float uy) {
        float uu = ux * ux + uy * uy;
        return uu > 0f ? CircleMath.clamp(-(dx * ux + dy * uy) / uu, 0f, 1f) : 0f;
    }

    public static float sensedSeparation(float dx, float dy, float ux, float uy, float share, float sum) {
        return CircleMath.length(dx + share * ux, dy + share * uy) - sum;
    }

    /** For circles that do touch. */
    public static float timeSensed(float dx, float dy, float ux, float uy, float sum) {
        float b = -(dx * ux + dy * uy);
        float gap = (dx * dx + dy * dy) - sum * sum;
        float disc = CircleMath.max(b * b - (ux * ux + uy * uy) * gap, 0f);
        return gap > 0f && b > 0f ? CircleMath.min(gap / (b + (float) Math.sqrt(disc)), 1f) : 0f;
    }
}
