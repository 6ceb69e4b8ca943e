package io.github.circles2d.world.model;

/**
 * The arena: an axis-parallel rectangle, and what there is at its edges.
 *
 * @param minX left edge
 * @param minY lower edge
 * @param maxX right edge
 * @param maxY upper edge
 * @param edgeX what there is at the left and the right edge
 * @param edgeY what there is at the lower and the upper edge
 */
public record Bounds(float minX, float minY, float maxX, float maxY, AxisEdge edgeX, AxisEdge edgeY) {
    /** Walls of an axis that has none, if it wraps: beyond all that a circle reaches in a step, and near enough for exact formulas. */
    private static final float NOWHERE = 4e9f;

    /** With walls all around. */
    public Bounds(float minX, float minY, float maxX, float maxY) {
        this(minX, minY, maxX, maxY, AxisEdge.WALL, AxisEdge.WALL);
    }

    /** The same rectangle with other edges. */
    public Bounds with(AxisEdge x, AxisEdge y) {
        return new Bounds(minX, minY, maxX, maxY, x, y);
    }

    /** Whether there are walls all around. */
    public boolean isWalled() {
        return edgeX == AxisEdge.WALL && edgeY == AxisEdge.WALL;
    }

    /** Whether an axis wraps. */
    public boolean wraps() {
        return edgeX == AxisEdge.WRAP || edgeY == AxisEdge.WRAP;
    }

    /** Whether some edge is at another place. A record's own equals would keep its class loader from being collected for long. */
    public boolean differs(Bounds other) {
        return minX != other.minX || minY != other.minY || maxX != other.maxX || maxY != other.maxY;
    }

    /**
     * Where walls are in a step. An open axis has them where coordinates end. A wrapped one has them so far away that no circle comes
     * near to them.
     */
    public Bounds walls() {
        return isWalled()
                ? this
                : new Bounds(
                        wall(minX, -1f, edgeX), wall(minY, -1f, edgeY), wall(maxX, 1f, edgeX), wall(maxY, 1f, edgeY));
    }

    private static float wall(float at, float side, AxisEdge edge) {
        return switch (edge) {
            case WALL -> at;
            case OPEN -> side * Limits.COORDINATE;
            case WRAP -> side * NOWHERE;
        };
    }

    /** The period along x; infinite if x does not wrap. */
    public float periodX() {
        return edgeX == AxisEdge.WRAP ? maxX - minX : Float.POSITIVE_INFINITY;
    }

    /** The period along y; infinite if y does not wrap. */
    public float periodY() {
        return edgeY == AxisEdge.WRAP ? maxY - minY : Float.POSITIVE_INFINITY;
    }

    /** The greatest coordinate of a circle along x, if x wraps. */
    public float lastX() {
        return Math.nextDown(maxX);
    }

    /** The greatest coordinate of a circle along y, if y wraps. */
    public float lastY() {
        return Math.nextDown(maxY);
    }

    /** An x that a caller has given, as circles have it: inside, if x wraps. */
    public float placeX(float x) {
        return edgeX == AxisEdge.WRAP ? inside(x, minX, lastX(), periodX()) : x;
    }

    /** A y that a caller has given, as circles have it: inside, if y wraps. */
    public float placeY(float y) {
        return edgeY == AxisEdge.WRAP ? inside(y, minY, lastY(), periodY()) : y;
    }

    /** A place that is inside stays: a replay brings places inside that have been. */
    private static float inside(float x, float min, float last, float period) {
        if (x >= min && x <= last) {
            return x;
        }
        float laps = Wrapping.laps(x, min, period);
        return laps == 0f ? x : CircleMath.clamp(x - laps * period, min, last);
    }

    /**
     * The greatest of all coordinates and extents: what bounds the precision of positions.
     *
     * @return a length greater than 0
     */
    public float magnitude() {
        float x = Math.max(Math.max(Math.abs(minX), Math.abs(maxX)), maxX - minX);
        float y = Math.max(Math.max(Math.abs(minY), Math.abs(maxY)), maxY - minY);
        return Math.max(x, y);
    }

    /**
     * The least radius of a circle here: a circle must be larger than the rounding of its coordinates.
     *
     * @return a length greater than 0
     */
    public float leastRadius() {
        return magnitude() * Limits.LEAST_RADIUS_SHARE;
    }

    /**
     * The greatest radius of a circle that fits: half of the way between two walls. Along an axis that wraps four cells must fit,
     * so that a circle and each that it meets have one shortest way to each other.
     *
     * @return a length
     */
    public float greatestRadius() {
        return Math.min(greatestRadius(maxX - minX, edgeX), greatestRadius(maxY - minY, edgeY));
    }

    private static float greatestRadius(float extent, AxisEdge edge) {
        return switch (edge) {
            case WALL -> extent * 0.5f;
            case OPEN -> Limits.COORDINATE * 0.5f;
            case WRAP -> extent / Limits.LEAST_PERIOD;
        };
    }
}
