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

/** The text and the graphs over the circles. */
final class Hud {
    private static final int PAD = 12;
    private static final int LINE = 19;
    private static final float SIZE = 13;
    private static final int LEGEND_GAP = 6;

    private final Graph steps = new Graph("ms a step", Theme.ACCENT, 0.97);
    private final Graph energy = new Graph("energy", Theme.WARM, 1);
    private final FrameRate rate = new FrameRate();
    private final List<Rectangle> shown = new ArrayList<>();

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

    void paint(Graphics2D g, HudLayout layout, Frame frame) {
        rate.tick(System.nanoTime());
        smooth(g);
        shown.clear();
        List<String> message = frame.message.isEmpty()
                ? List.of()
                : wrap(frame.message, metrics(g, SIZE), layout.messageWidth() - 2 * PAD);
        Rectangle note = layout.message(textSize(g, message));
        if (!message.isEmpty()) {
            shown.add(note);
        }
        paintCards(g, layout, frame);
        if (isFree(layout.figures())) {
            paintFigures(g, layout.figures(), lines(frame), frame);
        }
        if (isFree(layout.legend())) {
            paintLegend(g, layout.legend(), frame);
        }
        if (isFree(layout.steps())) {
            steps.paint(g, layout.steps(), frame.stepTimes, frame.stepMoves, Figures.format("%.2f", frame.stepMillis));
        }
        if (isFree(layout.energy())) {
            energy.paint(g, layout.energy(), frame.energies, Figures.format("%.3g", frame.energy));
        }
        if (!message.isEmpty()) {
            paintText(g, note, message, Theme.WARM, Theme.WARM);
        }
    }

    /** Whether a panel is to be shown, since it is there and nothing has taken its place. */
    private boolean isFree(Rectangle panel) {
        boolean free = panel != null && shown.stream().noneMatch(panel::intersects);
        if (free) {
            shown.add(panel);
        }
        return free;
    }

    private void paintCards(Graphics2D g, HudLayout layout, Frame frame) {
        List<String> circle = new ArrayList<>();
        for (String line : frame.card) {
            circle.addAll(wrap(line, metrics(g, SIZE), HudLayout.COLUMN - 2 * PAD));
        }
        Rectangle[] places = layout.cards(
                frame.showsProfile ? ProfileCard.height(frame) : 0, circle.isEmpty() ? 0 : textHeight(circle));
        if (places[0] != null) {
            ProfileCard.paint(g, places[0], frame);
            shown.add(places[0]);
        }
        if (places[1] != null) {
            paintText(g, places[1], circle, Theme.ACCENT, Theme.TEXT);
            shown.add(places[1]);
        }
    }

    /** The panels, cards and the message that were painted last. */
    List<Rectangle> shown() {
        return List.copyOf(shown);
    }

    /** The lines of the panel. */
    List<String> lines(Frame frame) {
        String speed = frame.speed == 1 ? "" : Figures.format(", speed 1/%.0f", 1 / frame.speed);
        String awake = frame.canSleep ? Figures.format(", %,d awake", frame.awake) : "";
        String state = frame.rewinding
                ? Figures.format(", rewinding (%,d left)", frame.stepsToRewind)
                : awake + (frame.paused ? ", paused" : speed);
        return List.of(
                Figures.format("%s, %,d circles", StageNotes.title(frame.stage), frame.circles),
                Figures.format("step %,d%s", frame.step, state),
                Figures.format(
                        "%s, %.0f frames a second", Whereabouts.words(frame.asked, frame.backend), rate.perSecond()),
                Figures.format("hash %016x at %,d", frame.hash, frame.hashStep));
    }

    private static void paintFigures(Graphics2D g, Rectangle at, List<String> lines, Frame frame) {
        boolean oneLine = at.height < HudLayout.FIGURES;
        panel(g, at.x, at.y, at.width, at.height);
        int x = at.x + PAD;
        int y = at.y + (oneLine ? 19 : PAD + 8);
        for (int k = 0; k < lines.size(); k++) {
            g.setFont(font(k));
            FontMetrics metrics = g.getFontMetrics();
            int room = at.x + at.width - PAD - x;
            if (oneLine && k > 0 && metrics.stringWidth(lines.get(k)) > room) {
                return;
            }
            boolean remark = k == 1 && (frame.paused || frame.rewinding || frame.speed < 1);
            g.setColor(remark ? Theme.WARM : k < 2 ? Theme.TEXT : Theme.FAINT);
            g.drawString(wrap(lines.get(k), metrics, room).get(0), x, y);
            if (oneLine) {
                x += metrics.stringWidth(lines.get(k)) + 2 * PAD;
            } else {
                y += LINE;
            }
        }
    }

    private static Font font(int line) {
        return line == 0 ? Theme.bold(SIZE) : line == 3 ? Theme.digits(SIZE - 1) : Theme.font(SIZE);
    }

    /** Whether the colours of a frame have a meaning. */
    static boolean hasLegend(Frame frame) {
        return Shades.legend(frame.paint).length > 0;
    }

    /** The number at the end of the legend; from there on all circles have the last colour. */
    private static String most(Frame frame) {
        String pattern = frame.legendMost < 100 ? "%.3g" : "%.0f";
        return frame.paint == PaintMode.CONTACTS
                ? Figures.format("%.0f+", frame.legendMost)
                : frame.legendMost > 0 ? Figures.format(pattern, frame.legendMost) + "+" : "";
    }

    private static void paintLegend(Graphics2D g, Rectangle at, Frame frame) {
        int[] colours = Shades.legend(frame.paint);
        String most = most(frame);
        g.setFont(Theme.font(SIZE - 1));
        panel(g, at.x, at.y, at.width, at.height);
        g.setColor(Theme.FAINT);
        g.drawString(frame.paint.label(), at.x + PAD, at.y + 18);
        FontMetrics metrics = g.getFontMetrics();
        int end = at.x + at.width - PAD - metrics.stringWidth(most);
        int zero = at.x + PAD + metrics.stringWidth(frame.paint.label()) + PAD;
        int left = zero + metrics.stringWidth("0") + LEGEND_GAP;
        int bar = end - LEGEND_GAP - left;
        g.drawString("0", zero, at.y + 18);
        g.drawString(most, end, at.y + 18);
        for (int k = 0; k < colours.length; k++) {
            int from = left + bar * k / colours.length;
            int to = left + bar * (k + 1) / colours.length;
            g.setColor(new Color(colours[k]));
            g.fillRect(from, at.y + 9, to - from, 8);
        }
    }

    private static Dimension textSize(Graphics2D g, List<String> lines) {
        FontMetrics metrics = metrics(g, SIZE);
        int widest = lines.stream().mapToInt(metrics::stringWidth).max().orElse(0);
        return new Dimension(widest + 2 * PAD, textHeight(lines));
    }

    private static int textHeight(List<String> lines) {
        return 9 + lines.size() * LINE;
    }

    private static void paintText(Graphics2D g, Rectangle at, List<String> lines, Color first, Color others) {
        panel(g, at.x, at.y, at.width, at.height);
        g.setFont(Theme.font(SIZE));
        for (int k = 0; k < lines.size(); k++) {
            g.setColor(k == 0 ? first : others);
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
}
