package io.github.circles2d.world.joints;

import io.github.circles2d.world.model.JointSpring;
import io.github.circles2d.world.model.JointStep;
import java.util.Arrays;

/** The springs of joints, each once, found by a hash. Row 0 is of no spring. A row goes with the last joint that uses it. */
final class SpringTable {
    private static final int NONE = -1;

    private float[] frequency = new float[0];
    private float[] dampingRatio = new float[0];

    /** How many joints use a row. */
    private int[] uses = new int[0];

    /** The next row with the same hash, or of a free row the next free one. */
    private int[] next = new int[0];

    /** By hash: the first row. */
    private int[] first = new int[0];

    private int firstFree = NONE;

    /** One more than the greatest row in use so far. */
    private int end = 1;

    /** Whether rows have come since the step was told of them. */
    private boolean changed;

    /** The length of a sub-step that the rows are of. */
    private float filledFor = Float.NaN;

    /** Makes room for more springs. All arrays are made before one is assigned: a growth that fails changes nothing. */
    void ensure(int more) {
        if (end + more > uses.length) {
            int room = Math.max(end + more, 2 * uses.length);
            float[] newFrequency = Arrays.copyOf(frequency, room);
            float[] newDampingRatio = Arrays.copyOf(dampingRatio, room);
            int[] newUses = Arrays.copyOf(uses, room);
            int[] newNext = new int[room];
            int[] newFirst = new int[Math.max(16, Integer.highestOneBit(room) << 1)];
            frequency = newFrequency;
            dampingRatio = newDampingRatio;
            uses = newUses;
            next = newNext;
            first = newFirst;
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
        int row = first[hash(f, ratio)];
        while (row != NONE && (frequency[row] != f || dampingRatio[row] != ratio)) {
            row = next[row];
        }
        if (row == NONE) {
            row = add(f, ratio);
        }
        uses[row]++;
        return row;
    }

    private int add(float f, float ratio) {
        int row = firstFree;
        if (row == NONE) {
            row = end++;
        } else {
            firstFree = next[row];
        }
        frequency[row] = f;
        dampingRatio[row] = ratio;
        link(row);
        changed = true;
        return row;
    }

    /** One joint less uses a row. */
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

    /** Hertz; 0 of no spring. */
    float frequency(int row) {
        return row == 0 ? 0f : frequency[row];
    }

    float dampingRatio(int row) {
        return row == 0 ? 0f : dampingRatio[row];
    }

    /** Strikes all off. */
    void clear() {
        changed |= uses.length > 0;
        Arrays.fill(first, NONE);
        Arrays.fill(uses, 0);
        firstFree = NONE;
        end = 1;
    }

    /** Makes room in a step for the rows. */
    void makeRoom(JointStep step) {
        if (uses.length > 0 && step.springs.length < JointSpring.of(end)) {
            step.springs = Arrays.copyOf(step.springs, JointSpring.of(end + (end >> 1)));
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
