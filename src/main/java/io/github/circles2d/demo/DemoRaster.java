package io.github.circles2d.demo;

import java.awt.image.BufferedImage;
import java.awt.image.DataBufferInt;
import java.util.Arrays;

/**
 * A picture of plain ints that discs with smooth edges are filled into.
 *
 * <p>The coverage of a pixel follows from its squared distance to the centre: near the edge, r - d is (r^2 - d^2) / 2r to
 * within 0.02 pixels at a radius of 6, and no square root is needed. Centres are not rounded to pixels, so slow circles
 * glide. The result does not depend on the platform's graphics pipeline.
 */
final class DemoRaster {
    private BufferedImage image = new BufferedImage(1, 1, BufferedImage.TYPE_INT_RGB);
    private int[] pixels = pixelsOf(image);
    private int width = 1;
    private int height = 1;

    /** Makes it this large; what was drawn is lost where the size changes. */
    void resize(int newWidth, int newHeight) {
        if (newWidth != width || newHeight != height) {
            image = new BufferedImage(newWidth, newHeight, BufferedImage.TYPE_INT_RGB);
            pixels = pixelsOf(image);
            width = newWidth;
            height = newHeight;
        }
    }

    BufferedImage image() {
        return image;
    }

    void clear() {
        Arrays.fill(pixels, 0);
    }

    /** Draws the one-pixel outline of a square just outside of [left, left + side) x [top, top + side). */
    void outline(int left, int top, int side, int rgb) {
        for (int k = -1; k <= side; k++) {
            set(left + k, top - 1, rgb);
            set(left + k, top + side, rgb);
            set(left - 1, top + k, rgb);
            set(left + side, top + k, rgb);
        }
    }

    /**
     * Fills a disc; what lies outside the picture is cut off, and a disc whose place or size is not finite is left out.
     *
     * @param ramp colours from the edge inwards, 0xRRGGBB, over the first pixel of depth behind the smooth edge; the
     *     last one fills the inside
     */
    void disc(double centreX, double centreY, double radius, int[] ramp) {
        if (!(Math.abs(centreX) < 1e6 && Math.abs(centreY) < 1e6 && radius > 0 && radius < 1e6)) {
            return;
        }
        // A disc below a pixel is drawn as a pixel-sized one that lets the ground through: the same light, and no
        // flicker.
        float r = (float) Math.max(radius, 1);
        float opacity = (float) (radius < 1 ? radius * radius : 1);
        float perSquare = 0.5f / r;
        int inside = ramp.length - 1;
        // The smaller the disc, the less of it may go to its rim; at a radius of one pixel nothing does.
        int first = (int) (inside * Math.min(Math.max((5 - r) / 4, 0), 1));
        int x0 = Math.max(0, (int) (centreX - r - 0.5));
        int x1 = Math.min(width - 1, (int) (centreX + r + 0.5));
        int y0 = Math.max(0, (int) (centreY - r - 0.5));
        int y1 = Math.min(height - 1, (int) (centreY + r + 0.5));
        for (int y = y0; y <= y1; y++) {
            float dy = (float) (y + 0.5 - centreY);
            float dx = (float) (x0 + 0.5 - centreX);
            float rowDepth = (r * r - dy * dy) * perSquare + 0.5f;
            for (int at = y * width + x0, end = y * width + x1; at <= end; at++, dx++) {
                float depth = rowDepth - dx * dx * perSquare; // in pixels; the disc's edge runs where it is a half
                if (depth >= 1 && opacity == 1) {
                    pixels[at] = ramp[Math.min(first + (int) ((depth - 1) * inside), inside)];
                } else if (depth > 0) {
                    pixels[at] = mix(pixels[at], ramp[first], Math.min(depth, 1) * opacity);
                }
            }
        }
    }

    private void set(int x, int y, int rgb) {
        if (x >= 0 && x < width && y >= 0 && y < height) {
            pixels[y * width + x] = rgb;
        }
    }

    /** Red and blue in one multiplication, green in the other. */
    private static int mix(int from, int to, float share) {
        int w = (int) (share * 256 + 0.5f);
        int v = 256 - w;
        int redBlue = ((from & 0xff00ff) * v + (to & 0xff00ff) * w) >>> 8 & 0xff00ff;
        int green = ((from & 0x00ff00) * v + (to & 0x00ff00) * w) >>> 8 & 0x00ff00;
        return redBlue | green;
    }

    private static int[] pixelsOf(BufferedImage image) {
        return ((DataBufferInt) image.getRaster().getDataBuffer()).getData();
    }
}
