package io.github.circles2d;

import io.github.circles2d.world.Simulation;
import io.github.circles2d.world.circles.Handle;
import io.github.circles2d.world.joints.JointEnds;
import io.github.circles2d.world.joints.JointForm;
import io.github.circles2d.world.joints.JointSetting;
import io.github.circles2d.world.model.Limits;
import io.github.circles2d.world.shared.Call;

/**
 * The joints of a {@link World}: ropes, bridges, springs, wheels, welded bodies, the mouse. {@link World#joints} gives this object.
 *
 * <pre>{@code
 * Joints joints = world.joints();
 * long hook = joints.add(world.add(40, 50, 1, 1), 40, 60, Joint.rope(10));
 * long mouse = joints.add(ball, x, y, Joint.mouse(5, 1, 1000));
 * joints.setAnchor(mouse, newX, newY); // in each frame
 * joints.remove(mouse);
 * }</pre>
 *
 * <p><b>Handles</b> are as those of circles: longs, never 0, stale once the joint has gone. No joint has the handle of a circle: a call that gets one for the
 * other refuses it.
 *
 * <p><b>Joints go</b> if they are removed, if they break ({@link Joint#breakingAt}), and with each circle and each body that they hold.
 *
 * <p><b>Bodies</b> of {@link World#bodies} are held at points, in their own coordinates from the centroid on: a hinge is a {@link Joint#pin} between points
 * of two bodies. Points are up to 100 times as far from the centroid as the outline is, along each axis. Between bodies all joints are possible but
 * {@link Joint#friction}. A weld of a body keeps both as they lie; the middle between its ends, or the centre of a circle, is as near to the body as points.
 *
 * <p><b>Collisions:</b> two circles or bodies that a joint holds do not collide, unless it is {@link Joint#colliding}.
 *
 * <p><b>Rigid</b> joints yield a little if masses differ: a rope of 100 links with an end of 100 times the mass of a link stretches by a fifth.
 * A second joint, a rope from its first circle to its last one, keeps it from that.
 *
 * <p><b>Static circles</b> may be held, but not two by one joint, nor one by an anchor. A joint whose circles become static afterwards, by {@link
 * World#setMass}, does nothing until one of them can move again.
 *
 * <p><b>Lengths that nobody gives</b>, and welds, take them from the circles as they are now, which are read for that if they have changed. So add
 * circles first and joints then, many by {@link #addAll}, or give lengths.
 *
 * <p><b>Limits:</b> a world has at most 2^20 joints. A circle may have any number; those of a circle that has more than ten with other circles
 * are a little softer. A world without joints pays nothing for this. A change acts from the next step on. Joints are in snapshots, in logs and in the hash. The rules of {@link World} for
 * threads, failures and closed worlds hold here, too.
 */
public final class Joints {
    private final Simulation simulation;
    private final JointEvents events = new JointEvents();

    Joints(Simulation simulation) {
        this.simulation = simulation;
    }

    private static JointForm form(Joint joint) {
        return Limits.notNull("joint", joint).form();
    }

    // ---- joints come

    /**
     * Adds a joint between two circles or bodies, which are held at their centres.
     *
     * @param circle the handle of its first circle or body
     * @param other that of the other one
     * @param joint what it does: no friction; no pin either, unless one is a body
     * @return the handle of the joint
     * @throws IllegalArgumentException if a circle or body has been removed, both are one or are static circles, the joint is of no use between two, or
     *     there are 2^20 joints
     */
    public long add(long circle, long other, Joint joint) {
        return simulation.joints.add(circle, other, form(joint));
    }

    /**
     * Adds a joint between points of two bodies.
     *
     * @param body the handle of the first body
     * @param x x of the point on it, in the body's coordinates
     * @param y y of it
     * @param other the handle of the other body
     * @param otherX x of the point on that, in its coordinates
     * @param otherY y of it
     * @param joint what it does: no friction
     * @return the handle of the joint
     * @throws IllegalArgumentException if a body has been removed, both are one, a point is too far away, the joint is of no use
     *     between two, or there are 2^20 joints
     */
    public long add(long body, float x, float y, long other, float otherX, float otherY, Joint joint) {
        return simulation.joints.add(JointEnds.RIGID, body, x, y, JointEnds.RIGID, other, otherX, otherY, form(joint));
    }

    /**
     * Adds a joint between a point of a body and a circle: a wheel, or a ball on a rope.
     *
     * @param body the handle of the body
     * @param x x of the point, in the body's coordinates
     * @param y y of it
     * @param circle the handle of the circle
     * @param joint what it does: no friction
     * @return the handle of the joint
     * @throws IllegalArgumentException as {@link #add(long, float, float, long, float, float, Joint)}
     */
    public long add(long body, float x, float y, long circle, Joint joint) {
        return simulation.joints.add(JointEnds.RIGID, body, x, y, JointEnds.CIRCLE, circle, 0, 0, form(joint));
    }

    /**
     * Adds a joint between a point of a body and a place of the world.
     *
     * @param body the handle of the body
     * @param x x of the point, in the body's coordinates
     * @param y y of it
     * @param worldX x of the anchor, up to 1e9 in magnitude
     * @param worldY y of it
     * @param joint what it does: a pin, or a joint along a line, but no weld
     * @return the handle of the joint
     * @throws IllegalArgumentException if the body has been removed, a value is out of range, the joint takes no anchor, or there are
     *     2^20 joints
     */
    public long add(long body, float x, float y, float worldX, float worldY, Joint joint) {
        return simulation.joints.add(
                JointEnds.RIGID, body, x, y, JointEnds.ANCHOR, simulation.bodies.ground(), worldX, worldY, form(joint));
    }

    /**
     * Adds a joint between a point of a body and a place of a body of terrain, with which the anchor moves.
     *
     * @param body the handle of the body that is pushed
     * @param x x of the point, in the body's coordinates
     * @param y y of it
     * @param terrain the body of terrain
     * @param terrainX x of the anchor, in the coordinates of that, up to 1e9 in magnitude
     * @param terrainY y of it
     * @param joint what it does: a pin, or a joint along a line, but no weld
     * @return the handle of the joint
     * @throws IllegalArgumentException as {@link #add(long, float, float, float, float, Joint)}, or if the body of terrain has been removed or is
     *     none of this world's
     */
    public long add(long body, float x, float y, TerrainBody terrain, float terrainX, float terrainY, Joint joint) {
        long handle = Limits.notNull("terrain", terrain).handleIn(simulation);
        return simulation.joints.add(
                JointEnds.RIGID, body, x, y, JointEnds.ANCHOR, handle, terrainX, terrainY, form(joint));
    }

    /**
     * Adds a joint between a circle and a place of the world.
     *
     * @param circle the handle of the circle
     * @param x x of the anchor, up to 1e9 in magnitude
     * @param y y of it
     * @param joint what it does: a pin, or a joint along a line, but no weld
     * @return the handle of the joint
     * @throws IllegalArgumentException if the circle has been removed or is static, a value is out of range, the joint takes no anchor, or
     *     there are 2^20 joints
     */
    public long add(long circle, float x, float y, Joint joint) {
        return simulation.joints.add(circle, simulation.bodies.ground(), x, y, form(joint));
    }

    /**
     * Adds a joint between a circle and a place of a body of terrain, with which the anchor moves.
     *
     * @param circle the handle of the circle
     * @param body the body
     * @param x x of the anchor in the body's coordinates ({@link TerrainBody#localX}), up to 1e9 in magnitude
     * @param y y of it
     * @param joint what it does: a pin, or a joint along a line, but no weld
     * @return the handle of the joint
     * @throws IllegalArgumentException as {@link #add(long, float, float, Joint)}, or if the body has been removed or is none of this world's
     */
    public long add(long circle, TerrainBody body, float x, float y, Joint joint) {
        long handle = Limits.notNull("body", body).handleIn(simulation);
        return simulation.joints.add(circle, handle, x, y, form(joint));
    }

    /**
     * Adds a joint between a circle or a body and the world, without a place.
     *
     * @param circle the handle of the circle or body
     * @param joint what it does: a motor, a servo or friction
     * @return the handle of the joint
     * @throws IllegalArgumentException if the circle or body has been removed, the circle is static, the joint needs another end, or there are 2^20 joints
     */
    public long add(long circle, Joint joint) {
        return simulation.joints.add(circle, form(joint));
    }

    /**
     * Adds joints between two circles each: all of them, or none if one is refused.
     *
     * @param circles the handles of their first circles
     * @param others those of the other ones, as many
     * @param joint what each of them does
     * @param handles takes the handles of the joints; may be null
     * @return the number of joints
     * @throws IllegalArgumentException if a joint is refused, as by {@link #add(long, long, Joint)}, with its index; or if an array has a
     *     wrong length
     */
    public int addAll(long[] circles, long[] others, Joint joint, long[] handles) {
        return simulation.joints.addAll(circles, others, form(joint), handles);
    }

    /**
     * Adds joints between a circle each and the world, without a place, such as the friction of a table for all pucks: all of them, or none if one
     * is refused.
     *
     * @param circles the handles of the circles
     * @param joint what each of them does: a motor, a servo or friction
     * @param handles takes the handles of the joints; may be null
     * @return the number of joints
     * @throws IllegalArgumentException if a joint is refused, as by {@link #add(long, Joint)}, with its index; or if the array of handles is
     *     too short
     */
    public int addAll(long[] circles, Joint joint, long[] handles) {
        return simulation.joints.addAll(circles, form(joint), handles);
    }

    // ---- joints go

    /**
     * Removes a joint.
     *
     * @param joint the handle of a joint
     * @throws IllegalArgumentException if the joint has gone, or the handle is none
     */
    public void remove(long joint) {
        simulation.calls.change(Call.REMOVE_JOINT, joint);
    }

    /**
     * Removes many joints: all of them, or none if one is refused.
     *
     * @param joints handles of joints
     * @throws IllegalArgumentException if a joint has gone, or is there twice; the message has the index
     */
    public void removeAll(long[] joints) {
        simulation.joints.removeAll(joints);
    }

    /** Removes all joints. */
    public void clear() {
        simulation.calls.make(Call.CLEAR_JOINTS);
    }

    // ---- which there are

    /**
     * Whether a handle is that of a joint of this world.
     *
     * @param joint any number
     * @return false if it is stale or never was a handle
     */
    public boolean contains(long joint) {
        return simulation.jointIds.contains(joint);
    }

    /** {@return the number of joints, at least 0} */
    public int size() {
        return simulation.jointIds.size();
    }

    /**
     * The id of a handle: its lower 28 bits. Two joints that are there at the same time have different ids. When a joint has gone, a new one takes
     * its id over.
     *
     * @param joint the handle of a joint, stale or not
     * @return its id, at least 0
     */
    public static int id(long joint) {
        return Handle.id(joint);
    }

    /** {@return how long the caller's arrays by id of joints must be: one more than the greatest id that a joint has had; at least {@link #size}} */
    public int idLimit() {
        return simulation.jointIds.limit();
    }

    /**
     * The handle of the joint that has an id now.
     *
     * @param id an id, at least 0 and less than {@link #idLimit}
     * @return the handle; 0 if no joint has the id
     * @throws IllegalArgumentException if the id is out of range
     */
    public long handle(int id) {
        return simulation.jointIds.handle(id);
    }

    /**
     * The first circle or body of a joint.
     *
     * @param joint the handle of a joint
     * @return the handle of the circle or body; {@link Bodies#contains} tells which
     * @throws IllegalArgumentException if the joint has gone, or the handle is none
     */
    public long circle(long joint) {
        return simulation.jointReads.end(joint, false);
    }

    /**
     * The other circle or body of a joint.
     *
     * @param joint the handle of a joint
     * @return the handle of the circle or body; 0 if the joint holds one alone
     * @throws IllegalArgumentException if the joint has gone, or the handle is none
     */
    public long other(long joint) {
        return simulation.jointReads.end(joint, true);
    }

    /**
     * What a joint does now.
     *
     * @param joint the handle of a joint
     * @return its definition, by which an equal one can be added
     * @throws IllegalArgumentException if the joint has gone, or the handle is none
     */
    public Joint joint(long joint) {
        return new Joint(simulation.jointReads.form(joint));
    }

    /**
     * Lists the joints of a circle.
     *
     * @param circle the handle of a circle
     * @param joints takes their handles, in the order of their ids; if it is too short, the first of them
     * @return how many joints there are, which may be more than the array takes
     * @throws IllegalArgumentException if the circle has been removed, or the handle is none
     */
    public int ofCircle(long circle, long[] joints) {
        return simulation.jointReads.ofCircle(circle, joints);
    }

    /**
     * Lists the joints of a body of {@link World#bodies}.
     *
     * @param body the handle of a body
     * @param joints takes their handles, in the order of their ids; if it is too short, the first of them
     * @return how many joints there are, which may be more than the array takes
     * @throws IllegalArgumentException if the body has been removed, or the handle is none
     */
    public int ofBody(long body, long[] joints) {
        return simulation.jointReads.ofBody(body, joints);
    }

    /**
     * The joint whose line is nearest to a point. A joint without a place is at its circle or body.
     *
     * @param x x of the point, up to 1e9 in magnitude
     * @param y y of it
     * @param maxDistance how far away it may be; at least 0
     * @return the handle of the joint, of several at one distance that of the lowest id; 0 if there is none
     * @throws IllegalArgumentException if a value is out of range
     */
    public long pick(float x, float y, float maxDistance) {
        return simulation.jointReads.pick(x, y, maxDistance);
    }

    // ---- where they are, and what they do

    /**
     * Where the anchor of a joint is in the world now.
     *
     * @param joint the handle of a joint
     * @return x
     * @throws IllegalArgumentException if the joint has gone or has no anchor
     */
    public float anchorX(long joint) {
        return simulation.jointReads.anchorX(joint);
    }

    /**
     * Where the anchor of a joint is in the world now.
     *
     * @param joint the handle of a joint
     * @return y
     * @throws IllegalArgumentException if the joint has gone or has no anchor
     */
    public float anchorY(long joint) {
        return simulation.jointReads.anchorY(joint);
    }

    /**
     * How far the ends of a joint are apart now.
     *
     * @param joint the handle of a joint
     * @return the distance; 0 if it has no other end
     * @throws IllegalArgumentException if the joint has gone, or the handle is none
     */
    public float length(long joint) {
        return simulation.jointReads.length(joint);
    }

    /**
     * The force of a joint on its first circle or body, the mean of the last step. On the other one it is the opposite.
     *
     * @param joint the handle of a joint
     * @return x of the force; 0 before the first step of the joint
     * @throws IllegalArgumentException if the joint has gone, or the handle is none
     */
    public float forceX(long joint) {
        return simulation.jointReads.forceX(joint);
    }

    /**
     * The force of a joint on its first circle or body; see {@link #forceX}.
     *
     * @param joint the handle of a joint
     * @return y of the force
     * @throws IllegalArgumentException if the joint has gone, or the handle is none
     */
    public float forceY(long joint) {
        return simulation.jointReads.forceY(joint);
    }

    /**
     * How hard a joint pulls or pushes, the mean of the last step.
     *
     * @param joint the handle of a joint
     * @return of a distance joint, a spring, a joint with limits or a weld of circles the force along its line as it is now, positive if it pulls its
     *     ends together; of others how great the force is
     * @throws IllegalArgumentException if the joint has gone, or the handle is none
     */
    public float force(long joint) {
        return simulation.jointReads.force(joint);
    }

    /**
     * The torque of a joint on its first circle or body, the mean of the last step. On the other one it is the opposite.
     *
     * @param joint the handle of a joint
     * @return the torque, anticlockwise where y points up
     * @throws IllegalArgumentException if the joint has gone, or the handle is none
     */
    public float torque(long joint) {
        return simulation.jointReads.torque(joint);
    }

    /**
     * Where both ends of all joints are now, in the order of their ids, for drawing: x and y of the first end, then of the second one. Along an
     * axis that wraps, the second one is the image nearest to the first, which may be outside of the bounds. Of a joint without a place both
     * are at its circle or body. {@link FixedStep#jointEnds} gives them between two steps.
     *
     * @param ends takes four elements a joint
     * @return the number of joints
     * @throws IllegalArgumentException if the array is too short
     */
    public int readEnds(float[] ends) {
        return simulation.jointReads.readEnds(ends);
    }

    // ---- joints that go by themselves

    /**
     * Sets whether {@link #events} tells of joints that go by themselves. By default it tells of none, which costs nothing. This changes no step, and
     * is in no snapshot and no log.
     *
     * @param on whether it tells of them from now on; if not, those of which it has not told yet are forgotten
     */
    public void report(boolean on) {
        simulation.joints.report(on);
    }

    /**
     * {@return the joints that went by themselves since the last call of this method, or since {@link World#restore}: always the same object, which
     * the next call fills again}
     */
    public JointEvents events() {
        simulation.joints.take(events.rows());
        return events;
    }

    // ---- joints change

    private void set(JointSetting setting, long joint, float a, float b) {
        simulation.calls.change(
                Call.JOINT_SETTING, joint, setting.number, Float.floatToRawIntBits(a), Float.floatToRawIntBits(b));
    }

    /**
     * Puts the anchor of a joint somewhere else. A rigid joint follows it by at most 0.2 radii of its circle a sub-step, or 0.2 times as far as its body
     * goes from the centroid, which is 48 radii a second with 60 steps of 4 sub-steps; behind an anchor that goes on faster the circle lags. The mouse, springs and soft pins have no such
     * limit, nor has an anchor on a {@link TerrainBody} that moves by its own velocity or {@link TerrainBody#moveTo}.
     *
     * @param joint the handle of a joint
     * @param x x of the anchor, of the world or of the body of terrain that it is on; up to 1e9 in magnitude
     * @param y y of it
     * @throws IllegalArgumentException if the joint has gone or has no anchor, or a value is out of range
     */
    public void setAnchor(long joint, float x, float y) {
        set(JointSetting.ANCHOR, joint, x, y);
    }

    /**
     * Sets the length of a distance joint or a spring.
     *
     * @param joint the handle of a joint
     * @param length 0 to 1e9
     * @throws IllegalArgumentException if the joint has gone or has no such length, or the length is out of range
     */
    public void setLength(long joint, float length) {
        set(JointSetting.LENGTH, joint, length, 0);
    }

    /**
     * Sets the least and the greatest length of a spring or of a joint with limits.
     *
     * @param joint the handle of a joint
     * @param minLength 0 to 1e9
     * @param maxLength at least the other one; may be infinite
     * @throws IllegalArgumentException if the joint has gone or has no limits, or a length is out of range
     */
    public void setLimits(long joint, float minLength, float maxLength) {
        set(JointSetting.LIMITS, joint, minLength, maxLength);
    }

    /**
     * Sets the spring of a spring, a pin with a spring or a servo.
     *
     * @param joint the handle of a joint
     * @param hertz 0 to 10,000
     * @param dampingRatio 0 to 1,000
     * @throws IllegalArgumentException if the joint has gone or has no spring, or a value is out of range
     */
    public void setSpring(long joint, float hertz, float dampingRatio) {
        set(JointSetting.SPRING, joint, hertz, dampingRatio);
    }

    /**
     * Sets the speed of a motor.
     *
     * @param joint the handle of a joint
     * @param speed radians per second, up to 1e9 in magnitude
     * @throws IllegalArgumentException if the joint has gone or is no motor, or the speed is out of range
     */
    public void setSpeed(long joint, float speed) {
        set(JointSetting.SPEED, joint, speed, 0);
    }

    /**
     * Sets the angle of a servo.
     *
     * @param joint the handle of a joint
     * @param angle radians, up to 1e6 in magnitude
     * @throws IllegalArgumentException if the joint has gone or is no servo, or the angle is out of range
     */
    public void setAngle(long joint, float angle) {
        set(JointSetting.ANGLE, joint, angle, 0);
    }

    /**
     * Sets the greatest force of a pin, also one that {@link Joint#mouse} has made, or of friction.
     *
     * @param joint the handle of a joint
     * @param maxForce at least 0; may be infinite
     * @throws IllegalArgumentException if the joint has gone or has no greatest force, or the force is out of range
     */
    public void setMaxForce(long joint, float maxForce) {
        set(JointSetting.MAX_FORCE, joint, maxForce, 0);
    }

    /**
     * Sets the greatest torque of a motor, a servo or of friction.
     *
     * @param joint the handle of a joint
     * @param maxTorque at least 0; may be infinite
     * @throws IllegalArgumentException if the joint has gone or has no greatest torque, or the torque is out of range
     */
    public void setMaxTorque(long joint, float maxTorque) {
        set(JointSetting.MAX_TORQUE, joint, maxTorque, 0);
    }

    /**
     * Sets by what a joint breaks, as {@link Joint#breakingAt}.
     *
     * @param joint the handle of a joint
     * @param force at least 0; may be infinite
     * @param torque likewise
     * @throws IllegalArgumentException if the joint has gone, or a value is out of range
     */
    public void setBreaking(long joint, float force, float torque) {
        set(JointSetting.BREAKING, joint, force, torque);
    }

    /**
     * Sets whether the two circles or bodies of a joint collide.
     *
     * @param joint the handle of a joint
     * @param collide whether they do
     * @throws IllegalArgumentException if the joint has gone, or the handle is none
     */
    public void setColliding(long joint, boolean collide) {
        set(JointSetting.COLLIDING, joint, collide ? 1 : 0, 0);
    }
}
