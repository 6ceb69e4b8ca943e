package io.github.circles2d.world.jvm.state;

import io.github.circles2d.world.circles.StateHash;
import io.github.circles2d.world.jvm.threads.SharedInts;
import io.github.circles2d.world.model.ContactRows;
import io.github.circles2d.world.snapshots.SavedState;
import java.util.Arrays;

/**
 * The impulses of contacts at the end of a step, from which the next step warm-starts. They have the numbers that the contacts had in
 * that step. Each circle of lower id has a chain of those that press, which begins at {@link State#firstCached}. An entry names the
 * circles by their ids, so slots may change in between.
 *
 * <p>From step to step most contacts keep their neighbours in the list. So a search looks first at the entry behind the one that was
 * found last: a processor guesses that right, and the end of a chain it does not.
 */
public final class ImpulseCache {
    /** Entries that are looked at before a chain is followed: others come between, or have gone. */
    private static final int NEAR = 4;

    private final State state;

    /** By contact: ids of its circles, the lower above the higher. */
    private long[] ids = new long[0];

    /** By contact of the step before: the same. */
    private long[] idsBefore = new long[0];

    /** By contact: its impulse; 0 until it is stored. */
    private float[] normalImpulse = new float[0];

    /** By contact of the step before: its impulse, 0 if it did not press. */
    private float[] impulseBefore = new float[0];

    /** By contact, if circles can rotate: the impulses of its rows, by {@link ContactRows}. */
    private float[] rows = new float[0];

    /** By contact of the step before: the same. */
    private float[] rowsBefore = new float[0];

    /** By contact that presses, of the step before until the first is stored: the next with the same circle of lower id, or -1. */
    private int[] next = new int[0];

    /** Entries of the step before, which all say what its contacts ended with, or what circles that woke have given back. */
    private int filledBefore;

    /** Entries as of now, which are of the step before in the step to come. */
    private int filled;

    public ImpulseCache(State state) {
        this.state = state;
    }

    /** Makes room for contacts. The array that is compared grows last: a growth that fails is tried again. */
    public void ensure(int contacts) {
        if (next.length < contacts) {
            ids = Arrays.copyOf(ids, contacts);
            idsBefore = Arrays.copyOf(idsBefore, contacts);
            normalImpulse = Arrays.copyOf(normalImpulse, contacts);
            impulseBefore = Arrays.copyOf(impulseBefore, contacts);
            next = Arrays.copyOf(next, contacts);
        }
        if (state.turning != null) {
            ensureRows();
        }
    }

    /** Makes room for the rows of the contacts for which there is room, so that circles can rotate. */
    public void ensureRows() {
        // Steps exchange the two: either may have grown without the other.
        if (Math.min(rows.length, rowsBefore.length) < ContactRows.of(next.length)) {
            rowsBefore = Arrays.copyOf(rowsBefore, ContactRows.of(next.length));
            rows = Arrays.copyOf(rows, ContactRows.of(next.length));
        }
    }

    public long bytes() {
        return 28L * next.length + 8L * rows.length;
    }

    /** How many entries there are. */
    public int filled() {
        return filled;
    }

    /** There are so many contacts. */
    public void hold(int contacts) {
        filled = contacts;
    }

    /** Adds an entry, for which there is room. */
    void append(int lo, int hi, float impulse, float[] ofRows, int at) {
        int entry = filled++;
        store(entry, state.slotOf[lo], hi, impulse);
        if (state.turning != null) {
            storeRows(entry, ofRows, at);
        }
    }

    /** What has been stored is of the step before. */
    public void begin() {
        long[] i = ids;
        ids = idsBefore;
        idsBefore = i;
        float[] impulse = normalImpulse;
        normalImpulse = impulseBefore;
        impulseBefore = impulse;
        impulse = rows;
        rows = rowsBefore;
        rowsBefore = impulse;
        filledBefore = filled;
    }

    /** Between steps: the entry of two circles, or -1. */
    public int find(int lower, int higher) {
        if (!state.fresh[higher]) {
            long pair = (long) state.id[lower] << 32 | state.id[higher];
            for (int c = state.firstCached[lower]; c >= 0; c = next[c]) {
                if (ids[c] == pair) {
                    return c;
                }
            }
        }
        return -1;
    }

    /** Of an entry that {@link #find} has found. */
    public float impulseNow(int entry) {
        return normalImpulse[entry];
    }

    /** The same of a row. */
    public float rowImpulseNow(int entry, int row) {
        return rows[ContactRows.of(entry) + row];
    }

    /** Between steps: moves the impulses of a circle, as the one of lower id, with others that do not move either to those of {@link Sleepers}. */
    public void moveToSleepers(int lower, Sleepers sleepers) {
        int kept = -1;
        int c = state.firstCached[lower];
        while (c >= 0) {
            int following = next[c];
            int lo = state.id[lower];
            int hi = (int) ids[c];
            boolean rests =
                    isFound(c) && state.isStatic(state.slotOf[hi]) && (sleepers.isAsleep(lo) || sleepers.isAsleep(hi));
            if (rests) {
                sleepers.press(lo, hi, normalImpulse[c], rows, ContactRows.of(c));
            } else {
                next[c] = kept;
                kept = c;
            }
            c = following;
        }
        state.firstCached[lower] = kept;
    }

    /** At most so many impulses can {@link #moveToSleepers} move. */
    public int most() {
        return filled;
    }

    /** Fills the entry of a contact of this step, and finds that of the step before, or -1; guess is the entry that it may be. */
    public int fill(int c, int guess, int lower, int higher, long pair) {
        ids[c] = pair;
        normalImpulse[c] = 0f;
        if (state.turning != null) {
            ContactRows.clear(rows, ContactRows.of(c), 1);
        }
        int end = Math.min(guess + NEAR, filledBefore);
        for (int entry = guess; entry < end; entry++) {
            if (idsBefore[entry] == pair) {
                return state.fresh[lower] | state.fresh[higher] ? -1 : entry;
            }
        }
        return search(lower, higher, pair);
    }

    private int search(int lower, int higher, long pair) {
        if (!state.fresh[higher]) {
            for (int c = state.firstCached[lower]; c >= 0; c = next[c]) {
                if (idsBefore[c] == pair) {
                    return c;
                }
            }
        }
        return -1;
    }

    /** The impulse of an entry of the step before; 0 of -1. */
    public float impulse(int entry) {
        return entry < 0 ? 0f : impulseBefore[entry];
    }

    /** The same of a row. */
    public float rowImpulse(int entry, int row) {
        return entry < 0 ? 0f : rowsBefore[ContactRows.of(entry) + row];
    }

    /** Stores the impulses of the rows of contact c, from a place of an array on; its normal impulse is stored too. */
    public void storeRows(int c, float[] impulses, int at) {
        ContactRows.copy(impulses, at, rows, ContactRows.of(c));
    }

    /** Stores the impulse of contact c. No two contacts with a circle in common at once. */
    public void store(int c, int lower, int id, float impulse) {
        ids[c] = (long) state.id[lower] << 32 | id;
        normalImpulse[c] = impulse;
        next[c] = state.firstCached[lower];
        state.firstCached[lower] = c;
    }

    /** As {@link #store}, where other workers may store impulses of the same circle. No result depends on the order of a chain. */
    public void storeShared(int c, int lower, int id, float impulse) {
        ids[c] = (long) state.id[lower] << 32 | id;
        normalImpulse[c] = impulse;
        next[c] = SharedInts.getAndSet(state.firstCached, lower, c);
    }

    /** Whether the circle of higher id is still the one that the impulse belongs to. */
    private boolean isFound(int c) {
        int hi = state.slotOf[(int) ids[c]];
        return hi >= 0 && !state.fresh[hi];
    }

    /** How many impulses of a slot, as the circle of lower id, the next step may start from. */
    public int count(int slot) {
        int count = 0;
        for (int c = state.firstCached[slot]; c >= 0; c = next[c]) {
            count += isFound(c) ? 1 : 0;
        }
        return count;
    }

    /** Saves them from a place on. Returns the place behind them. */
    public int save(int slot, SavedState into, int at) {
        int end = at;
        for (int c = state.firstCached[slot]; c >= 0; c = next[c]) {
            if (isFound(c)) {
                into.ensureImpulses(end + 1);
                into.setImpulse(end++, at, state.id[slot], (int) ids[c], normalImpulse[c], rows, ContactRows.of(c));
            }
        }
        return end;
    }

    /** Takes over saved impulses, for which there is room; the circles have been taken over before. */
    public void load(SavedState from) {
        filled = from.impulses;
        for (int c = 0; c < from.impulses; c++) {
            store(c, state.slotOf[from.lo[c]], from.hi[c], from.normalImpulse[c]);
            if (state.turning != null) {
                if (from.turns) {
                    storeRows(c, from.rows, ContactRows.of(c));
                } else {
                    ContactRows.clear(rows, ContactRows.of(c), 1);
                }
            }
        }
    }

    /** The part of the impulses of a slot, as the circle of lower id, in the hash of the state. */
    public long hash(int slot) {
        long sum = 0;
        for (int c = state.firstCached[slot]; c >= 0; c = next[c]) {
            if (isFound(c)) {
                long h = StateHash.absorb(StateHash.absorb(StateHash.impulse(), state.id[slot]), (int) ids[c]);
                sum += StateHash.absorb(h, normalImpulse[c]);
                if (state.turning != null) {
                    sum += StateHash.rows(state.id[slot], (int) ids[c], rows, ContactRows.of(c));
                }
            }
        }
        return sum;
    }
}
