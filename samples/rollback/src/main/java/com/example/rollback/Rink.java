package com.example.rollback;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Dimension;
import java.awt.Font;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.Point;
import java.awt.RenderingHints;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import javax.swing.JComponent;

/** What one peer sees. Where a late input shows that a prediction was wrong, a line leads from what was shown to what is. */
final class Rink extends JComponent {
    static final Color GROUND = new Color(0x0b0e13), TEXT = new Color(0xe3e9ef);
    private static final Color[] SIDES = {new Color(0xffb454), new Color(0x4cc2ff)};
    private static final Color ICE = new Color(0x151c26), LINE = new Color(0x2b3745), PUCK = new Color(0xc9d4df);
    private static final Color WRONG = new Color(0xff5f6d);
    private static final int TOP = 64;

    private final Hockey peer;
    private final int side;
    private final Corrections corrections;

    Rink(Hockey peer, Corrections corrections, int side) {
        this.peer = peer;
        this.corrections = corrections;
        this.side = side;
        setPreferredSize(new Dimension(Hockey.WIDTH, Hockey.HEIGHT + TOP));
    }

    /** Where the mouse is in the world; null outside. */
    Point mouse() {
        Point at = getMousePosition();
        return at == null ? null : new Point(at.x, Math.max(at.y - TOP, 0));
    }

    @Override
    protected void paintComponent(Graphics graphics) {
        Graphics2D g = (Graphics2D) graphics.create();
        g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        g.setRenderingHint(RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
        g.setColor(SIDES[side]);
        g.setFont(new Font(Font.SANS_SERIF, Font.PLAIN, 14));
        g.drawString("what " + (side == 0 ? "orange" : "blue") + " sees", 12, 28);
        int predicted = peer.rollback.frame() - peer.rollback.confirmedFrames();
        g.drawString(predicted + " frames are a guess, " + peer.rollback.rollbacks() + " guesses were wrong", 12, 50);
        g.setFont(new Font(Font.SANS_SERIF, Font.BOLD, 40));
        int middle = Hockey.WIDTH / 2;
        for (int k = 0; k < 2; k++) {
            String points = "" + peer.points[k];
            g.setColor(SIDES[k]);
            g.drawString(points, k == 0 ? middle + 60 : middle + 150, 46);
        }
        g.setColor(TEXT);
        g.drawString(":", middle + 120, 44);
        g.translate(0, TOP);
        g.setColor(ICE);
        g.fillRect(0, 0, Hockey.WIDTH, Hockey.HEIGHT);
        g.setColor(LINE);
        g.fillRect(middle - 1, 0, 2, Hockey.HEIGHT);
        g.clipRect(0, 0, Hockey.WIDTH, Hockey.HEIGHT);
        for (int k = 0; k < 2; k++) { // the walls to defend
            g.setColor(SIDES[k]);
            g.fillRect(k == 0 ? 0 : Hockey.WIDTH - 5, 0, 5, Hockey.HEIGHT);
        }
        corrections.look();
        float[] circles = corrections.circles;
        for (int k = 0; k + 3 < circles.length; k += 4) {
            if (circles[k] == circles[k]) { // else there is no circle
                g.setColor(k < 8 ? SIDES[k / 4] : PUCK);
                for (int seam = -1; seam <= 1; seam++) { // the lower edge is joined to the upper one
                    disc(g, circles[k], circles[k + 1] + seam * Hockey.HEIGHT, circles[k + 2]);
                }
            }
        }
        for (Corrections.Correction one : corrections.all) {
            int opacity = 255 * (one.ends() - corrections.frame) / Corrections.FADE;
            g.setColor(new Color(WRONG.getRed(), WRONG.getGreen(), WRONG.getBlue(), Math.max(opacity, 0)));
            g.setStroke(new BasicStroke(3, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND));
            g.draw(new Line2D.Float(one.x(), one.y(), one.toX(), one.toY()));
            g.draw(new Ellipse2D.Float(one.x() - 5, one.y() - 5, 10, 10));
        }
        g.dispose();
    }

    private static void disc(Graphics2D g, float x, float y, float r) {
        g.fill(new Ellipse2D.Float(x - r, y - r, 2 * r, 2 * r));
    }
}
