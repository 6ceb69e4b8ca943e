package io.github.circles2d.world.jvm.state;

import static io.github.circles2d.world.model.CircleRow.DX;
import static io.github.circles2d.world.model.CircleRow.DY;
import static io.github.circles2d.world.model.CircleRow.RADIUS;
import static io.github.circles2d.world.model.CircleRow.VX;
import static io.github.circles2d.world.model.CircleRow.VY;
import static io.github.circles2d.world.model.CircleRow.X;
import static io.github.circles2d.world.model.CircleRow.Y;

import io.github.circles2d.world.model.AxisEdge;
import io.github.circles2d.world.model.Bounds;
import io.github.circles2d.world.model.CircleMath;
import io.github.circles2d.world.model.CircleRow;
import io.github.circles2d.world.model.Reach;
import io.github.circles2d.world.model.StepConstants;
import java.util.Arrays;

/**
 * The circles that rest: static ones of which a step changes no bit. Steps leave them out, and the others look for them here. So a step
 * costs what moves and what is near to it. Which circles rest is no part of the state.
 *
 * <p>They lie in cells by their reach, each class of which is twice the next. A cell is a chain in no order, and cells share buckets by a
 * hash. Arrays by id have no slots, since these change.
 */
public final class Resting {
    private static final int NONE = -1;

    /** Ints of a circle in {@link #cell}. */
    private static final int CELL = 4;

    private static final int COLUMN = 0;
    private static final int ROW = 1;
    private static final int CLASS = 2;
    private static final int NEXT = 3;

    /** log2 of the buckets that lie together, in the memory that a processor loads at once. */
    private static final int LINE_LOG = 4;

    private static final int IN_LINE = (1 << LINE_LOG) - 1;

    /** Numbers of classes begin here, at the least exponent of a float. */
    private static final int LEAST_CLASS = Float.MIN_EXPONENT - 1;

    private static final int CLASSES = Float.MAX_EXPONENT - LEAST_CLASS + 1;

    /** So that no rounding hides a circle at the edge of what is looked at. */
    private static final float SLACK = 1.001f;

    private final State state;

    /** By id: x and y. */
    private float[] place = new float[0];

    /** By id: column, row and class of its cell, and the next id in the bucket. They lie together, since a search reads nothing else of most. */
    private int[] cell = new int[0];

    /** By id: its place among the members of its class. */
    private int[] rank = new int[0];

    /** By bucket: the id that came last. */
    private int[] last = new int[0];

    /** By class: ids. */
    private final int[][] members = new int[CLASSES][0];

    private final int[] count = new int[CLASSES];

    /** By class that has members: the greatest reach that one has had since the first came. */
    private final float[] greatest = new float[CLASSES];

    /** The classes that have members. */
    private final int[] used = new int[CLASSES];

    private int usedCount;
    private int size;

    /** Which kinds do not let their circles rest, as was looked at last. */
    private long[] asking;

    private int askingVersion;

    /** Whether some circle may have come to rest. */
    private volatile boolean proposed;

    /** Whether circles rest at all. */
    private boolean isOff;

    /** That of the last step; null before the first. */
    private Bounds arena;

    private float lowX;
    private float highX;
    private float lowY;
    private float highY;

    /** By order of coming: ids whose impulses, or whose being fresh, are of the step before. */
    private int[] unsettled = new int[16];

    private int unsettledCount;

    Resting(State state) {
        this.state = state;
    }

    /** From now on circles do not rest. */
    public void turnOff() {
        isOff = true;
    }

    /** Some circle may have come to rest. */
    public void propose() {
        proposed = true;
    }

    /** Begins anew with circles that have all been awakened. */
    void restart() {
        Arrays.fill(last, NONE);
        for (int k = 0; k < usedCount; k++) {
            count[used[k]] = 0;
        }
        usedCount = 0;
        size = 0;
        unsettledCount = 0;
        proposed = true;
    }

    long bytes() {
        long sum = 4L * (place.length + cell.length + rank.length + last.length + unsettled.length);
        for (int k = 0; k < usedCount; k++) {
            sum += 4L * members[used[k]].length;
        }
        return sum;
    }

    // ---- who rests

    /** Before a step, of a version of what kinds sense: wakes the circles that it may change, and lets those rest that it does not. */
    public void settle(StepConstants k, int ofKinds) {
        if (isOff) {
            return;
        }
        wakeAsking(ofKinds);
        if (size > 0 && (!isInside(k.bounds) || state.wraps && arena != null && k.arena.differs(arena))) {
            wakeMoved(k);
        }
        arena = k.arena;
        if (proposed) {
            proposed = false;
            ensure();
            for (int slot = state.awake - 1; slot >= 0; slot--) {
                if (state.isStatic(slot) && rests(slot, k)) {
                    state.rest(slot);
                }
            }
        }
    }

    /** Wakes the circles that look at static ones from now on; others may rest. */
    private void wakeAsking(int version) {
        if (state.asking == asking && (asking == null || version == askingVersion)) {
            return;
        }
        asking = state.asking;
        askingVersion = version;
        proposed = true;
        for (int slot = state.awake; slot < state.n; slot++) {
            if (state.asks(slot)) {
                // brings one here that has been looked at
                state.wake(slot);
            }
        }
    }

    private boolean isInside(Bounds b) {
        return b.minX() <= lowX && highX <= b.maxX() && b.minY() <= lowY && highY <= b.maxY();
    }

    private void wakeMoved(StepConstants k) {
        for (int slot = state.awake; slot < state.n; slot++) {
            if (!rests(slot, k)) {
                // brings one here that has been looked at
                state.wake(slot);
            }
        }
        lowX = Math.max(lowX, k.bounds.minX());
        highX = Math.min(highX, k.bounds.maxX());
        lowY = Math.max(lowY, k.bounds.minY());
        highY = Math.min(highY, k.bounds.maxY());
    }

    /** Whether a step changes no bit of a static circle. */
    private boolean rests(int slot, StepConstants k) {
        if (state.sleepers != null && state.sleepers.isAsleep(state.id[slot])) {
            return true;
        }
        int s = CircleRow.of(slot);
        float[] m = state.motion;
        return isZero(m[s + VX])
                && isZero(m[s + VY])
                && stays(state.circle[s + X], m[s + DX], k.bounds.minX(), k.bounds.maxX())
                && stays(state.circle[s + Y], m[s + DY], k.bounds.minY(), k.bounds.maxY())
                && CircleMath.laps(state.circle[s + X], k.arena.minX(), k.arena.periodX()) == 0f
                && CircleMath.laps(state.circle[s + Y], k.arena.minY(), k.arena.periodY()) == 0f
                && (state.turning == null || isZero(state.turning.angularVelocity[slot]))
                && (state.pieces == null || state.pieces.count[slot] == 0)
                && !state.asks(slot);
    }

    private static boolean isZero(float value) {
        return Float.floatToRawIntBits(value) == 0;
    }

    private static boolean stays(float base, float d, float min, float max) {
        float x = base + d;
        return min <= base
                && base <= max
                && isSame(x, base)
                && isSame(CircleMath.clamp(x, min, max), base)
                && isSame(CircleMath.lostByRounding(base, d, x), d);
    }

    private static boolean isSame(float one, float other) {
        return Float.floatToRawIntBits(one) == Float.floatToRawIntBits(other);
    }

    // ---- impulses

    /** Takes note that a circle that rests may get impulses in this step, or has some. */
    public void unsettle(int id) {
        if (unsettledCount == unsettled.length) {
            unsettled = Arrays.copyOf(unsettled, 2 * unsettledCount);
        }
        unsettled[unsettledCount++] = id;
    }

    /** Between steps: moves the impulses of circles that rest, with others that do not move either, to those of {@link Sleepers}. */
    public void moveToSleepers(ImpulseCache cache, Sleepers sleepers) {
        for (int n = 0; n < unsettledCount; n++) {
            int slot = state.slotOf[unsettled[n]];
            if (slot >= state.awake) {
                cache.moveToSleepers(slot, sleepers);
            }
        }
    }

    /** As a step does with the others: the impulses of the step before are gone, and nobody is fresh. */
    public void forgetImpulses() {
        for (int n = 0; n < unsettledCount; n++) {
            int slot = state.slotOf[unsettled[n]];
            if (slot >= state.awake) {
                state.firstCached[slot] = NONE;
                state.fresh[slot] = false;
            }
        }
        unsettledCount = 0;
    }

    // ---- cells

    /** Makes room for ids. */
    public void ensure() {
        if (rank.length < state.slotOf.length) {
            int ids = state.slotOf.length;
            place = Arrays.copyOf(place, CircleRow.vector(ids));
            cell = Arrays.copyOf(cell, CELL * ids);
            rank = Arrays.copyOf(rank, ids);
        }
    }

    /** Adds the circle of a slot, which rests from now on. */
    void add(int slot) {
        int id = state.id[slot];
        int s = CircleRow.of(slot);
        float reach = Reach.reachOf(state.circle[s + RADIUS], 0f, true);
        int ofClass = Math.getExponent(reach) - LEAST_CLASS;
        float inverseEdge = inverseEdge(ofClass);
        place[CircleRow.vector(id) + X] = state.circle[s + X];
        place[CircleRow.vector(id) + Y] = state.circle[s + Y];
        cell[CELL * id + COLUMN] = Reach.reachCell(state.circle[s + X], 0f, inverseEdge);
        cell[CELL * id + ROW] = Reach.reachCell(state.circle[s + Y], 0f, inverseEdge);
        cell[CELL * id + CLASS] = ofClass;
        if (count[ofClass] == members[ofClass].length) {
            members[ofClass] = Arrays.copyOf(members[ofClass], Math.max(16, 2 * count[ofClass]));
        }
        if (2 * size >= last.length) {
            rehash(Math.max(64, 2 * last.length));
        }
        if (count[ofClass] == 0) {
            used[usedCount++] = ofClass;
            greatest[ofClass] = 0f;
        }
        greatest[ofClass] = Math.max(greatest[ofClass], reach);
        rank[id] = count[ofClass];
        members[ofClass][count[ofClass]++] = id;
        link(id);
        widen(state.circle[s + X], state.circle[s + Y]);
        size++;
        if (state.fresh[slot] || state.firstCached[slot] >= 0) {
            unsettle(id);
        }
    }

    private void rehash(int buckets) {
        last = new int[buckets];
        Arrays.fill(last, NONE);
        for (int k = 0; k < usedCount; k++) {
            for (int n = 0; n < count[used[k]]; n++) {
                link(members[used[k]][n]);
            }
        }
    }

    /** Makes the rectangle around all circles wide enough for a place. */
    private void widen(float x, float y) {
        lowX = size == 0 ? x : Math.min(lowX, x);
        highX = size == 0 ? x : Math.max(highX, x);
        lowY = size == 0 ? y : Math.min(lowY, y);
        highY = size == 0 ? y : Math.max(highY, y);
    }

    void remove(int id) {
        int ofClass = cell[CELL * id + CLASS];
        int bucket = bucket(id);
        int next = cell[CELL * id + NEXT];
        if (last[bucket] == id) {
            last[bucket] = next;
        } else {
            int before = last[bucket];
            while (cell[CELL * before + NEXT] != id) {
                before = cell[CELL * before + NEXT];
            }
            cell[CELL * before + NEXT] = next;
        }
        int moved = members[ofClass][--count[ofClass]];
        members[ofClass][rank[id]] = moved;
        rank[moved] = rank[id];
        if (count[ofClass] == 0) {
            int k = 0;
            while (used[k] != ofClass) {
                k++;
            }
            used[k] = used[--usedCount];
        }
        size--;
    }

    private void link(int id) {
        int bucket = bucket(id);
        cell[CELL * id + NEXT] = last[bucket];
        last[bucket] = id;
    }

    private static float inverseEdge(int ofClass) {
        return powerOfTwo(-(ofClass + LEAST_CLASS + 1 + Reach.EDGE_LOG));
    }

    private static float powerOfTwo(int exponent) {
        return Float.intBitsToFloat((Float.MAX_EXPONENT + exponent) << 23);
    }

    private int bucket(int id) {
        int row = CELL * id;
        return line(cell[row + COLUMN], cell[row + ROW], cell[row + CLASS]) | cell[row + COLUMN] & IN_LINE;
    }

    /**
     * The first bucket of a line of cells. Cells side by side have buckets side by side: a search that looks into several, most of them empty,
     * waits for memory once a row.
     */
    private int line(int column, int row, int ofClass) {
        return Reach.reachBucket(column >> LINE_LOG, row, ofClass, last.length >> LINE_LOG) << LINE_LOG;
    }

    // ---- searches

    /** Slots that a search has found. Each worker has its own. */
    public static final class Found {
        public int[] slots = new int[64];
        public int count;

        /** Circles that searches have looked at. */
        public long tested;

        private void add(int slot) {
            if (count == slots.length) {
                slots = Arrays.copyOf(slots, 2 * count);
            }
            slots[count++] = slot;
        }

        private boolean has(int slot) {
            for (int k = 0; k < count; k++) {
                if (slots[k] == slot) {
                    return true;
                }
            }
            return false;
        }
    }

    /** Finds the circles whose reach meets a rectangle, each once, and maybe some beside it. */
    public void find(Found found, Bounds bounds, float left, float right, float below, float above) {
        find(found, bounds, left, right, below, above, 1f);
    }

    /** The same with every reach some times as far. */
    public void find(Found found, Bounds bounds, float left, float right, float below, float above, float stretch) {
        found.count = 0;
        float farthest = CircleMath.max(
                CircleMath.max(Math.abs(left), Math.abs(right)), CircleMath.max(Math.abs(below), Math.abs(above)));
        float rounding = CircleMath.max(bounds.magnitude(), farthest) * 0x1p-20f;
        for (int k = 0; k < usedCount; k++) {
            int ofClass = used[k];
            float far = stretch * (SLACK * greatest[ofClass]) + rounding;
            if (state.wraps) {
                findImages(found, bounds, ofClass, left - far, right + far, below - far, above + far);
            } else if (left - far <= highX && lowX <= right + far && below - far <= highY && lowY <= above + far) {
                scan(found, ofClass, left - far, right + far, below - far, above + far, false);
            }
        }
    }

    private void findImages(Found found, Bounds b, int ofClass, float left, float right, float below, float above) {
        boolean again = right - left > 0.99f * state.periodX || above - below > 0.99f * state.periodY;
        boolean wrapsX = b.edgeX() == AxisEdge.WRAP;
        boolean wrapsY = b.edgeY() == AxisEdge.WRAP;
        for (int u = wrapsX ? -1 : 0; u <= (wrapsX ? 1 : 0); u++) {
            float fromX = u == 0 ? left : left + u * state.periodX;
            float toX = u == 0 ? right : right + u * state.periodX;
            if (u != 0 && (toX < b.minX() || fromX > b.maxX())) {
                continue;
            }
            for (int v = wrapsY ? -1 : 0; v <= (wrapsY ? 1 : 0); v++) {
                float fromY = v == 0 ? below : below + v * state.periodY;
                float toY = v == 0 ? above : above + v * state.periodY;
                if (v == 0 || !(toY < b.minY() || fromY > b.maxY())) {
                    scan(found, ofClass, fromX, toX, fromY, toY, again);
                }
            }
        }
    }

    /** Finds the circles of a class in a rectangle. again: whether some may have been found before. */
    private void scan(Found found, int ofClass, float left, float right, float below, float above, boolean again) {
        float inverseEdge = inverseEdge(ofClass);
        int c0 = Reach.reachCell(left, 0f, inverseEdge);
        int c1 = Reach.reachCell(right, 0f, inverseEdge);
        int r0 = Reach.reachCell(below, 0f, inverseEdge);
        int r1 = Reach.reachCell(above, 0f, inverseEdge);
        if ((c1 - c0 + 1L) * (r1 - r0 + 1L) >= count[ofClass]) {
            for (int n = 0; n < count[ofClass]; n++) {
                take(found, members[ofClass][n], left, right, below, above, again);
            }
            found.tested += count[ofClass];
            return;
        }
        for (int row = r0; row <= r1; row++) {
            int line = 0;
            for (int column = c0; column <= c1; column++) {
                int inLine = column & IN_LINE;
                line = column == c0 || inLine == 0 ? line(column, row, ofClass) : line;
                int id = last[line | inLine];
                while (id != NONE) {
                    int c = CELL * id;
                    if (cell[c + COLUMN] == column && cell[c + ROW] == row && cell[c + CLASS] == ofClass) {
                        take(found, id, left, right, below, above, again);
                    }
                    found.tested++;
                    id = cell[c + NEXT];
                }
            }
        }
    }

    private void take(Found found, int id, float left, float right, float below, float above, boolean again) {
        float x = place[CircleRow.vector(id) + X];
        float y = place[CircleRow.vector(id) + Y];
        if (left <= x && x <= right && below <= y && y <= above) {
            int slot = state.slotOf[id];
            if (!again || !found.has(slot)) {
                found.add(slot);
            }
        }
    }
}
