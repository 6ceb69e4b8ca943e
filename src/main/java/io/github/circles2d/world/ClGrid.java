package io.github.circles2d.world;

import io.github.circles2d.opencl.Kernel;

/** Stage Grid on a device; {@code kernels/world/Grid.cl}. The same as {@link JvmGrid}. */
final class ClGrid {
    private final ClBuffers buffers;
    private final ClScan scan;
    private final Kernel count;
    private final Kernel scatter;
    private final Kernel gather;

    ClGrid(ClKernels kernels, ClBuffers buffers, ClScan scan) {
        this.buffers = buffers;
        this.scan = scan;
        count = kernels.staged("grid_count");
        scatter = kernels.staged("grid_scatter");
        gather = kernels.staged("grid_gather");
    }

    void build(Levels levels, int slots, int circles) {
        count.run(slots);
        scan.run(buffers, levels.buckets() + 1, ClBuffers.BUCKET_START);
        scatter.run(slots);
        gather.run(circles);
    }
}
