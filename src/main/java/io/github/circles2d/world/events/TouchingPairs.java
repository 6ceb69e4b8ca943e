package io.github.circles2d.world.events;

import java.util.Arrays;

/**
 * The pairs that touch, in no order, found by a hash of both ids. While pairs stay in touch nothing is written but a stamp each.
 * Several threads may find and stamp at once.
 */
final class TouchingPairs {
    static final int NONE = -1;

    /** The stamp of no step. */
    static final int NEVER = 0;

    /** The stamp of a pair that has been told to touch no more. */
    static final int ENDED = -1;

    private static final int STRIDE = 4;
    private static final int LOWER = 0;

    /** The higher id, or the code of a wall or piece. */
    private static final int HIGHER = 1;

    /** The last step that saw the pair touch. */
    private static final int STAMP = 2;

    /** The number of its hit that is not complete, or NONE. */
    private static final int OPEN = 3;

    private static final int LEAST_PAIRS = 64;

    int count;

    /** How many of them are with walls or pieces of terrain. */
    int others;

    /** Counts how often numbers have been given to other pairs than those of new or gone circles, or of ended touches. */
    int numbering;

    /** By hash, of which there are a power of two: the first pair of the chain, or NONE. */
    private int[] first = {NONE};

    /** By hash: the marks of the chain's pairs. They are few bytes, and mostly tell of a pair that is not there. */
    private byte[] marks = new byte[1];

    /** By pair: a row of what is looked at together. */
    private int[] rows = new int[0];

    /** By pair: the next of the chain, or NONE. */
    private int[] next = new int[0];

    /** By pair: the handles. */
    long[] a = new long[0];

    long[] b = new long[0];

    /** Makes room. All arrays are made before one is assigned: a growth that fails changes nothing. */
    void ensure(int pairs) {
        if (pairs > b.length) {
            int c = Math.max(pairs, Math.max(LEAST_PAIRS, b.length + (b.length >> 1)));
            int hashes = c > 1 << 30 ? 1 << 30 : Integer.highestOneBit(2 * c - 1);
            int[] longer = new int[hashes];
            byte[] longerMarks = new byte[hashes];
            int[] newRows = Arrays.copyOf(rows, Math.multiplyExact(STRIDE, c));
            int[] newNext = Arrays.copyOf(next, c);
            long[] newA = Arrays.copyOf(a, c);
            long[] newB = Arrays.copyOf(b, c);
            rows = newRows;
            next = newNext;
            a = newA;
            b = newB;
            first = longer;
            marks = longerMarks;
            Arrays.fill(first, NONE);
            for (int pair = 0; pair < count; pair++) {
                chain(pair);
            }
        }
    }

    void clear() {
        numbering++;
        others = 0;
        if (count > 0) {
            Arrays.fill(first, NONE);
            Arrays.fill(marks, (byte) 0);
            count = 0;
        }
    }

    int lower(int pair) {
        return rows[STRIDE * pair + LOWER];
    }

    int higher(int pair) {
        return rows[STRIDE * pair + HIGHER];
    }

    int stamp(int pair) {
        return rows[STRIDE * pair + STAMP];
    }

    void stamp(int pair, int step) {
        rows[STRIDE * pair + STAMP] = step;
    }

    int open(int pair) {
        return rows[STRIDE * pair + OPEN];
    }

    void setOpen(int pair, int hit) {
        rows[STRIDE * pair + OPEN] = hit;
    }

    void stampAll(int step) {
        for (int pair = 0; pair < count; pair++) {
            stamp(pair, step);
        }
    }

    /** The number of a pair, or NONE. */
    int find(int lowerId, int higherId) {
        int mixed = mix(lowerId, higherId);
        int hash = hash(mixed);
        if ((marks[hash] & mark(mixed)) == 0) {
            return NONE;
        }
        int pair = first[hash];
        while (pair != NONE && !is(pair, lowerId, higherId)) {
            pair = next[pair];
        }
        return pair;
    }

    private boolean is(int pair, int lowerId, int higherId) {
        return rows[STRIDE * pair + HIGHER] == higherId && rows[STRIDE * pair + LOWER] == lowerId;
    }

    /** Ids are dense: a multiplicative hash of each, of which the upper bits count. */
    private static int mix(int lowerId, int higherId) {
        return (lowerId * 0x9E3779B1 ^ higherId) * 0x85EBCA6B;
    }

    private int hash(int mixed) {
        return (mixed ^ mixed >>> 15) & first.length - 1;
    }

    /** One of eight bits. */
    private static int mark(int mixed) {
        return 1 << (mixed >>> 29);
    }

    private int mixOf(int pair) {
        return mix(lower(pair), higher(pair));
    }

    private void chain(int pair) {
        int mixed = mixOf(pair);
        int hash = hash(mixed);
        next[pair] = first[hash];
        first[hash] = pair;
        marks[hash] |= (byte) mark(mixed);
    }

    /** Adds a pair that is not there, and returns its number. */
    int add(int lowerId, int higherId, long handleA, long handleB) {
        ensure(count + 1);
        int pair = count++;
        a[pair] = handleA;
        b[pair] = handleB;
        int row = STRIDE * pair;
        rows[row + LOWER] = lowerId;
        rows[row + HIGHER] = higherId;
        rows[row + STAMP] = NEVER;
        rows[row + OPEN] = NONE;
        others += Partner.isCircle(higherId) ? 0 : 1;
        chain(pair);
        return pair;
    }

    /** Removes a pair; the last one takes its number. */
    void remove(int pair) {
        others -= Partner.isCircle(higher(pair)) ? 0 : 1;
        int hash = hash(mixOf(pair));
        link(pair, next[pair]);
        markAnew(hash);
        int last = --count;
        if (pair != last) {
            link(last, pair);
            next[pair] = next[last];
            a[pair] = a[last];
            b[pair] = b[last];
            System.arraycopy(rows, STRIDE * last, rows, STRIDE * pair, STRIDE);
        }
    }

    /** Another pair of the chain may have the mark of the one that went. */
    private void markAnew(int hash) {
        int all = 0;
        for (int pair = first[hash]; pair != NONE; pair = next[pair]) {
            all |= mark(mixOf(pair));
        }
        marks[hash] = (byte) all;
    }

    /** Lets what leads to a pair lead to another. */
    private void link(int pair, int to) {
        int hash = hash(mixOf(pair));
        if (first[hash] == pair) {
            first[hash] = to;
            return;
        }
        int before = first[hash];
        while (next[before] != pair) {
            before = next[before];
        }
        next[before] = to;
    }

    long bytes() {
        return 5L * first.length + 4L * rows.length + 20L * b.length;
    }
}
