package io.github.circles2d.demo;

import java.awt.AWTError;
import java.awt.Color;
import java.awt.Dimension;
import java.awt.EventQueue;
import java.awt.GraphicsEnvironment;
import java.awt.HeadlessException;
import java.awt.event.WindowAdapter;
import java.awt.event.WindowEvent;
import javax.swing.JFrame;
import javax.swing.WindowConstants;

/**
 * The window. It closes when a person asks for it or when the loop ends, and nothing of it is left then that would keep
 * the JVM alive.
 */
final class DemoWindow {
    private DemoWindow() {}

    /** Why no window can be shown here, or the empty string. */
    static String problem() {
        try {
            GraphicsEnvironment.getLocalGraphicsEnvironment().getDefaultScreenDevice();
            return "";
        } catch (HeadlessException
                | AWTError
                | LinkageError
                | InternalError e) { // none, unreachable, or a runtime without windows
            String reason = e.getMessage() == null ? "" : e.getMessage().strip();
            return reason.isEmpty()
                    ? "no display"
                    : reason.lines().findFirst().orElseThrow().replaceAll("[\\p{Punct}\\s]+$", "");
        }
    }

    /** Shows the window of a loop that has been started; returns at once. */
    static void show(SimulationLoop loop, int size, boolean overlay) {
        EventQueue.invokeLater(() -> {
            JFrame frame = new JFrame("CirclesTest");
            DemoCanvas canvas = new DemoCanvas(loop, size, overlay, () -> leave(frame, loop));
            frame.setContentPane(canvas);
            frame.setBackground(Color.BLACK);
            frame.setDefaultCloseOperation(WindowConstants.DO_NOTHING_ON_CLOSE);
            frame.addWindowListener(new WindowAdapter() {
                @Override
                public void windowClosing(WindowEvent event) {
                    leave(frame, loop);
                }
            });
            frame.setMinimumSize(new Dimension(160, 180));
            frame.pack();
            frame.setLocationRelativeTo(null);
            frame.setVisible(true);
            loop.onFrame(canvas::repaint); // repaint may be called by any thread: it only asks the event thread for it
            loop.onEnd(() -> EventQueue.invokeLater(frame::dispose));
        });
    }

    /** The window goes at once; the loop ends after the step that it is in. */
    private static void leave(JFrame frame, SimulationLoop loop) {
        frame.dispose();
        loop.stop();
    }
}
