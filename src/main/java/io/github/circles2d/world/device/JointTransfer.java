package io.github.circles2d.world.device;

import io.github.circles2d.world.device.memory.DeviceArrays;
import io.github.circles2d.world.device.memory.DeviceJointStates;
import io.github.circles2d.world.device.memory.Status;
import io.github.circles2d.world.device.memory.StatusWord;
import io.github.circles2d.world.joints.BrokenJoints;
import io.github.circles2d.world.joints.SavedJointStates;

/** Carries what joints keep, and which have broken, between host and device. */
final class JointTransfer {
    private final DeviceArrays arrays;
    private final DeviceJointStates states;

    /** Steps made when the host learned last which joints have broken. */
    private int taken;

    private int[] broken = new int[0];

    JointTransfer(DeviceArrays arrays) {
        this.arrays = arrays;
        states = new DeviceJointStates(arrays);
    }

    void save(SavedJointStates into) {
        into.begin(states.count());
        states.read(into.serial, into.rows, into.joints);
    }

    void makeRoom(SavedJointStates from) {
        if (arrays.features().joints()) {
            arrays.ensureJoints(from.joints);
        }
    }

    /** Takes over saved states, for which there is room; made: steps. */
    void load(SavedJointStates from, Status status, int made) {
        states.write(from.serial, from.rows, from.joints);
        forgetBroken(status, made);
    }

    /** Hands out the joints that have broken since the last time. status: as it is on the device. */
    void takeBroken(BrokenJoints into, Status status, int made) {
        int count = status.get(StatusWord.JOINTS_BROKEN);
        into.begin(count);
        if (broken.length < 2 * count) {
            broken = new int[3 * count];
        }
        states.readBroken(broken, count);
        for (int k = 0; k < count; k++) {
            into.add(broken[2 * k] - taken, broken[2 * k + 1]);
        }
        into.sort();
        forgetBroken(status, made);
    }

    private void forgetBroken(Status status, int made) {
        taken = made;
        if (status.has(StatusWord.JOINTS_BROKEN)) {
            status.read(arrays);
            status.clear(StatusWord.JOINTS_BROKEN);
            status.write(arrays);
        }
    }
}
