package io.github.circles2d.world.device;

import io.github.circles2d.opencl.Device;
import io.github.circles2d.opencl.Kernel;
import io.github.circles2d.world.model.GridLevels;

/**
 * The stages Contacts and Solver on a device, where all circles are of one level: a launch a pass instead of a launch a
 * colour; {@code kernels/world/Tiles.cl} tells how. Chooses the size of a tile: as large as gives the device enough tiles to
 * work on at once, but so that the circles around none of them exceed {@link #CIRCLES}, which a step finds out.
 */
final class Tiles {
    /**
     * Circles that the local memory of a work-group has room for. As few as the largest size needs where circles are packed:
     * more room means fewer work-groups at once.
     */
    static final int CIRCLES = 1312;

    /** Contacts that the local memory of a work-group has room for. */
    static final int CONTACTS = 3328;

    /** Rounds that there is room for. */
    static final int ROUNDS = 96;

    /** Work-items of a work-group: at least as many as a colour has groups around a tile. */
    static final int GROUP = 128;

    /** Parts of rounds that there is room for; even, as {@link #CIRCLES}: the pairs behind them in a record are aligned. */
    static final int PARTS = (ROUNDS + CONTACTS / GROUP + 1) & ~1;

    /** Ints of a tile's record; see {@code Tiles.cl}. */
    static final int RECORD = 4 + PARTS + 2 + CIRCLES + 2 * CONTACTS;

    /** A peak that says that no tile would do. */
    private static final int NO_TILE = Integer.MAX_VALUE;

    /** Local memory that a work-group takes. */
    private static final int LOCAL_BYTES = 40 << 10;

    /** The smallest size that is ever better for speed; smaller ones are for crowds. */
    private static final int SMALLEST = 2;

    /** Tiles that were given up are tried again after so many calls for the state. */
    private static final int RETRY = 256;

    /** Below this many percent of the room the next larger size has room too: its regions are 1.5 to 1.75 times as large. */
    private static final int CALM_PEAK = 50;

    /**
     * Sizes of a tile, largest first: log2 of its columns and rows. Wide ones, because the border is wider than high: 32 x 8
     * cells have one of 0.48 of their own, 16 x 16 of 0.55, 16 x 8 of 0.72.
     */
    private static final int[][] SIZES = {{5, 3}, {4, 3}, {3, 3}, {3, 2}, {3, 1}};

    private final DeviceArrays buffers;
    private final Scan scan;
    private final Device device;
    private final Kernel crowd;
    private final Kernel count;
    private final Kernel list;
    private final Kernel link;
    private final Kernel arrange;
    private final Kernel push;
    private final Kernel remember;
    private final Kernel relax;

    /** The largest size that may be chosen: larger ones held too many circles. None may where it is the number of sizes. */
    private int largestSize;

    /** How often there has been something to learn since tiles were given up. */
    private int without;

    /** How often tiles are not tried again on crowds that are thinned out, since they had a group too long for them. */
    private int withoutCrowds;

    private int size;
    private int tiles;

    Tiles(StageKernels kernels, DeviceArrays buffers, Scan scan, Device device) {
        this.buffers = buffers;
        this.scan = scan;
        this.device = device;
        crowd = kernels.staged("contacts_crowd");
        count = kernels.staged("contacts_count");
        list = kernels.staged("contacts_list");
        arrange = kernels.staged("contacts_arrange");
        link = kernels.staged("contacts_link");
        remember = kernels.staged("solver_remember");
        push = kernels.staged("solver_pushTile");
        relax = kernels.staged("solver_relaxTile");
    }

    /** Whether a device can run the tiles at all. */
    static boolean fit(Device device) {
        return device.localMemoryBytes() >= LOCAL_BYTES && device.maxWorkGroupSize() >= GROUP;
    }

    /**
     * Chooses the size of a tile for the next steps.
     *
     * @param atOnce how many work-groups run at once, where each had better have one tile; 0 where they come and go
     * @param thinning whether the steps thin crowds out
     * @return false where no tile would do
     */
    boolean choose(GridLevels levels, StepParameters parameters, int atOnce, boolean thinning) {
        if (levels.usedCount != 1 || largestSize == SIZES.length || (thinning && withoutCrowds > 0)) {
            return false;
        }
        size = largestSize;
        while (size < SMALLEST && tooFew(tiles(size, levels), tiles(size + 1, levels), atOnce)) {
            size++;
        }
        int level = levels.used[0];
        parameters.setTile(
                Math.min(SIZES[size][0], levels.columnsLog[level]),
                Math.min(SIZES[size][1], levels.rowsLog[level]),
                across(size, levels),
                down(size, levels));
        tiles = tiles(size, levels);
        buffers.ensureTiles(tiles);
        return true;
    }

    /** Whether a smaller size is better: a tile for each work-group that waits, or several for each compute unit. */
    private boolean tooFew(int tilesOfThis, int tilesOfNext, int atOnce) {
        return atOnce > 0 ? tilesOfNext <= atOnce : tilesOfThis < 3 * device.computeUnits();
    }

    private static int tiles(int size, GridLevels levels) {
        return across(size, levels) * down(size, levels);
    }

    /** Tiles side by side. */
    private static int across(int size, GridLevels levels) {
        int level = levels.used[0];
        return along(SIZES[size][0], levels.columnsUsed[level], levels.columnCount[level]);
    }

    /** Tiles in a column. */
    private static int down(int size, GridLevels levels) {
        int level = levels.used[0];
        return along(SIZES[size][1], levels.rowsUsed[level], levels.rowCount[level]);
    }

    /** Tiles from cell -1 to the last one used, or around the torus where those are fewer. */
    private static int along(int tileLog, int cellsUsed, int side) {
        return Math.min((cellsUsed >> tileLog) + 1, (side - 1 >> tileLog) + 1);
    }

    int tiles() {
        return tiles;
    }

    /**
     * Takes note of how full the fullest tile was: tiles become smaller where that was too much, and larger where there is
     * room again.
     *
     * @param peak percent of the room; 0 where no tiles were used
     * @param thinning whether the steps thinned crowds out
     */
    void learn(int peak, boolean thinning) {
        if (thinning && withoutCrowds > 0) {
            withoutCrowds--;
        } else if (thinning && peak == NO_TILE) {
            withoutCrowds = RETRY;
        } else if (peak > 100) {
            largestSize = peak == NO_TILE ? SIZES.length : size + 1;
            without = 0;
        } else if (largestSize == SIZES.length) {
            if (++without == RETRY) {
                largestSize--;
            }
        } else if (size == largestSize && size > 0 && peak > 0 && peak < CALM_PEAK) {
            largestSize--;
        }
    }

    /**
     * Lists the contacts, and puts those of each tile in order.
     *
     * @param thinning whether to thin crowds out
     */
    void list(GridLevels levels, int circles, boolean thinning) {
        if (thinning) {
            crowd.run(circles);
        }
        count.run(circles);
        scan.run(buffers, levels.buckets() + 1, DeviceArrays.GROUP_START);
        list.run(2L * circles);
        link.run(2L * circles);
        arrange.run((long) tiles * GROUP, GROUP);
    }

    void solve(int circles, int subSteps) {
        long items = (long) tiles * GROUP;
        for (int sub = 0; sub < subSteps; sub++) {
            push.arg(DeviceArrays.COUNT, sub).run(items, GROUP);
            relax.arg(DeviceArrays.COUNT, sub == subSteps - 1 ? 1 : 0).run(items, GROUP);
        }
        remember.run(2L * circles);
    }
}
