package io.github.circles2d.playground;

import io.github.circles2d.Terrain;
import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.geom.Arc2D;
import java.awt.geom.Line2D;

/** Paints the pieces of terrain of a frame: segments as thick as they are, lines and arcs of chains on the side that is solid. */
final class PiecePainter {
    /** Pixels: the least width of a stroke, and that of the band which shows the solid side. */
    private static final double STROKE = 2.5;

    private static final double BAND = 7;

    private PiecePainter() {}

    static void paint(Graphics2D g, int width, int height, Camera camera, Frame frame) {
        for (int k = 0; k < frame.pieces; k++) {
            int row = k * Terrain.PIECE_STRIDE;
            Color colour = new Color(frame.pieceColour[k]);
            if (frame.piece[row + Terrain.FORM] == Terrain.SEGMENT) {
                double thickness = 2 * frame.piece[row + Terrain.THICKNESS] * camera.scale();
                stroke(g, colour, Math.max(thickness, STROKE), BasicStroke.CAP_ROUND);
                line(g, width, height, camera, frame.piece, row, 0);
            } else {
                stroke(
                        g,
                        new Color(colour.getRed(), colour.getGreen(), colour.getBlue(), 70),
                        BAND,
                        BasicStroke.CAP_BUTT);
                solid(g, width, height, camera, frame.piece, row, BAND / 2);
                stroke(g, colour, STROKE, BasicStroke.CAP_ROUND);
                solid(g, width, height, camera, frame.piece, row, STROKE / 2);
            }
        }
    }

    private static void stroke(Graphics2D g, Color colour, double width, int cap) {
        g.setColor(colour);
        g.setStroke(new BasicStroke((float) width, cap, BasicStroke.JOIN_ROUND));
    }

    /** So many pixels behind the surface. */
    private static void solid(
            Graphics2D g, int width, int height, Camera camera, float[] piece, int row, double behind) {
        if (piece[row + Terrain.FORM] == Terrain.ARC) {
            arc(g, width, height, camera, piece, row, piece[row + Terrain.INSIDE] == 1 ? behind : -behind);
        } else {
            line(g, width, height, camera, piece, row, behind);
        }
    }

    /** A line, so many pixels to the left of its way. */
    private static void line(Graphics2D g, int width, int height, Camera camera, float[] piece, int row, double left) {
        double x = camera.screenX(piece[row + Terrain.X1], width);
        double y = camera.screenY(piece[row + Terrain.Y1], height);
        double toX = camera.screenX(piece[row + Terrain.X2], width);
        double toY = camera.screenY(piece[row + Terrain.Y2], height);
        double factor = left / Math.max(Math.hypot(toX - x, toY - y), 1e-9);
        double dx = (toY - y) * factor; // y points down on a screen
        double dy = (x - toX) * factor;
        g.draw(new Line2D.Double(x + dx, y + dy, toX + dx, toY + dy));
    }

    private static void arc(
            Graphics2D g, int width, int height, Camera camera, float[] piece, int row, double outside) {
        double x = camera.screenX(piece[row + Terrain.CENTRE_X], width);
        double y = camera.screenY(piece[row + Terrain.CENTRE_Y], height);
        double r = Math.max(piece[row + Terrain.RADIUS] * camera.scale() + outside, 0);
        double from = Math.toDegrees(piece[row + Terrain.FROM]);
        double extent = Math.toDegrees((double) piece[row + Terrain.TO] - piece[row + Terrain.FROM]);
        g.draw(new Arc2D.Double(x - r, y - r, 2 * r, 2 * r, from, extent, Arc2D.OPEN));
    }
}
