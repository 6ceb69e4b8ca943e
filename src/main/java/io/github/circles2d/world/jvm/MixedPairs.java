package io.github.circles2d.world.jvm;

import static io.github.circles2d.world.model.CircleRow.X;
import static io.github.circles2d.world.model.CircleRow.Y;

import io.github.circles2d.world.jvm.threads.Team;
import io.github.circles2d.world.model.CircleRow;
import io.github.circles2d.world.model.GridLevels;
import io.github.circles2d.world.model.PairRule;
import java.lang.invoke.MethodHandles;
import java.lang.invoke.VarHandle;
import java.util.Arrays;

/**
 * Finds the pairs of circles of different levels whose speculative distances meet. Each circle looks in 3 x 3 cells of every
 * coarser level, and a counting sort puts the pairs in the order of their groups.
 */
final class MixedPairs {
    private static final VarHandle INTS = MethodHandles.arrayElementVarHandle(int[].class);

    /** Ints per record. */
    private static final int STRIDE = 4;

    private static final int SLOT = 0;
    private static final int OTHER = 1;
    private static final int GROUP = 2;
    private static final int RANK = 3;

    private final State state;
    private final Grid grid;
    private final GridLevels levels;
    private final Candidates candidates;
    private final Team team;
    private final Sums sums;
    private final Found[] found;

    /** By group, which has the number of the bucket of its lesser column and row: its first pair; one more for the end. */
    private int[] start = new int[1];

    /** By pair: the slots of its circles, one above the other. */
    private long[] pairs = new long[0];

    MixedPairs(State state, Grid grid, GridLevels levels, Candidates candidates, Team team) {
        this.state = state;
        this.grid = grid;
        this.levels = levels;
        this.candidates = candidates;
        this.team = team;
        sums = new Sums(team);
        found = new Found[team.most()];
        for (int worker = 0; worker < found.length; worker++) {
            found[worker] = new Found();
        }
    }

    void ensure() {
        if (levels.usedCount > 1 && start.length <= levels.buckets()) {
            start = new int[levels.buckets() + 1 + (levels.buckets() >> 2)];
        }
    }

    /** Memory of the arrays. */
    long bytes() {
        long sum = 4L * start.length + 8L * pairs.length;
        for (Found f : found) {
            sum += 4L * f.records.length;
        }
        return sum;
    }

    /**
     * Finds all pairs; nothing where there is one level.
     *
     * @param room number of pairs a worker from which on they are given up
     */
    void find(int worker, int room) {
        Found f = found[worker];
        f.count = 0;
        f.tested = 0;
        if (levels.usedCount < 2) {
            return;
        }
        int groups = levels.buckets();
        Arrays.fill(start, team.part(groups, worker), team.part(groups, worker + 1), 0);
        team.sync(worker);
        f.room = room;
        int to = team.part(state.n, worker + 1);
        for (int slot = team.part(state.n, worker); slot < to && f.count <= room; slot++) {
            for (int k = levels.usedCount - 1; k >= 0 && levels.used[k] < grid.level[slot]; k--) {
                findInCoarserLevel(f, slot, levels.used[k]);
            }
        }
        team.sync(worker);
        if (overflowed()) {
            return;
        }
        if (worker == 0) {
            ensurePairs();
        }
        sums.sumUp(worker, start, groups);
        for (int k = 0; k < STRIDE * f.count; k += STRIDE) {
            pairs[start[f.records[k + GROUP]] + f.records[k + RANK]] =
                    (long) f.records[k + SLOT] << 32 | f.records[k + OTHER];
        }
        team.sync(worker);
    }

    /** Whether the pairs were given up because there are too many. */
    boolean overflowed() {
        for (int w = 0; w < team.size(); w++) {
            if (found[w].count > found[w].room) {
                return true;
            }
        }
        return false;
    }

    private void ensurePairs() {
        long sum = 0;
        for (int w = 0; w < team.size(); w++) {
            sum += found[w].count;
        }
        if (sum > pairs.length) {
            pairs = new long[Math.toIntExact(sum + (sum >> 2))];
        }
    }

    private void findInCoarserLevel(Found f, int slot, int level) {
        int[] bucketStart = grid.start;
        int column = grid.column(state.circle[CircleRow.of(slot) + X], level);
        int row = grid.row(state.circle[CircleRow.of(slot) + Y], level);
        int columns = levels.columnCount[level];
        int rows = levels.rowCount[level];
        for (int v = -1; v <= 1; v++) {
            int rowStart = levels.rowStart(level, GridLevels.neighbour(row, v, rows));
            int groupStart = levels.rowStart(level, GridLevels.neighbour(row, Math.min(v, 0), rows));
            for (int u = -1; u <= 1; u++) {
                int b = rowStart + GridLevels.neighbour(column, u, columns);
                int group = groupStart + GridLevels.neighbour(column, Math.min(u, 0), columns);
                scan(f, slot, bucketStart[b], bucketStart[b + 1], group);
            }
        }
    }

    private void scan(Found f, int slot, int from, int to, int group) {
        float[] speculativeDistance = grid.speculativeDistance;
        float own = speculativeDistance[slot];
        f.tested += to - from;
        for (int other = from; other < to; other++) {
            float dx = state.differenceX(slot, other);
            float dy = state.differenceY(slot, other);
            if (PairRule.isNear(dx, dy, own, speculativeDistance[other]) != 0 && candidates.keeps(slot, other)) {
                int rank = team.size() > 1 ? (int) INTS.getAndAdd(start, group, 1) : start[group]++;
                f.add(slot, other, group, rank);
            }
        }
    }

    /** Gathers the pairs of a group. */
    void gather(FoundPairs f, int group) {
        for (int k = start[group]; k < start[group + 1] && !f.overflowed; k++) {
            int slot = (int) (pairs[k] >>> 32);
            int other = (int) pairs[k];
            f.gather(slot, state.id[slot], other, state.id[other]);
        }
    }

    /** Pairs whose distance was tested. */
    long tested() {
        long sum = 0;
        for (int w = 0; w < team.size(); w++) {
            sum += found[w].tested;
        }
        return sum;
    }

    /** What one worker found: for each pair the two slots, the group, and the rank in the group. */
    private static final class Found {
        private int[] records = new int[STRIDE * 64];
        private int count;
        private int room;
        private long tested;

        private void add(int slot, int other, int group, int rank) {
            if (++count > room) {
                return;
            }
            int k = STRIDE * (count - 1);
            if (k == records.length) {
                records = Arrays.copyOf(records, 2 * records.length);
            }
            records[k + SLOT] = slot;
            records[k + OTHER] = other;
            records[k + GROUP] = group;
            records[k + RANK] = rank;
        }
    }
}
