package io.github.circles2d.playground;

import java.awt.Component;
import java.awt.Graphics;
import java.awt.Graphics2D;
import javax.swing.AbstractButton;
import javax.swing.Icon;

/** The mark of a menu item that is one of several: a dot if it is the one. */
final class Dot implements Icon {
    private static final int SIZE = 12;

    @Override
    public void paintIcon(Component component, Graphics graphics, int x, int y) {
        if (component instanceof AbstractButton button && button.isSelected()) {
            Graphics2D g = (Graphics2D) graphics.create();
            Hud.smooth(g);
            g.setColor(Theme.ACCENT);
            g.fillOval(x + 2, y + 2, SIZE - 4, SIZE - 4);
            g.dispose();
        }
    }

    @Override
    public int getIconWidth() {
        return SIZE;
    }

    @Override
    public int getIconHeight() {
        return SIZE;
    }
}
