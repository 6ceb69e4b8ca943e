package io.github.circles2d.world.joints;

import java.util.Arrays;

/** Joints that have broken, in the order of the steps, and of ids in a step. */
public final class BrokenJoints {
    public int count;

    /** By joint: in which step it broke, above its id. Steps are counted by the pipeline. */
    public long[] joint = new long[0];

    /** Makes room for so many, and keeps none. */
    public void begin(int room) {
        count = 0;
        if (joint.length < room) {
            joint = new long[room + (room >> 1)];
        }
    }

    /** Makes room for so many more. */
    public void ensure(int more) {
        if (joint.length < count + more) {
            joint = Arrays.copyOf(joint, count + more + (more >> 1));
        }
    }

    public void add(int step, int id) {
        joint[count++] = (long) step << 32 | id;
    }

    public void sort() {
        Arrays.sort(joint, 0, count);
    }

    public int id(int k) {
        return (int) joint[k];
    }
}
