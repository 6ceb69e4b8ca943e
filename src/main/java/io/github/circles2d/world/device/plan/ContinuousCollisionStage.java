package io.github.circles2d.world.device.plan;

import io.github.circles2d.opencl.Kernel;
import io.github.circles2d.world.device.memory.DeviceArrays;
import io.github.circles2d.world.device.memory.StageKernels;
import io.github.circles2d.world.model.GridLevels;

/**
 * Continuous collision on a device; {@code kernels/world/stages/ContinuousCollision.cl}. {@code world.jvm.ContinuousCollision} does the
 * same. The kernel of stage Contacts that looks for pairs sets the motion clamps.
 */
final class ContinuousCollisionStage {
    private final Kernel summarize;
    private final Kernel look;

    ContinuousCollisionStage(StageKernels kernels) {
        summarize = kernels.staged("continuousCollision_summarize");
        look = kernels.staged("continuousCollision_look");
    }

    void sweep(GridLevels levels, int circles) {
        summarize.run(DeviceArrays.cellBlocks(levels.buckets()));
        look.run(circles);
    }
}
