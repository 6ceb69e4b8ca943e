package io.github.circles2d.playground;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.geom.AffineTransform;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import java.awt.geom.Path2D;

/** Paints the arena, the circles, the bodies, the joints, the terrain and the marks of the tools. One thread at a time; it keeps its raster between frames. */
final class Painter {
    /** Where the mark of how a circle has turned is, and how large, in radii of the circle. */
    private static final double MARK_AT = 0.52;

    private static final double MARK_RADIUS = 0.26;

    /** The share of its colour in the inside of a soft body. */
    private static final double FILLING = 0.6;

    /** Below this radius in pixels a circle has no mark, which would be a speck. */
    private static final double MARK_FROM = 2.5;

    private final Raster raster = new Raster();

    /** Paints over (0, 0) to (width, height). If the transform scales, circles are filled in device pixels and stay sharp. */
    void paint(Graphics2D g, int width, int height, Camera camera, Frame frame) {
        double pixels = Math.max(g.getTransform().getScaleX(), 1e-3);
        fill((int) Math.ceil(width * pixels), (int) Math.ceil(height * pixels), pixels, camera, frame);
        AffineTransform given = g.getTransform();
        g.scale(1 / pixels, 1 / pixels);
        g.drawImage(raster.image(), 0, 0, null);
        g.setTransform(given);
        g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        paintBodies(g, width, height, camera, frame);
        JointPainter.paint(g, width, height, camera, frame);
        PiecePainter.paint(g, width, height, camera, frame);
        ContactPainter.paint(g, width, height, camera, frame);
        for (Mark mark : frame.marks) {
            paint(g, mark, width, height, camera);
        }
    }

    private void fill(int width, int height, double pixels, Camera given, Frame frame) {
        raster.resize(width, height);
        raster.clear(Theme.GROUND);
        Camera camera = new Camera(given.x(), given.y(), given.scale() * pixels);
        double left = camera.screenX(frame.arena.minX(), width);
        double right = camera.screenX(frame.arena.maxX(), width);
        double top = camera.screenY(frame.arena.maxY(), height);
        double bottom = camera.screenY(frame.arena.minY(), height);
        double wall = Math.max(1, Math.round(1.5 * pixels));
        raster.box(left - wall, top - wall, right + wall, bottom + wall, Theme.WALL);
        raster.box(left, top, right, bottom, Theme.ARENA);
        paintBlobs(width, height, camera, frame);
        for (int k = 0; k < frame.circles; k++) {
            double x = camera.screenX(frame.x[k], width);
            double y = camera.screenY(frame.y[k], height);
            double radius = frame.radius[k] * camera.scale();
            raster.disc(x, y, radius, frame.colour[k], frame.rim[k]);
            double angle = frame.angle[k];
            if (radius >= MARK_FROM && angle == angle) {
                double reach = MARK_AT * radius;
                int colour = Ramp.mark(frame.colour[k]);
                raster.disc(
                        x + reach * Math.cos(angle), y - reach * Math.sin(angle), MARK_RADIUS * radius, colour, colour);
            }
        }
    }

    private static Path2D path(Polygons all, int which, int width, int height, Camera camera) {
        Path2D outline = new Path2D.Double();
        for (int point = all.from(which); point < all.from(which + 1); point++) {
            double x = camera.screenX(all.x(point), width);
            double y = camera.screenY(all.y(point), height);
            if (point == all.from(which)) {
                outline.moveTo(x, y);
            } else {
                outline.lineTo(x, y);
            }
        }
        outline.closePath();
        return outline;
    }

    private void paintBlobs(int width, int height, Camera camera, Frame frame) {
        if (frame.blobs.count() == 0) {
            return;
        }
        Graphics2D g = raster.image().createGraphics();
        g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        for (int k = 0; k < frame.blobs.count(); k++) {
            g.setColor(new Color(Ramp.mix(Theme.ARENA, frame.blobs.colour(k), FILLING)));
            g.fill(path(frame.blobs, k, width, height, camera));
        }
        g.dispose();
    }

    private static void paintBodies(Graphics2D g, int width, int height, Camera camera, Frame frame) {
        g.setStroke(new BasicStroke(1.5f, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND));
        for (int k = 0; k < frame.bodies.count(); k++) {
            Path2D outline = path(frame.bodies, k, width, height, camera);
            g.setColor(new Color(frame.bodies.colour(k)));
            g.fill(outline);
            g.setColor(new Color(Ramp.rim(frame.bodies.colour(k))));
            g.draw(outline);
        }
    }

    private static void paint(Graphics2D g, Mark mark, int width, int height, Camera camera) {
        double x = camera.screenX(mark.x(), width);
        double y = camera.screenY(mark.y(), height);
        int opacity = Math.round(255 * Math.min(Math.max(mark.strength(), 0), 1));
        g.setColor(new Color(Theme.WARM.getRed(), Theme.WARM.getGreen(), Theme.WARM.getBlue(), opacity));
        g.setStroke(new BasicStroke(2, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND));
        if (mark.radius() > 0) {
            double r = mark.radius() * camera.scale();
            g.draw(new Ellipse2D.Double(x - r, y - r, 2 * r, 2 * r));
        } else {
            double toX = camera.screenX(mark.toX(), width);
            double toY = camera.screenY(mark.toY(), height);
            g.draw(new Line2D.Double(x, y, toX, toY));
            g.fill(new Ellipse2D.Double(toX - 4, toY - 4, 8, 8));
        }
    }
}
