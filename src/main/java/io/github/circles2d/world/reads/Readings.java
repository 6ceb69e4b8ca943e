package io.github.circles2d.world.reads;

import io.github.circles2d.world.circles.CircleField;
import io.github.circles2d.world.circles.IdMask;
import io.github.circles2d.world.model.CircleRow;
import io.github.circles2d.world.model.Limits;
import io.github.circles2d.world.model.Surface;
import io.github.circles2d.world.shared.Pipeline;
import io.github.circles2d.world.shared.WorldParts;
import java.nio.Buffer;
import java.nio.FloatBuffer;
import java.nio.LongBuffer;
import java.util.Arrays;

/** Reads of all circles, in the order of the ids, and of single numbers, which come from the last read of all. */
public final class Readings {
    private final WorldParts world;

    /** The ids of the circles of a read by id. */
    private final IdMask mask = new IdMask();

    /** What {@link #angles} gives. */
    private FloatBuffer angles = FloatBuffer.allocate(0);

    private FloatBuffer viewOfAngles = angles.asReadOnlyBuffer();

    /** Whether positions have been requested since the last were taken. */
    private boolean positionsRequested;

    /** Who was asked for positions last: the world may have moved since. */
    private Pipeline asked;

    /** The number of requests for positions; may overflow. */
    private int requests;

    /** A bit an id, of circles that sleep. */
    private long[] asleep = new long[0];

    public Readings(WorldParts world) {
        this.world = world;
    }

    /** Reads x, y, radius and mass of every circle, in the order of the ids. */
    public void read(float[] circles) {
        world.guard.enter();
        try (world.guard) {
            requireRoom("circles", circles, (long) CircleRow.STRIDE * world.handles.size());
            world.last.readCircles(circles);
        }
    }

    /** Reads x, y, radius and mass of every circle, in the order of the ids. */
    public void read(FloatBuffer circles) {
        world.guard.enter();
        try (world.guard) {
            requireRoom("circles", circles, (long) CircleRow.STRIDE * world.handles.size());
            circles.put(world.last.circles(), 0, CircleRow.STRIDE * world.handles.size());
        }
    }

    /** x, y, radius and mass; living, with a bit an id, may be null. */
    public void readById(float[] circles, long[] living) {
        world.guard.enter();
        try (world.guard) {
            requireRoom("circles", circles, (long) CircleRow.STRIDE * world.handles.end());
            requireRoom(living, world.handles.end());
            world.last.readCircles(circles);
            spread(circles, CircleRow.STRIDE, living);
        }
    }

    /** Two elements an id; living as above. */
    public void readVelocitiesById(float[] velocities, long[] living) {
        world.guard.enter();
        try (world.guard) {
            requireRoom("velocities", velocities, 2L * world.handles.end());
            requireRoom(living, world.handles.end());
            world.last.readVelocities(velocities);
            spread(velocities, 2, living);
        }
    }

    /** An element an id, in radians; living as above. */
    public void readAnglesById(float[] to, long[] living) {
        world.guard.enter();
        try (world.guard) {
            requireRoom("angles", to, world.handles.end());
            requireRoom(living, world.handles.end());
            int[] units = world.last.angles();
            for (int k = 0; k < world.handles.size(); k++) {
                to[k] = units == null ? 0f : Surface.radians(units[k]);
            }
            spread(to, 1, living);
        }
    }

    /** Whether a circle does not sleep. */
    public boolean isAwake(long handle) {
        world.guard.enter();
        try (world.guard) {
            int id = world.circle(handle);
            world.pending.settle();
            return !world.pipeline.isAsleep(id);
        }
    }

    /** Sets a bit an id, of circles that do not sleep. */
    public void readAwakeById(long[] to) {
        world.guard.enter();
        try (world.guard) {
            requireRoom("awake", to, IdMask.words(world.handles.end()));
            findAsleep();
            Arrays.fill(to, 0L);
            for (int id = 0; id < world.handles.end(); id++) {
                boolean isAwake = world.handles.lives(id) && (asleep[id >> 6] & 1L << id) == 0;
                to[id >> 6] |= isAwake ? 1L << id : 0L;
            }
        }
    }

    /** The number of circles that neither sleep nor are static. Calls and steps have been made. */
    public int awake() {
        findAsleep();
        int sleeping = 0;
        for (long bits : asleep) {
            sleeping += Long.bitCount(bits);
        }
        return world.handles.size() - world.handles.statics() - sleeping;
    }

    private void findAsleep() {
        world.pending.settle();
        int words = (world.handles.end() + 63) >> 6;
        if (asleep.length < words) {
            asleep = new long[words + (words >> 1)];
        }
        Arrays.fill(asleep, 0L);
        world.pipeline.readAsleep(asleep);
    }

    /** An element an id, in units of a turn's 2^-32; 0 where there is no circle. */
    public void readUnitsById(int[] to) {
        world.guard.enter();
        try (world.guard) {
            requireRoom("angles", to.length, world.handles.end());
            int[] units = world.last.angles();
            int k = 0;
            for (int id = 0; id < to.length; id++) {
                boolean turns = units != null && id < world.handles.end() && world.handles.lives(id);
                to[id] = turns ? units[k++] : 0;
            }
        }
    }

    /** An element an id, in radians a second; living as above. */
    public void readAngularVelocitiesById(float[] to, long[] living) {
        world.guard.enter();
        try (world.guard) {
            requireRoom("angularVelocities", to, world.handles.end());
            requireRoom(living, world.handles.end());
            float[] velocities = world.last.angularVelocities();
            for (int k = 0; k < world.handles.size(); k++) {
                to[k] = velocities == null ? 0f : velocities[k];
            }
            spread(to, 1, living);
        }
    }

    /** Reads the angle of every circle, in the order of the ids, into memory of the world. */
    public FloatBuffer angles() {
        world.guard.enter();
        try (world.guard) {
            int[] units = world.last.angles();
            int circles = world.handles.size();
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
        }
    }

    /** Reads kinds by id, and -1 where there is no circle; living takes a bit for each id, and may be null. */
    public void readKindsById(int[] kinds, long[] living) {
        world.guard.enter();
        try (world.guard) {
            requireRoom("kinds", Limits.notNull("kinds", kinds).length, world.handles.end());
            requireRoom(living, world.handles.end());
            for (int id = 0; id < kinds.length; id++) {
                boolean lives = id < world.handles.end() && world.handles.lives(id);
                kinds[id] = lives ? world.handles.fields().getInt(CircleField.KIND, id) : -1;
            }
            markLiving(living);
        }
    }

    /** Reads radii by id, and NaN where there is no circle; living takes a bit for each id, and may be null. */
    public void readRadiiById(float[] radii, long[] living) {
        world.guard.enter();
        try (world.guard) {
            requireRoom("radii", radii, world.handles.end());
            requireRoom(living, world.handles.end());
            for (int id = 0; id < radii.length; id++) {
                radii[id] = id < world.handles.end() && world.handles.lives(id) ? world.handles.radius(id) : Float.NaN;
            }
            markLiving(living);
        }
    }

    /** Reads tags by id, and 0 where there is no circle; living takes a bit for each id, and may be null. */
    public void readTagsById(long[] tags, long[] living) {
        world.guard.enter();
        try (world.guard) {
            requireRoom("tags", tags, world.handles.end());
            requireRoom(living, world.handles.end());
            for (int id = 0; id < tags.length; id++) {
                tags[id] = id < world.handles.end() ? world.handles.fields().get(CircleField.TAG, id) : 0;
            }
            markLiving(living);
        }
    }

    private void spread(float[] values, int each, long[] living) {
        mask.copy(world.handles);
        mask.spread(values, each, world.handles.size());
        copy(mask, living);
    }

    private void markLiving(long[] living) {
        mask.copy(world.handles);
        copy(mask, living);
    }

    private static void copy(IdMask mask, long[] living) {
        if (living != null) {
            mask.copyTo(living);
        }
    }

    /** Reads x and y of every circle, in the order of the ids, into memory of the pipeline. */
    public FloatBuffer positions() {
        world.guard.enter();
        try (world.guard) {
            return positions(false);
        }
    }

    /** Reads x and y by id into memory of the pipeline; living takes a bit for each id, and may be null. */
    public FloatBuffer positionsById(long[] living) {
        world.guard.enter();
        try (world.guard) {
            requireRoom(living, world.handles.end());
            FloatBuffer positions = positions(true);
            markLiving(living);
            return positions;
        }
    }

    private FloatBuffer positions(boolean byId) {
        world.pending.settle();
        world.clock.begin();
        FloatBuffer positions = world.pipeline.positions(world.handles, byId);
        world.clock.end();
        return positions;
    }

    /** Asks for x and y of every circle as they are now, without waiting for them. */
    public void requestPositions() {
        world.guard.enter();
        try (world.guard) {
            world.pending.apply();
            world.handles.makeRoomForSurvivors();
            world.pipeline.makeRoomForPositions(world.handles);
            positionsRequested = false; // what was requested before is lost if the pipeline fails
            world.handles.markSurvivors();
            asked = world.pipeline;
            world.clock.begin();
            asked.requestPositions(world.handles);
            world.clock.end();
            requests++;
            positionsRequested = true;
        }
    }

    /** A number that is another one after each request for positions. */
    public int requests() {
        world.guard.check();
        return requests;
    }

    /** Gives the positions that were requested last. */
    public FloatBuffer takePositions() {
        world.guard.enter();
        try (world.guard) {
            requireRequest();
            return take(null);
        }
    }

    /** Gives the positions that were requested last, by id; living takes a bit for each id, and may be null. */
    public FloatBuffer takePositionsById(long[] living) {
        world.guard.enter();
        try (world.guard) {
            requireRequest();
            requireRoom(living, world.handles.survivors().end());
            FloatBuffer positions = take(world.handles.survivors());
            copy(world.handles.survivors(), living);
            return positions;
        }
    }

    private void requireRequest() {
        if (!positionsRequested || world.moves.hasFailed(asked)) {
            throw new IllegalStateException("no positions have been requested since the last were taken:"
                    + " call requestPositions before each takePositions");
        }
    }

    private FloatBuffer take(IdMask shown) {
        world.clock.begin();
        if (!asked.positionsArrived()) {
            world.pending.finish();
        }
        FloatBuffer taken = asked.takePositions(shown);
        world.clock.end();
        positionsRequested = false;
        return taken;
    }

    /**
     * Values of ids whose circles of the last request have gone become NaN; each is 1 or 2 elements an id. living takes the bits of all circles
     * of now, also of those that came after the request.
     */
    public void markGone(FloatBuffer values, int each, long[] living) {
        world.guard.enter();
        try (world.guard) {
            requireRoom(living, Math.max(world.handles.survivors().end(), world.handles.end()));
            world.handles.survivors().markGaps(values, each);
            copy(world.handles.survivors(), living);
            for (int id = newFrom(0); id >= 0 && living != null; id = newFrom(id + 1)) {
                living[id >>> 6] |= 1L << id;
            }
        }
    }

    /** The least id, from one on, of a circle that came after the last request for positions; -1 if there is none. */
    public int nextNew(int from) {
        world.guard.enter();
        try (world.guard) {
            return newFrom(from);
        }
    }

    private int newFrom(int from) {
        for (int id = from; id < world.handles.end(); id++) {
            if (world.handles.lives(id) && !world.handles.survivors().has(id)) {
                return id;
            }
        }
        return -1;
    }

    /** Reads the velocity of every circle, in the order of the ids. */
    public void readVelocities(float[] velocities) {
        world.guard.enter();
        try (world.guard) {
            requireRoom("velocities", velocities, 2L * world.handles.size());
            world.last.readVelocities(velocities);
        }
    }

    /** Reads the velocity of every circle, in the order of the ids. */
    public void readVelocities(FloatBuffer velocities) {
        world.guard.enter();
        try (world.guard) {
            requireRoom("velocities", velocities, 2L * world.handles.size());
            velocities.put(world.last.velocities(), 0, 2 * world.handles.size());
        }
    }

    /** Reads the handle of every circle, in the order of the ids. */
    public void readHandles(long[] to) {
        world.guard.enter();
        try (world.guard) {
            requireRoom("handles", to, world.handles.size());
            int k = 0;
            for (int id = 0; id < world.handles.end(); id++) {
                if (world.handles.lives(id)) {
                    to[k++] = world.handles.handle(id);
                }
            }
        }
    }

    /** Reads the handle of every circle, in the order of the ids. */
    public void readHandles(LongBuffer to) {
        world.guard.enter();
        try (world.guard) {
            requireRoom("handles", to, world.handles.size());
            for (int id = 0; id < world.handles.end(); id++) {
                if (world.handles.lives(id)) {
                    to.put(world.handles.handle(id));
                }
            }
        }
    }

    /** {@link CircleRow#X}, {@code Y}, {@code RADIUS} or {@code MASS} of one circle, from the last bulk read if it still holds. */
    public float circle(long handle, int field) {
        world.guard.enter();
        try (world.guard) {
            int place = world.handles.place(world.circle(handle));
            return world.last.circles()[CircleRow.STRIDE * place + field];
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
        world.guard.enter();
        try (world.guard) {
            int place = world.handles.place(world.circle(handle));
            return world.last.velocities()[2 * place + component];
        }
    }

    /** The angle of one circle in radians, from the last bulk read if it still holds. */
    public float angle(long handle) {
        world.guard.enter();
        try (world.guard) {
            int id = world.circle(handle);
            int[] units = world.last.angles();
            return units == null ? 0 : Surface.radians(units[world.handles.place(id)]);
        }
    }

    /** The angular velocity of one circle, likewise. */
    public float angularVelocity(long handle) {
        world.guard.enter();
        try (world.guard) {
            int id = world.circle(handle);
            float[] velocities = world.last.angularVelocities();
            return velocities == null ? 0 : velocities[world.handles.place(id)];
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
