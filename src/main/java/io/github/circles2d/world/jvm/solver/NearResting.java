package io.github.circles2d.world.jvm.solver;

import static io.github.circles2d.world.model.CircleRow.RADIUS;
import static io.github.circles2d.world.model.CircleRow.X;
import static io.github.circles2d.world.model.CircleRow.Y;

import io.github.circles2d.world.jvm.grid.Candidates;
import io.github.circles2d.world.jvm.grid.Grid;
import io.github.circles2d.world.jvm.grid.PairFilter;
import io.github.circles2d.world.jvm.state.Resting;
import io.github.circles2d.world.jvm.state.State;
import io.github.circles2d.world.jvm.threads.Team;
import io.github.circles2d.world.model.CircleRow;
import io.github.circles2d.world.model.GridLevels;
import io.github.circles2d.world.model.PairRule;
import io.github.circles2d.world.model.Paths;
import io.github.circles2d.world.model.StepConstants;
import java.util.Arrays;

/** The circles that rest and are near to one that does not: their speculative distances meet. Each step finds them before its contacts. */
public final class NearResting {
    /** Bits of an entry of {@link #list} for the way from a circle to the one that rests. */
    private static final int WAY_LOG = 3;

    /** In one level: whether the way is to a lesser column, or to a lesser row. */
    static final int LEFT = 1;

    static final int DOWN = 2;

    /** The one that rests is of a coarser level. */
    static final int COARSER = 4;

    static final int FINER = 5;

    private final State state;
    private final Grid grid;
    private final GridLevels levels;
    private final Candidates candidates;
    private final Team team;
    private final Resting.Found[] found;

    /** By worker: what it has found. */
    private final int[][] ofWorker;

    private final int[] many;

    /** By slot: its first entry in {@link #list}; one more element for the end. */
    private int[] first = new int[1];

    private int[] list = new int[0];

    /** By worker: ids of circles that rest and have the lower id of a contact. */
    private final int[][] lower;

    private final int[] lowerCount;

    private final Team.Work lookAll = this::lookAll;
    private final Team.Work copy = this::copy;
    private final Team.Work begin = this::begin;
    private final Team.Work clearCounts = this::clearCounts;
    private final Team.Work count = this::count;

    /** By worker: the greatest number of candidates that one of its circles has. */
    private final int[] mostCandidates;

    private StepConstants constants;

    NearResting(State state, Grid grid, GridLevels levels, Candidates candidates, Team team) {
        this.state = state;
        this.grid = grid;
        this.levels = levels;
        this.candidates = candidates;
        this.team = team;
        found = new Resting.Found[team.most()];
        ofWorker = new int[team.most()][64];
        many = new int[team.most()];
        mostCandidates = new int[team.most()];
        lower = new int[team.most()][64];
        lowerCount = new int[team.most()];
        for (int worker = 0; worker < found.length; worker++) {
            found[worker] = new Resting.Found();
        }
    }

    /** Whether there are any circles that rest. */
    public boolean areAny() {
        return state.awake < state.n;
    }

    void ensure() {
        if (areAny() && first.length <= state.awake) {
            first = new int[state.awake + 1 + (state.awake >> 2)];
        }
        for (Resting.Found each : found) {
            each.tested = 0;
        }
    }

    long bytes() {
        long sum = 4L * (first.length + list.length);
        for (int worker = 0; worker < found.length; worker++) {
            sum += 4L * (ofWorker[worker].length + found[worker].slots.length + lower[worker].length);
        }
        return sum;
    }

    /** Circles whose distance was tested. */
    long tested() {
        long sum = 0;
        for (int w = 0; w < team.size(); w++) {
            sum += found[w].tested;
        }
        return sum;
    }

    /** Finds them. */
    void find() {
        team.all(lookAll);
        int all = before(team.size());
        if (list.length < all) {
            list = new int[all + (all >> 2)];
        }
        first[state.awake] = all;
        team.all(copy);
    }

    private void lookAll(int worker) {
        many[worker] = 0;
        int to = team.part(state.awake, worker + 1);
        for (int slot = team.part(state.awake, worker); slot < to; slot++) {
            first[slot] = many[worker];
            if (!state.isStatic(slot)) {
                look(worker, slot);
            }
        }
    }

    private void copy(int worker) {
        int before = before(worker);
        System.arraycopy(ofWorker[worker], 0, list, before, many[worker]);
        int to = team.part(state.awake, worker + 1);
        for (int slot = team.part(state.awake, worker); slot < to; slot++) {
            first[slot] += before;
        }
    }

    /** Makes them ready for the contacts of the step, behind continuous collision. */
    void begin(StepConstants k) {
        constants = k;
        team.all(begin);
    }

    /** Several workers may have found a circle. */
    private void begin(int worker) {
        int end = first[team.part(state.awake, worker + 1)];
        for (int entry = first[team.part(state.awake, worker)]; entry < end; entry++) {
            int other = slot(entry);
            candidates.clear(other, other + 1);
            Arrays.fill(state.load, CircleRow.of(other), CircleRow.of(other + 1), 0f);
            if (constants.turning) {
                state.turning.begin(other, other + 1);
            }
        }
    }

    private int before(int worker) {
        int sum = 0;
        for (int w = 0; w < worker; w++) {
            sum += many[w];
        }
        return sum;
    }

    private void look(int worker, int slot) {
        float x = state.circle[CircleRow.of(slot) + X];
        float y = state.circle[CircleRow.of(slot) + Y];
        float far = grid.speculativeDistance[slot];
        Resting.Found near = found[worker];
        state.resting.find(near, levels.bounds, x - far, x + far, y - far, y + far);
        for (int n = 0; n < near.count; n++) {
            int other = near.slots[n];
            float otherFar = Paths.speculativeDistance(state.circle[CircleRow.of(other) + RADIUS], 0f);
            if (PairRule.isNear(state.differenceX(slot, other), state.differenceY(slot, other), far, otherFar) != 0) {
                grid.describeResting(other);
                add(worker, other << WAY_LOG | way(slot, other));
            }
        }
    }

    private void add(int worker, int entry) {
        int count = many[worker]++;
        if (count == ofWorker[worker].length) {
            ofWorker[worker] = Arrays.copyOf(ofWorker[worker], 2 * count);
        }
        ofWorker[worker][count] = entry;
    }

    private int way(int slot, int other) {
        int level = grid.level[slot];
        if (grid.level[other] != level) {
            return grid.level[other] < level ? COARSER : FINER;
        }
        float[] circle = state.circle;
        int s = CircleRow.of(slot);
        int o = CircleRow.of(other);
        int left = GridLevels.neighbour(levels.column(circle[s + X], level), -1, levels.columnCount[level]);
        int down = GridLevels.neighbour(levels.row(circle[s + Y], level), -1, levels.rowCount[level]);
        return (levels.column(circle[o + X], level) == left ? LEFT : 0)
                + (levels.row(circle[o + Y], level) == down ? DOWN : 0);
    }

    /** The first entry of a slot; of the slot behind it: the end. */
    public int first(int slot) {
        return first[slot];
    }

    public int slot(int entry) {
        return list[entry] >> WAY_LOG;
    }

    int way(int entry) {
        return list[entry] & (1 << WAY_LOG) - 1;
    }

    /** Gathers the pairs of some slots with those that rest some way from them, in cells of one level. */
    void gather(FoundPairs f, int from, int to, int way) {
        if (first[from] == first[to]) {
            return;
        }
        for (int slot = from; slot < to; slot++) {
            int end = first[slot + 1];
            for (int entry = first[slot]; entry < end; entry++) {
                if (way(entry) == way && !f.overflowed) {
                    int other = slot(entry);
                    if (candidates.keeps(slot, other)) {
                        f.gather(slot, state.id[slot], other, state.id[other]);
                    }
                }
            }
        }
    }

    /** Counts the candidates of circles in a crowd and of those that rest near to them; returns the greatest number. */
    int countAll() {
        team.all(clearCounts);
        team.all(count);
        int most = 0;
        for (int w = 0; w < team.size(); w++) {
            most = Math.max(most, mostCandidates[w]);
        }
        return most;
    }

    private void clearCounts(int worker) {
        int to = first[team.part(state.awake, worker + 1)];
        for (int entry = first[team.part(state.awake, worker)]; entry < to; entry++) {
            candidates.clear(slot(entry), slot(entry) + 1);
        }
    }

    private void count(int worker) {
        int most = 0;
        int to = team.part(state.awake, worker + 1);
        for (int slot = team.part(state.awake, worker); slot < to; slot++) {
            for (int entry = first[slot]; entry < first[slot + 1]; entry++) {
                if (PairFilter.mayMeet(state, slot, slot(entry))) {
                    most = Math.max(most, way(entry) == FINER ? 0 : candidates.count(slot, 1));
                    most = Math.max(most, way(entry) == COARSER ? 0 : candidates.countShared(slot(entry)));
                }
            }
        }
        mostCandidates[worker] = most;
    }

    // ---- impulses

    /** Before contacts are filled. */
    void beginContacts(int worker) {
        lowerCount[worker] = 0;
    }

    /** Takes note of a contact of which a circle that rests has the lower id. */
    void noteLower(int worker, int slot) {
        int count = lowerCount[worker]++;
        if (count == lower[worker].length) {
            lower[worker] = Arrays.copyOf(lower[worker], 2 * count);
        }
        lower[worker][count] = state.id[slot];
    }

    /** Once all contacts are filled: impulses of the step before are gone. */
    void settle() {
        state.resting.forgetImpulses();
        for (int w = 0; w < team.size(); w++) {
            for (int n = 0; n < lowerCount[w]; n++) {
                state.resting.unsettle(lower[w][n]);
            }
        }
    }
}
