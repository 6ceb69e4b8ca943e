package io.github.circles2d.world.queries;

import io.github.circles2d.world.model.CircleRow;
import java.util.Arrays;

/**
 * Orders circles along a Hilbert curve, so that neighbours in the order are neighbours in space. The curve has 2^16 steps along each
 * axis of the smallest box around the centres. Circles in the same step keep their order, so a crowd that is narrower than 2^-16 of
 * that box is searched circle by circle.
 */
final class HilbertOrder {
    private static final int AXIS_BITS = 16;
    private static final int LAST_STEP = (1 << AXIS_BITS) - 1;

    // the curve goes on by parts of four bits of each coordinate
    private static final int PART_BITS = 4;
    private static final int PART = (1 << PART_BITS) - 1;
    private static final int PLACE_BITS = 2 * PART_BITS;
    private static final int PLACE = (1 << PLACE_BITS) - 1;

    // state: how the curve lies in a square
    private static final int SWAPPED = 1;
    private static final int FLIPPED = 2;
    private static final int STATES = 4;

    private static final int[] TURNS = turns();

    /** A radix sort of the keys in three passes. */
    private static final int DIGIT_BITS = 11;

    private static final int DIGITS = 1 << DIGIT_BITS;
    private static final int PASSES = 3;

    private int[] key = new int[0];
    private int[] place = new int[0];
    private int[] otherKey = new int[0];
    private int[] otherPlace = new int[0];
    private final int[] next = new int[PASSES * DIGITS];

    /** The places of rows in the order of the curve; the array may be longer, and is valid until the next call. */
    int[] order(float[] circles, int n) {
        makeRoom(n);
        computeKeys(circles, n);
        countDigits(n);
        for (int pass = 0; pass < PASSES; pass++) {
            distribute(pass, n);
        }
        return place;
    }

    /** All arrays are made before one is assigned: a growth that fails changes nothing. */
    private void makeRoom(int n) {
        if (otherPlace.length < n) {
            int c = Capacity.atLeast(n, otherPlace.length);
            int[] newKey = new int[c];
            int[] newPlace = new int[c];
            int[] newOtherKey = new int[c];
            int[] newOtherPlace = new int[c];
            key = newKey;
            place = newPlace;
            otherKey = newOtherKey;
            otherPlace = newOtherPlace;
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
            key[k] = place(column, line);
            place[k] = k;
        }
    }

    private static int step(float distance, float scale) {
        return Math.min((int) (distance * scale), LAST_STEP);
    }

    /** Through four bits of each coordinate: by state, column and line, the next state above the eight bits of the place on the curve. */
    private static int[] turns() {
        int[] turns = new int[STATES << PLACE_BITS];
        for (int k = 0; k < turns.length; k++) {
            int state = k >> PLACE_BITS;
            int place = 0;
            for (int bit = PART_BITS - 1; bit >= 0; bit--) {
                int flip = (state & FLIPPED) == 0 ? 0 : 1;
                int a = (k >> PART_BITS + bit & 1) ^ flip;
                int b = (k >> bit & 1) ^ flip;
                int right = (state & SWAPPED) == 0 ? a : b;
                int upper = (state & SWAPPED) == 0 ? b : a;
                place = place << 2 | (3 * right ^ upper); // lower left, upper left, upper right, lower right
                if (upper == 0) {
                    state ^= right == 0 ? SWAPPED : SWAPPED | FLIPPED;
                }
            }
            turns[k] = state << PLACE_BITS | place;
        }
        return turns;
    }

    /** The place on the curve of a step along each axis. */
    private static int place(int column, int line) {
        int place = 0;
        int state = 0;
        for (int shift = AXIS_BITS - PART_BITS; shift >= 0; shift -= PART_BITS) {
            int part = (column >> shift & PART) << PART_BITS | line >> shift & PART;
            int turn = TURNS[state | part];
            place = place << PLACE_BITS | turn & PLACE;
            state = turn & ~PLACE;
        }
        return place;
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
