package io.github.circles2d.world.jvm;

import io.github.circles2d.world.circles.SavedState;
import io.github.circles2d.world.circles.StateHash;
import java.lang.invoke.MethodHandles;
import java.lang.invoke.VarHandle;
import java.util.Arrays;

/**
 * The normal impulses at the end of a step, from which the next step warm-starts. They have the numbers that the contacts had in
 * that step. Each circle of lower id has a chain of them, which begins at {@link State#firstCached}. An entry names the circle of higher
 * id by its id, so slots may change in between.
 */
final class ImpulseCache {
    private static final VarHandle INTS = MethodHandles.arrayElementVarHandle(int[].class);

    private final State state;

    /** By contact of the step before: id of the circle of higher id. */
    private int[] higherId = new int[0];

    /** By contact of the step before: its impulse. */
    private float[] normalImpulse = new float[0];

    /** By contact of the step before: the next with the same circle of lower id, or -1. */
    private int[] next = new int[0];

    ImpulseCache(State state) {
        this.state = state;
    }

    /** Makes room for contacts. The length of the array that grows last tells whether there is room. */
    void ensure(int contacts) {
        if (next.length < contacts) {
            higherId = Arrays.copyOf(higherId, contacts);
            normalImpulse = Arrays.copyOf(normalImpulse, contacts);
            next = Arrays.copyOf(next, contacts);
        }
    }

    /** Memory of the arrays. */
    long bytes() {
        return 12L * higherId.length;
    }

    /** The impulse of a pair of slots, of which the higher id is known; 0 if there is none. */
    float find(int lower, int higher, int id) {
        if (!state.fresh[higher]) {
            for (int c = state.firstCached[lower]; c >= 0; c = next[c]) {
                if (higherId[c] == id) {
                    return normalImpulse[c];
                }
            }
        }
        return 0f;
    }

    /** Stores the impulse of contact c. No two contacts with a circle in common at once. */
    void store(int c, int lower, int id, float impulse) {
        higherId[c] = id;
        normalImpulse[c] = impulse;
        next[c] = state.firstCached[lower];
        state.firstCached[lower] = c;
    }

    /** As {@link #store}, where other workers may store impulses of the same circle. No result depends on the order of a chain. */
    void storeShared(int c, int lower, int id, float impulse) {
        higherId[c] = id;
        normalImpulse[c] = impulse;
        next[c] = (int) INTS.getAndSet(state.firstCached, lower, c);
    }

    /** Whether the circle of higher id is still the one that the impulse belongs to. */
    private boolean isFound(int c) {
        int hi = state.slotOf[higherId[c]];
        return hi >= 0 && !state.fresh[hi];
    }

    /** Saves the impulses of a slot, as the circle of lower id, that the next step may start from. */
    void save(int slot, SavedState into) {
        for (int c = state.firstCached[slot]; c >= 0; c = next[c]) {
            if (isFound(c)) {
                into.addImpulse(state.id[slot], higherId[c], normalImpulse[c]);
            }
        }
    }

    /** Takes over saved impulses, for which there is room; the circles have been taken over before. */
    void load(SavedState from) {
        for (int c = 0; c < from.impulses; c++) {
            store(c, state.slotOf[from.lo[c]], from.hi[c], from.lambda[c]);
        }
    }

    /** The part of the impulses of a slot, as the circle of lower id, in the hash of the state. */
    long hash(int slot) {
        long sum = 0;
        for (int c = state.firstCached[slot]; c >= 0; c = next[c]) {
            if (isFound(c)) {
                long h = StateHash.absorb(StateHash.absorb(StateHash.impulse(), state.id[slot]), higherId[c]);
                sum += StateHash.absorb(h, normalImpulse[c]);
            }
        }
        return sum;
    }
}
