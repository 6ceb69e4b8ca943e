package io.github.circles2d.demo;

import java.awt.Dimension;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.Toolkit;
import java.awt.event.ActionEvent;
import java.util.List;
import javax.swing.AbstractAction;
import javax.swing.JComponent;
import javax.swing.KeyStroke;

/** Shows the latest frame of a loop and turns keys into its commands. */
final class DemoCanvas extends JComponent {
    private static final long serialVersionUID = 1;
    static final List<String> KEYS =
            List.of("space pause", "S step", "R restart", "digit or T strategy", "O overlay", "Q quit");

    private final transient SimulationLoop loop;
    private final transient DemoPainter painter = new DemoPainter();
    private final transient boolean textWorks = Overlay.available();
    private boolean overlay;

    /**
     * @param size side of the arena in pixels, to start with
     * @param quit what to do when a person asks to leave
     */
    DemoCanvas(SimulationLoop loop, int size, boolean overlay, Runnable quit) {
        this.loop = loop;
        this.overlay = overlay;
        setOpaque(true);
        setPreferredSize(new Dimension(size + Viewport.MARGIN_X, size + Viewport.MARGIN_Y));
        bind("pause", loop::togglePause, "SPACE", "P");
        bind("step", loop::step, "S", "RIGHT");
        bind("restart", loop::restart, "R");
        bind("next strategy", loop::nextStrategy, "T");
        for (int k = 0; k <= 9; k++) {
            int strategy = k;
            bind("strategy " + k, () -> loop.switchTo(strategy), String.valueOf(k), "NUMPAD" + k);
        }
        bind("overlay", this::toggleOverlay, "O");
        bind("quit", quit, "Q", "ESCAPE");
    }

    private void toggleOverlay() {
        overlay = !overlay;
        repaint();
    }

    private void bind(String name, Runnable action, String... keys) {
        for (String key : keys) {
            getInputMap(WHEN_IN_FOCUSED_WINDOW).put(KeyStroke.getKeyStroke(key), name);
        }
        getActionMap().put(name, new AbstractAction(name) {
            private static final long serialVersionUID = 1;

            @Override
            public void actionPerformed(ActionEvent event) {
                action.run();
            }
        });
    }

    @Override
    protected void paintComponent(Graphics graphics) {
        Graphics2D g = (Graphics2D) graphics.create();
        painter.paint(g, getWidth(), getHeight(), loop.latest(), overlay && textWorks, KEYS);
        g.dispose();
        Toolkit.getDefaultToolkit().sync(); // some window systems gather requests until the next one comes
    }
}
