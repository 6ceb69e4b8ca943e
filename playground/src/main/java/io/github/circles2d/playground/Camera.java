package io.github.circles2d.playground;

import java.awt.Rectangle;

/**
 * Which part of the world the picture shows. In the world y points up, in the picture down.
 *
 * @param x     x of the world in the middle of the picture
 * @param y     y of the world in the middle of the picture
 * @param scale pixels a length
 */
record Camera(double x, double y, double scale) {
    /** Part of a picture without panels that an arena fills. */
    private static final double FILL = 0.94;

    private static final double LEAST_FACTOR = 0.2;
    private static final double GREATEST_FACTOR = 200;

    /** Shows a whole arena in the middle of a picture. */
    static Camera home(Arena arena, int width, int height) {
        double scale = Math.min(Math.max(width, 1) / arena.width(), Math.max(height, 1) / arena.height()) * FILL;
        return new Camera((arena.minX() + arena.maxX()) / 2.0, (arena.minY() + arena.maxY()) / 2.0, scale);
    }

    /** Shows a whole arena in a part of a picture. */
    static Camera home(Arena arena, Rectangle part, int width, int height) {
        double scale = Math.max(Math.min(part.width / arena.width(), part.height / arena.height()), 1 / arena.width());
        return new Camera(
                (arena.minX() + arena.maxX()) / 2.0 - (part.getCenterX() - width / 2.0) / scale,
                (arena.minY() + arena.maxY()) / 2.0 + (part.getCenterY() - height / 2.0) / scale,
                scale);
    }

    double screenX(double worldX, int width) {
        return width / 2.0 + (worldX - x) * scale;
    }

    double screenY(double worldY, int height) {
        return height / 2.0 - (worldY - y) * scale;
    }

    double worldX(double screenX, int width) {
        return x + (screenX - width / 2.0) / scale;
    }

    double worldY(double screenY, int height) {
        return y - (screenY - height / 2.0) / scale;
    }

    /** Enlarges the picture so that the point of the world at a place of it stays there. */
    Camera zoom(double factor, double screenX, double screenY, int width, int height) {
        double dx = (screenX - width / 2.0) / scale;
        double dy = (screenY - height / 2.0) / scale;
        double to = scale * factor;
        double share = 1 - scale / to;
        return new Camera(x + dx * share, y - dy * share, to);
    }

    /** Moves the picture along with a mouse that has moved by so many pixels. */
    Camera pan(double dx, double dy) {
        return new Camera(x - dx / scale, y + dy / scale, scale);
    }

    /** Keeps the scale within sight of the arena, and what is in the middle of the arena's part of the picture within the arena. */
    Camera clamp(Arena arena, Rectangle part, int width, int height) {
        double home = home(arena, part, width, height).scale;
        double to = Math.min(Math.max(scale, home * LEAST_FACTOR), home * GREATEST_FACTOR);
        double dx = (part.getCenterX() - width / 2.0) / to;
        double dy = (part.getCenterY() - height / 2.0) / to;
        return new Camera(
                Math.min(Math.max(x + dx, arena.minX()), arena.maxX()) - dx,
                Math.min(Math.max(y - dy, arena.minY()), arena.maxY()) + dy,
                to);
    }
}
