package io.github.circles2d.world.model;

/**
 * When surfaces touch, for events; nothing here changes a step. A contact records its greatest approach speed of the sub-steps in
 * which it touched, before impulses, and the sum of its impulses.
 */
public final class TouchRule {
    /** The approach speed of surfaces that have not touched. */
    public static final float NONE = -1f;

    /** They stay in touch up to this gap, in sums of radii: else a pile at rest would begin and end touches. */
    public static final float SLACK = 0.005f;

    /** A hit is complete once no more of its approach speed is left. */
    private static final float LEFT = 1f / 64f;

    private TouchRule() {}

    public static float approach(float vn) {
        return Branchless.positive(-vn);
    }

    /** Neither impulses nor separations are -0. */
    public static float greatest(float greatest, float approach, float impulse, float separation) {
        int touching = Branchless.isPositive(impulse) | ~Branchless.isPositive(separation);
        float now = Branchless.choose(touching, approach, NONE);
        // as ints such numbers have the order of the floats
        return Float.intBitsToFloat(Math.max(Float.floatToRawIntBits(greatest), Float.floatToRawIntBits(now)));
    }

    /** Whether the place of the touch may be another after the step. */
    public static boolean isFast(float approach, float dt, float radii) {
        return approach * dt > SLACK * radii;
    }

    public static boolean touches(float approach, float separation) {
        return approach >= 0f || separation <= 0f;
    }

    public static boolean staysInTouch(float approach, float separation, float radii) {
        return approach >= 0f || separation <= SLACK * radii;
    }

    public static float point(float x, float displacement, float normal, float radius, float separation) {
        return (x + displacement) + normal * (radius + 0.5f * separation);
    }

    /** Whether a hit goes on in the next step. */
    public static boolean isIncomplete(float vn, float approach) {
        return -vn > LEFT * approach;
    }
}
