package io.github.circles2d;

import io.github.circles2d.reference.BodyOutline;
import io.github.circles2d.reference.ChainShape;
import io.github.circles2d.reference.JointPlan;
import java.lang.reflect.InvocationHandler;
import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Proxy;

/** Calls of a test's program, which a World answers, or what a World is compared with. They are those of {@link World}. */
public interface WorldCalls {
    long add(float x, float y, float radius, float mass, float vx, float vy);

    long add(float x, float y, float radius, float mass, float vx, float vy, int kind);

    void addAll(float[] circles, float[] velocities, int[] kinds, long[] handles);

    void remove(long handle);

    boolean contains(long handle);

    int size();

    void read(float[] circles);

    void readHandles(long[] handles);

    void setPosition(long handle, float x, float y);

    void teleport(long handle, float x, float y);

    void setVelocity(long handle, float vx, float vy);

    void setRadius(long handle, float radius);

    void grow(long handle, float radius, int steps);

    void setMass(long handle, float mass);

    void setRestitution(long handle, float restitution);

    void setKind(long handle, int kind);

    void setGroup(long handle, int group);

    void wake(long handle);

    void wakeAll();

    boolean isAwake(long handle);

    default void setSleeps(int kind, boolean sleeps) {
        kind(kind).setSleeps(sleeps);
    }

    void setTag(long handle, long tag);

    void setResponse(int kindA, int kindB, Response response);

    Kind kind(int number);

    /** Sets what decides which circles of a kind meet. */
    default void setPairs(int kind, int category, int mask, boolean sensor) {
        kind(kind).setCategory(category).setMask(mask).setSensor(sensor);
    }

    /** Sets whether static circles of a kind sense what does not move. */
    default void setSensesStatic(int kind, boolean senses) {
        kind(kind).setSensesStatic(senses);
    }

    /** Sets how circles of a kind move. */
    default void setMotion(int kind, float gravityScale, float damping, float greatestSpeed) {
        kind(kind).setGravityScale(gravityScale).setDamping(damping).setGreatestSpeed(greatestSpeed);
    }

    /** Sets the restitution that circles get with a kind. */
    default void setKindRestitution(int kind, float restitution) {
        kind(kind).setRestitution(restitution);
    }

    /** Sets what circles of a kind touch others with. */
    default void setSurface(int kind, float friction, float rollingResistance, float beltSpeed) {
        kind(kind).setFriction(friction).setRollingResistance(rollingResistance).setBeltSpeed(beltSpeed);
    }

    /** Sets how circles of a kind turn. */
    default void setTurning(int kind, Inertia inertia, float angularDamping) {
        kind(kind).setInertia(inertia).setAngularDamping(angularDamping);
    }

    void setWallSurface(Wall wall, float friction, float rollingResistance, float beltSpeed);

    void setFriction(long handle, float friction);

    void setRollingResistance(long handle, float resistance);

    void setGravityScale(long handle, float scale);

    void setDamping(long handle, float damping);

    void setGreatestSpeed(long handle, float speed);

    void setAngle(long handle, float radians);

    void setAngularVelocity(long handle, float angularVelocity);

    void setTorque(long handle, float torque);

    void applyTorque(long handle, float torque);

    void applyAngularImpulse(long handle, float impulse);

    int setAngularVelocities(long[] handles, int count, float[] angularVelocities, StaleHandles stale);

    Terrain terrain();

    default void setOneWay(int kind, boolean oneWay) {
        kind(kind).setOneWay(oneWay);
    }

    default long addBody(float x, float y, float angle) {
        return terrain().addBody(x, y, angle).handle();
    }

    /** A body; 0 is the ground. */
    default TerrainBody body(long handle) {
        return handle == 0 ? terrain().ground() : terrain().body(handle);
    }

    default long addSegment(long body, float x1, float y1, float x2, float y2, float thickness, int kind) {
        return body(body).addSegment(x1, y1, x2, y2, thickness, kind);
    }

    default long addArc(long body, float x, float y, float radius, float from, float to, ArcSide side, int kind) {
        return body(body).addArc(x, y, radius, from, to, side, kind);
    }

    /** Returns how many pieces it has; handles has room for them. */
    default int addChain(long body, ChainShape shape, int kind, long[] handles) {
        return body(body).addChain(chain(shape), kind, handles);
    }

    /** A chain, as callers draw it. */
    static Chain chain(ChainShape shape) {
        Chain chain = Chain.from(shape.x(), shape.y());
        for (float[] way : shape.ways()) {
            chain = way.length == 2 ? chain.lineTo(way[0], way[1]) : chain.arcTo(way[0], way[1], way[2]);
        }
        return shape.closed() ? chain.close() : chain;
    }

    default void removePiece(long piece) {
        terrain().remove(piece);
    }

    default void setPieceKind(long piece, int kind) {
        terrain().setKind(piece, kind);
    }

    default void clearTerrain() {
        terrain().clear();
    }

    default void setBodyVelocity(long body, float vx, float vy, float angularVelocity) {
        body(body).setVelocity(vx, vy);
        body(body).setAngularVelocity(angularVelocity);
    }

    default void moveBodyTo(long body, float x, float y, float angle) {
        body(body).moveTo(x, y, angle);
    }

    default void teleportBody(long body, float x, float y, float angle) {
        body(body).teleport(x, y, angle);
    }

    default void removeBody(long body) {
        body(body).remove();
    }

    Bodies bodies();

    /** What is drawn, as callers make it. */
    static Outline outline(BodyOutline drawn) {
        Outline outline = Outline.of(chain(drawn.chain()));
        return Float.isNaN(drawn.rounding()) ? outline : outline.round(drawn.rounding());
    }

    default long addRigid(BodyOutline drawn, float x, float y, float angle, float mass, int kind) {
        return bodies().add(outline(drawn), x, y, angle, mass, kind);
    }

    /** The handles of all bodies that are pushed, in the order of their ids. */
    default long[] rigids() {
        long[] handles = new long[bodies().size()];
        bodies().readHandles(handles);
        return handles;
    }

    default void reportRigids(boolean on) {
        bodies().report(on);
    }

    default int touchingRigid(long body, long[] handles) {
        return bodies().touching(body, handles);
    }

    default void removeRigid(long body) {
        bodies().remove(body);
    }

    default void wakeRigid(long body) {
        bodies().wake(body);
    }

    default boolean isRigidAwake(long body) {
        return bodies().isAwake(body);
    }

    default void clearRigids() {
        bodies().clear();
    }

    default void setRigidVelocity(long body, float vx, float vy, float angularVelocity) {
        bodies().setVelocity(body, vx, vy);
        bodies().setAngularVelocity(body, angularVelocity);
    }

    default void teleportRigid(long body, float x, float y, float angle) {
        bodies().teleport(body, x, y, angle);
    }

    default void pushRigid(long body, float x, float y, float pointX, float pointY) {
        bodies().applyImpulse(body, x, y, pointX, pointY);
    }

    default void turnRigid(long body, float impulse) {
        bodies().applyAngularImpulse(body, impulse);
    }

    default void pressRigid(long body, float forceX, float forceY, float torque) {
        bodies().applyForce(body, forceX, forceY);
        bodies().applyTorque(body, torque);
    }

    default void pressRigidAt(long body, float forceX, float forceY, float pointX, float pointY) {
        bodies().applyForce(body, forceX, forceY, pointX, pointY);
    }

    /** Sets a force and a torque that last. */
    default void driveRigid(long body, float forceX, float forceY, float torque) {
        bodies().setForce(body, forceX, forceY);
        bodies().setTorque(body, torque);
    }

    default void setRigidKind(long body, int kind) {
        bodies().setKind(body, kind);
    }

    default void setRigidGroup(long body, int group) {
        bodies().setGroup(body, group);
    }

    default void setRigidTag(long body, long tag) {
        bodies().setTag(body, tag);
    }

    default void setRigidRestitution(long body, float restitution) {
        bodies().setRestitution(body, restitution);
    }

    /** An inertia of 1 is that of the outline. */
    default void setRigidInertia(long body, float share) {
        bodies().setInertia(body, share * bodies().outline(body).inertia(bodies().mass(body)));
    }

    Joints joints();

    /** What a plan says, as callers say it. */
    static Joint joint(JointPlan plan) {
        float[] n = plan.numbers();
        Joint joint =
                switch (plan.kind()) {
                    case DISTANCE -> Joint.distance();
                    case SPRING -> Joint.spring(n[0], n[1]);
                    case LIMITS -> Joint.limits(plan.leastLength(), plan.greatestLength());
                    case PIN -> Joint.pin();
                    case SOFT_PIN -> Joint.pin(n[0], n[1]);
                    case MOUSE -> Joint.mouse(n[0], n[1], n[2]);
                    case MOTOR -> Joint.motor(n[0], n[1]);
                    case SERVO -> Joint.servo(n[0], n[1], n[2], n[3]);
                    case FRICTION -> Joint.friction(n[0], n[1]);
                    case WELD -> Joint.weld();
                };
        joint = Float.isNaN(plan.length()) ? joint : joint.withLength(plan.length());
        boolean limits = plan.kind() == JointPlan.Kind.SPRING
                && (plan.leastLength() > 0f || plan.greatestLength() < Float.POSITIVE_INFINITY);
        joint = limits ? joint.withLimits(plan.leastLength(), plan.greatestLength()) : joint;
        return joint.breakingAt(plan.breakForce(), plan.breakTorque()).colliding(plan.collides());
    }

    default long addJoint(long circle, long other, JointPlan plan) {
        return joints().add(circle, other, joint(plan));
    }

    default long addJoint(long circle, float x, float y, JointPlan plan) {
        return joints().add(circle, x, y, joint(plan));
    }

    default long addJointToBody(long circle, long body, float x, float y, JointPlan plan) {
        return joints().add(circle, body(body), x, y, joint(plan));
    }

    default long addRigidJoint(long body, float x, float y, long other, float otherX, float otherY, JointPlan plan) {
        return joints().add(body, x, y, other, otherX, otherY, joint(plan));
    }

    default long addRigidJointToCircle(long body, float x, float y, long circle, JointPlan plan) {
        return joints().add(body, x, y, circle, joint(plan));
    }

    default long addRigidJointToPlace(long body, float x, float y, float toX, float toY, JointPlan plan) {
        return joints().add(body, x, y, toX, toY, joint(plan));
    }

    default long addRigidJointToBody(
            long body, float x, float y, long terrainBody, float toX, float toY, JointPlan plan) {
        return joints().add(body, x, y, body(terrainBody), toX, toY, joint(plan));
    }

    /** Of one circle or body, or of none but the world. */
    default long addJoint(long circle, JointPlan plan) {
        return joints().add(circle, joint(plan));
    }

    default int addJoints(long[] circles, long[] others, JointPlan plan, long[] handles) {
        return joints().addAll(circles, others, joint(plan), handles);
    }

    default void removeJoints(long[] them) {
        joints().removeAll(them);
    }

    default void removeJoint(long joint) {
        joints().remove(joint);
    }

    default void clearJoints() {
        joints().clear();
    }

    default void setJointAnchor(long joint, float x, float y) {
        joints().setAnchor(joint, x, y);
    }

    default void setJointLength(long joint, float length) {
        joints().setLength(joint, length);
    }

    default void setJointLimits(long joint, float least, float greatest) {
        joints().setLimits(joint, least, greatest);
    }

    default void setJointSpring(long joint, float frequency, float damping) {
        joints().setSpring(joint, frequency, damping);
    }

    default void setJointSpeed(long joint, float speed) {
        joints().setSpeed(joint, speed);
    }

    default void setJointAngle(long joint, float angle) {
        joints().setAngle(joint, angle);
    }

    default void setJointMaxForce(long joint, float force) {
        joints().setMaxForce(joint, force);
    }

    default void setJointMaxTorque(long joint, float torque) {
        joints().setMaxTorque(joint, torque);
    }

    default void setJointBreaking(long joint, float force, float torque) {
        joints().setBreaking(joint, force, torque);
    }

    default void setJointColliding(long joint, boolean collides) {
        joints().setColliding(joint, collides);
    }

    void applyImpulse(long handle, float x, float y);

    void setForce(long handle, float x, float y);

    void applyForce(long handle, float x, float y);

    void report(int types);

    void report(int kindA, int kindB, int types);

    void reportWalls(int kind, int types);

    int touching(int kindA, int kindB, long[] handles);

    void requestEvents();

    void setHitSpeed(float speed);

    void clear();

    int removeAll(long[] handles, int count, StaleHandles stale);

    int setPositions(long[] handles, int count, float[] positions, StaleHandles stale);

    int setVelocities(long[] handles, int count, float[] velocities, StaleHandles stale);

    int applyImpulses(long[] handles, int count, float[] impulses, StaleHandles stale);

    int setForces(long[] handles, int count, float[] forces, StaleHandles stale);

    int setKinds(long[] handles, int count, int[] kinds, StaleHandles stale);

    int explode(float x, float y, float radius, float impulse, float falloff);

    int explode(float x, float y, float radius, float impulse, float falloff, int mask);

    void setGravity(float x, float y);

    void setBounds(float minX, float minY, float maxX, float maxY);

    void step(float timeStep, int steps);

    long hash();

    /** The calls of a world. */
    static WorldCalls of(World world) {
        ClassLoader loader = WorldCalls.class.getClassLoader();
        return (WorldCalls)
                Proxy.newProxyInstance(loader, new Class<?>[] {WorldCalls.class}, (proxy, method, arguments) -> {
                    if (method.isDefault()) {
                        return InvocationHandler.invokeDefault(proxy, method, arguments);
                    }
                    try {
                        return World.class
                                .getMethod(method.getName(), method.getParameterTypes())
                                .invoke(world, arguments);
                    } catch (InvocationTargetException e) {
                        throw e.getCause();
                    }
                });
    }
}
