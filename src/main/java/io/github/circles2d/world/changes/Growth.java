package io.github.circles2d.world.changes;

import io.github.circles2d.world.circles.CircleField;
import io.github.circles2d.world.circles.CircleFields;
import io.github.circles2d.world.circles.Commands;
import io.github.circles2d.world.model.Bounds;
import io.github.circles2d.world.model.Limits;
import io.github.circles2d.world.shared.Call;
import io.github.circles2d.world.shared.Calls;
import io.github.circles2d.world.shared.WorldParts;
import io.github.circles2d.world.snapshots.SavedState;
import java.util.Arrays;

/**
 * Circles that grow or shrink to a radius over some steps: in each they take an even share of the rest of the way.
 *
 * <p>The radius and the steps left are values of {@link CircleField#GROWTH}, so they are in snapshots and in the hash. The step itself
 * knows nothing of this: a command before it gives the circle its next radius.
 */
public final class Growth implements Calls.Effects {
    private static final CircleField GROWTH = CircleField.GROWTH;

    private final WorldParts world;
    private final CircleFields fields;

    /** Circles that may grow, each once; some may have stopped, or be gone. */
    private int[] ids = new int[0];

    private int count;

    /** A bit for each id, set if it is among {@link #ids}. */
    private long[] listed = new long[0];

    // During a step, by place in ids: what each circle had before.
    private long[] growthBefore = new long[0];
    private float[] radiusBefore = new float[0];

    public Growth(WorldParts world) {
        this.world = world;
        fields = world.handles.fields();
        world.calls.define(this, Call.GROW);
    }

    @Override
    public long make(Call call, int[] w) {
        int id = w[0];
        float radius = Call.real(w[1]);
        int steps = w[2];
        Limits.growth(radius, steps, world.settings.bounds());
        fields.ensure(GROWTH, id + 1);
        ensure(count + 1, world.handles.end());
        world.calls.begin(call, w);
        list(id);
        fields.set(GROWTH, id, CircleField.growth(radius, steps));
        return 0;
    }

    /** The steps that a circle goes on to grow or shrink; 0 if it does neither. */
    public int steps(long handle) {
        world.guard.check();
        return CircleField.growthSteps(fields.get(GROWTH, world.circle(handle)));
    }

    private void ensure(int circles, int idLimit) {
        if (circles > ids.length) {
            ids = Arrays.copyOf(ids, Math.max(circles, 2 * ids.length));
        }
        int words = (idLimit + Long.SIZE - 1) / Long.SIZE;
        if (words > listed.length) {
            listed = Arrays.copyOf(listed, Math.max(words, listed.length + (listed.length >> 1)));
        }
    }

    private void list(int id) {
        if ((listed[id / Long.SIZE] >>> id & 1) == 0) {
            listed[id / Long.SIZE] |= 1L << id;
            ids[count++] = id;
        }
    }

    private boolean grows(int id) {
        return fields.get(GROWTH, id) != GROWTH.initial();
    }

    /** A circle keeps the radius that it has. */
    void forget(int id) {
        if (grows(id)) {
            fields.set(GROWTH, id, GROWTH.initial());
        }
    }

    /** Whether no circle grows in the next step. */
    boolean isEmpty() {
        return count == 0;
    }

    /** The number of commands that {@link #begin} records at most. */
    int count() {
        return count;
    }

    /** Refuses bounds in which a circle has no room at the end of its growth. */
    void requireRoom(Bounds bounds) {
        for (int k = 0; k < count; k++) {
            if (grows(ids[k])) {
                float radius = CircleField.growthRadius(fields.get(GROWTH, ids[k]));
                Limits.room("the radius to which a circle grows", radius, bounds);
            }
        }
    }

    /** Makes room for {@link #begin}, except for its commands. */
    void makeRoom() {
        if (radiusBefore.length < count) {
            growthBefore = new long[ids.length];
            radiusBefore = new float[ids.length];
        }
    }

    /** Before a step: gives the circles their next radii. */
    void begin() {
        drop();
        for (int k = 0; k < count; k++) {
            int id = ids[k];
            long growth = fields.get(GROWTH, id);
            float target = CircleField.growthRadius(growth);
            int steps = CircleField.growthSteps(growth);
            float radius = world.handles.radius(id);
            float next = steps == 1 ? target : radius + (target - radius) / steps;
            growthBefore[k] = growth;
            radiusBefore[k] = radius;
            world.commands.set(Commands.GROW, id, next, 0);
            world.handles.setRadius(id, next);
            fields.set(GROWTH, id, steps == 1 ? GROWTH.initial() : CircleField.growth(target, steps - 1));
        }
    }

    /** The step has not begun for want of memory: all is as before it. */
    void undo() {
        for (int k = 0; k < count; k++) {
            world.handles.setRadius(ids[k], radiusBefore[k]);
            fields.set(GROWTH, ids[k], growthBefore[k]);
        }
    }

    /** After a step. */
    void end() {
        drop();
    }

    /** Takes circles out of the list that do not grow. */
    private void drop() {
        int growing = 0;
        for (int k = 0; k < count; k++) {
            int id = ids[k];
            if (grows(id)) {
                ids[growing++] = id;
            } else {
                listed[id / Long.SIZE] &= ~(1L << id);
            }
        }
        count = growing;
    }

    /** Makes room for the circles of a saved state that grow. */
    void makeRoom(SavedState from) {
        int growing = from.fields.used(GROWTH);
        if (growing > 0) {
            ensure(growing, from.ids);
        }
    }

    /** Another state, for which there is room, has taken the place of all that was. */
    void restored() {
        count = 0;
        Arrays.fill(listed, 0);
        for (int id = 0; id < world.handles.end() && fields.isUsed(GROWTH); id++) {
            if (grows(id)) {
                list(id);
            }
        }
    }
}
