package io.github.circles2d.world.jvm;

import static io.github.circles2d.world.model.CircleRow.RADIUS;
import static io.github.circles2d.world.model.CircleRow.X;
import static io.github.circles2d.world.model.CircleRow.Y;

import io.github.circles2d.world.circles.CircleField;
import io.github.circles2d.world.events.ContactEvents;
import io.github.circles2d.world.events.TouchRecords;
import io.github.circles2d.world.jvm.grid.Grid;
import io.github.circles2d.world.jvm.grid.Nearby;
import io.github.circles2d.world.jvm.grid.PairFilter;
import io.github.circles2d.world.jvm.state.Resting;
import io.github.circles2d.world.jvm.state.State;
import io.github.circles2d.world.jvm.threads.Team;
import io.github.circles2d.world.model.Cells;
import io.github.circles2d.world.model.CircleMath;
import io.github.circles2d.world.model.CircleRow;
import io.github.circles2d.world.model.GridLevels;
import io.github.circles2d.world.model.PairTable;
import io.github.circles2d.world.model.Reach;
import io.github.circles2d.world.model.SensorRule;
import io.github.circles2d.world.model.StepConstants;
import io.github.circles2d.world.model.StepReports;
import io.github.circles2d.world.model.TouchRule;
import io.github.circles2d.world.model.Tuning;
import java.util.Arrays;

/**
 * Finds the pairs that are only sensed and touched in a step, behind its last sub-step, if they are reported; {@link SensorRule} says
 * when. It looks in the cells of the step's grid, where circles are as they were at its start. {@code Sensing.cl} does the same, but there
 * the sensors look for others; here the circles of that kind do of which there are fewer. Of circles that sense their own kind alone, those do
 * not look that are slow, have moved as planned, and have none near.
 */
final class Sensing {
    /** An eighth more than needed, for rounding and for {@link TouchRule#SLACK}. */
    private static final float MORE = 1.125f;

    /** In radii: with {@link TouchRule#SLACK} it is less than the slack of {@link Reach}, and than {@link Tuning#MARGIN}. */
    private static final float STRAY = 0.004f;

    private final State state;
    private final Grid grid;
    private final GridLevels levels;
    private final Team team;
    private final ContactEvents events;

    /** By worker: the circles around the one that it looks at. */
    private final Nearby[] nearby;

    /** By worker: those that rest. */
    private final Resting.Found[] resting;

    /** By slot: x, y at the start of the step. */
    private float[] start = new float[0];

    /** By slot, at the end of the step: the kind. */
    private int[] kind = new int[0];

    /** By slot, at the end of the step: the length of the path. */
    private float[] path = new float[0];

    /** By slot: radius and path, times {@link #MORE}; NaN if the kind takes no part. Only circles touch whose reaches meet. */
    private float[] reach = new float[0];

    /** By worker and level: the longest path of a circle that is not fast. */
    private final float[][] longest;

    /** By kind: whether the table has some other for it. */
    private final boolean[] takesPart = new boolean[PairTable.KINDS];

    /** By kind: whether it looks for another, even if it is slow. */
    private final boolean[] seeks = new boolean[PairTable.KINDS];

    /** By kind: whether it senses itself, and no other. */
    private final boolean[] keepsToItself = new boolean[PairTable.KINDS];

    /** By slot: whether another circle is near, as pairs and continuous collision have found; they look no farther than plans go. */
    private boolean[] seen = new boolean[0];

    /** By slot: whether it has not moved as was planned. */
    private boolean[] strays = new boolean[0];

    /** Those kinds that take part. */
    private final int[] kinds = new int[PairTable.KINDS];

    private int kindCount;

    /** By pair of kinds, whether they sense each other. */
    private int[] sensed;

    private int version = -1;

    /** Bits by kind, whether its static circles look at static ones, too; null if none do. */
    private long[] asking;

    /** By kind: whether it or a kind that it senses asks for that; null as long as none has. */
    private boolean[] meetsStatic;

    /** By pair of kinds, who looks for whom. */
    private final int[] seeking = new int[PairTable.WORDS];

    /** By worker and kind: the number of circles in this step; by kind: that for which {@link #seeking} was made. */
    private final int[][] counts;

    private final int[] count = new int[PairTable.KINDS];

    Sensing(State state, Grid grid, GridLevels levels, Team team, ContactEvents events) {
        this.state = state;
        this.team = team;
        this.grid = grid;
        counts = new int[team.most()][PairTable.KINDS];
        longest = new float[team.most()][GridLevels.COUNT];
        nearby = Nearby.ofWorkers(grid, levels, team);
        resting = new Resting.Found[team.most()];
        for (int worker = 0; worker < resting.length; worker++) {
            resting[worker] = new Resting.Found();
        }
        this.levels = levels;
        this.events = events;
    }

    void ensure(StepReports reports) {
        asking = reports.asking;
        if (asking != null && meetsStatic == null) {
            meetsStatic = new boolean[PairTable.KINDS];
            version = -1;
        }
        learn(reports);
        if (kind.length < state.capacity()) {
            start = new float[CircleRow.vector(state.capacity())];
            path = new float[state.capacity()];
            reach = new float[state.capacity()];
            seen = new boolean[state.capacity()];
            strays = new boolean[state.capacity()];
            kind = new int[state.capacity()];
        }
    }

    /** Begins a step of the circles that move. */
    void beginStep(int from, int to) {
        Arrays.fill(seen, from, to, false);
        begin(from, to);
    }

    /** What is to note by slot which circles have others near, for each pair that it finds. */
    boolean[] seen() {
        return seen;
    }

    /** Notes where circles are. */
    private void begin(int from, int to) {
        for (int slot = from; slot < to; slot++) {
            start[CircleRow.vector(slot) + X] = state.circle[CircleRow.of(slot) + X];
            start[CircleRow.vector(slot) + Y] = state.circle[CircleRow.of(slot) + Y];
        }
    }

    /** Learns which kinds sense each other. */
    private void learn(StepReports reports) {
        sensed = reports.seeking;
        if (version == reports.seekingVersion) {
            return;
        }
        version = reports.seekingVersion;
        Arrays.fill(seeking, SensorRule.NONE);
        Arrays.fill(count, 0);
        kindCount = 0;
        for (int a = 0; a < PairTable.KINDS; a++) {
            takesPart[a] = false;
            boolean some = false;
            for (int b = 0; b < PairTable.KINDS; b++) {
                boolean meets = PairTable.get(sensed, a, b) != SensorRule.NONE;
                takesPart[a] |= meets;
                some |= meets && asks(a, b);
            }
            if (meetsStatic != null) {
                meetsStatic[a] = some;
            }
            kinds[kindCount] = a;
            kindCount += takesPart[a] ? 1 : 0;
        }
    }

    /** Whether static circles of two kinds that sense each other do. */
    private boolean asks(int a, int b) {
        return asking != null && (StepReports.asks(asking, a) || StepReports.asks(asking, b));
    }

    /** Once circles are where the step leaves them: notes how far some slots reach, and counts their kinds. */
    void measure(int worker, int from, int to) {
        int[] ofWorker = counts[worker];
        float[] ofLevels = longest[worker];
        Arrays.fill(ofWorker, 0);
        Arrays.fill(ofLevels, 0f);
        for (int slot = from; slot < to; slot++) {
            measure(slot);
            strays[slot] = strays(slot);
            ofWorker[kind[slot]]++;
            int level = grid.level[slot];
            ofLevels[level] = isFast(slot) ? ofLevels[level] : CircleMath.max(path[slot], ofLevels[level]);
        }
    }

    /** Whether a circle has gone elsewhere than planned by more than what contacts and continuous collision look farther. */
    private boolean strays(int slot) {
        float offX = pathX(slot) - state.plan[CircleRow.vector(slot) + X];
        float offY = pathY(slot) - state.plan[CircleRow.vector(slot) + Y];
        boolean isClose = Math.abs(offX) + Math.abs(offY) <= STRAY * state.circle[CircleRow.of(slot) + RADIUS];
        return !isClose || state.isStatic(slot);
    }

    private void measure(int slot) {
        kind[slot] = state.fields.getInt(CircleField.KIND, state.id[slot]);
        path[slot] = CircleMath.length(pathX(slot), pathY(slot));
        reach[slot] =
                takesPart[kind[slot]] ? MORE * (state.circle[CircleRow.of(slot) + RADIUS] + path[slot]) : Float.NaN;
    }

    /** Decides who looks for whom, once all slots are measured. No result depends on that. */
    void settle() {
        boolean same = true;
        for (int k = 0; k < PairTable.KINDS; k++) {
            int sum = 0;
            for (int w = 0; w < team.size(); w++) {
                sum += counts[w][k];
            }
            same &= count[k] == sum;
            count[k] = sum;
        }
        for (int k = 0; k < kindCount && !same; k++) {
            settle(kinds[k]);
        }
        for (int w = 1; w < team.size(); w++) {
            for (int level = 0; level < GridLevels.COUNT; level++) {
                longest[0][level] = CircleMath.max(longest[w][level], longest[0][level]);
            }
        }
    }

    private void settle(int a) {
        seeks[a] = false;
        keepsToItself[a] = true;
        for (int k = 0; k < kindCount; k++) {
            int b = kinds[k];
            int row = PairTable.get(sensed, a, b);
            if (row != SensorRule.NONE && a != b) {
                boolean looks = count[a] < count[b] || count[a] == count[b] && a < b;
                row = looks ? SensorRule.SEEKS : SensorRule.FOUND;
            }
            PairTable.setOne(seeking, a, b, row);
            keepsToItself[a] &= a == b || row == SensorRule.NONE;
            seeks[a] |= row == SensorRule.SEEKS || row == SensorRule.BOTH_SEEK;
        }
    }

    /** Records the pairs that some slots have to find. */
    void find(int worker, TouchRecords records, int from, int to, StepConstants k) {
        for (int slot = from; slot < to; slot++) {
            if (!takesPart[kind[slot]]) {
                continue;
            }
            if (looks(slot)) {
                look(nearby[worker], records, slot, k);
            }
            if (state.awake < state.n && (!state.isStatic(slot) || state.asks(slot))) {
                lookAtResting(resting[worker], records, slot, k);
            }
        }
    }

    /** Looks at circles that rest for both: these do not look themselves. */
    private void lookAtResting(Resting.Found found, TouchRecords records, int slot, StepConstants k) {
        float x = start[CircleRow.vector(slot) + X];
        float y = start[CircleRow.vector(slot) + Y];
        float toX = x + pathX(slot);
        float toY = y + pathY(slot);
        float margin = SensorRule.sensorMargin(state.circle[CircleRow.of(slot) + RADIUS], 0f, 0f);
        state.resting.find(
                found,
                levels.bounds,
                CircleMath.min(x, toX) - margin,
                CircleMath.max(x, toX) + margin,
                CircleMath.min(y, toY) - margin,
                CircleMath.max(y, toY) + margin);
        for (int n = 0; n < found.count; n++) {
            int other = found.slots[n];
            measureResting(other);
            lookAt(records, slot, other, other + 1, k);
            lookAt(records, other, slot, slot + 1, k);
        }
    }

    /** Measures a circle that rests. Several workers may do it at once. */
    void measureResting(int slot) {
        begin(slot, slot + 1);
        measure(slot);
    }

    int kind(int slot) {
        return kind[slot];
    }

    /** Whether circles of the kind of a slot sense others. */
    boolean takesPart(int slot) {
        return takesPart[kind[slot]];
    }

    /** Where a circle was as the step began. */
    float startX(int slot) {
        return start[CircleRow.vector(slot) + X];
    }

    float startY(int slot) {
        return start[CircleRow.vector(slot) + Y];
    }

    /** How far a circle has gone in the step. */
    float pathX(int slot) {
        float path = state.circle[CircleRow.of(slot) + X] - start[CircleRow.vector(slot) + X];
        return state.wraps ? CircleMath.shortWay(path, state.periodX) : path;
    }

    float pathY(int slot) {
        float path = state.circle[CircleRow.of(slot) + Y] - start[CircleRow.vector(slot) + Y];
        return state.wraps ? CircleMath.shortWay(path, state.periodY) : path;
    }

    private boolean isFast(int slot) {
        return SensorRule.isFastSensed(path[slot], state.circle[CircleRow.of(slot) + RADIUS]);
    }

    private void look(Nearby near, TouchRecords records, int slot, StepConstants k) {
        float x = start[CircleRow.vector(slot) + X];
        float y = start[CircleRow.vector(slot) + Y];
        float r = state.circle[CircleRow.of(slot) + RADIUS];
        float toX = x + pathX(slot);
        float toY = y + pathY(slot);
        float fast = isFast(slot) ? path[slot] : 0f;
        boolean statics = !state.isStatic(slot) || asking != null && meetsStatic[kind[slot]];
        for (int l = 0; l < levels.usedCount; l++) {
            int level = levels.used[l];
            // a slow circle finds slow ones, a fast one also those that are not as fast
            float margin = MORE * ((r + levels.top[level]) + CircleMath.max(fast, longest[0][level]));
            float left = CircleMath.min(x, toX) - margin;
            float below = CircleMath.min(y, toY) - margin;
            float right = CircleMath.max(x, toX) + margin;
            float above = CircleMath.max(y, toY) + margin;
            if (!levels.folded[level] && (statics || !grid.hasSheets())) {
                lookInRows(records, slot, level, left, right, below, above, k);
                continue;
            }
            near.begin(level, left, right, below, above, statics);
            while (near.next()) {
                lookAt(records, slot, near.from, near.to, k);
            }
        }
    }

    /** Row by row: a walk that knows of sheets takes longer. */
    private void lookInRows(
            TouchRecords records,
            int slot,
            int level,
            float left,
            float right,
            float below,
            float above,
            StepConstants k) {
        int columns = levels.columnCount[level];
        int rows = levels.rowCount[level];
        int c0 = levels.columnFrom(left, level);
        int c1 = levels.columnTo(left, right, level);
        int r0 = levels.rowFrom(below, level);
        int r1 = levels.rowTo(below, above, level);
        int column = GridLevels.onRing(c0, columns);
        int end = column + Math.min(c1 - c0 + 1, columns);
        int row = GridLevels.onRing(r0, rows);
        for (int v = Math.min(r1 - r0 + 1, rows); v > 0; v--) {
            int b = levels.rowStart(level, row);
            lookAt(records, slot, grid.start[b + column], grid.start[b + Math.min(end, columns)], k);
            if (end > columns) {
                lookAt(records, slot, grid.start[b], grid.start[b + end - columns], k);
            }
            row = row + 1 < rows ? row + 1 : 0;
        }
    }

    private void lookAt(TouchRecords records, int slot, int from, int to, StepConstants k) {
        float x = start[CircleRow.vector(slot) + X];
        float y = start[CircleRow.vector(slot) + Y];
        float own = reach[slot];
        for (int other = from; other < to; other++) {
            float dx = start[CircleRow.vector(other) + X] - x;
            float dy = start[CircleRow.vector(other) + Y] - y;
            if (state.wraps) {
                dx = CircleMath.shortWay(dx, state.periodX);
                dy = CircleMath.shortWay(dy, state.periodY);
            }
            float far = own + reach[other];
            if (dx * dx + dy * dy <= far * far && other != slot && (finds(slot, other) || findsFor(slot, other))) {
                boolean isLower = state.id[slot] < state.id[other];
                meet(records, isLower ? slot : other, isLower ? other : slot, k);
            }
        }
    }

    /** Whether a circle looks around. Of a kind that keeps to itself, those do not that are slow, have moved as planned, and have none near. */
    private boolean looks(int slot) {
        boolean fast = isFast(slot);
        boolean near = strays[slot] || seen[slot] || !keepsToItself[kind[slot]];
        return fast || seeks[kind[slot]] && near;
    }

    /** Whether a circle finds a pair in place of the other, which does not look. */
    private boolean findsFor(int slot, int other) {
        boolean move = slot < state.awake && other < state.awake; // for others lookAtResting does it
        return move && takesPart[kind[other]] && keepsToItself[kind[other]] && !looks(other) && finds(other, slot);
    }

    private boolean finds(int slot, int other) {
        int row = PairTable.get(seeking, kind[slot], kind[other]);
        return row != SensorRule.NONE
                && PairFilter.maySense(state, slot, other, asks(kind[slot], kind[other]))
                && SensorRule.findsSensed(
                        row, isFast(slot), path[slot], state.id[slot], isFast(other), path[other], state.id[other]);
    }

    /** Records a pair, a of the lower id, if needed: as it begins to touch, or across a gap when it is closest. */
    private void meet(TouchRecords records, int a, int b, StepConstants k) {
        float ax = start[CircleRow.vector(a) + X];
        float ay = start[CircleRow.vector(a) + Y];
        float dx = CircleMath.shortWay(
                start[CircleRow.vector(b) + X] - ax, events.arena().periodX());
        float dy = CircleMath.shortWay(
                start[CircleRow.vector(b) + Y] - ay, events.arena().periodY());
        float ux = pathX(b) - pathX(a);
        float uy = pathY(b) - pathY(a);
        float r = state.circle[CircleRow.of(a) + RADIUS];
        float sum = r + state.circle[CircleRow.of(b) + RADIUS];
        float closest = SensorRule.timeOfClosest(dx, dy, ux, uy);
        float least = SensorRule.sensedSeparation(dx, dy, ux, uy, closest, sum);
        if (!TouchRule.staysInTouch(TouchRule.NONE, least, sum)) {
            return;
        }
        int lower = state.id[a];
        int higher = state.id[b];
        int pair = events.find(lower, higher);
        records.stay(pair == ContactEvents.NONE ? 0 : 1);
        boolean touches = TouchRule.touches(TouchRule.NONE, least);
        if (!events.tracker.concerns(pair, lower, higher, touches, 0f, 0f, Float.MAX_VALUE)) {
            return;
        }
        float t = touches ? SensorRule.timeSensed(dx, dy, ux, uy, sum) : closest;
        float mx = dx + t * ux;
        float my = dy + t * uy;
        float distance = CircleMath.length(mx, my);
        boolean apart = distance > Tuning.COINCIDENT * sum;
        float towardsX = apart ? mx : Cells.partingX(Cells.pairHash(lower, higher));
        float towardsY = apart ? my : Cells.partingY(Cells.pairHash(lower, higher));
        float length = CircleMath.length(towardsX, towardsY);
        float nx = towardsX / length;
        float ny = towardsY / length;
        float vn = CircleMath.dot(nx, ny, ux / k.dt, uy / k.dt);
        float px = TouchRule.touchPoint(ax, t * pathX(a), nx, r, distance - sum);
        float py = TouchRule.touchPoint(ay, t * pathY(a), ny, r, distance - sum);
        float approach = TouchRule.approachSpeed(vn);
        records.add(pair, lower, higher, approach, 0f, nx, ny, px, py, 0f, vn, Float.MAX_VALUE);
    }

    long bytes() {
        return 4L * (start.length + path.length + reach.length + kind.length) + seen.length + strays.length;
    }
}
