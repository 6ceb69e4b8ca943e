package io.github.circles2d.playground;

/**
 * What a tool draws over the circles, in the coordinates of the world: a ring about (x, y), or a line from (x, y) to (toX, toY) if the
 * radius is 0.
 *
 * @param strength 0 (not to be seen) to 1
 */
record Mark(float x, float y, float toX, float toY, float radius, float strength) {
    static Mark line(float x, float y, float toX, float toY) {
        return new Mark(x, y, toX, toY, 0, 1);
    }

    static Mark ring(float x, float y, float radius, float strength) {
        return new Mark(x, y, x, y, radius, strength);
    }
}
