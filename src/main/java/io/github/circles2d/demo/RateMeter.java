package io.github.circles2d.demo;

/** Events a second, over the last 64 of them. */
final class RateMeter {
    private final long[] ticks = new long[64];
    private int count;

    void tick(long nanos) {
        ticks[count++ % ticks.length] = nanos;
        if (count == 2 * ticks.length) {
            count = ticks.length; // a full ring stays full, and the counter never overflows
        }
    }

    void reset() {
        count = 0;
    }

    /** The rate; 0 before the second event. */
    double perSecond() {
        int kept = Math.min(count, ticks.length);
        if (kept < 2) {
            return 0;
        }
        long newest = ticks[(count - 1) % ticks.length];
        long oldest = ticks[(count - kept) % ticks.length];
        return newest == oldest ? 0 : (kept - 1) * 1e9 / (newest - oldest);
    }
}
