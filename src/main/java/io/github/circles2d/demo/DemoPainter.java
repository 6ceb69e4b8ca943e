package io.github.circles2d.demo;

import java.awt.Graphics2D;
import java.awt.geom.AffineTransform;
import java.awt.image.BufferedImage;
import java.util.List;

/**
 * Paints a frame: black ground, the outline of the arena, the discs, and the overlay where it is wanted. One thread at
 * a time; it keeps its raster from one frame to the next.
 */
final class DemoPainter {
    private static final int OUTLINE = 0x2c3338;

    private final DemoRaster raster = new DemoRaster();

    /**
     * Paints over (0, 0) .. (width, height) of the graphics. Where its transform scales (a screen with small pixels),
     * the discs are filled in device pixels and stay sharp.
     *
     * @param keys what to press, under the arena; drawn with the overlay only
     */
    void paint(Graphics2D g, int width, int height, DemoFrame frame, boolean overlay, List<String> keys) {
        double scale = Math.max(g.getTransform().getScaleX(), 1e-3);
        fill((int) Math.ceil(width * scale), (int) Math.ceil(height * scale), scale, frame.circles());
        AffineTransform given = g.getTransform();
        g.scale(1 / scale, 1 / scale);
        g.drawImage(raster.image(), 0, 0, null);
        g.setTransform(given);
        if (overlay) {
            Viewport arena = Viewport.fit(width, height, 1);
            Overlay.paint(g, arena, frame);
            Overlay.paintBelow(g, arena, width, height, keys);
        }
    }

    /** The same as a picture of its own. */
    BufferedImage picture(int width, int height, DemoFrame frame, boolean overlay) {
        BufferedImage picture = new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB);
        Graphics2D g = picture.createGraphics();
        paint(g, width, height, frame, overlay, List.of());
        g.dispose();
        return picture;
    }

    private void fill(int width, int height, double scale, float[][] circles) {
        raster.resize(width, height);
        raster.clear();
        Viewport arena = Viewport.fit(width, height, scale);
        raster.outline((int) arena.left(), (int) arena.top(), (int) arena.side(), OUTLINE);
        float[] x = circles[0];
        float[] y = circles[1];
        float[] radius = circles[2];
        float[] mass = circles[3];
        for (int k = 0; k < x.length; k++) {
            raster.disc(arena.x(x[k]), arena.y(y[k]), radius[k] * arena.side(), Palette.ramp(mass[k]));
        }
    }
}
