package io.github.circles2d.playground;

import java.awt.BasicStroke;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.geom.Line2D;
import java.awt.geom.Rectangle2D;

/** Paints the contacts of a frame: points, and normals that are the longer the greater the impulse is. */
final class ContactPainter {
    /** From so many contacts on they are drawn without smooth edges. */
    private static final int MANY = 1_500;

    private static final double POINT = 4;

    /** The greatest length, in those of the mean impulse. */
    private static final double LONGEST = 4;

    private ContactPainter() {}

    static void paint(Graphics2D g, int width, int height, Camera camera, Frame frame) {
        if (frame.contacts == 0) {
            return;
        }
        g.setRenderingHint(
                RenderingHints.KEY_ANTIALIASING,
                frame.contacts > MANY ? RenderingHints.VALUE_ANTIALIAS_OFF : RenderingHints.VALUE_ANTIALIAS_ON);
        g.setStroke(new BasicStroke(1.4f));
        g.setColor(Theme.NORMAL);
        for (int k = 0; k < frame.contacts; k++) {
            int at = Contacts.STRIDE * k;
            double length = length(frame, frame.contact[at + 4]);
            double toX = frame.contact[at] + length * frame.contact[at + 2];
            double toY = frame.contact[at + 1] + length * frame.contact[at + 3];
            g.draw(new Line2D.Double(
                    camera.screenX(frame.contact[at], width),
                    camera.screenY(frame.contact[at + 1], height),
                    camera.screenX(toX, width),
                    camera.screenY(toY, height)));
        }
        g.setColor(Theme.CONTACT);
        double size = Math.min(POINT, 0.6 * frame.normalLength * camera.scale());
        for (int k = 0; k < frame.contacts; k++) {
            double x = camera.screenX(frame.contact[Contacts.STRIDE * k], width);
            double y = camera.screenY(frame.contact[Contacts.STRIDE * k + 1], height);
            g.fill(new Rectangle2D.Double(x - size / 2, y - size / 2, size, size));
        }
        g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
    }

    /** That of the mean impulse is the usual radius. */
    static double length(Frame frame, float impulse) {
        return frame.meanImpulse > 0 ? frame.normalLength * Math.min(impulse / frame.meanImpulse, LONGEST) : 0;
    }
}
