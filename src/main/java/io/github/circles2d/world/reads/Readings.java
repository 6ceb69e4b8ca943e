package io.github.circles2d.world.reads;

import io.github.circles2d.world.changes.Circles;
import io.github.circles2d.world.circles.CircleField;
import io.github.circles2d.world.circles.HandleTable;
import io.github.circles2d.world.circles.IdMask;
import io.github.circles2d.world.model.CircleRow;
import io.github.circles2d.world.model.Limits;
import io.github.circles2d.world.model.Surface;
import io.github.circles2d.world.shared.Guard;
import io.github.circles2d.world.shared.LastReading;
import io.github.circles2d.world.shared.PendingWork;
import io.github.circles2d.world.shared.Pipeline;
import java.nio.Buffer;
import java.nio.FloatBuffer;
import java.nio.LongBuffer;

/** Reads of all circles, in the order of the ids, and of single numbers, which come from the last read of all. */
public final class Readings {
    private final Guard guard;
    private final HandleTable handles;
    private final Pipeline pipeline;
    private final PendingWork pending;
    private final LastReading last;

    /** The ids of the circles of a read by id. */
    private final IdMask mask = new IdMask();

    /** What {@link #angles} gives. */
    private FloatBuffer angles = FloatBuffer.allocate(0);

    private FloatBuffer viewOfAngles = angles.asReadOnlyBuffer();

    /** Whether positions have been requested since the last were taken. */
    private boolean positionsRequested;

    /** The number of requests for positions; may overflow. */
    private int requests;

    public Readings(Guard guard, HandleTable handles, Pipeline pipeline, PendingWork pending, LastReading last) {
        this.guard = guard;
        this.handles = handles;
        this.pipeline = pipeline;
        this.pending = pending;
        this.last = last;
    }

    /** Reads x, y, radius and mass of every circle, in the order of the ids. */
    public void read(float[] circles) {
        guard.enter();
        try {
            requireRoom("circles", circles, (long) CircleRow.STRIDE * handles.size());
            pending.settle();
            pipeline.readCircles(handles, circles);
        } catch (RuntimeException | Error thrown) {
            throw guard.failed(thrown);
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
        } catch (RuntimeException | Error thrown) {
            throw guard.failed(thrown);
        } finally {
            guard.user = null;
        }
    }

    /** x, y, radius and mass; living, with a bit an id, may be null. */
    public void readById(float[] circles, long[] living) {
        guard.enter();
        try {
            requireRoom("circles", circles, (long) CircleRow.STRIDE * handles.end());
            requireRoom(living, handles.end());
            pending.settle();
            pipeline.readCircles(handles, circles);
            spread(circles, CircleRow.STRIDE, living);
        } catch (RuntimeException | Error thrown) {
            throw guard.failed(thrown);
        } finally {
            guard.user = null;
        }
    }

    /** Two elements an id; living as above. */
    public void readVelocitiesById(float[] velocities, long[] living) {
        guard.enter();
        try {
            requireRoom("velocities", velocities, 2L * handles.end());
            requireRoom(living, handles.end());
            pending.settle();
            pipeline.readVelocities(handles, velocities);
            spread(velocities, 2, living);
        } catch (RuntimeException | Error thrown) {
            throw guard.failed(thrown);
        } finally {
            guard.user = null;
        }
    }

    /** An element an id, in radians; living as above. */
    public void readAnglesById(float[] to, long[] living) {
        guard.enter();
        try {
            requireRoom("angles", to, handles.end());
            requireRoom(living, handles.end());
            int[] units = last.angles();
            for (int k = 0; k < handles.size(); k++) {
                to[k] = units == null ? 0f : Surface.radians(units[k]);
            }
            spread(to, 1, living);
        } catch (RuntimeException | Error thrown) {
            throw guard.failed(thrown);
        } finally {
            guard.user = null;
        }
    }

    /** An element an id, in units of a turn's 2^-32; 0 where there is no circle. */
    public void readUnitsById(int[] to) {
        guard.enter();
        try {
            requireRoom("angles", to.length, handles.end());
            int[] units = last.angles();
            int k = 0;
            for (int id = 0; id < to.length; id++) {
                boolean turns = units != null && id < handles.end() && handles.lives(id);
                to[id] = turns ? units[k++] : 0;
            }
        } catch (RuntimeException | Error thrown) {
            throw guard.failed(thrown);
        } finally {
            guard.user = null;
        }
    }

    /** An element an id, in radians a second; living as above. */
    public void readAngularVelocitiesById(float[] to, long[] living) {
        guard.enter();
        try {
            requireRoom("angularVelocities", to, handles.end());
            requireRoom(living, handles.end());
            float[] velocities = last.angularVelocities();
            for (int k = 0; k < handles.size(); k++) {
                to[k] = velocities == null ? 0f : velocities[k];
            }
            spread(to, 1, living);
        } catch (RuntimeException | Error thrown) {
            throw guard.failed(thrown);
        } finally {
            guard.user = null;
        }
    }

    /** Reads the angle of every circle, in the order of the ids, into memory of the world. */
    public FloatBuffer angles() {
        guard.enter();
        try {
            int[] units = last.angles();
            int circles = handles.size();
            if (angles.capacity() < circles) {
                FloatBuffer larger = FloatBuffer.allocate(circles + (circles >> 1));
                viewOfAngles = larger.asReadOnlyBuffer();
                angles = larger;
            }
            for (int k = 0; k < circles; k++) {
                angles.put(k, units == null ? 0f : Surface.radians(units[k]));
            }
            ((Buffer) viewOfAngles).clear().limit(circles);
            return viewOfAngles;
        } catch (RuntimeException | Error thrown) {
            throw guard.failed(thrown);
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
        } catch (RuntimeException | Error thrown) {
            throw guard.failed(thrown);
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
        } catch (RuntimeException | Error thrown) {
            throw guard.failed(thrown);
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
        } catch (RuntimeException | Error thrown) {
            throw guard.failed(thrown);
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
            pending.settle();
            return pipeline.positions(handles, false);
        } catch (RuntimeException | Error thrown) {
            throw guard.failed(thrown);
        } finally {
            guard.user = null;
        }
    }

    /** Reads x and y by id into memory of the pipeline; living takes a bit for each id, and may be null. */
    public FloatBuffer positionsById(long[] living) {
        guard.enter();
        try {
            requireRoom(living, handles.end());
            pending.settle();
            FloatBuffer positions = pipeline.positions(handles, true);
            mask.copy(handles);
            copy(mask, living);
            return positions;
        } catch (RuntimeException | Error thrown) {
            throw guard.failed(thrown);
        } finally {
            guard.user = null;
        }
    }

    /** Asks for x and y of every circle as they are now, without waiting for them. */
    public void requestPositions() {
        guard.enter();
        try {
            pending.apply();
            handles.makeRoomForSurvivors();
            pipeline.makeRoomForPositions(handles);
            positionsRequested = false; // what was requested before is lost if the pipeline fails
            handles.markSurvivors();
            pipeline.requestPositions(handles);
            requests++;
            positionsRequested = true;
        } catch (RuntimeException | Error thrown) {
            throw guard.failed(thrown);
        } finally {
            guard.user = null;
        }
    }

    /** A number that is another one after each request for positions. */
    public int requests() {
        guard.check();
        return requests;
    }

    /** Gives the positions that were requested last. */
    public FloatBuffer takePositions() {
        guard.enter();
        try {
            requireRequest();
            return take(null);
        } catch (RuntimeException | Error thrown) {
            throw guard.failed(thrown);
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
        } catch (RuntimeException | Error thrown) {
            throw guard.failed(thrown);
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
        if (!pipeline.positionsArrived()) {
            pending.finish();
        }
        FloatBuffer taken = pipeline.takePositions(shown);
        positionsRequested = false;
        return taken;
    }

    /**
     * Values of ids whose circles of the last request have gone become NaN; each is 1 or 2 elements an id. living takes the bits of all circles
     * of now, also of those that came after the request.
     */
    public void markGone(FloatBuffer values, int each, long[] living) {
        guard.enter();
        try {
            requireRoom(living, Math.max(handles.survivors().end(), handles.end()));
            handles.survivors().markGaps(values, each);
            copy(handles.survivors(), living);
            for (int id = newFrom(0); id >= 0 && living != null; id = newFrom(id + 1)) {
                living[id >>> 6] |= 1L << id;
            }
        } catch (RuntimeException | Error thrown) {
            throw guard.failed(thrown);
        } finally {
            guard.user = null;
        }
    }

    /** The least id, from one on, of a circle that came after the last request for positions; -1 if there is none. */
    public int nextNew(int from) {
        guard.enter();
        try {
            return newFrom(from);
        } catch (RuntimeException | Error thrown) {
            throw guard.failed(thrown);
        } finally {
            guard.user = null;
        }
    }

    private int newFrom(int from) {
        for (int id = from; id < handles.end(); id++) {
            if (handles.lives(id) && !handles.survivors().has(id)) {
                return id;
            }
        }
        return -1;
    }

    /** Reads the velocity of every circle, in the order of the ids. */
    public void readVelocities(float[] velocities) {
        guard.enter();
        try {
            requireRoom("velocities", velocities, 2L * handles.size());
            pending.settle();
            pipeline.readVelocities(handles, velocities);
        } catch (RuntimeException | Error thrown) {
            throw guard.failed(thrown);
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
        } catch (RuntimeException | Error thrown) {
            throw guard.failed(thrown);
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
        } catch (RuntimeException | Error thrown) {
            throw guard.failed(thrown);
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
        } catch (RuntimeException | Error thrown) {
            throw guard.failed(thrown);
        } finally {
            guard.user = null;
        }
    }

    /** {@link CircleRow#X}, {@code Y}, {@code RADIUS} or {@code MASS} of one circle, from the last bulk read if it still holds. */
    public float circle(long handle, int field) {
        guard.enter();
        try {
            int place = handles.place(Circles.find(handles, handle));
            return last.circles()[CircleRow.STRIDE * place + field];
        } catch (RuntimeException | Error thrown) {
            throw guard.failed(thrown);
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
            int place = handles.place(Circles.find(handles, handle));
            return last.velocities()[2 * place + component];
        } catch (RuntimeException | Error thrown) {
            throw guard.failed(thrown);
        } finally {
            guard.user = null;
        }
    }

    /** The angle of one circle in radians, from the last bulk read if it still holds. */
    public float angle(long handle) {
        guard.enter();
        try {
            int id = Circles.find(handles, handle);
            int[] units = last.angles();
            return units == null ? 0 : Surface.radians(units[handles.place(id)]);
        } catch (RuntimeException | Error thrown) {
            throw guard.failed(thrown);
        } finally {
            guard.user = null;
        }
    }

    /** The angular velocity of one circle, likewise. */
    public float angularVelocity(long handle) {
        guard.enter();
        try {
            int id = Circles.find(handles, handle);
            float[] velocities = last.angularVelocities();
            return velocities == null ? 0 : velocities[handles.place(id)];
        } catch (RuntimeException | Error thrown) {
            throw guard.failed(thrown);
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
