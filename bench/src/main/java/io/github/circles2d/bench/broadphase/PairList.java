package io.github.circles2d.bench.broadphase;

import java.util.Arrays;

/** Pairs of circles, in the order in which they were found. */
final class PairList {
    /** Bytes that a pair takes. */
    static final int BYTES = 8;

    private int[] members = new int[1024];
    private int length;

    void add(int a, int b) {
        if (length == members.length) {
            members = Arrays.copyOf(members, 2 * length);
        }
        members[length] = a;
        members[length + 1] = b;
        length += 2;
    }

    void clear() {
        length = 0;
    }

    int size() {
        return length / 2;
    }

    int first(int pair) {
        return members[2 * pair];
    }

    int second(int pair) {
        return members[2 * pair + 1];
    }

    /** Puts a pair in the place of another, at or behind which it is. */
    void move(int from, int to) {
        members[2 * to] = members[2 * from];
        members[2 * to + 1] = members[2 * from + 1];
    }

    /** Keeps the first pairs only. */
    void truncate(int size) {
        length = 2 * size;
    }

    /** A number that depends on the set of pairs, but not on their order or on which circle comes first. */
    long checksum() {
        long sum = 0;
        for (int k = 0; k < length; k += 2) {
            long low = Math.min(members[k], members[k + 1]);
            long high = Math.max(members[k], members[k + 1]);
            sum += mix(low << 32 | high);
        }
        return sum;
    }

    /** The finalizer of SplitMix64. */
    private static long mix(long z) {
        long a = (z ^ z >>> 30) * 0xBF58476D1CE4E5B9L;
        long b = (a ^ a >>> 27) * 0x94D049BB133111EBL;
        return b ^ b >>> 31;
    }
}
