package io.github.circles2d.world.model;

/**
 * The shape of the grids: for each level a torus of W columns and H rows of buckets, by the rules of docs/step.md. Cells may share a bucket,
 * which costs time alone, since the distance of circles decides. So the circles bound memory. Arrays are by level.
 *
 * <p>The sheet of a cell is column div W, row div H. The buckets of a {@link #folded} level are in the order of {@link #sheetKey}, static
 * circles last in a sheet. A row begins at a multiple of V, W rounded up to a power of two. The group (ox, oy) has colour
 * (ox mod 2) + 2 (oy mod 2) and in it number (oy / 2)(V / 2) + ox / 2.
 */
public final class GridLevels {
    /** Factors of two, over all radii that a world takes; but where an axis is open, more are in the last. */
    public static final int COUNT = 20;

    private static final int LEAST_SIDE_LOG = 2;

    private static final int GREATEST_SIDE_LOG = 15;

    /** A bucket of no more circles is faster read whole than searched for a sheet. */
    public static final int FEW = 2;

    /** Sheets that never begin again. */
    public static final int ENDLESS = 0;

    /** In {@link #sheetKey}: odd, and unlike that of y, so sheets of one key are tens of thousands apart. */
    public static final int SHEET_X_FACTOR = 0x9e3779b1;

    public static final int SHEET_Y_FACTOR = 0x85ebca77;

    private static final int WRAPS = 4;

    /** Cells of an arena for each bucket. */
    private static final float ROOMY = 2f;

    private static final int LEAST_PRIME_SIDE_LOG = 4;

    /** By log2 of V, from {@link #LEAST_PRIME_SIDE_LOG} on. */
    private static final int[] PRIME_COLUMNS = {
        2 * 7, 2 * 13, 2 * 31, 2 * 61, 2 * 127, 2 * 251, 2 * 509, 2 * 1021, 2 * 2039, 2 * 4093, 2 * 8191, 2 * 16381
    };

    private static final int[] PRIME_ROWS = {
        2 * 5, 2 * 11, 2 * 29, 2 * 59, 2 * 113, 2 * 241, 2 * 503, 2 * 1019, 2 * 2029, 2 * 4091, 2 * 8179, 2 * 16369
    };

    /** By size class. */
    public final int[] levelOf = new int[COUNT];

    /** By level: the number of circles. */
    public final int[] population = new int[COUNT];

    public final float[] inverseEdge = new float[COUNT];

    /** Rounded up. */
    public final int[] columnsLog = new int[COUNT];

    public final int[] rowsLog = new int[COUNT];

    public final int[] columnCount = new int[COUNT];

    public final int[] rowCount = new int[COUNT];

    /** Fewer if the torus is larger than the arena. */
    public final int[] columnsUsed = new int[COUNT];

    public final int[] rowsUsed = new int[COUNT];

    /** Bucket, and group. */
    public final int[] first = new int[COUNT];

    public final int[] firstRow = new int[COUNT];

    /** Levels with circles, finest first, as their buckets. */
    public final int[] used = new int[COUNT];

    /** Greatest radius. */
    public final float[] top = new float[COUNT];

    /** Units or cells per length, by {@link RingCells}. */
    public final float[] scaleX = new float[COUNT];

    public final float[] scaleY = new float[COUNT];

    /** Of a cell of an open axis. */
    public final int[] unitsX = new int[COUNT];

    public final int[] unitsY = new int[COUNT];

    /** Whether many cells share a bucket; few are cheaper to read than to keep apart. */
    public final boolean[] folded = new boolean[COUNT];

    /** {@link #ENDLESS} unless the axis wraps. */
    public final int[] sheetsX = new int[COUNT];

    public final int[] sheetsY = new int[COUNT];

    private final Object[] arrays = {
        levelOf,
        population,
        inverseEdge,
        columnsLog,
        rowsLog,
        columnCount,
        rowCount,
        columnsUsed,
        rowsUsed,
        first,
        firstRow,
        used,
        top,
        scaleX,
        scaleY,
        unitsX,
        unitsY,
        folded,
        sheetsX,
        sheetsY
    };

    public boolean hasStatics;

    public Bounds bounds = new Bounds(0, 0, 1, 1);

    public int usedCount;
    public int buckets;
    public int rows;
    public float minX;
    public float minY;
    public float rmax;

    /** Counts are by size class. */
    public void layOut(Bounds bounds, float greatestRadius, int[] counts, boolean someStatic) {
        this.bounds = bounds;
        hasStatics = someStatic;
        minX = bounds.minX();
        minY = bounds.minY();
        rmax = greatestRadius;
        usedCount = 0;
        join(counts);
        top[0] = greatestRadius;
        for (int level = 1; level < COUNT; level++) {
            top[level] = top[level - 1] * 0.5f;
        }
        buckets = 0;
        rows = 0;
        for (int level = COUNT - 1; level >= 0; level--) {
            first[level] = buckets;
            firstRow[level] = rows;
            if (population[level] > 0) {
                used[usedCount++] = level;
                layOutLevel(level, bounds);
                buckets += 1 << (columnsLog[level] + rowsLog[level]);
                rows += rowCount[level];
            }
        }
    }

    /** Whether a level has far fewer buckets than its arena has cells, so that it matters where the circles are. */
    public boolean areRoomy() {
        boolean roomy = false;
        for (int l = 0; l < usedCount; l++) {
            int level = used[l];
            roomy |= across(level) * down(level) > ROOMY * (1 << (columnsLog[level] + rowsLog[level]));
        }
        return roomy;
    }

    /**
     * Makes the tori as small as so many circles need, and gives them the form of a box that has all circles: cells of the box share no bucket if
     * there are buckets enough. Cells, levels and the parities of cells stay, and so do all results that do not depend on the order of buckets.
     *
     * @param circles the greatest number in any level
     */
    public void fit(int circles, float width, float height) {
        buckets = 0;
        rows = 0;
        for (int l = 0; l < usedCount; l++) {
            int level = used[l];
            population[level] = Math.min(population[level], circles);
            fitLevel(level, width, height);
            first[level] = buckets;
            firstRow[level] = rows;
            buckets += 1 << (columnsLog[level] + rowsLog[level]);
            rows += rowCount[level];
        }
    }

    private void fitLevel(int level, float width, float height) {
        float boxAcross = cellsOfBox(width, level, bounds.edgeX());
        float boxDown = cellsOfBox(height, level, bounds.edgeY());
        float across = Math.min(across(level), boxAcross);
        float down = Math.min(down(level), boxDown);
        int columnsBefore = columnCount[level];
        int rowsBefore = rowCount[level];
        setSides(level, across, down);
        if (bounds.edgeX() == AxisEdge.WRAP) {
            int cells = columnsBefore * sheetsX[level];
            columnCount[level] = sideOfWhole(columnCount[level], columnsBefore, cells);
            columnsLog[level] = sideLog(columnCount[level]);
            sheetsX[level] = cells / columnCount[level];
            columnsUsed[level] = columnCount[level];
        }
        if (bounds.edgeY() == AxisEdge.WRAP) {
            int cells = rowsBefore * sheetsY[level];
            rowCount[level] = sideOfWhole(rowCount[level], rowsBefore, cells);
            rowsLog[level] = sideLog(rowCount[level]);
            sheetsY[level] = cells / rowCount[level];
            rowsUsed[level] = rowCount[level];
        }
        fold(level, boxAcross, boxDown);
    }

    /** At most; an axis that wraps keeps all of its cells. */
    private float cellsOfBox(float extent, int level, AxisEdge at) {
        return at == AxisEdge.WRAP ? Float.POSITIVE_INFINITY : extent / (2f * speculativeDistance(top[level])) + 2f;
    }

    /** A side of which an axis that wraps has whole sheets, as it has of the side before. */
    private static int sideOfWhole(int most, int before, int cells) {
        for (int side = Math.min(most, before); side >= 1 << LEAST_SIDE_LOG; side -= 2) {
            if (cells % side == 0) {
                return side;
            }
        }
        return before;
    }

    private void join(int[] counts) {
        for (int k = 0; k < COUNT; k++) {
            boolean joins = k > 0 && levelOf[k - 1] == k - 1 && counts[k] <= (long) Tuning.JOIN * counts[k - 1];
            levelOf[k] = joins ? k - 1 : k;
            population[k] = 0;
            population[levelOf[k]] += counts[k];
        }
    }

    private void layOutLevel(int level, Bounds bounds) {
        inverseEdge[level] = 1f / edge(top[level], bounds);
        float across = across(level);
        float down = down(level);
        setSides(level, across, down);
        sheetsX[level] = ENDLESS;
        sheetsY[level] = ENDLESS;
        if (!bounds.isWalled()) {
            layOutEdges(level, across, down);
        }
        fold(level, Float.POSITIVE_INFINITY, Float.POSITIVE_INFINITY);
    }

    private void setSides(int level, float across, float down) {
        int columns = sideLog(across);
        int rows = sideLog(down);
        int budget = Math.max(2 * LEAST_SIDE_LOG, 32 - Integer.numberOfLeadingZeros(population[level]));
        while (columns + rows > budget) {
            if (columns >= rows) {
                columns--;
            } else {
                rows--;
            }
        }
        columnsLog[level] = columns;
        rowsLog[level] = rows;
        columnCount[level] = side(columns, across, PRIME_COLUMNS);
        rowCount[level] = side(rows, down, PRIME_ROWS);
        columnsUsed[level] = cellsUsed(bounds.maxX(), bounds.minX(), level, columnCount[level]);
        rowsUsed[level] = cellsUsed(bounds.maxY(), bounds.minY(), level, rowCount[level]);
    }

    private void fold(int level, float across, float down) {
        folded[level] = isFolded(
                        bounds.edgeX(), bounds.minX(), bounds.maxX(), across, level, columnCount[level], sheetsX[level])
                || isFolded(bounds.edgeY(), bounds.minY(), bounds.maxY(), down, level, rowCount[level], sheetsY[level]);
    }

    /** Cells of the arena. */
    private float across(int level) {
        return cells(bounds.maxX() - bounds.minX(), edge(top[level], bounds), bounds.edgeX());
    }

    private float down(int level) {
        return cells(bounds.maxY() - bounds.minY(), edge(top[level], bounds), bounds.edgeY());
    }

    /** Even if the axis wraps, so that colours fit at the seam. */
    private static float cells(float extent, float edge, AxisEdge at) {
        return switch (at) {
            case WALL -> extent / edge;
            case OPEN -> Float.POSITIVE_INFINITY;
            case WRAP -> (int) (extent / edge) & ~1;
        };
    }

    private void layOutEdges(int level, float across, float down) {
        float open = 2f * speculativeDistance(top[level]);
        scaleX[level] = inverseEdge[level];
        scaleY[level] = inverseEdge[level];
        unitsX[level] = RingCells.unitsOfCell(open);
        unitsY[level] = unitsX[level];
        if (bounds.edgeX() == AxisEdge.WRAP) {
            columnCount[level] = Math.min(columnCount[level], (int) across);
            sheetsX[level] = (int) across / columnCount[level];
            scaleX[level] = sheetsX[level] * columnCount[level] / bounds.periodX();
        } else if (bounds.edgeX() == AxisEdge.OPEN) {
            scaleX[level] = RingCells.unitsPerLength(open);
        }
        if (bounds.edgeY() == AxisEdge.WRAP) {
            rowCount[level] = Math.min(rowCount[level], (int) down);
            sheetsY[level] = (int) down / rowCount[level];
            scaleY[level] = sheetsY[level] * rowCount[level] / bounds.periodY();
        } else if (bounds.edgeY() == AxisEdge.OPEN) {
            scaleY[level] = RingCells.unitsPerLength(open);
        }
        columnsUsed[level] = columnCount[level];
        rowsUsed[level] = rowCount[level];
    }

    private boolean isFolded(AxisEdge edge, float min, float max, float cells, int level, int side, int sheets) {
        return switch (edge) {
            case WALL -> Math.min(Cells.cell(max, min, inverseEdge[level]), cells) >= WRAPS * side;
            case OPEN -> cells >= WRAPS * side;
            case WRAP -> sheets > WRAPS;
        };
    }

    private static int side(int sideLog, float cells, int[] primes) {
        return sideLog < LEAST_PRIME_SIDE_LOG || cells <= WRAPS << sideLog
                ? 1 << sideLog
                : primes[sideLog - LEAST_PRIME_SIDE_LOG];
    }

    private int cellsUsed(float max, float min, int level, int side) {
        return Math.min(Cells.cell(max, min, inverseEdge[level]), side - 1) + 1;
    }

    /** A contact's greatest distance, and what rounding adds: 3 x 3 cells have all that a circle may touch. */
    private static float edge(float greatestRadius, Bounds bounds) {
        return 2f * speculativeDistance(greatestRadius) + bounds.magnitude() * 0x1p-20f;
    }

    public float reach(int level) {
        return speculativeDistance(top[level]) + bounds.magnitude() * 0x1p-20f;
    }

    private static float speculativeDistance(float radius) {
        return radius * (1f + Tuning.MARGIN + Tuning.CAP);
    }

    private static int sideLog(float cells) {
        int side = LEAST_SIDE_LOG;
        while (side < GREATEST_SIDE_LOG && cells > 1 << side) {
            side++;
        }
        return side;
    }

    public void copy(GridLevels other) {
        for (int k = 0; k < arrays.length; k++) {
            System.arraycopy(other.arrays[k], 0, arrays[k], 0, COUNT);
        }
        hasStatics = other.hasStatics;
        bounds = other.bounds;
        usedCount = other.usedCount;
        buckets = other.buckets;
        rows = other.rows;
        minX = other.minX;
        minY = other.minY;
        rmax = other.rmax;
    }

    public int buckets() {
        return buckets;
    }

    /** With several levels, one more for each circle. */
    public int groups(int circles) {
        return usedCount == 1 ? buckets : buckets + circles;
    }

    public int level(float r) {
        return levelOf[Cells.sizeClass(r, rmax)];
    }

    public int column(float x, int level) {
        AxisEdge edge = bounds.edgeX();
        return edge == AxisEdge.WALL
                ? onRing(Cells.cell(x, minX, inverseEdge[level]), columnCount[level])
                : RingCells.onRing(RingCells.cell(edge, x, minX, scaleX[level], unitsX[level]), columnCount[level]);
    }

    public int row(float y, int level) {
        AxisEdge edge = bounds.edgeY();
        return edge == AxisEdge.WALL
                ? onRing(Cells.cell(y, minY, inverseEdge[level]), rowCount[level])
                : RingCells.onRing(RingCells.cell(edge, y, minY, scaleY[level], unitsY[level]), rowCount[level]);
    }

    /** Whether buckets are not in the order of ids. */
    public boolean haveSheets() {
        boolean some = hasStatics;
        for (int l = 0; l < usedCount; l++) {
            some |= folded[used[l]];
        }
        return some;
    }

    public int sheetX(float x, int level) {
        AxisEdge edge = bounds.edgeX();
        return edge == AxisEdge.WALL
                ? Cells.cell(x, minX, inverseEdge[level]) / columnCount[level]
                : RingCells.sheet(
                        RingCells.cell(edge, x, minX, scaleX[level], unitsX[level]),
                        columnCount[level],
                        sheetsX[level]);
    }

    public int sheetY(float y, int level) {
        AxisEdge edge = bounds.edgeY();
        return edge == AxisEdge.WALL
                ? Cells.cell(y, minY, inverseEdge[level]) / rowCount[level]
                : RingCells.sheet(
                        RingCells.cell(edge, y, minY, scaleY[level], unitsY[level]), rowCount[level], sheetsY[level]);
    }

    public static int sheetBeside(int sheet, int offset, int sheets) {
        return sheets == ENDLESS ? sheet + offset : neighbour(sheet, offset, sheets);
    }

    /** Even, 0 if not folded; static circles have the odd number behind it. */
    public int sheetKey(int level, int sheetX, int sheetY) {
        return folded[level] ? 2 * (sheetX * SHEET_X_FACTOR + sheetY * SHEET_Y_FACTOR) : 0;
    }

    public int sheetKey(float x, float y, int level) {
        return folded[level] ? sheetKey(level, sheetX(x, level), sheetY(y, level)) : 0;
    }

    /** Where a range begins, before {@link #onRing}. */
    public int columnFrom(float x, int level) {
        return bounds.edgeX() == AxisEdge.WALL ? Cells.cell(x, minX, inverseEdge[level]) : column(x, level);
    }

    /** Where it ends, at most once around the torus. */
    public int columnTo(float from, float to, int level) {
        AxisEdge edge = bounds.edgeX();
        return edge == AxisEdge.WALL
                ? Cells.cell(to, minX, inverseEdge[level])
                : last(edge, from, to, minX, scaleX[level], unitsX[level], columnCount[level]);
    }

    public int rowFrom(float y, int level) {
        return bounds.edgeY() == AxisEdge.WALL ? Cells.cell(y, minY, inverseEdge[level]) : row(y, level);
    }

    public int rowTo(float from, float to, int level) {
        AxisEdge edge = bounds.edgeY();
        return edge == AxisEdge.WALL
                ? Cells.cell(to, minY, inverseEdge[level])
                : last(edge, from, to, minY, scaleY[level], unitsY[level], rowCount[level]);
    }

    private static int last(AxisEdge edge, float from, float to, float min, float scale, int units, int side) {
        long first = RingCells.cell(edge, from, min, scale, units);
        long more = RingCells.cell(edge, to, min, scale, units) - first;
        return RingCells.onRing(first, side) + (int) Math.min(more, side);
    }

    public static int onRing(int cell, int side) {
        return cell < side ? cell : cell % side;
    }

    /** At an offset of -1, 0 or 1. */
    public static int neighbour(int column, int offset, int side) {
        int moved = column + offset;
        return moved < 0 ? side - 1 : moved < side ? moved : 0;
    }

    public int rowStart(int level, int row) {
        return first[level] + (row << columnsLog[level]);
    }

    /** Of an axis without walls. A cell of an open axis has a whole number of units, powers of two, so it is exact however far out. */
    private static final class RingCells {
        private static final int LEAST_UNITS_LOG = 10;

        private static final float MOST_UNITS = 0x1p62f;

        static float unitsPerLength(float edge) {
            return Math.scalb(1f, LEAST_UNITS_LOG - Math.getExponent(edge));
        }

        static int unitsOfCell(float edge) {
            return (int) (edge * unitsPerLength(edge)) + 2;
        }

        /** Scales are units per length, or cells if the axis wraps. */
        static long cell(AxisEdge edge, float x, float min, float scale, int units) {
            return edge == AxisEdge.OPEN
                    ? Math.floorDiv((long) CircleMath.clamp(x * scale, -MOST_UNITS, MOST_UNITS), (long) units)
                    : (long) Math.floor(CircleMath.clamp((x - min) * scale, -Cells.MOST, Cells.MOST));
        }

        static int onRing(long cell, int side) {
            return (int) Math.floorMod(cell, (long) side);
        }

        static int sheet(long cell, int side, int sheets) {
            long sheet = Math.floorDiv(cell, (long) side);
            return (int) (sheets == GridLevels.ENDLESS ? sheet : Math.floorMod(sheet, (long) sheets));
        }
    }
}
