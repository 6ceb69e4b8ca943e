package io.github.circles2d.playground;

import java.awt.FontMetrics;
import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.util.Locale;

/** The card of {@link StepProfile}: a line for each stage with its milliseconds a step, its share of all, and this as a bar. */
final class ProfileCard {
    private static final int PAD = 12;
    private static final int HEAD = 28;
    private static final int ROW = 23;
    private static final int BAR = 3;
    private static final float SIZE = 12;

    /** Columns of numbers, from the right. */
    private static final int SHARE_WIDTH = 44;

    private ProfileCard() {}

    /** The height for as many stages as there are. */
    static int height(Frame frame) {
        return HEAD + Math.max(frame.profile.size(), 1) * ROW + PAD / 2;
    }

    static void paint(Graphics2D g, Rectangle at, Frame frame) {
        Hud.panel(g, at.x, at.y, at.width, at.height);
        double sum = 0;
        for (StepProfile.Part part : frame.profile) {
            sum += part.millis();
        }
        int right = at.x + at.width - PAD;
        g.setFont(Theme.bold(SIZE));
        g.setColor(Theme.ACCENT);
        g.drawString("stages, " + frame.backend, at.x + PAD, at.y + 18);
        g.setFont(Theme.font(SIZE));
        if (frame.profile.isEmpty()) {
            g.setColor(Theme.FAINT);
            g.drawString("no step has been measured yet", at.x + PAD, at.y + HEAD + 12);
            return;
        }
        g.setColor(Theme.TEXT);
        drawRight(g, String.format(Locale.ROOT, "%.3f ms a step", sum), right, at.y + 18);
        int y = at.y + HEAD;
        for (StepProfile.Part part : frame.profile) {
            double share = sum > 0 ? Math.min(Math.max(part.millis() / sum, 0), 1) : 0;
            g.setColor(Theme.FAINT);
            g.drawString(part.name(), at.x + PAD, y + 12);
            g.setColor(Theme.TEXT);
            drawRight(g, String.format(Locale.ROOT, "%.3f", part.millis()), right - SHARE_WIDTH, y + 12);
            drawRight(g, String.format(Locale.ROOT, "%.0f %%", 100 * share), right, y + 12);
            g.setColor(Theme.BUTTON);
            g.fillRect(at.x + PAD, y + 16, at.width - 2 * PAD, BAR);
            g.setColor(Theme.ACCENT);
            g.fillRect(at.x + PAD, y + 16, (int) Math.round(share * (at.width - 2 * PAD)), BAR);
            y += ROW;
        }
    }

    private static void drawRight(Graphics2D g, String text, int right, int y) {
        FontMetrics metrics = g.getFontMetrics();
        g.drawString(text, right - metrics.stringWidth(text), y);
    }
}
