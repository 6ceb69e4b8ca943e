package io.github.circles2d.world.model;

/**
 * When two surfaces touch, for the events of a step. Nothing here changes a step. {@code kernels/world/stages/Touches.cl} has the
 * same formulas.
 *
 * <p>A step records two numbers for each contact. The approach speed is the greatest of the sub-steps in which the surfaces touched,
 * from the velocities before any impulse of the sub-step; {@link #NONE} if they did not. The impulse is the sum of all.
 */
public final class TouchRule {
    /** The approach speed of surfaces that did not touch in a sub-step so far. */
    public static final float NONE = -1f;

    /** Surfaces that touched stay in touch up to this gap, in sums of radii. Without it, a pile at rest would begin and end touches. */
    public static final float SLACK = 0.005f;

    /** A hit is complete once no more than this share of its approach speed is left. */
    private static final float LEFT = 1f / 64f;

    private TouchRule() {}

    /** The speed of an approach; 0 if surfaces part. */
    public static float approach(float vn) {
        return Branchless.positive(-vn);
    }

    /** The greatest approach speed after a sub-step. Impulses are not negative, and neither they nor separations are -0. */
    public static float greatest(float greatest, float approach, float impulse, float separation) {
        int touching = Branchless.isPositive(impulse) | ~Branchless.isPositive(separation);
        float now = Branchless.choose(touching, approach, NONE);
        // as ints such numbers have the order of the floats
        return Float.intBitsToFloat(Math.max(Float.floatToRawIntBits(greatest), Float.floatToRawIntBits(now)));
    }

    /** Whether an approach is so fast that the place of the touch may be another after the step. */
    public static boolean isFast(float approach, float dt, float radii) {
        return approach * dt > SLACK * radii;
    }

    /** Whether surfaces that did not touch before the step touch after it. */
    public static boolean touches(float approach, float separation) {
        return approach >= 0f || separation <= 0f;
    }

    /** Whether surfaces that touched before the step still do; all that {@link #touches} do. */
    public static boolean staysInTouch(float approach, float separation, float radii) {
        return approach >= 0f || separation <= SLACK * radii;
    }

    /** A coordinate of the point half-way between two surfaces. */
    public static float point(float x, float displacement, float normal, float radius, float separation) {
        return (x + displacement) + normal * (radius + 0.5f * separation);
    }

    /**
     * Whether surfaces go on approaching after a step so fast that the hit goes on in the next one.
     *
     * @param vn normal speed after the step
     * @param approach approach speed of the hit
     */
    public static boolean isIncomplete(float vn, float approach) {
        return -vn > LEFT * approach;
    }
}
