package io.github.circles2d.world.joints;

import io.github.circles2d.world.model.JointSpring;
import io.github.circles2d.world.model.JointStep;
import java.util.Arrays;

/** The springs of joints, each once. Row 0 is of no spring. A row goes with the last joint that uses it. */
final class SpringTable {
    /** Null as long as there has been no spring. */
    private SpringRows rows;

    /** Whether rows have come since the step was told of them. */
    private boolean changed;

    /** The length of a sub-step that the rows are of. */
    private float filledFor = Float.NaN;

    /** Makes room for more springs. If there is none, nothing has changed. */
    void ensure(int more) {
        if (rows == null) {
            rows = new SpringRows(1 + more);
        } else if (rows.end() + more > rows.room()) {
            rows = new SpringRows(rows, Math.max(rows.end() + more, 2 * rows.room()));
        }
    }

    /** The row of a spring, which one more joint uses; there is room. */
    int take(float frequency, float dampingRatio) {
        int row = rows.find(frequency, dampingRatio);
        if (row == SpringRows.NONE) {
            row = rows.add(frequency, dampingRatio);
            changed = true;
        }
        rows.use(row);
        return row;
    }

    /** One joint less uses a row. */
    void release(int row) {
        rows.release(row);
    }

    float frequency(int row) {
        return row == 0 ? 0f : rows.frequency[row];
    }

    float dampingRatio(int row) {
        return row == 0 ? 0f : rows.dampingRatio[row];
    }

    /** Strikes all off. */
    void clear() {
        if (rows != null) {
            rows.clear();
            changed = true;
        }
    }

    /** Makes room in a step for the rows. */
    void makeRoom(JointStep step) {
        if (rows != null && step.springs.length < JointSpring.of(rows.end())) {
            step.springs = Arrays.copyOf(step.springs, JointSpring.of(rows.end() + (rows.end() >> 1)));
        }
    }

    /** Fills the rows for sub-steps of a length; there is room. */
    void fill(JointStep step, float h) {
        if (changed || h != filledFor) {
            int end = rows == null ? 1 : rows.end();
            for (int row = 1; row < end; row++) {
                JointSpring.fill(step.springs, row, rows.frequency[row], rows.dampingRatio[row], h);
            }
            step.springCount = end;
            step.springsVersion++;
            filledFor = h;
            changed = false;
        }
    }

    long bytes() {
        return rows == null ? 0 : rows.bytes();
    }
}
