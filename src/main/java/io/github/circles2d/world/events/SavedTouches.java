package io.github.circles2d.world.events;

import java.util.Arrays;

/**
 * What events of a saved state go on from, if a world reports them: the pairs that touch, and what the next step reports of this
 * one. Arrays are reused, and may be longer than their contents.
 */
public final class SavedTouches {
    /** Type of a late event: a hit. */
    public static final int HIT = 2;

    /** Type of a late event: the end of a touch. */
    public static final int END = 4;

    /** Floats of an event: approach speed, impulse, normal x, y, point x, y, {@link #SLIP}. */
    public static final int VALUES = 7;

    /** Of these, the speed along the surfaces. */
    public static final int SLIP = 6;

    /** Ints of a late event: its type, the number of its wall, -1 or {@link #PIECE}. */
    public static final int LATE_INTS = 2;

    /** In the place of a wall: a piece of terrain, which has the second handle. */
    public static final int PIECE = 4;

    public int pairs;

    /** By pair: the lower id above the higher one, or above the code of a wall or piece; ascending. */
    public long[] pair = new long[0];

    /** Number of hits that are not complete. */
    public int open;

    /** By open hit: which pair, ascending. */
    public int[] openPair = new int[0];

    /** By open hit: its values so far. */
    public float[] openValues = new float[0];

    /** Number of events, of removed circles and pieces, that the next step reports; in their order. */
    public int late;

    /** By late event: both handles. */
    public long[] lateHandles = new long[0];

    /** By late event: see {@link #LATE_INTS}. */
    public int[] lateInts = new int[0];

    public float[] lateValues = new float[0];

    /** Forgets everything. */
    public void clear() {
        pairs = 0;
        open = 0;
        late = 0;
    }

    /** Makes room without changing numbers. */
    public void ensure(int pairCount, int openCount, int lateCount) {
        if (pair.length < pairCount) {
            pair = Arrays.copyOf(pair, grown(pair.length, pairCount));
        }
        if (openPair.length < openCount) {
            int c = grown(openPair.length, openCount);
            openValues = Arrays.copyOf(openValues, VALUES * c);
            openPair = Arrays.copyOf(openPair, c);
        }
        if (lateHandles.length < 2 * lateCount) {
            int c = grown(lateHandles.length / 2, lateCount);
            lateInts = Arrays.copyOf(lateInts, LATE_INTS * c);
            lateValues = Arrays.copyOf(lateValues, VALUES * c);
            lateHandles = Arrays.copyOf(lateHandles, 2 * c);
        }
    }

    private static int grown(int has, int needs) {
        return Math.max(needs, has + (has >> 1));
    }
}
