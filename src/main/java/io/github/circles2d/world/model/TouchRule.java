package io.github.circles2d.world.model;

/** When surfaces touch, for events; no step depends on it. */
public final class TouchRule {
    /** Approach speed without a touch. */
    public static final float NONE = -1f;

    /** Greatest gap in touch, in sums of radii: else a pile at rest would begin and end touches. */
    public static final float SLACK = 0.005f;

    /** Of the approach speed, when a hit is complete. */
    private static final float LEFT = 1f / 64f;

    private TouchRule() {}

    public static float approachSpeed(float vn) {
        return Branchless.positive(-vn);
    }

    /** Not for impulses or separations of -0. */
    public static float greatest(float greatest, float approach, float impulse, float separation) {
        int touching = Branchless.isPositive(impulse) | ~Branchless.isPositive(separation);
        float now = Branchless.choose(touching, approach, NONE);
        // as ints such numbers have the order of the floats
        return Float.intBitsToFloat(Math.max(Float.floatToRawIntBits(greatest), Float.floatToRawIntBits(now)));
    }

    /** Whether the place may be another after the step. */
    public static boolean isFastApproach(float approach, float dt, float radii) {
        return approach * dt > SLACK * radii;
    }

    public static boolean touches(float approach, float separation) {
        return approach >= 0f || separation <= 0f;
    }

    public static boolean staysInTouch(float approach, float separation, float radii) {
        return approach >= 0f || separation <= SLACK * radii;
    }

    /** The threshold is the square of the least speed, unless a hit speed is set: 0 or more. */
    public static boolean isHitSpeed(float approach, float threshold, float hitSpeed) {
        return hitSpeed >= 0f ? approach >= hitSpeed : approach * approach > threshold;
    }

    public static boolean isHit(float approach, float impulse, float threshold, float hitSpeed) {
        return impulse > 0f && isHitSpeed(approach, threshold, hitSpeed);
    }

    public static float touchPoint(float x, float displacement, float normal, float radius, float separation) {
        return (x + displacement) + normal * (radius + 0.5f * separation);
    }

    /** Whether the next step goes on with the hit. */
    public static boolean isIncomplete(float vn, float approach) {
        return -vn > LEFT * approach;
    }
}
