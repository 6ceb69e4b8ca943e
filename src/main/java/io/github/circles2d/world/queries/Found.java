package io.github.circles2d.world.queries;

import java.util.Arrays;

/**
 * What a search has found, each with a distance: all, or the nearest few. Their order is by distance, then by id. Until they are sorted they are
 * a heap with the farthest on top.
 */
final class Found {
    private static final int ID_SHIFT = 32;

    private double[] distance = new double[Capacity.atLeast(0, 0)];

    /** The id, above the place in the tree: the order of these numbers is that of the ids. */
    private long[] item = new long[distance.length];

    private int count;

    void clear() {
        count = 0;
    }

    int count() {
        return count;
    }

    double distance(int k) {
        return distance[k];
    }

    int id(int k) {
        return (int) (item[k] >>> ID_SHIFT);
    }

    int place(int k) {
        return (int) item[k];
    }

    /** Adds a thing if there are fewer than so many, or instead of the last in the order. */
    void offer(double d, int id, int place, int most) {
        if (count < most) {
            ensure(count + 1);
            rise(count++, d, item(id, place));
        } else if (after(distance[0], item[0], d, item(id, place))) {
            sink(0, d, item(id, place), count);
        }
    }

    /** The distance of the last in the order, if there are as many as this; else infinity. */
    double last(int most) {
        return count < most ? Double.POSITIVE_INFINITY : distance[0];
    }

    /** Puts all into their order. */
    void sort() {
        for (int k = count / 2 - 1; k >= 0; k--) {
            sink(k, distance[k], item[k], count);
        }
        for (int end = count - 1; end > 0; end--) {
            double d = distance[end];
            long i = item[end];
            distance[end] = distance[0];
            item[end] = item[0];
            sink(0, d, i, end);
        }
    }

    private static long item(int id, int place) {
        return (long) id << ID_SHIFT | place;
    }

    private static boolean after(double d, long i, double otherD, long otherI) {
        return d > otherD || d == otherD && i > otherI;
    }

    private void rise(int at, double d, long i) {
        int k = at;
        while (k > 0) {
            int parent = (k - 1) / 2;
            if (!after(d, i, distance[parent], item[parent])) {
                break;
            }
            distance[k] = distance[parent];
            item[k] = item[parent];
            k = parent;
        }
        distance[k] = d;
        item[k] = i;
    }

    private void sink(int at, double d, long i, int n) {
        int k = at;
        while (2 * k + 1 < n) {
            int child = 2 * k + 1;
            if (child + 1 < n && after(distance[child + 1], item[child + 1], distance[child], item[child])) {
                child++;
            }
            if (!after(distance[child], item[child], d, i)) {
                break;
            }
            distance[k] = distance[child];
            item[k] = item[child];
            k = child;
        }
        distance[k] = d;
        item[k] = i;
    }

    private void ensure(int n) {
        if (item.length < n) {
            int c = Capacity.atLeast(n, item.length);
            distance = Arrays.copyOf(distance, c);
            item = Arrays.copyOf(item, c);
        }
    }
}
