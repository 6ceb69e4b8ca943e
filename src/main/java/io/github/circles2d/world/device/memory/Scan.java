package io.github.circles2d.world.device.memory;

import io.github.circles2d.opencl.DeviceBuffer;
import io.github.circles2d.opencl.Kernel;

/** Exclusive prefix sums on the device; {@code kernels/world/stages/Scan.cl}. */
public final class Scan {
    /** Work-items of a work-group. */
    public static final int GROUP = StageKernels.SMALL_GROUPS ? 8 : 256;

    /** Elements a work-item. */
    public static final int EACH = 4;

    private final Kernel blocks;
    private final Kernel starts;

    public Scan(StageKernels kernels) {
        blocks = kernels.plain("scan_blocks");
        starts = kernels.plain("scan_starts");
    }

    /** Number of elements that the arrays of a scan need room for. */
    public static int padded(int elements) {
        return (elements + EACH - 1) / EACH * EACH;
    }

    /** Number of block sums that a scan needs. */
    public static int blocks(int elements) {
        return (elements + EACH * GROUP - 1) / (EACH * GROUP);
    }

    /** Sums up the tally into one of the stages' arrays, and clears it. */
    public void run(DeviceArrays arrays, int elements, DeviceArray sums) {
        run(
                arrays.get(DeviceArray.TALLY),
                elements,
                arrays.get(DeviceArray.BLOCK_SUMS),
                arrays.get(sums),
                arrays.get(DeviceArray.STATUS));
    }

    /** Sums up counts, and clears them; leaves both alone if the status says that a step waits for the host. */
    public void run(DeviceBuffer counts, int elements, DeviceBuffer blockSums, DeviceBuffer sums, DeviceBuffer status) {
        long items = (long) blocks(elements) * GROUP;
        blocks.arg(0, counts).arg(1, elements).arg(2, blockSums).run(items, GROUP);
        starts.arg(0, counts)
                .arg(1, elements)
                .arg(2, blockSums)
                .arg(3, sums)
                .arg(4, status)
                .run(items, GROUP);
    }
}
