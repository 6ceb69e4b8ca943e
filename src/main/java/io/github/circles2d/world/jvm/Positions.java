package io.github.circles2d.world.jvm;

import static io.github.circles2d.world.model.CircleRow.X;
import static io.github.circles2d.world.model.CircleRow.Y;

import io.github.circles2d.world.circles.HandleTable;
import io.github.circles2d.world.model.CircleRow;
import java.nio.FloatBuffer;

/** Positions that callers read in place. */
public final class Positions {
    private FloatBuffer floats = FloatBuffer.allocate(0);
    private FloatBuffer view = floats.asReadOnlyBuffer();

    /** Takes the positions of now, in ascending order of ids. */
    void copy(State state, HandleTable handles) {
        if (floats.capacity() < 2 * handles.size()) {
            FloatBuffer larger = FloatBuffer.allocate(3 * handles.size());
            view = larger.asReadOnlyBuffer();
            floats = larger;
        }
        int k = 0;
        for (int id = 0; id < handles.end(); id++) {
            if (handles.lives(id)) {
                int s = CircleRow.of(state.slotOf[id]);
                floats.put(k++, state.circle[s + X]);
                floats.put(k++, state.circle[s + Y]);
            }
        }
        view.clear().limit(k);
    }

    /** What was copied last, read-only. */
    FloatBuffer view() {
        return view;
    }
}
