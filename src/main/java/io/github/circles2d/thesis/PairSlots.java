package io.github.circles2d.thesis;

/**
 * The arithmetic of pair slots: every unordered pair of n circles has one, row by row; row i holds (i, i+1), (i, i+2), ..
 * (i, n-1).
 */
public final class PairSlots {
    /** The largest n whose slots an int can number: 65,536 * 65,535 / 2 is less than 2^31. */
    public static final int MAX_CIRCLES = 65_536;

    private PairSlots() {}

    /** The number of slots of n circles: n(n-1)/2. */
    public static long count(int circles) {
        return (long) circles * (circles - 1) / 2;
    }

    /** The first slot of row i, from 0 to n: i(n-1) - i(i-1)/2, which is the number of slots in the rows before it. */
    public static long firstOfRow(int row, int circles) {
        return (long) row * (circles - 1) - (long) row * (row - 1) / 2;
    }
}
