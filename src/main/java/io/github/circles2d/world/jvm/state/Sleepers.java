package io.github.circles2d.world.jvm.state;

import static io.github.circles2d.world.model.CircleRow.DX;
import static io.github.circles2d.world.model.CircleRow.DY;
import static io.github.circles2d.world.model.CircleRow.RADIUS;

import io.github.circles2d.world.circles.StateHash;
import io.github.circles2d.world.model.CircleRow;
import io.github.circles2d.world.model.ContactRows;
import io.github.circles2d.world.model.Sleep;
import io.github.circles2d.world.model.StepConstants;
import io.github.circles2d.world.snapshots.SavedState;
import java.util.Arrays;

/**
 * How circles come to rest, and what those that sleep keep: the impulses with which they press others that do not move, and their contacts
 * with pieces of terrain. A step finds neither again. All is by id, since slots change.
 */
public final class Sleepers {
    private static final int NONE = -1;

    /** Ints of an impulse in {@link #links}: the ids of its circles, and the next impulse of each. */
    private static final int LINKS = 4;

    private static final int LO = 0;
    private static final int HI = 1;
    private static final int NEXT_OF_LO = 2;
    private static final int NEXT_OF_HI = 3;

    private final State state;

    /** Ints of a circle in {@link #rests}. They lie together since a step meets circles in no order of ids. */
    public static final int RESTS = 4;

    static final int REST = 0;
    public static final int TURNED = 1;
    public static final int DRIFT_X = 2;
    public static final int DRIFT_Y = 3;

    /**
     * By id: its rest, by {@link Sleep}; the units by which a circle that is awake has turned since it came to rest; the bits of how far it
     * has drifted since then, less its displacement. Of one that sleeps: its rest, its offset, and the bits of the acceleration it knows.
     */
    public int[] rests = new int[0];

    /**
     * By id: whether a circle that is awake and not static has begun anew in the last step, so that its rest and turn are 0, and its drift is minus its
     * displacement, whatever {@link #rests} has. Steps touch no more of circles that plainly move.
     */
    public boolean[] begins = new boolean[0];

    /** By slot, within a step: the displacement at its start. */
    float[] start = new float[0];

    /** By slot, within a step: the displacement before it went into the base. */
    public float[] moved = new float[0];

    /** By slot, within a step: whether a circle that {@link #begins} does so again. */
    public boolean[] movesOn = new boolean[0];

    /** By slot, within a step, if circles can rotate: the units by which a circle has turned in it. */
    public int[] turnedInStep = new int[0];

    /** How many circles sleep. */
    public int count;

    /** Another one as soon as others sleep than before, or other circles are static. */
    public int version;

    // ---- impulses

    /** By id: one of the impulses of the circle. */
    private int[] first = new int[0];

    private int[] links = new int[0];

    /** By impulse: the normal one. */
    private float[] normal = new float[0];

    /** By impulse, if circles can rotate: those of the other rows. */
    private float[] rows = new float[0];

    /** Impulses up to here have been used; those that are free are a chain. */
    private int used;

    private int free = NONE;

    /** How many impulses there are. */
    private int pressing;

    // ---- pieces

    /** By id: the rows of contacts with pieces, by {@link PieceContactRow}; null if there have been none. */
    private float[][] pieceRows = new float[0][];

    private int[][] pieceNumbers = new int[0][];

    /** By id: how many contacts there are. */
    private int[] pieceCount = new int[0];

    // ---- whom to look at

    /** By order of coming: ids whose balance may be another than in the step before, but for those near to circles that are awake. */
    private int[] suspects = new int[16];

    private int suspectCount;

    /** Whether all are to be looked at. */
    private boolean suspectsAll;

    Sleepers(State state) {
        this.state = state;
    }

    long bytes() {
        long sum = 4L * (rests.length + start.length + moved.length + turnedInStep.length + first.length + links.length)
                + 4L * (normal.length + rows.length + pieceCount.length + suspects.length)
                + begins.length
                + movesOn.length;
        for (float[] each : pieceRows) {
            sum += each == null ? 0 : 4L * each.length;
        }
        return sum;
    }

    /** Makes room for ids. The array that is compared grows last: a growth that fails is tried again. */
    void ensure(int ids) {
        if (first.length < ids) {
            int old = first.length;
            begins = Arrays.copyOf(begins, ids);
            start = Arrays.copyOf(start, CircleRow.vector(ids));
            moved = Arrays.copyOf(moved, CircleRow.vector(ids));
            movesOn = Arrays.copyOf(movesOn, ids);
            turnedInStep = Arrays.copyOf(turnedInStep, ids);
            rests = Arrays.copyOf(rests, RESTS * ids);
            pieceRows = Arrays.copyOf(pieceRows, ids);
            pieceNumbers = Arrays.copyOf(pieceNumbers, ids);
            pieceCount = Arrays.copyOf(pieceCount, ids);
            first = Arrays.copyOf(first, ids);
            Arrays.fill(first, old, ids, NONE);
        }
    }

    public boolean isAsleep(int id) {
        return Sleep.isAsleep(rests[RESTS * id + REST]);
    }

    public int rest(int id) {
        return begins[id] ? 0 : rests[RESTS * id + REST];
    }

    public void setRest(int id, int rest) {
        rests[RESTS * id + REST] = rest;
    }

    // ---- who sleeps

    /** A circle that is awake begins anew to come to rest. */
    public void restart(int slot) {
        boolean isStatic = state.isStatic(slot);
        float driftX = isStatic ? 0f : 0f - state.motion[CircleRow.of(slot) + DX];
        float driftY = isStatic ? 0f : 0f - state.motion[CircleRow.of(slot) + DY];
        set(state.id[slot], 0, 0, driftX, driftY);
    }

    public void set(int id, int rest, int turned, float driftX, float driftY) {
        int row = RESTS * id;
        begins[id] = false;
        rests[row + REST] = rest;
        rests[row + TURNED] = turned;
        rests[row + DRIFT_X] = Float.floatToRawIntBits(driftX);
        rests[row + DRIFT_Y] = Float.floatToRawIntBits(driftY);
    }

    private float driftX(int id) {
        return begins[id]
                ? 0f - state.motion[CircleRow.of(state.slotOf[id]) + DX]
                : Float.intBitsToFloat(rests[RESTS * id + DRIFT_X]);
    }

    private float driftY(int id) {
        return begins[id]
                ? 0f - state.motion[CircleRow.of(state.slotOf[id]) + DY]
                : Float.intBitsToFloat(rests[RESTS * id + DRIFT_Y]);
    }

    private int turned(int id) {
        return begins[id] ? 0 : rests[RESTS * id + TURNED];
    }

    // ---- of a step

    /** Before some slots move. */
    public void noteStarts(int from, int to) {
        for (int slot = from; slot < to; slot++) {
            start[CircleRow.vector(slot)] = state.motion[CircleRow.of(slot) + DX];
            start[CircleRow.vector(slot) + 1] = state.motion[CircleRow.of(slot) + DY];
        }
    }

    /** Once some slots have moved, before their displacements go into the bases. */
    public void noteMoves(int from, int to) {
        for (int slot = from; slot < to; slot++) {
            int s = CircleRow.of(slot);
            int v = CircleRow.vector(slot);
            float movedX = state.motion[s + DX];
            float movedY = state.motion[s + DY];
            moved[v] = movedX;
            moved[v + 1] = movedY;
            float r = state.circle[s + RADIUS];
            movesOn[slot] = begins[state.id[slot]]
                    && !Sleep.rests(0f - start[v] + movedX, 0f - start[v + 1] + movedY, 0, r, Sleep.DRIFT * r);
        }
    }

    /** A circle that begins anew gets a row, as it was at the start of the step. */
    public void writeStart(int slot, int id) {
        if (begins[id]) {
            set(id, 0, 0, 0f - start[CircleRow.vector(slot)], 0f - start[CircleRow.vector(slot) + 1]);
        }
    }

    /** A circle falls asleep, with the acceleration by gravity and its force. */
    void sleep(int id, float knownX, float knownY) {
        set(id, Sleep.ASLEEP, Sleep.NO_OFFSET, knownX, knownY);
    }

    /** A circle that sleeps gets to know gravity and its force; returns whether they have changed. */
    public boolean learn(int id, float gainX, float gainY, float gain, float radius, StepConstants k) {
        boolean changes = Sleep.changes(gainX, gainY, driftX(id), driftY(id), k.h, gain, radius, k.dt);
        if (changes) {
            set(id, rest(id), rests[RESTS * id + TURNED], gainX * k.inverseH, gainY * k.inverseH);
        }
        return changes;
    }

    /** The offset of a circle that sleeps. One that has just fallen asleep gets it from what it is out of balance, unless that is new. */
    public int offset(int id, float x, float y, float gain, boolean isNew) {
        int row = RESTS * id;
        if (rests[row + TURNED] == Sleep.NO_OFFSET) {
            rests[row + TURNED] = isNew ? 0 : Sleep.offset(x, y, gain);
        }
        return rests[row + TURNED];
    }

    /** An id is free. */
    void forget(int id) {
        set(id, 0, 0, 0f, 0f);
        pieceCount[id] = 0;
        while (first[id] != NONE) {
            unlink(first[id]);
        }
    }

    // ---- impulses

    /** The number of impulses. */
    public int impulses() {
        return pressing;
    }

    /** Makes room for more impulses. */
    public void ensureImpulses(int more) {
        int need = used + more;
        if (normal.length < need) {
            int c = need + (need >> 1);
            links = Arrays.copyOf(links, LINKS * c);
            normal = Arrays.copyOf(normal, c);
        }
        if (state.turning != null) {
            ensureRows();
        }
    }

    /** Makes room for the rows of impulses, so that circles can rotate. */
    void ensureRows() {
        if (rows.length < ContactRows.of(normal.length)) {
            rows = Arrays.copyOf(rows, ContactRows.of(normal.length));
        }
    }

    /** Keeps an impulse, for which there is room; those of its rows come from a place of an array on, if circles can rotate. */
    void press(int lo, int hi, float impulse, float[] ofRows, int at) {
        int k = free == NONE ? used++ : free;
        if (k == free) {
            free = links[LINKS * k];
        }
        pressing++;
        links[LINKS * k + LO] = lo;
        links[LINKS * k + HI] = hi;
        links[LINKS * k + NEXT_OF_LO] = first[lo];
        first[lo] = k;
        links[LINKS * k + NEXT_OF_HI] = first[hi];
        first[hi] = k;
        normal[k] = impulse;
        if (state.turning != null) {
            ContactRows.copy(ofRows, at, rows, ContactRows.of(k));
        }
    }

    /** One of the impulses of a circle, or -1. */
    public int first(int id) {
        return first[id];
    }

    /** The next impulse of a circle behind one, or -1. */
    public int next(int impulse, int id) {
        return links[LINKS * impulse + (links[LINKS * impulse + LO] == id ? NEXT_OF_LO : NEXT_OF_HI)];
    }

    /** The circle that one presses by an impulse. */
    public int other(int impulse, int id) {
        return links[LINKS * impulse + LO] + links[LINKS * impulse + HI] - id;
    }

    public float normal(int impulse) {
        return normal[impulse];
    }

    public float row(int impulse, int row) {
        return rows[ContactRows.of(impulse) + row];
    }

    /** The impulse of two circles, or -1. */
    public int find(int id, int other) {
        int k = first[id];
        while (k != NONE && other(k, id) != other) {
            k = next(k, id);
        }
        return k;
    }

    private void unlink(int k) {
        unlink(k, links[LINKS * k + LO]);
        unlink(k, links[LINKS * k + HI]);
        links[LINKS * k] = free;
        free = k;
        pressing--;
        if (pressing == 0) {
            used = 0;
            free = NONE;
        }
    }

    private void unlink(int k, int id) {
        if (first[id] == k) {
            first[id] = next(k, id);
            return;
        }
        int before = first[id];
        while (next(before, id) != k) {
            before = next(before, id);
        }
        int place = LINKS * before + (links[LINKS * before + LO] == id ? NEXT_OF_LO : NEXT_OF_HI);
        links[place] = next(k, id);
    }

    /** Gives the impulses of a circle that wakes to the cache, which has room for them. */
    void giveBack(int id, ImpulseCache cache) {
        while (first[id] != NONE) {
            int k = first[id];
            int lo = links[LINKS * k + LO];
            cache.append(lo, links[LINKS * k + HI], normal[k], rows, ContactRows.of(k));
            if (state.slotOf[lo] >= state.awake) {
                state.resting.unsettle(lo);
            }
            unlink(k);
        }
    }

    /** Another length of steps takes another impulse. */
    public void scale(float by) {
        if (by != 1f && pressing > 0) {
            for (int k = 0; k < used; k++) {
                normal[k] *= by;
            }
            for (int k = 0; state.turning != null && k < ContactRows.of(used); k++) {
                rows[k] *= by;
            }
        }
    }

    // ---- pieces

    /** Keeps the contacts of a slot with pieces, so many from one on. */
    public void keepPieces(int id, int from, int many, PieceContacts contacts) {
        if (many > 0) {
            int floats = PieceContactRow.of(many);
            if (pieceRows[id] == null || pieceRows[id].length < floats) {
                pieceRows[id] = new float[floats];
                pieceNumbers[id] = new int[PieceContactRow.numbers(many)];
            }
            System.arraycopy(contacts.rows, PieceContactRow.of(from), pieceRows[id], 0, floats);
            System.arraycopy(
                    contacts.numbers,
                    PieceContactRow.numbers(from),
                    pieceNumbers[id],
                    0,
                    PieceContactRow.numbers(many));
        }
        pieceCount[id] = many;
    }

    public int pieces(int id) {
        return pieceCount[id];
    }

    public float[] pieceRows(int id) {
        return pieceRows[id];
    }

    public int[] pieceNumbers(int id) {
        return pieceNumbers[id];
    }

    /** A step has found the contacts of a circle that woke. */
    public void forgetPieces(int id) {
        pieceCount[id] = 0;
    }

    // ---- whom to look at

    /** The balance of a circle may be another in the next step. */
    public void suspect(int id) {
        if (suspectCount == suspects.length) {
            suspects = Arrays.copyOf(suspects, 2 * suspectCount);
        }
        suspects[suspectCount++] = id;
    }

    public void suspectAll() {
        suspectsAll = true;
    }

    public boolean suspectsAll() {
        return suspectsAll;
    }

    public int suspects() {
        return suspectCount;
    }

    public int suspectAt(int k) {
        return suspects[k];
    }

    public void forgetSuspects() {
        suspectCount = 0;
        suspectsAll = false;
    }

    // ---- state

    /** Saves the circle with an id as circle k. */
    void save(int id, SavedState into, int k) {
        into.rest[k] = rest(id);
        into.drift[2 * k] = driftX(id);
        into.drift[2 * k + 1] = driftY(id);
        into.turned[k] = turned(id);
    }

    /** Saves the impulses of a circle, as the one of lower id. */
    public void saveImpulses(int id, SavedState into) {
        for (int k = first[id]; k != NONE; k = next(k, id)) {
            if (links[LINKS * k + LO] == id) {
                into.addImpulse(id, links[LINKS * k + HI], normal[k], rows, ContactRows.of(k));
            }
        }
    }

    /** Takes over saved circles, for which there is room. */
    void load(SavedState from) {
        Arrays.fill(rests, 0);
        Arrays.fill(begins, false);
        Arrays.fill(first, NONE);
        Arrays.fill(pieceCount, 0);
        used = 0;
        free = NONE;
        pressing = 0;
        count = 0;
        version++;
        for (int k = 0; from.sleeps && k < from.circles; k++) {
            int id = from.id[k];
            set(id, from.rest[k], from.turned[k], from.drift[2 * k], from.drift[2 * k + 1]);
        }
        forgetSuspects();
        suspectAll();
    }

    /** The part of a circle in the hash of the state. */
    long hash(int id) {
        long sum = StateHash.rest(id, rest(id), driftX(id), driftY(id), turned(id));
        for (int k = first[id]; k != NONE; k = next(k, id)) {
            if (links[LINKS * k + LO] == id) {
                int hi = links[LINKS * k + HI];
                long h = StateHash.absorb(StateHash.absorb(StateHash.impulse(), id), hi);
                sum += StateHash.absorb(h, normal[k]);
                if (state.turning != null) {
                    sum += StateHash.rows(id, hi, rows, ContactRows.of(k));
                }
            }
        }
        return sum;
    }
}
