package io.github.circles2d.scenes;

import java.util.Arrays;
import java.util.Random;

/** Random positions without overlaps: each circle in turn is drawn again until it touches no earlier one. */
final class Scatter {
    /** Far more draws than a fill of 0.3 ever needs (some tens); random placement jams at a fill of 0.547. */
    private static final int MAX_DRAWS = 1_000_000;

    private Scatter() {}

    /**
     * Fills x and y with centres in the unit square such that no two circles overlap and none crosses a wall. O(n) on a
     * grid whose cells are as wide as the greatest diameter.
     */
    static void withoutOverlaps(float[] x, float[] y, float[] radius, Random random) {
        int n = x.length;
        float greatest = 0;
        for (float r : radius) {
            greatest = Math.max(greatest, r);
        }
        if (2 * greatest >= 1) {
            throw new IllegalArgumentException("a circle of radius " + greatest + " does not fit in the unit arena");
        }
        int side = (int) Math.max(1, Math.min(1 / (2 * greatest), 4 * Math.sqrt(n) + 1));
        int[] first = new int[side * side];
        int[] next = new int[n];
        Arrays.fill(first, -1);
        for (int i = 0; i < n; i++) {
            float r = radius[i];
            int draws = 0;
            do {
                if (++draws > MAX_DRAWS) {
                    throw new IllegalArgumentException("no room for circle " + i + " of " + n + " without an overlap");
                }
                x[i] = r + random.nextFloat() * (1 - 2 * r);
                y[i] = r + random.nextFloat() * (1 - 2 * r);
            } while (touches(i, x, y, radius, side, first, next));
            int cell = cell(x[i], side) + side * cell(y[i], side);
            next[i] = first[cell];
            first[cell] = i;
        }
    }

    private static boolean touches(int i, float[] x, float[] y, float[] radius, int side, int[] first, int[] next) {
        int cx = cell(x[i], side);
        int cy = cell(y[i], side);
        for (int v = Math.max(cy - 1, 0); v <= Math.min(cy + 1, side - 1); v++) {
            for (int u = Math.max(cx - 1, 0); u <= Math.min(cx + 1, side - 1); u++) {
                for (int j = first[u + side * v]; j >= 0; j = next[j]) {
                    double dx = (double) x[j] - x[i];
                    double dy = (double) y[j] - y[i];
                    double reach = (double) radius[i] + radius[j];
                    if (dx * dx + dy * dy <= reach * reach) {
                        return true;
                    }
                }
            }
        }
        return false;
    }

    private static int cell(float p, int side) {
        return Math.min((int) (p * side), side - 1);
    }
}
