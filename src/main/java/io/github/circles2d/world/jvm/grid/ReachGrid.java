package io.github.circles2d.world.jvm.grid;

import static io.github.circles2d.world.model.CircleRow.RADIUS;
import static io.github.circles2d.world.model.CircleRow.X;
import static io.github.circles2d.world.model.CircleRow.Y;

import io.github.circles2d.world.jvm.state.State;
import io.github.circles2d.world.jvm.threads.SharedInts;
import io.github.circles2d.world.jvm.threads.Team;
import io.github.circles2d.world.model.Bounds;
import io.github.circles2d.world.model.CircleMath;
import io.github.circles2d.world.model.CircleRow;
import io.github.circles2d.world.model.GridLevels;
import io.github.circles2d.world.model.PairRule;
import io.github.circles2d.world.model.Paths;
import io.github.circles2d.world.model.Reach;
import java.util.Arrays;
import java.util.concurrent.atomic.AtomicInteger;

/**
 * The fast circles that {@linkplain Reach reach} far, by their reach. The grid of {@link Grid} has cells for radii: such a circle would
 * have to look at very many cells of finer levels, or of its own. So the circles there look for it. A bucket is a list of circles in no
 * order, so what is made of them must not depend on it.
 */
final class ReachGrid {
    private static final int NONE = -1;

    /** A circle reaches far in a level if it does so over more than so many of its cells. It changes the time alone. */
    private static final float FAR_CELLS = 3f;

    /** So that no rounding hides a circle at the edge of what is looked at. */
    private static final float SLACK = 1.001f;

    private final State state;
    private final Grid grid;
    private final GridLevels levels;
    private final Team team;

    /** By bucket: the slot that came last. */
    private int[] last = new int[0];

    /** By slot: the one that came before it to its bucket. */
    private int[] before = new int[0];

    /** By slot. */
    private float[] reach = new float[0];

    private int buckets;
    private int topExponent;

    /** What coordinates may be off by, along axes that wrap. */
    private float rounding;

    /** A bit for each class that has circles. */
    private final AtomicInteger used = new AtomicInteger();

    /** By worker: slots near the one that is looked at. */
    private final int[][] hits;

    ReachGrid(State state, Grid grid, GridLevels levels, Team team) {
        this.state = state;
        this.grid = grid;
        this.levels = levels;
        this.team = team;
        hits = new int[team.most()][64];
    }

    void ensure() {
        if (before.length < state.capacity()) {
            reach = new float[state.capacity()];
            last = new int[Reach.reachBuckets(state.capacity())];
            before = new int[state.capacity()];
        }
        buckets = Reach.reachBuckets(state.awake);
        topExponent = Reach.topExponent(levels.rmax);
        rounding = state.wraps ? levels.bounds.magnitude() * 0x1p-20f : 0f;
        used.set(0);
    }

    long bytes() {
        long sum = 4L * (last.length + before.length + reach.length);
        for (int[] each : hits) {
            sum += 4L * each.length;
        }
        return sum;
    }

    void clear(int worker) {
        Arrays.fill(last, team.part(buckets, worker), team.part(buckets, worker + 1), NONE);
    }

    /** Notes how far circles reach, and puts those into their buckets that are fast and reach far. */
    void add(int from, int to) {
        boolean shared = team.size() > 1;
        float far = farIn(levels.used[0]);
        int classes = 0;
        for (int slot = from; slot < to; slot++) {
            int s = CircleRow.of(slot);
            float r = state.circle[s + RADIUS];
            boolean isStatic = state.isStatic(slot);
            // no less than the distance of contacts, for those who look once for both
            reach[slot] = CircleMath.max(Reach.reachOf(r, grid.path[slot], isStatic), grid.speculativeDistance[slot]);
            if (!(reach[slot] > far) || isStatic || !Paths.isFast(grid.path[slot], r)) {
                continue;
            }
            int k = Reach.reachClassOf(reach[slot], topExponent);
            float inverseEdge = Reach.inverseReachEdge(k, topExponent);
            int b = Reach.reachBucket(
                    Reach.reachCell(state.circle[s + X], levels.minX, inverseEdge),
                    Reach.reachCell(state.circle[s + Y], levels.minY, inverseEdge),
                    k,
                    buckets);
            if (shared) {
                before[slot] = SharedInts.getAndSet(last, b, slot);
            } else {
                before[slot] = last[b];
                last[b] = slot;
            }
            classes |= 1 << k;
        }
        if (classes != 0) {
            used.accumulateAndGet(classes, (a, b) -> a | b);
        }
    }

    /** The reach from which on circles of a level look for a circle, and it does not look for them. */
    float farIn(int level) {
        return FAR_CELLS / levels.inverseEdge[level];
    }

    /** By slot: how far from its centre a circle gets in the step. */
    float[] reaches() {
        return reach;
    }

    /** The slots that were found last. */
    int[] hits(int worker) {
        return hits[worker];
    }

    /**
     * Finds those circles that reach far in the level of one, and no less far than it, and whose reach meets its own. Some may be of
     * other classes, and some may come twice. Of two that would find each other, the one of the lower slot does.
     *
     * @param looks whether the one is fast, and not static
     * @return how many {@link #hits} there are
     */
    int find(int worker, int slot, boolean looks) {
        int classes = used.get();
        if (classes == 0) {
            return 0;
        }
        int own = Reach.reachClassOf(reach[slot], topExponent);
        classes &= (2 << own) - 1;
        // One that reaches far itself looks for all of them.
        boolean isHere = looks && reach[slot] > farIn(levels.used[0]);
        float far = isHere ? 0f : farIn(grid.level[slot]);
        int count = 0;
        while (classes != 0) {
            int j = Integer.numberOfTrailingZeros(classes);
            classes &= classes - 1;
            if (Reach.topReach(j, topExponent) > far) {
                count = findIn(worker, slot, j, isHere && j == own ? slot : NONE, count);
            }
        }
        return count;
    }

    private int findIn(int worker, int slot, int j, int after, int found) {
        int s = CircleRow.of(slot);
        float x = state.circle[s + X];
        float y = state.circle[s + Y];
        float far = SLACK * (reach[slot] + Reach.topReach(j, topExponent)) + rounding;
        if (!state.wraps) {
            return scan(worker, slot, j, after, x - far, x + far, y - far, y + far, found);
        }
        Bounds b = levels.bounds;
        boolean allX = 2f * far >= state.periodX; // images would show the same circles again
        boolean allY = 2f * far >= state.periodY;
        int count = found;
        for (int u = allX ? 0 : -1; u <= (allX ? 0 : 1); u++) {
            float left = allX ? b.minX() : shifted(x - far, u, state.periodX);
            float right = allX ? b.maxX() : shifted(x + far, u, state.periodX);
            if (u != 0 && (right < b.minX() || left > b.maxX())) {
                continue;
            }
            for (int v = allY ? 0 : -1; v <= (allY ? 0 : 1); v++) {
                float low = allY ? b.minY() : shifted(y - far, v, state.periodY);
                float high = allY ? b.maxY() : shifted(y + far, v, state.periodY);
                if (v == 0 || !(high < b.minY() || low > b.maxY())) {
                    count = scan(worker, slot, j, after, left, right, low, high, count);
                }
            }
        }
        return count;
    }

    /** A coordinate so many periods further; beyond all where the axis does not wrap. */
    private static float shifted(float x, int periods, float period) {
        return periods == 0 ? x : x + periods * period;
    }

    private int scan(
            int worker, int slot, int j, int after, float left, float right, float low, float high, int found) {
        float inverseEdge = Reach.inverseReachEdge(j, topExponent);
        int c0 = Reach.reachCell(left, levels.minX, inverseEdge);
        int c1 = Reach.reachCell(right, levels.minX, inverseEdge);
        int r0 = Reach.reachCell(low, levels.minY, inverseEdge);
        int r1 = Reach.reachCell(high, levels.minY, inverseEdge);
        int count = found;
        for (int row = r0; row <= r1; row++) {
            for (int column = c0; column <= c1; column++) {
                int first = last[Reach.reachBucket(column, row, j, buckets)];
                if (first != NONE) {
                    count = scanBucket(worker, slot, first, after, count);
                }
            }
        }
        return count;
    }

    /** Of slots behind one. */
    private int scanBucket(int worker, int slot, int first, int after, int found) {
        float[] circle = state.circle;
        float[] reaches = reach;
        int[] next = before;
        int[] near = hits[worker];
        float own = reaches[slot];
        int count = found;
        if (state.wraps) {
            for (int other = first; other != NONE; other = next[other]) {
                near = ensure(worker, near, count);
                near[count] = other;
                count -= (after - other >> 31)
                        & PairRule.isNear(
                                state.differenceX(slot, other), state.differenceY(slot, other), own, reaches[other]);
            }
            return count;
        }
        float x = circle[CircleRow.of(slot) + X];
        float y = circle[CircleRow.of(slot) + Y];
        for (int other = first; other != NONE; other = next[other]) {
            near = ensure(worker, near, count);
            near[count] = other;
            count -= (after - other >> 31)
                    & PairRule.isNear(
                            circle[CircleRow.of(other) + X] - x,
                            circle[CircleRow.of(other) + Y] - y,
                            own,
                            reaches[other]);
        }
        return count;
    }

    private int[] ensure(int worker, int[] near, int count) {
        if (count < near.length) {
            return near;
        }
        hits[worker] = Arrays.copyOf(near, 2 * count);
        return hits[worker];
    }
}
