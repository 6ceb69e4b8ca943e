package io.github.circles2d.world.model;

/**
 * How the contacts of circles of different levels, the cross contacts, are solved. A large circle may have hundreds of small ones
 * around it. If they were visited one after the other, all would wait. So in each pass, behind all other contacts, each light circle
 * visits its own cross contacts one after the other, and all light circles do so at the same time: they see the heavy circles as they
 * were before. Then each heavy circle takes the sum of what the visits give it.
 *
 * <p>The sums are whole numbers, so their terms may come in any order. A unit depends on the heavy circle: 2^44 units are the greatest
 * power of two up to the speed that takes the circle its radius far in a sub-step, or up to the impulse that gives it that speed.
 *
 * <p>A heavy circle that all push at once could be pushed too far. So each contact counts the heavy circle as lighter than it is, by its
 * share: a number of at least 1 that grows with the contacts it has. (Mass splitting: R. Tonge, F. Benevolenski and A. Voroshilov, "Mass
 * splitting for jitter-free parallel rigid body simulation", SIGGRAPH 2012.)
 */
public final class CrossRule {
    /** log2 of the units of a range; a term is cut at 2^12 ranges. */
    public static final int RANGE_LOG = 44;

    private static final float GREATEST_TERM = 0x1p56f;

    /** The bits of a float's exponent, and where they begin. */
    private static final int EXPONENT = 0x7f800000;

    private static final int EXPONENT_SHIFT = 23;
    private static final int EXPONENT_OF_ONE = 127;

    /** Ranges are treated as if they were not below 2^-80: a unit is then a normal float. */
    private static final int LEAST_EXPONENT = 47;

    /** Units of a load of 1. */
    public static final float LOAD_UNITS = 16384f;

    /** How deep circles may overlap that wait to bounce, in sums of their radii. */
    public static final float WAIT_DEPTH = 0.25f;

    /** The same, in radii of the smaller one. */
    public static final float WAIT_DEPTH_OF_SMALLER = 4f;

    private CrossRule() {}

    /** Whether the circle of the finer level is the light one of a pair. */
    public static boolean isFinerLight(float inverseMassOfFiner, float inverseMassOfCoarser) {
        return inverseMassOfFiner >= inverseMassOfCoarser;
    }

    /** What a contact adds to the load of its heavy circle. The sum of whole numbers does not depend on their order. */
    public static int load(float inverseMassOfLight, float inverseMassOfHeavy) {
        return (int) (inverseMassOfHeavy / (inverseMassOfHeavy + inverseMassOfLight) * LOAD_UNITS) + 1;
    }

    /** By how much a heavy circle counts as lighter, from the sum of what its contacts add. */
    public static float share(int load) {
        return CircleMath.max((float) load * (1f / LOAD_UNITS), 1f);
    }

    /** The effective mass of a contact that is solved. */
    public static float mass(float inverseMassOfLight, float inverseMassOfHeavy, float share) {
        return 1f / (inverseMassOfLight + share * inverseMassOfHeavy);
    }

    /**
     * Whether two circles that fly free of each other, and are to bounce, may wait for it. If two light circles bounced off a heavy one
     * in the same pass, each as if it were alone, energy would be won or lost. So those that meet in the biased pass wait, and in
     * the relaxing pass one of them bounces: the one with the highest id. Nobody
     * waits who would be too deep, who meets a static circle, or who loses energy anyway.
     */
    public static boolean mayWait(
            float restitution, float inverseMassOfHeavy, float separation, float radius, float otherRadius) {
        float depth = CircleMath.min(
                WAIT_DEPTH * (radius + otherRadius), WAIT_DEPTH_OF_SMALLER * CircleMath.min(radius, otherRadius));
        return restitution > Tuning.NEARLY_ELASTIC && inverseMassOfHeavy > 0f && separation + depth >= 0f;
    }

    /** The range of what a heavy circle's velocity gains. */
    public static float velocityRange(float radius, float inverseH) {
        return radius * inverseH;
    }

    /** The range of the impulses on a heavy circle. */
    public static float impulseRange(float radius, float inverseH, float inverseMass) {
        return radius * inverseH / inverseMass;
    }

    /** Units per 1, where a sum has a range. */
    public static float scaleOf(float range) {
        return Float.intBitsToFloat(
                ((EXPONENT_OF_ONE + RANGE_LOG + EXPONENT_OF_ONE) << EXPONENT_SHIFT) - exponent(range));
    }

    /** A unit: 1 / scale. */
    public static float unitOf(float range) {
        return Float.intBitsToFloat(exponent(range) - (RANGE_LOG << EXPONENT_SHIFT));
    }

    private static int exponent(float range) {
        return Math.max(Float.floatToRawIntBits(range) & EXPONENT, LEAST_EXPONENT << EXPONENT_SHIFT);
    }

    /** A term of a sum, in units. */
    public static long toFixed(float v, float scale) {
        return (long) CircleMath.clamp(v * scale, -GREATEST_TERM, GREATEST_TERM);
    }

    /** The value of a sum of units. It may wrap, which does not depend on the order either. */
    public static float fromFixed(long sum, float unit) {
        return (float) sum * unit;
    }
}
