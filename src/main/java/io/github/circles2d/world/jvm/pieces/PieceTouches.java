package io.github.circles2d.world.jvm.pieces;

import static io.github.circles2d.world.model.CircleRow.DX;
import static io.github.circles2d.world.model.CircleRow.DY;
import static io.github.circles2d.world.model.CircleRow.INVERSE_MASS;
import static io.github.circles2d.world.model.CircleRow.MASS;
import static io.github.circles2d.world.model.CircleRow.RADIUS;
import static io.github.circles2d.world.model.CircleRow.VX;
import static io.github.circles2d.world.model.CircleRow.VY;
import static io.github.circles2d.world.model.CircleRow.X;
import static io.github.circles2d.world.model.CircleRow.Y;

import io.github.circles2d.world.events.ContactEvents;
import io.github.circles2d.world.events.Partner;
import io.github.circles2d.world.events.TouchRecords;
import io.github.circles2d.world.jvm.state.PieceContactRow;
import io.github.circles2d.world.jvm.state.PieceContacts;
import io.github.circles2d.world.jvm.state.State;
import io.github.circles2d.world.model.Bounce;
import io.github.circles2d.world.model.CircleRow;
import io.github.circles2d.world.model.PairTable;
import io.github.circles2d.world.model.PieceGap;
import io.github.circles2d.world.model.StepConstants;
import io.github.circles2d.world.model.TerrainStep;
import io.github.circles2d.world.model.TouchRule;

/**
 * Records what pieces of terrain do to circles in a step, as {@link WallTouches} does of walls, and which pieces sense a circle: its centre has
 * then moved evenly, in the frame of the piece.
 */
public final class PieceTouches {
    private static final int STRIDE = 8;

    // a row of a piece contact
    private static final int APPROACH = 0;
    private static final int IMPULSE = 1;

    // when the circle approached fastest: the normal towards it, the place, how fast surfaces slid, how fast the piece
    // came along the normal
    private static final int NORMAL_X = 2;
    private static final int NORMAL_Y = 3;
    private static final int POINT_X = 4;
    private static final int POINT_Y = 5;
    private static final int SLIP = 6;
    private static final int SURFACE = 7;

    // of a piece that senses: the centre at the start of the step, in the frame of the piece
    private static final int START_X = 2;
    private static final int START_Y = 3;

    private final State state;
    private final PieceContacts contacts;
    private final ContactEvents events;
    private float[] rows = new float[0];

    public PieceTouches(State state, ContactEvents events) {
        this.state = state;
        this.events = events;
        contacts = state.pieces;
    }

    void ensure(int many) {
        if (rows.length < STRIDE * (long) many) {
            rows = new float[Math.multiplyExact(STRIDE, many + (many >> 2))];
        }
    }

    /** Begins a step for slots. */
    public void clear(int from, int to) {
        for (int slot = from; slot < to; slot++) {
            int end = contacts.first[slot] + contacts.count[slot];
            for (int c = contacts.first[slot]; c < end; c++) {
                rows[STRIDE * c + APPROACH] = TouchRule.NONE;
                rows[STRIDE * c + IMPULSE] = 0f;
            }
        }
    }

    /** Takes note where circles are as the step begins. */
    void begin(int slot) {
        int end = contacts.first[slot] + contacts.count[slot];
        for (int c = contacts.first[slot]; c < end; c++) {
            if (senses(c)) {
                rows[STRIDE * c + START_X] = contacts.rows[PieceContactRow.of(c) + PieceContactRow.OX];
                rows[STRIDE * c + START_Y] = contacts.rows[PieceContactRow.of(c) + PieceContactRow.OY];
            }
        }
    }

    private boolean senses(int c) {
        return contacts.numbers[PieceContactRow.numbers(c) + PieceContactRow.RESPONSE] == PairTable.SENSE;
    }

    /**
     * A visit, with or without bias, before its effect: the normal speed that the circle approaches with, what the visit gives it along the
     * normal, how fast surfaces slide, and how fast the piece comes along the normal.
     */
    void visited(int slot, int c, float vn, float impulse, float slip, float surface) {
        int t = STRIDE * c;
        int k = PieceContactRow.of(c);
        float gap = contacts.rows[k + PieceContactRow.GAP];
        int s = CircleRow.of(slot);
        rows[t + IMPULSE] += impulse;
        float approach = TouchRule.approachSpeed(vn);
        if ((impulse > 0f || gap <= 0f) && approach > rows[t + APPROACH]) {
            rows[t + APPROACH] = approach;
            rows[t + SLIP] = slip;
            rows[t + SURFACE] = surface;
            place(slot, c, state.motion[s + DX], state.motion[s + DY]);
        }
    }

    /** Notes the normal, and the place half-way between the surfaces. */
    private void place(int slot, int c, float dx, float dy) {
        int t = STRIDE * c;
        int s = CircleRow.of(slot);
        int k = PieceContactRow.of(c);
        float nx = contacts.rows[k + PieceContactRow.NX];
        float ny = contacts.rows[k + PieceContactRow.NY];
        float gap = contacts.rows[k + PieceContactRow.GAP];
        float r = state.circle[s + RADIUS];
        rows[t + NORMAL_X] = nx;
        rows[t + NORMAL_Y] = ny;
        rows[t + POINT_X] = TouchRule.touchPoint(state.circle[s + X], dx, -1f * nx, r, gap);
        rows[t + POINT_Y] = TouchRule.touchPoint(state.circle[s + Y], dy, -1f * ny, r, gap);
    }

    public void endStep(
            TouchRecords records, SensedPiece sensed, int from, int to, TerrainStep terrain, StepConstants k) {
        for (int slot = from; slot < to; slot++) {
            if (state.traits[CircleRow.of(slot) + INVERSE_MASS] != 0f) {
                int end = contacts.first[slot] + contacts.count[slot];
                for (int c = contacts.first[slot]; c < end; c++) {
                    if (senses(c)) {
                        int row = PieceContactRow.of(c);
                        sensed.tell(
                                records,
                                state.id[slot],
                                contacts.piece(c),
                                rows[STRIDE * c + START_X],
                                rows[STRIDE * c + START_Y],
                                contacts.rows[row + PieceContactRow.OX],
                                contacts.rows[row + PieceContactRow.OY],
                                state.circle[CircleRow.of(slot) + RADIUS],
                                contacts.rows[row + PieceContactRow.SIDE],
                                terrain,
                                k);
                    } else {
                        endSolid(records, slot, c, k);
                    }
                }
            }
        }
    }

    private void endSolid(TouchRecords records, int slot, int c, StepConstants k) {
        int t = STRIDE * c;
        float r = state.circle[CircleRow.of(slot) + RADIUS];
        float gap = contacts.rows[PieceContactRow.of(c) + PieceContactRow.GAP];
        int feature = contacts.numbers[PieceContactRow.numbers(c) + PieceContactRow.FEATURE];
        boolean touches = rows[t + APPROACH] >= 0f;
        if (!touches) {
            if (feature == PieceGap.NONE || !TouchRule.staysInTouch(TouchRule.NONE, gap, 2f * r)) {
                return;
            }
            touches = TouchRule.touches(TouchRule.NONE, gap);
            rows[t + APPROACH] = 0f;
            rows[t + SLIP] = 0f;
            rows[t + SURFACE] = 0f;
            place(slot, c, 0f, 0f);
        }
        float impulse = state.circle[CircleRow.of(slot) + MASS] * rows[t + IMPULSE];
        float nx = rows[t + NORMAL_X];
        float ny = rows[t + NORMAL_Y];
        int s = CircleRow.of(slot);
        float vn = (nx * state.motion[s + VX] + ny * state.motion[s + VY]) - rows[t + SURFACE];
        float threshold = Bounce.bounceThreshold(2f * r, 0f, k.thresholdRate, k.restRate, k.fixedThreshold);
        tell(records, slot, c, touches, impulse, vn, threshold);
    }

    private void tell(
            TouchRecords records, int slot, int c, boolean touches, float impulse, float vn, float threshold) {
        int t = STRIDE * c;
        int id = state.id[slot];
        int code = Partner.ofPiece(contacts.piece(c));
        int pair = events.find(id, code);
        float approach = rows[t + APPROACH];
        if (events.tracker.concerns(pair, id, code, touches, approach, impulse, threshold)) {
            records.add(
                    pair,
                    id,
                    code,
                    approach,
                    impulse,
                    -rows[t + NORMAL_X],
                    -rows[t + NORMAL_Y],
                    rows[t + POINT_X],
                    rows[t + POINT_Y],
                    rows[t + SLIP],
                    vn,
                    threshold);
        }
    }

    public long bytes() {
        return 4L * rows.length;
    }
}
