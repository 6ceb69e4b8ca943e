package io.github.circles2d.world;

import io.github.circles2d.opencl.DeviceBuffer;
import io.github.circles2d.opencl.Kernel;

/** Exclusive prefix sums on the device, in place; {@code kernels/world/Scan.cl}. */
final class ClScan {
    /** Work-items of a work-group. */
    private static final int GROUP = 256;

    /** Elements of a block: eight a work-item. */
    private static final int BLOCK = 8 * GROUP;

    private final Kernel blocks;
    private final Kernel sums;
    private final Kernel add;

    ClScan(ClKernels kernels) {
        blocks = kernels.plain("scan_blocks");
        sums = kernels.plain("scan_sums");
        add = kernels.plain("scan_add");
    }

    /** Number of block sums that a scan needs. */
    static int blocks(int elements) {
        return (elements + BLOCK - 1) / BLOCK;
    }

    void run(DeviceBuffer counts, int elements, DeviceBuffer blockSums) {
        int n = blocks(elements);
        blocks.arg(0, counts).arg(1, elements).arg(2, blockSums).run((long) n * GROUP, GROUP);
        if (n > 1) {
            sums.arg(0, blockSums).arg(1, n).run(GROUP, GROUP);
            add.arg(0, counts).arg(1, elements).arg(2, blockSums).run(elements);
        }
    }
}
