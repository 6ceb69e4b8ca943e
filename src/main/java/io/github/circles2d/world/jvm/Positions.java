package io.github.circles2d.world.jvm;

import static io.github.circles2d.world.model.CircleRow.X;
import static io.github.circles2d.world.model.CircleRow.Y;

import io.github.circles2d.world.circles.HandleTable;
import io.github.circles2d.world.circles.IdMask;
import io.github.circles2d.world.jvm.state.State;
import io.github.circles2d.world.model.CircleRow;
import java.nio.Buffer;
import java.nio.FloatBuffer;
import java.util.Arrays;

/** Positions that callers read in place. */
public final class Positions {
    /** The circles whose positions were copied last. */
    final IdMask living = new IdMask();

    private int circles;

    /** Whether they lie by id; else they lie together. */
    private boolean liesById;

    private FloatBuffer floats = FloatBuffer.allocate(0);
    private FloatBuffer view = floats.asReadOnlyBuffer();

    /** Makes room for {@link #copy}; what was copied last stays. If there is none, nothing has changed. */
    void makeRoom(HandleTable handles) {
        living.makeRoom(handles);
        if (floats.capacity() < 2 * handles.end()) {
            FloatBuffer larger = FloatBuffer.wrap(Arrays.copyOf(floats.array(), 3 * handles.end()));
            view = larger.asReadOnlyBuffer();
            floats = larger;
        }
    }

    /** Takes the positions of now, by id or in ascending order of ids. */
    void copy(State state, HandleTable handles, boolean byId) {
        makeRoom(handles);
        living.copy(handles);
        circles = handles.size();
        liesById = byId;
        int k = 0;
        for (int id = 0; id < handles.end(); id++) {
            if (handles.lives(id)) {
                int s = CircleRow.of(state.slotOf[id]);
                floats.put(k, state.circle[s + X]);
                floats.put(k + 1, state.circle[s + Y]);
                k += 2;
            } else if (byId) {
                k += 2;
            }
        }
    }

    /** What was copied last, in ascending order of ids, read-only. */
    FloatBuffer together() {
        if (liesById && circles < living.end()) {
            living.closeGaps(floats, 2);
        }
        liesById = false;
        ((Buffer) view).clear().limit(2 * circles);
        return view;
    }

    /** What was copied last, by id, read-only, and NaN for ids that are not to be shown. */
    FloatBuffer byId(IdMask shown) {
        if (!liesById && circles < living.end()) {
            living.spread(floats.array(), 2, circles);
        }
        liesById = true;
        shown.markGaps(floats, 2);
        ((Buffer) view).clear().limit(2 * living.end());
        return view;
    }
}
