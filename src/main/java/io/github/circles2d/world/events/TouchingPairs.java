package io.github.circles2d.world.events;

import java.util.Arrays;

/**
 * The pairs that touch, in no order, with a chain for each lower id. While pairs stay in touch nothing is written but a stamp each.
 * Several threads may find and stamp at once.
 */
final class TouchingPairs {
    static final int NONE = -1;

    int count;

    /** By id: the first pair of which it is the lower, or NONE. */
    private int[] first = new int[0];

    int[] lower = new int[0];

    /** By pair: the higher id, or the code of a wall. */
    int[] higher = new int[0];

    /** By pair: the handles. */
    long[] a = new long[0];

    long[] b = new long[0];

    /** By pair: the last step that saw it touch. */
    int[] stamp = new int[0];

    /** By pair: the number of its hit that is not complete, or NONE. */
    int[] open = new int[0];

    private int[] next = new int[0];

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
        if (pairs > next.length) {
            int c = Math.max(pairs, Math.max(64, next.length + (next.length >> 1)));
            lower = Arrays.copyOf(lower, c);
            higher = Arrays.copyOf(higher, c);
            a = Arrays.copyOf(a, c);
            b = Arrays.copyOf(b, c);
            stamp = Arrays.copyOf(stamp, c);
            open = Arrays.copyOf(open, c);
            next = Arrays.copyOf(next, c);
        }
    }

    void clear() {
        Arrays.fill(first, NONE);
        count = 0;
    }

    /** The number of a pair, or NONE. */
    int find(int lowerId, int higherId) {
        for (int pair = first[lowerId]; pair != NONE; pair = next[pair]) {
            if (higher[pair] == higherId) {
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
        higher[pair] = higherId;
        a[pair] = handleA;
        b[pair] = handleB;
        open[pair] = NONE;
        next[pair] = first[lowerId];
        first[lowerId] = pair;
        return pair;
    }

    /** Removes a pair; the last one takes its number. */
    void remove(int pair) {
        link(lower[pair], pair, next[pair]);
        int last = --count;
        if (pair != last) {
            link(lower[last], last, pair);
            lower[pair] = lower[last];
            higher[pair] = higher[last];
            a[pair] = a[last];
            b[pair] = b[last];
            stamp[pair] = stamp[last];
            open[pair] = open[last];
            next[pair] = next[last];
        }
    }

    /** Lets what leads to a pair lead to another. */
    private void link(int lowerId, int pair, int to) {
        if (first[lowerId] == pair) {
            first[lowerId] = to;
            return;
        }
        int before = first[lowerId];
        while (next[before] != pair) {
            before = next[before];
        }
        next[before] = to;
    }

    /** Memory of the arrays. */
    long bytes() {
        return 4L * first.length + 36L * next.length;
    }
}
