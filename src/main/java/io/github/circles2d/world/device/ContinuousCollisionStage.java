package io.github.circles2d.world.device;

import io.github.circles2d.opencl.Kernel;
import io.github.circles2d.world.model.GridLevels;

/**
 * Stage Sweep on a device; {@code kernels/world/Sweep.cl}. The same as {@code world.jvm.ContinuousCollision}; the leashes are laid by
 * the kernel of stage Contacts that looks for pairs.
 */
final class ContinuousCollisionStage {
    /** log2 of the cells of a block. */
    private static final int BLOCK_CELLS_LOG = 4;

    private final Kernel summarize;
    private final Kernel look;

    ContinuousCollisionStage(StageKernels kernels) {
        summarize = kernels.staged("sweep_summarize");
        look = kernels.staged("sweep_look");
    }

    /** Number of blocks of cells. */
    static int blocks(int buckets) {
        return buckets >> BLOCK_CELLS_LOG;
    }

    void sweep(GridLevels levels, int circles) {
        summarize.run(blocks(levels.buckets()));
        look.run(circles);
    }
}
