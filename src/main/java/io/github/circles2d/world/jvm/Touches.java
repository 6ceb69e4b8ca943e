package io.github.circles2d.world.jvm;

import static io.github.circles2d.world.jvm.ContactRow.NORMAL_IMPULSE;
import static io.github.circles2d.world.jvm.ContactRow.RADII;
import static io.github.circles2d.world.jvm.ContactRow.SEPARATION;
import static io.github.circles2d.world.model.CircleRow.BEFORE_X;
import static io.github.circles2d.world.model.CircleRow.BEFORE_Y;
import static io.github.circles2d.world.model.CircleRow.DX;
import static io.github.circles2d.world.model.CircleRow.DY;
import static io.github.circles2d.world.model.CircleRow.RADIUS;
import static io.github.circles2d.world.model.CircleRow.VX;
import static io.github.circles2d.world.model.CircleRow.VY;
import static io.github.circles2d.world.model.CircleRow.X;
import static io.github.circles2d.world.model.CircleRow.Y;

import io.github.circles2d.world.events.ContactEvents;
import io.github.circles2d.world.events.TouchRecords;
import io.github.circles2d.world.jvm.threads.Team;
import io.github.circles2d.world.model.Bounce;
import io.github.circles2d.world.model.CircleMath;
import io.github.circles2d.world.model.StepConstants;
import io.github.circles2d.world.model.TouchRule;
import java.util.Arrays;

/**
 * Records what contacts do in a step, if events are reported. It looks at a row of contacts after each pass over it; the passes
 * themselves tell it of impulses that they do not keep. {@link WallTouches} does the same for walls.
 */
final class Touches {
    private static final int STRIDE = 4;
    private static final boolean[] ALL = new boolean[0];

    // A row: what an event says of a contact, and of the sub-step its approach speed and what no contact keeps.
    private static final int APPROACH = 0;
    private static final int IMPULSE = 1;
    private static final int APPROACH_NOW = 2;
    private static final int IMPULSE_NOW = 3;

    // A place.
    private static final int AT_NORMAL_X = 0;
    private static final int AT_NORMAL_Y = 1;
    private static final int POINT_X = 2;
    private static final int POINT_Y = 3;

    private final State state;
    private final Contacts contacts;

    /** Who is told. */
    final ContactEvents events;

    /** Null if walls are not reported. */
    final WallTouches walls;

    /** By worker: the contacts that it has told of, and that need a record; and how many. */
    private final int[][] listed;

    private final int[] count;

    /** By contact: whether it is reported; without elements where all contacts are. */
    private boolean[] wanted = new boolean[0];

    /** By contact: the number that its pair had among those that touched when it was told of; also of the step before. */
    private int[] number = new int[0];

    private int[] numberBefore = new int[0];

    private float[] rows = new float[0];

    /** By contact: where it touches. Noted within the step only if it is fast, so contacts at rest leave it alone. */
    private float[] places = new float[0];

    Touches(State state, Contacts contacts, Team team, ContactEvents events) {
        this.state = state;
        this.contacts = contacts;
        this.events = events;
        walls = events.hasWalls() ? new WallTouches(state, events) : null;
        listed = new int[team.most()][64];
        count = new int[team.most()];
    }

    void ensure(int many) {
        if (events.hasAllPairs()) {
            wanted = ALL;
        } else if (wanted.length < many || wanted == ALL) {
            wanted = new boolean[many + (many >> 2) + 1];
        }
        if (number.length < many) {
            number = new int[many + (many >> 2)];
        }
        if (rows.length < STRIDE * (long) many) {
            int length = Math.multiplyExact(STRIDE, many + (many >> 2));
            places = new float[length];
            rows = new float[length];
        }
    }

    /** Begins a step: what is known of contacts is of the step before. */
    void begin() {
        int[] before = numberBefore;
        numberBefore = number;
        number = before;
    }

    /** Takes note which contact of the step before a contact goes on from, or -1. */
    void follow(int c, int before) {
        number[c] = before < 0 || before >= numberBefore.length ? ContactEvents.NONE : numberBefore[before];
    }

    /** Begins a step for contacts. */
    void clear(int from, int to) {
        for (int t = STRIDE * from; t < STRIDE * to; t += STRIDE) {
            rows[t + APPROACH] = TouchRule.NONE;
            rows[t + IMPULSE] = 0f;
            rows[t + IMPULSE_NOW] = 0f;
        }
        for (int c = from; wanted != ALL && c < to; c++) {
            long ids = contacts.ids(c);
            wanted[c] = events.typesOfCircles((int) (ids >>> 32), (int) ids) != 0;
        }
    }

    /** An impulse that has acted, or will, and that the contact does not keep as its normal impulse. */
    void add(int c, float impulse) {
        rows[STRIDE * c + IMPULSE_NOW] += impulse;
    }

    /** Looks at contacts after the biased pass. */
    void afterSolve(int from, int to, StepConstants k) {
        float[] q = contacts.contact;
        float[] load = state.load;
        for (int c = from; c < to; c++) {
            if (isUnwanted(c)) {
                continue;
            }
            int o = ContactRow.of(c);
            int t = STRIDE * c;
            int a = contacts.pair[ContactRow.a(c)];
            int b = contacts.pair[ContactRow.b(c)];
            float beforeX = load[b + BEFORE_X] - load[a + BEFORE_X];
            float beforeY = load[b + BEFORE_Y] - load[a + BEFORE_Y];
            float before = CircleMath.dot(q[o + ContactRow.NORMAL_X], q[o + ContactRow.NORMAL_Y], beforeX, beforeY);
            float approach = TouchRule.approach(before);
            float impulse = q[o + NORMAL_IMPULSE] + rows[t + IMPULSE_NOW];
            rows[t + APPROACH_NOW] = approach;
            note(o, t, a, impulse, q[o + SEPARATION], k.dt);
        }
    }

    /** Looks at contacts after the relaxing pass. */
    void afterRelax(int worker, int from, int to, StepConstants k, boolean last) {
        float[] q = contacts.contact;
        for (int c = from; c < to; c++) {
            if (isUnwanted(c)) {
                continue;
            }
            int o = ContactRow.of(c);
            int t = STRIDE * c;
            float impulse = rows[t + IMPULSE_NOW] + q[o + NORMAL_IMPULSE];
            rows[t + IMPULSE_NOW] = 0f;
            rows[t + IMPULSE] += impulse;
            note(o, t, contacts.pair[ContactRow.a(c)], impulse, Float.MAX_VALUE, k.dt);
        }
        if (last) {
            for (int c = from; c < to; c++) {
                int o = ContactRow.of(c);
                if (!isUnwanted(c)
                        && TouchRule.staysInTouch(rows[STRIDE * c + APPROACH], q[o + SEPARATION], q[o + RADII])
                        && isConcern(c, k)) {
                    list(worker, c);
                }
            }
        }
    }

    /** Tells of a pair; returns whether it needs a record. */
    private boolean isConcern(int c, StepConstants k) {
        int t = STRIDE * c;
        float separation = contacts.contact[ContactRow.of(c) + SEPARATION];
        boolean touches = TouchRule.touches(rows[t + APPROACH], separation);
        long ids = contacts.ids(c);
        int lower = (int) (ids >>> 32);
        int higher = (int) ids;
        int pair = events.find(number[c], lower, higher);
        number[c] = pair;
        return events.concerns(pair, lower, higher, touches, approach(c), rows[t + IMPULSE], threshold(c, k));
    }

    private boolean isUnwanted(int c) {
        return wanted != ALL && !wanted[c];
    }

    private float approach(int c) {
        return CircleMath.max(rows[STRIDE * c + APPROACH], 0f);
    }

    private float threshold(int c, StepConstants k) {
        float radii = contacts.contact[ContactRow.of(c) + RADII];
        return Bounce.bounceThreshold(radii, 0f, k.thresholdRate, k.restRate, k.fixedThreshold);
    }

    private void list(int worker, int c) {
        if (count[worker] == listed[worker].length) {
            listed[worker] = Arrays.copyOf(listed[worker], 2 * count[worker]);
        }
        listed[worker][count[worker]++] = c;
    }

    /** Notes the approach speed of the sub-step if the surfaces touch, and where, if that may be elsewhere after the step. */
    private void note(int o, int t, int a, float impulse, float separation, float dt) {
        float approach = rows[t + APPROACH_NOW];
        float before = rows[t + APPROACH];
        float greatest = TouchRule.greatest(before, approach, impulse, separation);
        rows[t + APPROACH] = greatest;
        if (TouchRule.isFast(approach, dt, contacts.contact[o + RADII]) && greatest > before) {
            place(o, t, a, state.motion[a + DX], state.motion[a + DY]);
        }
    }

    private void place(int o, int t, int a, float dx, float dy) {
        float nx = contacts.contact[o + ContactRow.NORMAL_X];
        float ny = contacts.contact[o + ContactRow.NORMAL_Y];
        float separation = contacts.contact[o + SEPARATION];
        float[] circle = state.circle;
        places[t + AT_NORMAL_X] = nx;
        places[t + AT_NORMAL_Y] = ny;
        places[t + POINT_X] = TouchRule.point(circle[a + X], dx, nx, circle[a + RADIUS], separation);
        places[t + POINT_Y] = TouchRule.point(circle[a + Y], dy, ny, circle[a + RADIUS], separation);
    }

    /** Ends a step: records the pairs that need it, and a part of the slots at walls. */
    void endStep(int worker, TouchRecords own, int fromSlot, int toSlot, StepConstants k) {
        for (int n = 0; n < count[worker]; n++) {
            record(own, listed[worker][n], k);
        }
        count[worker] = 0;
        if (walls != null) {
            walls.endStep(own, fromSlot, toSlot, k);
        }
    }

    private void record(TouchRecords own, int c, StepConstants k) {
        int o = ContactRow.of(c);
        int t = STRIDE * c;
        float[] q = contacts.contact;
        float[] m = state.motion;
        int a = contacts.pair[ContactRow.a(c)];
        int b = contacts.pair[ContactRow.b(c)];
        if (!TouchRule.isFast(approach(c), k.dt, q[o + RADII])) {
            place(o, t, a, 0f, 0f);
        }
        float vn = CircleMath.dot(
                q[o + ContactRow.NORMAL_X], q[o + ContactRow.NORMAL_Y], m[b + VX] - m[a + VX], m[b + VY] - m[a + VY]);
        long ids = contacts.ids(c);
        own.add(
                (int) (ids >>> 32),
                (int) ids,
                approach(c),
                rows[t + IMPULSE],
                places[t + AT_NORMAL_X],
                places[t + AT_NORMAL_Y],
                places[t + POINT_X],
                places[t + POINT_Y],
                vn,
                threshold(c, k));
    }

    /** Memory of the arrays. */
    long bytes() {
        return 8L * rows.length
                + 4L * (number.length + numberBefore.length)
                + wanted.length
                + (walls == null ? 0 : walls.bytes());
    }
}
