package io.github.circles2d.world.model;

/** The arena. */
public record Bounds(float minX, float minY, float maxX, float maxY, AxisEdge edgeX, AxisEdge edgeY) {
    /** Beyond all that circles reach, near enough for exact formulas. */
    private static final float NOWHERE = 4e9f;

    /** All that is. */
    public static final Bounds EVERYWHERE = new Bounds(
            Float.NEGATIVE_INFINITY, Float.NEGATIVE_INFINITY, Float.POSITIVE_INFINITY, Float.POSITIVE_INFINITY);

    public Bounds(float minX, float minY, float maxX, float maxY) {
        this(minX, minY, maxX, maxY, AxisEdge.WALL, AxisEdge.WALL);
    }

    public Bounds with(AxisEdge x, AxisEdge y) {
        return new Bounds(minX, minY, maxX, maxY, x, y);
    }

    public boolean isWalled() {
        return edgeX == AxisEdge.WALL && edgeY == AxisEdge.WALL;
    }

    public boolean wraps() {
        return edgeX == AxisEdge.WRAP || edgeY == AxisEdge.WRAP;
    }

    /** A record's own equals would keep its class loader from being collected for long. */
    public boolean differs(Bounds other) {
        return minX != other.minX || minY != other.minY || maxX != other.maxX || maxY != other.maxY;
    }

    /** In a step an axis without walls has walls that no circle reaches. */
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

    /** Infinite if the axis does not wrap. */
    public float periodX() {
        return edgeX == AxisEdge.WRAP ? maxX - minX : Float.POSITIVE_INFINITY;
    }

    public float periodY() {
        return edgeY == AxisEdge.WRAP ? maxY - minY : Float.POSITIVE_INFINITY;
    }

    /** If the axis wraps. */
    public float lastX() {
        return Math.nextDown(maxX);
    }

    public float lastY() {
        return Math.nextDown(maxY);
    }

    /** Inside, if the axis wraps. */
    public float placeX(float x) {
        return edgeX == AxisEdge.WRAP ? inside(x, minX, lastX(), periodX()) : x;
    }

    public float placeY(float y) {
        return edgeY == AxisEdge.WRAP ? inside(y, minY, lastY(), periodY()) : y;
    }

    /** A place inside stays to the bit: a replay brings it again. */
    private static float inside(float x, float min, float last, float period) {
        if (x >= min && x <= last) {
            return x;
        }
        float laps = CircleMath.laps(x, min, period);
        return laps == 0f ? x : CircleMath.clamp(x - laps * period, min, last);
    }

    /** The greatest coordinate or extent, which bounds precision. */
    public float magnitude() {
        float x = Math.max(Math.max(Math.abs(minX), Math.abs(maxX)), maxX - minX);
        float y = Math.max(Math.max(Math.abs(minY), Math.abs(maxY)), maxY - minY);
        return Math.max(x, y);
    }

    /** Above the rounding of coordinates. */
    public float leastRadius() {
        return magnitude() * Limits.LEAST_RADIUS_SHARE;
    }

    /** Four cells must fit on an axis that wraps, so that circles have one shortest way. */
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
