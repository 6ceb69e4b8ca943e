package io.github.circles2d.playground;

/**
 * A disc with a smooth edge, ready to be drawn at places that differ by whole pixels. Each pixel has three parts: of the ground, of the
 * rim and of the filling; runs of pixels that are all filling are drawn at once.
 */
final class Sprite {
    /** All of a pixel. */
    static final int WHOLE = 256;

    /** Below this radius in pixels a disc has no rim. */
    private static final double RIM_FROM = 2.5;

    private static final double RIM = 0.14;
    private static final double LEAST_RIM = 0.7;
    private static final double GREATEST_RIM = 2.2;

    /** Width and height in pixels. */
    final int size;

    /** Where pixel (0, 0) lies, beside the pixel that has the centre in it. */
    final int offset;

    /** By pixel: the part of the ground. */
    final short[] ground;

    /** By pixel: the part of the filling. The rim has the rest. */
    final short[] filling;

    /** By row: the first pixel that is not all ground, and the one behind the last. */
    final short[] from;

    final short[] to;

    /** By row: the first pixel of the run that is all filling, and the one behind the last. */
    final short[] fullFrom;

    final short[] fullTo;

    /**
     * A disc.
     *
     * @param radius in pixels; below 1, it is drawn as 1 and lets the ground through: the same light, and no flicker
     * @param shiftX where the centre is in its pixel, 0 to 1
     * @param shiftY the same, downwards
     */
    Sprite(double radius, double shiftX, double shiftY) {
        double r = Math.max(radius, 1);
        double opacity = radius < 1 ? radius * radius : 1;
        double rim = radius < RIM_FROM ? 0 : Math.min(Math.max(RIM * r, LEAST_RIM), GREATEST_RIM);
        int reach = (int) Math.ceil(r + 0.5);
        offset = -reach;
        size = 2 * reach + 1;
        ground = new short[size * size];
        filling = new short[size * size];
        from = new short[size];
        to = new short[size];
        fullFrom = new short[size];
        fullTo = new short[size];
        for (int row = 0; row < size; row++) {
            double dy = row + offset + 0.5 - shiftY;
            int first = size;
            int end = 0;
            int full = size;
            int fullEnd = 0;
            for (int column = 0; column < size; column++) {
                double dx = column + offset + 0.5 - shiftX;
                double depth = r - Math.sqrt(dx * dx + dy * dy) + 0.5;
                int at = row * size + column;
                ground[at] = (short) (WHOLE - Math.round(WHOLE * clamp(depth) * opacity));
                filling[at] = (short) Math.min(Math.round(WHOLE * clamp(depth - rim) * opacity), WHOLE - ground[at]);
                if (ground[at] < WHOLE) {
                    first = Math.min(first, column);
                    end = column + 1;
                }
                if (filling[at] == WHOLE) {
                    full = Math.min(full, column);
                    fullEnd = column + 1;
                }
            }
            from[row] = (short) Math.min(first, end);
            to[row] = (short) end;
            fullFrom[row] = (short) (fullEnd == 0 ? end : full);
            fullTo[row] = (short) (fullEnd == 0 ? end : fullEnd);
        }
    }

    private static double clamp(double depth) {
        return Math.min(Math.max(depth, 0), 1);
    }
}
