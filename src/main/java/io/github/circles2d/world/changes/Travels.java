package io.github.circles2d.world.changes;

import io.github.circles2d.world.circles.CircleField;
import io.github.circles2d.world.circles.CircleFields;
import io.github.circles2d.world.circles.Commands;
import io.github.circles2d.world.model.Bounds;
import io.github.circles2d.world.model.CircleMath;
import io.github.circles2d.world.shared.WorldParts;
import io.github.circles2d.world.snapshots.SavedState;
import java.util.Arrays;

/**
 * Static circles on their way to a place that a call has given them. They travel there in the next step, with the velocity that
 * this takes, so that they push what is in their way. Then they are exactly there, and have the velocity that they had before.
 *
 * <p>Their targets are values of {@link CircleField#TARGET}, so they are in snapshots and in the hash. The step itself knows
 * nothing of this: a command before it gives the circle its velocity, and another one behind it takes that away.
 */
public final class Travels {
    private static final CircleField TARGET = CircleField.TARGET;

    private final WorldParts world;
    private final CircleFields fields;

    /** Circles that have got a target since the last step; some may have lost it, or be gone, or be here twice. */
    private int[] ids = new int[8];

    private int count;

    /** During a step: where each of them will be. */
    private long[] places = new long[8];

    public Travels(WorldParts world) {
        this.world = world;
        fields = world.handles.fields();
    }

    /** Whether no circle travels in the next step. */
    boolean isEmpty() {
        return count == 0;
    }

    /** Makes room for a target of a circle. ahead: circles that get one before it, of which this is told later. */
    void ensure(int id, int ahead) {
        fields.ensure(TARGET, id + 1);
        ensureIds(count + ahead + 1);
    }

    private void ensureIds(int circles) {
        if (circles > ids.length) {
            ids = Arrays.copyOf(ids, Math.max(circles, 2 * ids.length));
        }
    }

    /** Whether a circle travels in the next step. */
    boolean travels(int id) {
        return target(id) != TARGET.initial();
    }

    private long target(int id) {
        return fields.get(TARGET, id);
    }

    /** Gives a static circle a target, for which there is room, in place of one that it has. */
    void set(int id, float x, float y) {
        if (!travels(id)) {
            ids[count++] = id;
        }
        fields.set(TARGET, id, CircleField.place(x, y));
    }

    /** A circle stays where it is. */
    void forget(int id) {
        if (travels(id)) {
            fields.set(TARGET, id, TARGET.initial());
        }
    }

    /** A circle that travels is put at its target at once, by a command for which there is room. */
    void end(int id) {
        long target = target(id);
        world.commands.set(Commands.POSITION, id, CircleField.placeX(target), CircleField.placeY(target));
        forget(id);
    }

    /** Brings targets that new bounds have left outside to the nearest place inside. */
    void confine(Bounds bounds) {
        for (int k = 0; k < count; k++) {
            long target = target(ids[k]);
            if (target != TARGET.initial()) {
                float x = CircleMath.clamp(CircleField.placeX(target), bounds.minX(), bounds.maxX());
                float y = CircleMath.clamp(CircleField.placeY(target), bounds.minY(), bounds.maxY());
                fields.set(TARGET, ids[k], CircleField.place(x, y));
            }
        }
    }

    /** The number of commands that {@link #depart} records at most. */
    int count() {
        return count;
    }

    /** Makes room for {@link #depart}, except for its commands. */
    void makeRoom() {
        places = places.length < count ? new long[ids.length] : places;
    }

    /** Before the step: gives the circles the velocities that lead them to their targets, which they lose. */
    void depart(float timeStep, Bounds bounds) {
        int travelling = 0;
        for (int k = 0; k < count; k++) {
            int id = ids[k];
            long target = target(id);
            if (target != TARGET.initial()) {
                world.commands.depart(id, CircleField.placeX(target), CircleField.placeY(target), timeStep, bounds);
                fields.set(TARGET, id, TARGET.initial());
                ids[travelling] = id;
                places[travelling++] = target;
            }
        }
        count = travelling;
    }

    /** The step has not begun for want of memory: the circles have their targets again. */
    void stay() {
        for (int k = 0; k < count; k++) {
            fields.set(TARGET, ids[k], places[k]);
        }
    }

    /** After the step: puts the circles at their targets. */
    void arrive() {
        world.commands.ensure(count);
        for (int k = 0; k < count; k++) {
            world.commands.set(Commands.ARRIVE, ids[k], CircleField.placeX(places[k]), CircleField.placeY(places[k]));
        }
        count = 0;
    }

    void makeRoom(SavedState from) {
        int circles = 0;
        for (int id = 0; id < from.ids; id++) {
            circles += from.fields.get(TARGET, id) == TARGET.initial() ? 0 : 1;
        }
        ensureIds(circles);
    }

    /** A saved state, for which there is room, has taken the place of all that was. */
    void restored() {
        count = 0;
        for (int id = 0; id < world.handles.end(); id++) {
            if (travels(id)) {
                ids[count++] = id;
            }
        }
    }
}
