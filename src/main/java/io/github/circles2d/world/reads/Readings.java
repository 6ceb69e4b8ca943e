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
    // The functions of the calls. They are linked before memory, or the stack, may end in a call.
    private static final Guard.ChangeWith<Readings, float[]> READ = Readings::copyCircles;
    private static final Guard.ChangeWith<Readings, FloatBuffer> READ_TO_BUFFER = Readings::putCircles;
    private static final Guard.ChangeWithTwo<Readings, float[], long[]> READ_BY_ID = Readings::copyCirclesById;
    private static final Guard.ChangeWithTwo<Readings, float[], long[]> READ_VELOCITIES_BY_ID =
            Readings::copyVelocitiesById;
    private static final Guard.ChangeWithTwo<Readings, float[], long[]> READ_ANGLES_BY_ID = Readings::copyAnglesById;
    private static final Guard.ChangeWith<Readings, int[]> READ_UNITS_BY_ID = Readings::copyUnitsById;
    private static final Guard.ChangeWithTwo<Readings, float[], long[]> READ_ANGULAR_VELOCITIES_BY_ID =
            Readings::copyAngularVelocitiesById;
    private static final Guard.Read<Readings, FloatBuffer> ANGLES = Readings::currentAngles;
    private static final Guard.ChangeWithTwo<Readings, int[], long[]> READ_KINDS_BY_ID = Readings::copyKindsById;
    private static final Guard.ChangeWithTwo<Readings, float[], long[]> READ_RADII_BY_ID = Readings::copyRadiiById;
    private static final Guard.ChangeWithTwo<Readings, long[], long[]> READ_TAGS_BY_ID = Readings::copyTagsById;
    private static final Guard.Read<Readings, FloatBuffer> POSITIONS = Readings::settledPositions;
    private static final Guard.ReadWith<Readings, long[], FloatBuffer> POSITIONS_BY_ID = Readings::settledPositionsById;
    private static final Guard.Change<Readings> REQUEST_POSITIONS = Readings::request;
    private static final Guard.Read<Readings, FloatBuffer> TAKE_POSITIONS = Readings::takeRequested;
    private static final Guard.ReadWith<Readings, long[], FloatBuffer> TAKE_POSITIONS_BY_ID =
            Readings::takeRequestedById;
    private static final Guard.ChangeWithTwo<Readings, FloatBuffer, long[]> MARK_GONE_OF_ONE =
            (all, v, bits) -> all.markGaps(v, 1, bits);
    private static final Guard.ChangeWithTwo<Readings, FloatBuffer, long[]> MARK_GONE_OF_TWO =
            (all, v, bits) -> all.markGaps(v, 2, bits);
    private static final Guard.ChangeWith<Readings, float[]> READ_VELOCITIES = Readings::copyVelocities;
    private static final Guard.ChangeWith<Readings, FloatBuffer> READ_VELOCITIES_TO_BUFFER = Readings::putVelocities;
    private static final Guard.ChangeWith<Readings, long[]> READ_HANDLES = Readings::copyHandles;
    private static final Guard.ChangeWith<Readings, LongBuffer> READ_HANDLES_TO_BUFFER = Readings::putHandles;
    private static final Guard.Numbers<Readings, Void> CIRCLE = Readings::circleBits;
    private static final Guard.Numbers<Readings, Void> VELOCITY = Readings::velocityBits;
    private static final Guard.Numbers<Readings, Void> ANGLE = Readings::angleUnits;
    private static final Guard.Numbers<Readings, Void> ANGULAR_VELOCITY = Readings::angularVelocityBits;

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
        guard.change(this, circles, READ);
    }

    private void copyCircles(float[] circles) {
        requireRoom("circles", circles, (long) CircleRow.STRIDE * handles.size());
        pending.settle();
        pipeline.readCircles(handles, circles);
    }

    /** Reads x, y, radius and mass of every circle, in the order of the ids. */
    public void read(FloatBuffer circles) {
        guard.change(this, circles, READ_TO_BUFFER);
    }

    private void putCircles(FloatBuffer circles) {
        requireRoom("circles", circles, (long) CircleRow.STRIDE * handles.size());
        circles.put(last.circles(), 0, CircleRow.STRIDE * handles.size());
    }

    /** x, y, radius and mass; living, with a bit an id, may be null. */
    public void readById(float[] circles, long[] living) {
        guard.change(this, circles, living, READ_BY_ID);
    }

    private void copyCirclesById(float[] circles, long[] living) {
        requireRoom("circles", circles, (long) CircleRow.STRIDE * handles.end());
        requireRoom(living, handles.end());
        pending.settle();
        pipeline.readCircles(handles, circles);
        spread(circles, CircleRow.STRIDE, living);
    }

    /** Two elements an id; living as above. */
    public void readVelocitiesById(float[] velocities, long[] living) {
        guard.change(this, velocities, living, READ_VELOCITIES_BY_ID);
    }

    private void copyVelocitiesById(float[] velocities, long[] living) {
        requireRoom("velocities", velocities, 2L * handles.end());
        requireRoom(living, handles.end());
        pending.settle();
        pipeline.readVelocities(handles, velocities);
        spread(velocities, 2, living);
    }

    /** An element an id, in radians; living as above. */
    public void readAnglesById(float[] to, long[] living) {
        guard.change(this, to, living, READ_ANGLES_BY_ID);
    }

    private void copyAnglesById(float[] to, long[] living) {
        requireRoom("angles", to, handles.end());
        requireRoom(living, handles.end());
        int[] units = last.angles();
        for (int k = 0; k < handles.size(); k++) {
            to[k] = units == null ? 0f : Surface.radians(units[k]);
        }
        spread(to, 1, living);
    }

    /** An element an id, in units of a turn's 2^-32; 0 where there is no circle. */
    public void readUnitsById(int[] to) {
        guard.change(this, to, READ_UNITS_BY_ID);
    }

    private void copyUnitsById(int[] to) {
        requireRoom("angles", to.length, handles.end());
        int[] units = last.angles();
        int k = 0;
        for (int id = 0; id < to.length; id++) {
            boolean turns = units != null && id < handles.end() && handles.lives(id);
            to[id] = turns ? units[k++] : 0;
        }
    }

    /** An element an id, in radians a second; living as above. */
    public void readAngularVelocitiesById(float[] to, long[] living) {
        guard.change(this, to, living, READ_ANGULAR_VELOCITIES_BY_ID);
    }

    private void copyAngularVelocitiesById(float[] to, long[] living) {
        requireRoom("angularVelocities", to, handles.end());
        requireRoom(living, handles.end());
        float[] velocities = last.angularVelocities();
        for (int k = 0; k < handles.size(); k++) {
            to[k] = velocities == null ? 0f : velocities[k];
        }
        spread(to, 1, living);
    }

    /** Reads the angle of every circle, in the order of the ids, into memory of the world. */
    public FloatBuffer angles() {
        return guard.read(this, ANGLES);
    }

    private FloatBuffer currentAngles() {
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
    }

    /** Reads kinds by id, and -1 where there is no circle; living takes a bit for each id, and may be null. */
    public void readKindsById(int[] kinds, long[] living) {
        guard.change(this, kinds, living, READ_KINDS_BY_ID);
    }

    private void copyKindsById(int[] kinds, long[] living) {
        requireRoom("kinds", Limits.notNull("kinds", kinds).length, handles.end());
        requireRoom(living, handles.end());
        for (int id = 0; id < kinds.length; id++) {
            boolean lives = id < handles.end() && handles.lives(id);
            kinds[id] = lives ? handles.fields().getInt(CircleField.KIND, id) : -1;
        }
        mask.copy(handles);
        copy(mask, living);
    }

    /** Reads radii by id, and NaN where there is no circle; living takes a bit for each id, and may be null. */
    public void readRadiiById(float[] radii, long[] living) {
        guard.change(this, radii, living, READ_RADII_BY_ID);
    }

    private void copyRadiiById(float[] radii, long[] living) {
        requireRoom("radii", radii, handles.end());
        requireRoom(living, handles.end());
        for (int id = 0; id < radii.length; id++) {
            radii[id] = id < handles.end() && handles.lives(id) ? handles.radius(id) : Float.NaN;
        }
        mask.copy(handles);
        copy(mask, living);
    }

    /** Reads tags by id, and 0 where there is no circle; living takes a bit for each id, and may be null. */
    public void readTagsById(long[] tags, long[] living) {
        guard.change(this, tags, living, READ_TAGS_BY_ID);
    }

    private void copyTagsById(long[] tags, long[] living) {
        requireRoom("tags", tags, handles.end());
        requireRoom(living, handles.end());
        for (int id = 0; id < tags.length; id++) {
            tags[id] = id < handles.end() ? handles.fields().get(CircleField.TAG, id) : 0;
        }
        mask.copy(handles);
        copy(mask, living);
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
        return guard.read(this, POSITIONS);
    }

    private FloatBuffer settledPositions() {
        pending.settle();
        return pipeline.positions(handles, false);
    }

    /** Reads x and y by id into memory of the pipeline; living takes a bit for each id, and may be null. */
    public FloatBuffer positionsById(long[] living) {
        return guard.read(this, living, POSITIONS_BY_ID);
    }

    private FloatBuffer settledPositionsById(long[] living) {
        requireRoom(living, handles.end());
        pending.settle();
        FloatBuffer positions = pipeline.positions(handles, true);
        mask.copy(handles);
        copy(mask, living);
        return positions;
    }

    /** Asks for x and y of every circle as they are now, without waiting for them. */
    public void requestPositions() {
        guard.change(this, REQUEST_POSITIONS);
    }

    private void request() {
        pending.apply();
        handles.makeRoomForSurvivors();
        pipeline.makeRoomForPositions(handles);
        positionsRequested = false; // what was requested before is lost if the pipeline fails
        handles.markSurvivors();
        pipeline.requestPositions(handles);
        requests++;
        positionsRequested = true;
    }

    /** A number that is another one after each request for positions. */
    public int requests() {
        guard.check();
        return requests;
    }

    /** Gives the positions that were requested last. */
    public FloatBuffer takePositions() {
        return guard.read(this, TAKE_POSITIONS);
    }

    private FloatBuffer takeRequested() {
        requireRequest();
        return take(null);
    }

    /** Gives the positions that were requested last, by id; living takes a bit for each id, and may be null. */
    public FloatBuffer takePositionsById(long[] living) {
        return guard.read(this, living, TAKE_POSITIONS_BY_ID);
    }

    private FloatBuffer takeRequestedById(long[] living) {
        requireRequest();
        requireRoom(living, handles.survivors().end());
        FloatBuffer positions = take(handles.survivors());
        copy(handles.survivors(), living);
        return positions;
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

    /** Values of ids whose circles of the last request have gone become NaN; each is 1 or 2 elements an id. */
    public void markGone(FloatBuffer values, int each, long[] living) {
        guard.change(this, values, living, each == 1 ? MARK_GONE_OF_ONE : MARK_GONE_OF_TWO);
    }

    private void markGaps(FloatBuffer values, int each, long[] living) {
        requireRoom(living, handles.survivors().end());
        handles.survivors().markGaps(values, each);
        copy(handles.survivors(), living);
    }

    /** Reads the velocity of every circle, in the order of the ids. */
    public void readVelocities(float[] velocities) {
        guard.change(this, velocities, READ_VELOCITIES);
    }

    private void copyVelocities(float[] velocities) {
        requireRoom("velocities", velocities, 2L * handles.size());
        pending.settle();
        pipeline.readVelocities(handles, velocities);
    }

    /** Reads the velocity of every circle, in the order of the ids. */
    public void readVelocities(FloatBuffer velocities) {
        guard.change(this, velocities, READ_VELOCITIES_TO_BUFFER);
    }

    private void putVelocities(FloatBuffer velocities) {
        requireRoom("velocities", velocities, 2L * handles.size());
        velocities.put(last.velocities(), 0, 2 * handles.size());
    }

    /** Reads the handle of every circle, in the order of the ids. */
    public void readHandles(long[] to) {
        guard.change(this, to, READ_HANDLES);
    }

    private void copyHandles(long[] to) {
        requireRoom("handles", to, handles.size());
        int k = 0;
        for (int id = 0; id < handles.end(); id++) {
            if (handles.lives(id)) {
                to[k++] = handles.handle(id);
            }
        }
    }

    /** Reads the handle of every circle, in the order of the ids. */
    public void readHandles(LongBuffer to) {
        guard.change(this, to, READ_HANDLES_TO_BUFFER);
    }

    private void putHandles(LongBuffer to) {
        requireRoom("handles", to, handles.size());
        for (int id = 0; id < handles.end(); id++) {
            if (handles.lives(id)) {
                to.put(handles.handle(id));
            }
        }
    }

    /** {@link CircleRow#X}, {@code Y}, {@code RADIUS} or {@code MASS} of one circle, from the last bulk read if it still holds. */
    public float circle(long handle, int field) {
        return Float.intBitsToFloat((int) guard.read(this, null, handle, field, CIRCLE));
    }

    private long circleBits(Void none, long handle, long field) {
        int place = handles.place(Circles.find(handles, handle));
        return Float.floatToRawIntBits(last.circles()[CircleRow.STRIDE * place + (int) field]);
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
        return Float.intBitsToFloat((int) guard.read(this, null, handle, component, VELOCITY));
    }

    private long velocityBits(Void none, long handle, long component) {
        int place = handles.place(Circles.find(handles, handle));
        return Float.floatToRawIntBits(last.velocities()[2 * place + (int) component]);
    }

    /** The angle of one circle in radians, from the last bulk read if it still holds. */
    public float angle(long handle) {
        return Surface.radians((int) guard.read(this, null, handle, 0, ANGLE));
    }

    private long angleUnits(Void none, long handle, long n) {
        int id = Circles.find(handles, handle);
        int[] units = last.angles();
        return units == null ? 0 : units[handles.place(id)];
    }

    /** The angular velocity of one circle, likewise. */
    public float angularVelocity(long handle) {
        return Float.intBitsToFloat((int) guard.read(this, null, handle, 0, ANGULAR_VELOCITY));
    }

    private long angularVelocityBits(Void none, long handle, long n) {
        int id = Circles.find(handles, handle);
        float[] velocities = last.angularVelocities();
        return velocities == null ? 0 : Float.floatToRawIntBits(velocities[handles.place(id)]);
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
