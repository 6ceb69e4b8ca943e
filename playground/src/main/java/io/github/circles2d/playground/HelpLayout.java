package io.github.circles2d.playground;

/**
 * How the keys stand in the space that there is: in two columns or one, in letters that can be read, and to be scrolled if they are
 * higher than the canvas.
 *
 * @param columns 1 or 2
 * @param scale pixels for a unit
 * @param left left end of the panel in pixels
 * @param top its upper end
 * @param width its width in pixels
 * @param height its height; what is beyond must be scrolled
 * @param mostScroll by how many pixels the text can be scrolled; 0 if all of it is shown
 */
record HelpLayout(int columns, double scale, int left, int top, int width, int height, int mostScroll) {
    static final int ROW = 25;
    static final int KEY_WIDTH = 158;
    static final int COLUMN = KEY_WIDTH + 262;

    /** Of the title and the space above it. */
    static final int HEAD = 62;

    private static final int FOOT = 20;

    /** Letters of 14 units are not to be smaller than eleven pixels. */
    private static final double LEAST_SCALE = 0.79;

    private static final int EDGE = 10;

    /** Lays out keys of which so many stand in each of two columns. */
    static HelpLayout of(int width, int height, int first, int second) {
        int roomX = Math.max(width - 2 * EDGE, 1);
        int roomY = Math.max(height - 2 * EDGE, 1);
        boolean two = (double) roomX / wide(2) >= LEAST_SCALE;
        int columns = two ? 2 : 1;
        int rows = two ? Math.max(first, second) : first + second;
        double high = HEAD + rows * ROW + FOOT;
        double scale = Math.min(1, Math.min((double) roomX / wide(columns), Math.max(LEAST_SCALE, roomY / high)));
        int wholeHeight = (int) Math.ceil(high * scale);
        int shown = Math.min(wholeHeight, roomY);
        int across = (int) Math.round(wide(columns) * scale);
        return new HelpLayout(
                columns, scale, (width - across) / 2, (height - shown) / 2, across, shown, wholeHeight - shown);
    }

    private static int wide(int columns) {
        return columns * COLUMN + (columns + 1) * pad(columns);
    }

    /** Units beside and between the columns. */
    static int pad(int columns) {
        return columns == 2 ? 28 : 16;
    }
}
