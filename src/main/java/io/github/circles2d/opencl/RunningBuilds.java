package io.github.circles2d.opencl;

import java.util.concurrent.TimeUnit;

/**
 * The compilations under way on any thread. An exit of the JVM waits for them: it unloads the driver, and NVIDIA's then ends the process
 * with a signal if it is in its compiler.
 */
public final class RunningBuilds {
    private static final RunningBuilds ALL = new RunningBuilds();

    /** A compiler that takes longer hangs. */
    private static final long LIMIT_SECONDS = 180;

    static {
        try {
            Runtime.getRuntime().addShutdownHook(new Thread(ALL::awaitAtExit, "circles2d exit"));
        } catch (IllegalStateException e) {
            ALL.exiting = true; // the JVM is on its way out already
        }
    }

    private int running;
    private boolean exiting;

    RunningBuilds() {}

    /**
     * Whoever compiles ahead of need stops then.
     *
     * @return whether the JVM exits
     */
    public static boolean isExiting() {
        return ALL.exits();
    }

    /**
     * Makes a compilation, or opens a device, which an exit waits for.
     *
     * @param build what is to be done
     * @throws IllegalStateException if the JVM exits already: it is not done then
     */
    public static void make(Runnable build) {
        ALL.run(build);
    }

    /** Begins the exit, and returns when nothing is compiled any more. */
    static void awaitAll() {
        ALL.awaitAtExit();
    }

    void run(Runnable build) {
        synchronized (this) {
            if (exiting) {
                throw new IllegalStateException("the JVM exits: nothing is compiled any more");
            }
            running++;
        }
        try {
            build.run();
        } finally {
            synchronized (this) {
                running--;
                notifyAll();
            }
        }
    }

    synchronized boolean exits() {
        return exiting;
    }

    /** Returns when nothing is compiled any more. */
    synchronized void awaitAtExit() {
        exiting = true;
        long end = System.nanoTime() + TimeUnit.SECONDS.toNanos(LIMIT_SECONDS);
        while (running > 0 && end - System.nanoTime() > 0) {
            try {
                TimeUnit.NANOSECONDS.timedWait(this, end - System.nanoTime());
            } catch (InterruptedException e) {
                Thread.currentThread().interrupt();
                return;
            }
        }
    }
}
