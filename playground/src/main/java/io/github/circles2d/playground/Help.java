package io.github.circles2d.playground;

import java.awt.Color;
import java.awt.FontMetrics;
import java.awt.Graphics2D;

/** The keys, over everything. */
final class Help {
    /** What to press, and what it does. An empty line begins the second column. */
    static final String[][] LINES = {
        {"1 to 5", "grab, pour, explode, draw, erase"},
        {"6 to 8", "draw a line, an arc, a chain"},
        {"9  J  K  L", "cut; make a rope, a spring, a pin"},
        {"D", "draw a body, which falls"},
        {"left button", "use the tool; grab selects"},
        {"[ ]  shift + wheel", "brush size; turns held terrain"},
        {"F (held)", "pour at the mouse"},
        {"X", "explode at the mouse"},
        {"wheel", "zoom"},
        {"right or middle drag", "move the picture"},
        {"Home  0", "back to all"},
        {"M", "all scenes with pictures"},
        {"H  F1", "this text"},
        {},
        {"space", "pause"},
        {". ,", "one step, one step back"},
        {"B (held)", "back in time"},
        {"S", "slow motion: 1/2 to 1/16"},
        {"R", "start again"},
        {"Z", "sleep of what lies still, or none"},
        {"C", "paint by speed, pressure, contacts"},
        {"V", "contacts, normals, impulses"},
        {"N", "next back end, same hash"},
        {"T", "times of a step by stage"},
        {"G", "graphs"},
        {"ctrl + O  S  L  P  C", "open, save, link; picture, copy"},
    };

    private static final int FIRST = firstColumn();

    private Help() {}

    private static int firstColumn() {
        int count = 0;
        while (LINES[count].length > 0) {
            count++;
        }
        return count;
    }

    static HelpLayout layout(int width, int height) {
        return HelpLayout.of(width, height, FIRST, LINES.length - FIRST - 1);
    }

    /** Paints the keys, scrolled up by so many pixels. */
    static void paint(Graphics2D g, int width, int height, int scroll) {
        Hud.smooth(g);
        g.setColor(new Color(5, 7, 10, 150));
        g.fillRect(0, 0, width, height);
        HelpLayout layout = layout(width, height);
        Hud.panel(g, layout.left(), layout.top(), layout.width(), layout.height());
        Graphics2D scaled = (Graphics2D) g.create();
        scaled.clipRect(layout.left(), layout.top() + 1, layout.width(), layout.height() - 2);
        scaled.translate(layout.left(), layout.top() - scroll);
        scaled.scale(layout.scale(), layout.scale());
        paintLines(scaled, layout);
        scaled.dispose();
        if (layout.mostScroll() > 0) {
            paintScrollBar(g, layout, scroll);
        }
    }

    private static void paintLines(Graphics2D g, HelpLayout layout) {
        int pad = HelpLayout.pad(layout.columns());
        g.setColor(Theme.TEXT);
        g.setFont(Theme.bold(17));
        g.drawString("Playground", pad, 36);
        if (layout.mostScroll() > 0) {
            g.setColor(Theme.FAINT);
            g.setFont(Theme.font(13));
            g.drawString("scroll by wheel or arrows", pad + HelpLayout.KEY_WIDTH, 36);
        }
        int left = pad;
        int row = 0;
        for (String[] line : LINES) {
            if (line.length > 0) {
                int y = HelpLayout.HEAD + row * HelpLayout.ROW + 16;
                paintKey(g, line[0], left, y);
                g.setFont(Theme.font(14));
                g.setColor(Theme.TEXT);
                g.drawString(line[1], left + HelpLayout.KEY_WIDTH, y);
                row++;
            } else if (layout.columns() == 2) {
                left = 2 * pad + HelpLayout.COLUMN;
                row = 0;
            }
        }
    }

    private static void paintScrollBar(Graphics2D g, HelpLayout layout, int scroll) {
        int track = layout.height() - 8;
        int whole = layout.height() + layout.mostScroll();
        int length = track * layout.height() / whole;
        int from = (track - length) * scroll / layout.mostScroll();
        g.setColor(Theme.FAINT);
        g.fillRoundRect(layout.left() + layout.width() - 8, layout.top() + 4 + from, 4, length, 4, 4);
    }

    private static void paintKey(Graphics2D g, String keys, int left, int y) {
        g.setFont(Theme.font(13));
        FontMetrics metrics = g.getFontMetrics();
        g.setColor(Theme.BUTTON);
        g.fillRoundRect(left - 6, y - 15, metrics.stringWidth(keys) + 12, 21, 8, 8);
        g.setColor(Theme.ACCENT);
        g.drawString(keys, left, y);
    }

    /** The same for a terminal. */
    static String text() {
        StringBuilder text = new StringBuilder();
        for (String[] line : LINES) {
            if (line.length > 0) {
                text.append(String.format("  %-22s%s%n", line[0], line[1]));
            }
        }
        return text.toString();
    }
}
