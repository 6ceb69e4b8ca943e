package io.github.circles2d.world.jvm.bodies;

import io.github.circles2d.world.jvm.state.HeapSort;
import java.util.Arrays;

/** Keys of pairs of a rigid body and something else: a body and an id, and the type where it is not known. */
final class RigidKeys {
    private static final int BODY_SHIFT = 32;

    long[] keys = new long[64];
    int count;

    void add(int body, int other) {
        if (count == keys.length) {
            keys = Arrays.copyOf(keys, 2 * count);
        }
        keys[count++] = (long) body << BODY_SHIFT | other;
    }

    void addAll(RigidKeys from) {
        if (count + from.count > keys.length) {
            keys = Arrays.copyOf(keys, Math.max(2 * count, count + from.count));
        }
        System.arraycopy(from.keys, 0, keys, count, from.count);
        count += from.count;
    }

    /** Sorts all. */
    void sort() {
        HeapSort.ascending(keys, count);
    }

    /** Whether a pair is among them, which have been sorted. */
    boolean has(int body, int other) {
        return count > 0 && Arrays.binarySearch(keys, 0, count, (long) body << BODY_SHIFT | other) >= 0;
    }

    static int body(long key) {
        return (int) (key >>> BODY_SHIFT);
    }

    static int other(long key) {
        return (int) key;
    }

    /** Sorts those from one on, which are few. */
    void sortFrom(int from) {
        for (int k = from + 1; k < count; k++) {
            long key = keys[k];
            int to = k;
            while (to > from && keys[to - 1] > key) {
                keys[to] = keys[to - 1];
                to--;
            }
            keys[to] = key;
        }
    }

    long bytes() {
        return 8L * keys.length;
    }
}
