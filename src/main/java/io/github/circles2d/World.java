package io.github.circles2d;

import io.github.circles2d.opencl.Device;
import io.github.circles2d.opencl.DeviceMemoryException;
import io.github.circles2d.opencl.OpenClException;
import io.github.circles2d.opencl.OpenClUnavailableException;
import io.github.circles2d.world.LastReading;
import io.github.circles2d.world.Pipeline;
import io.github.circles2d.world.circles.Commands;
import io.github.circles2d.world.circles.HandleTable;
import io.github.circles2d.world.circles.SavedState;
import io.github.circles2d.world.circles.SnapshotCodec;
import io.github.circles2d.world.circles.WorldParameters;
import io.github.circles2d.world.jvm.JvmPipeline;
import io.github.circles2d.world.model.Bounds;
import io.github.circles2d.world.model.GridLevels;
import io.github.circles2d.world.model.Limits;
import io.github.circles2d.world.model.StepConstants;
import java.nio.Buffer;
import java.nio.ByteBuffer;
import java.nio.FloatBuffer;
import java.nio.LongBuffer;
import java.util.Collections;
import java.util.ConcurrentModificationException;
import java.util.Objects;
import java.util.concurrent.atomic.AtomicReferenceFieldUpdater;

/**
 * The engine for games: rigid circles that fall, collide, bounce and pile up between four walls, come and go, and replay to
 * the bit.
 *
 * <pre>{@code
 * try (World world = World.builder().bounds(0, 0, 80, 100).gravity(0, -10).restitution(0.5f).build()) {
 *     long ball = world.add(40, 50, 1, 2);
 *     world.setVelocity(ball, 1, 0);
 *     world.step(1 / 60f);
 *     float[] circles = new float[4 * world.size()];
 *     world.read(circles); // x, y, radius, mass of each
 * }
 * }</pre>
 *
 * <p><b>Units</b> are the caller's: any length, any mass, seconds. <b>Handles</b> are longs, never 0, and stay valid until
 * their circle is removed; after that they are stale, and every method but {@link #contains} refuses them with an
 * IllegalArgumentException, even if the circle's place has been taken by another. (Handles given after a snapshot was taken may
 * name other circles once it is restored, and those of two worlds may be equal.) <b>Order:</b> the bulk reads give the
 * circles in the order of their ids, the lower 32 bits of the handle. A new circle takes the lowest free id, so while
 * nothing is removed this is the order of adding; removing a circle closes its gap.
 *
 * <p><b>Changes</b> (add, remove, set, impulse) are gathered and take effect in call order, at the latest before the next
 * step or read. <b>Fixed circles</b> have a mass of {@link Float#POSITIVE_INFINITY}: nothing pushes them, they may overlap
 * walls and each other, and they move only by the velocity set for them (none at first). <b>Restitution:</b> a pair has the
 * greater of its two circles' values; a wall takes the circle's.
 *
 * <p><b>The same bits everywhere:</b> the state after any sequence of calls is the same on every back end, device and number
 * of threads; {@link #hash()} is a number to compare.
 *
 * <p><b>Fast circles</b>, which move farther than their radius in a step, look ahead and stop at what they would pass through.
 * Of 12,600 circles of restitution 1 that flew for 300 steps at a fence of fixed circles, or between two, none slipped through
 * at 5 radii a step, 2 did at 10, up to 1.2 % of a scene at 20, and 0.3 to 7 % at 40 to 100, most of them between fences 100
 * radii apart: at most 1.3 in a thousand turns. With restitution 0.8, at most 1 % did at any speed. Circles do not stop at what
 * is so much smaller that it is pushed aside (a sixteenth of the radius; a pebble of a tenth may be run over at somewhat less
 * than a radius a step), nor at fixed circles that move. In one step a circle moves at most 64 of its radii, whatever its
 * velocity: do not make circles tiny that are to fly far.
 *
 * <p><b>Time steps</b> had better all have one length: take real time into an accumulator and make whole steps. Piles settle for
 * one length, and a step of another stirs them up a little.
 *
 * <p><b>One thread at a time:</b> a call while another thread is inside throws a ConcurrentModificationException. Another
 * thread may write to an array or a buffer that a call reads from: each value is copied before it is checked. After
 * {@link #close()} every method but close throws an IllegalStateException.
 *
 * <p><b>Failures:</b> a call that throws an IllegalArgumentException has changed nothing. Nor has a call other than a step that
 * finds too little memory for itself (OutOfMemoryError, {@link io.github.circles2d.opencl.DeviceMemoryException}); it may be
 * made again. The state may be lost if a step fails in any other way, and is lost if any other error ends a change
 * half-way, and if an OpenCL device fails (any other {@link io.github.circles2d.opencl.OpenClException}). If it is lost, every later
 * call but close throws an IllegalStateException that names the failure. A device may tell of a step's failure in a later call.
 *
 * <p><b>Ranges:</b> coordinates up to 1e9 in magnitude; radii from 2^-20 of the greatest coordinate (or extent) up to half
 * the lesser extent of the bounds; masses from 1e-9 to 1e9; components of velocities and gravity up to 1e9; steps from 1e-6
 * to 1 second. Within them no sequence of calls leads to a state that is not finite.
 */
public final class World implements AutoCloseable {
    private static final AtomicReferenceFieldUpdater<World, Thread> USER =
            AtomicReferenceFieldUpdater.newUpdater(World.class, Thread.class, "user");

    private final Pipeline pipeline;
    private final HandleTable roster = new HandleTable();
    private final Commands commands = new Commands();
    private final GridLevels levels = new GridLevels();
    private final StepConstants constants = new StepConstants();
    private final LastReading last;
    private final SavedState saved = new SavedState();
    private final Backend backend;
    private final String reason;

    private int subSteps;
    private float defaultRestitution;
    private Bounds bounds;
    private float gravityX;
    private float gravityY;
    private float previousTimeStep;

    /** Whether the last step had no circles; also where there has been none, or one before a restore. */
    private boolean emptyStep = true;

    private boolean savedCurrent;
    private boolean positionsRequested;
    private boolean closed;

    /**
     * The thread that is inside. Whoever leaves sets it to null by an assignment and no call, for which the stack may have no
     * room.
     */
    private volatile Thread user;

    /** Whether the state is being changed. If it stays true, a change has ended half-way, and the state is lost. */
    private boolean changing;

    /** Why the state is lost; null if it is not. */
    private Throwable failure;

    World(Builder b, BackendChoice choice) {
        bounds = b.bounds;
        gravityX = b.gravityX;
        gravityY = b.gravityY;
        subSteps = b.subSteps;
        defaultRestitution = b.restitution;
        backend = choice.backend();
        reason = choice.reason();
        pipeline = choice.pipeline();
        last = new LastReading(pipeline, roster, this::settle);
    }

    /**
     * Starts a description of a world.
     *
     * @return a builder with every parameter at its default
     */
    public static Builder builder() {
        return new Builder();
    }

    // ---- circles
    // -----------------------------------------------------------------------------------------------------

    /**
     * Adds a circle at rest, with the world's restitution.
     *
     * @param x x of the centre, within the bounds; a circle that crosses a wall is moved inside by the next step
     * @param y y of the centre, within the bounds
     * @param radius radius
     * @param mass mass; positive infinity for a fixed circle
     * @return its handle
     * @throws IllegalArgumentException where a value is out of range
     */
    public long add(float x, float y, float radius, float mass) {
        return add(x, y, radius, mass, 0, 0);
    }

    /**
     * Adds a circle, with the world's restitution.
     *
     * @param x x of the centre, within the bounds; a circle that crosses a wall is moved inside by the next step
     * @param y y of the centre, within the bounds
     * @param radius radius
     * @param mass mass; positive infinity for a fixed circle
     * @param vx velocity
     * @param vy velocity
     * @return its handle
     * @throws IllegalArgumentException where a value is out of range
     */
    public long add(float x, float y, float radius, float mass, float vx, float vy) {
        enter();
        try {
            checkRoom(1);
            check(x, y, radius, mass);
            Limits.velocity(vx, vy);
            expect(1);
            roster.ensure(1);
            commands.prepare(0, x, y, radius, mass, defaultRestitution, vx, vy);
            changed();
            changing = true;
            long handle = admit();
            changing = false;
            return handle;
        } catch (RuntimeException | Error e) {
            throw failed(e);
        } finally {
            user = null;
        }
    }

    /**
     * Adds many circles at rest, with the world's restitution: all of them, or none where one is refused.
     *
     * @param circles x, y, radius and mass of one after the other
     * @param handles takes the handle of each; at least as many elements as there are circles; may be null
     * @throws IllegalArgumentException where a value is out of range (the message has the number of the circle), or an array
     *     has the wrong length
     */
    public void addAll(float[] circles, long[] handles) {
        addAll(circles, null, handles);
    }

    /**
     * Adds many circles, with the world's restitution: all of them, or none where one is refused.
     *
     * @param circles x, y, radius and mass of one after the other
     * @param velocities vx and vy of one after the other; may be null, for circles at rest
     * @param handles takes the handle of each; at least as many elements as there are circles; may be null
     * @throws IllegalArgumentException where a value is out of range (the message has the number of the circle), or an array
     *     has the wrong length
     */
    public void addAll(float[] circles, float[] velocities, long[] handles) {
        enter();
        try {
            Objects.requireNonNull(circles, "circles");
            int n = circles.length / 4;
            if (circles.length % 4 != 0) {
                throw new IllegalArgumentException(
                        "circles has " + circles.length + " elements, but must have four a circle");
            }
            if (velocities != null && velocities.length != 2 * n) {
                throw new IllegalArgumentException(
                        "velocities has " + velocities.length + " elements, but must have two for each of " + n);
            }
            if (handles != null && handles.length < n) {
                throw new IllegalArgumentException(
                        "handles has " + handles.length + " elements, but there are " + n + " circles");
            }
            checkRoom(n);
            expect(n);
            roster.ensure(n);
            for (int i = 0; i < n; i++) {
                // Each element is read once: another thread may write to the arrays.
                float x = circles[4 * i];
                float y = circles[4 * i + 1];
                float radius = circles[4 * i + 2];
                float mass = circles[4 * i + 3];
                float vx = velocities == null ? 0 : velocities[2 * i];
                float vy = velocities == null ? 0 : velocities[2 * i + 1];
                try {
                    check(x, y, radius, mass);
                    Limits.velocity(vx, vy);
                } catch (IllegalArgumentException e) {
                    throw new IllegalArgumentException("circle " + i + ": " + e.getMessage(), e);
                }
                commands.prepare(i, x, y, radius, mass, defaultRestitution, vx, vy);
            }
            changed();
            changing = true;
            for (int i = 0; i < n; i++) {
                long handle = admit();
                if (handles != null) {
                    handles[i] = handle;
                }
            }
            changing = false;
        } catch (RuntimeException | Error e) {
            throw failed(e);
        } finally {
            user = null;
        }
    }

    private void checkRoom(int more) {
        if (more > Limits.CIRCLES - roster.size()) {
            throw new IllegalArgumentException(
                    "a world has at most " + Limits.CIRCLES + " circles, not " + ((long) roster.size() + more));
        }
    }

    private void check(float x, float y, float radius, float mass) {
        Limits.position(x, y, bounds);
        Limits.radius(radius, bounds);
        Limits.mass(mass);
    }

    /** Gives the first circle that is prepared its id, and returns its handle. */
    private long admit() {
        int id = roster.add(commands.preparedRadius());
        roster.setRestitution(id, defaultRestitution);
        commands.admit(id);
        return roster.handle(id);
    }

    /**
     * Removes a circle. Its handle is stale from now on.
     *
     * @param handle the circle
     * @throws IllegalArgumentException where the handle is stale
     */
    public void remove(long handle) {
        enter();
        try {
            int id = find(handle);
            expect(1);
            changed();
            changing = true;
            roster.remove(id);
            commands.remove(id);
            changing = false;
        } catch (RuntimeException | Error e) {
            throw failed(e);
        } finally {
            user = null;
        }
    }

    /**
     * Whether a handle is that of a circle of this world.
     *
     * @param handle any number
     * @return false where it is stale or never was a handle
     */
    public boolean contains(long handle) {
        enter();
        try {
            return roster.find(handle) >= 0;
        } finally {
            user = null;
        }
    }

    /**
     * The number of circles.
     *
     * @return at least 0
     */
    public int size() {
        enter();
        try {
            return roster.size();
        } finally {
            user = null;
        }
    }

    /**
     * Puts a circle somewhere else.
     *
     * @param handle the circle
     * @param x x of the centre, within the bounds
     * @param y y of the centre, within the bounds
     * @throws IllegalArgumentException where the handle is stale or a value is out of range
     */
    public void setPosition(long handle, float x, float y) {
        enter();
        try {
            int id = find(handle);
            Limits.position(x, y, bounds);
            set(Commands.POSITION, id, x, y);
        } catch (RuntimeException | Error e) {
            throw failed(e);
        } finally {
            user = null;
        }
    }

    /**
     * Gives a circle a velocity. A fixed circle moves on with it until told otherwise; at the
     * bounds it stops, and has no velocity from there on.
     *
     * @param handle the circle
     * @param vx velocity
     * @param vy velocity
     * @throws IllegalArgumentException where the handle is stale or a value is out of range
     */
    public void setVelocity(long handle, float vx, float vy) {
        enter();
        try {
            int id = find(handle);
            Limits.velocity(vx, vy);
            set(Commands.VELOCITY, id, vx, vy);
        } catch (RuntimeException | Error e) {
            throw failed(e);
        } finally {
            user = null;
        }
    }

    /**
     * Gives a circle another radius; its mass stays.
     *
     * @param handle the circle
     * @param radius radius
     * @throws IllegalArgumentException where the handle is stale or the value is out of range
     */
    public void setRadius(long handle, float radius) {
        enter();
        try {
            int id = find(handle);
            Limits.radius(radius, bounds);
            set(Commands.RADIUS, id, radius, 0);
        } catch (RuntimeException | Error e) {
            throw failed(e);
        } finally {
            user = null;
        }
    }

    /**
     * Gives a circle another mass.
     *
     * @param handle the circle
     * @param mass mass; positive infinity makes it a fixed circle, which keeps its velocity
     * @throws IllegalArgumentException where the handle is stale or the value is out of range
     */
    public void setMass(long handle, float mass) {
        enter();
        try {
            int id = find(handle);
            set(Commands.MASS, id, Limits.mass(mass), 0);
        } catch (RuntimeException | Error e) {
            throw failed(e);
        } finally {
            user = null;
        }
    }

    /**
     * Gives a circle a restitution of its own.
     *
     * @param handle the circle
     * @param restitution 0 (inelastic) to 1 (elastic)
     * @throws IllegalArgumentException where the handle is stale or the value is out of range
     */
    public void setRestitution(long handle, float restitution) {
        enter();
        try {
            int id = find(handle);
            set(Commands.RESTITUTION, id, Limits.restitution(restitution), 0);
        } catch (RuntimeException | Error e) {
            throw failed(e);
        } finally {
            user = null;
        }
    }

    /**
     * Pushes a circle: its velocity changes by the impulse over its mass. A fixed circle does not mind.
     *
     * @param handle the circle
     * @param x impulse, mass times velocity
     * @param y impulse
     * @throws IllegalArgumentException where the handle is stale or a component is over 1e18 in magnitude
     */
    public void applyImpulse(long handle, float x, float y) {
        enter();
        try {
            int id = find(handle);
            Limits.within("impulse x", x, -Limits.IMPULSE, Limits.IMPULSE);
            Limits.within("impulse y", y, -Limits.IMPULSE, Limits.IMPULSE);
            set(Commands.IMPULSE, id, x, y);
        } catch (RuntimeException | Error e) {
            throw failed(e);
        } finally {
            user = null;
        }
    }

    private void set(int operation, int id, float a, float b) {
        expect(1);
        if (operation == Commands.VELOCITY || operation == Commands.IMPULSE) {
            last.forgetVelocities();
        } else if (operation != Commands.RESTITUTION) {
            last.forgetCircles();
        }
        savedCurrent = false;
        changing = true;
        commands.set(operation, id, a, b);
        if (operation == Commands.RADIUS) {
            roster.setRadius(id, a);
        } else if (operation == Commands.RESTITUTION) {
            roster.setRestitution(id, a);
        }
        changing = false;
    }

    private int find(long handle) {
        int id = roster.find(handle);
        if (id < 0) {
            throw new IllegalArgumentException(
                    "no circle has the handle " + handle + ": it was removed, or is none of this world's");
        }
        return id;
    }

    // ---- the world
    // ---------------------------------------------------------------------------------------------------

    /**
     * Changes gravity.
     *
     * @param x acceleration
     * @param y acceleration, negative downwards
     * @throws IllegalArgumentException where a value is out of range
     */
    public void setGravity(float x, float y) {
        enter();
        try {
            Limits.within("gravity x", x, -Limits.SPEED, Limits.SPEED);
            Limits.within("gravity y", y, -Limits.SPEED, Limits.SPEED);
            savedCurrent = false;
            gravityX = x;
            gravityY = y;
        } finally {
            user = null;
        }
    }

    /**
     * Gravity along x.
     *
     * @return acceleration, in lengths per second squared
     */
    public float gravityX() {
        enter();
        try {
            return gravityX;
        } finally {
            user = null;
        }
    }

    /**
     * Gravity along y.
     *
     * @return acceleration, in lengths per second squared; negative downwards
     */
    public float gravityY() {
        enter();
        try {
            return gravityY;
        } finally {
            user = null;
        }
    }

    /**
     * Moves the walls. Circles that are left outside are brought to the nearest place inside.
     *
     * @param minX left wall
     * @param minY lower wall
     * @param maxX right wall
     * @param maxY upper wall
     * @throws IllegalArgumentException where a value is out of range, or a circle is too large or too small for these bounds
     */
    public void setBounds(float minX, float minY, float maxX, float maxY) {
        enter();
        try {
            Bounds next = Limits.bounds(minX, minY, maxX, maxY);
            if (roster.size() > 0) {
                Limits.within(
                        "the greatest radius", roster.greatestRadius(), next.leastRadius(), next.greatestRadius());
                Limits.within("the least radius", roster.leastRadius(), next.leastRadius(), next.greatestRadius());
            }
            applyCommands();
            changed();
            changing = true;
            pipeline.confine(next);
            bounds = next;
            changing = false;
        } catch (RuntimeException | Error e) {
            throw failed(e);
        } finally {
            user = null;
        }
    }

    /**
     * Where the left wall is.
     *
     * @return its x
     */
    public float minX() {
        enter();
        try {
            return bounds.minX();
        } finally {
            user = null;
        }
    }

    /**
     * Where the lower wall is.
     *
     * @return its y
     */
    public float minY() {
        enter();
        try {
            return bounds.minY();
        } finally {
            user = null;
        }
    }

    /**
     * Where the right wall is.
     *
     * @return its x
     */
    public float maxX() {
        enter();
        try {
            return bounds.maxX();
        } finally {
            user = null;
        }
    }

    /**
     * Where the upper wall is.
     *
     * @return its y
     */
    public float maxY() {
        enter();
        try {
            return bounds.maxY();
        } finally {
            user = null;
        }
    }

    /**
     * The restitution that new circles get.
     *
     * @return 0 (inelastic) to 1 (elastic)
     */
    public float defaultRestitution() {
        enter();
        try {
            return defaultRestitution;
        } finally {
            user = null;
        }
    }

    /**
     * The number of sub-steps a step.
     *
     * @return 1 to 16
     */
    public int subSteps() {
        enter();
        try {
            return subSteps;
        } finally {
            user = null;
        }
    }

    /**
     * Makes one step.
     *
     * @param timeStep its length in seconds, 1e-6 to 1; games use 1 / 60f
     * @throws IllegalArgumentException where the value is out of range
     */
    public void step(float timeStep) {
        step(timeStep, 1);
    }

    /**
     * Makes several steps in one trip.
     *
     * @param timeStep the length of each in seconds, 1e-6 to 1
     * @param steps number of steps, at least 1
     * @throws IllegalArgumentException where a value is out of range
     */
    public void step(float timeStep, int steps) {
        enter();
        try {
            Limits.within("the time step", timeStep, Limits.LEAST_STEP, Limits.GREATEST_STEP);
            Limits.within("the number of steps", steps, 1, Integer.MAX_VALUE);
            applyCommands();
            changing = true;
            emptyStep = roster.size() == 0;
            if (!emptyStep) {
                changed();
                float before = previousTimeStep == 0 ? timeStep : previousTimeStep;
                constants.set(timeStep, subSteps, gravityX, gravityY, bounds, before);
                levels.layOut(bounds, roster.greatestRadius(), roster.population());
                pipeline.step(constants, levels, steps);
            }
            savedCurrent = false;
            previousTimeStep = timeStep;
            changing = false;
        } catch (RuntimeException | Error e) {
            throw failed(e);
        } finally {
            user = null;
        }
    }

    /**
     * Waits until all steps that were asked for have been made. Nothing but time depends on it: a step on an OpenCL device is
     * only enqueued, and whatever needs its result waits for it anyway.
     */
    public void finish() {
        enter();
        try {
            finishSteps();
        } catch (RuntimeException | Error e) {
            throw failed(e);
        } finally {
            user = null;
        }
    }

    // ---- reading
    // -----------------------------------------------------------------------------------------------------

    /**
     * Reads x, y, radius and mass of every circle, in the order of the ids.
     *
     * @param circles takes four elements a circle
     * @throws IllegalArgumentException where the array is too short
     */
    public void read(float[] circles) {
        enter();
        try {
            requireRoom("circles", circles.length, 4L * roster.size());
            settle();
            pipeline.readCircles(roster, circles);
        } catch (RuntimeException | Error e) {
            throw failed(e);
        } finally {
            user = null;
        }
    }

    /**
     * Reads x, y, radius and mass of every circle, in the order of the ids.
     *
     * @param circles takes four elements a circle from its position on, which is moved behind them
     * @throws IllegalArgumentException where too little remains of the buffer, or it is read-only
     */
    public void read(FloatBuffer circles) {
        enter();
        try {
            requireRoom("circles", circles, 4L * roster.size());
            circles.put(last.circles(), 0, 4 * roster.size());
        } catch (RuntimeException | Error e) {
            throw failed(e);
        } finally {
            user = null;
        }
    }

    /**
     * Reads x and y of every circle, in the order of the ids, into memory of the world's own. That is the fastest way to what
     * a frame needs: on an OpenCL device the memory is page-locked where the driver can, and nothing is copied again.
     *
     * @return two elements a circle, from position 0 to the limit. Read-only, and often the same object: the next call of this
     *     method overwrites what it shows, no other does. It may be kept beyond {@link #close()}.
     */
    public FloatBuffer positions() {
        enter();
        try {
            settle();
            return pipeline.positions(roster);
        } catch (RuntimeException | Error e) {
            throw failed(e);
        } finally {
            user = null;
        }
    }

    /**
     * Asks for x and y of every circle as they are now, without waiting for them: on an OpenCL device they are copied while the
     * next step runs. A game that draws one frame while the next is computed makes its frame of
     *
     * <pre>{@code
     * world.requestPositions();
     * world.step(1 / 60f);
     * draw(world.takePositions()); // from before the step
     * }</pre>
     *
     * <p>Whatever is called in between, the positions are those of this moment, of the circles of this moment, in the order of
     * their ids. A request that has not been taken is replaced by the next.
     */
    public void requestPositions() {
        enter();
        try {
            positionsRequested = false;
            applyCommands();
            pipeline.requestPositions(roster);
            positionsRequested = true;
        } catch (RuntimeException | Error e) {
            throw failed(e);
        } finally {
            user = null;
        }
    }

    /**
     * Gives the positions that {@link #requestPositions} asked for last, and waits for them where they are still on their way.
     * Each request can be taken once.
     *
     * @return two elements a circle, from position 0 to the limit, in memory of the world's own. Read-only, and valid until the
     *     second {@link #requestPositions} from now: the next one leaves it as it is. No other method touches it, and it may be
     *     kept beyond {@link #close()}.
     * @throws IllegalStateException where nothing has been requested since the last were taken
     */
    public FloatBuffer takePositions() {
        enter();
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
            throw failed(e);
        } finally {
            user = null;
        }
    }

    /**
     * Reads the velocity of every circle, in the order of the ids.
     *
     * @param velocities takes vx and vy of each
     * @throws IllegalArgumentException where the array is too short
     */
    public void readVelocities(float[] velocities) {
        enter();
        try {
            requireRoom("velocities", velocities.length, 2L * roster.size());
            settle();
            pipeline.readVelocities(roster, velocities);
        } catch (RuntimeException | Error e) {
            throw failed(e);
        } finally {
            user = null;
        }
    }

    /**
     * Reads the velocity of every circle, in the order of the ids.
     *
     * @param velocities takes vx and vy of each from its position on, which is moved behind them
     * @throws IllegalArgumentException where too little remains of the buffer, or it is read-only
     */
    public void readVelocities(FloatBuffer velocities) {
        enter();
        try {
            requireRoom("velocities", velocities, 2L * roster.size());
            velocities.put(last.velocities(), 0, 2 * roster.size());
        } catch (RuntimeException | Error e) {
            throw failed(e);
        } finally {
            user = null;
        }
    }

    /**
     * Reads the handle of every circle, in the order of the ids.
     *
     * @param handles takes one element a circle
     * @throws IllegalArgumentException where the array is too short
     */
    public void readHandles(long[] handles) {
        enter();
        try {
            requireRoom("handles", handles.length, roster.size());
            int k = 0;
            for (int id = 0; id < roster.end(); id++) {
                if (roster.lives(id)) {
                    handles[k++] = roster.handle(id);
                }
            }
        } finally {
            user = null;
        }
    }

    /**
     * Reads the handle of every circle, in the order of the ids.
     *
     * @param handles takes one element a circle from its position on, which is moved behind them
     * @throws IllegalArgumentException where too little remains of the buffer, or it is read-only
     */
    public void readHandles(LongBuffer handles) {
        enter();
        try {
            requireRoom("handles", handles, roster.size());
            for (int id = 0; id < roster.end(); id++) {
                if (roster.lives(id)) {
                    handles.put(roster.handle(id));
                }
            }
        } finally {
            user = null;
        }
    }

    /**
     * Reads one coordinate of one circle. The first such read after a step or a change reads all circles
     * back; the others are answered from that.
     *
     * @param handle the circle
     * @return x of its centre
     * @throws IllegalArgumentException where the handle is stale
     */
    public float x(long handle) {
        return one(handle, 0);
    }

    /**
     * Reads one coordinate of one circle; see {@link #x}.
     *
     * @param handle the circle
     * @return y of its centre
     * @throws IllegalArgumentException where the handle is stale
     */
    public float y(long handle) {
        return one(handle, 1);
    }

    /**
     * Reads the radius of one circle; see {@link #x}.
     *
     * @param handle the circle
     * @return its radius
     * @throws IllegalArgumentException where the handle is stale
     */
    public float radius(long handle) {
        return one(handle, 2);
    }

    /**
     * Reads the mass of one circle; see {@link #x}.
     *
     * @param handle the circle
     * @return its mass; positive infinity for a fixed circle
     * @throws IllegalArgumentException where the handle is stale
     */
    public float mass(long handle) {
        return one(handle, 3);
    }

    /**
     * Reads one component of the velocity of one circle; see {@link #x}.
     *
     * @param handle the circle
     * @return its velocity along x
     * @throws IllegalArgumentException where the handle is stale
     */
    public float vx(long handle) {
        return oneOfVelocity(handle, 0);
    }

    /**
     * Reads one component of the velocity of one circle; see {@link #x}.
     *
     * @param handle the circle
     * @return its velocity along y
     * @throws IllegalArgumentException where the handle is stale
     */
    public float vy(long handle) {
        return oneOfVelocity(handle, 1);
    }

    /**
     * The restitution of one circle. It is known without a read-back.
     *
     * @param handle the circle
     * @return 0 (inelastic) to 1 (elastic)
     * @throws IllegalArgumentException where the handle is stale
     */
    public float restitution(long handle) {
        enter();
        try {
            return roster.restitution(find(handle));
        } finally {
            user = null;
        }
    }

    private float one(long handle, int element) {
        enter();
        try {
            int place = roster.place(find(handle));
            return last.circles()[4 * place + element];
        } catch (RuntimeException | Error e) {
            throw failed(e);
        } finally {
            user = null;
        }
    }

    private float oneOfVelocity(long handle, int element) {
        enter();
        try {
            int place = roster.place(find(handle));
            return last.velocities()[2 * place + element];
        } catch (RuntimeException | Error e) {
            throw failed(e);
        } finally {
            user = null;
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

    /**
     * A hash of the state: of every circle, and of the impulses that the next step starts from. Equal states have equal
     * hashes, whatever they were computed on. Not in it is what the caller has set for the world as a whole (bounds, gravity,
     * sub-steps, restitution of circles to come) and which handles are stale; two snapshots compare these, too.
     *
     * @return 64 bits
     */
    public long hash() {
        enter();
        try {
            settle();
            return pipeline.hash();
        } catch (RuntimeException | Error e) {
            throw failed(e);
        } finally {
            user = null;
        }
    }

    /**
     * What the world is made of and what the last step did. Waits for the device, and takes about as long as a read: a call a
     * second is fine, one a frame is not.
     *
     * @return the figures as of now
     */
    public WorldStats stats() {
        enter();
        try {
            finishSteps();
            return new WorldStats(
                    roster.size(),
                    emptyStep ? 0 : pipeline.candidatePairs(),
                    emptyStep ? 0 : pipeline.contacts(),
                    emptyStep ? 0 : pipeline.greatestContacts(),
                    pipeline.bytesHeld(),
                    Collections.unmodifiableMap(pipeline.stageMillis()),
                    backend,
                    pipeline.device(),
                    reason);
        } catch (RuntimeException | Error e) {
            throw failed(e);
        } finally {
            user = null;
        }
    }

    // ---- snapshots
    // ---------------------------------------------------------------------------------------------------

    /**
     * The number of bytes that {@link #snapshot} would write now.
     *
     * @return about 50 a circle, where few of them were removed
     * @throws IllegalStateException where it is more than one buffer holds
     */
    public int snapshotBytes() {
        enter();
        try {
            save();
            return SnapshotCodec.bytes(saved);
        } catch (RuntimeException | Error e) {
            throw failed(e);
        } finally {
            user = null;
        }
    }

    /**
     * Writes all that decides this world's future: circles, handles, the impulses that the next step starts from, bounds,
     * gravity, restitution and sub-steps. Equal states give equal bytes, on every back end.
     *
     * @param to takes {@link #snapshotBytes} bytes from its position on, which is moved behind them; its byte order is of no
     *     meaning
     * @throws IllegalArgumentException where too little remains of the buffer, or it is read-only
     * @throws IllegalStateException where the snapshot is more than one buffer holds
     */
    public void snapshot(ByteBuffer to) {
        enter();
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
            throw failed(e);
        } finally {
            user = null;
        }
    }

    /**
     * Makes this world what a snapshot says, in place of what it is: the same calls from here on lead to the same bits as in
     * the world that it was taken from, on any back end. Handles of that world are valid in this one.
     *
     * @param from a snapshot from its position on, which is moved behind it; its byte order is of no meaning
     * @throws IllegalArgumentException where the bytes are no snapshot, or are damaged or cut off; world and buffer are then as
     *     before
     */
    public void restore(ByteBuffer from) {
        enter();
        try {
            savedCurrent = false;
            int length = SnapshotCodec.read(from, saved);
            finishSteps();
            roster.makeRoom(saved);
            pipeline.makeRoom(saved);
            changed();
            from.position(from.position() + length);
            changing = true;
            roster.load(saved);
            commands.clear();
            pipeline.load(saved);
            WorldParameters p = saved.parameters();
            bounds = p.bounds();
            gravityX = p.gravityX();
            gravityY = p.gravityY();
            defaultRestitution = p.restitution();
            subSteps = p.subSteps();
            previousTimeStep = p.previousTimeStep();
            emptyStep = true;
            changing = false;
        } catch (RuntimeException | Error e) {
            throw failed(e);
        } finally {
            user = null;
        }
    }

    private void save() {
        if (!savedCurrent) {
            settle();
            roster.save(saved);
            pipeline.save(saved);
            saved.setParameters(
                    new WorldParameters(bounds, gravityX, gravityY, defaultRestitution, subSteps, previousTimeStep));
            savedCurrent = true;
        }
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
            changing = true;
            pipeline.apply(commands);
            commands.clear();
            changing = false;
        }
    }

    private void finishSteps() {
        changing = true;
        pipeline.finish();
        changing = false;
    }

    /** Makes the state what calls have led to, so that reading it changes nothing. */
    private void settle() {
        applyCommands();
        finishSteps();
    }

    private void enter() {
        takeTurn();
        if (closed || changing || failure != null) {
            user = null;
            throw new IllegalStateException(
                    closed ? "this World has been closed" : "this World failed earlier and lost its state", failure);
        }
    }

    private void takeTurn() {
        if (!USER.compareAndSet(this, null, Thread.currentThread())) {
            throw new ConcurrentModificationException("a World is used by one thread at a time, but "
                    + Thread.currentThread().getName() + " came in while another was inside");
        }
    }

    /**
     * Takes note of what a call throws. The state is lost if the call was changing it, or if a device has failed: also a read
     * is told of commands that were enqueued before. It is not lost if a read found too little memory.
     */
    private RuntimeException failed(Throwable cause) {
        if (changing || cause instanceof OpenClException && !(cause instanceof DeviceMemoryException)) {
            failure = cause;
        }
        if (cause instanceof Error error) {
            throw error;
        }
        return (RuntimeException) cause;
    }

    /**
     * Ends the world and gives its memory, threads and devices back. Closing it again does nothing, unless an error has cut the
     * first call short. The threads of a world that is never closed do not keep the virtual machine running, and end some time
     * after the world has been forgotten.
     */
    @Override
    public void close() {
        takeTurn();
        try {
            closed = true;
            pipeline.close();
        } finally {
            user = null;
        }
    }

    /** Describes a world. Every parameter has a default; each is checked when it is given. */
    public static final class Builder {
        private Bounds bounds = new Bounds(0, 0, 1, 1);
        private float gravityX;
        private float gravityY;
        private float restitution = 0.5f;
        private int subSteps = 4;
        private Backend backend = Backend.AUTO;
        private Device device;
        private int threads = defaultThreads();
        private int capacity = 1024;
        private boolean profiling;
        private int leastShare = JvmPipeline.LEAST_SHARE;

        private Builder() {}

        static int defaultThreads() {
            return Math.min(Runtime.getRuntime().availableProcessors(), 16);
        }

        /** Circles that a thread of the JVM back end has at least. For tests of few circles on many threads. */
        Builder leastShare(int circles) {
            leastShare = circles;
            return this;
        }

        /**
         * The walls. By default the unit square.
         *
         * @param minX left wall
         * @param minY lower wall
         * @param maxX right wall
         * @param maxY upper wall
         * @return this
         * @throws IllegalArgumentException where a value is out of range
         */
        public Builder bounds(float minX, float minY, float maxX, float maxY) {
            bounds = Limits.bounds(minX, minY, maxX, maxY);
            return this;
        }

        /**
         * Gravity. By default none.
         *
         * @param x acceleration
         * @param y acceleration, negative downwards
         * @return this
         * @throws IllegalArgumentException where a value is out of range
         */
        public Builder gravity(float x, float y) {
            gravityX = Limits.within("gravity x", x, -Limits.SPEED, Limits.SPEED);
            gravityY = Limits.within("gravity y", y, -Limits.SPEED, Limits.SPEED);
            return this;
        }

        /**
         * The restitution that new circles get. By default 0.5.
         *
         * @param restitution 0 (inelastic) to 1 (elastic)
         * @return this
         * @throws IllegalArgumentException where the value is out of range
         */
        public Builder restitution(float restitution) {
            this.restitution = Limits.restitution(restitution);
            return this;
        }

        /**
         * Sub-steps a step: more are stiffer and slower. By default 4.
         *
         * @param subSteps 1 to 16
         * @return this
         * @throws IllegalArgumentException where the value is out of range
         */
        public Builder subSteps(int subSteps) {
            this.subSteps = Limits.within("the number of sub-steps", subSteps, 1, Limits.SUB_STEPS);
            return this;
        }

        /**
         * What to run on. By default {@link Backend#AUTO}.
         *
         * @param backend the back end
         * @return this
         */
        public Builder backend(Backend backend) {
            this.backend = Objects.requireNonNull(backend, "backend");
            device = null;
            return this;
        }

        /**
         * The OpenCL device to run on, where there are several; instead of a back end.
         *
         * @param device one of {@link io.github.circles2d.opencl.OpenCl#devices}
         * @return this
         */
        public Builder device(Device device) {
            this.device = Objects.requireNonNull(device, "device");
            return this;
        }

        /**
         * Threads of the JVM back end, the caller's included. By default one a processor, at most 16. No effect on results.
         *
         * @param threads 1 to 256
         * @return this
         * @throws IllegalArgumentException where the value is out of range
         */
        public Builder threads(int threads) {
            this.threads = Limits.within("the number of threads", threads, 1, Limits.THREADS);
            return this;
        }

        /**
         * How many circles to make room for at once. A world grows by itself; this saves it the growing, and tells
         * {@link Backend#AUTO} for how many circles the world is to be fast.
         *
         * @param capacity number of circles, at least 0
         * @return this
         * @throws IllegalArgumentException where the value is out of range
         */
        public Builder capacity(int capacity) {
            this.capacity = Limits.within("the capacity", capacity, 0, Limits.CIRCLES);
            return this;
        }

        /**
         * Whether to measure the time of each stage. By default not.
         *
         * @param profiling true to measure
         * @return this
         */
        public Builder profiling(boolean profiling) {
            this.profiling = profiling;
            return this;
        }

        /**
         * Builds the world.
         *
         * @return an empty world; close it after use
         * @throws OpenClUnavailableException where an OpenCL back end is asked for and there is no such device; the message says
         *     what is missing and what to install
         * @throws OpenClException where an OpenCL back end is asked for and its driver refuses, or memory is short
         */
        public World build() {
            BackendChoice choice = device == null
                    ? BackendChoice.of(backend, threads, leastShare, capacity, profiling)
                    : BackendChoice.of(device, capacity, profiling);
            return new World(this, choice);
        }
    }
}
