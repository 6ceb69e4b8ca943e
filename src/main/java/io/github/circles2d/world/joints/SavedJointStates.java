package io.github.circles2d.world.joints;

import io.github.circles2d.world.model.CircleMath;
import io.github.circles2d.world.model.JointState;
import java.util.Arrays;

/** What joints keep from step to step, by id. A row counts if its serial is that of the joint. */
public final class SavedJointStates {
    /** Greatest id, and 1. */
    public int joints;

    /** Of the joint that the row is of; its complement if it has broken. */
    public int[] serial = new int[0];

    /** {@link JointState} */
    public float[] rows = new float[0];

    /** Makes room for joints, and keeps none. */
    public void begin(int count) {
        joints = count;
        if (serial.length < count) {
            rows = new float[JointState.of(count + (count >> 1))];
            serial = new int[count + (count >> 1)];
        }
    }

    /** Makes room for joints, and keeps those that there are; others have the serial 0 and no impulses. */
    public void extend(int count) {
        if (serial.length < count) {
            rows = Arrays.copyOf(rows, JointState.of(count + (count >> 1)));
            serial = Arrays.copyOf(serial, count + (count >> 1));
        }
        if (joints < count) {
            for (int joint = joints; joint < count; joint++) {
                clear(joint);
            }
            joints = count;
        }
    }

    /** The force on the first circle in a step of a length: from the sum of the impulses. */
    public float forceX(int joint, float dt) {
        return rate(-1f * rows[JointState.of(joint) + JointState.SUM_X], dt);
    }

    public float forceY(int joint, float dt) {
        return rate(-1f * rows[JointState.of(joint) + JointState.SUM_Y], dt);
    }

    /** Not negative. */
    public float force(int joint, float dt) {
        return CircleMath.length(forceX(joint, dt), forceY(joint, dt));
    }

    public float torque(int joint, float dt) {
        return rate(rows[JointState.of(joint) + JointState.SUM_ANGULAR], dt);
    }

    /** There is one zero; 0 before the first step, also in a world that was restored to then. */
    private static float rate(float sum, float dt) {
        return dt > 0f ? sum / dt + 0f : 0f;
    }

    /** A joint has no impulses. */
    public void clear(int joint) {
        serial[joint] = 0;
        Arrays.fill(rows, JointState.of(joint), JointState.of(joint + 1), 0f);
    }
}
