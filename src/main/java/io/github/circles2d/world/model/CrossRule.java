package io.github.circles2d.world.model;

/**
 * Cross contacts. A boulder may touch hundreds of grains, which must not wait for each other: a heavy circle takes the sum of their visits
 * at the end. Sums are whole numbers, so they need no order. A heavy circle that all push at once counts as lighter, by its share (mass
 * splitting: Tonge, Benevolenski, Voroshilov, SIGGRAPH 2012).
 */
public final class CrossRule {
    /** log2 of the units of a range: the power of two up to what moves the circle a radius in a sub-step. */
    public static final int RANGE_LOG = 44;

    private static final float GREATEST_TERM = 0x1p56f;

    private static final int EXPONENT = 0x7f800000;

    private static final int EXPONENT_SHIFT = 23;
    private static final int EXPONENT_OF_ONE = 127;

    /** Of 2^-80, so that units are normal floats. */
    private static final int LEAST_EXPONENT = 47;

    public static final float LOAD_UNITS = 16384f;

    /** In sums of radii. */
    public static final float WAIT_DEPTH = 0.25f;

    /** In its radii. */
    public static final float WAIT_DEPTH_OF_SMALLER = 4f;

    private CrossRule() {}

    public static boolean isFinerLight(float inverseMassOfFiner, float inverseMassOfCoarser) {
        return inverseMassOfFiner >= inverseMassOfCoarser;
    }

    public static int loadOfHeavy(float inverseMassOfLight, float inverseMassOfHeavy) {
        return (int) (inverseMassOfHeavy / (inverseMassOfHeavy + inverseMassOfLight) * LOAD_UNITS) + 1;
    }

    public static float crossShare(int load) {
        return CircleMath.max((float) load * (1f / LOAD_UNITS), 1f);
    }

    public static float crossMass(float inverseMassOfLight, float inverseMassOfHeavy, float share) {
        return 1f / (inverseMassOfLight + share * inverseMassOfHeavy);
    }

    /** If two circles bounced off a heavy one in a pass, each as if alone, energy would change; so one does in the relaxing pass. */
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

    private static int exponentOf(float range) {
        return Math.max(Float.floatToRawIntBits(range) & EXPONENT, LEAST_EXPONENT << EXPONENT_SHIFT);
    }

    /** Units per 1. */
    public static float scaleOf(float range) {
        return Float.intBitsToFloat(
                ((EXPONENT_OF_ONE + RANGE_LOG + EXPONENT_OF_ONE) << EXPONENT_SHIFT) - exponentOf(range));
    }

    public static float unitOf(float range) {
        return Float.intBitsToFloat(exponentOf(range) - (RANGE_LOG << EXPONENT_SHIFT));
    }

    public static long toFixed(float v, float scale) {
        return (long) CircleMath.clamp(v * scale, -GREATEST_TERM, GREATEST_TERM);
    }

    /** Wrapped sums depend on no order either. */
    public static float fromFixed(long sum, float unit) {
        return (float) sum * unit;
    }
}
