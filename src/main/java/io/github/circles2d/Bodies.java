package io.github.circles2d;

import io.github.circles2d.world.Simulation;
import io.github.circles2d.world.bodies.OutlineShape;
import io.github.circles2d.world.bodies.RigidExtras;
import io.github.circles2d.world.bodies.RigidStep;
import io.github.circles2d.world.bodies.RigidTable;
import io.github.circles2d.world.circles.Handle;
import io.github.circles2d.world.model.Limits;
import io.github.circles2d.world.model.Surface;
import io.github.circles2d.world.reads.RigidReads;
import io.github.circles2d.world.shared.Call;

/**
 * The bodies of a {@link World} that are pushed: boxes, capsules, gears, any {@link Outline}. They fall, turn, and push each other, circles, and
 * are stopped by walls and terrain. {@link World#bodies} gives this object.
 *
 * <pre>{@code
 * Outline crate = Outline.box(1, 1);
 * long body = world.bodies().add(crate, 10, 20, 0, 2 * crate.area()); // 2 is the density
 * world.bodies().applyImpulse(body, 5, 0, 10, 20.4f); // near its top, so that it tips
 * }</pre>
 *
 * <p><b>Place:</b> a body is where the centroid of its outline is, and turns around it. Along an axis with walls the centroid is within the
 * bounds; along an axis that wraps it is brought inside.
 *
 * <p><b>Handles</b> are as those of circles: longs, never 0, stale once the body has gone. No body has the handle of a circle, a joint, or a body
 * of {@link Terrain}: a call that gets one for the other refuses it. Bodies of terrain are another thing: they move as they are told, and
 * nothing stops them.
 *
 * <p><b>No body is static:</b> what stands still, or moves as the game says, is {@link Terrain}. A {@link Joint#pin} to a place of the world holds a body there, which
 * then turns; two pins hold it still.
 *
 * <p><b>Kinds</b> are those of circles ({@link World#kind}): which kinds meet, gravity, damping and angular damping, greatest speed, restitution,
 * friction, rolling resistance, belt and sleep, but not {@link Kind#setInertia}: see {@link #setInertia}. Gravity scale, damping, greatest speed
 * and friction of one body alone are those of a kind of its own. A body of a sensor ({@link Kind#setSensor}, {@link Response#SENSE}) pushes nothing but walls and notices bodies, circles and
 * pieces of terrain, and these notice bodies likewise: {@link BodyEvents} tells of it, and {@link #touching} lists who is there. {@link World#contactsOf}
 * names the bodies that press a circle.
 *
 * <p><b>Masses</b> of bodies that touch may differ as 1 to 100. Beyond that heavy ones sink into light ones.
 *
 * <p><b>New:</b> bodies that fly 40 of their widths a second past others are not right yet; the guide has the list.
 *
 * <p><b>On devices</b> the host makes the bodies' part of a step, and waits for the device in each sub-step if circles touch bodies. Bodies
 * {@linkplain World.Builder#sleep sleep} as circles do. {@link Queries#bodies} finds bodies, {@link World#joints} hold them.
 *
 * <p><b>Limits:</b> a world has at most 65,536 bodies. A world without bodies pays nothing for this. A change acts from the next step on. Bodies are in
 * snapshots, in logs and in the hash. The rules of {@link World} for threads, failures and closed worlds hold here, too.
 */
public final class Bodies {
    private final Simulation simulation;
    private final RigidReads reads;
    private final RigidTable table;
    private final RigidStep step;
    private final BodyEvents events = new BodyEvents();

    Bodies(Simulation simulation) {
        this.simulation = simulation;
        reads = simulation.rigidReads;
        table = reads.table;
        step = reads.step;
    }

    private int require(long body) {
        return reads.require(body);
    }

    // ---- bodies come and go

    /**
     * Adds a body at rest, of kind 0.
     *
     * @param outline what it looks like; many bodies may have one
     * @param x x of its centroid, within the bounds along an axis with walls, else up to 1e9 in magnitude
     * @param y y of it, likewise
     * @param angle how far it is turned from how the outline lies, radians anticlockwise, up to 1e6 in magnitude
     * @param mass from 1e-9 to 1e9, not infinite; a density times {@link Outline#area}
     * @return the handle of the body
     * @throws IllegalArgumentException if a value is out of range; if the outline reaches from its centroid further than a radius may be in these bounds, or
     *     less far; or if there are 65,536 bodies
     */
    public long add(Outline outline, float x, float y, float angle, float mass) {
        return add(outline, x, y, angle, mass, 0);
    }

    /**
     * Adds a body at rest. Its restitution is that of its kind, else the world's.
     *
     * @param outline what it looks like; many bodies may have one
     * @param x x of its centroid, within the bounds along an axis with walls, else up to 1e9 in magnitude
     * @param y y of it, likewise
     * @param angle how far it is turned from how the outline lies, radians anticlockwise, up to 1e6 in magnitude
     * @param mass from 1e-9 to 1e9, not infinite; a density times {@link Outline#area}
     * @param kind the number of its kind, 0 to 255
     * @return the handle of the body
     * @throws IllegalArgumentException as {@link #add(Outline, float, float, float, float)}, or if there is no such kind
     */
    public long add(Outline outline, float x, float y, float angle, float mass, int kind) {
        return simulation.rigids.add(Limits.notNull("outline", outline).shape(), x, y, angle, mass, kind);
    }

    /**
     * Adds many bodies at rest of one outline: all of them, or none if one is refused.
     *
     * @param outline what they look like
     * @param bodies x, y, the angle in radians and the mass of one after the other, as with {@link #add(Outline, float, float, float, float)}
     * @param kinds the number of the kind of each, 0 to 255; may be null, for bodies of kind 0
     * @param handles takes the handle of each; at least as many elements as there are bodies; may be null
     * @throws IllegalArgumentException as {@link #add(Outline, float, float, float, float, int)} (the message has the number of the body), or if an
     *     array has the wrong length
     */
    public void addAll(Outline outline, float[] bodies, int[] kinds, long[] handles) {
        OutlineShape[] shapes = {Limits.notNull("outline", outline).shape()};
        simulation.rigidBulk.addAll(shapes, false, bodies, kinds, handles);
    }

    /**
     * Adds many bodies at rest, each of its outline: all of them, or none if one is refused.
     *
     * @param outlines what each looks like
     * @param bodies x, y, the angle in radians and the mass of one after the other, as with {@link #add(Outline, float, float, float, float)}
     * @param kinds the number of the kind of each, 0 to 255; may be null, for bodies of kind 0
     * @param handles takes the handle of each; at least as many elements as there are bodies; may be null
     * @throws IllegalArgumentException as {@link #addAll(Outline, float[], int[], long[])}
     * @throws NullPointerException if an outline is null (the message has its number)
     */
    public void addAll(Outline[] outlines, float[] bodies, int[] kinds, long[] handles) {
        OutlineShape[] shapes = new OutlineShape[Limits.notNull("outlines", outlines).length];
        for (int i = 0; i < shapes.length; i++) {
            Outline outline = outlines[i];
            if (outline == null) {
                throw new NullPointerException("outline " + i + " must not be null");
            }
            shapes[i] = outline.shape();
        }
        simulation.rigidBulk.addAll(shapes, true, bodies, kinds, handles);
    }

    /**
     * Removes a body.
     *
     * @param body the handle of a body
     * @throws IllegalArgumentException if the body has gone, or the handle is none
     */
    public void remove(long body) {
        simulation.calls.change(Call.REMOVE_RIGID, body);
    }

    /**
     * Removes many bodies: all of them, or none if one is refused. A handle that occurs again is stale by then.
     *
     * @param handles the bodies
     * @param count how many of them, from the first element on; 0 to the length of the array
     * @param stale what to do about stale handles
     * @return the number of handles that were left out, as the caller asked for
     * @throws IllegalArgumentException if a handle is stale and not to be left out, or the count is out of range
     */
    public int removeAll(long[] handles, int count, StaleHandles stale) {
        return simulation.rigidBulk.remove(handles, count, StaleHandles.areSkipped(stale));
    }

    /** Removes all bodies. {@link World#clear} leaves them. */
    public void clear() {
        simulation.calls.make(Call.CLEAR_RIGIDS);
    }

    /**
     * Whether a handle is that of a body of this world.
     *
     * @param body any number
     * @return false if it is stale or never was a handle
     */
    public boolean contains(long body) {
        return simulation.rigidIds.contains(body);
    }

    /**
     * The number of bodies.
     *
     * @return at least 0
     */
    public int size() {
        return simulation.rigidIds.size();
    }

    /**
     * The id of a handle: its lower 28 bits. Two bodies that are there at the same time have different ids. When a body has gone, a new one takes
     * its id over.
     *
     * @param body the handle of a body, stale or not; of the handle of anything else the number means nothing
     * @return its id, at least 0
     */
    public static int id(long body) {
        return Handle.id(body);
    }

    /**
     * How long the caller's arrays by id of bodies must be: one more than the greatest id that a body has had.
     *
     * @return at least {@link #size}
     */
    public int idLimit() {
        return simulation.rigidIds.limit();
    }

    /**
     * The handle of the body that has an id now.
     *
     * @param id an id, at least 0 and less than {@link #idLimit}
     * @return the handle; 0 if no body has the id
     * @throws IllegalArgumentException if the id is out of range
     */
    public long handle(int id) {
        return simulation.rigidIds.handle(id);
    }

    // ---- what bodies are

    /**
     * What a body looks like.
     *
     * @param body the handle of a body
     * @return an outline that equals the one that the body was added with
     * @throws IllegalArgumentException if the body has gone, or the handle is none
     */
    public Outline outline(long body) {
        return Outline.of(step.outline[require(body)]);
    }

    /**
     * The mass of a body.
     *
     * @param body the handle of a body
     * @return more than 0
     * @throws IllegalArgumentException if the body has gone, or the handle is none
     */
    public float mass(long body) {
        return table.mass(require(body));
    }

    /**
     * How hard it is to turn a body around its centroid.
     *
     * @param body the handle of a body
     * @return the moment of inertia, mass times length squared: {@link Outline#inertia} at first; infinite if nothing turns the
     *     body
     * @throws IllegalArgumentException if the body has gone, or the handle is none
     */
    public float inertia(long body) {
        return table.inertia(require(body));
    }

    /**
     * Sets how hard it is to turn a body around its centroid.
     *
     * @param body the handle of a body
     * @param inertia from a thousandth of {@link Outline#inertia} on; infinite for a body that never turns by itself, such as a hero
     * @throws IllegalArgumentException if the value is out of range, the body has gone, or the handle is none
     */
    public void setInertia(long body, float inertia) {
        simulation.calls.changeByFloats(Call.RIGID_INERTIA, body, inertia, 0, 0, 0);
    }

    /**
     * How much of the speed of an impact a body keeps: of two that collide the greater one counts.
     *
     * @param body the handle of a body
     * @return from 0 to 1
     * @throws IllegalArgumentException if the body has gone, or the handle is none
     */
    public float restitution(long body) {
        return step.restitution[require(body)];
    }

    /**
     * Sets the restitution of a body.
     *
     * @param body the handle of a body
     * @param restitution from 0 to 1
     * @throws IllegalArgumentException if the value is out of range, the body has gone, or the handle is none
     */
    public void setRestitution(long body, float restitution) {
        simulation.calls.changeByFloats(Call.RIGID_RESTITUTION, body, restitution, 0, 0, 0);
    }

    /**
     * The kind of a body.
     *
     * @param body the handle of a body
     * @return its number, 0 to 255
     * @throws IllegalArgumentException if the body has gone, or the handle is none
     */
    public int kindOf(long body) {
        return step.kind[require(body)];
    }

    /**
     * Gives a body another kind, and the restitution of the kind if it has one.
     *
     * @param body the handle of a body
     * @param kind the number of the kind, 0 to 255
     * @throws IllegalArgumentException if there is no such kind, the body has gone, or the handle is none
     */
    public void setKind(long body, int kind) {
        simulation.calls.change(Call.RIGID_KIND, body, kind, 0, 0);
    }

    /**
     * Puts a body into an exclusion group: bodies of one group never meet, nor do bodies and circles ({@link World#setGroup}), whatever their kinds.
     * Others meet as their kinds say.
     *
     * @param body the handle of a body
     * @param group any number; 0 for no group, as at first
     * @throws IllegalArgumentException if the body has gone, or the handle is none
     */
    public void setGroup(long body, int group) {
        simulation.calls.change(Call.RIGID_GROUP, body, group, 0, 0);
    }

    /**
     * The exclusion group of a body.
     *
     * @param body the handle of a body
     * @return the number of the group; 0 for none
     * @throws IllegalArgumentException if the body has gone, or the handle is none
     */
    public int group(long body) {
        return step.extras.get(require(body), RigidExtras.GROUP);
    }

    /**
     * The tag of a body.
     *
     * @param body the handle of a body
     * @return any number; 0 at first
     * @throws IllegalArgumentException if the body has gone, or the handle is none
     */
    public long tag(long body) {
        return table.tag(require(body));
    }

    /**
     * Gives a body a tag, a number that means something to the caller alone. No step depends on it; snapshots and logs keep it.
     *
     * @param body the handle of a body
     * @param tag any number
     * @throws IllegalArgumentException if the body has gone, or the handle is none
     */
    public void setTag(long body, long tag) {
        simulation.calls.change(Call.RIGID_TAG, body, (int) tag, (int) (tag >> Integer.SIZE), 0);
    }

    // ---- where bodies are, and how they move

    /**
     * Where a body is.
     *
     * @param body the handle of a body
     * @return x of its centroid
     * @throws IllegalArgumentException if the body has gone, or the handle is none
     */
    public float x(long body) {
        return step.x[require(body)];
    }

    /**
     * Where a body is.
     *
     * @param body the handle of a body
     * @return y of its centroid
     * @throws IllegalArgumentException if the body has gone, or the handle is none
     */
    public float y(long body) {
        return step.y[require(body)];
    }

    /**
     * How far a body is turned from how its outline lies.
     *
     * @param body the handle of a body
     * @return radians anticlockwise where y points up, from -pi to pi
     * @throws IllegalArgumentException if the body has gone, or the handle is none
     */
    public float angle(long body) {
        return Surface.radians(step.angle[require(body)]);
    }

    /**
     * The velocity of the centroid of a body.
     *
     * @param body the handle of a body
     * @return along x, lengths per second
     * @throws IllegalArgumentException if the body has gone, or the handle is none
     */
    public float vx(long body) {
        return step.vx[require(body)];
    }

    /**
     * The velocity of the centroid of a body.
     *
     * @param body the handle of a body
     * @return along y, lengths per second
     * @throws IllegalArgumentException if the body has gone, or the handle is none
     */
    public float vy(long body) {
        return step.vy[require(body)];
    }

    /**
     * How fast a body turns.
     *
     * @param body the handle of a body
     * @return radians per second, anticlockwise where y points up
     * @throws IllegalArgumentException if the body has gone, or the handle is none
     */
    public float angularVelocity(long body) {
        return step.omega[require(body)];
    }

    /**
     * Whether a body is awake ({@link World.Builder#sleep}).
     *
     * @param body the handle of a body
     * @return false if it sleeps
     * @throws IllegalArgumentException if the body has gone, or the handle is none
     */
    public boolean isAwake(long body) {
        return reads.isAwake(body);
    }

    /**
     * How many bodies are awake.
     *
     * @return bodies that steps move
     */
    public int awake() {
        return reads.awake();
    }

    /**
     * Wakes a body, if it sleeps. One that is awake begins anew to come to rest; so a body that is woken before each step never sleeps.
     *
     * @param body the handle of a body
     * @throws IllegalArgumentException if the body has gone, or the handle is none
     */
    public void wake(long body) {
        simulation.calls.change(Call.WAKE_RIGID, body);
    }

    /**
     * Puts a body somewhere else at once. It keeps its velocities; what it touched so far does not count. If it overlaps something there, both are
     * pushed apart.
     *
     * @param body the handle of a body
     * @param x x of its centroid, as with {@link #add(Outline, float, float, float, float)}
     * @param y y of it, likewise
     * @param angle radians anticlockwise, up to 1e6 in magnitude
     * @throws IllegalArgumentException if a value is out of range, the body has gone, or the handle is none
     */
    public void teleport(long body, float x, float y, float angle) {
        simulation.calls.changeByFloats(Call.TELEPORT_RIGID, body, x, y, angle, 0);
    }

    /**
     * Sets the velocity of the centroid of a body.
     *
     * @param body the handle of a body
     * @param vx velocity along x, lengths per second, up to 1e9 in magnitude
     * @param vy velocity along y, likewise
     * @throws IllegalArgumentException if a value is out of range, the body has gone, or the handle is none
     */
    public void setVelocity(long body, float vx, float vy) {
        simulation.calls.changeByFloats(Call.RIGID_VELOCITY, body, vx, vy, 0, 0);
    }

    /**
     * Sets how fast a body turns. In a sub-step it turns by 0.785 radians at most, so a step cuts what is faster than 0.785 times the number of
     * sub-steps over the length of the step: 188 radians a second with 4 sub-steps and 60 steps a second.
     *
     * @param body the handle of a body
     * @param velocity radians per second, anticlockwise where y points up, up to 1e9 in magnitude
     * @throws IllegalArgumentException if the value is out of range, the body has gone, or the handle is none
     */
    public void setAngularVelocity(long body, float velocity) {
        simulation.calls.changeByFloats(Call.RIGID_ANGULAR_VELOCITY, body, velocity, 0, 0, 0);
    }

    /**
     * Changes the velocity of a body at once by an impulse at its centroid, which does not turn it.
     *
     * @param body the handle of a body
     * @param x x of the impulse, mass times velocity, up to 1e18 in magnitude
     * @param y y of the impulse, likewise
     * @throws IllegalArgumentException if a value is out of range, the body has gone, or the handle is none
     */
    public void applyImpulse(long body, float x, float y) {
        simulation.rigids.applyImpulse(body, x, y);
    }

    /**
     * Changes both velocities of a body at once by an impulse at a point, which need not lie on the body.
     *
     * @param body the handle of a body
     * @param x x of the impulse, mass times velocity, up to 1e18 in magnitude
     * @param y y of the impulse, likewise
     * @param pointX x of the point in the world, up to 1e9 in magnitude; along an axis that wraps the image nearest to the centroid
     * @param pointY y of it, likewise
     * @throws IllegalArgumentException if a value is out of range, the body has gone, or the handle is none
     */
    public void applyImpulse(long body, float x, float y, float pointX, float pointY) {
        simulation.calls.changeByFloats(Call.RIGID_IMPULSE, body, x, y, pointX, pointY);
    }

    /**
     * Changes the angular velocity of a body at once by the impulse over its {@link #inertia}. A step cuts it as {@link #setAngularVelocity} says.
     *
     * @param body the handle of a body
     * @param impulse moment of inertia times angular velocity, up to 1e18 in magnitude
     * @throws IllegalArgumentException if the value is out of range, the body has gone, or the handle is none
     */
    public void applyAngularImpulse(long body, float impulse) {
        simulation.calls.changeByFloats(Call.RIGID_ANGULAR_IMPULSE, body, impulse, 0, 0, 0);
    }

    /**
     * Sets a force at the centroid of a body, which acts in every step until it is changed: thrust, wind. It does not turn with the body. Each second
     * it adds the force over the mass to the velocity. As with {@link World#setForce} it is the same in all sub-steps of a step.
     *
     * @param body the handle of a body
     * @param x x of the force, mass times length per second squared, up to 1e18 in magnitude; in a sub-step it changes a velocity
     *     by at most 1e9
     * @param y y of the force, likewise
     * @throws IllegalArgumentException if a value is out of range, the body has gone, or the handle is none
     */
    public void setForce(long body, float x, float y) {
        simulation.calls.changeByFloats(Call.RIGID_LASTING_FORCE, body, x, y, 0, 0);
    }

    /**
     * The force that is set for a body.
     *
     * @param body the handle of a body
     * @return along x; 0 at first
     * @throws IllegalArgumentException if the body has gone, or the handle is none
     */
    public float forceX(long body) {
        return step.extras.real(require(body), RigidExtras.FORCE_X);
    }

    /**
     * The force that is set for a body.
     *
     * @param body the handle of a body
     * @return along y; 0 at first
     * @throws IllegalArgumentException if the body has gone, or the handle is none
     */
    public float forceY(long body) {
        return step.extras.real(require(body), RigidExtras.FORCE_Y);
    }

    /**
     * Sets a torque on a body, which acts in every step until it is changed. Each second it adds the torque over the {@link #inertia} to the
     * angular velocity.
     *
     * @param body the handle of a body
     * @param torque mass times length squared per second squared, anticlockwise where y points up, up to 1e18 in magnitude
     * @throws IllegalArgumentException if the value is out of range, the body has gone, or the handle is none
     */
    public void setTorque(long body, float torque) {
        simulation.calls.changeByFloats(Call.RIGID_LASTING_TORQUE, body, torque, 0, 0, 0);
    }

    /**
     * The torque that is set for a body.
     *
     * @param body the handle of a body
     * @return the torque; 0 at first
     * @throws IllegalArgumentException if the body has gone, or the handle is none
     */
    public float torque(long body) {
        return step.extras.real(require(body), RigidExtras.TORQUE);
    }

    /**
     * Applies a force to the centroid of a body in the next step alone (the first of several that one call makes), besides the force that {@link
     * #setForce} has set. Several forces add up.
     *
     * @param body the handle of a body
     * @param x x of the force, mass times length per second squared, up to 1e18 in magnitude. The sum of several forces is cut to that
     * @param y y of the force, likewise
     * @throws IllegalArgumentException if a value is out of range, the body has gone, or the handle is none
     */
    public void applyForce(long body, float x, float y) {
        simulation.calls.changeByFloats(Call.RIGID_FORCE, body, x, y, 0, 0);
    }

    /**
     * Applies a force to a body at a point in the next step alone. It is that force at the centroid, and its torque about the centroid as that lies
     * now.
     *
     * @param body the handle of a body
     * @param x x of the force, mass times length per second squared, up to 1e18 in magnitude. The sum of several forces is cut to that
     * @param y y of the force, likewise
     * @param pointX x of the point in the world, up to 1e9 in magnitude; along an axis that wraps the image nearest to the centroid
     * @param pointY y of it, likewise
     * @throws IllegalArgumentException if a value is out of range, the body has gone, or the handle is none
     */
    public void applyForce(long body, float x, float y, float pointX, float pointY) {
        simulation.calls.changeByFloats(Call.RIGID_FORCE_AT, body, x, y, pointX, pointY);
    }

    /**
     * Applies a torque to a body in the next step alone, besides the torque that {@link #setTorque} has set. Several torques add up.
     *
     * @param body the handle of a body
     * @param torque mass times length squared per second squared, anticlockwise where y points up, up to 1e18 in magnitude. The sum of several is cut
     *     to that
     * @throws IllegalArgumentException if the value is out of range, the body has gone, or the handle is none
     */
    public void applyTorque(long body, float torque) {
        simulation.calls.changeByFloats(Call.RIGID_FORCE, body, 0, 0, torque, 0);
    }

    // ---- many bodies at once

    /**
     * Puts many bodies somewhere else at once, as {@link #teleport} does, in the order of the array: all of them, or none if one is refused.
     *
     * @param handles the bodies
     * @param count how many of them, from the first element on; 0 to the length of the array
     * @param poses x, y and the angle of each in radians, as {@link #readById} gives them
     * @param stale what to do about stale handles
     * @return the number of handles that were left out, as the caller asked for
     * @throws IllegalArgumentException if a handle is stale and not to be left out, a value of a handle that is not left out is out of range (the
     *     message has its place), the count is out of range, or there are too few values
     */
    public int teleportAll(long[] handles, int count, float[] poses, StaleHandles stale) {
        return simulation.rigidBulk.teleport(handles, count, poses, StaleHandles.areSkipped(stale));
    }

    /**
     * Gives many bodies velocities, as {@link #setVelocity} and {@link #setAngularVelocity} do, in the order of the array: all of them, or none if
     * one is refused.
     *
     * @param handles the bodies
     * @param count how many of them, from the first element on; 0 to the length of the array
     * @param velocities vx, vy and the angular velocity of each, as {@link #readVelocitiesById} gives them
     * @param stale what to do about stale handles
     * @return the number of handles that were left out, as the caller asked for
     * @throws IllegalArgumentException as {@link #teleportAll} does
     */
    public int setVelocities(long[] handles, int count, float[] velocities, StaleHandles stale) {
        return simulation.rigidBulk.setVelocities(handles, count, velocities, StaleHandles.areSkipped(stale));
    }

    /**
     * Pushes many bodies at their centroids, as {@link #applyImpulse(long, float, float)} does, in the order of the array: all of them, or none if
     * one is refused.
     *
     * @param handles the bodies; one that occurs twice is pushed twice
     * @param count how many of them, from the first element on; 0 to the length of the array
     * @param impulses x and y of the impulse on each, mass times velocity, up to 1e18 in magnitude
     * @param stale what to do about stale handles
     * @return the number of handles that were left out, as the caller asked for
     * @throws IllegalArgumentException as {@link #teleportAll} does
     */
    public int applyImpulses(long[] handles, int count, float[] impulses, StaleHandles stale) {
        return simulation.rigidBulk.applyImpulses(handles, count, impulses, StaleHandles.areSkipped(stale));
    }

    /**
     * Sets forces and torques on many bodies, as {@link #setForce} and {@link #setTorque} do, in the order of the array: on all of them, or on none
     * if one is refused.
     *
     * @param handles the bodies
     * @param count how many of them, from the first element on; 0 to the length of the array
     * @param forces x and y of the force on each, and the torque
     * @param stale what to do about stale handles
     * @return the number of handles that were left out, as the caller asked for
     * @throws IllegalArgumentException as {@link #teleportAll} does
     */
    public int setForces(long[] handles, int count, float[] forces, StaleHandles stale) {
        return simulation.rigidBulk.setForces(handles, count, forces, StaleHandles.areSkipped(stale));
    }

    /**
     * Gives many bodies other kinds, as {@link #setKind} does, in the order of the array: all of them, or none if one is refused.
     *
     * @param handles the bodies
     * @param count how many of them, from the first element on; 0 to the length of the array
     * @param kinds the number of the kind of each, 0 to 255
     * @param stale what to do about stale handles
     * @return the number of handles that were left out, as the caller asked for
     * @throws IllegalArgumentException as {@link #teleportAll} does
     */
    public int setKinds(long[] handles, int count, int[] kinds, StaleHandles stale) {
        return simulation.rigidBulk.setKinds(handles, count, kinds, StaleHandles.areSkipped(stale));
    }

    /**
     * Reads where all bodies are, by id: element 3 k is x of the body with the {@link #id} k, then y and the angle in radians.
     * {@link FixedStep#bodies} gives them between two steps.
     *
     * @param bodies takes three elements an id, so it has at least 3 {@link #idLimit}. All of it is written: elements without a body become
     *     NaN
     * @param living takes a bit for each id, 1 if there is such a body, as with {@link World#readById}; may be null
     * @throws IllegalArgumentException if an array is too short
     */
    public void readById(float[] bodies, long[] living) {
        reads.readById(bodies, living);
    }

    /**
     * Reads how all bodies move, by id, likewise: vx, vy and the angular velocity.
     *
     * @param velocities takes three elements an id. All of it is written: elements without a body become NaN
     * @param living as with {@link #readById}; may be null
     * @throws IllegalArgumentException if an array is too short
     */
    public void readVelocitiesById(float[] velocities, long[] living) {
        reads.readVelocitiesById(velocities, living);
    }

    /**
     * Reads the handles of all bodies, in the order of their ids.
     *
     * @param handles takes at least {@link #size} elements
     * @throws IllegalArgumentException if the array is too short
     */
    public void readHandles(long[] handles) {
        reads.readHandles(handles);
    }

    // ---- what bodies touch

    /**
     * Sets whether {@link #events} tells of what bodies touch. By default it tells of nothing, which costs nothing. This changes no step, and is in no
     * log; snapshots have what touches then, so that a rollback tells of no touch twice.
     *
     * @param on whether it tells from now on: first of all that touches in the next step, as begun; if not, what it has not told yet is forgotten
     */
    public void report(boolean on) {
        reads.report(on);
    }

    /**
     * The touches of bodies that have begun or ended since the last call of this method, or since {@link World#restore}.
     *
     * @return always the same object, which the next call fills again
     */
    public BodyEvents events() {
        reads.take(events.rows());
        return events;
    }

    /**
     * Lists what touches a body: what has begun and not ended, by the rules of {@link BodyEvents}, but walls. So it says who is in a body that senses.
     *
     * @param body the handle of a body
     * @param handles takes the handles of other bodies, then of pieces of {@link Terrain} and of circles, each in the order of ids; then, likewise, of
     *     what only senses the body or is only sensed by it. If it is too short, it takes the first of them
     * @return how many there are, which may be more than the array takes; 0 if {@link #report} is off
     * @throws IllegalArgumentException if the body does not exist
     */
    public int touching(long body, long[] handles) {
        return reads.touching(body, handles);
    }
}
