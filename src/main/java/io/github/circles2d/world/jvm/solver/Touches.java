package io.github.circles2d.world.jvm.solver;

import static io.github.circles2d.world.jvm.solver.ContactRow.NORMAL_IMPULSE;
import static io.github.circles2d.world.jvm.solver.ContactRow.RADII;
import static io.github.circles2d.world.jvm.solver.ContactRow.RESTITUTION_THRESHOLD;
import static io.github.circles2d.world.jvm.solver.ContactRow.SEPARATION;
import static io.github.circles2d.world.model.CircleRow.BEFORE_X;
import static io.github.circles2d.world.model.CircleRow.BEFORE_Y;
import static io.github.circles2d.world.model.CircleRow.DX;
import static io.github.circles2d.world.model.CircleRow.DY;
import static io.github.circles2d.world.model.CircleRow.RADIUS;
import static io.github.circles2d.world.model.CircleRow.SPIN_IMPULSE;
import static io.github.circles2d.world.model.CircleRow.VX;
import static io.github.circles2d.world.model.CircleRow.VY;
import static io.github.circles2d.world.model.CircleRow.X;
import static io.github.circles2d.world.model.CircleRow.Y;

import io.github.circles2d.world.events.ContactEvents;
import io.github.circles2d.world.events.TouchRecords;
import io.github.circles2d.world.jvm.pieces.PieceTouches;
import io.github.circles2d.world.jvm.pieces.SensedPiece;
import io.github.circles2d.world.jvm.pieces.WallTouches;
import io.github.circles2d.world.jvm.state.State;
import io.github.circles2d.world.jvm.threads.Team;
import io.github.circles2d.world.model.Bounce;
import io.github.circles2d.world.model.CircleMath;
import io.github.circles2d.world.model.StepConstants;
import io.github.circles2d.world.model.TerrainStep;
import io.github.circles2d.world.model.TouchRule;
import java.util.Arrays;

/**
 * Records what contacts do in a step, if events are reported. It looks at contacts after each pass over them; the passes
 * themselves tell it of impulses that they do not keep. {@link WallTouches} does the same for walls.
 */
public final class Touches {
    private static final int STRIDE = 4;
    private static final int BLOCK = 256;

    /** Contacts of a {@link #hasUnkept}, as a power of two. */
    private static final int PART = 5;

    /** In place of the number of a pair that has to be looked for. */
    private static final int UNKNOWN = Integer.MAX_VALUE;

    private static final boolean[] ALL = new boolean[0];

    // A row: what an event says of a contact, and of the sub-step its approach speed and what no contact keeps.
    private static final int APPROACH = 0;
    private static final int IMPULSE = 1;
    private static final int APPROACH_NOW = 2;
    private static final int IMPULSE_NOW = 3;

    // How fast surfaces slide, if circles can rotate: in the sub-step of the approach speed, and in this one.
    private static final int SLIPS = 2;
    private static final int SLIP = 0;
    private static final int SLIP_NOW = 1;

    // A place.
    private static final int AT_NORMAL_X = 0;
    private static final int AT_NORMAL_Y = 1;
    private static final int POINT_X = 2;
    private static final int POINT_Y = 3;

    private final State state;
    private final Contacts contacts;

    /** Who is told. */
    final ContactEvents events;

    private final WallTouches ofWalls;

    /** Null if walls are not reported. */
    public WallTouches walls;

    /** Null in a step that reports no pieces of terrain. */
    public PieceTouches pieces;

    private PieceTouches ofPieces;
    private final SensedPiece[] sensedPieces;

    /** By worker: what it tells of the step. */
    private final TouchRecords[] records;

    /** By worker: the contacts whose pairs are to be found, later those that need a record; and how many. */
    private final int[][] listed;

    private final int[] count;

    /** By worker: the contacts of a block that touch so fast that their places are to be noted. */
    private final int[][] fast;

    /** By contact: whether it is reported; without elements where all contacts are. */
    private boolean[] wanted = new boolean[0];

    /**
     * By contact: the number of its pair, {@link ContactEvents#going} of that if its hit goes on, or {@link ContactEvents#NONE} if it does
     * not touch. Within the step as it was before, and at its end as it is from then on.
     */
    private int[] number = new int[0];

    /** The same of the contacts of the step before. */
    private int[] numberBefore = new int[0];

    /** The last step that has been recorded, as the contacts count them, and the numbering of its pairs. */
    private long step = -1;

    private int numbering;

    private float[] rows = new float[0];

    /** By part of the contacts: whether some may have bounced in a biased pass of this step. */
    private boolean[] hasUnkept = new boolean[0];

    /** By contact: where it touches. Noted within the step only if it is fast, so contacts at rest leave it alone. */
    private float[] places = new float[0];

    /** By contact: how fast its surfaces slide; null unless circles can rotate. */
    private float[] slips;

    public Touches(State state, Contacts contacts, Team team, ContactEvents events, TouchRecords[] records) {
        this.state = state;
        this.contacts = contacts;
        this.events = events;
        this.records = records;
        ofWalls = new WallTouches(state, events);
        listed = new int[team.most()][64];
        sensedPieces = new SensedPiece[team.most()];
        count = new int[team.most()];
        fast = new int[team.most()][BLOCK];
    }

    /** Whether walls are recorded. */
    public void recordWalls(boolean some) {
        walls = some ? ofWalls : null;
    }

    /** Whether pieces of terrain are recorded, which a world may get at any time. */
    public void recordPieces(boolean some) {
        if (some && ofPieces == null) {
            for (int worker = 0; worker < sensedPieces.length; worker++) {
                sensedPieces[worker] = new SensedPiece(events);
            }
            ofPieces = new PieceTouches(state, events);
        }
        pieces = some ? ofPieces : null;
    }

    void ensure(int many) {
        Arrays.fill(count, 0); // a step that ended for want of memory may have left some
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
            hasUnkept = new boolean[(length / STRIDE >> PART) + 1];
            places = new float[length];
            rows = new float[length];
        }
        if (state.turning != null && (slips == null || slips.length < SLIPS * (long) many)) {
            slips = new float[SLIPS * (rows.length / STRIDE)];
        }
    }

    /** Begins a step: what is known of contacts is of the step before, if that has been recorded. */
    void begin(long nextStep) {
        int[] before = numberBefore;
        numberBefore = number;
        number = before;
        if (nextStep != step + 1 || numbering != events.numbering()) {
            Arrays.fill(numberBefore, UNKNOWN);
        }
        step = nextStep;
        numbering = events.numbering();
    }

    /** Takes note which contact of the step before a contact goes on from, or -1. */
    void follow(int worker, int c, int before) {
        int known = before < 0 || before >= numberBefore.length ? UNKNOWN : numberBefore[before];
        number[c] = known;
        if (!events.isNumber(pairOf(known))) {
            list(worker, c);
        }
    }

    /** Finds the pairs of the contacts that are listed: one search after the other, so that the processor waits for several at once. */
    private void findListed(int worker) {
        int[] ofWorker = listed[worker];
        for (int n = 0; n < count[worker]; n++) {
            long ids = contacts.ids(ofWorker[n]);
            int pair = events.find((int) (ids >>> 32), (int) ids);
            boolean goesOn = pair != ContactEvents.NONE && events.openHit(pair) != ContactEvents.NONE;
            number[ofWorker[n]] = goesOn ? ContactEvents.going(pair) : pair;
        }
        count[worker] = 0;
    }

    /** Begins a step for contacts. */
    void clear(int worker, int from, int to) {
        findListed(worker);
        for (int t = STRIDE * from; t < STRIDE * to; t += STRIDE) {
            rows[t + APPROACH] = TouchRule.NONE;
            rows[t + IMPULSE] = 0f;
            rows[t + IMPULSE_NOW] = 0f;
        }
        if (from < to) {
            Arrays.fill(hasUnkept, from >> PART, (to - 1 >> PART) + 1, false);
        }
        if (slips != null) {
            Arrays.fill(slips, SLIPS * from, SLIPS * to, 0f);
        }
        for (int c = from; wanted != ALL && c < to; c++) {
            long ids = contacts.ids(c);
            wanted[c] = events.tracker.typesOfCircles((int) (ids >>> 32), (int) ids) != 0;
        }
    }

    /** The number of the pair of a contact, or {@link ContactEvents#NONE}. */
    private int pair(int c) {
        return pairOf(number[c]);
    }

    private static int pairOf(int number) {
        return number >= ContactEvents.NONE ? number : ContactEvents.going(number);
    }

    /** An impulse that has acted, or will, and that the contact does not keep as its normal impulse. */
    void add(int c, float impulse) {
        rows[STRIDE * c + IMPULSE_NOW] += impulse;
    }

    /** Takes note that a contact has bounced in the biased pass, so that its impulse is taken even if it does not push. */
    void noteUnkept(int c) {
        hasUnkept[c >> PART] = true;
    }

    /** Looks at contacts after the biased pass. */
    void afterSolve(int worker, int from, int to, StepConstants k) {
        for (int block = from; block < to; block += BLOCK) {
            int end = Math.min(to, block + BLOCK);
            if (k.turning) {
                noteSlips(block, end);
            }
            placeAll(worker, afterSolve(fast[worker], block, end, k.dt));
        }
    }

    /** Notes how fast surfaces slide, by the speeds before any impulse of the sub-step. */
    private void noteSlips(int from, int to) {
        float[] q = contacts.contact;
        PairRows pairRows = contacts.rows;
        int[] pair = contacts.pair;
        float[] load = state.load;
        float[] spin = state.turning.spin;
        float[] slide = slips;
        for (int c = from; c < to; c++) {
            int o = ContactRow.of(c);
            int a = pair[ContactRow.a(c)];
            int b = pair[ContactRow.b(c)];
            float beforeX = load[b + BEFORE_X] - load[a + BEFORE_X];
            float beforeY = load[b + BEFORE_Y] - load[a + BEFORE_Y];
            float along = CircleMath.dot(-q[o + ContactRow.NORMAL_Y], q[o + ContactRow.NORMAL_X], beforeX, beforeY);
            slide[SLIPS * c + SLIP_NOW] = pairRows.slip(c, along, spin[a + SPIN_IMPULSE], spin[b + SPIN_IMPULSE]);
        }
    }

    /** The same of a block; lists the contacts whose place is to be noted, and returns their number. */
    private int afterSolve(int[] fastOnes, int from, int to, float dt) {
        // no call in the loop, or the compiler reads all fields again for each contact
        float[] q = contacts.contact;
        int[] pair = contacts.pair;
        float[] load = state.load;
        float[] r = rows;
        boolean[] some = wanted;
        boolean all = some == ALL;
        float[] slide = slips;
        int many = 0;
        for (int c = from; c < to; c++) {
            if (!all && !some[c]) {
                continue;
            }
            int o = ContactRow.of(c);
            int t = STRIDE * c;
            int a = pair[ContactRow.a(c)];
            int b = pair[ContactRow.b(c)];
            float beforeX = load[b + BEFORE_X] - load[a + BEFORE_X];
            float beforeY = load[b + BEFORE_Y] - load[a + BEFORE_Y];
            float vn = CircleMath.dot(q[o + ContactRow.NORMAL_X], q[o + ContactRow.NORMAL_Y], beforeX, beforeY);
            float approach = TouchRule.approachSpeed(vn);
            float impulse = q[o + NORMAL_IMPULSE] + r[t + IMPULSE_NOW];
            float before = r[t + APPROACH];
            float greatest = TouchRule.greatest(before, approach, impulse, q[o + SEPARATION]);
            r[t + APPROACH_NOW] = approach;
            r[t + APPROACH] = greatest;
            if (slide != null && greatest > before) {
                slide[SLIPS * c + SLIP] = slide[SLIPS * c + SLIP_NOW];
            }
            if (TouchRule.isFastApproach(approach, dt, q[o + RADII]) && greatest > before) {
                fastOnes[many++] = c;
            }
        }
        return many;
    }

    /**
     * Looks at a block of contacts after the relaxing pass: at those that push, which are among the carriers, and at those with impulses
     * that they do not keep. All others are as they were.
     */
    void afterRelax(int[] carriers, int carrying, int[] unkeptOnes, int unkept, int from, int to, float dt) {
        float[] q = contacts.contact;
        float[] r = rows;
        boolean[] some = wanted;
        boolean all = some == ALL;
        for (int n = 0; n < carrying; n++) {
            int c = carriers[n];
            if (!all && !some[c]) {
                continue;
            }
            int t = STRIDE * c;
            float impulse = r[t + IMPULSE_NOW] + q[ContactRow.of(c) + NORMAL_IMPULSE];
            r[t + IMPULSE_NOW] = 0f;
            r[t + IMPULSE] += impulse;
            if (r[t + APPROACH_NOW] > r[t + APPROACH] && impulse > 0f) {
                touchLate(c, dt);
            }
        }
        for (int n = 0; n < unkept; n++) {
            take(unkeptOnes[n], dt);
        }
        for (int part = from >> PART; part <= to - 1 >> PART; part++) {
            if (hasUnkept[part]) {
                int end = Math.min(to, part + 1 << PART);
                for (int c = Math.max(from, part << PART); c < end; c++) {
                    take(c, dt);
                }
            }
        }
    }

    /** Takes the impulses of a contact that it has not kept, if they have not been taken. */
    private void take(int c, float dt) {
        int t = STRIDE * c;
        float impulse = rows[t + IMPULSE_NOW];
        if (impulse != 0f) {
            rows[t + IMPULSE_NOW] = 0f;
            rows[t + IMPULSE] += impulse;
            if (rows[t + APPROACH_NOW] > rows[t + APPROACH] && impulse > 0f) {
                touchLate(c, dt);
            }
        }
    }

    /** Takes note that a contact touches only since the relaxing pass. */
    private void touchLate(int c, float dt) {
        int o = ContactRow.of(c);
        int t = STRIDE * c;
        float approach = rows[t + APPROACH_NOW];
        rows[t + APPROACH] = approach;
        if (slips != null) {
            slips[SLIPS * c + SLIP] = slips[SLIPS * c + SLIP_NOW];
        }
        if (TouchRule.isFastApproach(approach, dt, contacts.contact[o + RADII])) {
            int a = contacts.pair[ContactRow.a(c)];
            place(o, t, a, state.motion[a + DX], state.motion[a + DY]);
        }
    }

    /** Notes where contacts touch that may be elsewhere after the step. */
    private void placeAll(int worker, int many) {
        for (int n = 0; n < many; n++) {
            int c = fast[worker][n];
            int a = contacts.pair[ContactRow.a(c)];
            place(ContactRow.of(c), STRIDE * c, a, state.motion[a + DX], state.motion[a + DY]);
        }
    }

    /** Tells which pairs still touch and which do no more, and lists the contacts that need a record. */
    void tell(int worker, int from, int to, StepConstants k) {
        float[] q = contacts.contact;
        TouchRecords own = records[worker];
        int stay = 0;
        float[] r = rows;
        int[] numbers = number;
        for (int c = from; c < to; c++) {
            if (isUnwanted(c)) {
                numbers[c] = ContactEvents.NONE;
                continue;
            }
            int o = ContactRow.of(c);
            int t = STRIDE * c;
            float approach = r[t + APPROACH];
            float separation = q[o + SEPARATION];
            if (numbers[c] == ContactEvents.NONE) {
                if (TouchRule.touches(approach, separation)) {
                    list(worker, c);
                }
            } else if (TouchRule.staysInTouch(approach, separation, q[o + RADII])) {
                stay++;
                // Few pairs reach even the threshold of a bounce, which is at hand and not more than that of a hit.
                if (numbers[c] < ContactEvents.NONE
                        || events.tracker.isHitSpeed(approach, q[o + RESTITUTION_THRESHOLD])
                                && events.tracker.isHit(approach(c), r[t + IMPULSE], threshold(c, k))) {
                    list(worker, c);
                }
            } else {
                own.end(pair(c));
                numbers[c] = ContactEvents.NONE;
            }
        }
        own.stay(stay);
    }

    /** Tells of each pair that still touches, if some may have ended of which nobody has told. */
    public void stamp(int from, int to) {
        for (int c = from; c < to; c++) {
            if (number[c] != ContactEvents.NONE) {
                events.tracker.stamp(pair(c));
            }
        }
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

    private void place(int o, int t, int a, float dx, float dy) {
        float nx = contacts.contact[o + ContactRow.NORMAL_X];
        float ny = contacts.contact[o + ContactRow.NORMAL_Y];
        float separation = contacts.contact[o + SEPARATION];
        float[] circle = state.circle;
        places[t + AT_NORMAL_X] = nx;
        places[t + AT_NORMAL_Y] = ny;
        places[t + POINT_X] = TouchRule.touchPoint(circle[a + X], dx, nx, circle[a + RADIUS], separation);
        places[t + POINT_Y] = TouchRule.touchPoint(circle[a + Y], dy, ny, circle[a + RADIUS], separation);
    }

    /** Ends a step: records the pairs that need it, and tells of a part of the slots at walls and pieces. */
    public void endStep(int worker, int fromSlot, int toSlot, TerrainStep terrain, StepConstants k) {
        for (int n = 0; n < count[worker]; n++) {
            record(records[worker], listed[worker][n], k);
        }
        if (walls != null) {
            walls.endStep(records[worker], fromSlot, toSlot, k);
        }
        if (pieces != null) {
            pieces.endStep(records[worker], sensedPieces[worker], fromSlot, toSlot, terrain, k);
        }
    }

    /** Learns what numbers the pairs have got that were recorded. */
    public void learn(int worker) {
        for (int n = 0; n < count[worker]; n++) {
            number[listed[worker][n]] = records[worker].pair(n);
        }
        count[worker] = 0;
    }

    private void record(TouchRecords own, int c, StepConstants k) {
        int o = ContactRow.of(c);
        int t = STRIDE * c;
        float[] q = contacts.contact;
        float[] m = state.motion;
        int a = contacts.pair[ContactRow.a(c)];
        int b = contacts.pair[ContactRow.b(c)];
        if (!TouchRule.isFastApproach(approach(c), k.dt, q[o + RADII])) {
            place(o, t, a, 0f, 0f);
        }
        float vn = CircleMath.dot(
                q[o + ContactRow.NORMAL_X], q[o + ContactRow.NORMAL_Y], m[b + VX] - m[a + VX], m[b + VY] - m[a + VY]);
        long ids = contacts.ids(c);
        own.add(
                pair(c),
                (int) (ids >>> 32),
                (int) ids,
                approach(c),
                rows[t + IMPULSE],
                places[t + AT_NORMAL_X],
                places[t + AT_NORMAL_Y],
                places[t + POINT_X],
                places[t + POINT_Y],
                slips == null ? 0f : slips[SLIPS * c + SLIP],
                vn,
                threshold(c, k));
    }

    public long bytes() {
        return 8L * rows.length
                + hasUnkept.length
                + (slips == null ? 0 : 4L * slips.length)
                + 4L * (number.length + numberBefore.length)
                + wanted.length
                + (walls == null ? 0 : walls.bytes())
                + (ofPieces == null ? 0 : ofPieces.bytes());
    }
}
