package io.github.circles2d.world.model;

/**
 * How far circles get in a step, and the grid in which continuous collision finds them. A class of reaches spans a factor of two, class 0
 * the greatest. Each class has square cells of its own, whose edge is four times the greatest reach of the class. A circle
 * looks in its own class and in those of greater reaches, so it never looks at more than a few cells of each. Cells have buckets by a
 * hash: far cells may share one, which costs time and nothing else. {@code kernels/world/shared/Reach.cl} has the same.
 */
public final class Reach {
    /** A little more than 1: circles farther apart than their reaches do not touch, however a time of impact is rounded. */
    public static final float SLACK = 1.01f;

    /** The slack of a static circle: its contacts begin at a part of its radius, however small the other circle is. */
    public static final float STATIC_SLACK = 1.05f;

    /** More than the reach of any circle that is not static, in radii. */
    public static final float GREATEST = SLACK * (Tuning.TRAVEL + 2f);

    /** Cells beyond this number count as this one: so far away, coordinates are no finer than cells. */
    private static final float LAST_CELL = 0x1p22f;

    /** log2 of the edge of a cell in greatest reaches of its class. Smaller cells cost more: there are more of them to look at. */
    public static final int EDGE_LOG = 1;

    /** The class of all smaller reaches, too. */
    private static final int LAST_CLASS = 31;

    private Reach() {}

    /**
     * The reach of a circle. That of a static one has no path: one that moves takes others along, and sees to that itself.
     *
     * @param r radius
     * @param path length of its path in the step
     * @param isStatic whether it is static
     * @return a length greater than the radius
     */
    public static float of(float r, float path, boolean isStatic) {
        return isStatic ? STATIC_SLACK * r : SLACK * (r + path);
    }

    /** The exponent of the reaches of class 0, from the greatest radius of all circles. */
    public static int topExponent(float greatestRadius) {
        return Math.getExponent(GREATEST * greatestRadius);
    }

    /** The class of a reach. */
    public static int classOf(float reach, int topExponent) {
        return Math.min(topExponent - Math.getExponent(reach), LAST_CLASS);
    }

    /** A length that the reaches of a class are less than. */
    public static float top(int reachClass, int topExponent) {
        return powerOfTwo(topExponent - reachClass + 1);
    }

    /** 1 / edge of the cells of a class. */
    public static float inverseEdge(int reachClass, int topExponent) {
        return powerOfTwo(reachClass - topExponent - 1 - EDGE_LOG);
    }

    private static float powerOfTwo(int exponent) {
        return Float.intBitsToFloat((Float.MAX_EXPONENT + exponent) << 23);
    }

    /** The column (or row) of cells of a coordinate: it never falls where the coordinate grows. */
    public static int cell(float x, float min, float inverseEdge) {
        return (int) CircleMath.clamp((x - min) * inverseEdge, -LAST_CELL, LAST_CELL);
    }

    /** How many buckets there are for so many circles: a power of two. */
    public static int buckets(int circles) {
        return Integer.highestOneBit(Math.max(circles, 1)) << 1;
    }

    /** The bucket of a cell. */
    public static int bucket(int column, int row, int reachClass, int buckets) {
        int h = column * 0x9e3779b1 + row * 0x85ebca6b + reachClass * 0xc2b2ae35;
        return (h ^ h >>> 15) * 0x2c1b3c6d >>> 7 & buckets - 1;
    }
}
