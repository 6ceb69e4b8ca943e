package io.github.circles2d.world.events;

import java.util.Arrays;

/** Sorts the events of a step by their keys: a radix sort, which takes memory only when it sorts more than before. */
final class EventSort {
    private static final int DIGIT_BITS = 8;
    private static final int DIGITS = 1 << DIGIT_BITS;

    /** Up to this many rows an insertion sort is faster. */
    private static final int FEW = 32;

    private final int[] starts = new int[DIGITS];
    private long[] key = new long[0];
    private long[] keyNext = new long[0];
    private int[] order = new int[0];
    private int[] orderNext = new int[0];

    /** Makes room. All arrays are made before one is assigned: a growth that fails changes nothing. */
    void ensure(int rows) {
        if (rows > orderNext.length) {
            int c = Math.max(rows, orderNext.length + (orderNext.length >> 1));
            long[] newKey = new long[c];
            long[] newKeyNext = new long[c];
            int[] newOrder = new int[c];
            int[] newOrderNext = new int[c];
            key = newKey;
            keyNext = newKeyNext;
            order = newOrder;
            orderNext = newOrderNext;
        }
    }

    /** Sorts rows, for which there is room, by distinct keys. */
    void sort(EventRows rows) {
        int count = rows.count;
        long varying = 0;
        for (int row = 0; row < count; row++) {
            key[row] = rows.key(row);
            order[row] = row;
            varying |= key[row] ^ key[0];
        }
        if (count <= FEW) {
            insert(count);
            return;
        }
        for (int shift = 0; shift < Long.SIZE; shift += DIGIT_BITS) {
            if ((varying >>> shift & DIGITS - 1) != 0) {
                pass(count, shift);
            }
        }
    }

    private void insert(int count) {
        for (int k = 1; k < count; k++) {
            long own = key[k];
            int row = order[k];
            int place = k;
            for (; place > 0 && key[place - 1] > own; place--) {
                key[place] = key[place - 1];
                order[place] = order[place - 1];
            }
            key[place] = own;
            order[place] = row;
        }
    }

    private void pass(int count, int shift) {
        Arrays.fill(starts, 0);
        for (int k = 0; k < count; k++) {
            starts[(int) (key[k] >>> shift) & DIGITS - 1]++;
        }
        int sum = 0;
        for (int digit = 0; digit < DIGITS; digit++) {
            int many = starts[digit];
            starts[digit] = sum;
            sum += many;
        }
        for (int k = 0; k < count; k++) {
            int place = starts[(int) (key[k] >>> shift) & DIGITS - 1]++;
            keyNext[place] = key[k];
            orderNext[place] = order[k];
        }
        long[] keys = key;
        key = keyNext;
        keyNext = keys;
        int[] orders = order;
        order = orderNext;
        orderNext = orders;
    }

    int row(int place) {
        return order[place];
    }

    long bytes() {
        return 24L * orderNext.length + 4L * DIGITS;
    }
}
