package io.github.circles2d;

import java.util.concurrent.atomic.AtomicInteger;

/**
 * Ends memory at an allocation: classes that {@link AllocationLimitLoader} has loaded tell this one of each allocation before they make it,
 * and it throws an OutOfMemoryError at those that are beyond the limit. So the same call fails at the same place in each run, on any heap.
 */
public final class AllocationLimit {
    private static final AtomicInteger COUNT = new AtomicInteger();
    private static volatile boolean on;
    private static volatile int first;
    private static volatile int last;

    private AllocationLimit() {}

    /** From now on so many allocations succeed, and all others fail. */
    public static void after(int allocations) {
        limit(allocations, Integer.MAX_VALUE);
    }

    /** From now on so many allocations succeed, the next one fails, and those behind it succeed. */
    public static void onceAfter(int allocations) {
        limit(allocations, allocations);
    }

    private static void limit(int from, int to) {
        COUNT.set(0);
        first = from;
        last = to;
        on = true;
    }

    /** Ends the limit, and returns whether an allocation has failed. */
    public static boolean end() {
        on = false;
        return COUNT.get() > first;
    }

    /** How many allocations there were since the limit was set, those that failed included. */
    public static int count() {
        return COUNT.get();
    }

    /** An allocation is to be made. */
    public static void allocate() {
        if (on) {
            int number = COUNT.getAndIncrement();
            if (number >= first && number <= last) {
                throw new OutOfMemoryError("allocation " + number);
            }
        }
    }
}
