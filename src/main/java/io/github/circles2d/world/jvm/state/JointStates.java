package io.github.circles2d.world.jvm.state;

import io.github.circles2d.world.joints.BrokenJoints;
import io.github.circles2d.world.joints.SavedJointStates;
import io.github.circles2d.world.model.JointRow;
import io.github.circles2d.world.model.JointState;
import io.github.circles2d.world.model.JointStep;
import java.util.Arrays;

/** What joints keep from step to step, by id. Worlds without joints have none. */
public final class JointStates {
    /** {@link JointState} */
    public float[] rows = new float[0];

    /** The serial of the joint that a row is of; its complement if that joint has broken. */
    public int[] serial = new int[0];

    /** The joints that have broken since the host asked: the step, above the id. */
    private long[] broken = new long[0];

    private int brokenCount;

    /** Steps made since the host asked. */
    private int steps;

    public long bytes() {
        return 4L * (rows.length + serial.length) + 8L * broken.length;
    }

    /** Makes room for joints; what there is stays. */
    public void ensure(int joints) {
        if (joints > serial.length) {
            int room = joints + (joints >> 1) + 16;
            rows = Arrays.copyOf(rows, JointState.of(room));
            broken = Arrays.copyOf(broken, room);
            serial = Arrays.copyOf(serial, room);
        }
    }

    /** Whether there is a joint that has not broken; a new one begins without impulses. */
    public boolean begin(int joint, JointStep joints) {
        int now = joints.traits[JointRow.traits(joint) + JointRow.SERIAL];
        if (serial[joint] == ~now) {
            return false;
        }
        if (serial[joint] != now) {
            Arrays.fill(rows, JointState.of(joint), JointState.of(joint + 1), 0f);
            serial[joint] = now;
        }
        return true;
    }

    public void breakJoint(int joint) {
        serial[joint] = ~serial[joint];
        broken[brokenCount++] = (long) steps << 32 | joint;
    }

    /** Whether a joint has broken, of which the host does not know yet. */
    public boolean hasBroken(int joint, JointStep joints) {
        return serial[joint] == ~joints.traits[JointRow.traits(joint) + JointRow.SERIAL];
    }

    public void endStep() {
        steps++;
    }

    /** Hands out what has broken since the last time. */
    public void takeBroken(BrokenJoints into) {
        into.begin(brokenCount);
        addBroken(into);
    }

    /** The same, to what is there. */
    public void addBroken(BrokenJoints into) {
        into.ensure(brokenCount);
        System.arraycopy(broken, 0, into.joint, into.count, brokenCount);
        into.count += brokenCount;
        into.sort();
        brokenCount = 0;
        steps = 0;
    }

    public void save(SavedJointStates into) {
        into.begin(serial.length);
        System.arraycopy(serial, 0, into.serial, 0, serial.length);
        System.arraycopy(rows, 0, into.rows, 0, rows.length);
    }

    /** Saves one, if there is room. */
    public void save(int joint, SavedJointStates into) {
        if (joint >= into.joints || joint >= serial.length) {
            return;
        }
        into.serial[joint] = serial[joint];
        System.arraycopy(
                rows,
                JointState.of(joint),
                into.rows,
                JointState.of(joint),
                JointState.of(joint + 1) - JointState.of(joint));
    }

    /** Takes over saved states, for which there is room. */
    public void load(SavedJointStates from) {
        Arrays.fill(serial, 0);
        System.arraycopy(from.serial, 0, serial, 0, from.joints);
        System.arraycopy(from.rows, 0, rows, 0, JointState.of(from.joints));
        brokenCount = 0;
        steps = 0;
    }
}
