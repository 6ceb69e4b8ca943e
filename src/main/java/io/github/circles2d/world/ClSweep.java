package io.github.circles2d.world;

import io.github.circles2d.opencl.Kernel;

/**
 * Stage Sweep on a device; {@code kernels/world/Sweep.cl}. The same as {@link JvmSweep}; the leashes are laid by
 * the kernel of stage Contacts that looks for pairs.
 */
final class ClSweep {
    /** log2 of the cells of a block. */
    private static final int BLOCK_CELLS_LOG = 4;

    private final Kernel summarize;
    private final Kernel look;

    ClSweep(ClKernels kernels) {
        summarize = kernels.staged("sweep_summarize");
        look = kernels.staged("sweep_look");
    }

    /** Number of blocks of cells. */
    static int blocks(int buckets) {
        return buckets >> BLOCK_CELLS_LOG;
    }

    void sweep(Levels levels, int circles) {
        summarize.run(blocks(levels.buckets()));
        look.run(circles);
    }
}
