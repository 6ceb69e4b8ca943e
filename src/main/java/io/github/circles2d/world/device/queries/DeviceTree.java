package io.github.circles2d.world.device.queries;

import io.github.circles2d.opencl.DeviceBuffer;
import io.github.circles2d.opencl.Kernel;
import io.github.circles2d.opencl.KernelSource;
import io.github.circles2d.opencl.Session;
import io.github.circles2d.world.device.memory.DeviceArray;
import io.github.circles2d.world.device.memory.DeviceArrays;
import io.github.circles2d.world.device.memory.GrownBuffer;
import io.github.circles2d.world.device.memory.Scan;
import io.github.circles2d.world.device.memory.StageKernels;
import io.github.circles2d.world.queries.CircleTree;
import java.nio.IntBuffer;

/**
 * A tree of boxes over the circles of a device; {@code kernels/world/queries/Tree.cl}. It is built from where circles are now: the grid
 * of the last step has them where they were before it, and is the step's own.
 */
final class DeviceTree {
    /** At least the levels that 100 million circles need. */
    static final int LEVELS = 14;

    /** In the extent: four coordinates, and whether a cell is crowded. */
    private static final int EXTENT_WORDS = 5;

    private static final int CROWDED = 4;

    /** Circles of one cell from which on the host searches: boxes of a crowd all lie upon each other. */
    private static final int MOST_IN_A_CELL = 2048;

    /** Most bits of a column or a row: four million cells. */
    private static final int MOST_BITS = 11;

    private static final int EXTENT_ITEMS = 1 << 14;
    private static final long ROW_BYTES = 4L * Float.BYTES;

    private final DeviceArrays arrays;
    private final Scan scan;
    private final Kernel measure;
    private final Kernel tally;
    private final Kernel place;
    private final Kernel boxCircles;
    private final Kernel boxBoxes;
    private final int[] extent = new int[EXTENT_WORDS];

    /** The top level; then where the boxes of each level begin and how many there are. */
    private final int[] shape = new int[1 + 2 * LEVELS];

    private int circles;
    private final DeviceBuffer extentOf;
    private final DeviceBuffer shapeOf;
    private final GrownBuffer cellOf;
    private final GrownBuffer rank;
    private final GrownBuffer counts;
    private final GrownBuffer starts;
    private final GrownBuffer blockSums;
    private final GrownBuffer circle;
    private final GrownBuffer id;
    private final GrownBuffer box;

    DeviceTree(Session session, StageKernels kernels, DeviceArrays arrays) {
        this.arrays = arrays;
        scan = new Scan(kernels);
        measure = kernels.plain("queries_extent");
        tally = kernels.plain("queries_tally");
        place = kernels.plain("queries_place");
        boxCircles = kernels.plain("queries_boxCircles");
        boxBoxes = kernels.plain("queries_boxBoxes");
        cellOf = new GrownBuffer(session, "cells of circles");
        rank = new GrownBuffer(session, "ranks in cells");
        counts = new GrownBuffer(session, "circles in cells");
        starts = new GrownBuffer(session, "starts of cells");
        blockSums = new GrownBuffer(session, "sums of cells");
        circle = new GrownBuffer(session, "circles of the tree");
        id = new GrownBuffer(session, "ids of the tree");
        box = new GrownBuffer(session, "boxes of the tree");
        extentOf = session.allocate("extent", (long) Integer.BYTES * EXTENT_WORDS);
        shapeOf = session.allocate("shape of the tree", (long) Integer.BYTES * shape.length);
    }

    /** Adds the numbers that the kernels share with the host. */
    static KernelSource define(KernelSource source) {
        return source.define("TREE_MARGIN", CircleTree.MARGIN)
                .define("CIRCLES_A_BOX", CircleTree.CIRCLES_A_BOX)
                .define("BOXES_A_BOX", CircleTree.BOXES_A_BOX)
                .define("TREE_LEVELS", LEVELS)
                .define("MOST_IN_A_CELL", MOST_IN_A_CELL);
    }

    /** False if circles crowd so that a tree is of no use. */
    boolean build(int slots, int size) {
        circles = size;
        int bits = bits(size);
        makeRoom(slots, bits);
        extent[CROWDED] = 0;
        for (int k = 0; k < CROWDED; k++) {
            extent[k] = Integer.MAX_VALUE;
        }
        extentOf.write(0, IntBuffer.wrap(extent));
        atHome(measure, slots).arg(3, extentOf).run(Math.min(slots, EXTENT_ITEMS));
        atHome(tally, slots)
                .arg(3, bits)
                .arg(4, extentOf)
                .arg(5, cellOf.get())
                .arg(6, rank.get())
                .arg(7, counts.get())
                .run(slots);
        scan.run(counts.get(), cells(bits), blockSums.get(), starts.get(), arrays.get(DeviceArray.STATUS));
        extentOf.read(IntBuffer.wrap(extent));
        if (extent[CROWDED] != 0) {
            return false;
        }
        atHome(place, slots)
                .arg(3, cellOf.get())
                .arg(4, rank.get())
                .arg(5, starts.get())
                .arg(6, circle.get())
                .arg(7, id.get())
                .run(slots);
        boxCircles
                .arg(0, circle.get())
                .arg(1, size)
                .arg(2, boxes(0))
                .arg(3, box.get())
                .run(boxes(0));
        for (int level = 1; level <= shape[0]; level++) {
            boxBoxes.arg(0, box.get())
                    .arg(1, start(level - 1))
                    .arg(2, boxes(level - 1))
                    .arg(3, start(level))
                    .arg(4, boxes(level))
                    .run(boxes(level));
        }
        return true;
    }

    private Kernel atHome(Kernel kernel, int slots) {
        return kernel.arg(0, arrays.get(DeviceArray.HOME_ID))
                .arg(1, arrays.get(DeviceArray.HOME_CIRCLE))
                .arg(2, slots);
    }

    /** Sets the arguments of a search that tell of the tree: the first five. */
    Kernel bind(Kernel search) {
        return search.arg(0, circle.get())
                .arg(1, id.get())
                .arg(2, box.get())
                .arg(3, shapeOf)
                .arg(4, circles);
    }

    /** Bits of a column or a row, with which there are about as many cells as circles, and up to four times as many. */
    private static int bits(int size) {
        int bits = 1;
        while (bits < MOST_BITS && cells(bits) < size) {
            bits++;
        }
        return bits;
    }

    private static int cells(int bits) {
        return 1 << 2 * bits;
    }

    private int start(int level) {
        return shape[1 + 2 * level];
    }

    private int boxes(int level) {
        return shape[2 + 2 * level];
    }

    private void makeRoom(int slots, int bits) {
        int boxes = layOut();
        shapeOf.write(0, IntBuffer.wrap(shape));
        cellOf.ensureRoomy((long) Integer.BYTES * slots);
        rank.ensureRoomy((long) Integer.BYTES * slots);
        circle.ensureRoomy(ROW_BYTES * circles);
        id.ensureRoomy((long) Integer.BYTES * circles);
        box.ensureRoomy(ROW_BYTES * boxes);
        int elements = Scan.padded(cells(bits));
        starts.ensureRoomy((long) Integer.BYTES * elements);
        blockSums.ensureRoomy((long) Integer.BYTES * Scan.blocks(elements));
        if (!counts.has((long) Integer.BYTES * elements)) {
            DeviceBuffer zeros = counts.ensureRoomy((long) Integer.BYTES * elements);
            zeros.write(0, IntBuffer.wrap(new int[(int) (zeros.bytes() / Integer.BYTES)]));
        }
    }

    /** Lays the levels out. Returns the number of all boxes. */
    private int layOut() {
        int level = 0;
        int start = 0;
        int count = (circles + CircleTree.CIRCLES_A_BOX - 1) / CircleTree.CIRCLES_A_BOX;
        while (true) {
            shape[1 + 2 * level] = start;
            shape[2 + 2 * level] = count;
            start += count;
            if (count == 1) {
                shape[0] = level;
                return start;
            }
            count = (count + CircleTree.BOXES_A_BOX - 1) / CircleTree.BOXES_A_BOX;
            level++;
        }
    }
}
