package io.github.circles2d.fuzz;

import java.util.BitSet;
import java.util.function.Predicate;

/** Leaves lines out of a program that fails, for as long as it fails in the same way. */
final class Shrinker {
    private final long until;
    private final Predicate<BitSet> fails;

    /** Tries for some seconds. */
    Shrinker(int seconds, Predicate<BitSet> fails) {
        until = System.nanoTime() + seconds * 1_000_000_000L;
        this.fails = fails;
    }

    /** Leaves out halves, then quarters, and at last single lines, until none can be left out. */
    BitSet shrink(BitSet lines) {
        BitSet least = (BitSet) lines.clone();
        for (int length = Math.max(1, least.length() / 2); length >= 1; ) {
            boolean shorter = false;
            for (int from = 0; from < least.length() && System.nanoTime() < until; from += length) {
                BitSet fewer = (BitSet) least.clone();
                fewer.clear(from, from + length);
                if (!fewer.equals(least) && fails.test(fewer)) {
                    least = fewer;
                    shorter = true;
                }
            }
            if (System.nanoTime() >= until) {
                return least;
            }
            length = length > 1 ? length / 2 : shorter ? 1 : 0;
        }
        return least;
    }
}
