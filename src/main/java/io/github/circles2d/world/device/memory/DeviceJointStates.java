package io.github.circles2d.world.device.memory;

import io.github.circles2d.opencl.DeviceBuffer;
import io.github.circles2d.world.device.memory.JointArray.Count;
import io.github.circles2d.world.model.JointState;
import java.nio.FloatBuffer;
import java.nio.IntBuffer;

/** What a device keeps of joints from step to step. */
public final class DeviceJointStates {
    private final DeviceArrays arrays;

    /** Serials of no joints. */
    private final int[] none = new int[1 << 12];

    public DeviceJointStates(DeviceArrays arrays) {
        this.arrays = arrays;
    }

    /** Joints that there is room for. */
    public int count() {
        return arrays.jointRoom().capacity(Count.JOINTS);
    }

    /** Reads serials and {@link JointState}s of the first joints. */
    public void read(int[] serial, float[] rows, int joints) {
        if (joints > 0) {
            requireRoom(joints);
            tables().read(at(JointArray.SERIAL), IntBuffer.wrap(serial, 0, joints));
            tables().read(at(JointArray.STATE), FloatBuffer.wrap(rows, 0, JointState.of(joints)));
        }
    }

    /** Writes those of the first joints, for which there is room, and lets the others have none. */
    public void write(int[] serial, float[] rows, int joints) {
        if (count() > 0) {
            requireRoom(joints);
            for (int from = joints; from < count(); from += none.length) {
                int some = Math.min(none.length, count() - from);
                tables().write(at(JointArray.SERIAL) + (long) Integer.BYTES * from, IntBuffer.wrap(none, 0, some));
            }
            tables().write(at(JointArray.SERIAL), IntBuffer.wrap(serial, 0, joints));
            tables().write(at(JointArray.STATE), FloatBuffer.wrap(rows, 0, JointState.of(joints)));
        }
    }

    /** Reads the first entries of the list of joints that have broken: steps made before, joint. */
    public void readBroken(int[] list, int count) {
        if (count > 0) {
            requireRoom(count);
            tables().read(at(JointArray.BROKEN), IntBuffer.wrap(list, 0, JointArray.BROKEN.words() * count));
        }
    }

    private void requireRoom(int joints) {
        TableRoom.requireRange("joints", JointArray.STATE.ordinal(), 0, joints, count());
    }

    private DeviceBuffer tables() {
        return arrays.get(DeviceArray.KIND_MOTION);
    }

    /** In bytes. */
    private long at(JointArray table) {
        return (long) Integer.BYTES * arrays.at(table);
    }
}
