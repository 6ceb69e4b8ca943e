package io.github.circles2d.world.model;

/** Of an axis without walls. A cell of an open axis has a whole number of units, powers of two, so it is exact however far out. */
final class RingCells {
    private static final int LEAST_UNITS_LOG = 10;

    private static final float MOST_UNITS = 0x1p62f;

    private RingCells() {}

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
