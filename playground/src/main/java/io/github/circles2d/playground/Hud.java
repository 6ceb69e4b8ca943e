package io.github.circles2d.playground;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Dimension;
import java.awt.Font;
import java.awt.FontMetrics;
import java.awt.Graphics2D;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.RenderingHints;
import java.awt.geom.Ellipse2D;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/** The text and the graphs over the circles. */
final class Hud {
    private static final int PAD = 12;
    private static final int LINE = 19;
    private static final float SIZE = 13;
    private static final int LEGEND_BAR = 132;
    private static final int LEGEND_GAP = 6;

    private final Graph steps = new Graph("ms a step", Theme.ACCENT, 0.97);
    private final Graph energy = new Graph("energy", Theme.WARM, 1);
    private final FrameRate rate = new FrameRate();
    private HudLayout layout;

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
        int room = width - 2 * HudLayout.MARGIN - 2 * PAD;
        List<String> lines = lines(frame);
        List<String> message = frame.message.isEmpty() ? List.of() : wrap(frame.message, metrics(g, SIZE), room);
        layout = HudLayout.of(
                width,
                height,
                figuresSize(g, lines, room),
                legendSize(g, frame),
                message.isEmpty() ? null : messageSize(g, message),
                graphs);
        if (layout.figures() != null) {
            paintFigures(g, layout.figures(), lines, frame);
        }
        if (layout.steps() != null) {
            steps.paint(g, layout.steps(), frame.stepTimes, format("%.2f", frame.stepMillis));
            energy.paint(g, layout.energy(), frame.energies, format("%.3g", frame.energy));
        }
        if (layout.legend() != null) {
            paintLegend(g, layout.legend(), frame);
        }
        if (layout.message() != null) {
            paintMessage(g, layout.message(), message);
        }
        Rectangle card = frame.card.isEmpty() ? null : layout.right(width, height, messageSize(g, frame.card));
        if (card != null) {
            paintCard(g, card, frame.card);
        }
    }

    /** Where the panels were when they were painted last; null before. */
    HudLayout layout() {
        return layout;
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

    private static Dimension figuresSize(Graphics2D g, List<String> lines, int room) {
        int widest = 0;
        for (int k = 0; k < lines.size(); k++) {
            widest = Math.max(widest, g.getFontMetrics(font(k)).stringWidth(lines.get(k)));
        }
        return new Dimension(Math.min(widest, room) + 2 * PAD, lines.size() * LINE + PAD + 2);
    }

    private static void paintFigures(Graphics2D g, Rectangle at, List<String> lines, Frame frame) {
        panel(g, at.x, at.y, at.width, at.height);
        for (int k = 0; k < lines.size(); k++) {
            g.setFont(font(k));
            boolean remark = k == 1 && (frame.paused || frame.rewinding || frame.speed < 1);
            g.setColor(remark ? Theme.WARM : k < 2 ? Theme.TEXT : Theme.FAINT);
            String line =
                    wrap(lines.get(k), g.getFontMetrics(), at.width - 2 * PAD).get(0);
            g.drawString(line, at.x + PAD, at.y + PAD + 8 + k * LINE);
        }
    }

    private static Font font(int line) {
        return line == 0 ? Theme.bold(SIZE) : line == 3 ? Theme.digits(SIZE - 1) : Theme.font(SIZE);
    }

    /** Null for colours without a meaning. */
    private static Dimension legendSize(Graphics2D g, Frame frame) {
        boolean none = Shades.legend(frame.paint).length == 0;
        int text = metrics(g, SIZE - 1).stringWidth(frame.paint.label() + "0" + most(frame));
        return none ? null : new Dimension(text + LEGEND_BAR + 3 * PAD + 2 * LEGEND_GAP, 26);
    }

    /** The number at the end of the legend; from there on all circles have the last colour. */
    private static String most(Frame frame) {
        String pattern = frame.legendMost < 100 ? "%.3g" : "%.0f";
        return frame.paint == PaintMode.CONTACTS
                ? format("%.0f+", frame.legendMost)
                : frame.legendMost > 0 ? format(pattern, frame.legendMost) + "+" : "";
    }

    private static void paintLegend(Graphics2D g, Rectangle at, Frame frame) {
        int[] colours = Shades.legend(frame.paint);
        String most = most(frame);
        g.setFont(Theme.font(SIZE - 1));
        panel(g, at.x, at.y, at.width, at.height);
        g.setColor(Theme.FAINT);
        g.drawString(frame.paint.label(), at.x + PAD, at.y + 18);
        int end = at.x + at.width - PAD - g.getFontMetrics().stringWidth(most);
        int left = end - LEGEND_GAP - LEGEND_BAR;
        g.drawString("0", left - LEGEND_GAP - g.getFontMetrics().stringWidth("0"), at.y + 18);
        g.drawString(most, end, at.y + 18);
        for (int k = 0; k < colours.length; k++) {
            int from = left + LEGEND_BAR * k / colours.length;
            int to = left + LEGEND_BAR * (k + 1) / colours.length;
            g.setColor(new Color(colours[k]));
            g.fillRect(from, at.y + 9, to - from, 8);
        }
    }

    private static Dimension messageSize(Graphics2D g, List<String> lines) {
        FontMetrics metrics = metrics(g, SIZE);
        int widest = lines.stream().mapToInt(metrics::stringWidth).max().orElse(0);
        return new Dimension(widest + 2 * PAD, 9 + lines.size() * LINE);
    }

    private static void paintMessage(Graphics2D g, Rectangle at, List<String> lines) {
        panel(g, at.x, at.y, at.width, at.height);
        g.setFont(Theme.font(SIZE));
        g.setColor(Theme.WARM);
        for (int k = 0; k < lines.size(); k++) {
            g.drawString(lines.get(k), at.x + PAD, at.y + 19 + k * LINE);
        }
    }

    private static void paintCard(Graphics2D g, Rectangle at, List<String> lines) {
        panel(g, at.x, at.y, at.width, at.height);
        g.setFont(Theme.font(SIZE));
        for (int k = 0; k < lines.size(); k++) {
            g.setColor(k == 0 ? Theme.ACCENT : Theme.TEXT);
            g.drawString(lines.get(k), at.x + PAD, at.y + 19 + k * LINE);
        }
    }

    private static FontMetrics metrics(Graphics2D g, float size) {
        return g.getFontMetrics(Theme.font(size));
    }

    /** Breaks a text between words into lines that fit; within a word that is longer than a line. */
    static List<String> wrap(String text, FontMetrics metrics, int room) {
        List<String> lines = new ArrayList<>();
        String rest = text;
        while (rest.length() > 1 && metrics.stringWidth(rest) > room) {
            int fitting = 1;
            while (metrics.stringWidth(rest.substring(0, fitting + 1)) <= room) {
                fitting++;
            }
            int blank = rest.lastIndexOf(' ', fitting);
            int end = blank > 0 ? blank : fitting;
            lines.add(rest.substring(0, end));
            rest = rest.substring(end).stripLeading();
        }
        lines.add(rest);
        return lines;
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
