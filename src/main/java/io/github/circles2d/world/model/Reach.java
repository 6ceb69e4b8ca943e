package io.github.circles2d.world.model;

/**
 * A grid by how far circles get. Class 0 has the greatest reaches, each further class half. A circle looks in its class and greater ones.
 * Cells share buckets by a hash, which costs time alone.
 */
public final class Reach {
    /** Covers the rounding of a time of impact. */
    public static final float SLACK = 1.01f;

    /** For contacts, which begin before circles touch. */
    public static final float STATIC_SLACK = 1.05f;

    /** In radii. */
    public static final float GREATEST = SLACK * (Tuning.TRAVEL + 2f);

    /** Farther away, coordinates are no finer than cells. */
    private static final float LAST_CELL = 0x1p22f;

    /** log2 of a cell's edge in {@link #topReach}; smaller cells cost more visits. */
    public static final int EDGE_LOG = 1;

    private static final int LAST_CLASS = 31;

    private Reach() {}

    /** Static circles that move look for others themselves. */
    public static float reachOf(float r, float path, boolean isStatic) {
        return isStatic ? STATIC_SLACK * r : SLACK * (r + path);
    }

    private static float powerOfTwo(int exponent) {
        return Float.intBitsToFloat((Float.MAX_EXPONENT + exponent) << 23);
    }

    public static int topExponent(float greatestRadius) {
        return Math.getExponent(GREATEST * greatestRadius);
    }

    public static int reachClassOf(float reach, int topExponent) {
        return Math.min(topExponent - Math.getExponent(reach), LAST_CLASS);
    }

    public static float topReach(int reachClass, int topExponent) {
        return powerOfTwo(topExponent - reachClass + 1);
    }

    public static float inverseReachEdge(int reachClass, int topExponent) {
        return powerOfTwo(reachClass - topExponent - 1 - EDGE_LOG);
    }

    /** Never falls where x grows. */
    public static int reachCell(float x, float min, float inverseEdge) {
        return (int) CircleMath.clamp((x - min) * inverseEdge, -LAST_CELL, LAST_CELL);
    }

    /** A power of two. */
    public static int reachBuckets(int circles) {
        return Integer.highestOneBit(Math.max(circles, 1)) << 1;
    }

    public static int reachBucket(int column, int row, int reachClass, int buckets) {
        int h = column * 0x9e3779b1 + row * 0x85ebca6b + reachClass * 0xc2b2ae35;
        return (h ^ h >>> 15) * 0x2c1b3c6d >>> 7 & buckets - 1;
    }
}
