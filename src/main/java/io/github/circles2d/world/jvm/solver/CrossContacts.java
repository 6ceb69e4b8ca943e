package io.github.circles2d.world.jvm.solver;

import static io.github.circles2d.world.model.CircleRow.INVERSE_MASS;
import static io.github.circles2d.world.model.CircleRow.X;
import static io.github.circles2d.world.model.CircleRow.Y;

import io.github.circles2d.world.jvm.grid.Ahead;
import io.github.circles2d.world.jvm.grid.Candidates;
import io.github.circles2d.world.jvm.grid.Grid;
import io.github.circles2d.world.jvm.grid.NearSlots;
import io.github.circles2d.world.jvm.grid.Nearby;
import io.github.circles2d.world.jvm.state.State;
import io.github.circles2d.world.jvm.state.Sums;
import io.github.circles2d.world.jvm.threads.SharedInts;
import io.github.circles2d.world.jvm.threads.Team;
import io.github.circles2d.world.model.CircleRow;
import io.github.circles2d.world.model.CrossRule;
import io.github.circles2d.world.model.GridLevels;
import java.util.Arrays;

/**
 * Finds the cross contacts: those of circles of different levels. Each circle looks in every coarser level in which continuous collision
 * has not looked for it ({@link Ahead}).
 *
 * <p>One of the two circles is the light one, the other the heavy one ({@link CrossRule}). Cross contacts lie in the order of the
 * slots of their light circles, and those of one light circle in the order of the ids of the heavy ones.
 */
final class CrossContacts {
    private final State state;
    private final Grid grid;
    private final GridLevels levels;
    private final Candidates candidates;
    private final Team team;
    private final Sums sums;
    private final FoundCross[] found;
    private final Nearby[] nearby;
    private final Ahead[] ahead;
    private final NearResting resting;

    /** The circles that are heavy in some contact. */
    final HeavyCircles heavyCircles;

    /** By level: how far from their centres its circles look at most. */
    private final float[] reach = new float[GridLevels.COUNT];

    /** By slot: the first contact in which it is the light circle; one more element for the end. */
    private int[] lightStart = new int[1];

    /** By slot: the sum of what the contacts add in which it is the heavy circle; 0 if there are none. */
    private int[] load = new int[0];

    /** By slot of a heavy circle: its number among those. */
    private int[] number = new int[0];

    /** By contact: the slot of the light circle. */
    private int[] light = new int[0];

    /** By contact: id and slot of the heavy circle, one above the other. */
    private long[] heavy = new long[0];

    private final Team.Work clear = this::clear;
    private final Team.Work findAll = this::findAll;
    private final Team.Work countHeavyCircles = this::countHeavyCircles;
    private final Team.Work place = this::place;
    private final Team.Work numberAll = this::numberAll;

    CrossContacts(
            State state,
            Grid grid,
            GridLevels levels,
            Candidates candidates,
            Team team,
            Nearby[] nearby,
            Ahead[] ahead,
            NearResting resting) {
        this.state = state;
        this.grid = grid;
        this.levels = levels;
        this.candidates = candidates;
        this.team = team;
        this.nearby = nearby;
        this.ahead = ahead;
        this.resting = resting;
        sums = new Sums(team);
        heavyCircles = new HeavyCircles(state, team);
        found = new FoundCross[team.most()];
        for (int worker = 0; worker < found.length; worker++) {
            found[worker] = new FoundCross();
        }
    }

    void ensure() {
        if (levels.usedCount > 1 && number.length < state.capacity()) {
            lightStart = new int[state.capacity() + 1];
            load = new int[state.capacity()];
            number = new int[state.capacity()];
        }
        for (int l = 0; l < levels.usedCount; l++) {
            reach[levels.used[l]] = levels.reach(levels.used[l]);
        }
    }

    long bytes() {
        long sum = 4L * (lightStart.length + load.length + number.length + light.length) + 8L * heavy.length;
        for (FoundCross f : found) {
            sum += f.bytes();
        }
        return sum + heavyCircles.bytes();
    }

    /** Number of contacts; 0 where there is one level. */
    int count() {
        return levels.usedCount < 2 ? 0 : lightStart[state.awake];
    }

    int lightSlot(int contact) {
        return light[contact];
    }

    int heavySlot(int contact) {
        return (int) heavy[contact];
    }

    /** The number of a contact's heavy circle among the heavy ones; all that rest have the one behind the last. */
    int heavyNumber(int contact) {
        return rests(contact) ? heavyCircles.count : number[heavySlot(contact)];
    }

    private boolean rests(int contact) {
        return heavySlot(contact) >= state.awake;
    }

    /** The number of a slot among the heavy circles; -1 if it is heavy in no contact. */
    int numberOf(int slot) {
        return load[slot] == 0 ? -1 : number[slot];
    }

    /** By how much the heavy circle of a contact counts as lighter. */
    float share(int contact) {
        return rests(contact) ? 1f : CrossRule.crossShare(load[heavySlot(contact)]);
    }

    /** The first contact whose light circle lies in a slot or behind it. */
    int firstOf(int slot) {
        return lightStart[slot];
    }

    /** Finds the cross contacts; nothing where there is one level. If there are many, they are given up unless all are listed. */
    void find(boolean all) {
        for (int w = 0; w < team.size(); w++) {
            found[w].begin(all ? Integer.MAX_VALUE : Contacts.room(to(w) - from(w)));
        }
        if (levels.usedCount < 2) {
            return;
        }
        team.all(clear);
        team.all(findAll);
        if (overflowed()) {
            return;
        }
        team.all(countHeavyCircles);
        ensureContacts();
        sums.sumUp(lightStart, state.awake);
        heavyCircles.ensure(heavyCirclesBefore(team.size()));
        team.all(place);
        team.all(numberAll);
    }

    private int from(int worker) {
        return team.part(state.awake, worker);
    }

    private int to(int worker) {
        return team.part(state.awake, worker + 1);
    }

    private void clear(int worker) {
        Arrays.fill(lightStart, from(worker), to(worker), 0);
        Arrays.fill(load, from(worker), to(worker), 0);
    }

    private void findAll(int worker) {
        FoundCross f = found[worker];
        ahead[worker].rewind();
        for (int round = 0; round < team.rounds(); round++) {
            int end = team.to(state.awake, worker, round);
            for (int slot = team.from(state.awake, worker, round); slot < end && !f.overflowed; slot++) {
                find(f, nearby[worker], ahead[worker], slot);
            }
        }
    }

    private void countHeavyCircles(int worker) {
        int sum = 0;
        int to = to(worker);
        for (int slot = from(worker); slot < to; slot++) {
            sum += load[slot] != 0 ? 1 : 0;
        }
        found[worker].heavyCircles = sum;
    }

    private void place(int worker) {
        FoundCross f = found[worker];
        for (int k = 0; k < f.count; k++) {
            int c = lightStart[f.light[k]] + f.rank[k];
            light[c] = f.light[k];
            heavy[c] = f.heavy[k];
        }
    }

    private void numberAll(int worker) {
        numberHeavyCircles(heavyCirclesBefore(worker), from(worker), to(worker));
        if (anyFromFiner()) {
            order(from(worker), to(worker));
        }
    }

    /** Room of a worker for slots, outside of {@link #find}. */
    NearSlots near(int worker) {
        return found[worker].near;
    }

    /** Whether the contacts were given up because there are too many. */
    boolean overflowed() {
        for (int w = 0; w < team.size(); w++) {
            if (found[w].overflowed) {
                return true;
            }
        }
        return false;
    }

    /** Greatest number of contacts that one circle found. */
    int mostFound() {
        int most = 0;
        for (int w = 0; w < team.size(); w++) {
            most = Math.max(most, found[w].most);
        }
        return most;
    }

    private void ensureContacts() {
        long sum = 0;
        for (int w = 0; w < team.size(); w++) {
            sum += found[w].count;
        }
        if (sum > heavy.length) {
            int c = Math.toIntExact(sum + (sum >> 2));
            light = new int[c];
            heavy = new long[c];
        }
    }

    private int heavyCirclesBefore(int worker) {
        int sum = 0;
        for (int w = 0; w < worker; w++) {
            sum += found[w].heavyCircles;
        }
        return sum;
    }

    private void numberHeavyCircles(int first, int from, int to) {
        int next = first;
        for (int slot = from; slot < to; slot++) {
            if (load[slot] != 0) {
                number[slot] = next;
                heavyCircles.set(next++, slot);
            }
        }
    }

    private boolean anyFromFiner() {
        for (int w = 0; w < team.size(); w++) {
            if (found[w].anyFromFiner) {
                return true;
            }
        }
        return false;
    }

    /** Orders the contacts of each light circle by the ids of the heavy ones. */
    private void order(int from, int to) {
        for (int slot = from; slot < to; slot++) {
            if (lightStart[slot + 1] - lightStart[slot] > 1) {
                Arrays.sort(heavy, lightStart[slot], lightStart[slot + 1]);
            }
        }
    }

    private int countIn(int[] counts, int slot, int more) {
        if (team.size() > 1) {
            return SharedInts.getAndAdd(counts, slot, more);
        }
        int before = counts[slot];
        counts[slot] = before + more;
        return before;
    }

    /** Finds the contacts of a circle with those of coarser levels. */
    private void find(FoundCross f, Nearby near, Ahead seen, int slot) {
        int before = f.count;
        int level = grid.level[slot];
        int fromFiner = 0;
        int seenNow = seen.take(state, grid, f.near, slot);
        f.tested += Math.max(seenNow, 0);
        int left = seenNow < 0 ? levels.usedCount : seen.left();
        for (int k = left - 1; k >= 0 && levels.used[k] < level; k--) {
            findInCoarserLevel(f, near, slot, levels.used[k]);
        }
        boolean rest = resting.areAny() && resting.first(slot) < resting.first(slot + 1);
        if (f.near.count == 0 && !rest) {
            f.most = Math.max(f.most, candidates.countFound(slot, 0));
            return;
        }
        float w = state.traits[CircleRow.of(slot) + INVERSE_MASS];
        for (int k = 0; k < f.near.count; k++) {
            int other = f.near.slots[k];
            if (!candidates.keeps(slot, other)) {
                continue;
            }
            float v = state.traits[CircleRow.of(other) + INVERSE_MASS];
            if (CrossRule.isFinerLight(w, v)) {
                f.add(slot, (long) state.id[other] << 32 | other);
                countIn(load, other, CrossRule.loadOfHeavy(w, v));
            }
        }
        int fromResting = rest ? addResting(f, slot) : 0;
        f.sort(before);
        int own = f.count - before;
        f.rank(before, own == 0 ? 0 : countIn(lightStart, slot, own));
        for (int k = 0; k < f.near.count; k++) {
            int other = f.near.slots[k];
            float v = state.traits[CircleRow.of(other) + INVERSE_MASS];
            if (!CrossRule.isFinerLight(w, v) && candidates.keeps(slot, other)) {
                f.addFromFiner(other, (long) state.id[slot] << 32 | slot, countIn(lightStart, other, 1));
                countIn(load, slot, CrossRule.loadOfHeavy(v, w));
                fromFiner++;
            }
        }
        f.near.count = 0;
        f.most = Math.max(f.most, candidates.countFound(slot, own + fromFiner - fromResting));
    }

    /** Adds the contacts of a circle with those that rest in other levels; returns how many of these are finer. */
    private int addResting(FoundCross f, int slot) {
        int finer = 0;
        for (int entry = resting.first(slot); entry < resting.first(slot + 1); entry++) {
            int other = resting.slot(entry);
            if (resting.way(entry) >= NearResting.COARSER && candidates.keeps(slot, other)) {
                f.add(slot, (long) state.id[other] << 32 | other);
                if (resting.way(entry) == NearResting.FINER) {
                    finer++;
                    f.most = Math.max(f.most, candidates.countFoundShared(other));
                }
            }
        }
        return finer;
    }

    /** Looks in the cells of a coarser level in which a circle may lie whose speculative distance meets that of this one. */
    private void findInCoarserLevel(FoundCross f, Nearby near, int slot, int level) {
        if (!levels.folded[level] && !(grid.hasSheets() && state.isStatic(slot))) {
            findInRows(f, slot, level);
            return;
        }
        float x = state.circle[CircleRow.of(slot) + X];
        float y = state.circle[CircleRow.of(slot) + Y];
        boolean withStatics = !state.isStatic(slot);
        if (levels.bounds.isWalled()) {
            float far = grid.speculativeDistance[slot] + reach[level];
            near.begin(level, x - far, x + far, y - far, y + far, withStatics);
        } else {
            near.beginAround(level, x, y, withStatics);
        }
        while (near.next()) {
            scan(f, slot, near.from, near.to);
        }
    }

    /** The same row by row: a walk that knows of sheets takes longer. */
    private void findInRows(FoundCross f, int slot, int level) {
        float x = state.circle[CircleRow.of(slot) + X];
        float y = state.circle[CircleRow.of(slot) + Y];
        int columns = levels.columnCount[level];
        int rows = levels.rowCount[level];
        if (!levels.bounds.isWalled()) {
            int column = GridLevels.neighbour(levels.column(x, level), -1, columns);
            int row = GridLevels.neighbour(levels.row(y, level), -1, rows);
            scan(f, slot, level, column, 3, row, 3);
            return;
        }
        float far = grid.speculativeDistance[slot] + reach[level];
        int column = levels.columnFrom(x - far, level);
        int row = levels.rowFrom(y - far, level);
        scan(
                f,
                slot,
                level,
                GridLevels.onRing(column, columns),
                Math.min(levels.columnTo(x - far, x + far, level) - column + 1, columns),
                GridLevels.onRing(row, rows),
                Math.min(levels.rowTo(y - far, y + far, level) - row + 1, rows));
    }

    /** Looks in so many columns and rows of a level, from a first one of each on. */
    private void scan(FoundCross f, int slot, int level, int firstColumn, int manyColumns, int firstRow, int manyRows) {
        int[] start = grid.start;
        int columns = levels.columnCount[level];
        int rows = levels.rowCount[level];
        int behindSeam = firstColumn + manyColumns - columns;
        int row = firstRow;
        for (int k = 0; k < manyRows; k++) {
            int b = levels.rowStart(level, row);
            if (behindSeam <= 0) {
                scan(f, slot, start[b + firstColumn], start[b + firstColumn + manyColumns]);
            } else {
                scan(f, slot, start[b + firstColumn], start[b + columns]);
                scan(f, slot, start[b], start[b + behindSeam]);
            }
            row = row + 1 < rows ? row + 1 : 0;
        }
    }

    private void scan(FoundCross f, int slot, int from, int to) {
        if (from < to) {
            f.near.scan(state, grid, slot, from, to);
            f.tested += to - from;
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
}
