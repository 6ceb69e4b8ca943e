package io.github.circles2d.world.jvm.solver;

import static io.github.circles2d.world.model.CircleRow.X;
import static io.github.circles2d.world.model.CircleRow.Y;

import io.github.circles2d.world.jvm.grid.Candidates;
import io.github.circles2d.world.jvm.grid.Grid;
import io.github.circles2d.world.jvm.state.State;
import io.github.circles2d.world.model.CircleRow;
import io.github.circles2d.world.model.GridLevels;
import io.github.circles2d.world.model.PairRule;

/**
 * Finds the pairs of circles of one level whose speculative distances meet. Each group finds, in its 2 x 2 cells, the pairs whose
 * lesser column and lesser row are its own, so each pair is found once, in the group of its contact.
 */
public final class Pairs {
    /** Circles that are tested against another in one go. */
    private static final int BLOCK = 64;

    private final State state;
    private final Grid grid;
    private final GridLevels levels;

    private final Candidates candidates;
    private final NearResting resting;

    Pairs(State state, Grid grid, GridLevels levels, Candidates candidates, NearResting resting) {
        this.state = state;
        this.grid = grid;
        this.levels = levels;
        this.candidates = candidates;
        this.resting = resting;
    }

    /** Pairs near to each other, a few at a time: slot of the one above slot of the other. */
    static long[] newHits() {
        return new long[2 * BLOCK];
    }

    /** Gathers the pairs of a group. */
    void find(FoundPairs f, int level, int column, int row) {
        int[] start = grid.start;
        int nextColumn = GridLevels.neighbour(column, 1, levels.columnCount[level]);
        int own = levels.rowStart(level, row);
        int above = levels.rowStart(level, GridLevels.neighbour(row, 1, levels.rowCount[level]));
        int from = start[own + column];
        int to = start[own + column + 1];
        int rightFrom = start[own + nextColumn];
        int rightTo = start[own + nextColumn + 1];
        int aboveFrom = start[above + column];
        int aboveTo = start[above + column + 1];
        if (resting.areAny()) {
            resting.gather(f, from, to, 0);
            resting.gather(f, rightFrom, rightTo, NearResting.LEFT);
            resting.gather(f, aboveFrom, aboveTo, NearResting.DOWN);
            int beyond = above + nextColumn;
            resting.gather(f, start[beyond], start[beyond + 1], NearResting.LEFT | NearResting.DOWN);
        }
        if (grid.hasSheets()
                && !(grid.isPlain(from, to, level)
                        && grid.isPlain(rightFrom, rightTo, level)
                        && grid.isPlain(aboveFrom, aboveTo, level)
                        && grid.isPlain(start[above + nextColumn], start[above + nextColumn + 1], level))) {
            gather(f, findBySheet(f, level, column, row));
            return;
        }
        int count = 0;
        for (int slot = rightFrom; slot < rightTo; slot++) {
            count = scan(f, count, slot, aboveFrom, aboveTo);
        }
        if (nextColumn > 0) {
            int aboveRightTo = start[above + nextColumn + 1];
            for (int slot = from; slot < to; slot++) {
                count = scan(f, count, slot, slot + 1, rightTo);
                count = scan(f, count, slot, aboveFrom, aboveRightTo);
            }
        } else {
            for (int slot = from; slot < to; slot++) {
                count = scan(f, count, slot, slot + 1, to);
                count = scan(f, count, slot, rightFrom, rightTo);
                count = scan(f, count, slot, aboveFrom, aboveTo);
                count = scan(f, count, slot, start[above], start[above + 1]);
            }
        }
        gather(f, count);
    }

    /** The same sheet by sheet. Static circles, the last of a sheet, are tested against those that are not alone. */
    private int findBySheet(FoundPairs f, int level, int column, int row) {
        int[] start = grid.start;
        int nextColumn = GridLevels.neighbour(column, 1, levels.columnCount[level]);
        int nextRow = GridLevels.neighbour(row, 1, levels.rowCount[level]);
        int own = levels.rowStart(level, row);
        int from = start[own + column];
        int to = start[own + column + 1];
        int rightFrom = start[own + nextColumn];
        int rightTo = start[own + nextColumn + 1];
        if (from == to && rightFrom == rightTo) {
            return 0; // every pair has a circle in the group's own row
        }
        int overX = nextColumn == 0 ? 1 : 0;
        int overY = nextRow == 0 ? 1 : 0;
        int above = levels.rowStart(level, nextRow);
        int aboveFrom = start[above + column];
        int aboveTo = start[above + column + 1];
        int beyondFrom = start[above + nextColumn];
        int beyondTo = start[above + nextColumn + 1];
        int count = 0;
        int restTo = to - from <= GridLevels.FEW ? to : 0;
        for (int slot = from; slot < to; ) {
            int moving = grid.movingEnd(slot, to, grid.sheet(slot));
            int end = levels.hasStatics ? grid.sheetEnd(moving, to, grid.sheet(slot)) : moving;
            if (slot < moving) {
                int restEnd = Math.max(end, restTo);
                long right = grid.slotsBeside(slot, overX, 0, rightFrom, rightTo);
                long up = grid.slotsBeside(slot, 0, overY, aboveFrom, aboveTo);
                long beyond = grid.slotsBeside(slot, overX, overY, beyondFrom, beyondTo);
                for (; slot < moving; slot++) {
                    count = scanBoth(f, count, slot, slot + 1, restEnd, Grid.from(right), Grid.to(right));
                    count = scanBoth(f, count, slot, Grid.from(up), Grid.to(up), Grid.from(beyond), Grid.to(beyond));
                }
            }
            if (slot < end) {
                long right = grid.movingBeside(slot, overX, 0, rightFrom, rightTo);
                long up = grid.movingBeside(slot, 0, overY, aboveFrom, aboveTo);
                long beyond = grid.movingBeside(slot, overX, overY, beyondFrom, beyondTo);
                for (; slot < end; slot++) {
                    count = scan(f, count, slot, Grid.from(right), Grid.to(right));
                    count = scanBoth(f, count, slot, Grid.from(up), Grid.to(up), Grid.from(beyond), Grid.to(beyond));
                }
            }
        }
        if (aboveFrom == aboveTo) {
            return count;
        }
        for (int slot = rightFrom; slot < rightTo; ) {
            int moving = grid.movingEnd(slot, rightTo, grid.sheet(slot));
            int end = levels.hasStatics ? grid.sheetEnd(moving, rightTo, grid.sheet(slot)) : moving;
            if (slot < moving) {
                long up = grid.slotsBeside(slot, -overX, overY, aboveFrom, aboveTo);
                for (; slot < moving; slot++) {
                    count = scan(f, count, slot, Grid.from(up), Grid.to(up));
                }
            }
            if (slot < end) {
                long up = grid.movingBeside(slot, -overX, overY, aboveFrom, aboveTo);
                for (; slot < end; slot++) {
                    count = scan(f, count, slot, Grid.from(up), Grid.to(up));
                }
            }
        }
        return count;
    }

    /** Tests a circle against slots of two ranges, together if the second lies behind the first. */
    private int scanBoth(FoundPairs f, int hitsBefore, int slot, int from, int to, int nextFrom, int nextTo) {
        if (to == nextFrom) {
            return scan(f, hitsBefore, slot, from, nextTo);
        }
        return scan(f, scan(f, hitsBefore, slot, from, to), slot, nextFrom, nextTo);
    }

    /** Tests a circle against slots [from, to); returns the number of hits that have not been gathered yet. */
    private int scan(FoundPairs f, int hitsBefore, int slot, int from, int to) {
        if (state.wraps) {
            return scanTheShortWay(f, hitsBefore, slot, from, to);
        }
        float[] circle = state.circle;
        float[] speculativeDistance = grid.speculativeDistance;
        long[] hits = f.hits;
        float x = circle[CircleRow.of(slot) + X];
        float y = circle[CircleRow.of(slot) + Y];
        float own = speculativeDistance[slot] + f.slack;
        int count = hitsBefore;
        for (int begin = from; begin < to; begin += BLOCK) {
            int end = Math.min(to, begin + BLOCK);
            for (int other = begin; other < end; other++) {
                float dx = circle[CircleRow.of(other) + X] - x;
                float dy = circle[CircleRow.of(other) + Y] - y;
                hits[count] = (long) slot << 32 | other;
                count -= PairRule.isNear(dx, dy, own, speculativeDistance[other]);
            }
            f.tested += end - begin;
            if (count > BLOCK) {
                gather(f, count);
                count = 0;
            }
        }
        return count;
    }

    /** As {@link #scan} where an axis wraps. */
    private int scanTheShortWay(FoundPairs f, int hitsBefore, int slot, int from, int to) {
        float own = grid.speculativeDistance[slot];
        int count = hitsBefore;
        for (int other = from; other < to; other++) {
            f.hits[count] = (long) slot << 32 | other;
            count -= PairRule.isNear(
                    state.differenceX(slot, other),
                    state.differenceY(slot, other),
                    own,
                    grid.speculativeDistance[other]);
            if (count > BLOCK) {
                gather(f, count);
                count = 0;
            }
        }
        f.tested += to - from;
        return count;
    }

    private void gather(FoundPairs f, int count) {
        int[] id = state.id;
        for (int k = 0; k < count && !f.overflowed; k++) {
            int slot = (int) (f.hits[k] >>> 32);
            int other = (int) f.hits[k];
            if (f.slack > 0f || candidates.keeps(slot, other)) {
                f.gather(slot, id[slot], other, id[other]);
            }
        }
    }
}
