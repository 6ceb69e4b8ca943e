package io.github.circles2d.playground;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Font;
import java.awt.FontMetrics;
import java.awt.Graphics2D;
import java.awt.Point;
import java.awt.RenderingHints;
import java.awt.geom.Ellipse2D;
import java.util.List;
import java.util.Locale;

/** The text and the graphs over the circles. */
final class Hud {
    private static final int MARGIN = 14;
    private static final int PAD = 12;
    private static final int LINE = 19;
    private static final float SIZE = 13;
    private static final int GRAPH_WIDTH = 240;
    private static final int GRAPH_HEIGHT = 74;

    private final Graph steps = new Graph("ms a step", Theme.ACCENT, 0.97);
    private final Graph energy = new Graph("energy", Theme.WARM, 1);
    private final FrameRate rate = new FrameRate();

    /** Draws how far the tool in hand reaches. */
    void paintBrush(Graphics2D g, Point mouse, Camera camera, Frame frame) {
        if (mouse == null || frame.brush <= 0) {
            return;
        }
        smooth(g);
        double r = frame.brush * camera.scale();
        g.setStroke(new BasicStroke(1.5f));
        g.setColor(new Color(0xe3, 0xe9, 0xef, 130));
        g.draw(new Ellipse2D.Double(mouse.x - r, mouse.y - r, 2 * r, 2 * r));
    }

    void paint(Graphics2D g, int width, int height, Frame frame, boolean graphs) {
        rate.tick(System.nanoTime());
        smooth(g);
        int bottom = paintFigures(g, frame);
        if (graphs) {
            int left = width - MARGIN - GRAPH_WIDTH;
            steps.paint(g, left, MARGIN, GRAPH_WIDTH, GRAPH_HEIGHT, frame.stepTimes, format("%.2f", frame.stepMillis));
            energy.paint(
                    g,
                    left,
                    MARGIN + GRAPH_HEIGHT + 8,
                    GRAPH_WIDTH,
                    GRAPH_HEIGHT,
                    frame.energies,
                    format("%.3g", frame.energy));
        }
        paintLegend(g, bottom + 8, frame.paint);
        paintMessage(g, width, frame);
    }

    /** The lines of the panel. */
    List<String> lines(Frame frame) {
        String speed = frame.speed == 1 ? "" : format(", speed 1/%.0f", 1 / frame.speed);
        String state = frame.rewinding
                ? format(", back in time (%,d steps left)", frame.stepsToRewind)
                : frame.paused ? ", paused" : speed;
        return List.of(
                format("%s, %,d circles", frame.stage, frame.circles),
                format("step %,d%s", frame.step, state),
                format("%s, %.0f frames a second", frame.backend, rate.perSecond()),
                format("hash %016x at step %,d", frame.hash, frame.hashStep));
    }

    /** Returns where the panel ends. */
    private int paintFigures(Graphics2D g, Frame frame) {
        List<String> lines = lines(frame);
        int widest = 0;
        for (int k = 0; k < lines.size(); k++) {
            g.setFont(font(k));
            widest = Math.max(widest, g.getFontMetrics().stringWidth(lines.get(k)));
        }
        panel(g, MARGIN, MARGIN, widest + 2 * PAD, lines.size() * LINE + PAD + 2);
        for (int k = 0; k < lines.size(); k++) {
            g.setFont(font(k));
            boolean remark = k == 1 && (frame.paused || frame.rewinding || frame.speed < 1);
            g.setColor(remark ? Theme.WARM : k < 2 ? Theme.TEXT : Theme.FAINT);
            g.drawString(lines.get(k), MARGIN + PAD, MARGIN + PAD + 8 + k * LINE);
        }
        return MARGIN + lines.size() * LINE + PAD + 2;
    }

    private static Font font(int line) {
        return line == 0 ? Theme.bold(SIZE) : line == 3 ? Theme.digits(SIZE - 1) : Theme.font(SIZE);
    }

    private static void paintLegend(Graphics2D g, int top, PaintMode mode) {
        int[] colours = Shades.legend(mode);
        if (colours.length == 0) {
            return;
        }
        g.setFont(Theme.font(SIZE - 1));
        FontMetrics metrics = g.getFontMetrics();
        int bar = 132;
        String label = mode.label();
        panel(g, MARGIN, top, metrics.stringWidth(label) + bar + 3 * PAD, 26);
        g.setColor(Theme.FAINT);
        g.drawString(label, MARGIN + PAD, top + 18);
        int left = MARGIN + 2 * PAD + metrics.stringWidth(label);
        for (int k = 0; k < colours.length; k++) {
            int from = left + bar * k / colours.length;
            int to = left + bar * (k + 1) / colours.length;
            g.setColor(new Color(colours[k]));
            g.fillRect(from, top + 9, to - from, 8);
        }
    }

    private static void paintMessage(Graphics2D g, int width, Frame frame) {
        if (frame.message.isEmpty()) {
            return;
        }
        g.setFont(Theme.font(SIZE));
        FontMetrics metrics = g.getFontMetrics();
        String text = cut(frame.message, metrics, width - 2 * (MARGIN + PAD));
        int wide = metrics.stringWidth(text) + 2 * PAD;
        int left = Math.max((width - wide) / 2, MARGIN);
        int top = MARGIN + 130;
        panel(g, left, top, wide, 28);
        g.setColor(Theme.WARM);
        g.drawString(text, left + PAD, top + 19);
    }

    private static String cut(String text, FontMetrics metrics, int room) {
        int length = text.length();
        while (length > 0 && metrics.stringWidth(text.substring(0, length)) > room) {
            length--;
        }
        return text.substring(0, length);
    }

    /** The ground of a text. */
    static void panel(Graphics2D g, int left, int top, int width, int height) {
        g.setColor(Theme.PANEL);
        g.fillRoundRect(left, top, width, height, 10, 10);
        g.setColor(Theme.LINE);
        g.setStroke(new BasicStroke(1));
        g.drawRoundRect(left, top, width - 1, height - 1, 10, 10);
    }

    static void smooth(Graphics2D g) {
        g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        g.setRenderingHint(RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
        g.setRenderingHint(RenderingHints.KEY_STROKE_CONTROL, RenderingHints.VALUE_STROKE_PURE);
    }

    private static String format(String pattern, Object... values) {
        return String.format(Locale.ROOT, pattern, values);
    }
}
