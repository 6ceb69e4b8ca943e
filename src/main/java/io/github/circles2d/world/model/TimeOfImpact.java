package io.github.circles2d.world.model;

/**
 * When circles touch that move evenly, as a share of their motion; more than 1 if they do not. d is the second position minus the first, u
 * the first motion minus the second, sum that of the radii.
 */
public final class TimeOfImpact {
    private TimeOfImpact() {}

    /** Negative in the wall. Walls are as at the end of the step, and have come in by travel. */
    public static float timeOfWall(float x, float p, float r, float min, float max, float travelMin, float travelMax) {
        float low = ((min - travelMin) + r) - x;
        float high = ((max + travelMax) - r) - x;
        float toMin = p - travelMin; // against the wall
        float toMax = p - (0f - travelMax); // for no travel p itself, a zero with its sign
        return toMin < 0f && toMin < low ? low / toMin : toMax > 0f && toMax > high ? high / toMax : 1f;
    }

    public static float timeOfTouch(float dx, float dy, float ux, float uy, float sum) {
        float b = dx * ux + dy * uy;
        float a = ux * ux + uy * uy;
        float c = (dx * dx + dy * dy) - sum * sum;
        float disc = b * b - a * c;
        if (!(b > 0f) || !(disc >= 0f)) {
            return 2f;
        }
        return CircleMath.max(c, 0f) / (b + (float) Math.sqrt(disc));
    }

    /** Not of circles that only graze each other, which get no deeper than that. */
    public static float timeOfImpactBeyond(float dx, float dy, float ux, float uy, float sum, float graze) {
        float deep = timeOfTouch(dx, dy, ux, uy, sum - graze);
        return deep < 1f ? timeOfTouch(dx, dy, ux, uy, sum) : 2f;
    }

    public static float timeOfImpact(float dx, float dy, float ux, float uy, float sum) {
        return timeOfImpactBeyond(dx, dy, ux, uy, sum, Tuning.GRAZE * sum);
    }

    /** Whether a circle at rest ends deep in a static one, or behind it. */
    public static boolean isRunOver(float dx, float dy, float px, float py, float r, float sum) {
        float x = dx - px;
        float y = dy - py;
        return x * px + y * py < 0f || !CircleMath.isLonger(x, y, sum - Tuning.RUN_OVER * r);
    }

    /**
     * A time, or an earlier one at which it would touch a slow circle at the end of that one's path, so that none runs into it. With a sum
     * that leaves a small gap, their contact is rigid in the next step, not soft.
     */
    public static float beforeSlow(
            float t, float dx, float dy, float px, float py, float pathX, float pathY, float sum) {
        return CircleMath.min(timeOfTouch(dx + pathX, dy + pathY, px, py, sum), t);
    }

    /** When a static circle takes another along, which goes a share of its path and waits; 1 if only a sudden stop leads to that. */
    public static float timeOfCarry(
            float dx, float dy, float px, float py, float pathX, float pathY, float share, float r, float sum) {
        float t = timeOfImpact(dx, dy, px - pathX, py - pathY, sum);
        if (t < share) {
            return t;
        }
        float x = dx + share * pathX;
        float y = dy + share * pathY;
        t = CircleMath.max(timeOfImpact(x, y, px, py, sum), share);
        if (t < 1f && isRunOver(x, y, px, py, r, sum)) {
            return t;
        }
        boolean meets = timeOfImpact(dx, dy, px, py, sum) < 1f;
        return meets && isRunOver(dx, dy, px, py, r, sum) ? 1f : 2f;
    }
}
