package io.github.circles2d.demo;

import java.awt.Color;
import java.awt.Font;
import java.awt.FontMetrics;
import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.RenderingHints;
import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Locale;

/** The text over the arena: which engine runs, on what, and how fast. */
final class Overlay {
    private static final Color PANEL = new Color(0, 0, 0, 170);
    private static final Color TEXT = new Color(0xe8eef2);
    private static final Color FAINT = new Color(0x8a97a0);
    private static final Color REMARK = new Color(0xffc857);
    private static final double LINE_HEIGHT = 1.4;

    /** Between two keys in a line. */
    private static final String BETWEEN = "   ";

    /** Pixels that stay free beside the keys. */
    private static final int SIDE = 4;

    private static final float LEAST_SIZE = 8;

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
    static List<String> lines(DemoFrame frame) {
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

    /**
     * Lines of text and where they stand.
     *
     * @param bounds what they and the panel under them cover
     * @param font their font
     * @param lines the lines
     * @param colours of each line
     */
    record Block(Rectangle bounds, Font font, List<String> lines, List<Color> colours) {}

    /** Places the lines in the upper left corner of the arena: broken where they are too long, and no more of them than it has room for. */
    static Block panel(Graphics2D g, Viewport arena, DemoFrame frame) {
        Font font = font(size(arena));
        FontMetrics metrics = g.getFontMetrics(font);
        int pad = metrics.getHeight() / 2;
        int lineHeight = lineHeight(metrics);
        int most = Math.max(1, ((int) arena.side() - 3 * pad) / lineHeight);
        List<String> lines = new ArrayList<>();
        List<Color> colours = new ArrayList<>();
        List<String> whole = lines(frame);
        int widest = 0;
        for (int k = 0; k < whole.size(); k++) {
            for (String line : LineBreaker.words(whole.get(k), metrics, (int) arena.side() - 4 * pad)) {
                if (lines.size() < most) {
                    lines.add(line);
                    colours.add(k == 3 ? REMARK : k == 1 ? FAINT : TEXT);
                    widest = Math.max(widest, metrics.stringWidth(line));
                }
            }
        }
        Rectangle bounds = new Rectangle(
                (int) arena.left() + pad, (int) arena.top() + pad, widest + 2 * pad, lines.size() * lineHeight + pad);
        return new Block(bounds, font, lines, colours);
    }

    /** Draws the lines into the upper left corner of the arena. */
    static void paint(Graphics2D g, Viewport arena, DemoFrame frame) {
        smooth(g);
        Block block = panel(g, arena, frame);
        FontMetrics metrics = g.getFontMetrics(block.font);
        int pad = metrics.getHeight() / 2;
        Rectangle bounds = block.bounds;
        g.setColor(PANEL);
        g.fillRoundRect(bounds.x, bounds.y, bounds.width, bounds.height, pad, pad);
        draw(g, block, bounds.x + pad, bounds.y + pad / 2 + metrics.getAscent(), lineHeight(metrics));
    }

    /**
     * Places the keys under the arena: in the largest type, up to that of the overlay, in which all of them fit into the window;
     * in two lines if that is the only way.
     */
    static Block below(Graphics2D g, Viewport arena, int width, int height, List<String> keys) {
        int top = (int) (arena.top() + arena.side()) + 2;
        int room = width - 2 * SIDE;
        Block block = null;
        for (float size = size(arena); size >= LEAST_SIZE; size--) {
            Font font = font(size);
            FontMetrics metrics = g.getFontMetrics(font);
            List<String> lines = LineBreaker.parts(keys, BETWEEN, metrics, room);
            int most = Math.max(1, (height - top) / metrics.getHeight());
            List<String> shown = lines.subList(0, Math.min(lines.size(), most));
            int widest = shown.stream().mapToInt(metrics::stringWidth).max().orElse(0);
            int left = Math.max(SIDE, Math.min((int) arena.left(), width - SIDE - widest));
            Rectangle bounds = new Rectangle(left, top, widest, shown.size() * metrics.getHeight());
            block = new Block(bounds, font, shown, Collections.nCopies(shown.size(), FAINT));
            boolean whole = String.join(BETWEEN, shown).equals(String.join(BETWEEN, keys));
            if (whole && bounds.y + bounds.height <= height) {
                break;
            }
        }
        return block;
    }

    /** Draws the keys under the arena. */
    static void paintBelow(Graphics2D g, Viewport arena, int width, int height, List<String> keys) {
        smooth(g);
        Block block = below(g, arena, width, height, keys);
        FontMetrics metrics = g.getFontMetrics(block.font);
        draw(g, block, block.bounds.x, block.bounds.y + metrics.getAscent(), metrics.getHeight());
    }

    private static void draw(Graphics2D g, Block block, int left, int baseline, int lineHeight) {
        g.setFont(block.font);
        for (int k = 0; k < block.lines.size(); k++) {
            g.setColor(block.colours.get(k));
            g.drawString(block.lines.get(k), left, baseline + k * lineHeight);
        }
    }

    private static int lineHeight(FontMetrics metrics) {
        return (int) Math.round(metrics.getAscent() * LINE_HEIGHT);
    }

    private static float size(Viewport arena) {
        return (float) Math.min(Math.max(arena.side() / 40, 9), 24);
    }

    private static void smooth(Graphics2D g) {
        g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        g.setRenderingHint(RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
    }

    private static Font font(float size) {
        return new Font(Font.SANS_SERIF, Font.PLAIN, 1).deriveFont(size);
    }

    private static String format(String pattern, Object... values) {
        return String.format(Locale.ROOT, pattern, values);
    }
}
