package io.github.circles2d.world.jvm.grid;

import static io.github.circles2d.world.model.CircleRow.INVERSE_MASS;
import static io.github.circles2d.world.model.CircleRow.RADIUS;
import static io.github.circles2d.world.model.CircleRow.VX;
import static io.github.circles2d.world.model.CircleRow.VY;
import static io.github.circles2d.world.model.CircleRow.X;
import static io.github.circles2d.world.model.CircleRow.Y;

import io.github.circles2d.world.circles.CircleField;
import io.github.circles2d.world.jvm.state.HeapSort;
import io.github.circles2d.world.jvm.state.State;
import io.github.circles2d.world.jvm.state.Sums;
import io.github.circles2d.world.jvm.threads.SharedInts;
import io.github.circles2d.world.jvm.threads.Team;
import io.github.circles2d.world.model.Bounds;
import io.github.circles2d.world.model.Cells;
import io.github.circles2d.world.model.CircleMath;
import io.github.circles2d.world.model.CircleRow;
import io.github.circles2d.world.model.GridLevels;
import io.github.circles2d.world.model.KindMotion;
import io.github.circles2d.world.model.Paths;
import io.github.circles2d.world.model.StepConstants;
import io.github.circles2d.world.model.Velocity;
import java.util.Arrays;
import java.util.concurrent.atomic.AtomicInteger;

/**
 * Stage Grid: sorts the circles that do not rest by (level, bucket), and within a bucket by sheet, if there are sheets ({@link GridLevels}), and id. So
 * a bucket's circles have consecutive slots. It is a counting sort: count, sum up, scatter, then sort each bucket, so that the order of
 * the threads does not show.
 */
public final class Grid {
    /** Slots that are looked through one by one. */
    private static final int FEW = 8;

    private final State state;
    private final GridLevels levels;
    private final Team team;

    /** By slot: the bucket, before the sort; {@link #bucketOf} after it. */
    private int[] bucketBefore = new int[0];

    /** By slot, before the sort: how many of its bucket were counted before it. */
    private int[] rank = new int[0];

    /** By slot, before the sort: as {@link #sheetKey}. */
    private int[] sheetKeyBefore = new int[0];

    /** By new slot: the old slot. */
    private int[] order = new int[0];

    public int[] bucketOf = new int[0];

    /** By slot, if there are sheets: {@link GridLevels#sheetKey}, and 1 more if the circle is static. */
    private int[] sheetKey = new int[0];

    /** Whether there are sheets in this step. */
    private boolean sheets;

    /** By slot: how far the circle looks for contacts. */
    public float[] speculativeDistance = new float[0];

    /** By slot: length of what the circle would move in the step. */
    public float[] path = new float[0];

    public byte[] level = new byte[0];

    /** By bucket: its first slot; one more element for the end. */
    public int[] start = new int[1];

    private final Sums sums;

    private final Team.Work findBuckets = this::findBuckets;
    private final Team.Work setStarts = this::setStarts;
    private final Team.Work count = this::count;
    private final Team.Work scatter = this::scatter;
    private final Team.Work sortBuckets = this::sortBuckets;
    private final Team.Work permute = this::permute;
    private final Team.Work copyResting = this::copyResting;
    private final Team.Work takeBack = this::takeBack;
    private final Team.Work describe = this::describe;

    private StepConstants constants;

    /** Whether no circle has to move for the sort, as where all rests. */
    private volatile boolean sorted;

    private volatile boolean moved;
    private volatile boolean fast;

    private volatile boolean movingStatics;

    /** The longest path of a circle that is not static, as the bits of a float, which sort like the float itself. */
    private final AtomicInteger longestPath = new AtomicInteger();

    public Grid(State state, GridLevels levels, Team team) {
        this.state = state;
        this.levels = levels;
        this.team = team;
        sums = new Sums(team);
    }

    public void ensure() {
        if (bucketOf.length < state.capacity()) {
            int c = state.capacity();
            bucketBefore = new int[c];
            rank = new int[c];
            order = new int[c];
            speculativeDistance = new float[c];
            path = new float[c];
            level = new byte[c];
            bucketOf = new int[c];
        }
        sheets = levels.haveSheets();
        if (sheets && sheetKey.length < state.capacity()) {
            sheetKeyBefore = new int[state.capacity()];
            sheetKey = new int[state.capacity()];
        }
        if (start.length <= levels.buckets()) {
            start = new int[levels.buckets() + 1 + (levels.buckets() >> 2)];
        }
        sorted = true;
        moved = false;
        fast = false;
        movingStatics = false;
        longestPath.set(0);
    }

    public void build(StepConstants k) {
        constants = k;
        team.all(findBuckets);
        if (sorted) {
            team.all(setStarts);
        } else {
            sort();
        }
        team.all(describe);
    }

    private void sort() {
        team.all(count);
        sums.sumUp(start, levels.buckets());
        team.all(scatter);
        team.all(sortBuckets);
        if (moved) {
            team.all(permute);
            if (2 * state.awake >= state.n) {
                if (state.awake < state.n) {
                    team.all(copyResting);
                }
                state.swap();
            } else {
                team.all(takeBack);
            }
        }
    }

    private int from(int worker) {
        return team.part(state.awake, worker);
    }

    private int to(int worker) {
        return team.part(state.awake, worker + 1);
    }

    private void permute(int worker) {
        state.permute(order, from(worker), to(worker));
    }

    private void copyResting(int worker) {
        state.copyResting(team.part(state.n - state.awake, worker), team.part(state.n - state.awake, worker + 1));
    }

    private void takeBack(int worker) {
        state.takeBack(from(worker), to(worker));
    }

    private void count(int worker) {
        count(from(worker), to(worker));
    }

    private void scatter(int worker) {
        scatter(from(worker), to(worker));
    }

    private void sortBuckets(int worker) {
        sortBuckets(team.part(levels.buckets(), worker), team.part(levels.buckets(), worker + 1));
    }

    private void describe(int worker) {
        describe(from(worker), to(worker));
    }

    private void findBuckets(int worker) {
        Arrays.fill(start, team.part(levels.buckets(), worker), team.part(levels.buckets(), worker + 1), 0);
        int to = to(worker);
        boolean inOrder = true;
        int before = from(worker) > 0 ? findBucket(from(worker) - 1) : 0;
        for (int slot = from(worker); slot < to; slot++) {
            int bucket = findBucket(slot);
            if (inOrder) {
                inOrder = before < bucket || before == bucket && (slot == 0 || !isBefore(slot, slot - 1));
                before = bucket;
            }
            bucketBefore[slot] = bucket;
        }
        if (!inOrder) {
            sorted = false;
        }
    }

    private int findBucket(int slot) {
        int s = CircleRow.of(slot);
        float x = state.circle[s + X];
        float y = state.circle[s + Y];
        int atLevel = levels.level(state.circle[s + RADIUS]);
        return sheets ? bucketAndSheet(slot, x, y, atLevel) : bucket(x, y, atLevel);
    }

    /** Whether one of two circles of a bucket comes first. */
    private boolean isBefore(int slot, int other) {
        return HeapSort.isBefore(slot, other, sheets ? sheetKeyBefore : null, state.id);
    }

    /** All circles are where they belong: what is left to know is where buckets begin. */
    private void setStarts(int worker) {
        int to = to(worker);
        for (int slot = from(worker); slot < to; slot++) {
            int bucket = bucketBefore[slot];
            for (int empty = slot == 0 ? 0 : bucketBefore[slot - 1] + 1; empty <= bucket; empty++) {
                start[empty] = slot;
            }
            bucketOf[slot] = bucket;
            if (sheets) {
                sheetKey[slot] = sheetKeyBefore[slot];
            }
        }
        if (worker == team.size() - 1) {
            Arrays.fill(start, to == 0 ? 0 : bucketBefore[to - 1] + 1, levels.buckets() + 1, to);
        }
    }

    private void count(int from, int to) {
        boolean shared = team.size() > 1;
        for (int slot = from; slot < to; slot++) {
            int bucket = bucketBefore[slot];
            rank[slot] = shared ? SharedInts.getAndAdd(start, bucket, 1) : start[bucket]++;
        }
    }

    /** The bucket of a place; notes the sheet. With walls one division gives both. */
    private int bucketAndSheet(int slot, float x, float y, int atLevel) {
        int isStatic = state.isStatic(slot) ? 1 : 0;
        if (!levels.folded[atLevel] || !levels.bounds.isWalled()) {
            sheetKeyBefore[slot] = levels.sheetKey(x, y, atLevel) + isStatic;
            return bucket(x, y, atLevel);
        }
        int cellX = Cells.cell(x, levels.minX, levels.inverseEdge[atLevel]);
        int cellY = Cells.cell(y, levels.minY, levels.inverseEdge[atLevel]);
        int sheetX = cellX / levels.columnCount[atLevel];
        int sheetY = cellY / levels.rowCount[atLevel];
        sheetKeyBefore[slot] = levels.sheetKey(atLevel, sheetX, sheetY) + isStatic;
        int row = cellY - sheetY * levels.rowCount[atLevel];
        return levels.first[atLevel]
                + (cellX - sheetX * levels.columnCount[atLevel])
                + (row << levels.columnsLog[atLevel]);
    }

    private int bucket(float x, float y, int atLevel) {
        int column = column(x, atLevel);
        int row = row(y, atLevel);
        return levels.first[atLevel] + column + (row << levels.columnsLog[atLevel]);
    }

    int column(float x, int atLevel) {
        return levels.column(x, atLevel);
    }

    int row(float y, int atLevel) {
        return levels.row(y, atLevel);
    }

    private void scatter(int from, int to) {
        for (int slot = from; slot < to; slot++) {
            order[start[bucketBefore[slot]] + rank[slot]] = slot;
        }
    }

    /** Insertion sort: buckets are short, and nearly in order from the step before; a long one takes a heap sort. */
    private void sortBuckets(int from, int to) {
        int[] id = state.id;
        int[] sheet = sheets ? sheetKeyBefore : null;
        boolean same = true;
        for (int bucket = from; bucket < to; bucket++) {
            int first = start[bucket];
            int end = start[bucket + 1];
            if (end - first > 64) {
                HeapSort.byKey(order, sheet, id, first, end);
            }
            for (int k = first; k < end; k++) {
                int slot = order[k];
                int p = k;
                while (p > first && HeapSort.isBefore(slot, order[p - 1], sheet, id)) {
                    order[p] = order[p - 1];
                    p--;
                }
                order[p] = slot;
                bucketOf[k] = bucket;
            }
            for (int k = first; k < end; k++) {
                same &= order[k] == k;
            }
            if (sheets) {
                for (int k = first; k < end; k++) {
                    sheetKey[k] = sheetKeyBefore[order[k]];
                }
            }
        }
        if (!same) {
            moved = true;
        }
    }

    private void describe(int from, int to) {
        float[] circle = state.circle;
        float[] motion = state.motion;
        float[] plan = state.plan;
        float[] kinds = state.kindMotion;
        boolean some = false;
        boolean moving = false;
        boolean resting = false;
        float longest = 0f;
        float least = leastRadius();
        Bounds b = constants.bounds;
        for (int slot = from; slot < to; slot++) {
            int s = CircleRow.of(slot);
            float r = circle[s + RADIUS];
            boolean isStatic = state.traits[s + INVERSE_MASS] == 0f;
            float px = Velocity.plan(motion[s + VX], constants.dt, isStatic ? 0f : constants.fallX);
            float py = Velocity.plan(motion[s + VY], constants.dt, isStatic ? 0f : constants.fallY);
            float length = CircleMath.length(px, py);
            if (kinds != null && !isStatic) {
                int row = state.motionRow(slot);
                float falls = kinds[row + KindMotion.FALLS];
                float time = kinds[row + KindMotion.TIME];
                if (!Float.isNaN(state.own(CircleField.DAMPING, slot))) {
                    float factor = state.dampingFactor(slot, row, constants);
                    falls = Velocity.dampedFalls(factor, constants.subSteps);
                    time = Velocity.dampedTime(factor, constants.subSteps, constants.h, constants.dt);
                }
                px = Velocity.plan(motion[s + VX], time, state.gainX(slot, constants) * constants.h * falls);
                py = Velocity.plan(motion[s + VY], time, state.gainY(slot, constants) * constants.h * falls);
                float most = Velocity.shareWithin(px, py, state.greatestSpeed(slot, row) * constants.dt);
                px = most * px;
                py = most * py;
                length = CircleMath.length(px, py);
            }
            if (state.wraps) {
                float within = CircleMath.min(
                        CircleMath.shareOfPeriod(px, state.periodX), CircleMath.shareOfPeriod(py, state.periodY));
                px = within * px;
                py = within * py;
                length = CircleMath.length(px, py);
            }
            if (isStatic) {
                // it stops at the bounds
                px = CircleMath.within(circle[s + X], px, b.minX(), b.maxX());
                py = CircleMath.within(circle[s + Y], py, b.minY(), b.maxY());
                length = CircleMath.length(px, py);
            } else if (length > r) {
                px = Paths.besideWalls(circle[s + X], px, r, b.minX(), b.maxX());
                py = Paths.besideWalls(circle[s + Y], py, r, b.minY(), b.maxY());
                length = CircleMath.length(px, py);
            }
            float share = isStatic ? 1f : Paths.travelShare(length, r);
            plan[2 * slot] = share * px;
            plan[2 * slot + 1] = share * py;
            level[slot] = (byte) levels.level(r);
            path[slot] = share * length;
            speculativeDistance[slot] = Paths.speculativeDistance(r, path[slot]);
            some |= Paths.isFast(path[slot], isStatic ? least : r);
            moving |= isStatic && length > 0f;
            resting |= isStatic && length == 0f;
            longest = isStatic ? longest : CircleMath.max(path[slot], longest);
        }
        if (some) {
            fast = true;
        }
        if (moving) {
            movingStatics = true;
        }
        if (resting) {
            state.resting.propose();
        }
        longestPath.accumulateAndGet(Float.floatToRawIntBits(longest), Math::max);
    }

    /** As {@link #describe} of a circle that rests, and that one near to it has found; several workers may have found it. */
    public void describeResting(int slot) {
        float r = state.circle[CircleRow.of(slot) + RADIUS];
        state.plan[CircleRow.vector(slot) + X] = 0f;
        state.plan[CircleRow.vector(slot) + Y] = 0f;
        level[slot] = (byte) levels.level(r);
        path[slot] = 0f;
        speculativeDistance[slot] = Paths.speculativeDistance(r, 0f);
    }

    /** Whether the circles of a bucket are in the order of their sheets, and static ones last in a sheet. */
    public boolean hasSheets() {
        return sheets;
    }

    /** The sheet of a slot: {@link GridLevels#sheetKey}. */
    public int sheet(int slot) {
        return sheetKey[slot] & ~1;
    }

    /** The sheet that a slot's cell has behind (1) or before (-1) the seams of the torus along x and y, or not behind any (0). */
    int sheetBeside(int slot, int overX, int overY) {
        int at = level[slot];
        if ((overX | overY) == 0 || !levels.folded[at]) {
            return sheet(slot);
        }
        int sheetX = levels.sheetX(state.circle[CircleRow.of(slot) + X], at);
        int sheetY = levels.sheetY(state.circle[CircleRow.of(slot) + Y], at);
        return levels.sheetKey(
                at,
                GridLevels.sheetBeside(sheetX, overX, levels.sheetsX[at]),
                GridLevels.sheetBeside(sheetY, overY, levels.sheetsY[at]));
    }

    /** The first of the slots [from, to) of a bucket that is of a sheet, or of one behind it. */
    int sheetStart(int from, int to, int sheet) {
        int low = from;
        int high = to;
        while (high - low > FEW) {
            int middle = (low + high) >>> 1;
            if (sheetKey[middle] < sheet) {
                low = middle + 1;
            } else {
                high = middle;
            }
        }
        while (low < high && sheetKey[low] < sheet) {
            low++;
        }
        return low;
    }

    /** Whether a search may scan the slots [from, to) of a bucket without checking sheets. */
    public boolean isPlain(int from, int to, int ofLevel) {
        boolean fewSheets = to - from <= GridLevels.FEW || !levels.folded[ofLevel];
        return fewSheets && (from == to || !levels.hasStatics || ((sheetKey[from] | sheetKey[to - 1]) & 1) == 0);
    }

    /**
     * What a circle that is not static looks at of the slots [from, to) of a bucket: those of the sheet that its own has behind (1) or
     * before (-1) the seams, or not behind any (0); all of them if they are few. {@link #from} and {@link #to} unpack it.
     */
    public long slotsBeside(int slot, int overX, int overY, int from, int to) {
        if (to - from <= GridLevels.FEW) {
            return range(from, to);
        }
        int sheet = sheetBeside(slot, overX, overY);
        int start = sheetStart(from, to, sheet);
        return range(start, sheetEnd(start, to, sheet));
    }

    /** The same for a static circle. */
    public long movingBeside(int slot, int overX, int overY, int from, int to) {
        int sheet = sheetBeside(slot, overX, overY);
        int start = sheetStart(from, to, sheet);
        return range(start, movingEnd(start, to, sheet));
    }

    private static long range(int from, int to) {
        return (long) from << 32 | to;
    }

    public static int from(long range) {
        return (int) (range >>> 32);
    }

    public static int to(long range) {
        return (int) range;
    }

    /** The end of a sheet's slots that begin at one, up to the end of its bucket. */
    public int sheetEnd(int from, int to, int sheet) {
        return endOf(from, to, sheet + 1);
    }

    /** The end of those of them that are not static. */
    public int movingEnd(int from, int to, int sheet) {
        return endOf(from, to, sheet);
    }

    /** A cell has few circles, or each of them is looked at anyway. */
    private int endOf(int from, int to, int lastKey) {
        int end = from;
        while (end < to && sheetKey[end] <= lastKey) {
            end++;
        }
        return end;
    }

    /** About the least radius: a static circle that moves is fast if it is so for circles of this radius. */
    float leastRadius() {
        return 0.5f * levels.top[levels.used[0]];
    }

    public long bytes() {
        return (6 * 4 + 1L) * bucketOf.length + 8L * sheetKey.length + 4L * start.length;
    }

    /** Whether any circle is fast in this step. */
    public boolean anyFast() {
        return fast;
    }

    float longestPath() {
        return Float.intBitsToFloat(longestPath.get());
    }

    boolean anyMovingStatic() {
        return movingStatics;
    }
}
