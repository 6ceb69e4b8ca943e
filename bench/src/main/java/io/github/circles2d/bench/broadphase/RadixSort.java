package io.github.circles2d.bench.broadphase;

import java.util.Arrays;

/**
 * Sorts numbers by keys of 31 bits: three passes of eleven bits, the lowest first. Bytes: 4 per element to count, and 16 per
 * element and pass.
 */
final class RadixSort {
    /** Bits of a key. */
    static final int BITS = 31;

    /** Bytes read and written for each element. */
    static final int BYTES = 4 + 3 * 16;

    private static final int DIGIT = 11;
    private static final int VALUES = 1 << DIGIT;

    private final int[] starts = new int[3 * VALUES];
    private int[] spareKeys = new int[0];
    private int[] spareNumbers = new int[0];

    /** Keys, in order after {@link #sort}; longer than the number of elements. */
    int[] keys = new int[0];

    /** The numbers that go with the keys. */
    int[] numbers = new int[0];

    /** Makes room for some elements; what is there stays. */
    void ensure(int size) {
        if (keys.length < size) {
            int room = size + (size >> 2);
            keys = Arrays.copyOf(keys, room);
            numbers = Arrays.copyOf(numbers, room);
            spareKeys = new int[room];
            spareNumbers = new int[room];
        }
    }

    /** Sorts the first elements. */
    void sort(int size) {
        Arrays.fill(starts, 0);
        for (int k = 0; k < size; k++) {
            int key = keys[k];
            starts[key & VALUES - 1]++;
            starts[VALUES + (key >>> DIGIT & VALUES - 1)]++;
            starts[2 * VALUES + (key >>> 2 * DIGIT)]++;
        }
        for (int pass = 0; pass < 3; pass++) {
            int sum = 0;
            for (int value = pass * VALUES; value < (pass + 1) * VALUES; value++) {
                int count = starts[value];
                starts[value] = sum;
                sum += count;
            }
            scatter(size, pass);
        }
    }

    private void scatter(int size, int pass) {
        int shift = pass * DIGIT;
        int base = pass * VALUES;
        for (int k = 0; k < size; k++) {
            int key = keys[k];
            int to = starts[base + (key >>> shift & VALUES - 1)]++;
            spareKeys[to] = key;
            spareNumbers[to] = numbers[k];
        }
        int[] sortedKeys = spareKeys;
        int[] sortedNumbers = spareNumbers;
        spareKeys = keys;
        spareNumbers = numbers;
        keys = sortedKeys;
        numbers = sortedNumbers;
    }
}
