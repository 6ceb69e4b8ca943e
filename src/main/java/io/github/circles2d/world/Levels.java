package io.github.circles2d.world;

/**
 * The shape of the grids: one a level of radii, each on a torus. A level is a size class, a factor of two, or two of them where
 * the smaller does not outnumber the larger by far: fewer levels are fewer stages, but many small circles in a grid made for
 * a few large ones would be many neighbours. Decided on the host from the bounds, the greatest radius
 * and the number of circles of each level; the same for every back end.
 *
 * <p>A level has W x H buckets, powers of two of at least 4, no more than the arena needs and about as many to twice as
 * many as it has circles. The cell (cx, cy) lies in bucket (cx mod W) + W (cy mod H): far cells may share a bucket, which
 * costs time and nothing else, because the distance of two circles decides. So memory is bounded by the number of circles,
 * however small they are and however large the arena is.
 *
 * <p>For OpenCL, groups of contacts are numbered so that those of one colour are consecutive: the group (ox, oy) has colour
 * (ox mod 2) + 2 (oy mod 2) and is number (oy / 2)(W / 2) + ox / 2 within its colour.
 */
public final class Levels {
    /** Number of size classes, and so of levels at most: with factors of two, they span all radii that a world takes. */
    public static final int COUNT = 20;

    private static final int LEAST_SIDE_LOG = 2;

    /** Level of each size class ({@link CircleMath#sizeClass}): the number of the class itself, or of the next larger one. */
    final int[] levelOf = new int[COUNT];

    /** Circles of each level. */
    final int[] population = new int[COUNT];

    /** 1 / edge of a cell, by level. */
    final float[] inverseEdge = new float[COUNT];

    /** log2 of the number of columns, by level. */
    final int[] columnsLog = new int[COUNT];

    /** log2 of the number of rows, by level. */
    final int[] rowsLog = new int[COUNT];

    /** Columns that circles can be in, by level: less than all of them where the torus is larger than the arena. */
    final int[] columnsUsed = new int[COUNT];

    /** Rows that circles can be in, by level. */
    final int[] rowsUsed = new int[COUNT];

    /** Number of the first bucket, and of the first group, of each level. */
    final int[] first = new int[COUNT];

    /** Number of the first row of buckets of each level, where the rows of all levels are counted as their buckets are. */
    final int[] firstRow = new int[COUNT];

    /** Numbers of the levels that have circles, finest first: the order in which their buckets are numbered. */
    final int[] used = new int[COUNT];

    /** Greatest radius of each level. */
    final float[] top = new float[COUNT];

    int usedCount;
    int buckets;
    int rows;
    float minX;
    float minY;
    float rmax;

    /** No levels, until they are laid out. */
    public Levels() {}

    /**
     * Lays the grids out.
     *
     * @param bounds the arena
     * @param greatestRadius greatest radius of all circles
     * @param counts number of circles of each size class
     */
    public void layOut(Bounds bounds, float greatestRadius, int[] counts) {
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
                rows += 1 << rowsLog[level];
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
        int columns = sideLog((bounds.maxX() - bounds.minX()) / edge);
        int rows = sideLog((bounds.maxY() - bounds.minY()) / edge);
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
        columnsUsed[level] = cellsUsed(bounds.maxX(), bounds.minX(), level, columns);
        rowsUsed[level] = cellsUsed(bounds.maxY(), bounds.minY(), level, rows);
    }

    /** Cells from the one of the lower wall to the one of the upper, where there are as many: no base is outside the walls. */
    private int cellsUsed(float max, float min, int level, int sideLog) {
        return Math.min(CircleMath.cell(max, min, inverseEdge[level]), (1 << sideLog) - 1) + 1;
    }

    /**
     * A cell is at least as wide as the greatest distance at which two of its level are listed, plus what the rounding of
     * coordinates can move two circles apart: then whatever a circle may touch lies in 3 x 3 cells.
     */
    private static float edge(float greatestRadius, Bounds bounds) {
        float reach = greatestRadius * (1f + Tuning.MARGIN + Tuning.CAP);
        return 2f * reach + bounds.magnitude() * 0x1p-20f;
    }

    private static int sideLog(float cells) {
        int side = LEAST_SIDE_LOG;
        while (side < 15 && cells > 1 << side) {
            side++;
        }
        return side;
    }

    /** Takes the shape of another. */
    void copy(Levels other) {
        System.arraycopy(other.levelOf, 0, levelOf, 0, COUNT);
        System.arraycopy(other.population, 0, population, 0, COUNT);
        System.arraycopy(other.inverseEdge, 0, inverseEdge, 0, COUNT);
        System.arraycopy(other.columnsLog, 0, columnsLog, 0, COUNT);
        System.arraycopy(other.rowsLog, 0, rowsLog, 0, COUNT);
        System.arraycopy(other.columnsUsed, 0, columnsUsed, 0, COUNT);
        System.arraycopy(other.rowsUsed, 0, rowsUsed, 0, COUNT);
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

    int buckets() {
        return buckets;
    }

    /** Level of a radius. */
    int level(float r) {
        return levelOf[CircleMath.sizeClass(r, rmax)];
    }

    /** Number of the bucket before which a row of buckets begins. */
    int rowStart(int level, int row) {
        return first[level] + (row << columnsLog[level]);
    }

    /** Number of the first group of a colour (0 to 4: colour 4 is the end). */
    int firstOfColour(int level, int colour) {
        return first[level] + (colour << (columnsLog[level] + rowsLog[level] - 2));
    }
}
