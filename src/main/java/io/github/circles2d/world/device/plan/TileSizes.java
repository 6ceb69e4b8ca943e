package io.github.circles2d.world.device.plan;

import io.github.circles2d.world.device.memory.StepParameters;
import io.github.circles2d.world.device.memory.TileRecord;
import io.github.circles2d.world.model.GridLevels;

/**
 * Chooses the size of a tile, one for all levels: the largest that leaves enough tiles for the device to work on at once. A step finds out
 * whether a region has more circles than {@link TileRecord#CIRCLES}, or more contacts than there is room for. Then the next steps cut such
 * tiles, if they have a launch a pass, and all tiles are smaller if work-groups wait for each other.
 */
final class TileSizes {
    /** Columns that a region reaches beyond its tile, on both sides; see {@code kernels/world/tiles/Tiles.cl}. */
    static final int HALO_COLUMNS = 3;

    /** A size of a tile, log2 of its columns and rows of cells. */
    private record Size(int columnsLog, int rowsLog) {}

    /** Largest first, and wide, because the border is wider than high: 0.48 of the cells of 32 x 8, 0.55 of 16 x 16, 0.72 of 16 x 8. */
    private static final Size[] SIZES = {new Size(5, 3), new Size(4, 3), new Size(3, 3), new Size(3, 2), new Size(3, 1)
    };

    /** The smallest size that is ever better for speed; smaller ones are for crowds. */
    private static final int SMALLEST = 2;

    /** Sizes for work-groups that wait for each other are tried again after so many batches without any. */
    private static final int RETRY_TOGETHER = 256;

    /** Batches after which tiles are tried again: a refused step costs little beside one by colours, and crowds go within a second. */
    private static final int RETRY = 16;

    /** For so many batches after the last that cut some, steps look for tiles to cut. */
    private static final int CALM = 16;

    /** Below this many percent of the room the next larger size has room too: its regions are 1.5 to 1.75 times as large. */
    private static final int CALM_PEAK = 50;

    private final int computeUnits;

    /** Whether tiles have room for circles that turn. */
    private final boolean holdTurning;

    /** The largest size for work-groups that wait for each other: larger ones held too much. None does where it is the number of sizes. */
    private int largestSize;

    /** For how many batches there has been no size for these. */
    private int without;

    /** For how many more batches no tiles are tried. */
    private int givenUp;

    /** For how many more batches tiles are not tried on crowds that are thinned out. */
    private int givenUpForCrowds;

    /** For how many more batches steps cut tiles; 0 where they do not. */
    private int cutting;

    /** Places in the list of tiles, once one had too few; 0 before. */
    private int room;

    /** Whether the size was chosen for work-groups that wait for each other. */
    private boolean together;

    private int size;
    private int tiles;

    TileSizes(int computeUnits, boolean holdTurning) {
        this.computeUnits = computeUnits;
        this.holdTurning = holdTurning;
    }

    /** Whether tiles may do for such steps. */
    boolean suit(Steps steps) {
        return (holdTurning || !steps.turning()) && givenUp == 0 && !(steps.thinning() && givenUpForCrowds > 0);
    }

    /** Whether there is a size that may do for such steps if work-groups wait for each other. */
    boolean suitTogether(Steps steps) {
        return suit(steps) && largestSize < SIZES.length;
    }

    /** Chooses the size for work-groups that come and go: several for each compute unit. */
    void choose(Steps steps) {
        together = false;
        size = 0;
        while (size < SMALLEST && tiles(size, steps) < 3 * computeUnits) {
            size++;
        }
        tiles = tiles(size, steps);
        if (cutting > 0) {
            tiles = Math.max(room, withSpare(tiles));
        }
    }

    /** For work-groups that wait for each other, so many at once, each of which should have one tile. */
    void choose(Steps steps, int atOnce) {
        together = true;
        size = largestSize;
        while (size < SMALLEST && tiles(size + 1, steps) <= atOnce) {
            size++;
        }
        tiles = tiles(size, steps);
    }

    /** Whether steps list the tiles, and cut those that hold too much. */
    boolean cut() {
        return cutting > 0;
    }

    /** How many tiles there are of the size that was chosen, or room for in the list. */
    int tiles() {
        return tiles;
    }

    /** Tells kernels the size that was chosen: in a level of few cells a tile has no more than there are. */
    void describe(Steps steps, StepParameters parameters) {
        GridLevels levels = steps.levels();
        int first = 0;
        for (int n = 0; n < levels.usedCount; n++) {
            int level = levels.used[n];
            int across = across(size, levels, level);
            parameters.setTiles(
                    level,
                    columnsLog(size, levels, level),
                    Math.min(SIZES[size].rowsLog, levels.rowsLog[level]),
                    across,
                    first);
            first += across * down(size, levels, level);
        }
        parameters.setTileCount(tiles);
    }

    /** Tiles of all levels. */
    private static int tiles(int size, Steps steps) {
        GridLevels levels = steps.levels();
        int sum = 0;
        for (int n = 0; n < levels.usedCount; n++) {
            sum += across(size, levels, levels.used[n]) * down(size, levels, levels.used[n]);
        }
        return sum;
    }

    /** log2 of the columns of a tile. It spans a torus around which its region would go further than once. */
    private static int columnsLog(int size, GridLevels levels, int level) {
        int log = Math.min(SIZES[size].columnsLog, levels.columnsLog[level]);
        return (1 << log) + 2 * HALO_COLUMNS > levels.columnCount[level] ? levels.columnsLog[level] : log;
    }

    /** Tiles side by side. */
    private static int across(int size, GridLevels levels, int level) {
        return along(columnsLog(size, levels, level), levels.columnsUsed[level], levels.columnCount[level]);
    }

    /** Tiles in a column. */
    private static int down(int size, GridLevels levels, int level) {
        return along(SIZES[size].rowsLog, levels.rowsUsed[level], levels.rowCount[level]);
    }

    /** Tiles from cell -1 to the last one used, or around the torus where those are fewer. */
    private static int along(int tileLog, int cellsUsed, int side) {
        return Math.min((cellsUsed >> tileLog) + 1, (side - 1 >> tileLog) + 1);
    }

    void learn(Plan.TileUse use, boolean thinning) {
        if (thinning && givenUpForCrowds > 0) {
            givenUpForCrowds--;
        } else if (givenUp > 0) {
            givenUp--;
        } else if (use.peak() == TileRecord.NONE || (use.peak() > 100 && !together && cutting > 0)) {
            giveUp(thinning);
        } else if (together) {
            learnTogether(use.peak());
        } else {
            learnCutting(use);
        }
    }

    private void giveUp(boolean thinning) {
        if (thinning) {
            givenUpForCrowds = RETRY;
        } else {
            givenUp = RETRY;
        }
    }

    private void learnTogether(int peak) {
        if (peak > 100) {
            largestSize = size + 1;
            without = 0;
        } else if (size == largestSize && size > 0 && peak > 0 && peak < CALM_PEAK) {
            largestSize--;
        }
    }

    private void learnCutting(Plan.TileUse use) {
        if (largestSize == SIZES.length && ++without == RETRY_TOGETHER) {
            largestSize--;
        }
        if (cutting == 0) {
            cutting = use.peak() > 100 ? CALM : 0;
            room = 0;
            return;
        }
        if (use.listed() > 0) { // else the step was refused before
            cutting = use.cut() ? CALM : cutting - 1;
        }
        if (use.listed() > tiles) {
            room = withSpare(use.listed());
        }
    }

    private static int withSpare(int tiles) {
        return tiles + (tiles >> 2);
    }
}
