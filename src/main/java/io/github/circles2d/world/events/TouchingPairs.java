package io.github.circles2d.world.events;

import java.util.Arrays;

/**
 * The pairs that touch, in no order, with a chain for each lower id. While pairs stay in touch nothing is written but a stamp each.
 * Several threads may find and stamp at once.
 */
final class TouchingPairs {
    static final int NONE = -1;

    /** The stamp of no step. */
    static final int NEVER = 0;

    /** The stamp of pairs that hold: they touch until they are told of. */
    private static final int HOLDING = -1;

    private static final int STRIDE = 4;

    /** The higher id, or the code of a wall. */
    private static final int HIGHER = 0;

    /** The next pair of the chain, or NONE. */
    private static final int NEXT = 1;

    /** The last step that saw the pair touch. */
    private static final int STAMP = 2;

    /** The number of its hit that is not complete, or NONE. */
    private static final int OPEN = 3;

    int count;

    /** By id: the first pair of which it is the lower, or NONE. */
    private int[] first = new int[0];

    /** By pair: a row of what is looked at together. */
    private int[] rows = new int[0];

    private int[] lower = new int[0];

    /** By pair: the handles. */
    long[] a = new long[0];

    long[] b = new long[0];

    void ensureIds(int ids) {
        if (ids > first.length) {
            int old = first.length;
            int[] longer = Arrays.copyOf(first, Math.max(ids, old + (old >> 1)));
            Arrays.fill(longer, old, longer.length, NONE);
            first = longer;
        }
    }

    /** Makes room. The length of the array that grows last tells whether there is room. */
    void ensure(int pairs) {
        if (pairs > lower.length) {
            int c = Math.max(pairs, Math.max(64, lower.length + (lower.length >> 1)));
            rows = Arrays.copyOf(rows, Math.multiplyExact(STRIDE, c));
            a = Arrays.copyOf(a, c);
            b = Arrays.copyOf(b, c);
            lower = Arrays.copyOf(lower, c);
        }
    }

    void clear() {
        Arrays.fill(first, NONE);
        count = 0;
    }

    int lower(int pair) {
        return lower[pair];
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

    void hold(int pair) {
        stamp(pair, HOLDING);
    }

    boolean holds(int pair) {
        return stamp(pair) == HOLDING;
    }

    int open(int pair) {
        return rows[STRIDE * pair + OPEN];
    }

    void setOpen(int pair, int hit) {
        rows[STRIDE * pair + OPEN] = hit;
    }

    /** The number of a pair, or NONE. */
    int find(int lowerId, int higherId) {
        for (int pair = first[lowerId]; pair != NONE; pair = rows[STRIDE * pair + NEXT]) {
            if (rows[STRIDE * pair + HIGHER] == higherId) {
                return pair;
            }
        }
        return NONE;
    }

    /** Adds a pair that is not there, and returns its number. */
    int add(int lowerId, int higherId, long handleA, long handleB) {
        ensure(count + 1);
        int pair = count++;
        lower[pair] = lowerId;
        a[pair] = handleA;
        b[pair] = handleB;
        int row = STRIDE * pair;
        rows[row + HIGHER] = higherId;
        rows[row + NEXT] = first[lowerId];
        rows[row + STAMP] = NEVER;
        rows[row + OPEN] = NONE;
        first[lowerId] = pair;
        return pair;
    }

    /** Removes a pair; the last one takes its number. */
    void remove(int pair) {
        link(lower[pair], pair, rows[STRIDE * pair + NEXT]);
        int last = --count;
        if (pair != last) {
            link(lower[last], last, pair);
            lower[pair] = lower[last];
            a[pair] = a[last];
            b[pair] = b[last];
            System.arraycopy(rows, STRIDE * last, rows, STRIDE * pair, STRIDE);
        }
    }

    /** Lets what leads to a pair lead to another. */
    private void link(int lowerId, int pair, int to) {
        if (first[lowerId] == pair) {
            first[lowerId] = to;
            return;
        }
        int before = first[lowerId];
        while (rows[STRIDE * before + NEXT] != pair) {
            before = rows[STRIDE * before + NEXT];
        }
        rows[STRIDE * before + NEXT] = to;
    }

    /** Memory of the arrays. */
    long bytes() {
        return 4L * first.length + 4L * rows.length + 20L * lower.length;
    }
}
