package io.github.circles2d.world;

import java.lang.invoke.MethodHandles;
import java.lang.invoke.VarHandle;
import java.util.Arrays;

/**
 * Stage Contacts: lists the pairs of circles that may meet within the step, and puts them in the one order that every sum
 * follows: by level of the larger circle, colour, group, lower id, higher id.
 *
 * <p>The group of a contact is the lesser column and the lesser row of the cells of its two circles, in the grid of the
 * contact's level. It touches circles of the 2 x 2 cells from there on, so groups whose columns and rows have the same
 * parities share no circle: such a colour can be solved in parallel, a group at a time, with no further colouring.
 */
final class JvmContacts {
    /** Floats a contact. */
    static final int STRIDE = 14;

    /** Difference of the bases, x. */
    static final int EX = 0;

    static final int EY = 1;

    /** Sum of the radii. */
    static final int SUM = 2;

    /** Restitution of the pair. */
    static final int E = 3;

    /** Inverse mass of the circle of lower id. */
    static final int W_LO = 4;

    static final int W_HI = 5;

    /** Greatest push-out speed. */
    static final int PUSH = 6;

    /** Normal. */
    static final int NX = 7;

    static final int NY = 8;

    /** Separation. */
    static final int S = 9;

    /** Accumulated impulse. */
    static final int LAMBDA = 10;

    /** Target speed of a bounce, between the two passes of a sub-step. */
    static final int BOUNCE = 11;

    /** Effective mass. */
    static final int MASS = 12;

    /** Square of the bounce threshold. */
    static final int THRESHOLD = 13;

    private static final VarHandle INTS = MethodHandles.arrayElementVarHandle(int[].class);
    private static final int SHORT = 48;

    /** Groups whose contacts are laid out together. */
    static final int TOGETHER = 16;

    /** Pairs a circle for which a list has room, before it is given up. */
    private static final int ROOM_PER_CIRCLE = 24;

    private static final int LEAST_ROOM = 4096;

    /** Contacts that fit into one array. */
    private static final int MOST_CONTACTS = (Integer.MAX_VALUE - 8) / STRIDE;

    private final JvmState state;
    private final JvmGrid grid;
    private final Levels levels;
    private final Team team;
    private final JvmMemory memory;
    private final JvmSums sums;

    /** By worker: the pairs that it has found. */
    private final FoundPairs[] found;

    /** Number of contacts. */
    int count;

    /** Number of circles when they were listed. */
    private int circles;

    /** By group: its first contact; one more element for the end. */
    int[] start = new int[1];

    /** By slot: number of pairs with circles of its own level and of coarser ones. */
    private int[] candidates = new int[0];

    /** By contact: slot of the circle of lower id times 4, slot of the other times 4. */
    int[] pair = new int[0];

    /** By contact: {@link #STRIDE} floats. */
    float[] contact = new float[0];

    /** By contact, while the list is built: ids, lower above higher. */
    private long[] key = new long[0];

    /** By contact, while the list is built: slots, in the same order as the ids. */
    private long[] slots = new long[0];

    JvmContacts(JvmState state, JvmGrid grid, Levels levels, Team team) {
        this.state = state;
        this.grid = grid;
        this.levels = levels;
        this.team = team;
        memory = new JvmMemory(state);
        sums = new JvmSums(team);
        found = new FoundPairs[team.most()];
        for (int worker = 0; worker < found.length; worker++) {
            found[worker] = new FoundPairs();
        }
    }

    void ensure() {
        if (candidates.length < state.capacity()) {
            candidates = new int[state.capacity()];
        }
        if (start.length <= levels.buckets()) {
            start = new int[levels.buckets() + 1 + (levels.buckets() >> 2)];
        }
    }

    /**
     * Lists the contacts and puts them in order. Where circles crowd, so that a list of all pairs would take too much memory,
     * it stops half-way: {@link #overflowed} then says so.
     *
     * @param thinned whether to keep only a share of the pairs of a crowd, whose candidates have been counted before
     */
    void list(int worker, boolean thinned) {
        int groups = levels.buckets();
        int from = team.part(state.n, worker);
        int to = team.part(state.n, worker + 1);
        FoundPairs f = found[worker];
        Arrays.fill(start, team.part(groups, worker), team.part(groups, worker + 1), 0);
        if (!thinned) {
            Arrays.fill(candidates, from, to, 0);
        }
        team.sync(worker);
        f.reset(thinned, thinned ? Integer.MAX_VALUE : LEAST_ROOM + ROOM_PER_CIRCLE * (to - from));
        find(f, from, to);
        team.sync(worker);
        if (overflowed()) {
            return;
        }
        if (worker == 0) {
            long sum = 0;
            for (int w = 0; w < team.size(); w++) {
                sum += found[w].count;
            }
            ensureContacts(sum);
            count = (int) sum;
            circles = state.n;
        }
        sums.sumUp(worker, start, groups);
        scatter(found[worker]);
        team.sync(worker);
    }

    /** Whether the list was given up because there are too many pairs. */
    boolean overflowed() {
        for (int w = 0; w < team.size(); w++) {
            if (found[w].count > found[w].room) {
                return true;
            }
        }
        return false;
    }

    /** Counts the candidates of each circle, without a list: every circle looks at all cells around it. */
    void countCandidates(int worker) {
        int to = team.part(state.n, worker + 1);
        for (int slot = team.part(state.n, worker); slot < to; slot++) {
            int level = grid.level[slot];
            int sum = 0;
            for (int k = levels.usedCount - 1; k >= 0 && levels.used[k] <= level; k--) {
                sum += countInLevel(slot, levels.used[k]);
            }
            candidates[slot] = sum;
        }
        team.sync(worker);
    }

    private int countInLevel(int slot, int level) {
        int[] bucketStart = grid.start;
        int column = grid.column(state.circle[4 * slot], level);
        int row = grid.row(state.circle[4 * slot + 1], level);
        int w = levels.columnsLog[level];
        int mask = (1 << w) - 1;
        int rowMask = (1 << levels.rowsLog[level]) - 1;
        int sum = 0;
        for (int v = -1; v <= 1; v++) {
            int rowStart = levels.first[level] + (((row + v) & rowMask) << w);
            for (int u = -1; u <= 1; u++) {
                int b = rowStart + ((column + u) & mask);
                sum += countIn(slot, bucketStart[b], bucketStart[b + 1]);
            }
        }
        return sum;
    }

    private int countIn(int slot, int from, int to) {
        float[] circle = state.circle;
        float[] reach = grid.reach;
        float x = circle[4 * slot];
        float y = circle[4 * slot + 1];
        float own = reach[slot];
        boolean fixed = state.traits[4 * slot] == 0f;
        int sum = 0;
        for (int other = from; other < to; other++) {
            float dx = circle[4 * other] - x;
            float dy = circle[4 * other + 1] - y;
            float limit = own + reach[other];
            if (dx * dx + dy * dy < limit * limit && other != slot && !(fixed && state.traits[4 * other] == 0f)) {
                sum++;
            }
        }
        return sum;
    }

    /** Whether a circle has so many candidates that pairs are to be thinned out. Valid once all groups are filled. */
    boolean crowded() {
        for (int w = 0; w < team.size(); w++) {
            if (found[w].most > Tuning.CROWD) {
                return true;
            }
        }
        return false;
    }

    private void ensureContacts(long contacts) {
        if (contacts > MOST_CONTACTS) {
            throw new IllegalStateException(contacts + " contacts are more than the JVM back end can hold");
        }
        if (contacts > key.length) {
            int c = (int) Math.min(MOST_CONTACTS, Math.max(contacts + (contacts >> 2), 256));
            key = new long[c];
            slots = new long[c];
            pair = new int[2 * c];
            contact = new float[STRIDE * c];
            memory.ensure(c);
        }
    }

    // ---- finding
    // -----------------------------------------------------------------------------------------------------

    private void find(FoundPairs f, int from, int to) {
        for (int slot = from; slot < to && f.count <= f.room; slot++) {
            int level = grid.level[slot];
            findInOwnLevel(f, slot, level);
            for (int k = levels.usedCount - 1; k >= 0 && levels.used[k] < level; k--) {
                findInCoarserLevel(f, slot, levels.used[k]);
            }
        }
    }

    /** Half of the neighbourhood, so that each pair is seen once: the rest of the own bucket, the next, the row above. */
    private void findInOwnLevel(FoundPairs f, int slot, int level) {
        int[] bucketStart = grid.start;
        int w = levels.columnsLog[level];
        int mask = (1 << w) - 1;
        int bucket = grid.bucketOf[slot] - levels.first[level];
        int column = bucket & mask;
        int row = bucket >> w;
        int rowStart = levels.first[level] + (row << w);
        int aboveRow = (row + 1) & ((1 << levels.rowsLog[level]) - 1);
        int aboveStart = levels.first[level] + (aboveRow << w);
        if (column > 0 && column < mask) {
            scan(f, slot, level, column, row, slot + 1, bucketStart[rowStart + column + 2]);
            scan(
                    f,
                    slot,
                    level,
                    column,
                    row,
                    bucketStart[aboveStart + column - 1],
                    bucketStart[aboveStart + column + 2]);
        } else {
            int next = (column + 1) & mask;
            scan(f, slot, level, column, row, slot + 1, bucketStart[rowStart + column + 1]);
            scan(f, slot, level, column, row, bucketStart[rowStart + next], bucketStart[rowStart + next + 1]);
            for (int d = -1; d <= 1; d++) {
                int b = aboveStart + ((column + d) & mask);
                scan(f, slot, level, column, row, bucketStart[b], bucketStart[b + 1]);
            }
        }
    }

    private void findInCoarserLevel(FoundPairs f, int slot, int level) {
        int[] bucketStart = grid.start;
        int column = grid.column(state.circle[4 * slot], level);
        int row = grid.row(state.circle[4 * slot + 1], level);
        int w = levels.columnsLog[level];
        int mask = (1 << w) - 1;
        int rowMask = (1 << levels.rowsLog[level]) - 1;
        for (int v = -1; v <= 1; v++) {
            int rowStart = levels.first[level] + (((row + v) & rowMask) << w);
            if (column > 0 && column < mask) {
                scan(
                        f,
                        slot,
                        level,
                        column,
                        row,
                        bucketStart[rowStart + column - 1],
                        bucketStart[rowStart + column + 2]);
            } else {
                for (int u = -1; u <= 1; u++) {
                    int b = rowStart + ((column + u) & mask);
                    scan(f, slot, level, column, row, bucketStart[b], bucketStart[b + 1]);
                }
            }
        }
    }

    /** Tests one circle, which lies in cell (column, row) of a level, against slots [from, to) of that level. */
    private void scan(FoundPairs f, int slot, int level, int column, int row, int from, int to) {
        float[] circle = state.circle;
        float[] reach = grid.reach;
        float x = circle[4 * slot];
        float y = circle[4 * slot + 1];
        float own = reach[slot];
        f.tested += Math.max(0, to - from);
        int[] hits = f.hits;
        for (int start = from; start < to; start += hits.length) {
            int end = Math.min(to, start + hits.length);
            int count = 0;
            for (int other = start; other < end; other++) {
                float dx = circle[4 * other] - x;
                float dy = circle[4 * other + 1] - y;
                float limit = own + reach[other];
                hits[count] = other;
                // one more where the difference is negative; no branch, which would be taken as if by chance
                count -= Float.floatToRawIntBits(dx * dx + dy * dy - limit * limit) >> 31;
            }
            for (int k = 0; k < count; k++) {
                add(f, slot, hits[k], level, column, row);
            }
        }
    }

    private void add(FoundPairs f, int slot, int other, int level, int column, int row) {
        if (state.traits[4 * slot] == 0f && state.traits[4 * other] == 0f) {
            return;
        }
        f.count++;
        if (f.count > f.room) {
            return;
        }
        boolean lower = state.id[slot] < state.id[other];
        if (f.thinned) {
            int hash = CircleMath.pairHash(state.id[lower ? slot : other], state.id[lower ? other : slot]);
            if (!CircleMath.keeps(hash, Math.min(candidates[slot], candidates[other]))) {
                f.count--;
                return;
            }
        }
        int w = levels.columnsLog[level];
        int bucket = grid.bucketOf[other] - levels.first[level];
        int ox = CircleMath.ringFirst(column, bucket & ((1 << w) - 1), (1 << w) - 1);
        int oy = CircleMath.ringFirst(row, bucket >> w, (1 << levels.rowsLog[level]) - 1);
        int group = levels.group(level, ox, oy);
        int rank = team.size() > 1 ? (int) INTS.getAndAdd(start, group, 1) : start[group]++;
        f.add(lower ? slot : other, lower ? other : slot, group, rank);
    }

    private void scatter(FoundPairs f) {
        int[] id = state.id;
        int[] records = f.records;
        for (int k = 0; k < 4 * f.count; k += 4) {
            int lo = records[k];
            int hi = records[k + 1];
            int c = start[records[k + 2]] + records[k + 3];
            key[c] = (long) id[lo] << 32 | id[hi];
            slots[c] = (long) lo << 32 | hi;
        }
    }

    // ---- filling
    // -----------------------------------------------------------------------------------------------------

    /**
     * Orders the contacts of some groups of one colour, and fills them: the first contact of each group, then the second of each.
     * Groups of one colour share no circle, so a processor can work on neighbours in this order at the same time.
     */
    void fillGroups(int worker, int fromGroup, int toGroup, StepConstants constants) {
        FoundPairs f = found[worker];
        int open = 0;
        for (int group = fromGroup; group < toGroup; group++) {
            if (start[group] < start[group + 1]) {
                sort(start[group], start[group + 1]);
                f.next[open] = start[group];
                f.end[open++] = start[group + 1];
            }
        }
        int to = start[fromGroup];
        while (open > 0) {
            int left = 0;
            for (int k = 0; k < open; k++) {
                int from = f.next[k];
                fill(from, to++, constants);
                if (from + 1 < f.end[k]) {
                    f.next[left] = from + 1;
                    f.end[left++] = f.end[k];
                }
            }
            open = left;
        }
        if (!f.thinned) {
            f.most = Math.max(f.most, countCandidates(start[fromGroup], start[toGroup]));
        }
    }

    /** Counts the candidates that circles have among some contacts, where no other thread has any of the same circles. */
    private int countCandidates(int from, int to) {
        int most = 0;
        for (int c = from; c < to; c++) {
            int lo = pair[2 * c] >> 2;
            int hi = pair[2 * c + 1] >> 2;
            // a circle counts those of its own level and of coarser ones, which have lower numbers
            if (grid.level[lo] >= grid.level[hi]) {
                most = Math.max(most, ++candidates[lo]);
            }
            if (grid.level[hi] >= grid.level[lo]) {
                most = Math.max(most, ++candidates[hi]);
            }
        }
        return most;
    }

    private void sort(int from, int to) {
        if (to - from > SHORT) {
            HeapSort.longs(key, slots, from, to);
            return;
        }
        for (int k = from + 1; k < to; k++) {
            long key1 = key[k];
            long slots1 = slots[k];
            int p = k;
            while (p > from && key[p - 1] > key1) {
                key[p] = key[p - 1];
                slots[p] = slots[p - 1];
                p--;
            }
            key[p] = key1;
            slots[p] = slots1;
        }
    }

    private void fill(int from, int c, StepConstants constants) {
        int lo = (int) (slots[from] >>> 32);
        int hi = (int) slots[from];
        int i = 4 * lo;
        int j = 4 * hi;
        float[] circle = state.circle;
        float[] traits = state.traits;
        int k = STRIDE * c;
        pair[2 * c] = i;
        pair[2 * c + 1] = j;
        float sum = circle[i + 2] + circle[j + 2];
        float ex = circle[j] - circle[i];
        float ey = circle[j + 1] - circle[i + 1];
        float e = CircleMath.greatest(traits[i + 1], traits[j + 1]);
        contact[k + EX] = ex;
        contact[k + EY] = ey;
        contact[k + SUM] = sum;
        contact[k + E] = e;
        contact[k + THRESHOLD] = CircleMath.bounceThreshold(sum, e, constants.thresholdRate, constants.restRate);
        contact[k + W_LO] = traits[i];
        contact[k + W_HI] = traits[j];
        contact[k + MASS] = 1f / (traits[i] + traits[j]);
        contact[k + PUSH] = CircleMath.pushSpeed(sum, constants.pushPerLength, constants.pushPerRoot);
        if (!(ex * ex + ey * ey > 0.25f * (sum * sum))) {
            part(k, CircleMath.pairHash((int) (key[from] >>> 32), (int) key[from]));
        }
        contact[k + LAMBDA] = memory.recall(lo, hi, (int) key[from]) * constants.warmScale;
    }

    /** Gives a contact a normal for the case that its circles turn out to have one centre. */
    private void part(int k, int hash) {
        float px = CircleMath.partingX(hash);
        float py = CircleMath.partingY(hash);
        float norm = CircleMath.norm(px, py);
        contact[k + NX] = px / norm;
        contact[k + NY] = py / norm;
    }

    /** What the contacts of the step before have left. */
    JvmMemory memory() {
        return memory;
    }

    /** Remembers a contact for the step to come. No two contacts with a circle in common at once. */
    void remember(int c, float lambda) {
        int lo = pair[2 * c] >> 2;
        memory.remember(c, lo, state.id[pair[2 * c + 1] >> 2], lambda);
    }

    /** Takes over saved impulses in place of contacts; the circles have been taken over before. */
    void load(SavedState from) {
        count = 0;
        ensureContacts(from.impulses);
        memory.load(from);
    }

    /** Pairs whose distance was tested. */
    long candidatePairs() {
        long sum = 0;
        for (int w = 0; w < team.size(); w++) {
            sum += found[w].tested;
        }
        return sum;
    }

    /** Ids of the two circles of a contact, the lower one above the higher. */
    long ids(int c) {
        return key[c];
    }

    /** Memory of the arrays. */
    long bytes() {
        long sum = 4L * (candidates.length + start.length) + (8 + 8 + 8 + 4L * STRIDE) * key.length;
        for (FoundPairs f : found) {
            sum += f.bytes();
        }
        return sum + memory.bytes();
    }

    /** Greatest number of contacts of one circle. */
    int greatest() {
        int[] degree = new int[circles];
        int greatest = 0;
        for (int k = 0; k < 2 * count; k++) {
            greatest = Math.max(greatest, ++degree[pair[k] >> 2]);
        }
        return greatest;
    }
}
