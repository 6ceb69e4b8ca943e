package io.github.circles2d.world;

import io.github.circles2d.world.circles.Commands;
import io.github.circles2d.world.circles.HandleTable;
import io.github.circles2d.world.circles.IdMask;
import io.github.circles2d.world.model.CircleRow;
import io.github.circles2d.world.model.Explosion;
import java.util.Arrays;

/**
 * The calls that change many circles at once. A call copies and checks everything into the room behind the records of
 * {@link Commands} first, and then admits it, so it changes all or nothing.
 */
public final class BulkChanges {
    private final Simulation simulation;
    private final Guard guard;
    private final HandleTable handles;
    private final Commands commands;

    private final Explosion explosion = new Explosion();

    /** A bit for each id, set while a call that removes it is prepared. */
    private long[] leaving = new long[0];

    BulkChanges(Simulation simulation) {
        this.simulation = simulation;
        guard = simulation.guard;
        handles = simulation.handles;
        commands = simulation.commands;
    }

    /**
     * Changes many circles, in the order of the array.
     *
     * @param operation an operation of {@link Commands} with two values
     * @param circles their handles
     * @param count number of handles
     * @param values two values for each
     * @param skipStale whether to leave stale handles out; else they are refused
     * @return number of handles that were left out
     */
    public int set(int operation, long[] circles, int count, float[] values, boolean skipStale) {
        guard.enter();
        try {
            checkLengths(circles, count);
            if (values.length < 2L * count) {
                throw new IllegalArgumentException(
                        "there are " + values.length + " values, but must be two for each of " + count + " handles");
            }
            simulation.expect(count);
            int changes = 0;
            int travels = 0;
            for (int i = 0; i < count; i++) {
                int id = find(circles, i, skipStale);
                if (id >= 0) {
                    prepare(changes++, operation, id, i, values[2 * i], values[2 * i + 1]);
                    if (operation == Commands.POSITION && handles.isStatic(id)) {
                        simulation.travels.ensure(id, travels++);
                    }
                }
            }
            simulation.circles().forget(operation);
            if (travels > 0) {
                recordTravels(changes);
            }
            guard.changing = true;
            commands.admitChanges(travels == 0 ? changes : sendOff(changes));
            guard.changing = false;
            return count - changes;
        } catch (RuntimeException | Error e) {
            throw guard.failed(e);
        } finally {
            guard.user = null;
        }
    }

    private void recordTravels(int changes) {
        for (int k = 0; k < changes; k++) {
            int id = commands.preparedId(k);
            if (handles.isStatic(id)) {
                simulation.journal.travel(id, commands.preparedFirst(k), commands.preparedSecond(k));
            }
        }
    }

    /** Static circles travel to the positions that are prepared for them. Returns the number of the other ones that are prepared. */
    private int sendOff(int changes) {
        int others = 0;
        for (int k = 0; k < changes; k++) {
            int id = commands.preparedId(k);
            if (handles.isStatic(id)) {
                simulation.travels.set(id, commands.preparedFirst(k), commands.preparedSecond(k));
            } else {
                commands.advancePrepared(k, others++);
            }
        }
        return others;
    }

    private void prepare(int ahead, int operation, int id, int i, float a, float b) {
        try {
            simulation.circles().checkValues(operation, a, b);
        } catch (IllegalArgumentException e) {
            throw new IllegalArgumentException("circle " + i + ": " + e.getMessage(), e);
        }
        boolean places = operation == Commands.POSITION;
        commands.prepareChange(
                ahead,
                operation,
                id,
                places ? simulation.bounds.placeX(a) : a,
                places ? simulation.bounds.placeY(b) : b);
    }

    /**
     * Removes many circles. A handle that occurs again is stale by then.
     *
     * @param circles their handles
     * @param count number of handles
     * @param skipStale whether to leave stale handles out; else they are refused
     * @return number of handles that were left out
     */
    public int remove(long[] circles, int count, boolean skipStale) {
        guard.enter();
        try {
            checkLengths(circles, count);
            simulation.expect(count);
            clearLeaving(IdMask.words(handles.end()));
            int changes = 0;
            for (int i = 0; i < count; i++) {
                int id = find(circles, i, skipStale);
                if (id >= 0 && isNew(id, i, skipStale)) {
                    commands.prepareChange(changes++, Commands.REMOVE, id, 0, 0);
                }
            }
            simulation.changed();
            guard.changing = true;
            for (int k = 0; k < changes; k++) {
                handles.remove(commands.preparedId(k));
            }
            commands.admitChanges(changes);
            guard.changing = false;
            return count - changes;
        } catch (RuntimeException | Error e) {
            throw guard.failed(e);
        } finally {
            guard.user = null;
        }
    }

    private void clearLeaving(int words) {
        if (leaving.length < words) {
            leaving = new long[words + (words >> 1)];
        } else {
            Arrays.fill(leaving, 0, words, 0);
        }
    }

    private boolean isNew(int id, int i, boolean skipStale) {
        long bit = 1L << id;
        boolean isNew = (leaving[id / Long.SIZE] & bit) == 0;
        if (!isNew && !skipStale) {
            throw new IllegalArgumentException("handle " + i + " occurs twice");
        }
        leaving[id / Long.SIZE] |= bit;
        return isNew;
    }

    private static void checkLengths(long[] circles, int count) {
        if (count < 0 || count > circles.length) {
            throw new IllegalArgumentException(
                    "the number of handles is " + count + ", but must be from 0 to " + circles.length);
        }
    }

    /** The id of handle i; -1 if it is stale and left out. Each element is read once: another thread may write to the array. */
    private int find(long[] circles, int i, boolean skipStale) {
        long handle = circles[i];
        int id = handles.find(handle);
        if (id < 0 && !skipStale) {
            throw new IllegalArgumentException("handle " + i + ": no circle has the handle " + handle
                    + ": it was removed, or is none of this world's");
        }
        return id;
    }

    /**
     * Pushes the circles near a point away from it, by {@link Explosion}.
     *
     * @param x x of the point
     * @param y y of the point
     * @param radius how far from the point a circle's edge may be for the whole impulse
     * @param impulse the impulse
     * @param falloff over which distance the impulse then falls to 0
     * @return number of circles that got an impulse
     */
    public int explode(float x, float y, float radius, float impulse, float falloff) {
        guard.enter();
        try {
            explosion.set(x, y, radius, impulse, falloff, simulation.bounds);
            float[] circles = simulation.last.circles();
            simulation.expect(0);
            int changes = 0;
            int s = 0;
            for (int id = 0; id < handles.end(); id++) {
                if (handles.lives(id)) {
                    if (explosion.reaches(circles, s)) {
                        commands.prepareChange(
                                changes++, Commands.IMPULSE, id, explosion.impulseX(), explosion.impulseY());
                    }
                    s += CircleRow.STRIDE;
                }
            }
            simulation.circles().forget(Commands.IMPULSE);
            guard.changing = true;
            commands.admitChanges(changes);
            guard.changing = false;
            return changes;
        } catch (RuntimeException | Error e) {
            throw guard.failed(e);
        } finally {
            guard.user = null;
        }
    }
}
