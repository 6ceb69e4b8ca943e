package io.github.circles2d.playground;

import java.util.concurrent.atomic.AtomicReference;

/**
 * Hands frames from the thread that fills them to the thread that shows them. There are three, so neither waits: one is being filled,
 * one is the newest, one is being shown.
 */
final class FrameExchange {
    private final AtomicReference<Frame> newest = new AtomicReference<>(new Frame());
    private Frame filled = new Frame();
    private Frame shown = new Frame();
    private long number;

    /** The frame to fill; for the one thread that fills. */
    Frame toFill() {
        return filled;
    }

    /** Makes what was filled the newest frame. */
    void publish() {
        filled.number = ++number;
        filled = newest.getAndSet(filled);
    }

    /** The newest frame, to be shown until the next call; for the one thread that shows. */
    Frame latest() {
        if (newest.get().number > shown.number) {
            shown = newest.getAndSet(shown);
        }
        return shown;
    }
}
