package io.github.circles2d.world.device;

import io.github.circles2d.opencl.Kernel;
import io.github.circles2d.world.device.memory.DeviceArray;
import io.github.circles2d.world.device.memory.DeviceArrays;
import io.github.circles2d.world.device.memory.StageKernels;
import io.github.circles2d.world.device.plan.Plan;
import java.nio.IntBuffer;

/** Counts on request what the last step did, from the grid and the contact list that it left. */
final class StepStatistics {
    private final DeviceArrays arrays;

    /** Those that the plans use: they know of the world's edges. */
    private StageKernels kernels;

    /** The plan of the last step; null before the first. */
    private Plan plan;

    private int circles;

    private int contacts;

    /** Counts of the last step, or -1 where they have not been asked for. */
    private long candidatePairs;

    private int greatestContacts;

    StepStatistics(DeviceArrays arrays) {
        this.arrays = arrays;
    }

    /** Sets the kernels to count with from here on. */
    void use(StageKernels newKernels) {
        kernels = newKernels;
    }

    /** Takes note of a step. */
    void stepped(Plan planOfStep, int circlesOfStep, int contactsOfStep) {
        plan = planOfStep;
        circles = circlesOfStep;
        contacts = contactsOfStep;
        candidatePairs = -1;
        greatestContacts = -1;
    }

    /** Takes note that the state is not of a step. */
    void loaded() {
        circles = 0;
        contacts = 0;
        candidatePairs = 0;
        greatestContacts = 0;
    }

    int contacts() {
        return contacts;
    }

    /** Counts while what the step has left behind is still there. */
    void keep() {
        candidatePairs();
        greatestContacts();
    }

    long candidatePairs() {
        if (candidatePairs < 0) {
            Kernel candidates = kernels.staged("contacts_candidates");
            kernels.bind(arrays, circles, circles);
            candidates.run(circles);
            long sum = 0;
            for (int tested : Readback.ints(arrays.get(DeviceArray.RANK), circles)) {
                sum += tested;
            }
            candidatePairs = sum;
        }
        return candidatePairs;
    }

    int greatestContacts() {
        if (greatestContacts < 0) {
            arrays.get(DeviceArray.RANK).write(0, IntBuffer.wrap(new int[circles]));
            kernels.bind(arrays, circles, circles);
            plan.countDegrees(contacts);
            int greatest = 0;
            for (int degree : Readback.ints(arrays.get(DeviceArray.RANK), circles)) {
                greatest = Math.max(greatest, degree);
            }
            greatestContacts = greatest;
        }
        return greatestContacts;
    }
}
