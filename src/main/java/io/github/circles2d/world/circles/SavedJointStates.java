package io.github.circles2d.world.circles;

import io.github.circles2d.world.model.JointState;

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
            serial = new int[count + (count >> 1)];
            rows = new float[JointState.of(serial.length)];
        }
    }
}
