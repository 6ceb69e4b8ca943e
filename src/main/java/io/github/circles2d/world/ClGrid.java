package io.github.circles2d.world;

import io.github.circles2d.opencl.Kernel;

/** Stage Grid on a device; {@code kernels/world/Grid.cl}. The same as {@link JvmGrid}. */
final class ClGrid {
    private final ClBuffers buffers;
    private final ClScan scan;
    private final Kernel clear;
    private final Kernel count;
    private final Kernel scatter;
    private final Kernel sort;
    private final Kernel gather;

    ClGrid(ClKernels kernels, ClBuffers buffers, ClScan scan) {
        this.buffers = buffers;
        this.scan = scan;
        clear = kernels.staged("grid_clear");
        count = kernels.staged("grid_count");
        scatter = kernels.staged("grid_scatter");
        sort = kernels.staged("grid_sort");
        gather = kernels.staged("grid_gather");
    }

    void build(Levels levels, int slots, int circles) {
        int buckets = levels.buckets();
        clear.run(buckets + 1L);
        count.run(slots);
        scan.run(buffers.get(ClBuffers.BUCKET_START), buckets + 1, buffers.get(ClBuffers.BLOCK_SUMS));
        scatter.run(slots);
        sort.run(buckets);
        gather.run(circles);
    }
}
