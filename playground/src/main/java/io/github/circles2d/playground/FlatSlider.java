package io.github.circles2d.playground;

import java.awt.Dimension;
import java.awt.FontMetrics;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.Shape;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.util.function.Consumer;
import javax.swing.JComponent;

/** A number from 0 to a greatest one, as a bar with its name in it: a press or a drag sets it. */
final class FlatSlider extends JComponent {
    private static final long serialVersionUID = 1;
    private static final int HEIGHT = 30;
    private static final int PAD = 11;

    /** Steps of the bar. */
    private static final int STEPS = 50;

    private final String text;
    private float greatest;
    private float value;

    /** Whether the mouse holds it: then no frame moves it. */
    private boolean held;

    FlatSlider(String text, String tip, float greatest, Consumer<Float> setter) {
        this.text = text;
        this.greatest = greatest;
        setToolTipText(tip);
        MouseAdapter mouse = new MouseAdapter() {
            @Override
            public void mousePressed(MouseEvent event) {
                held = true;
                mouseDragged(event);
            }

            @Override
            public void mouseDragged(MouseEvent event) {
                float share = Math.min(Math.max((float) event.getX() / Math.max(getWidth(), 1), 0), 1);
                value = Math.round(share * STEPS) * FlatSlider.this.greatest / STEPS;
                setter.accept(value);
                repaint();
            }

            @Override
            public void mouseReleased(MouseEvent event) {
                held = false;
            }
        };
        addMouseListener(mouse);
        addMouseMotionListener(mouse);
    }

    /** Shows what a frame says. */
    void show(float now) {
        if (!held && now != value) {
            value = now;
            repaint();
        }
    }

    /** The same for a number whose greatest one depends on the scene. */
    void show(float now, float most) {
        if (!held && most != greatest) {
            greatest = most;
            revalidate();
            repaint();
        }
        show(now);
    }

    @Override
    public Dimension getPreferredSize() {
        return new Dimension(metrics().stringWidth(label(greatest)) + 2 * PAD, HEIGHT);
    }

    private FontMetrics metrics() {
        return getFontMetrics(Theme.font(13));
    }

    private String label(float number) {
        String pattern = greatest < 0.1f ? "%s %.4f" : greatest < 10 ? "%s %.2f" : "%s %.1f";
        return Figures.format(pattern, text, number);
    }

    @Override
    protected void paintComponent(Graphics graphics) {
        Graphics2D g = (Graphics2D) graphics.create();
        Hud.smooth(g);
        g.setColor(Theme.BUTTON);
        g.fillRoundRect(0, 0, getWidth(), getHeight(), 9, 9);
        int filled = Math.round(getWidth() * Math.min(value / greatest, 1));
        Shape whole = g.getClip();
        g.clipRect(0, 0, filled, getHeight());
        g.setColor(Theme.TRACK);
        g.fillRoundRect(0, 0, getWidth(), getHeight(), 9, 9);
        g.setClip(whole);
        g.setColor(Theme.TEXT);
        g.setFont(Theme.font(13));
        FontMetrics metrics = g.getFontMetrics();
        g.drawString(label(value), PAD, (getHeight() - metrics.getHeight()) / 2 + metrics.getAscent());
        g.dispose();
    }
}
