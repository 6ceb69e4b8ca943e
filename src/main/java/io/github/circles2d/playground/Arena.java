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
    static Arena of(World world) {
        return new Arena(world.minX(), world.minY(), world.maxX(), world.maxY());
    }

    double width() {
        return (double) maxX - minX;
    }

    double height() {
        return (double) maxY - minY;
    }

    boolean contains(float x, float y) {
        return x >= minX && x <= maxX && y >= minY && y <= maxY;
    }
}
