package io.github.circles2d.bench.broadphase;

import java.util.Arrays;

/**
 * Some circles in the square cells of a torus, by a counting sort. Cells that are a whole torus apart share a bucket, so memory
 * depends on the number of circles alone, wherever they are; the distance decides about pairs.
 *
 * <p>A cell is at least as wide as the greatest sum of two reaches: what a circle may touch lies in 3 x 3 cells. A circle is
 * paired with those behind it in its own cell, with those of the cell to the right, and of the three cells above.
 *
 * <p>Bytes: 24 per circle to count (x, y, its number, its cell written and the cell's count read and written), 48 to scatter, 4
 * per cell to clear and 8 to sum up, 12 per test, 8 per range of cells.
 */
final class CellGrid {
    private static final int LEAST_SIDE = 4;

    final Sorted sorted = new Sorted();

    /** Numbers of the circles, the members of this grid. */
    private final int[] members;

    private final int[] cellOf;

    /** By cell: its first place; one more element for the end. */
    private final int[] start;

    private final float inverseEdge;
    private final int side;
    private final int mask;
    private final Counts counts;

    /**
     * Lays out a grid.
     *
     * @param members numbers of its circles
     * @param greatest the greatest reach among them, or a greater one
     */
    CellGrid(int[] members, float greatest, Counts counts) {
        this.members = members;
        this.counts = counts;
        int least = LEAST_SIDE;
        while ((long) least * least < members.length) {
            least *= 2;
        }
        side = least;
        mask = side - 1;
        inverseEdge = 1 / (2 * greatest + BroadPhase.SLACK);
        cellOf = new int[members.length];
        start = new int[side * side + 1];
        sorted.ensure(members.length);
    }

    void sort(float[] x, float[] y, float[] reach) {
        Arrays.fill(start, 0);
        int n = members.length;
        for (int k = 0; k < n; k++) {
            int i = members[k];
            int cell = row(y[i]) * side + column(x[i]);
            cellOf[k] = cell;
            start[cell]++;
        }
        int end = 0;
        for (int cell = 0; cell < start.length; cell++) {
            end += start[cell];
            start[cell] = end;
        }
        for (int k = n - 1; k >= 0; k--) {
            int i = members[k];
            sorted.put(--start[cellOf[k]], i, x[i], y[i], reach[i]);
        }
        counts.bytes += 72L * n + 12L * start.length;
    }

    private int column(float x) {
        return (int) (x * inverseEdge) & mask;
    }

    private int row(float y) {
        return (int) (y * inverseEdge) & mask;
    }

    /** Adds the pairs of two circles of this grid. */
    void pairWithin(PairList pairs) {
        long tests = 0;
        for (int row = 0; row < side; row++) {
            int here = row * side;
            int above = (row + 1 & mask) * side;
            for (int column = 0; column < side; column++) {
                boolean atEdge = column == 0 || column == mask;
                int first = start[here + column];
                int end = start[here + column + 1];
                for (int k = first; k < end; k++) {
                    tests += atEdge
                            ? pairAtEdge(k, end, here, above, column, pairs)
                            : sorted.pair(k, k + 1, start[here + column + 2], pairs)
                                    + sorted.pair(k, start[above + column - 1], start[above + column + 2], pairs);
                }
            }
        }
        counts.tests += tests;
        counts.bytes += 12 * tests + 16L * members.length;
    }

    private int pairAtEdge(int place, int end, int here, int above, int column, PairList pairs) {
        return sorted.pair(place, place + 1, end, pairs)
                + pairWithCell(place, here + (column + 1 & mask), pairs)
                + pairWithCell(place, above + (column - 1 & mask), pairs)
                + pairWithCell(place, above + column, pairs)
                + pairWithCell(place, above + (column + 1 & mask), pairs);
    }

    private int pairWithCell(int place, int cell, PairList pairs) {
        return sorted.pair(place, start[cell], start[cell + 1], pairs);
    }

    /** Adds the pairs of a circle of this grid and one of another, whose reaches are smaller than any here may be. */
    void pairWith(CellGrid finer, float greatest, PairList pairs) {
        Sorted others = finer.sorted;
        long tests = 0;
        long ranges = 0;
        for (int k = 0; k < finer.members.length; k++) {
            float x = others.x[k];
            float y = others.y[k];
            float r = others.reach[k];
            float range = r + greatest + BroadPhase.SLACK;
            int columns = (int) ((x + range) * inverseEdge) - (int) ((x - range) * inverseEdge);
            int rows = (int) ((y + range) * inverseEdge) - (int) ((y - range) * inverseEdge);
            int column = column(x - range);
            int row = row(y - range);
            for (int v = 0; v <= rows; v++) {
                int here = (row + v & mask) * side;
                // The part of a row of cells that goes on at the other side of the torus is a second range.
                int last = column + columns;
                tests += others(others, k, start[here + column], start[here + Math.min(last, mask) + 1], pairs);
                if (last > mask) {
                    tests += others(others, k, start[here], start[here + last - side + 1], pairs);
                }
            }
            ranges += rows + 1;
        }
        counts.tests += tests;
        counts.bytes += 12 * tests + 12L * finer.members.length + 8 * ranges;
    }

    private int others(Sorted others, int k, int from, int to, PairList pairs) {
        return sorted.pair(others.x[k], others.y[k], others.reach[k], others.number[k], from, to, pairs);
    }
}
