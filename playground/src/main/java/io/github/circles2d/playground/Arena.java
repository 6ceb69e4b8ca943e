package io.github.circles2d.playground;

import io.github.circles2d.World;

/**
 * The walls of a world.
 *
 * @param minX the left wall
 * @param minY the lower wall
 * @param maxX the right wall
 * @param maxY the upper wall
 */
record Arena(float minX, float minY, float maxX, float maxY) {
    private static final float LEAST_RADIUS_SHARE = 0x1p-20f;

    static Arena of(World world) {
        return new Arena(world.minX(), world.minY(), world.maxX(), world.maxY());
    }

    double width() {
        return (double) maxX - minX;
    }

    double height() {
        return (double) maxY - minY;
    }

    /** The radius nearest to another that the world takes: {@link World} has the range. */
    float radius(float wished) {
        float width = maxX - minX;
        float height = maxY - minY;
        float x = Math.max(Math.abs(minX), Math.abs(maxX));
        float y = Math.max(Math.abs(minY), Math.abs(maxY));
        float least = Math.max(Math.max(x, y), Math.max(width, height)) * LEAST_RADIUS_SHARE;
        return Math.min(Math.max(wished, least), Math.min(width, height) * 0.5f);
    }

    boolean contains(float x, float y) {
        return x >= minX && x <= maxX && y >= minY && y <= maxY;
    }
}
