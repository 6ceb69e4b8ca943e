package io.github.circles2d.world.queries;

import io.github.circles2d.world.model.Bounds;
import io.github.circles2d.world.model.CircleRow;

/**
 * The circles of a world of which an axis wraps, and their images: each circle is also a period farther to either side, where that is
 * no more than half a period beyond the bounds. So whatever is nearest to a place inside the bounds, the short way round, is there.
 */
public final class Images {
    private float[] circles = new float[0];
    private int[] ids = new int[0];
    private int count;

    /** Takes rows of circles and their ids, and makes their images. */
    public void make(float[] rows, int[] ofRows, int n, Bounds bounds) {
        boolean x = bounds.periodX() < Float.POSITIVE_INFINITY;
        boolean y = bounds.periodY() < Float.POSITIVE_INFINITY;
        int most = Math.multiplyExact(n, (x ? 2 : 1) * (y ? 2 : 1));
        if (ids.length < most) {
            int c = Capacity.atLeast(most, ids.length);
            circles = new float[Math.multiplyExact(CircleRow.STRIDE, c)];
            ids = new int[c];
        }
        System.arraycopy(rows, 0, circles, 0, CircleRow.STRIDE * n);
        System.arraycopy(ofRows, 0, ids, 0, n);
        count = n;
        if (x) {
            add(CircleRow.X, bounds.periodX(), 0.5f * bounds.minX() + 0.5f * bounds.maxX());
        }
        if (y) {
            add(CircleRow.Y, bounds.periodY(), 0.5f * bounds.minY() + 0.5f * bounds.maxY());
        }
    }

    /** Adds an image of each that there is: to the right of those in the lower half, to the left of those in the upper. */
    private void add(int coordinate, float period, float middle) {
        int before = count;
        for (int k = 0; k < before; k++) {
            int from = CircleRow.of(k);
            int to = CircleRow.of(count);
            System.arraycopy(circles, from, circles, to, CircleRow.STRIDE);
            circles[to + coordinate] += circles[from + coordinate] < middle ? period : -period;
            ids[count++] = ids[k];
        }
    }

    /** Rows of all. */
    public float[] circles() {
        return circles;
    }

    /** The id of each. */
    public int[] ids() {
        return ids;
    }

    /** Their number. */
    public int count() {
        return count;
    }
}
