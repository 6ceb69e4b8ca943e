package io.github.circles2d.playground;

import java.awt.Color;
import java.awt.FontMetrics;
import java.awt.Graphics2D;

/** The keys, over everything. */
final class Help {
    /** What to press, and what it does. An empty line begins the second column. */
    static final String[][] LINES = {
        {"1 to 5", "grab, pour, explode, draw, erase"},
        {"left button", "use the tool"},
        {"[ ]  shift + wheel", "smaller or larger brush"},
        {"F (held)", "pour at the mouse"},
        {"X", "explode at the mouse"},
        {"wheel", "zoom"},
        {"right or middle drag", "move the picture"},
        {"Home  0", "back to all"},
        {"H  F1", "this text"},
        {},
        {"space", "pause"},
        {". ,", "one step, one step back"},
        {"B (held)", "back in time"},
        {"S", "slow motion: 1/2 to 1/16"},
        {"R", "start again"},
        {"C", "paint by speed, pressure, contacts"},
        {"N", "next back end, same hash"},
        {"G", "graphs"},
        {"ctrl + O  S  P  C", "open, save, picture, copy"},
    };

    private static final int ROW = 25;
    private static final int KEY_WIDTH = 158;
    private static final int TEXT_WIDTH = 262;
    private static final int PAD = 28;

    private Help() {}

    static void paint(Graphics2D g, int width, int height) {
        Hud.smooth(g);
        g.setColor(new Color(5, 7, 10, 150));
        g.fillRect(0, 0, width, height);
        int column = KEY_WIDTH + TEXT_WIDTH;
        int wide = 2 * column + 3 * PAD;
        int high = 9 * ROW + 2 * PAD + 34;
        double fit = Math.min(1, Math.min((double) width / (wide + 20), (double) height / (high + 20)));
        Graphics2D scaled = (Graphics2D) g.create();
        scaled.translate((width - wide * fit) / 2, (height - high * fit) / 2);
        scaled.scale(fit, fit);
        Hud.panel(scaled, 0, 0, wide, high);
        scaled.setColor(Theme.TEXT);
        scaled.setFont(Theme.bold(17));
        scaled.drawString("Playground", PAD, PAD + 14);
        int left = PAD;
        int y = PAD + 50;
        for (String[] line : LINES) {
            if (line.length == 0) {
                left = 2 * PAD + column;
                y = PAD + 50;
                continue;
            }
            paintKey(scaled, line[0], left, y);
            scaled.setFont(Theme.font(14));
            scaled.setColor(Theme.TEXT);
            scaled.drawString(line[1], left + KEY_WIDTH, y);
            y += ROW;
        }
        scaled.dispose();
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
