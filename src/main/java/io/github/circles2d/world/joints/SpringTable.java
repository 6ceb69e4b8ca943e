package io.github.circles2d.world.joints;

import io.github.circles2d.world.model.JointSpring;
import io.github.circles2d.world.model.JointStep;
import java.util.Arrays;

/** The springs of joints, each once: by frequency and damping ratio. Row 0 is of no spring. A row goes with the last joint that uses it. */
final class SpringTable {
    private static final int NONE = -1;

    private float[] frequency = new float[0];
    private float[] dampingRatio = new float[0];

    /** By row: how many joints use it. */
    private int[] uses = new int[0];

    /** By row: the next one with the same hash, or of a free row the next free one. */
    private int[] next = new int[0];

    /** By hash: the first row. */
    private int[] first = new int[0];

    private int firstFree = NONE;
    private int end = 1;

    /** Whether rows have come since the step was told of them. */
    private boolean changed;

    /** The length of a sub-step that the rows are of. */
    private float filledFor = Float.NaN;

    /** Makes room for more springs. If there is none, nothing has changed. */
    void ensure(int more) {
        int rows = end + more;
        if (rows > uses.length) {
            int c = Math.max(rows, 2 * uses.length);
            int hashes = Math.max(16, Integer.highestOneBit(c) << 1);
            int[] heads = new int[hashes];
            int[] links = new int[c];
            float[] frequencies = Arrays.copyOf(frequency, c);
            float[] ratios = Arrays.copyOf(dampingRatio, c);
            uses = Arrays.copyOf(uses, c);
            frequency = frequencies;
            dampingRatio = ratios;
            next = links;
            first = heads;
            linkAll();
        }
    }

    private void linkAll() {
        Arrays.fill(first, NONE);
        firstFree = NONE;
        for (int row = 1; row < end; row++) {
            if (uses[row] > 0) {
                link(row);
            } else {
                free(row);
            }
        }
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

    /** The row of a spring, which one more joint uses; there is room. */
    int take(float f, float ratio) {
        for (int row = first[hash(f, ratio)]; row != NONE; row = next[row]) {
            if (frequency[row] == f && dampingRatio[row] == ratio) {
                uses[row]++;
                return row;
            }
        }
        int row = firstFree;
        if (row == NONE) {
            row = end++;
        } else {
            firstFree = next[row];
        }
        frequency[row] = f;
        dampingRatio[row] = ratio;
        uses[row] = 1;
        link(row);
        changed = true;
        return row;
    }

    /** One joint less uses a row. */
    void release(int row) {
        if (--uses[row] == 0) {
            int hash = hash(frequency[row], dampingRatio[row]);
            if (first[hash] == row) {
                first[hash] = next[row];
            } else {
                int before = first[hash];
                while (next[before] != row) {
                    before = next[before];
                }
                next[before] = next[row];
            }
            free(row);
        }
    }

    float frequency(int row) {
        return row == 0 ? 0f : frequency[row];
    }

    float dampingRatio(int row) {
        return row == 0 ? 0f : dampingRatio[row];
    }

    /** Strikes all off. */
    void clear() {
        Arrays.fill(first, NONE);
        firstFree = NONE;
        end = 1;
    }

    /** Makes room in a step for the rows. */
    void makeRoom(JointStep step) {
        int needed = JointSpring.of(end);
        if (step.springs.length < needed) {
            step.springs = Arrays.copyOf(step.springs, JointSpring.of(uses.length));
        }
    }

    /** Fills the rows for sub-steps of a length; there is room. */
    void fill(JointStep step, float h) {
        if (changed || h != filledFor) {
            for (int row = 1; row < end; row++) {
                JointSpring.fill(step.springs, row, frequency[row], dampingRatio[row], h);
            }
            step.springCount = end;
            step.springsVersion++;
            filledFor = h;
            changed = false;
        }
    }

    long bytes() {
        return 4L * (4L * uses.length + first.length);
    }
}
