package io.github.circles2d.world.jvm.grid;

import static io.github.circles2d.world.model.CircleRow.X;
import static io.github.circles2d.world.model.CircleRow.Y;

import io.github.circles2d.world.jvm.state.State;
import io.github.circles2d.world.jvm.threads.SharedInts;
import io.github.circles2d.world.jvm.threads.Team;
import io.github.circles2d.world.model.CircleRow;
import io.github.circles2d.world.model.GridLevels;
import io.github.circles2d.world.model.PairRule;
import java.util.Arrays;

/**
 * The circles of {@linkplain GridLevels folded} levels, in cells about as wide as circles are apart. Around a long path {@link Grid} has
 * many cells of such a level, each with circles that are far away; here there are few cells, with circles that are near. If the circles
 * of a level lie close together, such cells are full, and this grid does not {@linkplain #holds hold} the level. It holds none in a world
 * with an axis that has no walls. A cell is a list in no order, so no result may depend on one.
 */
final class SparseGrid {
    private static final int NONE = -1;

    /** Cells for each circle. */
    private static final int CELLS = 2;

    /** How many circles share a cell with one, in the mean and itself counted, up to which a level is held. It changes the time alone. */
    private static final int CROWDED = 4;

    private final State state;
    private final Grid grid;
    private final GridLevels levels;
    private final Team team;

    /** By cell: the slot that came last. */
    private int[] last = new int[0];

    /** By cell: the number of circles. */
    private int[] count = new int[0];

    /** By slot: the one that came before it to its cell. */
    private int[] before = new int[0];

    private int cells;

    // by level
    private final int[] first = new int[GridLevels.COUNT];
    private final int[] columns = new int[GridLevels.COUNT];
    private final int[] rows = new int[GridLevels.COUNT];
    private final float[] scaleX = new float[GridLevels.COUNT];
    private final float[] scaleY = new float[GridLevels.COUNT];

    /** By worker and level: the pairs of circles of one cell that it has made, each with itself and with those before. */
    private final long[][] pairs;

    /** By level. */
    private final boolean[] held = new boolean[GridLevels.COUNT];

    /** By worker: slots near the one that is looked at. */
    private final int[][] hits;

    SparseGrid(State state, Grid grid, GridLevels levels, Team team) {
        this.state = state;
        this.grid = grid;
        this.levels = levels;
        this.team = team;
        pairs = new long[team.most()][GridLevels.COUNT];
        hits = new int[team.most()][64];
    }

    /** Lays out the cells of the step's levels. */
    void ensure() {
        cells = 0;
        for (int l = 0; l < levels.usedCount; l++) {
            int level = levels.used[l];
            columns[level] = 0;
            if (levels.folded[level] && levels.bounds.isWalled()) {
                layOut(level, CELLS * levels.population[level]);
            }
        }
        if (last.length < cells) {
            int c = cells + (cells >> 2);
            count = new int[c];
            last = new int[c];
        }
        if (cells > 0 && before.length < state.capacity()) {
            before = new int[state.capacity()];
        }
    }

    private void layOut(int level, int many) {
        float width = levels.bounds.maxX() - levels.bounds.minX();
        float height = levels.bounds.maxY() - levels.bounds.minY();
        float edge = (float) Math.sqrt((double) width * height / many);
        columns[level] = Math.max(1, (int) Math.min(width / edge, many));
        rows[level] = Math.max(1, (int) Math.min(height / edge, many / columns[level]));
        scaleX[level] = columns[level] / width;
        scaleY[level] = rows[level] / height;
        first[level] = cells;
        cells += columns[level] * rows[level];
    }

    long bytes() {
        long sum = 4L * (last.length + count.length + before.length);
        for (int[] each : hits) {
            sum += 4L * each.length;
        }
        return sum;
    }

    void clear(int worker) {
        int from = team.part(cells, worker);
        int to = team.part(cells, worker + 1);
        Arrays.fill(last, from, to, NONE);
        Arrays.fill(count, from, to, 0);
        Arrays.fill(pairs[worker], 0);
    }

    /** Puts circles into their cells. */
    void add(int worker, int from, int to) {
        if (cells == 0) {
            return;
        }
        boolean shared = team.size() > 1;
        long[] sums = pairs[worker];
        for (int slot = from; slot < to; slot++) {
            int level = grid.level[slot];
            if (columns[level] == 0) {
                continue;
            }
            int s = CircleRow.of(slot);
            int cell = first[level]
                    + row(state.circle[s + Y], level) * columns[level]
                    + column(state.circle[s + X], level);
            if (shared) {
                before[slot] = SharedInts.getAndSet(last, cell, slot);
                sums[level] += 2 * SharedInts.getAndAdd(count, cell, 1) + 1;
            } else {
                before[slot] = last[cell];
                last[cell] = slot;
                sums[level] += 2 * count[cell]++ + 1;
            }
        }
    }

    /** Decides which levels are held; behind {@link #add} of all workers. */
    void settle() {
        for (int l = 0; l < levels.usedCount; l++) {
            int level = levels.used[l];
            long sum = 0;
            for (int w = 0; w < team.size(); w++) {
                sum += pairs[w][level];
            }
            held[level] = columns[level] > 0 && sum <= (long) CROWDED * levels.population[level];
        }
    }

    /** Whether {@link #find} finds the circles of a level. */
    boolean holds(int level) {
        return held[level];
    }

    /** The slots that were found last. */
    int[] hits(int worker) {
        return hits[worker];
    }

    /**
     * Finds the circles of a level that is held in a rectangle, and some beside it, whose reach meets that of one. The one is among them
     * if it is of the level.
     *
     * @param reach by slot
     * @return how many {@link #hits} there are
     */
    int find(int worker, int slot, int level, float left, float right, float low, float high, float[] reach) {
        float[] circle = state.circle;
        float x = circle[CircleRow.of(slot) + X];
        float y = circle[CircleRow.of(slot) + Y];
        float own = reach[slot];
        int c0 = column(left, level);
        int c1 = column(right, level);
        int r1 = row(high, level);
        int[] next = before;
        int[] near = hits[worker];
        int found = 0;
        for (int row = row(low, level); row <= r1; row++) {
            int rowStart = first[level] + row * columns[level];
            for (int cell = rowStart + c0; cell <= rowStart + c1; cell++) {
                for (int other = last[cell]; other != NONE; other = next[other]) {
                    if (found == near.length) {
                        near = Arrays.copyOf(near, 2 * found);
                        hits[worker] = near;
                    }
                    near[found] = other;
                    found -= PairRule.isNear(
                            circle[CircleRow.of(other) + X] - x,
                            circle[CircleRow.of(other) + Y] - y,
                            own,
                            reach[other]);
                }
            }
        }
        return found;
    }

    /** Never falls where x grows; circles outside of the walls are in the cells at these. */
    private int column(float x, int level) {
        return cell((x - levels.minX) * scaleX[level], columns[level]);
    }

    private int row(float y, int level) {
        return cell((y - levels.minY) * scaleY[level], rows[level]);
    }

    private static int cell(float place, int many) {
        return Math.max(0, Math.min((int) place, many - 1));
    }
}
