package io.github.circles2d.world.model;

/**
 * When two circles that are only sensed touch in a step: at any time, if both move evenly, so a fast one is noticed that flies
 * through a small one. The faster of a pair looks for the other if its path is longer than its radius, else the seeker by kinds
 * does. d is the position of the higher id minus that of the other, u the same of the paths.
 */
public final class SensorRule {
    public static final int NONE = 0;

    /** The circle of the second kind looks for that of the first. */
    public static final int FOUND = 1;

    public static final int SEEKS = 2;

    /** The one of lower id counts. */
    public static final int BOTH_SEEK = 3;

    private SensorRule() {}

    public static boolean isFast(float path, float r) {
        return path > r;
    }

    /** How far around its path a circle looks for slower ones of a level; top is the greatest radius there. */
    public static float margin(float r, float path, float top) {
        return 1.125f * ((r + top) + CircleMath.max(path, top));
    }

    public static boolean finds(
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

    public static float separation(float dx, float dy, float ux, float uy, float share, float sum) {
        return CircleMath.length(dx + share * ux, dy + share * uy) - sum;
    }

    /** For circles that do touch. */
    public static float timeOfTouch(float dx, float dy, float ux, float uy, float sum) {
        float b = -(dx * ux + dy * uy);
        float gap = (dx * dx + dy * dy) - sum * sum;
        float disc = CircleMath.max(b * b - (ux * ux + uy * uy) * gap, 0f);
        return gap > 0f && b > 0f ? CircleMath.min(gap / (b + (float) Math.sqrt(disc)), 1f) : 0f;
    }
}
