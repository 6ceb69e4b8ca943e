package io.github.circles2d;

import io.github.circles2d.opencl.Device;
import io.github.circles2d.opencl.OpenClException;
import io.github.circles2d.opencl.OpenClUnavailableException;
import io.github.circles2d.world.Simulation;
import io.github.circles2d.world.circles.CircleField;
import io.github.circles2d.world.circles.Commands;
import io.github.circles2d.world.circles.WorldParameters;
import io.github.circles2d.world.model.AxisEdge;
import io.github.circles2d.world.model.Bounds;
import io.github.circles2d.world.model.CircleMath;
import io.github.circles2d.world.model.CircleRow;
import io.github.circles2d.world.model.ContactSettings;
import io.github.circles2d.world.model.Limits;
import io.github.circles2d.world.model.PairTable;
import io.github.circles2d.world.model.SurfaceSettings;
import io.github.circles2d.world.reads.CircleContacts;
import io.github.circles2d.world.shared.Call;
import java.nio.ByteBuffer;
import java.nio.FloatBuffer;
import java.nio.LongBuffer;
import java.util.Arrays;

/**
 * The engine for games: rigid circles that fall, collide, bounce, roll and pile up. A replay of the same calls gives the same bits.
 *
 * <pre>{@code
 * try (World world = World.builder().bounds(0, 0, 80, 100).gravity(0, -10).restitution(0.5f).build()) {
 *     long ball = world.add(40, 50, 1, 2);
 *     world.setVelocity(ball, 1, 0);
 *     world.step(1 / 60f);
 *     float[] circles = new float[4 * world.idLimit()];
 *     world.readById(circles, null); // x, y, radius, mass of each, by World.id
 * }
 * }</pre>
 *
 * <p>docs/guide.md has the calls by task, and what circles do at their limits. {@link Kind} decides which circles meet, {@link Terrain}
 * makes levels, {@link Joints} hold circles, {@link FixedStep} is a game's loop. {@link Edge} says how an axis ends; "walls" and "within
 * the bounds" mean axes with walls. Lengths and masses have the caller's units, time is in seconds, angles grow anticlockwise.
 *
 * <p><b>Handles</b> are longs, never 0. They are stale once their circle is removed: then all methods but {@link #contains} and {@link #id}
 * refuse them with an IllegalArgumentException, or skip and count them if asked to ({@link StaleHandles}). Handles given after a snapshot
 * was taken may name other circles once it is restored. Handles of two worlds may be equal. A new circle takes the lowest free {@link #id}.
 * Bulk reads have the order of ids; those by id ({@link #readById}) leave gaps. Changes take effect in call order, at the latest before the
 * next step or read.
 *
 * <p><b>Static circles</b> have a mass of {@link Float#POSITIVE_INFINITY}. Nothing pushes them, and they may overlap. They move by the
 * velocity set for them, by {@link #setPosition} and by {@link #teleport}, and turn by their angular velocity, as a roller does.
 *
 * <p><img src="doc-files/step.svg" alt="A step: changes, the look ahead of fast circles, contacts, sub-steps of four passes, then events and reads">
 *
 * <p><b>A pair</b> has the greater restitution of its two (at a wall the circle's), the geometric mean of the frictions, sqrt(a b), the
 * greater rolling resistance, and the sum of the belts ({@link Kind#setBeltSpeed}). Impacts up to a speed of sqrt(0.16 g r + c^2), or
 * {@link Builder#restitutionThreshold}, do not bounce. r is the mean radius, g gravity (at a wall along its axis). c is r per second, or
 * 0.1 (1 - restitution) r if nothing carries the two. The limit falls to 0 from a restitution of 0.9 to 1. Overlaps of up to 0.4 r are
 * pushed out at up to 0.8 r a second, deeper ones faster ({@link Builder#greatestPushOutSpeed}), so that they do not burst.
 *
 * <p><img src="doc-files/restitution.svg" alt="A ball with a restitution of 1 comes back to its height, with 0.5 to a quarter of it, with 0 it stays on the ground">
 *
 * <p><b>Threads and failures:</b> a call while another thread is inside throws a ConcurrentModificationException; after {@link #close} all
 * calls but close throw an IllegalStateException. A call that throws an IllegalArgumentException has changed nothing, nor has a call but a
 * step that finds too little memory. If a step or device fails, or an error ends a change half-way, the state may be lost. Then all calls
 * but close throw an IllegalStateException that names the failure. A device may tell of a step's failure in a later call. If a GPU fails
 * to which a world of {@link Backend#AUTO} has moved, {@link #restore} and {@link Rewind#restore} work, and the world goes on on the JVM.
 *
 * <p><b>Ranges</b>, within which all states are finite: coordinates, velocities and gravity up to 1e9; radii from 2^-20 of the greatest
 * extent or coordinate of the bounds to half of the lesser extent, or an eleventh of it if it wraps; masses 1e-9 to 1e9; friction and
 * rolling resistance up to 1,000; angles up to 1e6 and angular velocities up to 1e9 radians; steps 1e-6 to 1 second.
 */
public final class World implements AutoCloseable {
    /**
     * Elements of a contact that {@link #contactsOf} gives: {@link #NORMAL_X}, {@link #NORMAL_Y}, {@link #DEPTH}, {@link #IMPULSE}.
     */
    public static final int CONTACT_STRIDE = CircleContacts.STRIDE;

    /** In a contact: x of the unit normal, which leads from the partner to the circle. */
    public static final int NORMAL_X = CircleContacts.NORMAL_X;

    /** In a contact: y of that normal: 1 if the circle lies on a floor, where y points up. */
    public static final int NORMAL_Y = CircleContacts.NORMAL_Y;

    /** In a contact: how deep the two are in each other, a length; negative if they are apart. */
    public static final int DEPTH = CircleContacts.DEPTH;

    /**
     * In a contact: mass times speed that the partner gave the circle along the normal in the last step, if it pushed evenly. Divided by the
     * length of the step it is the force.
     */
    public static final int IMPULSE = CircleContacts.IMPULSE;

    /** By the settings of the matrix of kinds. */
    private static final Response[] RESPONSES = Response.values();

    /** Here and not in {@link Kind}: memory may end in the first call of a kind, and a class must be ready then. */
    private static final Inertia[] INERTIAS = Inertia.values();

    private static final Edge[] EDGES = Edge.values();

    private final Simulation simulation;
    private final Kind[] kinds = new Kind[PairTable.KINDS];
    private final Queries queries;
    private final Terrain terrain;
    private final Joints joints;
    private final Bodies bodies;
    private final Backend backend;
    private final String reason;

    /** Null if this world never moves. */
    private final RunningChoice running;

    private final Events events = new Events();

    World(Builder b, BackendChoice choice) {
        backend = choice.backend();
        reason = choice.reason();
        running = choice.running();
        simulation = new Simulation(
                choice.pipeline(),
                new WorldParameters(b.arena(), b.gravityX, b.gravityY, b.restitution, b.subSteps, 0)
                        .with(b.contacts)
                        .with(b.surfaces())
                        .sleeping(b.sleep));
        if (running != null) {
            simulation.moves.by(running);
        }
        queries = new Queries(simulation.searches, simulation.terrainSearches, simulation.bodySearches);
        terrain = new Terrain(simulation);
        joints = new Joints(simulation);
        bodies = new Bodies(simulation);
    }

    /** {@return a new description of a world, with every parameter at its default} */
    public static Builder builder() {
        return new Builder();
    }

    /** The inside of this world. */
    static Inertia inertia(int number) {
        return INERTIAS[number];
    }

    Simulation simulation() {
        return simulation;
    }

    // ---- circles

    /**
     * Adds a circle at rest, with the world's restitution.
     *
     * @param x x of the centre, within the bounds; a circle that crosses a wall is moved inside by the next step
     * @param y y of the centre, within the bounds
     * @param radius radius, from 2^-20 of the greatest coordinate or extent of the bounds up to half their lesser extent
     * @param mass mass, 1e-9 to 1e9; positive infinity for a static circle. A circle can carry about a hundred times its own mass,
     *     whatever its radius and kind
     * @return its handle
     * @throws IllegalArgumentException if a value is out of range
     */
    public long add(float x, float y, float radius, float mass) {
        return simulation.newCircles.add(x, y, radius, mass, 0, 0, 0);
    }

    /**
     * Adds a circle, with the world's restitution.
     *
     * @param x x of the centre, within the bounds; a circle that crosses a wall is moved inside by the next step
     * @param y y of the centre, within the bounds
     * @param radius radius, from 2^-20 of the greatest coordinate or extent of the bounds up to half their lesser extent
     * @param mass mass, 1e-9 to 1e9; positive infinity for a static circle. A circle can carry about a hundred times its own mass,
     *     whatever its radius and kind
     * @param vx velocity along x, lengths per second, up to 1e9 in magnitude
     * @param vy velocity along y, likewise
     * @return its handle
     * @throws IllegalArgumentException if a value is out of range
     */
    public long add(float x, float y, float radius, float mass, float vx, float vy) {
        return simulation.newCircles.add(x, y, radius, mass, vx, vy, 0);
    }

    /**
     * Adds a circle of a kind, with the kind's restitution, else the world's.
     *
     * @param x x of the centre, within the bounds; a circle that crosses a wall is moved inside by the next step
     * @param y y of the centre, within the bounds
     * @param radius radius, from 2^-20 of the greatest coordinate or extent of the bounds up to half their lesser extent
     * @param mass mass, 1e-9 to 1e9; positive infinity for a static circle. A circle can carry about a hundred times its own mass,
     *     whatever its radius and kind
     * @param vx velocity along x, lengths per second, up to 1e9 in magnitude
     * @param vy velocity along y, likewise
     * @param kind the number of its kind, 0 to 255
     * @return its handle
     * @throws IllegalArgumentException if a value is out of range
     */
    public long add(float x, float y, float radius, float mass, float vx, float vy, int kind) {
        return simulation.newCircles.add(x, y, radius, mass, vx, vy, kind);
    }

    /**
     * Adds many circles at rest, with the world's restitution: all of them, or none if one is refused.
     *
     * @param circles x, y, radius and mass of one after the other
     * @param handles takes the handle of each; at least as many elements as there are circles; may be null
     * @throws IllegalArgumentException if a value is out of range (the message has the number of the circle), or an array
     *     has the wrong length
     */
    public void addAll(float[] circles, long[] handles) {
        addAll(circles, null, handles);
    }

    /**
     * Adds many circles, with the world's restitution: all of them, or none if one is refused.
     *
     * @param circles x, y, radius and mass of one after the other
     * @param velocities vx and vy of one after the other; may be null, for circles at rest
     * @param handles takes the handle of each; at least as many elements as there are circles; may be null
     * @throws IllegalArgumentException if a value is out of range (the message has the number of the circle), or an array
     *     has the wrong length
     */
    public void addAll(float[] circles, float[] velocities, long[] handles) {
        addAll(circles, velocities, null, handles);
    }

    /**
     * Adds many circles of any kinds, each with its kind's restitution, else the world's: all of them, or none if one is refused.
     *
     * @param circles x, y, radius and mass of one after the other
     * @param velocities vx and vy of one after the other; may be null, for circles at rest
     * @param kinds the number of the kind of each, 0 to 255; may be null, for circles of kind 0
     * @param handles takes the handle of each; at least as many elements as there are circles; may be null
     * @throws IllegalArgumentException if a value is out of range (the message has the number of the circle), or an array
     *     has the wrong length
     */
    public void addAll(float[] circles, float[] velocities, int[] kinds, long[] handles) {
        simulation.newCircles.addAll(circles, velocities, kinds, handles);
    }

    /**
     * Removes a circle, and its {@link Joints}. Its handle is stale from now on.
     *
     * @param handle the circle
     * @throws IllegalArgumentException if the handle is stale
     */
    public void remove(long handle) {
        simulation.circles.remove(handle);
    }

    /**
     * Removes many circles with their {@link Joints}: all of them, or none if one is refused. A handle that occurs again is stale by then.
     *
     * @param handles the circles
     * @param count how many of them, from the first element on; 0 to the length of the array
     * @param stale what to do about stale handles
     * @return the number of handles that were left out, as the caller asked for
     * @throws IllegalArgumentException if a handle is stale and not to be left out, or the count is out of range
     */
    public int removeAll(long[] handles, int count, StaleHandles stale) {
        return simulation.bulk.remove(handles, count, StaleHandles.areSkipped(stale));
    }

    /**
     * Removes all circles and their joints, as {@link #remove} of each in the order of their ids would: their handles are stale from now on, their ids
     * are free, and pairs that touched end. It takes about as long as a read. Changes of circles that still wait for a step are dropped.
     *
     * <p>All else stays: the bounds and the way that walls have to go, gravity, sub-steps and the other settings of the builder, {@link
     * #terrain}, which {@link Terrain#clear} removes, {@link #bodies}, which {@link Bodies#clear} removes, kinds and the responses of {@link #setResponse}, the reported types and events that have not been taken, {@link #idLimit}, and the length of
     * the last step. {@link #stats} counts no pairs until the next step.
     */
    public void clear() {
        simulation.calls.make(Call.CLEAR);
    }

    /**
     * The id of a handle: its lower 32 bits. Ids are small numbers from 0 on, so a game keeps its own data of circles in arrays by id.
     * Two circles that live at the same time have different ids. When a circle has been removed, a new one takes its id over: reset
     * the entries of its id when you add a circle.
     *
     * @param handle the handle of a circle, stale or not; of the handle of anything else the number means nothing
     * @return its id, at least 0
     */
    public static int id(long handle) {
        return (int) handle;
    }

    /**
     * How long the caller's arrays by id must be: one more than the greatest id that a circle of this world has had. It grows with
     * the greatest number of circles that there were at a time, and not with the number of circles that came. It does not shrink,
     * except that {@link #restore} makes it what it was when the snapshot was taken.
     *
     * @return at least {@link #size}
     */
    public int idLimit() {
        return simulation.circles.idLimit();
    }

    /**
     * The handle of the circle that has an id now. {@link #readHandles} gives those of all circles.
     *
     * @param id an id, at least 0 and less than {@link #idLimit}
     * @return the handle; 0 if no circle has the id
     * @throws IllegalArgumentException if the id is out of range
     */
    public long handle(int id) {
        return simulation.circles.handle(id);
    }

    /**
     * Whether a handle is that of a circle of this world. This looks into two arrays and waits for nothing.
     *
     * @param handle any number
     * @return false if it is stale or never was a handle
     */
    public boolean contains(long handle) {
        return simulation.circles.contains(handle);
    }

    /** {@return the number of circles, at least 0} */
    public int size() {
        return simulation.circles.size();
    }

    /**
     * Puts a circle somewhere else; its velocity stays.
     *
     * <p>A circle that is not static is there at once. It may overlap others there, which are pushed apart (see the class).
     *
     * <p>A static circle travels there in the next step, on a straight line, however far it is, and pushes what is in its way ahead.
     * Reads give its old place until then; after the step it is exactly at the new one, with the velocity that it had before. In this
     * step it does not move by its own velocity. Of several calls before a step the last one counts. {@link #setBounds} brings the
     * new place inside, and a circle that {@link #setMass} makes no longer static is there at once. A circle far away flings what it
     * meets: use {@link #teleport} for jumps.
     *
     * @param handle the circle
     * @param x x of the centre, within the bounds
     * @param y y of the centre, within the bounds
     * @throws IllegalArgumentException if the handle is stale or a value is out of range
     */
    public void setPosition(long handle, float x, float y) {
        simulation.circles.move(handle, x, y);
    }

    /**
     * Puts a circle somewhere else at once, also a static one, past all that lies between; its velocity stays. It may overlap others
     * there, which are pushed apart (see the class).
     *
     * @param handle the circle
     * @param x x of the centre, within the bounds
     * @param y y of the centre, within the bounds
     * @throws IllegalArgumentException if the handle is stale or a value is out of range
     */
    public void teleport(long handle, float x, float y) {
        simulation.circles.set(Commands.POSITION, handle, x, y);
    }

    /**
     * Gives a circle a velocity. A static circle keeps it until another call changes it; at the bounds it stops, and has no velocity
     * from there on.
     *
     * @param handle the circle
     * @param vx velocity along x, lengths per second, up to 1e9 in magnitude
     * @param vy velocity along y, likewise
     * @throws IllegalArgumentException if the handle is stale or a value is out of range
     */
    public void setVelocity(long handle, float vx, float vy) {
        simulation.circles.set(Commands.VELOCITY, handle, vx, vy);
    }

    /**
     * Gives a circle another radius at once; its mass stays. Circles that it overlaps then are pushed out slowly (see the class), so
     * many circles may grow at once. With {@link #grow} it overlaps them less.
     *
     * @param handle the circle
     * @param radius radius, from 2^-20 of the greatest coordinate or extent of the bounds up to half their lesser extent
     * @throws IllegalArgumentException if the handle is stale or the value is out of range
     */
    public void setRadius(long handle, float radius) {
        simulation.circles.set(Commands.RADIUS, handle, radius, 0);
    }

    /**
     * Lets a circle grow or shrink to a radius over some steps, in equal parts; its mass stays. Each step begins with the next radius,
     * so reads and queries give that of the last step. {@link #setRadius} ends the growth, and another call of this method replaces it.
     * The growth is in snapshots, in the hash and in logs.
     *
     * <p><b>In a crowd</b> a circle hardly overlaps others, and throws none, if it grows by at most about 0.4 of its radius a second: by
     * 30 % in 45 steps of 1/60 second. Two circles that merge need no extra room at first: remove one of them, and let the other one grow
     * from the radius that it has:
     *
     * <pre>{@code
     * world.remove(upper);
     * world.setMass(lower, mass);
     * world.grow(lower, radius, 45);
     * }</pre>
     *
     * <p>Balls that merged so in a full box overlapped others by more than 0.15 of their radius in one of 60 frames. With the builder's
     * {@code subSteps(8)}, {@code contactFrequency(134)} and {@code greatestPushOutSpeed(2)} they did so in one of 48,000 frames. Balls
     * that came with their whole size did so in one of 12. A circle that grows still carries the circles that lie on it.
     *
     * @param handle the circle
     * @param radius the radius at the end, as {@link #setRadius} takes it
     * @param steps in how many steps, 1 to 100,000
     * @throws IllegalArgumentException if the handle is stale or a value is out of range
     */
    public void grow(long handle, float radius, int steps) {
        simulation.calls.change(Call.GROW, handle, Float.floatToRawIntBits(radius), steps, 0);
    }

    /**
     * Gives a circle another mass.
     *
     * @param handle the circle
     * @param mass mass, 1e-9 to 1e9 (a circle can carry about a hundred times its own); positive infinity makes it a static circle,
     *     which goes on at its velocity: {@link #setVelocity} stops it
     * @throws IllegalArgumentException if the handle is stale or the value is out of range
     */
    public void setMass(long handle, float mass) {
        simulation.circles.set(Commands.MASS, handle, mass, 0);
    }

    /**
     * Gives a circle a restitution, in place of the one that it got when it was added.
     *
     * @param handle the circle
     * @param restitution 0 (inelastic) to 1 (elastic); slow impacts do not bounce (see the class)
     * @throws IllegalArgumentException if the handle is stale or the value is out of range
     */
    public void setRestitution(long handle, float restitution) {
        simulation.circles.set(Commands.RESTITUTION, handle, restitution, 0);
    }

    /**
     * Wakes a circle, if it sleeps ({@link Builder#sleep}). One that is awake begins anew to come to rest; so a circle that is woken before
     * each step never sleeps.
     *
     * @param handle the circle
     * @throws IllegalArgumentException if the handle is stale
     */
    public void wake(long handle) {
        simulation.circles.set(Commands.WAKE, handle, 0, 0);
    }

    /** Wakes all circles and bodies that sleep. */
    public void wakeAll() {
        simulation.calls.make(Call.WAKE_ALL);
    }

    /**
     * Gives a circle a number for the caller's own use. It is 0 at first. It changes no step, but it is in snapshots, and in the hash if
     * it is not 0.
     *
     * @param handle the circle
     * @param tag any number
     * @throws IllegalArgumentException if the handle is stale
     */
    public void setTag(long handle, long tag) {
        simulation.fields.set(CircleField.TAG, handle, tag);
    }

    /**
     * Gives a circle another kind, and the kind's restitution if it has one. {@link Kind} says what kinds are for.
     *
     * @param handle the circle
     * @param kind the number of the kind, 0 to 255
     * @throws IllegalArgumentException if the handle is stale or the value is out of range
     */
    public void setKind(long handle, int kind) {
        simulation.circles.setKind(handle, kind);
    }

    /**
     * Puts a circle into an exclusion group: circles of one group never meet, nor do they meet the bodies of it ({@link Bodies#setGroup}), whatever
     * their kinds. Others meet as their kinds say.
     *
     * @param handle the circle
     * @param group any number; 0 for no group, as at first
     * @throws IllegalArgumentException if the handle is stale
     */
    public void setGroup(long handle, int group) {
        simulation.fields.set(CircleField.GROUP, handle, group);
    }

    /**
     * Pushes a circle: its velocity changes by the impulse over its mass. That of a static circle stays.
     *
     * @param handle the circle
     * @param x impulse along x, mass times length per second, up to 1e18 in magnitude
     * @param y impulse along y, likewise
     * @throws IllegalArgumentException if the handle is stale or a component is over 1e18 in magnitude
     */
    public void applyImpulse(long handle, float x, float y) {
        simulation.circles.set(Commands.IMPULSE, handle, x, y);
    }

    /**
     * Sets a force on a circle, which acts in every step until it is changed: thrust, steering, wind. Each second it adds the force over
     * the mass to the velocity; static circles do not feel it. A force keeps the effects of collisions, which {@link #setVelocity} would
     * wipe out.
     *
     * <p>It is the same in all sub-steps of a step. So a force that depends on the place adds energy: a spring of 1 Hz that the game sets before
     * each step has 11.7 times its swing after 20 s. {@link #applyImpulse} with the force times the length of the step keeps it (1.001), and a
     * {@link Joint#spring} is exact.
     *
     * @param handle the circle
     * @param x force along x, mass times length per second squared, up to 1e18 in magnitude; in a sub-step it changes a velocity by at
     *     most 1e9
     * @param y force along y, likewise
     * @throws IllegalArgumentException if the handle is stale or a component is over 1e18 in magnitude
     */
    public void setForce(long handle, float x, float y) {
        simulation.circles.setForce(handle, x, y);
    }

    /**
     * Applies a force to a circle in the next step alone (the first of several that one call makes), besides the force that
     * {@link #setForce} has set. Several that are applied before a step add up. For a push that is over at once use {@link #applyImpulse}.
     *
     * @param handle the circle
     * @param x force along x, mass times length per second squared, up to 1e18 in magnitude. The sum of several forces is cut to that
     * @param y force along y, likewise
     * @throws IllegalArgumentException if the handle is stale or a component is over 1e18 in magnitude
     */
    public void applyForce(long handle, float x, float y) {
        simulation.forces.apply(handle, x, y);
    }

    /**
     * Gives a circle friction of its own, in place of that of its kind ({@link Kind#setFriction}) or of the world ({@link
     * Builder#friction}). It acts from the next step on.
     *
     * @param handle the circle
     * @param friction 0 (slides) to 1,000, or {@link Float#NaN} for none of its own; the class says what a pair has
     * @throws IllegalArgumentException if the handle is stale or the value is out of range
     */
    public void setFriction(long handle, float friction) {
        simulation.fields.setOwn(CircleField.FRICTION, handle, friction);
    }

    /**
     * Gives a circle rolling resistance of its own, in place of that of its kind or of the world. It acts from the next step on. Where a
     * circle rolls on another or on a wall, a torque of up to this times the load times the greater radius holds their turning against each
     * other.
     *
     * @param handle the circle
     * @param resistance 0 (rolls on) to 1,000, or {@link Float#NaN} for none of its own; a pair has the greater of its two
     * @throws IllegalArgumentException if the handle is stale or the value is out of range
     */
    public void setRollingResistance(long handle, float resistance) {
        simulation.fields.setOwn(CircleField.ROLLING_RESISTANCE, handle, resistance);
    }

    /**
     * Gives a circle a factor of gravity of its own, in place of that of its kind ({@link Kind#setGravityScale}). It acts from the next
     * step on.
     *
     * @param handle the circle
     * @param scale -1000 to 1000: 0 for a circle that does not fall, negative for one that rises; {@link Float#NaN} for none of its own.
     *     Gravity times this is cut to 1e9 along each axis
     * @throws IllegalArgumentException if the handle is stale or the value is out of range
     */
    public void setGravityScale(long handle, float scale) {
        simulation.fields.setOwn(CircleField.GRAVITY_SCALE, handle, scale);
    }

    /**
     * Gives a circle damping of its own, in place of that of its kind ({@link Kind#setDamping}): in t seconds it loses about the share
     * 1 - e^(-damping t) of its velocity. It acts from the next step on.
     *
     * @param handle the circle
     * @param damping per second, 0 to 1e6, or {@link Float#NaN} for none of its own
     * @throws IllegalArgumentException if the handle is stale or the value is out of range
     */
    public void setDamping(long handle, float damping) {
        simulation.fields.setOwn(CircleField.DAMPING, handle, damping);
    }

    /**
     * Gives a circle a greatest speed of its own, in place of that of its kind ({@link Kind#setGreatestSpeed}, which says what it does to
     * collisions and impulses). It acts from the next step on.
     *
     * @param handle the circle
     * @param speed lengths per second, at least 0; infinite if nothing limits it; {@link Float#NaN} for none of its own
     * @throws IllegalArgumentException if the handle is stale or the value is out of range
     */
    public void setGreatestSpeed(long handle, float speed) {
        simulation.fields.setOwn(CircleField.GREATEST_SPEED, handle, speed);
    }

    /**
     * Turns a circle to an angle; its angular velocity stays. The angle of a circle is a number for the caller, who draws the circle by it:
     * no collision depends on it.
     *
     * @param handle the circle
     * @param angle radians anticlockwise, up to 1e6 in magnitude. Whole turns are dropped, and the rest is rounded to 2^-32 of a turn
     * @throws IllegalArgumentException if the handle is stale or the value is out of range
     */
    public void setAngle(long handle, float angle) {
        simulation.circles.setAngle(handle, angle);
    }

    /**
     * Gives a circle an angular velocity. A static circle keeps it until another call changes it, and drives the circles that grip it. Any
     * other circle keeps it until friction, rolling resistance, a torque, an angular impulse or {@link Kind#setAngularDamping} changes it;
     * {@link #setRadius} and {@link #setMass} do not.
     *
     * @param handle the circle
     * @param velocity radians per second anticlockwise, up to 1e9 in magnitude. Times the radius it counts as at most 1e9
     * @throws IllegalArgumentException if the handle is stale or the value is out of range
     */
    public void setAngularVelocity(long handle, float velocity) {
        simulation.circles.setAngularVelocity(handle, velocity);
    }

    /**
     * Turns a circle by a push: its angular velocity changes by the impulse over its inertia. That of a static circle stays, and so does
     * that of a circle whose kind has {@link Inertia#NONE}.
     *
     * @param handle the circle
     * @param impulse mass times length squared per second, anticlockwise, up to 1e18 in magnitude
     * @throws IllegalArgumentException if the handle is stale or the value is out of range
     */
    public void applyAngularImpulse(long handle, float impulse) {
        simulation.circles.applyAngularImpulse(handle, impulse);
    }

    /**
     * Sets a torque on a circle, which acts in every step until it is changed: a motor, a wheel that steers. Each second it adds the torque
     * over the inertia to the angular velocity. Static circles do not feel it, nor do those whose kind has {@link Inertia#NONE}.
     *
     * @param handle the circle
     * @param torque mass times length squared per second squared, anticlockwise, up to 1e18 in magnitude
     * @throws IllegalArgumentException if the handle is stale or the value is out of range
     */
    public void setTorque(long handle, float torque) {
        simulation.fields.setTorque(handle, torque);
    }

    /**
     * Applies a torque to a circle in the next step alone (the first of several that one call makes), besides the torque that {@link
     * #setTorque} has set. Several that are applied before a step add up.
     *
     * @param handle the circle
     * @param torque as {@link #setTorque} takes it. The sum of several is cut to 1e18 in magnitude
     * @throws IllegalArgumentException if the handle is stale or the value is out of range
     */
    public void applyTorque(long handle, float torque) {
        simulation.forces.applyTorque(handle, torque);
    }

    /**
     * Puts many circles somewhere else, as {@link #setPosition} does, in the order of the array: all of them, or none if one is
     * refused.
     *
     * @param handles the circles
     * @param count how many of them, from the first element on; 0 to the length of the array
     * @param positions x and y of the centre of each, within the bounds
     * @param stale what to do about stale handles
     * @return the number of handles that were left out, as the caller asked for
     * @throws IllegalArgumentException if a handle is stale and not to be left out, a value of a handle that is not left out is
     *     out of range (the message has its place), or the count is out of range or there are too few values
     */
    public int setPositions(long[] handles, int count, float[] positions, StaleHandles stale) {
        return simulation.bulk.setPositions(handles, count, positions, StaleHandles.areSkipped(stale));
    }

    /**
     * Gives many circles velocities, as {@link #setVelocity} does, in the order of the array: all of them, or none if one is
     * refused.
     *
     * @param handles the circles
     * @param count how many of them, from the first element on; 0 to the length of the array
     * @param velocities vx and vy of each, lengths per second, up to 1e9 in magnitude
     * @param stale what to do about stale handles
     * @return the number of handles that were left out, as the caller asked for
     * @throws IllegalArgumentException as {@link #setPositions} does
     */
    public int setVelocities(long[] handles, int count, float[] velocities, StaleHandles stale) {
        return simulation.bulk.setVelocities(handles, count, velocities, StaleHandles.areSkipped(stale));
    }

    /**
     * Pushes many circles, as {@link #applyImpulse} does, in the order of the array: all of them, or none if one is refused.
     *
     * @param handles the circles; one that occurs twice is pushed twice
     * @param count how many of them, from the first element on; 0 to the length of the array
     * @param impulses impulse along x and y of each, mass times length per second, up to 1e18 in magnitude
     * @param stale what to do about stale handles
     * @return the number of handles that were left out, as the caller asked for
     * @throws IllegalArgumentException as {@link #setPositions} does
     */
    public int applyImpulses(long[] handles, int count, float[] impulses, StaleHandles stale) {
        return simulation.bulk.applyImpulses(handles, count, impulses, StaleHandles.areSkipped(stale));
    }

    /**
     * Sets forces on many circles, as {@link #setForce} does, in the order of the array: on all of them, or on none if one is
     * refused.
     *
     * @param handles the circles
     * @param count how many of them, from the first element on; 0 to the length of the array
     * @param forces force along x and y of each, mass times length per second squared, up to 1e18 in magnitude
     * @param stale what to do about stale handles
     * @return the number of handles that were left out, as the caller asked for
     * @throws IllegalArgumentException as {@link #setPositions} does
     */
    public int setForces(long[] handles, int count, float[] forces, StaleHandles stale) {
        return simulation.bulk.setForces(handles, count, forces, StaleHandles.areSkipped(stale));
    }

    /**
     * Gives many circles angular velocities, as {@link #setAngularVelocity} does, in the order of the array: all of them, or none if one is
     * refused.
     *
     * @param handles the circles
     * @param count how many of them, from the first element on; 0 to the length of the array
     * @param angularVelocities that of each, radians per second, up to 1e9 in magnitude
     * @param stale what to do about stale handles
     * @return the number of handles that were left out, as the caller asked for
     * @throws IllegalArgumentException as {@link #setPositions} does
     */
    public int setAngularVelocities(long[] handles, int count, float[] angularVelocities, StaleHandles stale) {
        return simulation.bulk.setAngularVelocities(handles, count, angularVelocities, StaleHandles.areSkipped(stale));
    }

    /**
     * Gives many circles other kinds, as {@link #setKind} does, in the order of the array: all of them, or none if one is refused.
     *
     * @param handles the circles
     * @param count how many of them, from the first element on; 0 to the length of the array
     * @param kinds the number of the kind of each, 0 to 255
     * @param stale what to do about stale handles
     * @return the number of handles that were left out, as the caller asked for
     * @throws IllegalArgumentException as {@link #setPositions} does
     */
    public int setKinds(long[] handles, int count, int[] kinds, StaleHandles stale) {
        return simulation.bulk.setKinds(handles, count, kinds, StaleHandles.areSkipped(stale));
    }

    /**
     * Pushes the circles and {@link #bodies} near a point away from it. A circle gets the whole impulse if its edge is at most the radius away from the
     * point, none from radius + falloff on, and in between a share that falls in a straight line. The same impulse makes a light
     * circle faster than a heavy one. Static circles stay as they are, and so does a circle whose centre is the point itself.
     *
     * <p>A body gets its impulse by the distance of its outline, at the point of the outline that is nearest, into the body at right angles. So it turns
     * a body, too. If the point of the explosion is inside, the impulse is whole, and a body whose centroid is there stays as it is.
     *
     * <p>It needs the present positions. So the first explosion after a step, or after a change of circles, reads all circles back, as
     * {@link #x} does, and waits for the device. Further ones use the same positions.
     *
     * @param x x of the point, up to 1e9 in magnitude; it may lie outside the bounds
     * @param y y of the point, likewise
     * @param radius a length, 0 to 1e10
     * @param impulse mass times length per second, up to 1e18 in magnitude; negative to pull circles to the point
     * @param falloff a length, 0 to 1e10
     * @return the number of circles and bodies that got an impulse
     * @throws IllegalArgumentException if a value is out of range
     */
    public int explode(float x, float y, float radius, float impulse, float falloff) {
        return simulation.bulk.explode(false, 0, x, y, radius, impulse, falloff);
    }

    /**
     * Pushes some of the circles and bodies near a point away from it, as {@link #explode(float, float, float, float, float)} does: those whose
     * kind's category ({@link Kind#setCategory}) has a bit of a mask, as {@link Queries#withMask} finds them.
     *
     * @param x x of the point, up to 1e9 in magnitude; it may lie outside the bounds
     * @param y y of the point, likewise
     * @param radius a length, 0 to 1e10
     * @param impulse mass times length per second, up to 1e18 in magnitude; negative to pull circles to the point
     * @param falloff a length, 0 to 1e10
     * @param mask the bits of the categories to push
     * @return the number of circles and bodies that got an impulse
     * @throws IllegalArgumentException if a value is out of range
     */
    public int explode(float x, float y, float radius, float impulse, float falloff, int mask) {
        return simulation.bulk.explode(true, mask, x, y, radius, impulse, falloff);
    }

    /**
     * Pushes the circles and bodies near a point away from it, as {@link #explode(float, float, float, float, float)} does, but those that are hidden
     * behind terrain: a circle gets nothing if a piece that would stop it is between the point and its centre, and a body if one is between the
     * point and the nearest point of the outline. A ray from the point decides, as {@link TerrainQueries#rayCast(float, float, float, float, float[])} finds pieces, but pieces at the point itself hide
     * nobody.
     *
     * @param x x of the point, up to 1e9 in magnitude; it may lie outside the bounds
     * @param y y of the point, likewise
     * @param radius a length, 0 to 1e10
     * @param impulse mass times length per second, up to 1e18 in magnitude; negative to pull circles to the point
     * @param falloff a length, 0 to 1e10
     * @return the number of circles and bodies that got an impulse
     * @throws IllegalArgumentException if a value is out of range
     */
    public int explodeInSight(float x, float y, float radius, float impulse, float falloff) {
        return simulation.bulk.explodeInSight(false, 0, x, y, radius, impulse, falloff);
    }

    /**
     * Pushes some of the circles and bodies near a point away from it, as {@link #explodeInSight(float, float, float, float, float)} does: those
     * whose kind's category ({@link Kind#setCategory}) has a bit of a mask.
     *
     * @param x x of the point, up to 1e9 in magnitude; it may lie outside the bounds
     * @param y y of the point, likewise
     * @param radius a length, 0 to 1e10
     * @param impulse mass times length per second, up to 1e18 in magnitude; negative to pull circles to the point
     * @param falloff a length, 0 to 1e10
     * @param mask the bits of the categories to push
     * @return the number of circles and bodies that got an impulse
     * @throws IllegalArgumentException if a value is out of range
     */
    public int explodeInSight(float x, float y, float radius, float impulse, float falloff, int mask) {
        return simulation.bulk.explodeInSight(true, mask, x, y, radius, impulse, falloff);
    }

    // ---- the world

    /**
     * A kind of circles, to change or to ask. A circle without another kind is of kind 0. {@link #kindOf} tells the kind of a circle.
     *
     * @param number 0 to 255
     * @return the kind; the same object for the same number
     * @throws IllegalArgumentException if there is no such kind
     */
    public Kind kind(int number) {
        if (kinds[simulation.kinds.check(number)] == null) {
            kinds[number] = new Kind(simulation.kinds, number);
        }
        return kinds[number];
    }

    /**
     * Says what the circles of two kinds do to each other, whatever their masks and sensors say; or leaves it to these.
     *
     * @param kindA the number of a kind, 0 to 255
     * @param kindB the number of another kind, or of the same
     * @param response what they do; {@link Response#BY_MASK} to leave it to masks and sensors, as at first
     * @throws IllegalArgumentException if there is no such kind
     */
    public void setResponse(int kindA, int kindB, Response response) {
        simulation.kinds.setSetting(
                kindA, kindB, Limits.notNull("response", response).ordinal());
    }

    /**
     * The response that {@link #setResponse} has set for two kinds.
     *
     * @param kindA the number of a kind, 0 to 255
     * @param kindB the number of another kind, or of the same
     * @return what was set last; {@link Response#BY_MASK} at first
     * @throws IllegalArgumentException if there is no such kind
     */
    public Response response(int kindA, int kindB) {
        return RESPONSES[simulation.kinds.setting(kindA, kindB)];
    }

    /**
     * Changes gravity.
     *
     * @param x acceleration along x, lengths per second squared, up to 1e9 in magnitude
     * @param y acceleration along y, likewise; negative downwards
     * @throws IllegalArgumentException if a value is out of range
     */
    public void setGravity(float x, float y) {
        simulation.calls.makeOfFloats(Call.GRAVITY, x, y, 0, 0);
    }

    /** {@return gravity along x: an acceleration, in lengths per second squared} */
    public float gravityX() {
        return simulation.settings().gravityX();
    }

    /** {@return gravity along y: an acceleration, in lengths per second squared; negative downwards} */
    public float gravityY() {
        return simulation.settings().gravityY();
    }

    /**
     * Moves the walls. They travel to their new places in the next step, and push the circles that they meet: these get the wall's
     * speed, or bounce off by their speed against the wall. Call this before each step to let a wall go on. If a wall moves farther than
     * the radius of a circle, it does not push that circle: the circle is brought to the nearest place inside at once, and gets no speed.
     * Along an {@linkplain Builder#edges open} axis nothing is moved.
     *
     * @param minX left wall
     * @param minY lower wall
     * @param maxX right wall
     * @param maxY upper wall
     * @throws IllegalArgumentException if a value is out of range; if a circle is, or grows to be, too large or too small for these bounds;
     *     or if the call would move the bounds of an axis that wraps
     */
    public void setBounds(float minX, float minY, float maxX, float maxY) {
        simulation.calls.makeOfFloats(Call.BOUNDS, minX, minY, maxX, maxY);
    }

    /** {@return where the left wall is: its x} */
    public float minX() {
        return simulation.settings().bounds().minX();
    }

    /** {@return where the lower wall is: its y} */
    public float minY() {
        return simulation.settings().bounds().minY();
    }

    /** {@return where the right wall is: its x} */
    public float maxX() {
        return simulation.settings().bounds().maxX();
    }

    /** {@return where the upper wall is: its y} */
    public float maxY() {
        return simulation.settings().bounds().maxY();
    }

    /** The bounds, with what there is at their edges. */
    Bounds arena() {
        return simulation.settings().bounds();
    }

    /**
     * The way along x from one place to another: the short one if the axis {@linkplain Builder#edges wraps}, which may lead across the seam. So
     * a thing beside another is drawn at {@code x + world.shortestX(x, otherX)}, though it may be at the other end of the bounds.
     *
     * @param fromX x of the place where the way begins, up to 1e9 in magnitude
     * @param toX x of the place where it ends, likewise
     * @return a length, negative to the left; at most half of the extent of an axis that wraps
     * @throws IllegalArgumentException if a value is out of range
     */
    public float shortestX(float fromX, float toX) {
        Limits.within("fromX", fromX, -Limits.COORDINATE, Limits.COORDINATE);
        Limits.within("toX", toX, -Limits.COORDINATE, Limits.COORDINATE);
        Bounds bounds = arena();
        return CircleMath.shortWay(bounds.placeX(toX) - bounds.placeX(fromX), bounds.periodX());
    }

    /**
     * The way along y from one place to another; see {@link #shortestX}.
     *
     * @param fromY y of the place where the way begins, up to 1e9 in magnitude
     * @param toY y of the place where it ends, likewise
     * @return a length, negative downwards if y points up; at most half of the extent of an axis that wraps
     * @throws IllegalArgumentException if a value is out of range
     */
    public float shortestY(float fromY, float toY) {
        Limits.within("fromY", fromY, -Limits.COORDINATE, Limits.COORDINATE);
        Limits.within("toY", toY, -Limits.COORDINATE, Limits.COORDINATE);
        Bounds bounds = arena();
        return CircleMath.shortWay(bounds.placeY(toY) - bounds.placeY(fromY), bounds.periodY());
    }

    /** {@return what there is at the left and the right edge, as {@link Builder#edges} has set it, or a restored snapshot} */
    public Edge edgeX() {
        return EDGES[simulation.settings().bounds().edgeX().ordinal()];
    }

    /** {@return what there is at the lower and the upper edge, as {@link Builder#edges} has set it, or a restored snapshot} */
    public Edge edgeY() {
        return EDGES[simulation.settings().bounds().edgeY().ordinal()];
    }

    /** {@return the restitution that new circles get: 0 (inelastic) to 1 (elastic)} */
    public float defaultRestitution() {
        return simulation.settings().defaultRestitution();
    }

    /**
     * {@return the friction of circles that have none of their own, nor by their kind, as {@link Builder#friction} has set it, or a restored
     * snapshot: 0 to 1,000}
     */
    public float defaultFriction() {
        return simulation.settings().surfaces().friction;
    }

    /**
     * {@return the rolling resistance of circles that have none of their own, nor by their kind, as {@link Builder#rollingResistance} has set it, or
     * a restored snapshot: 0 to 1,000}
     */
    public float defaultRollingResistance() {
        return simulation.settings().surfaces().rollingResistance;
    }

    /**
     * {@return whether circles that lie still fall asleep, as {@link Builder#sleep} has set it, or a restored snapshot; false if all are always
     * awake}
     */
    public boolean sleeps() {
        return simulation.settings().sleeps();
    }

    /**
     * Gives a wall a surface, from the next step on. Walls that are not there, since an axis is open or wraps, have surfaces too, which do
     * nothing.
     *
     * @param wall which wall
     * @param friction 0 to 1,000
     * @param rollingResistance 0 to 1,000
     * @param beltSpeed speed of the surface along the wall, as that of a conveyor belt: lengths per second, up to 1e9 in magnitude, with
     *     the sign of {@link Kind#setBeltSpeed}. A positive one carries to the right on the lower wall, up on the right one, to the left on
     *     the upper one, and down on the left one
     * @throws IllegalArgumentException if a value is out of range
     */
    public void setWallSurface(Wall wall, float friction, float rollingResistance, float beltSpeed) {
        int number = Limits.notNull("wall", wall).ordinal();
        simulation.calls.make(
                Call.WALL_SURFACE,
                number,
                Float.floatToRawIntBits(friction),
                Float.floatToRawIntBits(rollingResistance),
                Float.floatToRawIntBits(SurfaceSettings.beltOfWall(number, beltSpeed)));
    }

    /**
     * The friction of a wall.
     *
     * @param wall which wall
     * @return 0 to 1,000
     */
    public float wallFriction(Wall wall) {
        return simulation
                .settings()
                .surfaces()
                .wallFriction(Limits.notNull("wall", wall).ordinal());
    }

    /**
     * The rolling resistance of a wall.
     *
     * @param wall which wall
     * @return 0 to 1,000
     */
    public float wallRollingResistance(Wall wall) {
        return simulation
                .settings()
                .surfaces()
                .wallRollingResistance(Limits.notNull("wall", wall).ordinal());
    }

    /**
     * The speed of the surface of a wall.
     *
     * @param wall which wall
     * @return lengths per second, with the sign of {@link #setWallSurface}
     */
    public float wallBeltSpeed(Wall wall) {
        int number = Limits.notNull("wall", wall).ordinal();
        return SurfaceSettings.beltOfWall(
                number, simulation.settings().surfaces().wallBelt(number));
    }

    /** {@return the number of sub-steps a step, 1 to 16} */
    public int subSteps() {
        return simulation.settings().subSteps();
    }

    /** {@return the speed up to which impacts do not bounce, in lengths per second; -1 if it follows from gravity, radii and restitutions} */
    public float restitutionThreshold() {
        return simulation.settings().contacts().restitutionThreshold();
    }

    /** {@return the stiffness of contacts in hertz} */
    public float contactFrequency() {
        return simulation.settings().contacts().frequency();
    }

    /** {@return the damping ratio of contacts, at least 0} */
    public float contactDamping() {
        return simulation.settings().contacts().damping();
    }

    /** {@return the greatest speed at which overlaps are pushed out that are not deep, in mean radii of the pair a second} */
    public float greatestPushOutSpeed() {
        return simulation.settings().contacts().pushOutSpeed();
    }

    /**
     * Makes one step.
     *
     * @param timeStep its length in seconds, 1e-6 to 1; games use 1 / 60f. It may differ from that of the step before
     * @throws IllegalArgumentException if the value is out of range
     */
    public void step(float timeStep) {
        step(timeStep, 1);
    }

    /**
     * Makes several steps in one call, which an OpenCL device gets together.
     *
     * @param timeStep the length of each in seconds, 1e-6 to 1
     * @param steps number of steps, at least 1
     * @throws IllegalArgumentException if a value is out of range
     */
    public void step(float timeStep, int steps) {
        simulation.step(timeStep, steps);
    }

    /** The number of steps that were asked for. */
    long stepsMade() {
        return simulation.stepCount();
    }

    /**
     * Waits until all steps that were asked for have been made. It is for measuring alone: a step on an OpenCL device is only enqueued,
     * and each call that needs its result waits for it anyway.
     */
    public void finish() {
        simulation.finish();
    }

    // ---- reading

    /**
     * Reads x, y, radius and mass of every circle, in the order of the ids.
     *
     * @param circles takes four elements a circle
     * @throws IllegalArgumentException if the array is too short
     */
    public void read(float[] circles) {
        simulation.readings.read(circles);
    }

    /**
     * Reads x, y, radius and mass of every circle, in the order of the ids.
     *
     * @param circles takes four elements a circle from its position on; the position moves behind them
     * @throws IllegalArgumentException if too little remains of the buffer, or it is read-only
     */
    public void read(FloatBuffer circles) {
        simulation.readings.read(circles);
    }

    /**
     * Reads x, y, radius and mass of every circle by id: element 4 k is x of the circle with the {@link #id} k. So a circle stays
     * at its place in the array, whichever others are removed, and an array for the greatest number of circles serves for good:
     *
     * <pre>{@code
     * world.readById(circles, null);
     * float x = circles[4 * World.id(ball)];
     * }</pre>
     *
     * @param circles takes four elements an id, so it has at least 4 {@link #idLimit}. All of it is written: elements without a
     *     circle become NaN
     * @param living takes a bit for each id, 1 if there is such a circle: id k is bit k % 64 of element k / 64, in Java
     *     {@code living[k >> 6] >>> k & 1}. Further bits become 0. May be null
     * @throws IllegalArgumentException if an array is too short
     */
    public void readById(float[] circles, long[] living) {
        simulation.readings.readById(circles, living);
    }

    /**
     * Reads the velocity of every circle by id, as {@link #readById} does.
     *
     * @param velocities takes vx and vy of each id. All of it is written: elements without a circle become NaN
     * @param living takes a bit for each id, as with {@link #readById}; may be null
     * @throws IllegalArgumentException if an array is too short
     */
    public void readVelocitiesById(float[] velocities, long[] living) {
        simulation.readings.readVelocitiesById(velocities, living);
    }

    /**
     * Reads the angle of every circle by id, as {@link #readById} does.
     *
     * @param angles takes an element an id, radians anticlockwise from -pi to pi. All of it is written: elements without a circle become NaN
     * @param living takes a bit for each id, as with {@link #readById}; may be null
     * @throws IllegalArgumentException if an array is too short
     */
    public void readAnglesById(float[] angles, long[] living) {
        simulation.readings.readAnglesById(angles, living);
    }

    /** Reads angles by id in units of a turn's 2^-32; 0 where there is no circle. */
    void readAngleUnits(int[] units) {
        simulation.readings.readUnitsById(units);
    }

    /**
     * Reads the angular velocity of every circle by id, as {@link #readById} does.
     *
     * @param angularVelocities takes an element an id, radians per second anticlockwise. All of it is written: elements without a circle
     *     become NaN
     * @param living takes a bit for each id, as with {@link #readById}; may be null
     * @throws IllegalArgumentException if an array is too short
     */
    public void readAngularVelocitiesById(float[] angularVelocities, long[] living) {
        simulation.readings.readAngularVelocitiesById(angularVelocities, living);
    }

    /**
     * Reads the radius of every circle by id. It is known without a read-back, and waits for nothing.
     *
     * @param radii takes an element an id, so it has at least {@link #idLimit}. All of it is written: elements without a circle
     *     become NaN
     * @param living takes a bit for each id, as with {@link #readById}; may be null
     * @throws IllegalArgumentException if an array is too short
     */
    public void readRadiiById(float[] radii, long[] living) {
        simulation.readings.readRadiiById(radii, living);
    }

    /**
     * Reads the kind of every circle by id. It is known without a read-back, and waits for nothing.
     *
     * @param kinds takes an element an id, so it has at least {@link #idLimit}. All of it is written: elements without a circle
     *     become -1
     * @param living takes a bit for each id, as with {@link #readById}; may be null
     * @throws IllegalArgumentException if an array is too short
     */
    public void readKindsById(int[] kinds, long[] living) {
        simulation.readings.readKindsById(kinds, living);
    }

    /**
     * Reads the {@link #tag} of every circle by id. It is known without a read-back, and waits for nothing.
     *
     * @param tags takes an element an id, so it has at least {@link #idLimit}. All of it is written: elements without a circle
     *     become 0, as those of circles without a tag are
     * @param living takes a bit for each id, as with {@link #readById}; may be null
     * @throws IllegalArgumentException if an array is too short
     */
    public void readTagsById(long[] tags, long[] living) {
        simulation.readings.readTagsById(tags, living);
    }

    /**
     * Reads by id how hard every circle is pressed: by how many circles, walls, pieces of terrain and bodies (at each of their corners and sides), and the sum of the forces, without
     * their directions, by which these do so. Joints do not count. The forces are those at the end of the last step, from which the next one starts. They hold piles up. A
     * bounce is over at once, and does not count. The numbers are the same to the bit on every back end. The call copies the state, as
     * {@link #snapshot} does.
     *
     * @param loads takes two elements an id: the number of circles, walls, pieces and bodies that press the circle, and the sum of their forces, mass
     *     times length per second squared. All of it is written: elements without a circle become NaN
     * @param living takes a bit for each id, as with {@link #readById}; may be null
     * @throws IllegalArgumentException if an array is too short
     */
    public void readLoadsById(float[] loads, long[] living) {
        simulation.loads.readById(loads, living);
    }

    /**
     * Reads what presses a circle: other circles by id, then pieces of terrain by id, then {@link Bodies} by id (at each of their corners and sides), then walls. It is what the last step ended with, as {@link
     * #readLoadsById} counts it, so it needs no {@link #report}; normals and depths are those of now. A bounce is over at once, and does not
     * count. Sensors press nobody.
     *
     * <pre>{@code
     * long[] partners = new long[8];
     * float[] contacts = new float[8 * World.CONTACT_STRIDE];
     * boolean onTheGround = false;
     * for (int k = Math.min(8, world.contactsOf(hero, partners, contacts)) - 1; k >= 0; k--) {
     *     onTheGround |= contacts[World.CONTACT_STRIDE * k + World.NORMAL_Y] > 0.7f; // at most 45 degrees steep
     * }
     * }</pre>
     *
     * <p>The first call after a step or a change copies the state, as {@link #snapshot} does; others look through that copy. The numbers are
     * the same to the bit on every back end.
     *
     * @param circle a circle
     * @param partners takes the handles of circles, pieces and bodies ({@link #contains}, {@link Terrain#contains} and {@link Bodies#contains} tell
     *     them apart), and 0 for a wall; only the first ones if it is too short
     * @param contacts takes {@link #CONTACT_STRIDE} elements each, likewise; may be null
     * @return how many there are, which may be more than the arrays take
     * @throws IllegalArgumentException if the handle is stale
     */
    public int contactsOf(long circle, long[] partners, float[] contacts) {
        return simulation.contacts.of(circle, partners, contacts);
    }

    /**
     * Reads x and y of every circle by id, as {@link #readById} does, into the memory of {@link #positions}.
     *
     * @param living takes a bit for each id, as with {@link #readById}; may be null
     * @return two elements for each id less than {@link #idLimit}, NaN where there is no such circle, from position 0 to the limit.
     *     Read-only; the next call of this method or of {@link #positions} overwrites it
     * @throws IllegalArgumentException if the array is too short
     */
    public FloatBuffer positionsById(long[] living) {
        return simulation.readings.positionsById(living);
    }

    /**
     * Reads x and y of every circle, in the order of the ids, into memory of the world's own. That is the fastest way to what
     * a frame needs: on an OpenCL device the memory is page-locked if the driver can do it, and nothing is copied again.
     *
     * @return two elements a circle, from position 0 to the limit. Read-only, and often the same object: the next call of this
     *     method or of {@link #positionsById} overwrites what it shows, no other does. It may be kept beyond {@link #close()}.
     */
    public FloatBuffer positions() {
        return simulation.readings.positions();
    }

    /**
     * Reads the angle of every circle, in the order of the ids, into memory of the world's own: what a renderer needs beside {@link
     * #positions}.
     *
     * @return an element a circle, radians anticlockwise from -pi to pi, from position 0 to the limit. Read-only, and often the
     *     same object: the next call of this method overwrites what it shows, no other does
     */
    public FloatBuffer angles() {
        return simulation.readings.angles();
    }

    /**
     * Asks for x and y of every circle as they are now, without waiting for them: on an OpenCL device they are copied while the
     * next step runs. A game that draws one frame while the next is computed makes each frame so:
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
        simulation.readings.requestPositions();
    }

    /**
     * Gives the positions that {@link #requestPositions} asked for last, and waits for them if they are still on their way.
     * Each request can be taken once.
     *
     * @return two elements a circle, from position 0 to the limit, in memory of the world's own. Read-only, and valid until the
     *     second {@link #requestPositions} from now: the next one leaves it as it is. No other method touches it, and it may be
     *     kept beyond {@link #close()}.
     * @throws IllegalStateException if nothing has been requested since the last were taken
     */
    public FloatBuffer takePositions() {
        return simulation.readings.takePositions();
    }

    /**
     * Gives the positions that {@link #requestPositions} asked for last by id, in place of {@link #takePositions}. They are those of
     * the request, of the circles that are still there: a circle that has been removed since is not shown, even if a restore has
     * brought it back, nor is one that came since and has its id. So element 2 k is x of the circle that has the id k now, or NaN.
     *
     * @param living takes a bit for each id, 1 if its position is shown, as with {@link #readById}; may be null
     * @return two elements for each id less than {@link #idLimit} was at the request, in memory as that of {@link #takePositions}
     * @throws IllegalStateException if nothing has been requested since the last were taken
     * @throws IllegalArgumentException if the array is too short; the positions can still be taken
     */
    public FloatBuffer takePositionsById(long[] living) {
        return simulation.readings.takePositionsById(living);
    }

    /** A number that is another one after each request for positions. */
    int positionRequests() {
        return simulation.readings.requests();
    }

    /**
     * Makes values by id NaN that are not of the circles of the last request that are still there. living takes a bit for each circle of
     * now, and may be null.
     */
    void markGone(FloatBuffer values, int each, long[] living) {
        simulation.readings.markGone(values, each, living);
    }

    /** The least id, from one on, of a circle that came after the last request for positions; -1 if there is none. */
    int nextNew(int from) {
        return simulation.readings.nextNew(from);
    }

    /**
     * Reads the velocity of every circle, in the order of the ids.
     *
     * @param velocities takes vx and vy of each
     * @throws IllegalArgumentException if the array is too short
     */
    public void readVelocities(float[] velocities) {
        simulation.readings.readVelocities(velocities);
    }

    /**
     * Reads the velocity of every circle, in the order of the ids.
     *
     * @param velocities takes vx and vy of each from its position on; the position moves behind them
     * @throws IllegalArgumentException if too little remains of the buffer, or it is read-only
     */
    public void readVelocities(FloatBuffer velocities) {
        simulation.readings.readVelocities(velocities);
    }

    /**
     * Reads the handle of every circle, in the order of the ids.
     *
     * @param handles takes one element a circle
     * @throws IllegalArgumentException if the array is too short
     */
    public void readHandles(long[] handles) {
        simulation.readings.readHandles(handles);
    }

    /**
     * Reads the handle of every circle, in the order of the ids.
     *
     * @param handles takes one element a circle from its position on; the position moves behind them
     * @throws IllegalArgumentException if too little remains of the buffer, or it is read-only
     */
    public void readHandles(LongBuffer handles) {
        simulation.readings.readHandles(handles);
    }

    /**
     * Whether a circle is awake. Static circles never sleep.
     *
     * @param handle the circle
     * @return false if it sleeps
     * @throws IllegalArgumentException if the handle is stale
     */
    public boolean isAwake(long handle) {
        return simulation.readings.isAwake(handle);
    }

    /**
     * Says of all circles which are awake. Static circles never sleep.
     *
     * @param awake gets a bit an id, from bit 0 of element 0 on: 1 if there is a circle and it does not sleep; room for {@link #idLimit()} bits
     * @throws IllegalArgumentException if there is not so much room
     */
    public void readAwakeById(long[] awake) {
        simulation.readings.readAwakeById(awake);
    }

    /**
     * Reads one coordinate of one circle. The first such read after a step or a change reads all circles
     * back; the others are answered from that.
     *
     * @param handle the circle
     * @return x of its centre
     * @throws IllegalArgumentException if the handle is stale
     */
    public float x(long handle) {
        return simulation.readings.circle(handle, CircleRow.X);
    }

    /**
     * Reads one coordinate of one circle; see {@link #x}.
     *
     * @param handle the circle
     * @return y of its centre
     * @throws IllegalArgumentException if the handle is stale
     */
    public float y(long handle) {
        return simulation.readings.circle(handle, CircleRow.Y);
    }

    /**
     * Reads the radius of one circle; see {@link #x}.
     *
     * @param handle the circle
     * @return its radius
     * @throws IllegalArgumentException if the handle is stale
     */
    public float radius(long handle) {
        return simulation.readings.circle(handle, CircleRow.RADIUS);
    }

    /**
     * Reads the mass of one circle; see {@link #x}.
     *
     * @param handle the circle
     * @return its mass; positive infinity for a static circle
     * @throws IllegalArgumentException if the handle is stale
     */
    public float mass(long handle) {
        return simulation.readings.circle(handle, CircleRow.MASS);
    }

    /**
     * Reads one component of the velocity of one circle; see {@link #x}.
     *
     * @param handle the circle
     * @return its velocity along x
     * @throws IllegalArgumentException if the handle is stale
     */
    public float vx(long handle) {
        return simulation.readings.vx(handle);
    }

    /**
     * Reads one component of the velocity of one circle; see {@link #x}.
     *
     * @param handle the circle
     * @return its velocity along y
     * @throws IllegalArgumentException if the handle is stale
     */
    public float vy(long handle) {
        return simulation.readings.vy(handle);
    }

    /**
     * Reads the angle of one circle; see {@link #x}.
     *
     * @param handle the circle
     * @return radians anticlockwise, from -pi to pi; 0 at first
     * @throws IllegalArgumentException if the handle is stale
     */
    public float angle(long handle) {
        return simulation.readings.angle(handle);
    }

    /**
     * Reads the angular velocity of one circle; see {@link #x}.
     *
     * @param handle the circle
     * @return radians per second anticlockwise; 0 at first
     * @throws IllegalArgumentException if the handle is stale
     */
    public float angularVelocity(long handle) {
        return simulation.readings.angularVelocity(handle);
    }

    /**
     * The restitution of one circle. It is known without a read-back.
     *
     * @param handle the circle
     * @return 0 (inelastic) to 1 (elastic)
     * @throws IllegalArgumentException if the handle is stale
     */
    public float restitution(long handle) {
        return simulation.circles.restitution(handle);
    }

    /**
     * In how many steps a circle has the radius that {@link #grow} has asked for. It is known without a read-back.
     *
     * @param handle the circle
     * @return the steps left; 0 if it does not grow or shrink
     * @throws IllegalArgumentException if the handle is stale
     */
    public int growthSteps(long handle) {
        return simulation.growth.steps(handle);
    }

    /**
     * The force that is set for a circle, along x. It is known without a read-back.
     *
     * @param handle the circle
     * @return the force; 0 at first
     * @throws IllegalArgumentException if the handle is stale
     */
    public float forceX(long handle) {
        return simulation.fields.force(CircleField.FORCE_X, handle);
    }

    /**
     * The force that is set for a circle, along y. It is known without a read-back.
     *
     * @param handle the circle
     * @return the force; 0 at first
     * @throws IllegalArgumentException if the handle is stale
     */
    public float forceY(long handle) {
        return simulation.fields.force(CircleField.FORCE_Y, handle);
    }

    /**
     * The torque that is set for a circle. It is known without a read-back.
     *
     * @param handle the circle
     * @return the torque; 0 at first
     * @throws IllegalArgumentException if the handle is stale
     */
    public float torque(long handle) {
        return simulation.fields.force(CircleField.TORQUE, handle);
    }

    /**
     * The friction of one circle: its own, else that of its kind, else the world's. It is known without a read-back.
     *
     * @param handle the circle
     * @return 0 to 1,000
     * @throws IllegalArgumentException if the handle is stale
     */
    public float friction(long handle) {
        return simulation.fields.own(CircleField.FRICTION, handle);
    }

    /**
     * The rolling resistance of one circle: its own, else that of its kind, else the world's. It is known without a read-back.
     *
     * @param handle the circle
     * @return 0 to 1,000
     * @throws IllegalArgumentException if the handle is stale
     */
    public float rollingResistance(long handle) {
        return simulation.fields.own(CircleField.ROLLING_RESISTANCE, handle);
    }

    /**
     * The factor of gravity of one circle: its own, else that of its kind. It is known without a read-back.
     *
     * @param handle the circle
     * @return -1000 to 1000
     * @throws IllegalArgumentException if the handle is stale
     */
    public float gravityScale(long handle) {
        return simulation.fields.own(CircleField.GRAVITY_SCALE, handle);
    }

    /**
     * How fast one circle loses its velocity: its own damping, else that of its kind. It is known without a read-back.
     *
     * @param handle the circle
     * @return per second, 0 to 1e6
     * @throws IllegalArgumentException if the handle is stale
     */
    public float damping(long handle) {
        return simulation.fields.own(CircleField.DAMPING, handle);
    }

    /**
     * The greatest speed of one circle: its own, else that of its kind. It is known without a read-back.
     *
     * @param handle the circle
     * @return lengths per second, at least 0; perhaps infinite
     * @throws IllegalArgumentException if the handle is stale
     */
    public float greatestSpeed(long handle) {
        return simulation.fields.own(CircleField.GREATEST_SPEED, handle);
    }

    /**
     * The number that the caller has given a circle. It is known without a read-back.
     *
     * @param handle the circle
     * @return the number set last, or 0
     * @throws IllegalArgumentException if the handle is stale
     */
    public long tag(long handle) {
        return simulation.fields.get(CircleField.TAG, handle);
    }

    /**
     * The kind of a circle. It is known without a read-back.
     *
     * @param handle the circle
     * @return the number of its kind, 0 to 255
     * @throws IllegalArgumentException if the handle is stale
     */
    public int kindOf(long handle) {
        return (int) simulation.fields.get(CircleField.KIND, handle);
    }

    /**
     * The exclusion group of a circle. It is known without a read-back.
     *
     * @param handle the circle
     * @return the number of the group; 0 for none
     * @throws IllegalArgumentException if the handle is stale
     */
    public int group(long handle) {
        return (int) simulation.fields.get(CircleField.GROUP, handle);
    }

    /**
     * {@return the terrain, always the same object: what circles lie on, roll along and bounce off besides walls and each other} It has no pieces at
     * first. Its calls follow the rules of this class.
     */
    public Terrain terrain() {
        simulation.check();
        return terrain;
    }

    /**
     * {@return the joints, always the same object: what holds circles to each other, to places, to bodies of terrain, or makes them turn} There are
     * none at first.
     */
    public Joints joints() {
        simulation.check();
        return joints;
    }

    /** {@return the bodies that are pushed, always the same object: boxes, capsules, any outline} There are none at first. */
    public Bodies bodies() {
        simulation.check();
        return bodies;
    }

    /**
     * {@return questions about where circles are, always the same object: overlaps, the circle at a point, the nearest ones, rays and casts} Its
     * calls follow the rules of this class.
     */
    public Queries queries() {
        simulation.searches.requireOpen();
        return queries;
    }

    /**
     * A hash of the state: of every circle, its tag too, of the impulses that the next step starts from, of the kinds, of terrain, of joints and of bodies. Equal states
     * have equal hashes, whatever they were computed on. The hash also has the way that walls have to go in the next step, and the
     * settings of contacts and surfaces that are not the defaults. It lacks the other settings of the world as a whole (bounds, gravity,
     * sub-steps, restitution of circles to come) and the handles that are stale. Compare two snapshots if these count, too.
     *
     * @return 64 bits
     */
    public long hash() {
        return simulation.hash();
    }

    /**
     * {@return the size of the world, its back end, and the work of the last step, as of now} Waits for the device, and takes about as long as a
     * read: a call a second is fine, one a frame is not.
     */
    public WorldStats stats() {
        Simulation.Figures figures = simulation.figures();
        return new WorldStats(
                figures.circles(),
                figures.candidatePairs(),
                figures.contacts(),
                figures.greatestContacts(),
                figures.awake(),
                figures.bodies(),
                figures.awakeBodies(),
                figures.bodyContacts(),
                figures.bytesHeld(),
                figures.stageMillis(),
                running != null && running.isAway() ? Backend.OPENCL_GPU : backend,
                figures.device(),
                running == null ? reason : running.reason(),
                running == null ? 0 : running.moves(),
                running == null ? 0 : running.moveMillis());
    }

    // ---- events

    /**
     * Sets the types of events that {@link #events} reports of all circles, and of circles and pieces of {@link Terrain}, from the next step on,
     * in place of all earlier calls. By default a world reports nothing, which costs nothing. The reported types change no step, and are in no snapshot and no log: call
     * this again in a world that restores or replays. ({@link Rollback} brings them back.) If a pair touches already, its begin comes
     * with the first step that reports it.
     *
     * <p>Steps that report take longer: docs/guide.md has the costs in its chapter on events, and the ways to lower them.
     *
     * @param types the sum of some of {@link Events#BEGIN}, {@link Events#HIT}, {@link Events#END}, and {@link Events#WALL} if walls
     *     count too, which alone reports nothing; 0 for nothing
     * @throws IllegalArgumentException if there are other types
     */
    public void report(int types) {
        simulation.reports.report(types);
    }

    /**
     * Sets the types of events that {@link #events} reports of two kinds, of circles or of a circle and a piece of {@link Terrain}, from the next
     * step on, in place of those that {@link #report(int)} has set for all. A later call of {@link #report(int)} replaces them. Pairs that only sense each
     * other report {@link Events#BEGIN} and {@link Events#END}, and never {@link Events#HIT}. While no circle is of a kind that is
     * reported, a step takes no longer.
     *
     * @param kindA the number of a kind, 0 to 255
     * @param kindB the number of another kind, or of the same; which of them comes first does not matter
     * @param types the sum of some of {@link Events#BEGIN}, {@link Events#HIT} and {@link Events#END}; 0 for nothing
     * @throws IllegalArgumentException if there is no such kind, or there are other types
     */
    public void report(int kindA, int kindB, int types) {
        simulation.reports.report(kindA, kindB, types);
    }

    /**
     * Sets the types of events that {@link #events} reports of the circles of a kind and walls, from the next step on, in place of those
     * that {@link #report(int)} has set for all circles.
     *
     * @param kind the number of a kind, 0 to 255
     * @param types the sum of some of {@link Events#BEGIN}, {@link Events#HIT} and {@link Events#END}; 0 for nothing
     * @throws IllegalArgumentException if there is no such kind, or there are other types
     */
    public void reportWalls(int kind, int types) {
        simulation.reports.reportWalls(kind, types);
    }

    /**
     * Lists the pairs of circles of two kinds that touch: that have begun and not ended, by the rules of {@link Events}. It lists only
     * pairs of which the world reports some type of event.
     *
     * @param kindA the number of a kind, 0 to 255
     * @param kindB the number of another kind, or of the same
     * @param handles takes two handles a pair, first that of the circle of kindA; of one kind, that of the lower id. Pairs are in the
     *     order of their lower ids, then of the higher. If it is too short, it takes the first of them
     * @return how many pairs there are, which may be more than the array takes
     * @throws IllegalArgumentException if there is no such kind
     */
    public int touching(int kindA, int kindB, long[] handles) {
        return simulation.reports.touching(kindA, kindB, handles);
    }

    /**
     * Lists the pairs of a circle of a kind and a piece of {@link Terrain} of a kind that touch, as {@link #touching} does of circles: so it
     * says who is in a gate that senses.
     *
     * @param kind the number of the kind of the circles
     * @param kindOfPieces the number of the kind of the pieces
     * @param handles takes two handles a pair, first that of the circle, then that of the piece. Pairs are in the order of the circles' ids, then
     *     of the pieces'. If it is too short, it takes the first of them
     * @return how many pairs there are, which may be more than the array takes
     * @throws IllegalArgumentException if there is no such kind
     */
    public int touchingPieces(int kind, int kindOfPieces, long[] handles) {
        return simulation.reports.touchingPieces(kind, kindOfPieces, handles);
    }

    /**
     * Sets the approach speed from which on a hit is reported. By default it depends on the pair: a hit is faster than
     * sqrt(0.16 g r + c^2), up to which circles of a restitution below 0.9 do not bounce (see the class), or than
     * {@link Builder#restitutionThreshold}, if that is set. g is gravity (at a wall its component along that axis), r is the mean radius
     * of the pair, and c is r per second. So nothing in a pile at rest is a hit. Like the reported types, the hit speed is in no snapshot
     * and no log.
     *
     * @param speed lengths per second, from 0 to 1e9
     * @throws IllegalArgumentException if the value is out of range
     */
    public void setHitSpeed(float speed) {
        simulation.reports.setHitSpeed(speed);
    }

    /**
     * {@return the events of all steps since the last call of this method, or since {@link #restore}: always the same object, which the next call
     * fills again} Call it often while the world reports: all events are kept until then.
     */
    public Events events() {
        return events.of(simulation.reports.take());
    }

    /**
     * Asks for the events of all steps so far that have not been taken, without waiting for these steps. On an OpenCL device the next
     * step hands the events over before it begins, so a later {@link #takeEvents} waits for no step.
     *
     * <pre>{@code
     * world.requestEvents();
     * world.step(1 / 60f);
     * play(world.takeEvents()); // of the steps before
     * }</pre>
     *
     * <p>A request that has not been taken is replaced by the next, which has its events too; {@link #events} takes all events, and leaves
     * no request.
     */
    public void requestEvents() {
        simulation.reports.request();
    }

    /**
     * Gives the events that {@link #requestEvents} asked for last, and waits for them if they are still on their way. Those of later
     * steps stay, and number their steps from the request on.
     *
     * @return always the same object, which the next call of this method or of {@link #events} fills again
     * @throws IllegalStateException if nothing has been requested since the last were taken
     */
    public Events takeEvents() {
        return events.of(simulation.reports.takeRequested());
    }

    // ---- snapshots

    /**
     * The number of bytes that {@link #snapshot} would write now.
     *
     * @return about 50 a circle, if few circles were removed, and about 25 a piece of terrain
     * @throws IllegalStateException if it is more than one buffer holds
     */
    public int snapshotBytes() {
        return simulation.snapshots.bytes();
    }

    /**
     * Writes all that decides this world's future: circles, handles, the impulses that the next step starts from, kinds, terrain, joints,
     * bounds, gravity, restitution, sub-steps, contact settings and surfaces; and, if the world reports events, the pairs that touch. Equal
     * states give equal bytes, on every back end.
     *
     * <pre>{@code
     * ByteBuffer saved = ByteBuffer.allocate(world.snapshotBytes());
     * world.snapshot(saved);
     * saved.flip(); // so that it is read from its beginning
     * world.restore(saved);
     * }</pre>
     *
     * @param to takes {@link #snapshotBytes} bytes from its position on; the position moves behind them. Its byte order does not
     *     matter
     * @throws IllegalArgumentException if too little remains of the buffer, or it is read-only
     * @throws IllegalStateException if the snapshot is more than one buffer holds
     */
    public void snapshot(ByteBuffer to) {
        simulation.snapshots.write(to);
    }

    /**
     * Gives this world the state of a snapshot, in place of its own. The same calls from here on lead to the same bits as in the world
     * that the snapshot was taken from, on any back end. Handles of that world are valid in this one. The reported types stay as they
     * are, and events that have not been taken are dropped. Pairs that touched then do not begin again, if that world reported them and
     * this one does: call {@link #report} before this.
     *
     * @param from a snapshot from its position on; the position moves behind it. Its byte order does not matter
     * @throws IllegalArgumentException if the bytes are no snapshot, or are damaged or cut off; world and buffer are then as
     *     before
     */
    public void restore(ByteBuffer from) {
        simulation.snapshots.restore(from);
    }

    /**
     * Ends the world and gives its memory, threads and devices back. Closing it again does nothing, unless an error has cut the
     * first call short. The threads of a world that is never closed do not keep the virtual machine running. They end some time after
     * the program has dropped the world.
     */
    @Override
    public void close() {
        simulation.close();
    }

    /** Describes a world. Every parameter has a default; each is checked when it is given. */
    public static final class Builder {
        private Bounds bounds = new Bounds(0, 0, 1, 1);
        private AxisEdge edgeX = AxisEdge.WALL;
        private AxisEdge edgeY = AxisEdge.WALL;
        private float gravityX;
        private float gravityY;
        private float restitution = 0.5f;
        private int subSteps = 4;
        private ContactSettings contacts = ContactSettings.DEFAULT;
        private float friction;
        private float rollingResistance;
        private boolean sleep;

        /** Three floats for each wall, as {@link World#setWallSurface} takes them; NaN for those that follow the circles. */
        private final float[] walls = new float[3 * Wall.values().length];

        private final BackendWish wish = new BackendWish();

        private Builder() {
            Arrays.fill(walls, Float.NaN);
        }

        private SurfaceSettings surfaces() {
            SurfaceSettings settings = SurfaceSettings.NONE.ofCircles(friction, rollingResistance);
            for (int wall = 0; 3 * wall < walls.length; wall++) {
                int at = 3 * wall;
                settings = Float.isNaN(walls[at])
                        ? settings.withWall(wall, friction, rollingResistance, 0)
                        : settings.withWall(
                                wall, walls[at], walls[at + 1], SurfaceSettings.beltOfWall(wall, walls[at + 2]));
            }
            return settings.any() ? settings : SurfaceSettings.NONE;
        }

        private Bounds arena() {
            return bounds.with(edgeX, edgeY);
        }

        static int defaultThreads() {
            return defaultThreads(Runtime.getRuntime().availableProcessors(), isAndroid());
        }

        static boolean isAndroid() {
            return "Dalvik".equals(System.getProperty("java.vm.name"));
        }

        /** A phone has slow processors besides its fast ones, and threads that wait at a barrier drain its battery. */
        static int defaultThreads(int processors, boolean android) {
            return Math.min(processors, android ? 2 : 16);
        }

        /**
         * The bounds: where the walls are. By default the unit square.
         *
         * @param minX left wall
         * @param minY lower wall
         * @param maxX right wall
         * @param maxY upper wall
         * @return this
         * @throws IllegalArgumentException if a value is out of range
         */
        public Builder bounds(float minX, float minY, float maxX, float maxY) {
            bounds = Limits.bounds(minX, minY, maxX, maxY);
            return this;
        }

        /**
         * The ends of each axis: walls, nothing, or each other. By default walls.
         *
         * <p>Along an open axis the bounds are no limit. Circles go on to coordinates of 1e9 in magnitude, and bounce there as
         * off a wall, of which no event tells. Keep circles nearer than 2^17 of their radii: farther out coordinates are too
         * coarse for them to touch exactly. Nothing else changes out there, and no step takes longer.
         *
         * <p>Along an axis that wraps, coordinates are from the least one of the bounds to less than the greatest. A position
         * that a caller gives may be anywhere up to 1e9 in magnitude, and is brought inside. Circles meet across the seam, and
         * static ones that travel take the short way round. A radius is at most an eleventh of the extent, which {@link #bounds}
         * must make at least 2^-14 of the greatest coordinate. In one step no circle moves farther than an eighth of the extent: a
         * faster one is held up. A static one that travels farther arrives, but pushes only the circles that it meets on that part of
         * its way.
         *
         * <p>The edges are in snapshots; a world that restores one has its edges from then on.
         *
         * @param x of the left and the right edge
         * @param y of the lower and the upper edge
         * @return this
         */
        public Builder edges(Edge x, Edge y) {
            edgeX = AxisEdge.values()[Limits.notNull("x", x).ordinal()];
            edgeY = AxisEdge.values()[Limits.notNull("y", y).ordinal()];
            return this;
        }

        /**
         * Gravity. By default none.
         *
         * @param x acceleration along x, lengths per second squared, up to 1e9 in magnitude
         * @param y acceleration along y, likewise; negative downwards
         * @return this
         * @throws IllegalArgumentException if a value is out of range
         */
        public Builder gravity(float x, float y) {
            gravityX = Limits.within("gravity x", x, -Limits.SPEED, Limits.SPEED);
            gravityY = Limits.within("gravity y", y, -Limits.SPEED, Limits.SPEED);
            return this;
        }

        /**
         * The restitution that new circles get. By default 0.5. {@link World} says which impacts are too slow to bounce.
         *
         * @param restitution 0 (inelastic) to 1 (elastic)
         * @return this
         * @throws IllegalArgumentException if the value is out of range
         */
        public Builder restitution(float restitution) {
            this.restitution = Limits.restitution(restitution);
            return this;
        }

        /**
         * The friction of circles, and of the walls for which {@link #wallSurface} says nothing. By default 0. {@link Kind#setFriction} and
         * {@link World#setFriction} give circles another. {@link World} says what a pair has.
         *
         * @param friction 0 (slides) to 1,000
         * @return this
         * @throws IllegalArgumentException if the value is out of range
         */
        public Builder friction(float friction) {
            this.friction = Limits.friction(friction);
            return this;
        }

        /**
         * The rolling resistance of circles, and of the walls for which {@link #wallSurface} says nothing. By default 0. {@link
         * Kind#setRollingResistance} and {@link World#setRollingResistance} give circles another.
         *
         * @param resistance 0 (rolls on) to 1,000
         * @return this
         * @throws IllegalArgumentException if the value is out of range
         */
        public Builder rollingResistance(float resistance) {
            rollingResistance = Limits.rollingResistance(resistance);
            return this;
        }

        /**
         * Lets circles and bodies that lie still fall asleep, and wake when something moves them: steps then cost what is awake, not what there is. By
         * default false. A circle falls asleep if it has hardly moved for a second. It wakes when something is about to push it, when it loses
         * what carries it, when gravity or its force change, or a call changes it. Until then its velocity is 0. {@link
         * Kind#setSleeps} keeps circles of a kind awake; those that a motor drives, that grow or have a torque never sleep, nor do any without
         * gravity and damping. The guide's chapter on sleep says more. Devices make the same steps, but cost about what they cost without sleep unless all sleep.
         *
         * @param sleep true if circles may fall asleep
         * @return this
         */
        public Builder sleep(boolean sleep) {
            this.sleep = sleep;
            return this;
        }

        /**
         * The surface of a wall, in place of {@link #friction} and {@link #rollingResistance}; {@link World#setWallSurface} changes it
         * later.
         *
         * @param wall which wall
         * @param friction 0 to 1,000
         * @param rollingResistance 0 to 1,000
         * @param beltSpeed speed of the surface along the wall, lengths per second, up to 1e9 in magnitude, with the sign of {@link
         *     World#setWallSurface}
         * @return this
         * @throws IllegalArgumentException if a value is out of range
         */
        public Builder wallSurface(Wall wall, float friction, float rollingResistance, float beltSpeed) {
            int at = 3 * Limits.notNull("wall", wall).ordinal();
            float itsFriction = Limits.friction(friction);
            float itsResistance = Limits.rollingResistance(rollingResistance);
            walls[at + 2] = Limits.beltSpeed(beltSpeed);
            walls[at + 1] = itsResistance;
            walls[at] = itsFriction;
            return this;
        }

        /**
         * Sub-steps per step: more solve contacts more exactly and take more time. By default 4. Contacts have their full stiffness
         * if a sub-step is at most 1/223 second long, as a quarter of 1/60 second is.
         *
         * @param subSteps 1 to 16
         * @return this
         * @throws IllegalArgumentException if the value is out of range
         */
        public Builder subSteps(int subSteps) {
            this.subSteps = Limits.within("the number of sub-steps", subSteps, 1, Limits.SUB_STEPS);
            return this;
        }

        /**
         * The normal speed up to which impacts do not bounce, the same for all circles, elastic ones too, and for walls. At 0 all
         * impacts bounce, and piles of circles with a restitution take long to rest. By default it follows from gravity, radii and
         * restitutions, as {@link World} says. A back end by OpenCL compiles its kernels again for another value.
         *
         * @param speed lengths per second, 0 to 1e9
         * @return this
         * @throws IllegalArgumentException if the value is out of range
         */
        public Builder restitutionThreshold(float speed) {
            contacts = contacts.withRestitutionThreshold(
                    Limits.within("the restitution threshold", speed, 0, Limits.SPEED));
            return this;
        }

        /**
         * The stiffness of contacts, as the frequency of a spring; walls have twice as much. Softer contacts let piles sink in. By
         * default 67. Its product with the length of a sub-step counts as at most 0.3, since stiffer contacts tremble. So with four
         * sub-steps in a sixtieth of a second, frequencies over 72 Hz count as 72.
         *
         * @param hertz 1 to 10,000
         * @return this
         * @throws IllegalArgumentException if the value is out of range
         */
        public Builder contactFrequency(float hertz) {
            contacts = contacts.withFrequency(hertz);
            return this;
        }

        /**
         * The damping ratio of contacts and walls: overlaps swing below 1, and shrink the more slowly the greater it is. By default
         * 20, with which piles rest soonest.
         *
         * @param ratio 0 to 1,000
         * @return this
         * @throws IllegalArgumentException if the value is out of range
         */
        public Builder contactDamping(float ratio) {
            contacts = contacts.withDamping(ratio);
            return this;
        }

        /**
         * The greatest speed at which overlaps of up to 0.4 mean radii of the pair are pushed out; deeper ones are pushed out faster,
         * in the same proportion as by default. By default 0.8. A slow one keeps crowds calm in which many circles grow at once. A fast
         * one soon separates circles, but crowds without room may boil: a pair that carries a load bounces only if its overlap is less
         * than the length by which it is pushed out in a fortieth of a second. A back end by OpenCL compiles its kernels again for
         * another value.
         *
         * @param speed mean radii of the pair a second, 0 to 100
         * @return this
         * @throws IllegalArgumentException if the value is out of range
         */
        public Builder greatestPushOutSpeed(float speed) {
            contacts = contacts.withPushOutSpeed(speed);
            return this;
        }

        /**
         * The back end to run on. By default {@link Backend#AUTO}.
         *
         * @param backend the back end
         * @return this
         */
        public Builder backend(Backend backend) {
            wish.backend = Limits.notNull("backend", backend);
            wish.device = null;
            return this;
        }

        /**
         * The OpenCL device to run on, if there are several; instead of a back end.
         *
         * @param device one of {@link io.github.circles2d.opencl.OpenCl#devices}
         * @return this
         */
        public Builder device(Device device) {
            wish.device = Limits.notNull("device", device);
            return this;
        }

        /**
         * Threads of the JVM back end, the caller's included. By default one a processor, at most 16, and on Android at most 2. They
         * have no effect on results. In a browser there is one, whatever the number.
         *
         * @param threads 1 to 256
         * @return this
         * @throws IllegalArgumentException if the value is out of range
         */
        public Builder threads(int threads) {
            wish.threads = Limits.within("the number of threads", threads, 1, Limits.THREADS);
            return this;
        }

        /**
         * How many circles to make room for at once. By default 1,024. A world grows by itself; this saves it the growing, and tells
         * {@link Backend#AUTO} that a GPU may be of use before the circles are there.
         *
         * @param capacity number of circles, at least 0
         * @return this
         * @throws IllegalArgumentException if the value is out of range
         */
        public Builder capacity(int capacity) {
            wish.capacity = Limits.within("the capacity", capacity, 0, Limits.CIRCLES);
            return this;
        }

        /**
         * Whether to measure the time of each stage. By default not.
         *
         * @param profiling true to measure
         * @return this
         */
        public Builder profiling(boolean profiling) {
            wish.profiling = profiling;
            return this;
        }

        /**
         * Whether a world of {@link Backend#AUTO} moves between the JVM and a GPU while it runs. By default it does: it starts at once on the JVM,
         * and goes to a GPU when kernels have been compiled and frames are shorter there. One that does not move takes its back end when
         * it is built, and a GPU's first step waits for kernels. No result depends on it.
         *
         * @param moving false to stay
         * @return this
         */
        public Builder moving(boolean moving) {
            wish.moving = moving;
            return this;
        }

        /**
         * Builds the world.
         *
         * @return an empty world; close it after use
         * @throws OpenClUnavailableException if an OpenCL back end is asked for and there is no such device; the message says
         *     what is missing and what to install
         * @throws OpenClException if an OpenCL back end is asked for and its driver refuses, or memory is short
         */
        public World build() {
            Limits.edges(arena()); // before anything is opened
            return new World(this, BackendChoice.of(wish));
        }
    }
}
