package io.github.circles2d.world.jvm;

import static io.github.circles2d.world.model.CircleRow.RADIUS;
import static io.github.circles2d.world.model.CircleRow.X;
import static io.github.circles2d.world.model.CircleRow.Y;

import io.github.circles2d.world.circles.CircleField;
import io.github.circles2d.world.events.ContactEvents;
import io.github.circles2d.world.events.TouchRecords;
import io.github.circles2d.world.jvm.threads.Team;
import io.github.circles2d.world.model.Cells;
import io.github.circles2d.world.model.CircleMath;
import io.github.circles2d.world.model.CircleRow;
import io.github.circles2d.world.model.GridLevels;
import io.github.circles2d.world.model.PairTable;
import io.github.circles2d.world.model.SensorRule;
import io.github.circles2d.world.model.StepConstants;
import io.github.circles2d.world.model.StepReports;
import io.github.circles2d.world.model.TouchRule;
import io.github.circles2d.world.model.Tuning;

/**
 * Finds the pairs that are only sensed and touched in a step, behind its last sub-step, if they are reported; {@link SensorRule} says
 * when. It looks in the cells of the step's grid, where circles are as they were at its start. {@code Sensing.cl} does the same.
 */
final class Sensing {
    private final State state;
    private final GridLevels levels;
    private final ContactEvents events;

    /** By worker: the circles around the one that it looks at. */
    private final Nearby[] nearby;

    /** By worker: those that rest. */
    private final Resting.Found[] resting;

    /** By slot: x, y at the start of the step. */
    private float[] start = new float[0];

    /** By kind: whether the table has some other for it. */
    private final boolean[] takesPart = new boolean[PairTable.KINDS];

    /** By kind: whether it looks for another, even if it is slow. */
    private final boolean[] seeks = new boolean[PairTable.KINDS];

    /** By pair of kinds, who looks for whom. */
    private int[] seeking;

    private int version = -1;

    Sensing(State state, Grid grid, GridLevels levels, Team team, ContactEvents events) {
        this.state = state;
        nearby = Nearby.ofWorkers(grid, levels, team);
        resting = new Resting.Found[team.most()];
        for (int worker = 0; worker < resting.length; worker++) {
            resting[worker] = new Resting.Found();
        }
        this.levels = levels;
        this.events = events;
    }

    void ensure(StepReports reports) {
        learn(reports);
        if (start.length < CircleRow.vector(state.capacity())) {
            start = new float[CircleRow.vector(state.capacity())];
        }
    }

    /** Notes where circles are. */
    void begin(int from, int to) {
        for (int slot = from; slot < to; slot++) {
            start[CircleRow.vector(slot) + X] = state.circle[CircleRow.of(slot) + X];
            start[CircleRow.vector(slot) + Y] = state.circle[CircleRow.of(slot) + Y];
        }
    }

    /** Learns who looks for whom. */
    private void learn(StepReports reports) {
        seeking = reports.seeking;
        if (version == reports.seekingVersion) {
            return;
        }
        version = reports.seekingVersion;
        for (int kind = 0; kind < PairTable.KINDS; kind++) {
            takesPart[kind] = false;
            seeks[kind] = false;
            for (int other = 0; other < PairTable.KINDS; other++) {
                int row = PairTable.get(seeking, kind, other);
                takesPart[kind] |= row != SensorRule.NONE;
                seeks[kind] |= row == SensorRule.SEEKS || row == SensorRule.BOTH_SEEK;
            }
        }
    }

    /** Records the pairs that some slots have to find. */
    void find(int worker, TouchRecords records, int from, int to, StepConstants k) {
        for (int slot = from; slot < to; slot++) {
            int kind = kind(slot);
            if (takesPart[kind] && (seeks[kind] || isFast(slot))) {
                look(nearby[worker], records, slot, k);
            }
            if (takesPart[kind] && state.awake < state.n && !state.isStatic(slot)) {
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
        float path = path(slot);
        for (int n = 0; n < found.count; n++) {
            int other = found.slots[n];
            begin(other, other + 1);
            lookAt(records, slot, other, other + 1, path, k);
            lookAt(records, other, slot, slot + 1, 0f, k);
        }
    }

    private int kind(int slot) {
        return state.fields.getInt(CircleField.KIND, state.id[slot]);
    }

    private float pathX(int slot) {
        float path = state.circle[CircleRow.of(slot) + X] - start[CircleRow.vector(slot) + X];
        return state.wraps ? CircleMath.shortWay(path, state.periodX) : path;
    }

    private float pathY(int slot) {
        float path = state.circle[CircleRow.of(slot) + Y] - start[CircleRow.vector(slot) + Y];
        return state.wraps ? CircleMath.shortWay(path, state.periodY) : path;
    }

    private float path(int slot) {
        return CircleMath.length(pathX(slot), pathY(slot));
    }

    private boolean isFast(int slot) {
        return SensorRule.isFastSensed(path(slot), state.circle[CircleRow.of(slot) + RADIUS]);
    }

    private void look(Nearby near, TouchRecords records, int slot, StepConstants k) {
        float x = start[CircleRow.vector(slot) + X];
        float y = start[CircleRow.vector(slot) + Y];
        float r = state.circle[CircleRow.of(slot) + RADIUS];
        float path = path(slot);
        float toX = x + pathX(slot);
        float toY = y + pathY(slot);
        for (int l = 0; l < levels.usedCount; l++) {
            int level = levels.used[l];
            float margin = SensorRule.sensorMargin(r, path, levels.top[level]);
            float left = CircleMath.min(x, toX) - margin;
            float below = CircleMath.min(y, toY) - margin;
            float right = CircleMath.max(x, toX) + margin;
            float above = CircleMath.max(y, toY) + margin;
            near.begin(level, left, right, below, above, !state.isStatic(slot));
            while (near.next()) {
                lookAt(records, slot, near.from, near.to, path, k);
            }
        }
    }

    private void lookAt(TouchRecords records, int slot, int from, int to, float path, StepConstants k) {
        int kind = kind(slot);
        boolean isFast = isFast(slot);
        for (int other = from; other < to; other++) {
            int row = PairTable.get(seeking, kind, kind(other));
            if (row != SensorRule.NONE
                    && other != slot
                    && (isFast || row != SensorRule.FOUND)
                    && PairFilter.maySense(state, slot, other)
                    && SensorRule.findsSensed(
                            row, isFast, path, state.id[slot], isFast(other), path(other), state.id[other])) {
                boolean isLower = state.id[slot] < state.id[other];
                meet(records, isLower ? slot : other, isLower ? other : slot, k);
            }
        }
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
        if (!events.concerns(pair, lower, higher, touches, 0f, 0f, Float.MAX_VALUE)) {
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

    /** Memory of the arrays. */
    long bytes() {
        return 4L * start.length;
    }
}
