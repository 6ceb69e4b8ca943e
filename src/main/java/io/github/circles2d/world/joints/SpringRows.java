package io.github.circles2d.world.joints;

import java.util.Arrays;

/** Springs by row, and by frequency and damping ratio, with room for so many. Row 0 is of no spring. */
final class SpringRows {
    static final int NONE = -1;

    final float[] frequency;
    final float[] dampingRatio;

    /** How many joints use a row. */
    private final int[] uses;

    /** The next row with the same hash, or of a free row the next free one. */
    private final int[] next;

    /** By hash: the first row. */
    private final int[] first;

    private int firstFree = NONE;

    /** One more than the greatest row in use so far. */
    private int end = 1;

    /** Room for some, at least 1. */
    SpringRows(int room) {
        frequency = new float[room];
        dampingRatio = new float[room];
        uses = new int[room];
        next = new int[room];
        first = new int[Math.max(16, Integer.highestOneBit(room) << 1)];
        Arrays.fill(first, NONE);
    }

    /** The same springs, in the same rows. */
    SpringRows(SpringRows from, int room) {
        this(room);
        end = from.end;
        System.arraycopy(from.frequency, 0, frequency, 0, end);
        System.arraycopy(from.dampingRatio, 0, dampingRatio, 0, end);
        System.arraycopy(from.uses, 0, uses, 0, end);
        for (int row = 1; row < end; row++) {
            if (uses[row] > 0) {
                link(row);
            } else {
                free(row);
            }
        }
    }

    int room() {
        return uses.length;
    }

    int end() {
        return end;
    }

    private void link(int row) {
        int hash = hash(frequency[row], dampingRatio[row]);
        next[row] = first[hash];
        first[hash] = row;
    }

    private void free(int row) {
        next[row] = firstFree;
        firstFree = row;
    }

    private int hash(float f, float ratio) {
        int h = (31 * Float.floatToRawIntBits(f) + Float.floatToRawIntBits(ratio)) * 0x9E3779B9;
        return h >>> Integer.numberOfLeadingZeros(first.length) + 1;
    }

    /** The row of a spring; {@link #NONE} if there is none. */
    int find(float f, float ratio) {
        int row = first[hash(f, ratio)];
        while (row != NONE && (frequency[row] != f || dampingRatio[row] != ratio)) {
            row = next[row];
        }
        return row;
    }

    /** The row of a new spring, which nothing uses yet; there is room. */
    int add(float f, float ratio) {
        int row = firstFree;
        if (row == NONE) {
            row = end++;
        } else {
            firstFree = next[row];
        }
        frequency[row] = f;
        dampingRatio[row] = ratio;
        link(row);
        return row;
    }

    void use(int row) {
        uses[row]++;
    }

    /** A row goes if nothing uses it any more. */
    void release(int row) {
        if (--uses[row] == 0) {
            unlink(row);
            free(row);
        }
    }

    private void unlink(int row) {
        int hash = hash(frequency[row], dampingRatio[row]);
        if (first[hash] == row) {
            first[hash] = next[row];
            return;
        }
        int before = first[hash];
        while (next[before] != row) {
            before = next[before];
        }
        next[before] = next[row];
    }

    /** Strikes all off. */
    void clear() {
        Arrays.fill(first, NONE);
        Arrays.fill(uses, 0);
        firstFree = NONE;
        end = 1;
    }

    long bytes() {
        return 4L * (4L * uses.length + first.length);
    }
}
