package io.github.circles2d.world.device.plan;

import io.github.circles2d.opencl.Kernel;
import io.github.circles2d.world.device.memory.DeviceArray;
import io.github.circles2d.world.device.memory.DeviceArrays;
import io.github.circles2d.world.device.memory.Scan;
import io.github.circles2d.world.device.memory.StageKernels;
import io.github.circles2d.world.model.GridLevels;

/** Stage Grid on a device; {@code kernels/world/stages/Grid.cl}. {@code world.jvm.Grid} does the same. */
final class GridStage {
    private final DeviceArrays arrays;
    private final Scan scan;
    private final Kernel count;
    private final Kernel scatter;
    private final Kernel gather;

    /** Whether circles may sleep. */
    private final boolean sleeping;

    GridStage(StageKernels kernels, DeviceArrays arrays, Scan scan) {
        this.arrays = arrays;
        this.scan = scan;
        count = kernels.staged("grid_count");
        scatter = kernels.staged("grid_scatter");
        gather = kernels.staged("grid_gather");
        sleeping = arrays.sleeping();
    }

    /** waking: whether the step can wake circles. */
    void build(GridLevels levels, int slots, int circles, boolean waking) {
        count.run(slots);
        scan.run(arrays, levels.buckets() + 1, DeviceArray.BUCKET_START);
        scatter.run(slots);
        if (sleeping) {
            gather.arg(StageKernels.own(0), waking ? 1 : 0);
        }
        gather.run(circles);
    }
}
