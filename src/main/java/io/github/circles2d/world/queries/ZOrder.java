package io.github.circles2d.world.queries;

import io.github.circles2d.world.model.CircleRow;
import java.util.Arrays;

/**
 * Orders circles along a Z-curve, so that neighbours in space are mostly neighbours in the order. The curve has 2^16 steps along
 * each axis of the smallest box around the centres. Circles in the same step keep their order.
 */
final class ZOrder {
    private static final int AXIS_BITS = 16;
    private static final int LAST_STEP = (1 << AXIS_BITS) - 1;

    /** A radix sort of the keys in three passes. */
    private static final int DIGIT_BITS = 11;

    private static final int DIGITS = 1 << DIGIT_BITS;
    private static final int PASSES = 3;

    private int[] key = new int[0];
    private int[] place = new int[0];
    private int[] otherKey = new int[0];
    private int[] otherPlace = new int[0];
    private final int[] next = new int[PASSES * DIGITS];

    /**
     * Orders circles.
     *
     * @param circles rows of circles, by place
     * @param n their number
     * @return the places in the order of the curve; may be longer; valid until the next call
     */
    int[] order(float[] circles, int n) {
        makeRoom(n);
        computeKeys(circles, n);
        countDigits(n);
        for (int pass = 0; pass < PASSES; pass++) {
            distribute(pass, n);
        }
        return place;
    }

    /** The array that is made last tells whether there is room. */
    private void makeRoom(int n) {
        if (otherPlace.length < n) {
            int c = Capacity.atLeast(n, otherPlace.length);
            key = new int[c];
            place = new int[c];
            otherKey = new int[c];
            otherPlace = new int[c];
        }
    }

    private void computeKeys(float[] circles, int n) {
        float minX = Float.POSITIVE_INFINITY;
        float minY = Float.POSITIVE_INFINITY;
        float maxX = Float.NEGATIVE_INFINITY;
        float maxY = Float.NEGATIVE_INFINITY;
        for (int row = 0; row < CircleRow.STRIDE * n; row += CircleRow.STRIDE) {
            float x = circles[row + CircleRow.X];
            float y = circles[row + CircleRow.Y];
            minX = Math.min(minX, x);
            minY = Math.min(minY, y);
            maxX = Math.max(maxX, x);
            maxY = Math.max(maxY, y);
        }
        float scaleX = LAST_STEP / (maxX - minX); // infinite if there is but one x: all steps are then 0 (NaN)
        float scaleY = LAST_STEP / (maxY - minY);
        for (int k = 0; k < n; k++) {
            int column = step(circles[CircleRow.of(k) + CircleRow.X] - minX, scaleX);
            int line = step(circles[CircleRow.of(k) + CircleRow.Y] - minY, scaleY);
            key[k] = spread(column) | spread(line) << 1;
            place[k] = k;
        }
    }

    private static int step(float distance, float scale) {
        return Math.min((int) (distance * scale), LAST_STEP);
    }

    /** Moves the lower 16 bits apart: bit b becomes bit 2 b. */
    private static int spread(int bits) {
        int b = (bits | bits << 8) & 0x00FF00FF;
        b = (b | b << 4) & 0x0F0F0F0F;
        b = (b | b << 2) & 0x33333333;
        return (b | b << 1) & 0x55555555;
    }

    private static int digit(int key, int pass) {
        return key >>> pass * DIGIT_BITS & DIGITS - 1;
    }

    /** Computes where the first key of each digit goes, for all passes. */
    private void countDigits(int n) {
        Arrays.fill(next, 0);
        for (int k = 0; k < n; k++) {
            next[digit(key[k], 0)]++;
            next[DIGITS + digit(key[k], 1)]++;
            next[2 * DIGITS + digit(key[k], 2)]++;
        }
        for (int pass = 0; pass < PASSES; pass++) {
            int sum = 0;
            for (int d = pass * DIGITS; d < (pass + 1) * DIGITS; d++) {
                int count = next[d];
                next[d] = sum;
                sum += count;
            }
        }
    }

    private void distribute(int pass, int n) {
        int[] fromKey = key;
        int[] fromPlace = place;
        int[] toKey = otherKey;
        int[] toPlace = otherPlace;
        int first = pass * DIGITS;
        for (int k = 0; k < n; k++) {
            int to = next[first + digit(fromKey[k], pass)]++;
            toKey[to] = fromKey[k];
            toPlace[to] = fromPlace[k];
        }
        key = toKey;
        place = toPlace;
        otherKey = fromKey;
        otherPlace = fromPlace;
    }
}
