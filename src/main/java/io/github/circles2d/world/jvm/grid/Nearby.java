package io.github.circles2d.world.jvm.grid;

import io.github.circles2d.world.jvm.threads.Team;
import io.github.circles2d.world.model.GridLevels;

/**
 * Goes through the circles in a rectangle of a level's cells, as ranges of slots: row by row, or in a level that is {@linkplain
 * GridLevels folded} bucket by bucket, with the circles of the rectangle's own sheets alone. Each worker has its own.
 */
public final class Nearby {
    private final Grid grid;
    private final GridLevels levels;

    /** The slots of the range that {@link #next} has found: from, up to. */
    public int from;

    public int to;

    private int firstColumn;
    private int columns;
    private int rows;
    private int side;
    private int lastRow;
    private int rowLog;

    private int row;
    private int rowsSeen;
    private int columnsSeen;

    private boolean areSheetsKnown;

    /** Whether a range is of one bucket, and of one sheet there. */
    private boolean bySheet;

    private boolean withStatics;

    /** The sheet before the seams of the torus, behind that along x, behind that along y, behind both. */
    private final int[] sheet = new int[4];

    /** 1 behind the seam along x, 2 behind that along y: what the first cell has of both. */
    private int beyond;

    private int firstBucket;
    private int firstRow;

    Nearby(Grid grid, GridLevels levels) {
        this.grid = grid;
        this.levels = levels;
    }

    /** One for each worker. */
    public static Nearby[] ofWorkers(Grid grid, GridLevels levels, Team team) {
        Nearby[] all = new Nearby[team.most()];
        for (int worker = 0; worker < all.length; worker++) {
            all[worker] = new Nearby(grid, levels);
        }
        return all;
    }

    /**
     * Begins with the cells that a rectangle meets.
     *
     * @param statics whether to find static circles, too
     */
    public void begin(int level, float left, float right, float below, float above, boolean statics) {
        int c0 = levels.columnFrom(left, level);
        int r0 = levels.rowFrom(below, level);
        int many = levels.columnTo(left, right, level) - c0 + 1;
        int manyRows = levels.rowTo(below, above, level) - r0 + 1;
        int width = levels.columnCount[level];
        int height = levels.rowCount[level];
        set(
                level,
                GridLevels.onRing(c0, width),
                Math.min(many, width),
                GridLevels.onRing(r0, height),
                Math.min(manyRows, height),
                statics);
        if (levels.folded[level] && many <= width && manyRows <= height) {
            setSheets(level, levels.sheetX(left, level), levels.sheetY(below, level));
            bySheet = true;
        }
    }

    /** The same with the 3 x 3 cells around a place. */
    public void beginAround(int level, float x, float y, boolean statics) {
        int column = levels.column(x, level);
        int row = levels.row(y, level);
        set(
                level,
                GridLevels.neighbour(column, -1, levels.columnCount[level]),
                3,
                GridLevels.neighbour(row, -1, levels.rowCount[level]),
                3,
                statics);
        if (levels.folded[level]) {
            setSheets(
                    level,
                    GridLevels.sheetBeside(levels.sheetX(x, level), column == 0 ? -1 : 0, levels.sheetsX[level]),
                    GridLevels.sheetBeside(levels.sheetY(y, level), row == 0 ? -1 : 0, levels.sheetsY[level]));
            bySheet = true;
        }
    }

    /** Sets the sheets that blocks to come lie on, before the seams. */
    void setSheets(int level, int sheetX, int sheetY) {
        int nextX = GridLevels.sheetBeside(sheetX, 1, levels.sheetsX[level]);
        int nextY = GridLevels.sheetBeside(sheetY, 1, levels.sheetsY[level]);
        sheet[0] = levels.sheetKey(level, sheetX, sheetY);
        sheet[1] = levels.sheetKey(level, nextX, sheetY);
        sheet[2] = levels.sheetKey(level, sheetX, nextY);
        sheet[3] = levels.sheetKey(level, nextX, nextY);
        areSheetsKnown = true;
    }

    /** Blocks to come are of any sheets. */
    void forgetSheets() {
        areSheetsKnown = false;
    }

    /** Begins with a block of cells, which no seam divides: behind those along x or y, or before. */
    void beginBlock(
            int level, int column, int manyColumns, boolean isBeyondX, int atRow, int manyRows, boolean isBeyondY) {
        set(level, column, manyColumns, atRow, manyRows, true);
        beyond = (isBeyondX ? 1 : 0) + (isBeyondY ? 2 : 0);
        bySheet = areSheetsKnown && levels.folded[level];
    }

    private void set(int level, int column, int manyColumns, int atRow, int manyRows, boolean statics) {
        firstBucket = levels.first[level];
        rowLog = levels.columnsLog[level];
        side = levels.columnCount[level];
        lastRow = levels.rowCount[level] - 1;
        firstColumn = column;
        columns = manyColumns;
        firstRow = atRow;
        row = atRow;
        rows = manyRows;
        rowsSeen = 0;
        columnsSeen = 0;
        withStatics = statics || !grid.hasSheets();
        beyond = 0;
        bySheet = !withStatics && !levels.folded[level];
        if (bySheet) {
            setSheets(level, 0, 0);
        }
    }

    /** Finds the next range that is not empty; whether there is one. */
    public boolean next() {
        while (rowsSeen < rows) {
            if (columnsSeen == columns) {
                columnsSeen = 0;
                rowsSeen++;
                row = row == lastRow ? 0 : row + 1;
                continue;
            }
            int column = firstColumn + columnsSeen;
            boolean isBeyond = column >= side;
            int bucket = firstBucket + (row << rowLog) + (isBeyond ? column - side : column);
            int run = isBeyond ? columns - columnsSeen : Math.min(columns - columnsSeen, side - column);
            boolean eachBucket = bySheet && !(withStatics && areFew(bucket, run));
            int width = eachBucket ? 1 : run;
            columnsSeen += width;
            from = grid.start[bucket];
            to = grid.start[bucket + width];
            if (eachBucket && (withStatics ? to - from > GridLevels.FEW : from < to)) {
                int own = sheet[beyond | (isBeyond ? 1 : 0) | (row < firstRow ? 2 : 0)];
                from = grid.sheetStart(from, to, own);
                to = withStatics ? grid.sheetEnd(from, to, own) : grid.movingEnd(from, to, own);
            }
            if (from < to) {
                return true;
            }
        }
        return false;
    }

    /** Whether buckets have so few circles that all are looked at: to look for their sheets would take longer. */
    private boolean areFew(int bucket, int many) {
        return grid.start[bucket + many] - grid.start[bucket] <= GridLevels.FEW * many;
    }
}
