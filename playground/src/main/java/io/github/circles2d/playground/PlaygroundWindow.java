package io.github.circles2d.playground;

import java.awt.AWTError;
import java.awt.BorderLayout;
import java.awt.Color;
import java.awt.Dimension;
import java.awt.EventQueue;
import java.awt.GraphicsEnvironment;
import java.awt.HeadlessException;
import java.awt.event.WindowAdapter;
import java.awt.event.WindowEvent;
import java.util.concurrent.atomic.AtomicBoolean;
import javax.swing.JFrame;
import javax.swing.JPanel;
import javax.swing.WindowConstants;

/** The window. When it is closed, the loop ends, and nothing is left that would keep the JVM alive. */
final class PlaygroundWindow {
    private final SessionLoop loop;
    private final JFrame frame = new JFrame("circles2d playground");
    private final PlaygroundCanvas canvas;
    private final Bar bar;
    private final Menus menus;

    /** Whether the event thread has been asked to show a frame and has not yet done so. */
    private final AtomicBoolean due = new AtomicBoolean();

    private PlaygroundWindow(SessionLoop loop, BackendSwitch backends, int width, int height, String page) {
        this.loop = loop;
        Menus.prepare();
        canvas = new PlaygroundCanvas(loop, width, height);
        Runnable gallery = () -> Gallery.show(frame, loop);
        bar = new Bar(loop, gallery, width);
        menus = new Menus(loop, canvas, new FileMenu(frame, canvas, loop, page), backends, gallery, this::leave);
        JPanel content = new JPanel(new BorderLayout());
        content.add(bar, BorderLayout.NORTH);
        content.add(canvas, BorderLayout.CENTER);
        frame.setContentPane(content);
        frame.setJMenuBar(menus.bar());
        frame.setBackground(new Color(Theme.GROUND));
        frame.setDefaultCloseOperation(WindowConstants.DO_NOTHING_ON_CLOSE);
        frame.addWindowListener(new WindowAdapter() {
            @Override
            public void windowClosing(WindowEvent event) {
                leave();
            }
        });
        CanvasMouse.listen(canvas, loop);
        Keys.bind(frame, canvas, loop, backends, gallery);
        frame.setMinimumSize(new Dimension(360, 300));
        frame.pack();
        frame.setLocationRelativeTo(null);
        frame.setVisible(true);
        canvas.requestFocusInWindow();
        loop.onFrame(this::requestShow);
        loop.onEnd(() -> EventQueue.invokeLater(frame::dispose));
    }

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

    /** Shows the window of a loop that has been started; returns at once. Links begin with the address of a page. */
    static void show(SessionLoop loop, int width, int height, String page) {
        // Swing asks the desktop for smooth text, and many have no answer.
        System.setProperty("awt.useSystemAAFontSettings", System.getProperty("awt.useSystemAAFontSettings", "on"));
        BackendSwitch backends = new BackendSwitch(loop);
        EventQueue.invokeLater(() -> new PlaygroundWindow(loop, backends, width, height, page));
    }

    /** Called by the thread of the loop. If the event thread is behind, it skips frames. */
    private void requestShow() {
        if (due.compareAndSet(false, true)) {
            EventQueue.invokeLater(this::showFrame);
        }
    }

    private void showFrame() {
        due.set(false);
        Frame latest = canvas.refresh();
        bar.show(latest);
        menus.show(latest);
        canvas.paintImmediately(0, 0, canvas.getWidth(), canvas.getHeight());
    }

    private void leave() {
        frame.dispose();
        loop.stop();
    }
}
