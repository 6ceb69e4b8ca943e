package io.github.circles2d.demo;

import java.awt.Color;
import java.awt.Font;
import java.awt.FontMetrics;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/** The text over the arena: which engine runs, on what, and how fast. */
final class Overlay {
    private static final Color PANEL = new Color(0, 0, 0, 170);
    private static final Color TEXT = new Color(0xe8eef2);
    private static final Color FAINT = new Color(0x8a97a0);
    private static final Color REMARK = new Color(0xffc857);
    private static final double LINE_HEIGHT = 1.4;

    private Overlay() {}

    /** Whether this machine can draw text at all; a Java runtime without any font installed cannot. */
    static boolean available() {
        try {
            Graphics2D g = new BufferedImage(1, 1, BufferedImage.TYPE_INT_RGB).createGraphics();
            g.setFont(font(12));
            boolean works = g.getFontMetrics().stringWidth("circles") > 0;
            g.dispose();
            return works;
        } catch (RuntimeException | Error e) { // which of them, even a plain Error, depends on the runtime
            return false;
        }
    }

    /** The lines that stand over the arena, the remark last where there is one. */
    static List<String> lines(Frame frame) {
        List<String> lines = new ArrayList<>();
        lines.add(format("%s, %s, n = %,d", frame.engine(), frame.strategy(), frame.size()));
        lines.add(frame.device());
        String speed = frame.loopMillis() == 0 ? "" : format("%.2f ms a loop, ", frame.loopMillis());
        String rate = frame.framesPerSecond() == 0 ? "" : format("%.0f frames a second, ", frame.framesPerSecond());
        lines.add(speed + rate + format("frame %,d", frame.number()) + (frame.paused() ? ", paused" : ""));
        if (!frame.message().isEmpty()) {
            lines.add(frame.message());
        }
        return lines;
    }

    /** Draws the lines into the upper left corner of the arena. */
    static void paint(Graphics2D g, Viewport arena, Frame frame) {
        prepare(g, arena);
        FontMetrics metrics = g.getFontMetrics();
        List<String> lines = lines(frame);
        int pad = metrics.getHeight() / 2;
        int room = (int) arena.side() - 4 * pad;
        int widest = 0;
        for (int k = 0; k < lines.size(); k++) {
            String cut = cut(lines.get(k), metrics, room);
            lines.set(k, cut);
            widest = Math.max(widest, metrics.stringWidth(cut));
        }
        int lineHeight = (int) Math.round(metrics.getAscent() * LINE_HEIGHT);
        int left = (int) arena.left() + pad;
        int top = (int) arena.top() + pad;
        g.setColor(PANEL);
        g.fillRoundRect(left, top, widest + 2 * pad, lines.size() * lineHeight + pad, pad, pad);
        int baseline = top + pad / 2 + metrics.getAscent();
        for (int k = 0; k < lines.size(); k++) {
            g.setColor(k == 3 ? REMARK : k == 1 ? FAINT : TEXT);
            g.drawString(lines.get(k), left + pad, baseline + k * lineHeight);
        }
    }

    /** Draws one faint line below the arena. */
    static void paintBelow(Graphics2D g, Viewport arena, String text) {
        prepare(g, arena);
        g.setColor(FAINT);
        FontMetrics metrics = g.getFontMetrics();
        String cut = cut(text, metrics, (int) arena.side());
        g.drawString(cut, (int) arena.left(), (int) (arena.top() + arena.side()) + metrics.getAscent() + 3);
    }

    private static void prepare(Graphics2D g, Viewport arena) {
        g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        g.setRenderingHint(RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
        g.setFont(font((float) Math.min(Math.max(arena.side() / 40, 9), 24)));
    }

    private static Font font(float size) {
        return new Font(Font.SANS_SERIF, Font.PLAIN, 1).deriveFont(size);
    }

    private static String cut(String text, FontMetrics metrics, int room) {
        if (metrics.stringWidth(text) <= room) {
            return text;
        }
        int length = text.length();
        while (length > 0 && metrics.stringWidth(text.substring(0, length) + "...") > room) {
            length--;
        }
        return text.substring(0, length) + "...";
    }

    private static String format(String pattern, Object... values) {
        return String.format(Locale.ROOT, pattern, values);
    }
}
