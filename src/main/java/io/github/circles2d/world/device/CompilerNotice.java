package io.github.circles2d.world.device;

import java.lang.System.Logger.Level;
import java.util.Locale;

/**
 * Tells the log of a compiler that a call waits for: while it waits, once that has taken a second, and how long it was. It says nothing of kernels that
 * the driver has kept.
 */
final class CompilerNotice {
    private static final System.Logger LOG = System.getLogger(DevicePipeline.class.getName());

    private static final long LONG_MILLIS = 1000;

    private final String device;
    private final long start = System.nanoTime();
    private boolean ended;
    private boolean told;

    private CompilerNotice(String device) {
        this.device = device;
    }

    /** Compiles for a device. */
    static void during(Runnable compilation, String device) {
        CompilerNotice notice = new CompilerNotice(device);
        Thread thread = new Thread(notice::tellIfLong, "circles2d compiler notice");
        thread.setDaemon(true);
        thread.start();
        try {
            compilation.run();
        } finally {
            notice.end();
        }
    }

    private long millis() {
        return (System.nanoTime() - start) / 1_000_000;
    }

    private synchronized void tellIfLong() {
        try {
            while (!ended && millis() < LONG_MILLIS) {
                wait(Math.max(1, LONG_MILLIS - millis()));
            }
        } catch (InterruptedException e) {
            return; // nobody interrupts it but who wants it to end
        }
        if (!ended) {
            told = true;
            LOG.log(Level.INFO, "World waits until kernels are compiled for " + device + "; most drivers keep them");
        }
    }

    private synchronized void end() {
        ended = true;
        notifyAll();
        if (told) {
            LOG.log(
                    Level.INFO,
                    String.format(
                            Locale.ROOT, "World has waited %.1f s for the compiler of %s", millis() * 1e-3, device));
        }
    }
}
