package io.github.circles2d.playground;

import java.awt.Dimension;
import java.awt.FontMetrics;
import java.awt.Graphics;
import java.awt.Graphics2D;
import javax.swing.JToggleButton;

/** A button without a border, that shows whether it is on. */
final class FlatButton extends JToggleButton {
    private static final long serialVersionUID = 1;
    private static final int HEIGHT = 30;

    FlatButton(String text, String tip, Runnable action) {
        super(text);
        setToolTipText(tip);
        setFocusable(false);
        setBorderPainted(false);
        setContentAreaFilled(false);
        setOpaque(false);
        setFont(Theme.font(13));
        addActionListener(event -> action.run());
    }

    @Override
    public Dimension getPreferredSize() {
        return new Dimension(getFontMetrics(getFont()).stringWidth(getText()) + 14, HEIGHT);
    }

    @Override
    protected void paintComponent(Graphics graphics) {
        Graphics2D g = (Graphics2D) graphics.create();
        Hud.smooth(g);
        boolean over = getModel().isRollover() || getModel().isArmed();
        g.setColor(isSelected() ? Theme.ACCENT : over ? Theme.HOVER : Theme.BUTTON);
        g.fillRoundRect(0, 0, getWidth(), getHeight(), 9, 9);
        g.setColor(isSelected() ? Theme.BAR : Theme.TEXT);
        g.setFont(getFont());
        FontMetrics metrics = g.getFontMetrics();
        int x = (getWidth() - metrics.stringWidth(getText())) / 2;
        int y = (getHeight() - metrics.getHeight()) / 2 + metrics.getAscent();
        g.drawString(getText(), x, y);
        g.dispose();
    }
}
