package io.github.circles2d.world.model;

/**
 * The cells of an axis without walls. {@code kernels/world/stages/World.cl} has the same functions.
 *
 * <p>An open axis has any number of cells. Their edge is a whole number of units, and a unit is a power of two, so a coordinate's
 * cell is exact wherever it is: two circles that are near to each other are in one cell or in neighbours, even where coordinates
 * are coarse. A wrapped axis has a whole number of cells a period, which is a multiple of the columns (or rows) of the torus.
 */
final class RingCells {
    /** Units of the narrowest cell of an open axis. */
    private static final int LEAST_UNITS_LOG = 10;

    private static final float MOST_UNITS = 0x1p62f;
    private static final float MOST_CELLS = 0x1p30f;

    private RingCells() {}

    /** Units a length, of cells of an edge of an open axis: a power of two. */
    static float unitsPerLength(float edge) {
        return Math.scalb(1f, LEAST_UNITS_LOG - Math.getExponent(edge));
    }

    /** Units of a cell that is at least so wide. */
    static int unitsOfCell(float edge) {
        return (int) (edge * unitsPerLength(edge)) + 2;
    }

    /**
     * The number of the cell of a coordinate.
     *
     * @param edge of the axis, without walls
     * @param x coordinate
     * @param min where cell 0 of a wrapped axis begins
     * @param scale units, or cells of a wrapped axis, per length
     * @param units of a cell of an open axis
     */
    static long cell(AxisEdge edge, float x, float min, float scale, int units) {
        return edge == AxisEdge.OPEN
                ? Math.floorDiv((long) CircleMath.clamp(x * scale, -MOST_UNITS, MOST_UNITS), (long) units)
                : (long) Math.floor(CircleMath.clamp((x - min) * scale, -MOST_CELLS, MOST_CELLS));
    }

    /** The column (or row) of the torus of a cell. */
    static int onRing(long cell, int side) {
        return (int) Math.floorMod(cell, (long) side);
    }

    /** How many times the torus has gone round before a cell: any number, or of so many that begin again. */
    static int sheet(long cell, int side, int sheets) {
        long sheet = Math.floorDiv(cell, (long) side);
        return (int) (sheets == GridLevels.ENDLESS ? sheet : Math.floorMod(sheet, (long) sheets));
    }
}
