package io.github.circles2d.world.model;

/**
 * The arena: an axis-parallel rectangle with walls all around.
 *
 * @param minX left wall
 * @param minY lower wall
 * @param maxX right wall
 * @param maxY upper wall
 */
public record Bounds(float minX, float minY, float maxX, float maxY) {
    /** Whether some wall is at another place. A record's own equals would keep its class loader from being collected for long. */
    public boolean differs(Bounds other) {
        return minX != other.minX || minY != other.minY || maxX != other.maxX || maxY != other.maxY;
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
     * The greatest radius of a circle that fits.
     *
     * @return a length
     */
    public float greatestRadius() {
        return Math.min(maxX - minX, maxY - minY) * 0.5f;
    }
}
