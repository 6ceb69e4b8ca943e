package io.github.circles2d.playground;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;

/** Paints the joints of a frame as lines, in the colours of their forces; a joint without length as a dot. */
final class JointPainter {
    /** From so many lines on they are drawn without smooth edges, in a tenth of the time. */
    private static final int MANY = 4_000;

    private static final double DOT = 5;

    private JointPainter() {}

    static void paint(Graphics2D g, int width, int height, Camera camera, Frame frame) {
        boolean many = frame.joints > MANY;
        g.setRenderingHint(
                RenderingHints.KEY_ANTIALIASING,
                many ? RenderingHints.VALUE_ANTIALIAS_OFF : RenderingHints.VALUE_ANTIALIAS_ON);
        g.setStroke(new BasicStroke(many ? 1 : 1.8f, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND));
        int colour = -1;
        for (int k = 0; k < frame.joints; k++) {
            double x = camera.screenX(frame.joint[4 * k], width);
            double y = camera.screenY(frame.joint[4 * k + 1], height);
            double toX = camera.screenX(frame.joint[4 * k + 2], width);
            double toY = camera.screenY(frame.joint[4 * k + 3], height);
            if (frame.jointColour[k] != colour) {
                colour = frame.jointColour[k];
                g.setColor(new Color(colour));
            }
            if (Math.abs(toX - x) + Math.abs(toY - y) < DOT) {
                g.fill(new Ellipse2D.Double(x - DOT / 2, y - DOT / 2, DOT, DOT));
            } else {
                g.draw(new Line2D.Double(x, y, toX, toY));
            }
        }
        g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
    }
}
