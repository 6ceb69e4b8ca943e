package io.github.circles2d.world.jvm;

import static io.github.circles2d.world.model.CircleRow.X;
import static io.github.circles2d.world.model.CircleRow.Y;

import io.github.circles2d.world.circles.HandleTable;
import io.github.circles2d.world.circles.IdMask;
import io.github.circles2d.world.model.CircleRow;
import java.nio.FloatBuffer;

/** Positions that callers read in place. */
public final class Positions {
    /** The circles whose positions were copied last. */
    final IdMask living = new IdMask();

    private int circles;
    private FloatBuffer floats = FloatBuffer.allocate(0);
    private FloatBuffer view = floats.asReadOnlyBuffer();

    /** Takes the positions of now, by id. */
    void copy(State state, HandleTable handles) {
        if (floats.capacity() < 2 * handles.end()) {
            FloatBuffer larger = FloatBuffer.allocate(3 * handles.end());
            view = larger.asReadOnlyBuffer();
            floats = larger;
        }
        living.copy(handles);
        circles = handles.size();
        for (int id = 0; id < handles.end(); id++) {
            if (handles.lives(id)) {
                int s = CircleRow.of(state.slotOf[id]);
                floats.put(2 * id, state.circle[s + X]);
                floats.put(2 * id + 1, state.circle[s + Y]);
            }
        }
    }

    /** What was copied last, in ascending order of ids, read-only. Once a copy. */
    FloatBuffer together() {
        if (circles < living.end()) {
            living.closeGaps(floats, 2);
        }
        return view.clear().limit(2 * circles);
    }

    /** What was copied last, by id, read-only, and NaN for ids that are not to be shown. Once a copy. */
    FloatBuffer byId(IdMask shown) {
        shown.markGaps(floats, 2);
        return view.clear().limit(2 * living.end());
    }
}
