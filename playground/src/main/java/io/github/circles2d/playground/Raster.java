package io.github.circles2d.playground;

import java.awt.image.BufferedImage;
import java.awt.image.DataBufferInt;
import java.util.Arrays;

/** A picture of plain ints that is filled with boxes and discs. It needs no display, and looks the same on every platform. */
final class Raster {
    private static final int RED_BLUE = 0xff00ff;
    private static final int GREEN = 0x00ff00;
    private static final double GREATEST = 1e5;

    private final Sprites sprites = new Sprites();
    private BufferedImage image = new BufferedImage(1, 1, BufferedImage.TYPE_INT_RGB);
    private int[] pixels = pixelsOf(image);
    private int width = 1;
    private int height = 1;

    /** Makes it this large; what was drawn is lost if the size changes. */
    void resize(int newWidth, int newHeight) {
        if (newWidth != width || newHeight != height) {
            width = Math.max(newWidth, 1);
            height = Math.max(newHeight, 1);
            image = new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB);
            pixels = pixelsOf(image);
        }
    }

    BufferedImage image() {
        return image;
    }

    int width() {
        return width;
    }

    int height() {
        return height;
    }

    void clear(int rgb) {
        Arrays.fill(pixels, rgb);
    }

    /** Fills the pixels from (left, top) on, up to and without (right, bottom). */
    void box(double left, double top, double right, double bottom, int rgb) {
        int x0 = inside(left, width);
        int x1 = inside(right, width);
        int y1 = inside(bottom, height);
        for (int y = inside(top, height); y < y1; y++) {
            Arrays.fill(pixels, y * width + x0, y * width + Math.max(x0, x1), rgb);
        }
    }

    private static int inside(double place, int end) {
        return (int) Math.min(Math.max(Math.round(place), 0), end);
    }

    /** Fills a disc; one whose place or size is not finite, or that is far larger than a screen, is left out. */
    void disc(double x, double y, double radius, int filling, int rim) {
        if (!(Math.abs(x) < GREATEST && Math.abs(y) < GREATEST && radius > 0 && radius < GREATEST)
                || x + radius < 0
                || y + radius < 0
                || x - radius > width
                || y - radius > height) {
            return;
        }
        if (radius > Math.max(width, height)) {
            box(x - radius, y - radius, x + radius, y + radius, filling);
            return;
        }
        int column = (int) Math.floor(x);
        int row = (int) Math.floor(y);
        Sprite sprite = sprites.get(radius, quarter(x - column), quarter(y - row));
        draw(sprite, column + sprite.offset, row + sprite.offset, filling, rim);
    }

    /** The place in a pixel in quarters; rounding may have made it a whole pixel. */
    private static int quarter(double place) {
        return Math.min((int) (place * Sprites.QUARTERS), Sprites.QUARTERS - 1);
    }

    private void draw(Sprite s, int left, int top, int filling, int rim) {
        int first = Math.max(0, -top);
        int end = Math.min(s.size, height - top);
        for (int row = first; row < end; row++) {
            int line = (top + row) * width + left;
            int from = Math.max(s.from[row], -left);
            int to = Math.min(s.to[row], width - left);
            int fullFrom = Math.min(Math.max(s.fullFrom[row], from), to);
            int fullTo = Math.min(Math.max(s.fullTo[row], fullFrom), to);
            blend(s, row * s.size, from, fullFrom, line, filling, rim);
            if (fullTo > fullFrom) {
                Arrays.fill(pixels, line + fullFrom, line + fullTo, filling);
            }
            blend(s, row * s.size, fullTo, to, line, filling, rim);
        }
    }

    private void blend(Sprite s, int row, int from, int to, int line, int filling, int rim) {
        for (int column = from; column < to; column++) {
            int ground = s.ground[row + column];
            int full = s.filling[row + column];
            int edge = Sprite.WHOLE - ground - full;
            int below = pixels[line + column];
            int redBlue = (below & RED_BLUE) * ground + (filling & RED_BLUE) * full + (rim & RED_BLUE) * edge;
            int green = (below & GREEN) * ground + (filling & GREEN) * full + (rim & GREEN) * edge;
            pixels[line + column] = redBlue >>> 8 & RED_BLUE | green >>> 8 & GREEN;
        }
    }

    private static int[] pixelsOf(BufferedImage image) {
        return ((DataBufferInt) image.getRaster().getDataBuffer()).getData();
    }
}
