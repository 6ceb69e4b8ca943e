package io.github.circles2d.world.jvm.grid;

import static io.github.circles2d.world.model.CircleRow.X;
import static io.github.circles2d.world.model.CircleRow.Y;

import io.github.circles2d.world.jvm.state.State;
import io.github.circles2d.world.jvm.threads.SharedInts;
import io.github.circles2d.world.model.Cells;
import io.github.circles2d.world.model.CircleRow;
import io.github.circles2d.world.model.GridLevels;
import io.github.circles2d.world.model.Tuning;
import java.util.Arrays;

/**
 * Counts the candidate pairs of each circle, in its own level and in coarser ones. In a crowd, the count decides which pairs are
 * kept.
 */
public final class Candidates {
    private final State state;
    private final Grid grid;
    private final GridLevels levels;

    /** By slot: the number of pairs. */
    private int[] count = new int[0];

    /** Whether only a share of the pairs of a crowd is kept. */
    private boolean thinned;

    public Candidates(State state, Grid grid, GridLevels levels) {
        this.state = state;
        this.grid = grid;
        this.levels = levels;
    }

    public void ensure() {
        if (count.length < state.capacity()) {
            count = new int[state.capacity()];
        }
        thinned = false;
    }

    public long bytes() {
        return 4L * count.length;
    }

    public void clear(int from, int to) {
        Arrays.fill(count, from, to, 0);
    }

    /** From here on only a share of the pairs of a crowd is kept. */
    public void thinOut() {
        thinned = true;
    }

    public boolean thinned() {
        return thinned;
    }

    /** Whether a pair of circles that are near to each other is listed: not if they may not meet, and maybe not in a crowd. */
    public boolean keeps(int slot, int other) {
        if (!PairFilter.mayMeet(state, slot, other)) {
            state.noteSeen(slot, other);
            return false;
        }
        if (!thinned) {
            return true;
        }
        int fewer = Math.min(count[slot], count[other]);
        if (fewer <= Tuning.CROWD) {
            return true;
        }
        int id = state.id[slot];
        int otherId = state.id[other];
        return Cells.keeps(Cells.pairHash(Math.min(id, otherId), Math.max(id, otherId)), fewer);
    }

    /** Counts a contact for its circles, which are of one level; no other worker has any of the same. Returns the greater number. */
    public int countContact(int lo, int hi) {
        return Math.max(++count[lo], ++count[hi]);
    }

    /** Counts what a circle has found in coarser levels, unless all has been counted before. Returns its number. */
    public int countFound(int slot, int pairs) {
        return count(slot, thinned ? 0 : pairs);
    }

    /** Counts pairs of a circle that no other worker counts for; returns its number. */
    public int count(int slot, int pairs) {
        count[slot] += pairs;
        return count[slot];
    }

    /** As {@link #countFound} of one pair of a circle for which other workers may count, too. */
    public int countFoundShared(int slot) {
        return thinned ? count[slot] : countShared(slot);
    }

    /** Counts a pair of a circle for which other workers may count, too; returns its number so far. */
    public int countShared(int slot) {
        return SharedInts.getAndAdd(count, slot, 1) + 1;
    }

    /**
     * Counts the pairs of some circles without a list: every circle looks at all cells around it. Returns the greatest number.
     *
     * @param near room to work in
     */
    public int countAll(Nearby cells, NearSlots near, int from, int to) {
        int most = 0;
        for (int slot = from; slot < to; slot++) {
            int level = grid.level[slot];
            int sum = 0;
            for (int k = levels.usedCount - 1; k >= 0 && levels.used[k] <= level; k--) {
                sum += countInLevel(cells, near, slot, levels.used[k]);
            }
            count[slot] = sum;
            most = Math.max(most, sum);
        }
        return most;
    }

    private int countInLevel(Nearby cells, NearSlots near, int slot, int level) {
        float x = state.circle[CircleRow.of(slot) + X];
        float y = state.circle[CircleRow.of(slot) + Y];
        cells.beginAround(level, x, y, !state.isStatic(slot));
        int sum = 0;
        while (cells.next()) {
            near.count = 0;
            near.scan(state, grid, slot, cells.from, cells.to);
            for (int k = 0; k < near.count; k++) {
                int other = near.slots[k];
                sum += other != slot && PairFilter.mayMeet(state, slot, other) ? 1 : 0;
            }
        }
        return sum;
    }
}
