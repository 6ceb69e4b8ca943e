package io.github.circles2d.world.jvm.threads;

import java.util.concurrent.atomic.AtomicLong;

/**
 * The first steps of a virtual machine. Its compiler counts how often code runs, and threads that count together hinder each other: on 16 threads
 * they take twice as long as on one, until the code is compiled.
 */
public final class ColdStart {
    private static final long NANOS = 400_000_000;
    private static final int MOST_STEPS = 10;

    private static final AtomicLong LEFT = new AtomicLong(NANOS);

    private ColdStart() {}

    /** How many of so many workers the next step should have. */
    public static int workers(int asked) {
        return LEFT.get() > 0 ? 1 : asked;
    }

    /** Takes note of a step. */
    public static void made(long nanos) {
        if (LEFT.get() > 0) {
            LEFT.addAndGet(-Math.max(nanos, NANOS / MOST_STEPS));
        }
    }
}
