package io.github.circles2d.playground;

import java.awt.event.ActionEvent;
import java.util.function.Consumer;
import javax.swing.AbstractAction;
import javax.swing.JComponent;
import javax.swing.KeyStroke;
import javax.swing.Timer;

/**
 * A key that does something for as long as it is held. X11 repeats a held key as releases and presses, so a release counts only if no
 * press follows at once.
 */
final class HeldKey {
    private static final int REPEAT_MILLIS = 50;

    private final Consumer<Boolean> listener;
    private final Timer release;
    private boolean down;

    private HeldKey(Consumer<Boolean> listener) {
        this.listener = listener;
        release = new Timer(REPEAT_MILLIS, event -> let());
        release.setRepeats(false);
    }

    /** Tells a listener, on the event thread, when the key goes down and up. */
    static HeldKey bind(JComponent component, String key, Consumer<Boolean> listener) {
        HeldKey held = new HeldKey(listener);
        held.put(component, key, held::press);
        held.put(component, "released " + key, held.release::restart);
        return held;
    }

    private void put(JComponent component, String key, Runnable action) {
        component.getInputMap(JComponent.WHEN_IN_FOCUSED_WINDOW).put(KeyStroke.getKeyStroke(key), key);
        component.getActionMap().put(key, new AbstractAction(key) {
            private static final long serialVersionUID = 1;

            @Override
            public void actionPerformed(ActionEvent event) {
                action.run();
            }
        });
    }

    private void press() {
        release.stop();
        if (!down) {
            down = true;
            listener.accept(true);
        }
    }

    /** The key is up, or nobody will tell: the window has lost the keyboard. */
    void let() {
        release.stop();
        if (down) {
            down = false;
            listener.accept(false);
        }
    }
}
