package io.github.circles2d.world.jvm.state;

/** Heap sorts in place: no recursion, no input that makes them slow, and no memory, of which {@code Arrays.sort} takes some since Java 22. */
public final class HeapSort {
    private HeapSort() {}

    /** Sorts items [from, to) by sheet[item], if there are sheets, and by key[item] within a sheet; keys are distinct. */
    public static void byKey(int[] items, int[] sheet, int[] key, int from, int to) {
        int n = to - from;
        for (int k = n / 2 - 1; k >= 0; k--) {
            sink(items, sheet, key, from, k, n);
        }
        for (int end = n - 1; end > 0; end--) {
            int top = items[from];
            items[from] = items[from + end];
            items[from + end] = top;
            sink(items, sheet, key, from, 0, end);
        }
    }

    /** Whether an item comes before another in the order of {@link #byKey}. */
    public static boolean isBefore(int item, int other, int[] sheet, int[] key) {
        return sheet == null || sheet[item] == sheet[other] ? key[item] < key[other] : sheet[item] < sheet[other];
    }

    private static void sink(int[] items, int[] sheet, int[] key, int from, int root, int n) {
        int item = items[from + root];
        int k = root;
        while (2 * k + 1 < n) {
            int child = 2 * k + 1;
            if (child + 1 < n && isBefore(items[from + child], items[from + child + 1], sheet, key)) {
                child++;
            }
            if (!isBefore(item, items[from + child], sheet, key)) {
                break;
            }
            items[from + k] = items[from + child];
            k = child;
        }
        items[from + k] = item;
    }

    /** Sorts keys [from, to), distinct, and with them their values. */
    public static void longs(long[] keys, long[] values, int from, int to) {
        int n = to - from;
        for (int k = n / 2 - 1; k >= 0; k--) {
            sink(keys, values, from, k, n);
        }
        for (int end = n - 1; end > 0; end--) {
            long key = keys[from];
            keys[from] = keys[from + end];
            keys[from + end] = key;
            long value = values[from];
            values[from] = values[from + end];
            values[from + end] = value;
            sink(keys, values, from, 0, end);
        }
    }

    private static void sink(long[] keys, long[] values, int from, int root, int n) {
        long key = keys[from + root];
        long value = values[from + root];
        int k = root;
        while (2 * k + 1 < n) {
            int child = 2 * k + 1;
            if (child + 1 < n && keys[from + child] < keys[from + child + 1]) {
                child++;
            }
            if (keys[from + child] <= key) {
                break;
            }
            keys[from + k] = keys[from + child];
            values[from + k] = values[from + child];
            k = child;
        }
        keys[from + k] = key;
        values[from + k] = value;
    }

    /** Sorts the first keys. */
    public static void ascending(long[] keys, int count) {
        for (int k = count / 2 - 1; k >= 0; k--) {
            sink(keys, k, count);
        }
        for (int end = count - 1; end > 0; end--) {
            long top = keys[0];
            keys[0] = keys[end];
            keys[end] = top;
            sink(keys, 0, end);
        }
    }

    private static void sink(long[] keys, int root, int count) {
        long key = keys[root];
        int k = root;
        while (2 * k + 1 < count) {
            int child = 2 * k + 1;
            if (child + 1 < count && keys[child] < keys[child + 1]) {
                child++;
            }
            if (key >= keys[child]) {
                break;
            }
            keys[k] = keys[child];
            k = child;
        }
        keys[k] = key;
    }
}
