package io.github.circles2d.world.model;

/**
 * How contacts of circles of different levels are solved. A boulder may touch hundreds of grains, which would all wait for each
 * other. So behind all other contacts each light circle visits its cross contacts in order, all light circles at the same time, and
 * then each heavy circle takes the sum of what the visits give it.
 *
 * <p>Sums are whole numbers, so their order does not matter. 2^44 units are the greatest power of two up to the speed, or the
 * impulse, that takes the heavy circle its radius far in a sub-step.
 *
 * <p>A heavy circle that all push at once counts as lighter, by its share (mass splitting: Tonge, Benevolenski and Voroshilov,
 * SIGGRAPH 2012).
 */
public final class CrossRule {
    /** log2 of the units of a range; a term is cut at 2^12 ranges. */
    public static final int RANGE_LOG = 44;

    private static final float GREATEST_TERM = 0x1p56f;

    private static final int EXPONENT = 0x7f800000;

    private static final int EXPONENT_SHIFT = 23;
    private static final int EXPONENT_OF_ONE = 127;

    /** Ranges are at least 2^-80: a unit is then a normal float. */
    private static final int LEAST_EXPONENT = 47;

    public static final float LOAD_UNITS = 16384f;

    /** How deep circles may overlap that wait to bounce, in sums of radii. */
    public static final float WAIT_DEPTH = 0.25f;

    /** In radii of the smaller one. */
    public static final float WAIT_DEPTH_OF_SMALLER = 4f;

    private CrossRule() {}

    public static boolean isFinerLight(float inverseMassOfFiner, float inverseMassOfCoarser) {
        return inverseMassOfFiner >= inverseMassOfCoarser;
    }

    public static int load(float inverseMassOfLight, float inverseMassOfHeavy) {
        return (int) (inverseMassOfHeavy / (inverseMassOfHeavy + inverseMassOfLight) * LOAD_UNITS) + 1;
    }

    public static float share(int load) {
        return CircleMath.max((float) load * (1f / LOAD_UNITS), 1f);
    }

    public static float mass(float inverseMassOfLight, float inverseMassOfHeavy, float share) {
        return 1f / (inverseMassOfLight + share * inverseMassOfHeavy);
    }

    /**
     * If two light circles bounced off a heavy one in one pass, each as if alone, energy would change. So they wait, and the one of
     * the highest id bounces in the relaxing pass; not those who would be too deep, meet a static circle, or lose energy anyway.
     */
    public static boolean mayWait(
            float restitution, float inverseMassOfHeavy, float separation, float radius, float otherRadius) {
        float depth = CircleMath.min(
                WAIT_DEPTH * (radius + otherRadius), WAIT_DEPTH_OF_SMALLER * CircleMath.min(radius, otherRadius));
        return restitution > Tuning.NEARLY_ELASTIC && inverseMassOfHeavy > 0f && separation + depth >= 0f;
    }

    public static float velocityRange(float radius, float inverseH) {
        return radius * inverseH;
    }

    public static float impulseRange(float radius, float inverseH, float inverseMass) {
        return radius * inverseH / inverseMass;
    }

    /** Units per 1. */
    public static float scaleOf(float range) {
        return Float.intBitsToFloat(
                ((EXPONENT_OF_ONE + RANGE_LOG + EXPONENT_OF_ONE) << EXPONENT_SHIFT) - exponent(range));
    }

    public static float unitOf(float range) {
        return Float.intBitsToFloat(exponent(range) - (RANGE_LOG << EXPONENT_SHIFT));
    }

    private static int exponent(float range) {
        return Math.max(Float.floatToRawIntBits(range) & EXPONENT, LEAST_EXPONENT << EXPONENT_SHIFT);
    }

    public static long toFixed(float v, float scale) {
        return (long) CircleMath.clamp(v * scale, -GREATEST_TERM, GREATEST_TERM);
    }

    /** The sum may wrap, which does not depend on the order either. */
    public static float fromFixed(long sum, float unit) {
        return (float) sum * unit;
    }
}
