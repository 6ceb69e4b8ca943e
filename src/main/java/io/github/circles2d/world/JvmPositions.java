package io.github.circles2d.world;

import java.nio.FloatBuffer;

/** Positions that callers look into. */
final class JvmPositions {
    private FloatBuffer floats = FloatBuffer.allocate(0);
    private FloatBuffer view = floats.asReadOnlyBuffer();

    /** Takes the positions of now, in ascending order of ids. */
    void copy(JvmState state, Roster roster) {
        if (floats.capacity() < 2 * roster.size()) {
            FloatBuffer larger = FloatBuffer.allocate(3 * roster.size());
            view = larger.asReadOnlyBuffer();
            floats = larger;
        }
        int k = 0;
        for (int id = 0; id < roster.end(); id++) {
            if (roster.lives(id)) {
                int s = 4 * state.slotOf[id];
                floats.put(k++, state.circle[s]);
                floats.put(k++, state.circle[s + 1]);
            }
        }
        view.clear().limit(k);
    }

    /** What was copied last, read-only. */
    FloatBuffer view() {
        return view;
    }
}
