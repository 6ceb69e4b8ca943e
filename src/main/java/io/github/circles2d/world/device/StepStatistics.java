package io.github.circles2d.world.device;

import io.github.circles2d.opencl.Kernel;
import java.nio.IntBuffer;

/** Counts what the last step did, when asked: from the grid and the contact list that it has left behind. */
final class StepStatistics {
    private final StageKernels kernels;
    private final DeviceArrays buffers;
    private final Kernel candidates;
    private final Kernel degrees;

    /** Whether the last step was made by tiles. */
    private boolean tiled;

    /** What the last step was made by; null where it was made in another way. */
    private PersistentCpu lanes;

    /** Circles and contacts of the last step. */
    private int circles;

    private int contacts;

    /** Counts of the last step, or -1 where they have not been asked for. */
    private long candidatePairs;

    private int greatestContacts;

    StepStatistics(StageKernels kernels, DeviceArrays buffers) {
        this.kernels = kernels;
        this.buffers = buffers;
        candidates = kernels.staged("contacts_candidates");
        degrees = kernels.plain("contacts_degrees");
    }

    /** Takes note of a step. */
    void stepped(int circlesOfStep, int contactsOfStep, boolean tiledStep, PersistentCpu lanesOfStep) {
        tiled = tiledStep;
        lanes = lanesOfStep;
        circles = circlesOfStep;
        contacts = contactsOfStep;
        candidatePairs = -1;
        greatestContacts = -1;
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
            kernels.bind(buffers, circles, circles);
            candidates.run(circles);
            long sum = 0;
            for (int tested : Readback.ints(buffers.get(DeviceArrays.RANK), circles)) {
                sum += tested;
            }
            candidatePairs = sum;
        }
        return candidatePairs;
    }

    int greatestContacts() {
        if (greatestContacts < 0) {
            buffers.get(DeviceArrays.RANK).write(0, IntBuffer.wrap(new int[circles]));
            if (lanes != null) {
                kernels.bind(buffers, circles, circles);
                lanes.countDegrees();
            } else {
                degrees.arg(0, buffers.get(tiled ? DeviceArrays.ORDERED : DeviceArrays.PAIR))
                        .arg(1, contacts)
                        .arg(2, buffers.get(DeviceArrays.RANK))
                        .run(contacts);
            }
            int greatest = 0;
            for (int degree : Readback.ints(buffers.get(DeviceArrays.RANK), circles)) {
                greatest = Math.max(greatest, degree);
            }
            greatestContacts = greatest;
        }
        return greatestContacts;
    }
}
