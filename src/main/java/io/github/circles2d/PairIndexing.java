package io.github.circles2d;

import java.util.List;

/**
 * How a work-item that owns a slot of the collision buffer finds its pair of circles (i, j): the subject of the thesis
 * that {@link Circles2D} reproduces.
 *
 * <p>For n circles there are n(n-1)/2 slots, numbered row by row: row i holds (i, i+1), (i, i+2), .. (i, n-1).
 */
public enum PairIndexing {
    /**
     * Strategy 0: the root of a quadratic, in single precision and without a table. Above 2,049 circles rounding can map
     * slots wrongly: from 2,050 on an NVIDIA H200, somewhere above 2,500 on POCL 3.1 for x86-64. Such slots are skipped, so
     * that their pairs pass through each other. {@link Circles2D#wrongSlots} counts them.
     */
    COMPUTED,

    /** Strategy 1: a table of all pairs, 8 bytes a slot, as much again as the collision buffer. */
    LOOKUP_TABLE,

    /** Strategy 2: a binary search for the slot's row in a table of n rows, 8 bytes a row. */
    ROW_SEARCH,

    /**
     * Strategy 3, not in the thesis but an answer to its first open question: a closed form for single precision that is
     * right for every slot of every n up to {@value Circles2D#MAX_CIRCLES}, without a table.
     */
    EXACT,

    /**
     * The one of {@link #EXACT}, {@link #LOOKUP_TABLE} and {@link #ROW_SEARCH} that is likely to be
     * the fastest on the device for the number of circles, and fits into its memory. If a {@link Calibration} has measured
     * the device, it is the one with the shortest loop. Else it is, by rule, the look-up table on a CPU and EXACT on other
     * devices. It is never {@link #COMPUTED}, which may be wrong and is no faster than EXACT. {@link Circles2D#indexing} says which one
     * was taken; the log says why.
     */
    AUTO;

    private static final List<PairIndexing> STRATEGIES = List.of(COMPUTED, LOOKUP_TABLE, ROW_SEARCH, EXACT);

    /**
     * Returns the thesis's number for this indexing.
     *
     * @return 0 to 3
     * @throws IllegalStateException for {@link #AUTO}, which stands for one of the others
     */
    public int strategy() {
        int strategy = STRATEGIES.indexOf(this);
        if (strategy < 0) {
            throw new IllegalStateException("AUTO has no number: it stands for an indexing that init chooses");
        }
        return strategy;
    }

    /**
     * Returns the indexing with a given number.
     *
     * @param strategy 0 to 3
     * @return the indexing
     * @throws IllegalArgumentException if there is no such strategy
     */
    public static PairIndexing ofStrategy(int strategy) {
        if (strategy < 0 || strategy >= STRATEGIES.size()) {
            throw new IllegalArgumentException("strategy must be 0 (computed), 1 (look-up table), 2 (row search) or 3"
                    + " (exact), not " + strategy);
        }
        return STRATEGIES.get(strategy);
    }
}
