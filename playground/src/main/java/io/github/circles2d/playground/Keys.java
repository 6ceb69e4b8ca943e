package io.github.circles2d.playground;

import java.awt.event.ActionEvent;
import java.awt.event.WindowAdapter;
import java.awt.event.WindowEvent;
import javax.swing.AbstractAction;
import javax.swing.JComponent;
import javax.swing.JFrame;
import javax.swing.KeyStroke;

/** Binds the keys that {@link Help} lists. Those of files are the menus'. */
final class Keys {
    /** Rows of the keys that are scrolled at once. */
    private static final int PAGE = 4;

    private final JComponent component;
    private final SessionLoop loop;

    private Keys(JComponent component, SessionLoop loop) {
        this.component = component;
        this.loop = loop;
    }

    static void bind(
            JFrame window, PlaygroundCanvas canvas, SessionLoop loop, BackendSwitch backends, Runnable gallery) {
        Keys keys = new Keys(canvas, loop);
        for (ToolKind kind : ToolKind.values()) {
            keys.on(() -> loop.ask(session -> session.setTool(kind)), kind.key());
        }
        keys.on(() -> loop.ask(Session::togglePause), "SPACE", "P");
        keys.on(() -> loop.ask(Session::stepOnce), "PERIOD", "RIGHT");
        keys.on(() -> loop.ask(Session::stepBack), "COMMA", "LEFT");
        keys.on(() -> loop.ask(Session::slower), "S");
        keys.on(() -> loop.ask(Session::restart), "R");
        keys.on(() -> loop.ask(Session::toggleSleep), "Z");
        keys.on(() -> loop.ask(Session::nextPaint), "C");
        keys.on(() -> loop.ask(Session::toggleContacts), "V");
        keys.on(() -> loop.ask(Session::toggleProfile), "T");
        keys.on(() -> loop.ask(Session::explode), "X");
        keys.on(() -> loop.ask(session -> session.scaleBrush(-1)), "OPEN_BRACKET");
        keys.on(() -> loop.ask(session -> session.scaleBrush(1)), "CLOSE_BRACKET");
        keys.on(backends::next, "N");
        keys.on(gallery, "M");
        keys.on(canvas::goHome, "HOME", "0", "NUMPAD0");
        keys.on(canvas::toggleGraphs, "G");
        keys.on(canvas::toggleHelp, "H", "F1");
        keys.on(canvas::hideHelp, "ESCAPE");
        keys.on(() -> canvas.scrollHelp(-1), "UP");
        keys.on(() -> canvas.scrollHelp(1), "DOWN");
        keys.on(() -> canvas.scrollHelp(-PAGE), "PAGE_UP");
        keys.on(() -> canvas.scrollHelp(PAGE), "PAGE_DOWN");
        HeldKey rewind = HeldKey.bind(canvas, "B", on -> loop.ask(session -> session.setRewinding(on)));
        HeldKey pour = HeldKey.bind(canvas, "F", on -> loop.ask(session -> session.pour(on)));
        window.addWindowFocusListener(new WindowAdapter() {
            @Override
            public void windowLostFocus(WindowEvent event) {
                rewind.let();
                pour.let();
            }
        });
    }

    private void on(Runnable action, String... strokes) {
        for (String stroke : strokes) {
            component.getInputMap(JComponent.WHEN_IN_FOCUSED_WINDOW).put(KeyStroke.getKeyStroke(stroke), stroke);
            component.getActionMap().put(stroke, new AbstractAction(stroke) {
                private static final long serialVersionUID = 1;

                @Override
                public void actionPerformed(ActionEvent event) {
                    action.run();
                }
            });
        }
    }
}
