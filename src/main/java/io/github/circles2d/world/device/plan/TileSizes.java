package io.github.circles2d.world.device.plan;

import io.github.circles2d.world.device.memory.StepParameters;
import io.github.circles2d.world.device.memory.TileRecord;
import io.github.circles2d.world.model.GridLevels;

/**
 * Chooses the size of a tile, one for all levels: the largest that leaves enough tiles for the device to work on at once, and no
 * region with more circles than {@link TileRecord#CIRCLES}. A step finds out whether a region has more.
 */
final class TileSizes {
    /** A size of a tile, log2 of its columns and rows of cells. */
    private record Size(int columnsLog, int rowsLog) {}

    /**
     * Largest first. Wide ones, because the border is wider than high: 32 x 8 cells have one of 0.48 of their own, 16 x 16 of
     * 0.55, 16 x 8 of 0.72.
     */
    private static final Size[] SIZES = {new Size(5, 3), new Size(4, 3), new Size(3, 3), new Size(3, 2), new Size(3, 1)
    };

    /** The smallest size that is ever better for speed; smaller ones are for crowds. */
    private static final int SMALLEST = 2;

    /** Tiles that were given up are tried again after so many calls for the state. */
    private static final int RETRY = 256;

    /** Below this many percent of the room the next larger size has room too: its regions are 1.5 to 1.75 times as large. */
    private static final int CALM_PEAK = 50;

    private final int computeUnits;

    /** The largest size that may be chosen: larger ones held too many circles. None may where it is the number of sizes. */
    private int largestSize;

    /** How often there has been something to learn since tiles were given up. */
    private int without;

    /** How often tiles are not tried again on crowds that are thinned out, since they had a group too long for them. */
    private int withoutCrowds;

    private int size;
    private int tiles;

    TileSizes(int computeUnits) {
        this.computeUnits = computeUnits;
    }

    /** Whether there is a size that may do for such steps. */
    boolean suit(Steps steps) {
        return largestSize != SIZES.length && !(steps.thinning() && withoutCrowds > 0);
    }

    /** Chooses the size for work-groups that come and go: several for each compute unit. */
    void choose(Steps steps) {
        size = largestSize;
        while (size < SMALLEST && tiles(size, steps) < 3 * computeUnits) {
            size++;
        }
        tiles = tiles(size, steps);
    }

    /**
     * Chooses the size for work-groups that wait for each other, each of which should have one tile.
     *
     * @param atOnce how many work-groups run at once
     */
    void choose(Steps steps, int atOnce) {
        size = largestSize;
        while (size < SMALLEST && tiles(size + 1, steps) <= atOnce) {
            size++;
        }
        tiles = tiles(size, steps);
    }

    /** How many tiles there are of the size that was chosen. */
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
                    Math.min(SIZES[size].columnsLog, levels.columnsLog[level]),
                    Math.min(SIZES[size].rowsLog, levels.rowsLog[level]),
                    across,
                    first);
            first += across * down(size, levels, level);
        }
        parameters.setTileCount(first);
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

    /** Tiles side by side. */
    private static int across(int size, GridLevels levels, int level) {
        return along(SIZES[size].columnsLog, levels.columnsUsed[level], levels.columnCount[level]);
    }

    /** Tiles in a column. */
    private static int down(int size, GridLevels levels, int level) {
        return along(SIZES[size].rowsLog, levels.rowsUsed[level], levels.rowCount[level]);
    }

    /** Tiles from cell -1 to the last one used, or around the torus where those are fewer. */
    private static int along(int tileLog, int cellsUsed, int side) {
        return Math.min((cellsUsed >> tileLog) + 1, (side - 1 >> tileLog) + 1);
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
        } else if (thinning && peak == TileRecord.NO_TILE) {
            withoutCrowds = RETRY;
        } else if (peak > 100) {
            largestSize = peak == TileRecord.NO_TILE ? SIZES.length : size + 1;
            without = 0;
        } else if (largestSize == SIZES.length) {
            if (++without == RETRY) {
                largestSize--;
            }
        } else if (size == largestSize && size > 0 && peak > 0 && peak < CALM_PEAK) {
            largestSize--;
        }
    }
}
