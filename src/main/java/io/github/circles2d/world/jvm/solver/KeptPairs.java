package io.github.circles2d.world.jvm.solver;

import static io.github.circles2d.world.model.CircleRow.X;
import static io.github.circles2d.world.model.CircleRow.Y;

import io.github.circles2d.world.jvm.grid.Candidates;
import io.github.circles2d.world.jvm.grid.Grid;
import io.github.circles2d.world.jvm.state.State;
import io.github.circles2d.world.jvm.threads.Team;
import io.github.circles2d.world.model.CircleMath;
import io.github.circles2d.world.model.CircleRow;
import io.github.circles2d.world.model.GridLevels;
import io.github.circles2d.world.model.PairRule;
import java.util.Arrays;

/**
 * Pairs that are kept from step to step where circles hardly move, as in a heap. The groups of a span of columns of a row, of one parity, keep the
 * pairs that are nearer than a contact by some slack, in the order of contacts. While each circle stays in its bucket, and all ways since then are
 * shorter than the slack, no other pair can be a contact, and it is enough to test these. Two static circles are no pair.
 *
 * <p>Where most things move this gains nothing. Then it pauses for some steps.
 */
final class KeptPairs {
    /** Log of the columns of a span. A row of buckets has whole spans, or its level is left out. */
    private static final int SPAN_LOG = 4;

    private static final int SPAN = 1 << SPAN_LOG;

    /** By the greatest radius of a level. */
    private static final float SLACK = 0.25f;

    /** What rounding may add to ways and distances is far less than the rest. */
    private static final float SAFE = 0.99f;

    /** Pairs are kept if they would be of use for so many steps like this one. */
    private static final int LEAST_STEPS = 3;

    /** Steps of a pause. */
    private static final int PAUSE = 8;

    /** It pauses unless so great a part of what was looked at is kept, and of what was kept, used. */
    private static final int LEAST_PART = 4;

    private final State state;
    private final Grid grid;
    private final GridLevels levels;
    private final Team team;
    private final Bands bands;
    private final Pairs pairs;
    private final Candidates candidates;
    private final NearResting resting;
    private final FoundPairs[] found;

    private final Team.Work noteWays = this::noteWays;

    /** The shape of the grid of the last step. */
    private final GridLevels before = new GridLevels();

    /** Whether pairs are kept in this step. */
    private boolean on;

    /** The number of this step; one is left out after a step that has kept none. */
    private int step;

    /** Steps since the last pause, and steps until its end. */
    private int steps;

    private int pausing;

    /** By id: the place and the speculative distance in the step that is named below. */
    private float[] last = new float[0];

    /** By id: twice the bucket, and 1 more if the circle is static; and the step. */
    private int[] lastBucket = new int[0];

    /** By span: the last step in which circles came or went. */
    private int[] changed = new int[0];

    /** By span: how many circles it had. */
    private int[] circles = new int[0];

    /** By span: the longest way of a circle since the last step, and by how much its speculative distance has grown. */
    private float[] way = new float[0];

    /** By span and parity: the last step for which the pairs hold, the slack that is left, whose list they are in, and where. */
    private int[] keptAt = new int[0];

    private float[] left = new float[0];
    private int[] keeper = new int[0];
    private int[] from = new int[0];
    private int[] to = new int[0];

    KeptPairs(
            State state,
            Grid grid,
            GridLevels levels,
            Team team,
            Bands bands,
            Pairs pairs,
            Candidates candidates,
            NearResting resting,
            FoundPairs[] found) {
        this.state = state;
        this.grid = grid;
        this.levels = levels;
        this.team = team;
        this.bands = bands;
        this.pairs = pairs;
        this.candidates = candidates;
        this.resting = resting;
        this.found = found;
    }

    long bytes() {
        return 4L * (last.length + lastBucket.length + 3L * way.length + 5L * keptAt.length);
    }

    /** Begins the finding of a step, whose bands have been divided; possible: whether all pairs are to be found. */
    void begin(boolean possible) {
        on = possible && !state.wraps && !pauses();
        step += on ? 1 : 2;
        if (!on) {
            steps = 0;
            return;
        }
        steps++;
        if (!isAsBefore()) {
            before.copy(levels);
            step++;
        }
        ensure();
        for (FoundPairs f : found) {
            f.beginKeeping();
        }
        team.all(noteWays);
    }

    private boolean pauses() {
        if (pausing > 0) {
            pausing--;
            return true;
        }
        int looked = 0;
        int kept = 0;
        int used = 0;
        for (FoundPairs f : found) {
            looked += f.spans;
            kept += f.spansKept;
            used += f.spansUsed;
        }
        // in the first step ways are not known, and in the second one nothing has been kept
        if (steps > 1 && LEAST_PART * kept < looked || steps > 2 && LEAST_PART * used < looked) {
            pausing = PAUSE;
            return true;
        }
        return false;
    }

    private void ensure() {
        int ids = state.slotOf.length;
        if (lastBucket.length < 2 * ids) {
            last = Arrays.copyOf(last, 3 * ids);
            lastBucket = Arrays.copyOf(lastBucket, 2 * ids);
        }
        int spans = (levels.buckets() >> SPAN_LOG) + 1;
        if (changed.length < spans) {
            int c = spans + (spans >> 2);
            circles = Arrays.copyOf(circles, c);
            way = Arrays.copyOf(way, c);
            keptAt = Arrays.copyOf(keptAt, 2 * c);
            left = Arrays.copyOf(left, 2 * c);
            keeper = Arrays.copyOf(keeper, 2 * c);
            from = Arrays.copyOf(from, 2 * c);
            to = Arrays.copyOf(to, 2 * c);
            changed = Arrays.copyOf(changed, c);
        }
    }

    private boolean isAsBefore() {
        boolean same = levels.usedCount == before.usedCount
                && levels.buckets == before.buckets
                && levels.minX == before.minX
                && levels.minY == before.minY;
        for (int l = 0; same && l < levels.usedCount; l++) {
            int level = levels.used[l];
            same = level == before.used[l]
                    && levels.first[level] == before.first[level]
                    && levels.columnsLog[level] == before.columnsLog[level]
                    && levels.columnCount[level] == before.columnCount[level]
                    && levels.rowCount[level] == before.rowCount[level]
                    && levels.inverseEdge[level] == before.inverseEdge[level]
                    && levels.scaleX[level] == before.scaleX[level]
                    && levels.scaleY[level] == before.scaleY[level]
                    && levels.unitsX[level] == before.unitsX[level]
                    && levels.unitsY[level] == before.unitsY[level]
                    && levels.top[level] == before.top[level];
        }
        return same && Arrays.equals(levels.levelOf, before.levelOf);
    }

    // ---- ways

    private void noteWays(int worker) {
        for (int l = 0; l < levels.usedCount; l++) {
            int level = levels.used[l];
            int end = bands.first(level, worker + 1);
            for (int row = bands.first(level, worker); row < end && levels.columnsLog[level] >= SPAN_LOG; row++) {
                int bucket = levels.rowStart(level, row);
                for (int column = 0; column < levels.columnCount[level]; column += SPAN) {
                    int columns = Math.min(SPAN, levels.columnCount[level] - column);
                    noteWays(bucket + column >> SPAN_LOG, bucket + column, bucket + column + columns);
                }
            }
        }
    }

    private void noteWays(int span, int bucket, int endBucket) {
        int begin = grid.start[bucket];
        int end = grid.start[endBucket];
        boolean same = circles[span] == end - begin;
        boolean rest = resting.areAny();
        float longest = 0f;
        for (int slot = begin; slot < end; slot++) {
            int id = state.id[slot];
            float x = state.circle[CircleRow.of(slot) + X];
            float y = state.circle[CircleRow.of(slot) + Y];
            float distance = grid.speculativeDistance[slot];
            float gone = Math.abs(x - last[3 * id])
                    + Math.abs(y - last[3 * id + 1])
                    + CircleMath.max(distance - last[3 * id + 2], 0f);
            longest = CircleMath.max(longest, gone);
            if (rest && resting.first(slot) < resting.first(slot + 1)) {
                longest = Float.POSITIVE_INFINITY; // its pairs lie among those of its groups, which are found anew
            }
            last[3 * id] = x;
            last[3 * id + 1] = y;
            last[3 * id + 2] = distance;
            int now = 2 * grid.bucketOf[slot] + (state.isStatic(slot) ? 1 : 0);
            if (lastBucket[2 * id] != now || lastBucket[2 * id + 1] != step - 1) {
                changed[lastBucket[2 * id] >> SPAN_LOG + 1] = step; // other workers may write the same
                same = false;
                lastBucket[2 * id] = now;
            }
            lastBucket[2 * id + 1] = step;
        }
        circles[span] = end - begin;
        way[span] = longest;
        if (!same) {
            changed[span] = step;
        }
    }

    // ---- pairs

    /** Whether {@link #find} finds the pairs of a level. */
    boolean has(int level) {
        return on && levels.columnsLog[level] >= SPAN_LOG;
    }

    /** Finds the pairs of a row of groups. */
    void find(int worker, int level, int row) {
        FoundPairs f = found[worker];
        int columns = levels.columnCount[level];
        int bucket = levels.rowStart(level, row);
        int above = levels.rowStart(level, GridLevels.neighbour(row, 1, levels.rowCount[level]));
        for (int odd = 0; odd < 2; odd++) {
            for (int column = 0; column < columns && !f.overflowed; column += SPAN) {
                int span = bucket + column >> SPAN_LOG;
                int spanAbove = above + column >> SPAN_LOG;
                float longest = CircleMath.max(way[span], way[spanAbove]);
                boolean same = changed[span] != step && changed[spanAbove] != step;
                int some = circles[span] + circles[spanAbove];
                if (odd == 1) {
                    int next = column + SPAN < columns ? column + SPAN : 0;
                    int beside = bucket + next >> SPAN_LOG;
                    int besideAbove = above + next >> SPAN_LOG;
                    longest = CircleMath.max(longest, CircleMath.max(way[beside], way[besideAbove]));
                    same &= changed[beside] != step && changed[besideAbove] != step;
                    some += circles[beside] + circles[besideAbove];
                }
                if (some == 0) {
                    continue;
                }
                find(worker, level, row, column + odd, Math.min(column + SPAN, columns), 2 * span + odd, longest, same);
            }
        }
    }

    /** Finds the pairs of every other column from one on. */
    private void find(int worker, int level, int row, int column, int end, int part, float longest, boolean same) {
        FoundPairs f = found[worker];
        float slack = SAFE * SLACK * levels.top[level];
        left[part] -= 2f * longest;
        f.spans++;
        if (same && keptAt[part] == step - 1 && left[part] >= 0f) {
            int begin = f.keptCount;
            f.keep(found[keeper[part]].keptBefore, from[part], to[part]);
            f.spansUsed++;
            f.tested += f.keptCount - begin;
            takeOver(part, worker, begin);
        } else if (2 * LEAST_STEPS * longest <= slack) {
            int begin = f.keptCount;
            f.slack = SLACK * levels.top[level];
            for (int group = column; group < end; group += 2) {
                pairs.find(f, level, group, row);
                f.endKeptGroup();
            }
            f.slack = 0f;
            f.flushKept();
            left[part] = slack;
            takeOver(part, worker, begin);
        } else {
            for (int group = column; group < end; group += 2) {
                pairs.find(f, level, group, row);
                f.endGroup();
            }
            f.flush();
        }
    }

    /** Keeps pairs that lie in a worker's list, and lists those that are contacts. */
    private void takeOver(int part, int worker, int begin) {
        FoundPairs f = found[worker];
        keptAt[part] = step;
        keeper[part] = worker;
        from[part] = begin;
        to[part] = f.keptCount;
        f.spansKept++;
        list(f, begin);
    }

    /** Lists those of the kept pairs from one on that are near. */
    private void list(FoundPairs f, int begin) {
        int[] slotOf = state.slotOf;
        float[] circle = state.circle;
        float[] distance = grid.speculativeDistance;
        long[] kept = f.kept;
        int end = f.keptCount;
        f.ensure(f.count + end - begin);
        long[] ids = f.ids;
        long[] slots = f.slots;
        int first = f.count;
        int count = first;
        for (int k = begin; k < end; k++) {
            long pair = kept[k];
            int lower = slotOf[(int) (pair >>> 32)];
            int higher = slotOf[(int) pair];
            int a = CircleRow.of(lower);
            int b = CircleRow.of(higher);
            ids[count] = pair;
            slots[count] = (long) lower << 32 | higher;
            count -= PairRule.isNear(
                    circle[b + X] - circle[a + X], circle[b + Y] - circle[a + Y], distance[lower], distance[higher]);
        }
        if (state.filtering || state.parting != null || levels.hasStatics) {
            int near = count;
            count = first;
            for (int k = first; k < near; k++) {
                ids[count] = ids[k];
                slots[count] = slots[k];
                count += candidates.keeps((int) (slots[k] >>> 32), (int) slots[k]) ? 1 : 0;
            }
        }
        f.count = count;
        f.noteRoom();
    }
}
