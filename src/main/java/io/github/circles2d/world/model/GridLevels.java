package io.github.circles2d.world.model;

/**
 * The shape of the grids: one per level of radii, each on a torus. A level is a size class, which spans a factor of two, or two of
 * them if the smaller does not outnumber the larger by far. Fewer levels mean fewer stages, but many small circles in a grid for a
 * few large ones would have many neighbours. The host decides from the bounds, the greatest radius and the number of circles of
 * each size class; the shape is the same for every back end.
 *
 * <p>A level's torus has W columns and H rows of buckets. The cell (cx, cy) lies in column cx mod W and row cy mod H: far cells
 * may share a bucket, which costs time and nothing else, because the distance of two circles decides. So memory is bounded by the
 * number of circles, however small they are and however large the arena is: rounded up to powers of two, W and H are at
 * least 4, no more than the arena needs, and their product is at most twice the number of circles.
 *
 * <p>W (or H) is this power of two if the arena has at most four times as many columns (or rows): then few cells share a
 * bucket. In a wider arena it is twice a prime, and another prime for rows than for columns. With powers of two, a square
 * lattice of circles that are 128 cells apart would lie in a few buckets. With two primes, a square lattice does only if its
 * spacing is a multiple of both primes; if it is a multiple of one, the other prime is the least number of buckets in use.
 * Other patterns remain, as in every torus: a line of circles goes round in a few buckets.
 *
 * <p>So a bucket keeps the circles of different cells apart. The torus lies on the arena in sheets: the sheet of a cell is its column
 * div W and its row div H. A level of many sheets is {@link #folded}: there a bucket has its circles in the order of {@link #sheetKey}.
 * A circle looks at the sheet of a cell alone, or at the whole bucket if that has {@link #FEW}. Static circles come last in a sheet, of
 * any level, and a static circle stops where they begin.
 *
 * <p>This is for axes with walls. An open axis counts as infinitely wide. Along an axis that wraps, the arena is a whole number
 * of times as many cells wide as the torus has columns, so that the torus goes round where space does; {@link RingCells} has
 * both.
 *
 * <p>In memory, a row of buckets begins at a multiple of the power of two. For OpenCL, groups of contacts are numbered so that
 * those of one colour are consecutive: the group (ox, oy) has colour (ox mod 2) + 2 (oy mod 2) and is number
 * (oy / 2)(V / 2) + ox / 2 within its colour, where V is that power of two.
 */
public final class GridLevels {
    /** Number of size classes, and so of levels at most: with factors of two, they span all radii that a world takes. */
    public static final int COUNT = 20;

    private static final int LEAST_SIDE_LOG = 2;

    private static final int GREATEST_SIDE_LOG = 15;

    /** A circle that is not static looks at a bucket of no more circles as a whole, which is faster than to look for its sheet. */
    public static final int FEW = 2;

    /** A number of sheets: they never begin again. */
    public static final int ENDLESS = 0;

    /** What a sheet along x counts in {@link #sheetKey}. Odd, and without a pattern in common with that along y: two sheets of one
     * key are tens of thousands of sheets apart.
     */
    public static final int SHEET_X_FACTOR = 0x9e3779b1;

    /** The same along y. */
    public static final int SHEET_Y_FACTOR = 0x85ebca77;

    /** How many times as many columns (or rows) as the torus an arena has before it is made for lattices and lines. */
    private static final int WRAPS = 4;

    /** Sides below this are powers of two in any case. */
    private static final int LEAST_PRIME_SIDE_LOG = 4;

    /** By log2 of the next power of two, from {@link #LEAST_PRIME_SIDE_LOG} on: columns of the torus in a wide arena. */
    private static final int[] PRIME_COLUMNS = {
        2 * 7, 2 * 13, 2 * 31, 2 * 61, 2 * 127, 2 * 251, 2 * 509, 2 * 1021, 2 * 2039, 2 * 4093, 2 * 8191, 2 * 16381
    };

    /** The same for rows. */
    private static final int[] PRIME_ROWS = {
        2 * 5, 2 * 11, 2 * 29, 2 * 59, 2 * 113, 2 * 241, 2 * 503, 2 * 1019, 2 * 2029, 2 * 4091, 2 * 8179, 2 * 16369
    };

    /** Level of each size class ({@link Cells#sizeClass}): the number of the class itself, or of the next larger one. */
    public final int[] levelOf = new int[COUNT];

    /** Circles of each level. */
    final int[] population = new int[COUNT];

    /** 1 / edge of a cell, by level. */
    public final float[] inverseEdge = new float[COUNT];

    /** log2 of the number of columns, rounded up to a power of two, by level. */
    public final int[] columnsLog = new int[COUNT];

    /** log2 of the number of rows, rounded up to a power of two, by level. */
    public final int[] rowsLog = new int[COUNT];

    /** Number of columns of the torus, by level. */
    public final int[] columnCount = new int[COUNT];

    /** Number of rows of the torus, by level. */
    public final int[] rowCount = new int[COUNT];

    /** Columns that circles can be in, by level: less than all of them where the torus is larger than the arena. */
    public final int[] columnsUsed = new int[COUNT];

    /** Rows that circles can be in, by level. */
    public final int[] rowsUsed = new int[COUNT];

    /** Number of the first bucket, and of the first group, of each level. */
    public final int[] first = new int[COUNT];

    /** Number of the first row of buckets of each level, where the rows of all levels are counted as their buckets are. */
    public final int[] firstRow = new int[COUNT];

    /** Numbers of the levels that have circles, finest first: the order in which their buckets are numbered. */
    public final int[] used = new int[COUNT];

    /** Greatest radius of each level. */
    public final float[] top = new float[COUNT];

    /** Units or cells per length along x, by level: of an axis without walls by {@link RingCells}. */
    public final float[] scaleX = new float[COUNT];

    /** The same along y. */
    public final float[] scaleY = new float[COUNT];

    /** Units of a cell along x, by level, if x is open. */
    public final int[] unitsX = new int[COUNT];

    /** The same along y. */
    public final int[] unitsY = new int[COUNT];

    /**
     * Whether many far cells share a bucket, by level: along some axis the torus goes round more than {@link #WRAPS} times. Otherwise a
     * bucket has few circles unless they lie close anyway, and to keep them apart would cost more than to look at them.
     */
    public final boolean[] folded = new boolean[COUNT];

    /** Number of sheets along x after which they begin again, by level; {@link #ENDLESS} but for an axis that wraps. */
    public final int[] sheetsX = new int[COUNT];

    /** The same along y. */
    public final int[] sheetsY = new int[COUNT];

    /** Whether any circle is static. */
    public boolean hasStatics;

    /** Where the levels are. */
    public Bounds bounds = new Bounds(0, 0, 1, 1);

    public int usedCount;
    public int buckets;
    public int rows;
    public float minX;
    public float minY;
    public float rmax;

    /** No levels, until they are laid out. */
    public GridLevels() {}

    /**
     * Lays the grids out.
     *
     * @param bounds the arena
     * @param greatestRadius greatest radius of all circles
     * @param counts number of circles of each size class
     * @param someStatic whether any circle is static
     */
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

    private void join(int[] counts) {
        for (int k = 0; k < COUNT; k++) {
            boolean joins = k > 0 && levelOf[k - 1] == k - 1 && counts[k] <= (long) Tuning.JOIN * counts[k - 1];
            levelOf[k] = joins ? k - 1 : k;
            population[k] = 0;
            population[levelOf[k]] += counts[k];
        }
    }

    private void layOutLevel(int level, Bounds bounds) {
        float edge = edge(top[level], bounds);
        inverseEdge[level] = 1f / edge;
        float across = cells(bounds.maxX() - bounds.minX(), edge, bounds.edgeX());
        float down = cells(bounds.maxY() - bounds.minY(), edge, bounds.edgeY());
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
        sheetsX[level] = ENDLESS;
        sheetsY[level] = ENDLESS;
        if (!bounds.isWalled()) {
            layOutEdges(level, across, down);
        }
        folded[level] = isFolded(
                        bounds.edgeX(), bounds.minX(), bounds.maxX(), level, columnCount[level], sheetsX[level])
                || isFolded(bounds.edgeY(), bounds.minY(), bounds.maxY(), level, rowCount[level], sheetsY[level]);
    }

    /** Cells along an axis: any number if it is open, and an even one if it wraps, so that the colours of groups fit at the seam.
     */
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

    private boolean isFolded(AxisEdge edge, float min, float max, int level, int side, int sheets) {
        return switch (edge) {
            case WALL -> Cells.cell(max, min, inverseEdge[level]) >= WRAPS * side;
            case OPEN -> true;
            case WRAP -> sheets > WRAPS;
        };
    }

    private static int side(int sideLog, float cells, int[] primes) {
        return sideLog < LEAST_PRIME_SIDE_LOG || cells <= WRAPS << sideLog
                ? 1 << sideLog
                : primes[sideLog - LEAST_PRIME_SIDE_LOG];
    }

    /** Cells from the one of the lower wall to the one of the upper, where there are as many: no base is outside the walls. */
    private int cellsUsed(float max, float min, int level, int side) {
        return Math.min(Cells.cell(max, min, inverseEdge[level]), side - 1) + 1;
    }

    /**
     * A cell is at least as wide as the greatest distance at which two of its level are listed, plus what the rounding of
     * coordinates can move two circles apart: then whatever a circle may touch lies in 3 x 3 cells.
     */
    private static float edge(float greatestRadius, Bounds bounds) {
        return 2f * speculativeDistance(greatestRadius) + bounds.magnitude() * 0x1p-20f;
    }

    /** What a circle of a level looks from its centre at most, and what the rounding of coordinates can move two circles apart. */
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

    /** Takes the shape of another. */
    public void copy(GridLevels other) {
        System.arraycopy(other.levelOf, 0, levelOf, 0, COUNT);
        System.arraycopy(other.population, 0, population, 0, COUNT);
        System.arraycopy(other.inverseEdge, 0, inverseEdge, 0, COUNT);
        System.arraycopy(other.columnsLog, 0, columnsLog, 0, COUNT);
        System.arraycopy(other.rowsLog, 0, rowsLog, 0, COUNT);
        System.arraycopy(other.columnCount, 0, columnCount, 0, COUNT);
        System.arraycopy(other.rowCount, 0, rowCount, 0, COUNT);
        System.arraycopy(other.columnsUsed, 0, columnsUsed, 0, COUNT);
        System.arraycopy(other.rowsUsed, 0, rowsUsed, 0, COUNT);
        System.arraycopy(other.scaleX, 0, scaleX, 0, COUNT);
        System.arraycopy(other.scaleY, 0, scaleY, 0, COUNT);
        System.arraycopy(other.unitsX, 0, unitsX, 0, COUNT);
        System.arraycopy(other.unitsY, 0, unitsY, 0, COUNT);
        System.arraycopy(other.folded, 0, folded, 0, COUNT);
        System.arraycopy(other.sheetsX, 0, sheetsX, 0, COUNT);
        System.arraycopy(other.sheetsY, 0, sheetsY, 0, COUNT);
        hasStatics = other.hasStatics;
        bounds = other.bounds;
        System.arraycopy(other.first, 0, first, 0, COUNT);
        System.arraycopy(other.firstRow, 0, firstRow, 0, COUNT);
        System.arraycopy(other.used, 0, used, 0, COUNT);
        System.arraycopy(other.top, 0, top, 0, COUNT);
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

    /** Number of groups of contacts: as many as buckets; if there are several levels, one for each circle more. */
    public int groups(int circles) {
        return usedCount == 1 ? buckets : buckets + circles;
    }

    /** Level of a radius. */
    public int level(float r) {
        return levelOf[Cells.sizeClass(r, rmax)];
    }

    /** The column of the torus of a coordinate. */
    public int column(float x, int level) {
        AxisEdge edge = bounds.edgeX();
        return edge == AxisEdge.WALL
                ? onRing(Cells.cell(x, minX, inverseEdge[level]), columnCount[level])
                : RingCells.onRing(RingCells.cell(edge, x, minX, scaleX[level], unitsX[level]), columnCount[level]);
    }

    /** The row of the torus of a coordinate. */
    public int row(float y, int level) {
        AxisEdge edge = bounds.edgeY();
        return edge == AxisEdge.WALL
                ? onRing(Cells.cell(y, minY, inverseEdge[level]), rowCount[level])
                : RingCells.onRing(RingCells.cell(edge, y, minY, scaleY[level], unitsY[level]), rowCount[level]);
    }

    /** Whether the circles of a bucket are in the order of sheets, or of whether they are static: else of their ids alone. */
    public boolean haveSheets() {
        boolean some = hasStatics;
        for (int l = 0; l < usedCount; l++) {
            some |= folded[used[l]];
        }
        return some;
    }

    /** The sheet of a coordinate along x. */
    public int sheetX(float x, int level) {
        AxisEdge edge = bounds.edgeX();
        return edge == AxisEdge.WALL
                ? Cells.cell(x, minX, inverseEdge[level]) / columnCount[level]
                : RingCells.sheet(
                        RingCells.cell(edge, x, minX, scaleX[level], unitsX[level]),
                        columnCount[level],
                        sheetsX[level]);
    }

    /** The sheet of a coordinate along y. */
    public int sheetY(float y, int level) {
        AxisEdge edge = bounds.edgeY();
        return edge == AxisEdge.WALL
                ? Cells.cell(y, minY, inverseEdge[level]) / rowCount[level]
                : RingCells.sheet(
                        RingCells.cell(edge, y, minY, scaleY[level], unitsY[level]), rowCount[level], sheetsY[level]);
    }

    /** The sheet that is at (0), behind (1) or before (-1) another, of so many or {@link #ENDLESS}. */
    public static int sheetBeside(int sheet, int offset, int sheets) {
        return sheets == ENDLESS ? sheet + offset : neighbour(sheet, offset, sheets);
    }

    /**
     * What the circles of a bucket are ordered by: an even number for each sheet, or 0 in a level that is not folded. Static circles have
     * the odd number behind it. Two sheets seldom have one key, which costs time and nothing else.
     */
    public int sheetKey(int level, int sheetX, int sheetY) {
        return folded[level] ? 2 * (sheetX * SHEET_X_FACTOR + sheetY * SHEET_Y_FACTOR) : 0;
    }

    /** The same of the sheet of a place. */
    public int sheetKey(float x, float y, int level) {
        return folded[level] ? sheetKey(level, sheetX(x, level), sheetY(y, level)) : 0;
    }

    /** The column of a coordinate where a range begins; {@link #onRing} gives that of the torus. */
    public int columnFrom(float x, int level) {
        return bounds.edgeX() == AxisEdge.WALL ? Cells.cell(x, minX, inverseEdge[level]) : column(x, level);
    }

    /** The column where a range ends that begins at a coordinate; behind the first one by as many as the torus has, or fewer. */
    public int columnTo(float from, float to, int level) {
        AxisEdge edge = bounds.edgeX();
        return edge == AxisEdge.WALL
                ? Cells.cell(to, minX, inverseEdge[level])
                : last(edge, from, to, minX, scaleX[level], unitsX[level], columnCount[level]);
    }

    /** The row of a coordinate where a range begins; {@link #onRing} gives that of the torus. */
    public int rowFrom(float y, int level) {
        return bounds.edgeY() == AxisEdge.WALL ? Cells.cell(y, minY, inverseEdge[level]) : row(y, level);
    }

    /** The row where a range ends that begins at a coordinate; behind the first one by as many as the torus has, or fewer. */
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

    /** The column (or row) of the torus of a cell's column (or row). */
    public static int onRing(int cell, int side) {
        return cell < side ? cell : cell % side;
    }

    /** The column (or row) of the torus that is at (0), behind (1) or before (-1) another. */
    public static int neighbour(int column, int offset, int side) {
        int moved = column + offset;
        return moved < 0 ? side - 1 : moved < side ? moved : 0;
    }

    /** Number of the bucket before which a row of buckets begins. */
    public int rowStart(int level, int row) {
        return first[level] + (row << columnsLog[level]);
    }
}
