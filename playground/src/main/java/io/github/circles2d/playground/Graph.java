package io.github.circles2d.playground;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.FontMetrics;
import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.geom.Path2D;
import java.util.Arrays;

/** A line of the last values of a figure, on a panel. Its scale follows the great values, slowly when they fall; rare peaks are cut off. */
final class Graph {
    private static final double FALL = 0.02;
    private static final int HEAD = 24;

    private static final double MARGIN = 1.15;

    private static final float[] NONE = {};

    private final String title;
    private final Color colour;
    private final double common;
    private double top;

    /** A graph whose scale has room for this part of the values, 0 to 1. */
    Graph(String title, Color colour, double common) {
        this.title = title;
        this.common = common;
        this.colour = colour;
    }

    void paint(Graphics2D g, Rectangle at, float[] values, String now) {
        paint(g, at, values, NONE, now);
    }

    /** Marks values beside which there is not 0, too. */
    void paint(Graphics2D g, Rectangle at, float[] values, float[] marks, String now) {
        int left = at.x;
        int upper = at.y;
        int width = at.width;
        int height = at.height;
        Hud.panel(g, left, upper, width, height);
        g.setFont(Theme.font(12));
        FontMetrics metrics = g.getFontMetrics();
        g.setColor(Theme.FAINT);
        g.drawString(title, left + 10, upper + 17);
        g.setColor(Theme.TEXT);
        g.drawString(now, left + width - 10 - metrics.stringWidth(now), upper + 17);
        scale(values);
        if (values.length > 1 && top > 0) {
            Rectangle inner = new Rectangle(left + 10, upper + HEAD, width - 20, height - HEAD - 8);
            draw(g, inner.x, inner.y, inner.width, inner.height, values);
            mark(g, inner, marks);
        }
    }

    private void scale(float[] values) {
        float[] sorted = values.clone();
        Arrays.sort(sorted);
        double greatest = sorted.length == 0 ? 0 : MARGIN * sorted[(int) (common * (sorted.length - 1))];
        boolean far = greatest < top * 1e-3;
        top = greatest >= top || far ? greatest : top + FALL * (greatest - top);
    }

    private static void mark(Graphics2D g, Rectangle at, float[] marks) {
        double pitch = (double) at.width / (History.LENGTH - 1);
        g.setColor(Theme.WARM);
        g.setStroke(new BasicStroke(1));
        for (int k = 0; k < marks.length; k++) {
            if (marks[k] != 0) {
                int x = (int) Math.round(at.x + at.width - pitch * (marks.length - 1 - k));
                g.drawLine(x, at.y, x, at.y + at.height);
            }
        }
    }

    private void draw(Graphics2D g, int left, int upper, int width, int height, float[] values) {
        Path2D line = new Path2D.Double();
        double pitch = (double) width / (History.LENGTH - 1);
        double first = left + width - pitch * (values.length - 1);
        for (int k = 0; k < values.length; k++) {
            double x = first + pitch * k;
            double y = upper + height * (1 - Math.min(Math.max(values[k] / top, 0), 1));
            if (k == 0) {
                line.moveTo(x, y);
            } else {
                line.lineTo(x, y);
            }
        }
        Path2D area = new Path2D.Double(line);
        area.lineTo(left + width, upper + height);
        area.lineTo(first, upper + height);
        area.closePath();
        g.setColor(new Color(colour.getRed(), colour.getGreen(), colour.getBlue(), 38));
        g.fill(area);
        g.setColor(colour);
        g.setStroke(new BasicStroke(1.4f, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND));
        g.draw(line);
    }
}
