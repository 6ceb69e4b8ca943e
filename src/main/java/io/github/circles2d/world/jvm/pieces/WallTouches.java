package io.github.circles2d.world.jvm.pieces;

import static io.github.circles2d.world.model.CircleRow.DX;
import static io.github.circles2d.world.model.CircleRow.INVERSE_MASS;
import static io.github.circles2d.world.model.CircleRow.MASS;
import static io.github.circles2d.world.model.CircleRow.RADIUS;
import static io.github.circles2d.world.model.CircleRow.VX;
import static io.github.circles2d.world.model.CircleRow.X;

import io.github.circles2d.world.events.ContactEvents;
import io.github.circles2d.world.events.Partner;
import io.github.circles2d.world.events.TouchRecords;
import io.github.circles2d.world.jvm.state.State;
import io.github.circles2d.world.model.Bounce;
import io.github.circles2d.world.model.CircleRow;
import io.github.circles2d.world.model.StepConstants;
import io.github.circles2d.world.model.TouchRule;
import io.github.circles2d.world.model.WallMotion;
import io.github.circles2d.world.model.Walls;

/**
 * Records what walls do to circles in a step. The impulse of a visit is what it adds to the velocity. A visit in which an impulse
 * acts is a touch: its approach speed is that before impulses, or, in the relaxing pass, that before the visit.
 */
public final class WallTouches {
    private static final int AXES = 2;
    private static final int STRIDE = 4;

    // A row, for each axis of a slot.
    private static final int APPROACH = 0;
    private static final int IMPULSE = 1;

    /** Where the circle was along the wall when it approached fastest. */
    private static final int PLACE = 2;

    /** How fast the surfaces slid then, with the sign of {@link Walls#wallSide}. */
    private static final int SLIP = 3;

    private final State state;
    private final ContactEvents events;
    private float[] rows = new float[0];

    public WallTouches(State state, ContactEvents events) {
        this.state = state;
        this.events = events;
    }

    private static int row(int slot, int axis) {
        return STRIDE * (AXES * slot + axis);
    }

    public void ensure() {
        if (rows.length < row(state.capacity(), 0)) {
            rows = new float[row(state.capacity(), 0)];
        }
    }

    /** Begins a step for slots. */
    public void clear(int from, int to) {
        for (int t = row(from, 0); t < row(to, 0); t += STRIDE) {
            rows[t + APPROACH] = TouchRule.NONE;
            rows[t + IMPULSE] = 0f;
        }
    }

    /** A visit with bias: velocity before impulses, what the visit added to it; gap from where the wall is at the end of the step. */
    public void solved(
            int slot,
            int axis,
            float side,
            float before,
            float gained,
            float gap,
            float slip,
            StepConstants k,
            int sub) {
        int wall = WallMotion.of(axis, side);
        float r = state.circle[CircleRow.of(slot) + RADIUS];
        float now = (gap + k.walls.behind(wall, sub)) + k.walls.sweepFor(wall, r);
        visited(slot, axis, side, side * before - k.walls.speedFor(wall, r), gained, now, slip);
    }

    /** A visit without bias: velocity and gap before it. */
    void relaxed(int slot, int axis, float side, float from, float gap, float slip, StepConstants k) {
        float r = state.circle[CircleRow.of(slot) + RADIUS];
        float vn = side * from - k.walls.speedFor(WallMotion.of(axis, side), r);
        visited(slot, axis, side, vn, state.motion[CircleRow.of(slot) + VX + axis] - from, gap, slip);
    }

    /** vn: normal speed that the circle approached with. */
    private void visited(int slot, int axis, float side, float vn, float gained, float gap, float slip) {
        int t = row(slot, axis);
        float impulse = side * gained;
        rows[t + IMPULSE] += impulse;
        float approach = TouchRule.approachSpeed(vn);
        if ((impulse > 0f || gap <= 0f) && approach > rows[t + APPROACH]) {
            rows[t + APPROACH] = approach;
            rows[t + PLACE] = place(CircleRow.of(slot), axis, 1f);
            rows[t + SLIP] = Math.copySign(slip, side);
        }
    }

    /** A coordinate along the wall; at the end of a step without the displacement. */
    private float place(int s, int axis, float displaced) {
        int other = 1 - axis;
        return displaced > 0f
                ? state.circle[s + X + other] + state.motion[s + DX + other]
                : state.circle[s + X + other];
    }

    public void endStep(TouchRecords records, int from, int to, StepConstants k) {
        for (int slot = from; slot < to; slot++) {
            if (state.traits[CircleRow.of(slot) + INVERSE_MASS] != 0f) {
                endStep(records, slot, 0, k.bounds.minX(), k.bounds.maxX(), k);
                endStep(records, slot, 1, k.bounds.minY(), k.bounds.maxY(), k);
            }
        }
    }

    private void endStep(TouchRecords records, int slot, int axis, float min, float max, StepConstants k) {
        int s = CircleRow.of(slot);
        int t = row(slot, axis);
        float base = state.circle[s + X + axis];
        float r = state.circle[s + RADIUS];
        float side = Walls.wallSide(base, min, max);
        float gap = Walls.wallGap(base, state.motion[s + DX + axis], r, side, min, max);
        boolean touched = rows[t + APPROACH] >= 0f;
        float touchedSide = Math.copySign(1f, rows[t + SLIP]);
        if (touched) {
            float at = touchedSide > 0f ? min : max;
            float impulse = state.circle[s + MASS] * rows[t + IMPULSE];
            float slip = Math.abs(rows[t + SLIP]);
            tell(records, slot, axis, touchedSide, true, rows[t + APPROACH], impulse, slip, rows[t + PLACE], at, k);
        }
        if ((!touched || touchedSide != side) && TouchRule.staysInTouch(TouchRule.NONE, gap, 2f * r)) {
            boolean touches = TouchRule.touches(TouchRule.NONE, gap);
            tell(records, slot, axis, side, touches, 0f, 0f, 0f, place(s, axis, 0f), side > 0f ? min : max, k);
        }
    }

    private void tell(
            TouchRecords records,
            int slot,
            int axis,
            float side,
            boolean touches,
            float approach,
            float impulse,
            float slip,
            float place,
            float at,
            StepConstants k) {
        int id = state.id[slot];
        int wall = Partner.ofWall(axis, side);
        int pair = events.find(id, wall);
        boolean isX = axis == 0;
        float r = state.circle[CircleRow.of(slot) + RADIUS];
        float thresholdRate = isX ? k.thresholdRateX : k.thresholdRateY;
        float threshold = Bounce.bounceThreshold(2f * r, 0f, thresholdRate, k.restRate, k.fixedThreshold);
        if (events.tracker.concerns(pair, id, wall, touches, approach, impulse, threshold)) {
            float vn = side * state.motion[CircleRow.of(slot) + VX + axis]
                    - k.walls.speedFor(WallMotion.of(axis, side), r);
            float nx = isX ? -side : 0f;
            float ny = isX ? 0f : -side;
            records.add(
                    pair, id, wall, approach, impulse, nx, ny, isX ? at : place, isX ? place : at, slip, vn, threshold);
        }
    }

    public long bytes() {
        return 4L * rows.length;
    }
}
