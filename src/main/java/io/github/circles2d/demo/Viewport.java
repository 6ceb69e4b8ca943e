package io.github.circles2d.demo;

/**
 * Where the unit square lies in a picture: a square of {@code side} pixels whose upper left corner is at ({@code left},
 * {@code top}). In the arena y points up, in the picture down.
 */
record Viewport(double left, double top, double side) {

    /** Room beside the arena, left and right together, at a side of 480: the margin of the thesis's window. */
    static final int MARGIN_X = 20;
    /** Room above and below the arena together. */
    static final int MARGIN_Y = 40;

    /** The largest square, in the middle, that leaves the margin free. */
    static Viewport fit(int width, int height, double scale) {
        double side = Math.max(1, Math.floor(Math.min(width - MARGIN_X * scale, height - MARGIN_Y * scale)));
        return new Viewport(Math.floor((width - side) / 2), Math.floor((height - side) / 2), side);
    }

    double x(double arenaX) {
        return left + arenaX * side;
    }

    double y(double arenaY) {
        return top + (1 - arenaY) * side;
    }
}
