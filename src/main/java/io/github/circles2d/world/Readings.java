package io.github.circles2d.world;

import io.github.circles2d.world.circles.CircleField;
import io.github.circles2d.world.circles.HandleTable;
import io.github.circles2d.world.circles.IdMask;
import io.github.circles2d.world.model.CircleRow;
import io.github.circles2d.world.model.Limits;
import java.nio.Buffer;
import java.nio.FloatBuffer;
import java.nio.LongBuffer;

/** Reads of all circles, in the order of the ids, and of single numbers, which come from the last read of all. */
public final class Readings {
    private final Simulation simulation;
    private final Guard guard;
    private final HandleTable handles;
    private final Pipeline pipeline;
    private final LastReading last;

    /** The ids of the circles of a read by id. */
    private final IdMask mask = new IdMask();

    /** Whether positions have been requested since the last were taken. */
    private boolean positionsRequested;

    /** The number of requests for positions; may overflow. */
    private int requests;

    Readings(Simulation simulation) {
        this.simulation = simulation;
        guard = simulation.guard;
        handles = simulation.handles;
        pipeline = simulation.pipeline;
        last = simulation.last;
    }

    /** Reads x, y, radius and mass of every circle, in the order of the ids. */
    public void read(float[] circles) {
        guard.enter();
        try {
            requireRoom("circles", circles, (long) CircleRow.STRIDE * handles.size());
            simulation.settle();
            pipeline.readCircles(handles, circles);
        } catch (RuntimeException | Error e) {
            throw guard.failed(e);
        } finally {
            guard.user = null;
        }
    }

    /** Reads x, y, radius and mass of every circle, in the order of the ids. */
    public void read(FloatBuffer circles) {
        guard.enter();
        try {
            requireRoom("circles", circles, (long) CircleRow.STRIDE * handles.size());
            circles.put(last.circles(), 0, CircleRow.STRIDE * handles.size());
        } catch (RuntimeException | Error e) {
            throw guard.failed(e);
        } finally {
            guard.user = null;
        }
    }

    /**
     * Reads x, y, radius and mass by id.
     *
     * @param circles takes four elements an id
     * @param living takes a bit for each id; may be null
     */
    public void readById(float[] circles, long[] living) {
        guard.enter();
        try {
            requireRoom("circles", circles, (long) CircleRow.STRIDE * handles.end());
            requireRoom(living, handles.end());
            simulation.settle();
            pipeline.readCircles(handles, circles);
            spread(circles, CircleRow.STRIDE, living);
        } catch (RuntimeException | Error e) {
            throw guard.failed(e);
        } finally {
            guard.user = null;
        }
    }

    /**
     * Reads velocities by id.
     *
     * @param velocities takes two elements an id
     * @param living takes a bit for each id; may be null
     */
    public void readVelocitiesById(float[] velocities, long[] living) {
        guard.enter();
        try {
            requireRoom("velocities", velocities, 2L * handles.end());
            requireRoom(living, handles.end());
            simulation.settle();
            pipeline.readVelocities(handles, velocities);
            spread(velocities, 2, living);
        } catch (RuntimeException | Error e) {
            throw guard.failed(e);
        } finally {
            guard.user = null;
        }
    }

    /** Reads kinds by id, and -1 where there is no circle; living takes a bit for each id, and may be null. */
    public void readKindsById(int[] kinds, long[] living) {
        guard.enter();
        try {
            requireRoom("kinds", Limits.notNull("kinds", kinds).length, handles.end());
            requireRoom(living, handles.end());
            for (int id = 0; id < kinds.length; id++) {
                boolean lives = id < handles.end() && handles.lives(id);
                kinds[id] = lives ? handles.fields().getInt(CircleField.KIND, id) : -1;
            }
            mask.copy(handles);
            copy(mask, living);
        } finally {
            guard.user = null;
        }
    }

    /** Reads radii by id, and NaN where there is no circle; living takes a bit for each id, and may be null. */
    public void readRadiiById(float[] radii, long[] living) {
        guard.enter();
        try {
            requireRoom("radii", radii, handles.end());
            requireRoom(living, handles.end());
            for (int id = 0; id < radii.length; id++) {
                radii[id] = id < handles.end() && handles.lives(id) ? handles.radius(id) : Float.NaN;
            }
            mask.copy(handles);
            copy(mask, living);
        } finally {
            guard.user = null;
        }
    }

    /** Reads tags by id, and 0 where there is no circle; living takes a bit for each id, and may be null. */
    public void readTagsById(long[] tags, long[] living) {
        guard.enter();
        try {
            requireRoom("tags", tags, handles.end());
            requireRoom(living, handles.end());
            for (int id = 0; id < tags.length; id++) {
                tags[id] = id < handles.end() ? handles.fields().get(CircleField.TAG, id) : 0;
            }
            mask.copy(handles);
            copy(mask, living);
        } finally {
            guard.user = null;
        }
    }

    private void spread(float[] values, int each, long[] living) {
        mask.copy(handles);
        mask.spread(values, each, handles.size());
        copy(mask, living);
    }

    private static void copy(IdMask mask, long[] living) {
        if (living != null) {
            mask.copyTo(living);
        }
    }

    /** Reads x and y of every circle, in the order of the ids, into memory of the pipeline. */
    public FloatBuffer positions() {
        guard.enter();
        try {
            simulation.settle();
            return pipeline.positions(handles, false);
        } catch (RuntimeException | Error e) {
            throw guard.failed(e);
        } finally {
            guard.user = null;
        }
    }

    /** Reads x and y by id into memory of the pipeline; living takes a bit for each id, and may be null. */
    public FloatBuffer positionsById(long[] living) {
        guard.enter();
        try {
            requireRoom(living, handles.end());
            simulation.settle();
            FloatBuffer positions = pipeline.positions(handles, true);
            mask.copy(handles);
            copy(mask, living);
            return positions;
        } catch (RuntimeException | Error e) {
            throw guard.failed(e);
        } finally {
            guard.user = null;
        }
    }

    /** Asks for x and y of every circle as they are now, without waiting for them. */
    public void requestPositions() {
        guard.enter();
        try {
            positionsRequested = false;
            simulation.applyCommands();
            requests++;
            handles.markSurvivors();
            pipeline.requestPositions(handles);
            positionsRequested = true;
        } catch (RuntimeException | Error e) {
            throw guard.failed(e);
        } finally {
            guard.user = null;
        }
    }

    /** A number that is another one after each request for positions. */
    public int requests() {
        guard.enter();
        try {
            return requests;
        } finally {
            guard.user = null;
        }
    }

    /** Gives the positions that were requested last. */
    public FloatBuffer takePositions() {
        guard.enter();
        try {
            requireRequest();
            return take(null);
        } catch (RuntimeException | Error e) {
            throw guard.failed(e);
        } finally {
            guard.user = null;
        }
    }

    /** Gives the positions that were requested last, by id; living takes a bit for each id, and may be null. */
    public FloatBuffer takePositionsById(long[] living) {
        guard.enter();
        try {
            requireRequest();
            requireRoom(living, handles.survivors().end());
            FloatBuffer positions = take(handles.survivors());
            copy(handles.survivors(), living);
            return positions;
        } catch (RuntimeException | Error e) {
            throw guard.failed(e);
        } finally {
            guard.user = null;
        }
    }

    private void requireRequest() {
        if (!positionsRequested) {
            throw new IllegalStateException("no positions have been requested since the last were taken:"
                    + " call requestPositions before each takePositions");
        }
    }

    private FloatBuffer take(IdMask shown) {
        positionsRequested = false;
        if (!pipeline.positionsArrived()) {
            simulation.finishSteps();
        }
        return pipeline.takePositions(shown);
    }

    /**
     * Makes values by id NaN that are not of the circles of the last request that have stayed.
     *
     * @param values by id
     * @param each elements an id
     * @param living takes a bit for each id; may be null
     */
    public void markGone(FloatBuffer values, int each, long[] living) {
        guard.enter();
        try {
            requireRoom(living, handles.survivors().end());
            handles.survivors().markGaps(values, each);
            copy(handles.survivors(), living);
        } catch (RuntimeException | Error e) {
            throw guard.failed(e);
        } finally {
            guard.user = null;
        }
    }

    /** Reads the velocity of every circle, in the order of the ids. */
    public void readVelocities(float[] velocities) {
        guard.enter();
        try {
            requireRoom("velocities", velocities, 2L * handles.size());
            simulation.settle();
            pipeline.readVelocities(handles, velocities);
        } catch (RuntimeException | Error e) {
            throw guard.failed(e);
        } finally {
            guard.user = null;
        }
    }

    /** Reads the velocity of every circle, in the order of the ids. */
    public void readVelocities(FloatBuffer velocities) {
        guard.enter();
        try {
            requireRoom("velocities", velocities, 2L * handles.size());
            velocities.put(last.velocities(), 0, 2 * handles.size());
        } catch (RuntimeException | Error e) {
            throw guard.failed(e);
        } finally {
            guard.user = null;
        }
    }

    /** Reads the handle of every circle, in the order of the ids. */
    public void readHandles(long[] to) {
        guard.enter();
        try {
            requireRoom("handles", to, handles.size());
            int k = 0;
            for (int id = 0; id < handles.end(); id++) {
                if (handles.lives(id)) {
                    to[k++] = handles.handle(id);
                }
            }
        } finally {
            guard.user = null;
        }
    }

    /** Reads the handle of every circle, in the order of the ids. */
    public void readHandles(LongBuffer to) {
        guard.enter();
        try {
            requireRoom("handles", to, handles.size());
            for (int id = 0; id < handles.end(); id++) {
                if (handles.lives(id)) {
                    to.put(handles.handle(id));
                }
            }
        } finally {
            guard.user = null;
        }
    }

    /**
     * Reads one number of one circle, from the last bulk read if it still holds.
     *
     * @param handle the circle
     * @param field {@link CircleRow#X}, {@code Y}, {@code RADIUS} or {@code MASS}
     * @return the number
     */
    public float circle(long handle, int field) {
        guard.enter();
        try {
            int place = handles.place(simulation.circles().find(handle));
            return last.circles()[CircleRow.STRIDE * place + field];
        } catch (RuntimeException | Error e) {
            throw guard.failed(e);
        } finally {
            guard.user = null;
        }
    }

    /** The velocity of one circle along x, from the last bulk read if it still holds. */
    public float vx(long handle) {
        return velocity(handle, 0);
    }

    /** The velocity of one circle along y, from the last bulk read if it still holds. */
    public float vy(long handle) {
        return velocity(handle, 1);
    }

    private float velocity(long handle, int component) {
        guard.enter();
        try {
            int place = handles.place(simulation.circles().find(handle));
            return last.velocities()[2 * place + component];
        } catch (RuntimeException | Error e) {
            throw guard.failed(e);
        } finally {
            guard.user = null;
        }
    }

    static void requireRoom(long[] living, int ids) {
        if (living != null) {
            requireRoom("living", living.length, IdMask.words(ids));
        }
    }

    static void requireRoom(String what, float[] array, long needs) {
        requireRoom(what, Limits.notNull(what, array).length, needs);
    }

    static void requireRoom(String what, long[] array, long needs) {
        requireRoom(what, Limits.notNull(what, array).length, needs);
    }

    static void requireRoom(String what, Buffer buffer, long needs) {
        Limits.notNull(what, buffer);
        if (buffer.isReadOnly()) {
            throw new IllegalArgumentException(what + " is a read-only buffer");
        }
        requireRoom(what, buffer.remaining(), needs);
    }

    static void requireRoom(String what, long has, long needs) {
        if (has < needs) {
            throw new IllegalArgumentException(what + " has room for " + has + " elements, but needs " + needs);
        }
    }
}
