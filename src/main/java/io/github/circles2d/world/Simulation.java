package io.github.circles2d.world;

import io.github.circles2d.world.circles.Commands;
import io.github.circles2d.world.circles.HandleTable;
import io.github.circles2d.world.circles.SavedState;
import io.github.circles2d.world.circles.SnapshotCodec;
import io.github.circles2d.world.circles.WorldParameters;
import io.github.circles2d.world.model.Bounds;
import io.github.circles2d.world.model.CircleRow;
import io.github.circles2d.world.model.GridLevels;
import io.github.circles2d.world.model.Limits;
import io.github.circles2d.world.model.StepConstants;
import java.nio.Buffer;
import java.nio.ByteBuffer;
import java.nio.FloatBuffer;
import java.nio.LongBuffer;
import java.util.Collections;
import java.util.Objects;

/**
 * Drives a {@link Pipeline}: it checks arguments, collects changes, makes steps, reads, and takes snapshots. It is the inside of
 * {@code World}, whose documentation says what each call does and throws.
 *
 * <p>{@link Guard} guards every call. A call makes room before it changes the state: if memory runs out, nothing has changed.
 */
public final class Simulation implements AutoCloseable {
    private final Pipeline pipeline;
    private final Guard guard;
    private final HandleTable handles = new HandleTable();
    private final Commands commands = new Commands();
    private final GridLevels levels = new GridLevels();
    private final StepConstants constants = new StepConstants();
    private final LastReading last;
    private final SavedState saved = new SavedState();

    private Bounds bounds;
    private float gravityX;
    private float gravityY;
    private float defaultRestitution;
    private int subSteps;
    private float previousTimeStep;

    /** Whether the last step had no circles; also if there has been none, or none since a restore. */
    private boolean emptyStep = true;

    private boolean savedCurrent;
    private boolean positionsRequested;

    /**
     * A world without circles.
     *
     * @param pipeline what holds the state and makes the steps; closed with this object
     * @param start bounds, gravity, restitution and sub-steps, which have been checked
     */
    public Simulation(Pipeline pipeline, WorldParameters start) {
        this.pipeline = pipeline;
        guard = new Guard(pipeline);
        last = new LastReading(pipeline, handles, this::settle);
        setParameters(start);
    }

    // ---- circles
    // -----------------------------------------------------------------------------------------------------

    /** Adds a circle, with the world's restitution, and returns its handle. */
    public long add(float x, float y, float radius, float mass, float vx, float vy) {
        guard.enter();
        try {
            checkRoom(1);
            check(x, y, radius, mass, vx, vy);
            expect(1);
            handles.ensure(1);
            commands.prepare(0, x, y, radius, mass, defaultRestitution, vx, vy);
            changed();
            guard.changing = true;
            long handle = admit();
            guard.changing = false;
            return handle;
        } catch (RuntimeException | Error e) {
            throw guard.failed(e);
        } finally {
            guard.user = null;
        }
    }

    /** Adds circles, four elements each, with velocities, or at rest if there are none; the handles are optional, too. */
    public void addAll(float[] circles, float[] velocities, long[] to) {
        guard.enter();
        try {
            Objects.requireNonNull(circles, "circles");
            int n = circles.length / CircleRow.STRIDE;
            checkLengths(n, circles, velocities, to);
            checkRoom(n);
            expect(n);
            handles.ensure(n);
            for (int i = 0; i < n; i++) {
                prepare(i, circles, velocities);
            }
            changed();
            guard.changing = true;
            for (int i = 0; i < n; i++) {
                long handle = admit();
                if (to != null) {
                    to[i] = handle;
                }
            }
            guard.changing = false;
        } catch (RuntimeException | Error e) {
            throw guard.failed(e);
        } finally {
            guard.user = null;
        }
    }

    private static void checkLengths(int n, float[] circles, float[] velocities, long[] to) {
        if (circles.length % CircleRow.STRIDE != 0) {
            throw new IllegalArgumentException(
                    "circles has " + circles.length + " elements, but must have four a circle");
        }
        if (velocities != null && velocities.length != 2 * n) {
            throw new IllegalArgumentException(
                    "velocities has " + velocities.length + " elements, but must have two for each of " + n);
        }
        if (to != null && to.length < n) {
            throw new IllegalArgumentException(
                    "handles has " + to.length + " elements, but there are " + n + " circles");
        }
    }

    /** Checks circle i of many and prepares it. Each element is read once: another thread may write to the arrays. */
    private void prepare(int i, float[] circles, float[] velocities) {
        float x = circles[CircleRow.STRIDE * i + CircleRow.X];
        float y = circles[CircleRow.STRIDE * i + CircleRow.Y];
        float radius = circles[CircleRow.STRIDE * i + CircleRow.RADIUS];
        float mass = circles[CircleRow.STRIDE * i + CircleRow.MASS];
        float vx = velocities == null ? 0 : velocities[2 * i];
        float vy = velocities == null ? 0 : velocities[2 * i + 1];
        try {
            check(x, y, radius, mass, vx, vy);
        } catch (IllegalArgumentException e) {
            throw new IllegalArgumentException("circle " + i + ": " + e.getMessage(), e);
        }
        commands.prepare(i, x, y, radius, mass, defaultRestitution, vx, vy);
    }

    private void checkRoom(int more) {
        if (more > Limits.CIRCLES - handles.size()) {
            throw new IllegalArgumentException(
                    "a world has at most " + Limits.CIRCLES + " circles, not " + ((long) handles.size() + more));
        }
    }

    private void check(float x, float y, float radius, float mass, float vx, float vy) {
        Limits.position(x, y, bounds);
        Limits.radius(radius, bounds);
        Limits.mass(mass);
        Limits.velocity(vx, vy);
    }

    /** Gives the first circle that is prepared its id, and returns its handle. */
    private long admit() {
        int id = handles.add(commands.preparedRadius());
        handles.setRestitution(id, defaultRestitution);
        commands.admit(id);
        return handles.handle(id);
    }

    /** Removes a circle. */
    public void remove(long handle) {
        guard.enter();
        try {
            int id = find(handle);
            expect(1);
            changed();
            guard.changing = true;
            handles.remove(id);
            commands.remove(id);
            guard.changing = false;
        } catch (RuntimeException | Error e) {
            throw guard.failed(e);
        } finally {
            guard.user = null;
        }
    }

    /** Whether a handle is that of a circle. */
    public boolean contains(long handle) {
        guard.enter();
        try {
            return handles.find(handle) >= 0;
        } finally {
            guard.user = null;
        }
    }

    /** The number of circles. */
    public int size() {
        guard.enter();
        try {
            return handles.size();
        } finally {
            guard.user = null;
        }
    }

    /**
     * Changes a circle.
     *
     * @param operation an operation of {@link Commands} that changes a circle
     * @param handle the circle
     * @param a first value of the operation
     * @param b second value; of no meaning if the operation has one
     */
    public void set(int operation, long handle, float a, float b) {
        guard.enter();
        try {
            int id = find(handle);
            checkValues(operation, a, b);
            expect(1);
            if (operation == Commands.VELOCITY || operation == Commands.IMPULSE) {
                last.forgetVelocities();
            } else if (operation != Commands.RESTITUTION) {
                last.forgetCircles();
            }
            savedCurrent = false;
            guard.changing = true;
            commands.set(operation, id, a, b);
            if (operation == Commands.RADIUS) {
                handles.setRadius(id, a);
            } else if (operation == Commands.RESTITUTION) {
                handles.setRestitution(id, a);
            }
            guard.changing = false;
        } catch (RuntimeException | Error e) {
            throw guard.failed(e);
        } finally {
            guard.user = null;
        }
    }

    private void checkValues(int operation, float a, float b) {
        switch (operation) {
            case Commands.POSITION -> Limits.position(a, b, bounds);
            case Commands.VELOCITY -> Limits.velocity(a, b);
            case Commands.RADIUS -> Limits.radius(a, bounds);
            case Commands.MASS -> Limits.mass(a);
            case Commands.RESTITUTION -> Limits.restitution(a);
            case Commands.IMPULSE -> Limits.impulse(a, b);
            default -> throw new IllegalArgumentException("operation " + operation + " changes no circle");
        }
    }

    private int find(long handle) {
        int id = handles.find(handle);
        if (id < 0) {
            throw new IllegalArgumentException(
                    "no circle has the handle " + handle + ": it was removed, or is none of this world's");
        }
        return id;
    }

    // ---- the world
    // ---------------------------------------------------------------------------------------------------

    /** Changes gravity. */
    public void setGravity(float x, float y) {
        guard.enter();
        try {
            Limits.gravity(x, y);
            savedCurrent = false;
            gravityX = x;
            gravityY = y;
        } finally {
            guard.user = null;
        }
    }

    /** Gravity along x. */
    public float gravityX() {
        guard.enter();
        try {
            return gravityX;
        } finally {
            guard.user = null;
        }
    }

    /** Gravity along y. */
    public float gravityY() {
        guard.enter();
        try {
            return gravityY;
        } finally {
            guard.user = null;
        }
    }

    /** Moves the walls, and brings circles that are left outside to the nearest place inside. */
    public void setBounds(float minX, float minY, float maxX, float maxY) {
        guard.enter();
        try {
            Bounds next = Limits.bounds(minX, minY, maxX, maxY);
            if (handles.size() > 0) {
                Limits.within(
                        "the greatest radius", handles.greatestRadius(), next.leastRadius(), next.greatestRadius());
                Limits.within("the least radius", handles.leastRadius(), next.leastRadius(), next.greatestRadius());
            }
            applyCommands();
            changed();
            guard.changing = true;
            pipeline.confine(next);
            bounds = next;
            guard.changing = false;
        } catch (RuntimeException | Error e) {
            throw guard.failed(e);
        } finally {
            guard.user = null;
        }
    }

    /** Where the walls are. */
    public Bounds bounds() {
        guard.enter();
        try {
            return bounds;
        } finally {
            guard.user = null;
        }
    }

    /** The restitution that new circles get. */
    public float defaultRestitution() {
        guard.enter();
        try {
            return defaultRestitution;
        } finally {
            guard.user = null;
        }
    }

    /** The number of sub-steps of a step. */
    public int subSteps() {
        guard.enter();
        try {
            return subSteps;
        } finally {
            guard.user = null;
        }
    }

    /** Makes steps. */
    public void step(float timeStep, int steps) {
        guard.enter();
        try {
            Limits.within("the time step", timeStep, Limits.LEAST_STEP, Limits.GREATEST_STEP);
            Limits.within("the number of steps", steps, 1, Integer.MAX_VALUE);
            applyCommands();
            guard.changing = true;
            emptyStep = handles.size() == 0;
            if (!emptyStep) {
                changed();
                float before = previousTimeStep == 0 ? timeStep : previousTimeStep;
                constants.set(timeStep, subSteps, gravityX, gravityY, bounds, before);
                levels.layOut(bounds, handles.greatestRadius(), handles.population());
                pipeline.step(constants, levels, steps);
            }
            savedCurrent = false;
            previousTimeStep = timeStep;
            guard.changing = false;
        } catch (RuntimeException | Error e) {
            throw guard.failed(e);
        } finally {
            guard.user = null;
        }
    }

    /** Waits until all steps that were asked for have been made. */
    public void finish() {
        guard.enter();
        try {
            finishSteps();
        } catch (RuntimeException | Error e) {
            throw guard.failed(e);
        } finally {
            guard.user = null;
        }
    }

    // ---- reading
    // -----------------------------------------------------------------------------------------------------

    /** Reads x, y, radius and mass of every circle, in the order of the ids. */
    public void read(float[] circles) {
        guard.enter();
        try {
            requireRoom("circles", circles.length, (long) CircleRow.STRIDE * handles.size());
            settle();
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

    /** Reads x and y of every circle, in the order of the ids, into memory of the pipeline. */
    public FloatBuffer positions() {
        guard.enter();
        try {
            settle();
            return pipeline.positions(handles);
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
            applyCommands();
            pipeline.requestPositions(handles);
            positionsRequested = true;
        } catch (RuntimeException | Error e) {
            throw guard.failed(e);
        } finally {
            guard.user = null;
        }
    }

    /** Gives the positions that were requested last. */
    public FloatBuffer takePositions() {
        guard.enter();
        try {
            if (!positionsRequested) {
                throw new IllegalStateException("no positions have been requested since the last were taken:"
                        + " call requestPositions before each takePositions");
            }
            positionsRequested = false;
            if (!pipeline.positionsArrived()) {
                finishSteps();
            }
            return pipeline.takePositions();
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
            requireRoom("velocities", velocities.length, 2L * handles.size());
            settle();
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
            requireRoom("handles", to.length, handles.size());
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
            int place = handles.place(find(handle));
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
            int place = handles.place(find(handle));
            return last.velocities()[2 * place + component];
        } catch (RuntimeException | Error e) {
            throw guard.failed(e);
        } finally {
            guard.user = null;
        }
    }

    /** The restitution of one circle. */
    public float restitution(long handle) {
        guard.enter();
        try {
            return handles.restitution(find(handle));
        } finally {
            guard.user = null;
        }
    }

    private static void requireRoom(String what, Buffer buffer, long needs) {
        if (buffer.isReadOnly()) {
            throw new IllegalArgumentException(what + " is a read-only buffer");
        }
        requireRoom(what, buffer.remaining(), needs);
    }

    private static void requireRoom(String what, long has, long needs) {
        if (has < needs) {
            throw new IllegalArgumentException(what + " has room for " + has + " elements, but needs " + needs);
        }
    }

    /** The hash of the state. */
    public long hash() {
        guard.enter();
        try {
            settle();
            return pipeline.hash();
        } catch (RuntimeException | Error e) {
            throw guard.failed(e);
        } finally {
            guard.user = null;
        }
    }

    /** The figures as of now. */
    public Figures figures() {
        guard.enter();
        try {
            finishSteps();
            return new Figures(
                    handles.size(),
                    emptyStep ? 0 : pipeline.candidatePairs(),
                    emptyStep ? 0 : pipeline.contacts(),
                    emptyStep ? 0 : pipeline.greatestContacts(),
                    pipeline.bytesHeld(),
                    Collections.unmodifiableMap(pipeline.stageMillis()),
                    pipeline.device());
        } catch (RuntimeException | Error e) {
            throw guard.failed(e);
        } finally {
            guard.user = null;
        }
    }

    // ---- snapshots
    // ---------------------------------------------------------------------------------------------------

    /** The number of bytes that {@link #snapshot} would write now. */
    public int snapshotBytes() {
        guard.enter();
        try {
            save();
            return SnapshotCodec.bytes(saved);
        } catch (RuntimeException | Error e) {
            throw guard.failed(e);
        } finally {
            guard.user = null;
        }
    }

    /** Writes all that decides what comes after it. */
    public void snapshot(ByteBuffer to) {
        guard.enter();
        try {
            if (to.isReadOnly()) {
                throw new IllegalArgumentException("the buffer is read-only");
            }
            save();
            int bytes = SnapshotCodec.bytes(saved);
            if (to.remaining() < bytes) {
                throw new IllegalArgumentException(
                        "the buffer has room for " + to.remaining() + " bytes, but the snapshot has " + bytes);
            }
            SnapshotCodec.write(saved, to);
        } catch (RuntimeException | Error e) {
            throw guard.failed(e);
        } finally {
            guard.user = null;
        }
    }

    /** Takes over what a snapshot says, in place of all that is. */
    public void restore(ByteBuffer from) {
        guard.enter();
        try {
            savedCurrent = false;
            int length = SnapshotCodec.read(from, saved);
            finishSteps();
            handles.makeRoom(saved);
            pipeline.makeRoom(saved);
            changed();
            from.position(from.position() + length);
            guard.changing = true;
            handles.load(saved);
            commands.clear();
            pipeline.load(saved);
            setParameters(saved.parameters());
            emptyStep = true;
            guard.changing = false;
        } catch (RuntimeException | Error e) {
            throw guard.failed(e);
        } finally {
            guard.user = null;
        }
    }

    private void save() {
        if (!savedCurrent) {
            settle();
            handles.save(saved);
            pipeline.save(saved);
            saved.setParameters(
                    new WorldParameters(bounds, gravityX, gravityY, defaultRestitution, subSteps, previousTimeStep));
            savedCurrent = true;
        }
    }

    private void setParameters(WorldParameters p) {
        bounds = p.bounds();
        gravityX = p.gravityX();
        gravityY = p.gravityY();
        defaultRestitution = p.restitution();
        subSteps = p.subSteps();
        previousTimeStep = p.previousTimeStep();
    }

    // ---- housekeeping
    // ------------------------------------------------------------------------------------------------

    private void changed() {
        last.forgetCircles();
        last.forgetVelocities();
        savedCurrent = false;
    }

    /** Makes room for changes to come, so that none fails half-way. */
    private void expect(int more) {
        if (commands.count() >= Commands.MANY) {
            applyCommands();
        }
        commands.ensure(more);
    }

    private void applyCommands() {
        if (commands.count() > 0) {
            finishSteps();
            pipeline.makeRoom(commands);
            guard.changing = true;
            pipeline.apply(commands);
            commands.clear();
            guard.changing = false;
        }
    }

    private void finishSteps() {
        guard.changing = true;
        pipeline.finish();
        guard.changing = false;
    }

    /** Makes the state what calls have led to, so that reading it changes nothing. */
    private void settle() {
        applyCommands();
        finishSteps();
    }

    /** Ends the simulation and closes its pipeline. */
    @Override
    public void close() {
        guard.takeTurn();
        try {
            guard.closed = true;
            pipeline.close();
        } finally {
            guard.user = null;
        }
    }
}
