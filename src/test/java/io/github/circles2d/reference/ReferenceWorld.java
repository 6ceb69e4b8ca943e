package io.github.circles2d.reference;

import io.github.circles2d.ArcSide;
import io.github.circles2d.Bodies;
import io.github.circles2d.Edge;
import io.github.circles2d.Inertia;
import io.github.circles2d.Joints;
import io.github.circles2d.Kind;
import io.github.circles2d.Response;
import io.github.circles2d.StaleHandles;
import io.github.circles2d.Terrain;
import io.github.circles2d.Wall;
import io.github.circles2d.WorldCalls;
import io.github.circles2d.reference.ReferenceJoint.End;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.function.Consumer;
import java.util.function.IntConsumer;
import java.util.function.IntPredicate;

/**
 * World as docs/step.md and docs/step-bodies.md specify it, but for explosions that push bodies. Arguments are not checked: World is asked first, and
 * refuses what is not allowed.
 */
public final class ReferenceWorld implements WorldCalls {
    private static final float GREATEST_WARM_SCALE = 4f;
    private static final float GREATEST_FORCE = 1e18f;

    /** In sums of radii. */
    private static final float WAKING_NEIGHBOURS = 1.05f;

    private static final long CIRCLE = 0x636972636C653264L;
    private static final int TARGET = 9;
    private static final int GROWTH_FIELD = 10;
    private static final long CONTACTS = 0x636F6E7461637473L;
    private static final long WALLS = 0x77616C6C73746172L;
    private static final long IMPULSE = 0x696D70756C736573L;
    private static final long FIELD = 0x666965E5C2D1F01DL;
    private static final int TAG_FIELD = 1;
    private static final int KIND_FIELD = 2;
    private static final int GROUP_FIELD = 3;
    private static final int FORCE_FIELDS = 4;
    private static final int APPLIED_FORCE_FIELDS = 6;

    private static final long TURN = 0x7475726E696E6721L;
    private static final long SLEEP = 0x736C656570696E67L;
    private static final long GRIP = 0x6772697065332121L;
    private static final int FRICTION_FIELD = 11;
    private static final int ROLLING_RESISTANCE_FIELD = 12;
    private static final int TORQUE_FIELD = 13;
    private static final int APPLIED_TORQUE_FIELD = 14;
    private static final int GRAVITY_SCALE_FIELD = 15;
    private static final int DAMPING_FIELD = 16;
    private static final int GREATEST_SPEED_FIELD = 17;

    private final float restitution;
    private final int subSteps;
    private final Settings settings;

    /** By id; null if the id is free. */
    private final List<Circle> byId = new ArrayList<>();

    /** By id: how many circles have had it. */
    private final Map<Integer, Integer> generations = new HashMap<>();

    /** The impulses with which contacts ended the last step; of those that pressed. */
    private final Map<Contact.Pair, Impulses> impulseCache = new HashMap<>();

    private final Kinds kinds = new Kinds();
    private final ReferenceTerrain terrain = new ReferenceTerrain();
    private final ReferenceJoints joints = new ReferenceJoints();
    private final ReferenceRigids rigids = new ReferenceRigids();
    private final TouchEvents events = new TouchEvents();
    private Arena arena = new Arena(new float[] {0f, 0f}, new float[] {1f, 1f}, new Edge[] {Edge.WALL, Edge.WALL});
    private float[] min = arena.lowerWalls();
    private float[] max = arena.upperWalls();

    /** Where the walls were in the last step; where they are if they have jumped since. */
    private float[] startMin = min;

    private float[] startMax = max;

    private float[] gravity = {0f, 0f};
    private Surfaces surfaces = Surfaces.NONE;
    private float previousDt;
    private boolean sleeps;

    public ReferenceWorld(float restitution, int subSteps) {
        this(restitution, subSteps, Settings.DEFAULT);
    }

    public ReferenceWorld(float restitution, int subSteps, Settings settings) {
        this.restitution = restitution;
        this.subSteps = subSteps;
        this.settings = settings;
    }

    /** Sets what there is at the edges; before there are circles. */
    public ReferenceWorld edges(Edge x, Edge y) {
        arena = new Arena(arena.min(), arena.max(), new Edge[] {x, y});
        setBounds(arena.min()[0], arena.min()[1], arena.max()[0], arena.max()[1]);
        return this;
    }

    /** Sets what walls touch circles with, and circles that nobody says more of. */
    public ReferenceWorld surfaces(Surfaces all) {
        surfaces = all;
        return this;
    }

    /** Lets circles fall asleep. */
    public ReferenceWorld sleep() {
        sleeps = true;
        return this;
    }

    private StepParameters parameters(float dt) {
        return new StepParameters(
                arena,
                min,
                max,
                Numbers.minus(min, startMin),
                Numbers.minus(startMax, max),
                gravity,
                dt,
                subSteps,
                settings,
                surfaces,
                sleeps);
    }

    /** In the order of the ids. */
    private List<Circle> circles() {
        return byId.stream().filter(Objects::nonNull).toList();
    }

    private Circle find(long handle) {
        return byId.get((int) handle);
    }

    @Override
    public void step(float dt, int steps) {
        for (int k = 0; k < steps; k++) {
            List<Circle> circles = circles();
            circles.forEach(this::grow);
            float[][] velocities =
                    circles.stream().map(c -> c.depart(dt, arena)).toArray(float[][]::new);
            float warmScale = previousDt == 0f ? 1f : Numbers.min(dt / previousDt, GREATEST_WARM_SCALE);
            List<Contact> contacts = List.of();
            Step step = new Step(circles, terrain, joints, rigids, parameters(dt), kinds);
            for (Circle c : circles) {
                c.arena = arena;
                c.actingForce[0] = c.force[0];
                c.actingForce[1] = c.force[1];
                addForce(c.actingForce, c.appliedForce[0], c.appliedForce[1]);
                c.appliedForce[0] = 0f;
                c.appliedForce[1] = 0f;
                c.actingTorque = sum(c.torque, c.appliedTorque);
                c.appliedTorque = 0f;
            }
            circles.forEach(c -> c.start = c.base.clone());
            terrain.begin(parameters(dt));
            if (!circles.isEmpty() || !rigids.all().isEmpty()) {
                step.make(impulseCache, warmScale);
                contacts = step.contacts();
            }
            events.step(contacts, circles, terrain, kinds, parameters(dt));
            rigids.events.step(step.touches(), step.resting(), this::handles);
            step.fallAsleep();
            for (int i = 0; i < velocities.length; i++) {
                Circle c = circles.get(i);
                if (c.target != null) {
                    c.arrive(velocities[i]);
                    wakeNear(c);
                }
            }
            terrain.end(arena);
            previousDt = dt;
            startMin = min;
            startMax = max;
        }
    }

    @Override
    public long add(float x, float y, float radius, float mass, float vx, float vy) {
        return add(x, y, radius, mass, vx, vy, 0);
    }

    @Override
    public long add(float x, float y, float radius, float mass, float vx, float vy, int kind) {
        if (!byId.contains(null)) {
            byId.add(null);
        }
        int id = byId.indexOf(null);
        long generation = generations.merge(id, 1, Integer::sum);
        Circle c = new Circle(id, generation << 32 | id);
        byId.set(id, c);
        c.restitution = restitution;
        c.radius = radius;
        c.mass = mass;
        put(c, x, y);
        c.velocity[0] = vx;
        c.velocity[1] = vy;
        c.kind = kind;
        c.restitution = kinds.restitution(kind, restitution);
        c.wake();
        if (c.hasInfiniteMass()) {
            wakeNear(c);
        }
        return c.handle;
    }

    /** Wakes circles that sleep and may touch one that changes. */
    private void wakeNear(Circle changed) {
        wakeNear(changed.base, changed.radius);
    }

    private void wakeNear(Rigid changed) {
        wakeNear(changed.base, changed.outline.reach);
    }

    private void wakeNear(float[] place, float reach) {
        for (Circle c : circles()) {
            float[] way = arena.way(c.base, place);
            float far = WAKING_NEIGHBOURS * (c.radius + reach);
            if (c.isAsleep() && Math.abs(way[0]) <= far && Math.abs(way[1]) <= far) {
                c.wake();
            }
        }
        for (Rigid body : rigids.all()) {
            float[] way = arena.way(body.base, place);
            float far = WAKING_NEIGHBOURS * (body.outline.reach + reach);
            if (body.isAsleep() && Math.abs(way[0]) <= far && Math.abs(way[1]) <= far) {
                body.wake();
            }
        }
    }

    private void wakeKinds(IntPredicate which) {
        circles().stream().filter(c -> c.isAsleep() && which.test(c.kind)).forEach(Circle::wake);
        rigids.all().stream()
                .filter(body -> body.isAsleep() && which.test(body.kind))
                .forEach(Rigid::wake);
    }

    /** Changes a value of a kind. */
    private void change(int kind, int field, int value) {
        Response[] before = responses(kind);
        if (kinds.set(kind, field, value)) {
            boolean stays = circles().stream().anyMatch(c -> c.hasInfiniteMass() && c.kind == kind)
                    || terrain.pieces().stream().anyMatch(piece -> piece.kind == kind);
            Response[] now = responses(kind);
            wakeKinds(k -> k == kind || now[k] != before[k] || stays && now[k] != Response.IGNORE);
        }
    }

    private void change(int kind, int field, float value) {
        change(kind, field, Float.floatToIntBits(value));
    }

    private Response[] responses(int kind) {
        Response[] all = new Response[256];
        Arrays.setAll(all, other -> kinds.response(kind, other));
        return all;
    }

    @Override
    public void wakeAll() {
        circles().stream().filter(Circle::isAsleep).forEach(Circle::wake);
        rigids.all().stream().filter(Rigid::isAsleep).forEach(Rigid::wake);
    }

    @Override
    public void wake(long handle) {
        find(handle).wake();
    }

    @Override
    public boolean isAwake(long handle) {
        return !find(handle).isAsleep();
    }

    @Override
    public void addAll(float[] circles, float[] velocities, int[] kindsOfAll, long[] to) {
        for (int i = 0; i < circles.length / 4; i++) {
            float vx = velocities == null ? 0f : velocities[2 * i];
            float vy = velocities == null ? 0f : velocities[2 * i + 1];
            int kind = kindsOfAll == null ? 0 : kindsOfAll[i];
            int at = 4 * i;
            to[i] = add(circles[at], circles[at + 1], circles[at + 2], circles[at + 3], vx, vy, kind);
        }
    }

    @Override
    public void remove(long handle) {
        wakeNear(find(handle));
        joints.removed(find(handle));
        events.removed(find(handle));
        forgetImpulses(find(handle));
        rigids.removed(find(handle));
        byId.set((int) handle, null);
    }

    private void forgetImpulses(Circle c) {
        c.pieceContacts.clear();
        c.wallImpulse[0] = 0f;
        c.wallImpulse[1] = 0f;
        Arrays.fill(c.wallFriction, 0f);
        Arrays.fill(c.wallRolling, 0f);
        impulseCache.keySet().removeIf(pair -> pair.lower() == c || pair.higher() == c);
    }

    @Override
    public boolean contains(long handle) {
        int id = (int) handle;
        return id >= 0 && id < byId.size() && byId.get(id) != null && byId.get(id).handle == handle;
    }

    @Override
    public int size() {
        return circles().size();
    }

    @Override
    public void read(float[] to) {
        int k = 0;
        for (Circle c : circles()) {
            to[k++] = c.base[0];
            to[k++] = c.base[1];
            to[k++] = c.radius;
            to[k++] = c.mass;
        }
    }

    @Override
    public void readHandles(long[] to) {
        int k = 0;
        for (Circle c : circles()) {
            to[k++] = c.handle;
        }
    }

    @Override
    public void setPosition(long handle, float x, float y) {
        if (find(handle).hasInfiniteMass()) {
            find(handle).target = new float[] {arena.inside(0, x), arena.inside(1, y)};
        } else {
            teleport(handle, x, y);
        }
    }

    @Override
    public void teleport(long handle, float x, float y) {
        wakeHeld(find(handle));
        move(find(handle), x, y);
    }

    private void move(Circle c, float x, float y) {
        wakeNear(c);
        put(c, x, y);
        change(c);
    }

    /** Wakes those that joints hold to a circle. */
    private void wakeHeld(Circle c) {
        joints.of(c).stream()
                .map(joint -> joint.otherThan(c))
                .filter(Objects::nonNull)
                .forEach(Circle::wake);
    }

    private void put(Circle c, float x, float y) {
        c.target = null;
        c.pieceContacts.clear();
        c.place(0, arena.inside(0, x));
        c.place(1, arena.inside(1, y));
    }

    /** After a change by which others may lose what carries them, or be pushed. */
    private void change(Circle c) {
        c.wake();
        wakeNear(c);
    }

    @Override
    public void setVelocity(long handle, float vx, float vy) {
        find(handle).wake();
        find(handle).velocity[0] = vx;
        find(handle).velocity[1] = vy;
    }

    /** Takes its share of the rest of the way, which all steps left share evenly. */
    private void grow(Circle c) {
        if (c.stepsToGrow == 0) {
            return;
        }
        wakeNear(c);
        if (c.stepsToGrow == 1) {
            c.radius = c.radiusGrownTo;
            c.stepsToGrow = 0;
        } else {
            c.radius += (c.radiusGrownTo - c.radius) / c.stepsToGrow;
            c.stepsToGrow--;
        }
        change(c);
    }

    @Override
    public void grow(long handle, float radius, int steps) {
        find(handle).radiusGrownTo = radius;
        find(handle).stepsToGrow = steps;
    }

    @Override
    public void clear() {
        rigids.removedCircles();
        circles().forEach(c -> remove(c.handle));
    }

    @Override
    public void setRadius(long handle, float radius) {
        wakeNear(find(handle));
        find(handle).stepsToGrow = 0;
        find(handle).radius = radius;
        forgetImpulses(find(handle));
        change(find(handle));
    }

    @Override
    public void setMass(long handle, float mass) {
        Circle c = find(handle);
        c.mass = mass;
        if (c.target != null && !c.hasInfiniteMass()) {
            move(c, c.target[0], c.target[1]);
        }
        forgetImpulses(find(handle));
        change(find(handle));
    }

    @Override
    public void setRestitution(long handle, float e) {
        find(handle).restitution = e;
        find(handle).wake();
    }

    @Override
    public void setKind(long handle, int kind) {
        find(handle).kind = kind;
        find(handle).restitution = kinds.restitution(kind, find(handle).restitution);
        change(find(handle));
    }

    @Override
    public void setGroup(long handle, int group) {
        find(handle).group = group;
        change(find(handle));
    }

    @Override
    public void setTag(long handle, long tag) {
        find(handle).tag = tag;
    }

    /** The kinds by id, and -1 where there is no circle. */
    public void readKindsById(int[] to, long[] living) {
        Arrays.fill(to, -1);
        circles().forEach(c -> to[c.id] = c.kind);
        readLiving(living);
    }

    /** The tags by id, and 0 where there is no circle. */
    public void readTagsById(long[] to, long[] living) {
        Arrays.fill(to, 0);
        circles().forEach(c -> to[c.id] = c.tag);
        readLiving(living);
    }

    private void readLiving(long[] to) {
        Arrays.fill(to, 0);
        circles().forEach(c -> to[c.id / 64] |= 1L << c.id);
    }

    @Override
    public void setResponse(int kindA, int kindB, Response response) {
        if (kinds.setResponse(kindA, kindB, response)) {
            wakeKinds(kind -> kind == kindA || kind == kindB);
        }
    }

    @Override
    public Kind kind(int number) {
        throw new UnsupportedOperationException("kinds belong to a World");
    }

    @Override
    public void setPairs(int kind, int category, int mask, boolean sensor) {
        change(kind, Kinds.CATEGORY, category);
        change(kind, Kinds.MASK, mask);
        change(kind, Kinds.SENSOR, sensor ? 1 : 0);
    }

    @Override
    public void setSensesStatic(int kind, boolean senses) {
        change(kind, Kinds.SENSES_STATIC, senses ? 1 : 0);
    }

    @Override
    public void setMotion(int kind, float gravityScale, float damping, float greatestSpeed) {
        change(kind, Kinds.GRAVITY_SCALE, gravityScale);
        change(kind, Kinds.DAMPING, damping);
        change(kind, Kinds.GREATEST_SPEED, greatestSpeed);
    }

    @Override
    public void setSurface(int kind, float friction, float rollingResistance, float beltSpeed) {
        change(kind, Kinds.FRICTION, friction);
        change(kind, Kinds.ROLLING_RESISTANCE, rollingResistance);
        change(kind, Kinds.BELT_SPEED, 0f - beltSpeed);
    }

    @Override
    public void setTurning(int kind, Inertia inertia, float angularDamping) {
        change(kind, Kinds.INERTIA, inertia.ordinal());
        change(kind, Kinds.ANGULAR_DAMPING, angularDamping);
    }

    @Override
    public void setKindRestitution(int kind, float e) {
        change(kind, Kinds.RESTITUTION, e);
    }

    @Override
    public Terrain terrain() {
        throw new UnsupportedOperationException("terrain belongs to a World");
    }

    @Override
    public void setOneWay(int kind, boolean oneWay) {
        change(kind, Kinds.ONE_WAY, oneWay ? 1 : 0);
    }

    @Override
    public long addBody(float x, float y, float angle) {
        return terrain.addBody(arena.inside(0, x), arena.inside(1, y), angle);
    }

    @Override
    public long addSegment(long body, float x1, float y1, float x2, float y2, float thickness, int kind) {
        wakeAll();
        return terrain.addSegment(terrain.body(body), x1, y1, x2, y2, thickness, kind);
    }

    @Override
    public long addArc(long body, float x, float y, float radius, float from, float to, ArcSide side, int kind) {
        wakeAll();
        return terrain.addArc(terrain.body(body), x, y, radius, from, to, side == ArcSide.INNER, kind);
    }

    @Override
    public int addChain(long body, ChainShape shape, int kind, long[] handles) {
        wakeAll();
        List<Long> chain = terrain.addChain(terrain.body(body), shape, kind);
        for (int k = 0; k < chain.size(); k++) {
            handles[k] = chain.get(k);
        }
        return chain.size();
    }

    @Override
    public void removePiece(long piece) {
        wakeAll();
        events.removed(terrain.piece(piece));
        rigids.removed(terrain.piece(piece));
        terrain.remove(terrain.piece(piece));
    }

    @Override
    public void setPieceKind(long piece, int kind) {
        if (terrain.piece(piece).kind != kind) {
            wakeAll();
        }
        terrain.piece(piece).kind = kind;
    }

    @Override
    public void clearTerrain() {
        wakeAll();
        joints.removedBodies(body -> true);
        terrain.pieces().forEach(events::removed);
        terrain.pieces().forEach(rigids::removed);
        terrain.clear();
    }

    @Override
    public void setBodyVelocity(long body, float vx, float vy, float angularVelocity) {
        terrain.body(body).velocity[0] = vx + 0f;
        terrain.body(body).velocity[1] = vy + 0f;
        terrain.body(body).omega = angularVelocity + 0f;
    }

    @Override
    public void moveBodyTo(long body, float x, float y, float angle) {
        terrain.body(body).target = new float[] {arena.inside(0, x), arena.inside(1, y)};
        terrain.body(body).targetAngle = (int) Angles.units(angle);
    }

    @Override
    public void teleportBody(long body, float x, float y, float angle) {
        wakeAll();
        Body moved = terrain.body(body);
        terrain.teleport(moved, arena.inside(0, x), arena.inside(1, y), angle);
        terrain.pieces().stream().filter(piece -> piece.body == moved).forEach(rigids::forgetContacts);
    }

    @Override
    public void removeBody(long body) {
        wakeAll();
        Body removed = terrain.body(body);
        joints.removedBodies(removed::equals);
        for (Piece piece : terrain.pieces()) {
            if (piece.body == removed) {
                events.removed(piece);
                rigids.removed(piece);
            }
        }
        terrain.removeBody(removed);
    }

    // ---- bodies that are pushed

    @Override
    public Bodies bodies() {
        throw new UnsupportedOperationException("bodies belong to a World");
    }

    @Override
    public long addRigid(BodyOutline drawn, float x, float y, float angle, float mass, int kind) {
        Rigid body = rigids.add(drawn, mass);
        body.put(arena.inside(0, x), arena.inside(1, y), (int) Angles.units(angle));
        body.kind = kind;
        body.restitution = kinds.restitution(kind, restitution);
        wakeNear(body);
        return body.handle;
    }

    private long[] handles(RigidTouch.Key key) {
        long other =
                switch (key.type()) {
                    case RigidThing.BODY -> rigids.byId(key.other()).handle;
                    case RigidThing.PIECE ->
                        terrain.pieces().stream()
                                .filter(piece -> piece.id == key.other())
                                .findFirst()
                                .orElseThrow()
                                .handle;
                    case RigidThing.CIRCLE -> byId.get(key.other()).handle;
                    default -> 0;
                };
        return new long[] {rigids.byId(key.body()).handle, other};
    }

    @Override
    public void reportRigids(boolean on) {
        rigids.events.report(on);
    }

    @Override
    public int touchingRigid(long body, long[] handles) {
        List<Long> list = rigids.events.touching(rigids.find(body).id);
        for (int k = 0; k < Math.min(handles.length, list.size()); k++) {
            handles[k] = list.get(k);
        }
        return list.size();
    }

    /** The events of bodies that are pushed since the last call. */
    public List<RigidEvent> takeRigidEvents() {
        return rigids.events.take();
    }

    @Override
    public long[] rigids() {
        return rigids.all().stream().mapToLong(body -> body.handle).toArray();
    }

    @Override
    public void removeRigid(long body) {
        joints.removed(rigids.find(body));
        wakeNear(rigids.find(body));
        rigids.remove(rigids.find(body));
    }

    @Override
    public void wakeRigid(long body) {
        rigids.find(body).wake();
    }

    @Override
    public boolean isRigidAwake(long body) {
        return !rigids.find(body).isAsleep();
    }

    @Override
    public void clearRigids() {
        joints.removedRigids();
        wakeAll();
        rigids.clear();
    }

    @Override
    public void setRigidVelocity(long body, float vx, float vy, float angularVelocity) {
        rigids.find(body).wake();
        rigids.find(body).velocity[0] = vx + 0f;
        rigids.find(body).velocity[1] = vy + 0f;
        rigids.find(body).omega = angularVelocity + 0f;
    }

    @Override
    public void teleportRigid(long body, float x, float y, float angle) {
        wakeNear(rigids.find(body));
        rigids.find(body).wake();
        rigids.find(body).put(arena.inside(0, x), arena.inside(1, y), (int) Angles.units(angle));
        rigids.forgetContacts(rigids.find(body));
        wakeNear(rigids.find(body));
    }

    @Override
    public void pushRigid(long body, float x, float y, float pointX, float pointY) {
        Rigid pushed = rigids.find(body);
        pushed.wake();
        pushed.push(new float[] {x, y}, arena.way(pushed.base, place(pointX, pointY)));
    }

    @Override
    public void turnRigid(long body, float impulse) {
        rigids.find(body).wake();
        rigids.find(body).turn(impulse);
    }

    @Override
    public void pressRigid(long body, float forceX, float forceY, float torque) {
        rigids.find(body).press(forceX, forceY, torque);
    }

    @Override
    public void pressRigidAt(long body, float forceX, float forceY, float pointX, float pointY) {
        Rigid pressed = rigids.find(body);
        pressed.press(forceX, forceY, arena.way(pressed.base, place(pointX, pointY)));
    }

    @Override
    public void driveRigid(long body, float forceX, float forceY, float torque) {
        Rigid driven = rigids.find(body);
        driven.lastingForce[0] = forceX + 0f;
        driven.lastingForce[1] = forceY + 0f;
        driven.lastingTorque = torque + 0f;
    }

    @Override
    public void setRigidKind(long body, int kind) {
        wakeNear(rigids.find(body));
        rigids.find(body).wake();
        rigids.find(body).kind = kind;
        rigids.find(body).restitution = kinds.restitution(kind, rigids.find(body).restitution);
    }

    @Override
    public void setRigidGroup(long body, int group) {
        wakeNear(rigids.find(body));
        rigids.find(body).wake();
        rigids.find(body).group = group;
    }

    @Override
    public void setRigidTag(long body, long tag) {
        rigids.find(body).tag = tag;
    }

    @Override
    public void setRigidRestitution(long body, float e) {
        rigids.find(body).wake();
        rigids.find(body).restitution = e + 0f;
    }

    @Override
    public void setRigidInertia(long body, float share) {
        Rigid turned = rigids.find(body);
        turned.wake();
        turned.inertia = share * (turned.mass * turned.outline.inertia);
    }

    // ---- joints

    @Override
    public Joints joints() {
        throw new UnsupportedOperationException("joints belong to a World");
    }

    @Override
    public long addJoint(long circle, long other, JointPlan plan) {
        return added(joints.add(end(circle), end(other), null, null, plan, arena));
    }

    @Override
    public long addJoint(long circle, float x, float y, JointPlan plan) {
        return added(joints.add(end(circle), End.NOTHING, null, place(x, y), plan, arena));
    }

    @Override
    public long addJointToBody(long circle, long body, float x, float y, JointPlan plan) {
        return addAnchored(end(circle), body, x, y, plan);
    }

    private long addAnchored(End end, long body, float x, float y, JointPlan plan) {
        boolean onGround = terrain.body(body).id == 0;
        float[] place = onGround ? place(x, y) : new float[] {x + 0f, y + 0f};
        return added(joints.add(end, End.NOTHING, onGround ? null : terrain.body(body), place, plan, arena));
    }

    /** A circle, or the centroid of a body. */
    private End end(long handle) {
        return ReferenceRigids.isRigid(handle) ? End.of(rigids.find(handle), 0f, 0f) : End.of(find(handle));
    }

    @Override
    public long addRigidJoint(long body, float x, float y, long other, float otherX, float otherY, JointPlan plan) {
        End end = End.of(rigids.find(body), x, y);
        return added(joints.add(end, End.of(rigids.find(other), otherX, otherY), null, null, plan, arena));
    }

    @Override
    public long addRigidJointToCircle(long body, float x, float y, long circle, JointPlan plan) {
        return added(joints.add(End.of(rigids.find(body), x, y), end(circle), null, null, plan, arena));
    }

    @Override
    public long addRigidJointToPlace(long body, float x, float y, float toX, float toY, JointPlan plan) {
        return added(joints.add(End.of(rigids.find(body), x, y), End.NOTHING, null, place(toX, toY), plan, arena));
    }

    @Override
    public long addRigidJointToBody(
            long body, float x, float y, long terrainBody, float toX, float toY, JointPlan plan) {
        return addAnchored(End.of(rigids.find(body), x, y), terrainBody, toX, toY, plan);
    }

    /** A zero is always +0. */
    private float[] place(float x, float y) {
        return new float[] {arena.inside(0, x + 0f), arena.inside(1, y + 0f)};
    }

    @Override
    public long addJoint(long circle, JointPlan plan) {
        return added(joints.add(end(circle), End.NOTHING, null, new float[2], plan, arena));
    }

    private static long added(ReferenceJoint joint) {
        ReferenceJoints.wake(joint);
        return joint.handle;
    }

    @Override
    public int addJoints(long[] circles, long[] others, JointPlan plan, long[] handles) {
        for (int k = 0; k < circles.length; k++) {
            handles[k] = addJoint(circles[k], others[k], plan);
        }
        return circles.length;
    }

    @Override
    public void removeJoints(long[] them) {
        Arrays.stream(them).forEach(this::removeJoint);
    }

    @Override
    public void removeJoint(long joint) {
        ReferenceJoints.wake(joints.find(joint));
        joints.remove(joints.find(joint));
    }

    @Override
    public void clearJoints() {
        wakeAll();
        joints.all().forEach(joints::remove);
    }

    /** Changes a joint. Its circles wake if it is another one then. */
    private void set(long joint, Consumer<ReferenceJoint> change) {
        ReferenceJoint found = joints.find(joint);
        long before = found.hash();
        change.accept(found);
        if (found.hash() != before) {
            ReferenceJoints.wake(found);
        }
    }

    @Override
    public void setJointAnchor(long joint, float x, float y) {
        set(joint, found -> found.anchor = found.body != null ? new float[] {x + 0f, y + 0f} : place(x, y));
    }

    @Override
    public void setJointLength(long joint, float length) {
        set(joint, found -> found.length = length + 0f);
    }

    @Override
    public void setJointLimits(long joint, float least, float greatest) {
        set(joint, found -> found.limit(least, greatest));
    }

    @Override
    public void setJointSpring(long joint, float frequency, float damping) {
        set(joint, found -> {
            found.frequency = frequency + 0f;
            found.damping = damping + 0f;
        });
    }

    @Override
    public void setJointSpeed(long joint, float speed) {
        set(joint, found -> found.speed = speed + 0f);
    }

    @Override
    public void setJointAngle(long joint, float angle) {
        set(joint, found -> found.referenceOfA = (int) Angles.units(angle));
    }

    @Override
    public void setJointMaxForce(long joint, float force) {
        set(joint, found -> found.mostForce = force + 0f);
    }

    @Override
    public void setJointMaxTorque(long joint, float torque) {
        set(joint, found -> found.mostTorque = torque + 0f);
    }

    @Override
    public void setJointBreaking(long joint, float force, float torque) {
        set(joint, found -> {
            found.breakForce = force + 0f;
            found.breakTorque = torque + 0f;
        });
    }

    @Override
    public void setJointColliding(long joint, boolean collides) {
        set(joint, found -> found.collides = collides);
    }

    @Override
    public void applyImpulse(long handle, float impulseX, float impulseY) {
        Circle c = find(handle);
        c.wake();
        c.velocity[0] = Numbers.limitSpeed(c.velocity[0] + c.inverseMass() * impulseX);
        c.velocity[1] = Numbers.limitSpeed(c.velocity[1] + c.inverseMass() * impulseY);
    }

    @Override
    public void setForce(long handle, float x, float y) {
        // A zero is always +0.
        find(handle).force[0] = x + 0f;
        find(handle).force[1] = y + 0f;
    }

    @Override
    public void applyForce(long handle, float x, float y) {
        addForce(find(handle).appliedForce, x, y);
    }

    private static void addForce(float[] to, float x, float y) {
        to[0] = sum(to[0], x);
        to[1] = sum(to[1], y);
    }

    /** Within the greatest force, and never -0. */
    private static float sum(float a, float b) {
        return Numbers.clamp(a + b, -GREATEST_FORCE, GREATEST_FORCE) + 0f;
    }

    @Override
    public void setWallSurface(Wall wall, float friction, float rollingResistance, float beltSpeed) {
        int number = wall.ordinal();
        long before = surfaces.hash();
        surfaces = surfaces.withWall(number, friction, rollingResistance, Surfaces.turned(number, beltSpeed));
        boolean changes = surfaces.hash() != before;
        float side = number % 2 == 0 ? 1f : -1f;
        circles().stream()
                .filter(c -> changes && c.isAsleep() && side * c.wallImpulse[number / 2] > 0f)
                .forEach(Circle::wake);
        for (RigidContact.Saved saved : changes ? rigids.contacts() : List.<RigidContact.Saved>of()) {
            rigids.all().stream()
                    .filter(body -> body.id == saved.body() && body.isAsleep())
                    .filter(body -> saved.type() == RigidThing.WALL && saved.other() == number && saved.impulse() > 0f)
                    .forEach(Rigid::wake);
        }
    }

    @Override
    public void setFriction(long handle, float friction) {
        change(find(handle));
        find(handle).friction = friction + 0f;
    }

    @Override
    public void setRollingResistance(long handle, float resistance) {
        change(find(handle));
        find(handle).rollingResistance = resistance + 0f;
    }

    @Override
    public void setGravityScale(long handle, float scale) {
        find(handle).wake();
        find(handle).gravityScale = scale + 0f;
    }

    @Override
    public void setDamping(long handle, float damping) {
        find(handle).wake();
        find(handle).damping = damping + 0f;
    }

    @Override
    public void setGreatestSpeed(long handle, float speed) {
        find(handle).wake();
        find(handle).greatestSpeed = speed + 0f;
    }

    @Override
    public void setAngle(long handle, float radians) {
        find(handle).wake();
        wakeHeld(find(handle));
        find(handle).angle = (int) Math.round(radians / (Math.PI / (1L << 31)));
    }

    @Override
    public void setAngularVelocity(long handle, float angularVelocity) {
        change(find(handle));
        find(handle).angularVelocity = angularVelocity + 0f;
    }

    @Override
    public void setTorque(long handle, float torque) {
        find(handle).torque = torque + 0f;
    }

    @Override
    public void applyTorque(long handle, float torque) {
        find(handle).appliedTorque = sum(find(handle).appliedTorque, torque);
    }

    @Override
    public void applyAngularImpulse(long handle, float impulse) {
        Circle c = find(handle);
        c.wake();
        float inverseInertia = c.inverseMass() * kinds.inverseInertia(c.kind);
        c.angularVelocity = Numbers.limitSpeed(c.angularVelocity + impulse / c.radius * inverseInertia / c.radius);
    }

    @Override
    public int setAngularVelocities(long[] handles, int count, float[] angularVelocities, StaleHandles stale) {
        return forEachThatLives(handles, count, k -> setAngularVelocity(handles[k], angularVelocities[k]));
    }

    @Override
    public void report(int types) {
        events.report(types);
    }

    @Override
    public void report(int kindA, int kindB, int types) {
        events.report(kindA, kindB, types);
    }

    @Override
    public void reportWalls(int kind, int types) {
        events.reportWalls(kind, types);
    }

    @Override
    public int touching(int kindA, int kindB, long[] handles) {
        List<long[]> pairs = events.touching(kindA, kindB);
        for (int k = 0; k < Math.min(pairs.size(), handles.length / 2); k++) {
            System.arraycopy(pairs.get(k), 0, handles, 2 * k, 2);
        }
        return pairs.size();
    }

    @Override
    public void requestEvents() {
        events.request();
    }

    /** Of joints that went by themselves since the last call. */
    public List<JointEvent> takeJointEvents() {
        return joints.takeEvents();
    }

    /** Of the joints in the order of their ids, what they did in the last step; nothing before the first one. */
    public List<JointLoad> jointLoads() {
        float dt = previousDt == 0f ? 1f : previousDt;
        return joints.all().stream()
                .map(joint -> new JointLoad(joint.handle, joint.forceX(dt), joint.forceY(dt), joint.torque(dt)))
                .toList();
    }

    /** The events that were requested. */
    public List<Event> takeRequestedEvents() {
        return events.takeRequested();
    }

    @Override
    public void setHitSpeed(float speed) {
        events.setHitSpeed(speed);
    }

    /** The events since the last call. */
    public List<Event> takeEvents() {
        return events.take();
    }

    @Override
    public int removeAll(long[] handles, int count, StaleHandles stale) {
        return forEachThatLives(handles, count, k -> remove(handles[k]));
    }

    @Override
    public int setPositions(long[] handles, int count, float[] positions, StaleHandles stale) {
        return forEachThatLives(handles, count, k -> setPosition(handles[k], positions[2 * k], positions[2 * k + 1]));
    }

    @Override
    public int setVelocities(long[] handles, int count, float[] velocities, StaleHandles stale) {
        return forEachThatLives(handles, count, k -> setVelocity(handles[k], velocities[2 * k], velocities[2 * k + 1]));
    }

    @Override
    public int applyImpulses(long[] handles, int count, float[] impulses, StaleHandles stale) {
        return forEachThatLives(handles, count, k -> applyImpulse(handles[k], impulses[2 * k], impulses[2 * k + 1]));
    }

    @Override
    public int setForces(long[] handles, int count, float[] forces, StaleHandles stale) {
        return forEachThatLives(handles, count, k -> setForce(handles[k], forces[2 * k], forces[2 * k + 1]));
    }

    @Override
    public int setKinds(long[] handles, int count, int[] kindsOfAll, StaleHandles stale) {
        return forEachThatLives(handles, count, k -> setKind(handles[k], kindsOfAll[k]));
    }

    /** Returns how many handles are stale. */
    private int forEachThatLives(long[] handles, int count, IntConsumer change) {
        int skipped = 0;
        for (int k = 0; k < count; k++) {
            if (contains(handles[k])) {
                change.accept(k);
            } else {
                skipped++;
            }
        }
        return skipped;
    }

    @Override
    public int explode(float x, float y, float radius, float impulse, float falloff) {
        return explode(circles(), x, y, radius, impulse, falloff);
    }

    @Override
    public int explode(float x, float y, float radius, float impulse, float falloff, int mask) {
        List<Circle> some = circles().stream()
                .filter(c -> (kinds.get(c.kind, Kinds.CATEGORY) & mask) != 0)
                .toList();
        return explode(some, x, y, radius, impulse, falloff);
    }

    private int explode(List<Circle> circles, float x, float y, float radius, float impulse, float falloff) {
        int pushed = 0;
        for (Circle c : circles) {
            float[] d = arena.way(new float[] {arena.inside(0, x), arena.inside(1, y)}, c.base);
            float distance = Numbers.length(d[0], d[1]);
            float gap = Numbers.max(distance - c.radius, 0f);
            if (c.hasInfiniteMass() || distance == 0f || gap > radius && gap >= radius + falloff) {
                continue;
            }
            float share = 1f;
            if (gap > radius) {
                share = Numbers.min((radius + falloff - gap) / falloff, 1f);
            }
            applyImpulse(c.handle, impulse * share * (d[0] / distance), impulse * share * (d[1] / distance));
            pushed++;
        }
        return pushed;
    }

    @Override
    public void setGravity(float gx, float gy) {
        gravity = new float[] {gx, gy};
    }

    @Override
    public void setBounds(float minX, float minY, float maxX, float maxY) {
        float[] oldMin = min;
        float[] oldMax = max;
        arena = arena.at(new float[] {minX, minY}, new float[] {maxX, maxY});
        min = arena.lowerWalls();
        max = arena.upperWalls();
        wakeAtStatics(oldMin, oldMax);
        float[] fromMin = startMin;
        float[] fromMax = startMax;
        startMin = starts(fromMin, min);
        startMax = starts(fromMax, max);
        if (jumps(fromMin, startMin) || jumps(fromMax, startMax)) {
            wakeAll();
        }
        for (Rigid body : rigids.all()) {
            for (int a = 0; a < 2; a++) {
                float inside = arena.inside(a, Numbers.clamp(body.base[a], min[a], max[a]));
                if (inside != body.base[a]) {
                    wakeAll();
                }
                body.rest[a] = inside == body.base[a] ? body.rest[a] : 0f;
                body.base[a] = inside;
            }
        }
        for (Circle c : circles()) {
            for (int a = 0; a < 2; a++) {
                float low = min[a] + margin(startMin[a], min[a], c);
                float inside = Numbers.clamp(c.base[a], low, max[a] - margin(startMax[a], max[a], c));
                if (inside != c.base[a]) {
                    c.place(a, inside);
                    c.wake();
                }
                if (c.target != null) {
                    c.target[a] = Numbers.clamp(c.target[a], min[a], max[a]);
                }
            }
        }
    }

    /** Walls that are set farther in may take along circles of infinite mass: those wake that may lie at them, or hang from them. */
    private void wakeAtStatics(float[] oldMin, float[] oldMax) {
        List<Circle> still = circles().stream().filter(Circle::hasInfiniteMass).toList();
        boolean movesIn = false;
        for (int a = 0; a < 2 && !still.isEmpty(); a++) {
            movesIn |= min[a] > oldMin[a] || max[a] < oldMax[a];
            float far = WAKING_NEIGHBOURS
                    * (float) still.stream().mapToDouble(c -> c.radius).max().orElse(0);
            for (Circle c : circles()) {
                float reach = WAKING_NEIGHBOURS * c.radius;
                boolean near = min[a] > oldMin[a] && c.base[a] - reach < min[a] + far
                        || max[a] < oldMax[a] && c.base[a] + reach > max[a] - far;
                if (near && c.isAsleep()) {
                    c.wake();
                }
            }
            for (Rigid body : rigids.all()) {
                float reach = WAKING_NEIGHBOURS * body.outline.reach;
                boolean near = min[a] > oldMin[a] && body.base[a] - reach < min[a] + far
                        || max[a] < oldMax[a] && body.base[a] + reach > max[a] - far;
                if (near && body.isAsleep()) {
                    body.wake();
                }
            }
        }
        if (movesIn) {
            still.forEach(this::wakeHeldBy);
        }
    }

    private void wakeHeldBy(Circle still) {
        joints.of(still).stream()
                .map(joint -> joint.otherThan(still))
                .filter(o -> o != null && !o.hasInfiniteMass())
                .forEach(Circle::wake);
    }

    /** A wall jumps if it moves farther than every radius. */
    private float[] starts(float[] from, float[] to) {
        double greatest = circles().stream().mapToDouble(c -> c.radius).max().orElse(0);
        float[] start = from.clone();
        for (int a = 0; a < 2; a++) {
            start[a] = from[a] == to[a] || Math.abs(to[a] - from[a]) > greatest ? to[a] : from[a];
        }
        return start;
    }

    private boolean jumps(float[] from, float[] start) {
        return !Arrays.equals(from, start);
    }

    /** How far a circle is kept from a wall: not at all if the next step pushes it. */
    private static float margin(float from, float to, Circle c) {
        boolean pushed = from != to && Math.abs(to - from) <= c.radius;
        return c.hasInfiniteMass() || pushed ? 0f : c.radius;
    }

    private long hashOfSleep() {
        long sum = 0;
        for (Circle c : circles()) {
            if (c.rest != 0 || c.turned != 0 || !areZeros(c.drift)) {
                sum += absorb(absorb(absorb(absorb(SLEEP, c.id), c.rest), c.drift), c.turned);
            }
        }
        return sum;
    }

    /** Sets if circles of a kind fall asleep. */
    @Override
    public void setSleeps(int kind, boolean sleeps) {
        change(kind, Kinds.AWAKE, sleeps ? 0 : 1);
    }

    @Override
    public long hash() {
        boolean moved =
                startMin[0] != min[0] || startMin[1] != min[1] || startMax[0] != max[0] || startMax[1] != max[1];
        long sum = moved ? absorb(WALLS, start(0), start(1), startOfUpper(0), startOfUpper(1)) : 0;
        if (!settings.equals(Settings.DEFAULT)) {
            float[] numbers = {settings.threshold(), settings.frequency(), settings.damping(), settings.pushOutSpeed()};
            sum += absorb(CONTACTS, numbers);
        }
        sum += kinds.hash() + arena.hash() + surfaces.hash() + terrain.hash() + joints.hash() + rigids.hash();
        sum += sleeps ? hashOfSleep() : 0;
        for (Circle c : circles()) {
            sum += hashOfField(TAG_FIELD, c.id, c.tag);
            sum += hashOfField(KIND_FIELD, c.id, c.kind) + hashOfField(GROUP_FIELD, c.id, c.group);
            for (int a = 0; a < 2; a++) {
                sum += hashOfField(FORCE_FIELDS + a, c.id, Float.floatToRawIntBits(c.force[a]));
                sum += hashOfField(APPLIED_FORCE_FIELDS + a, c.id, Float.floatToRawIntBits(c.appliedForce[a]));
            }
            sum += hashOfOwn(GRAVITY_SCALE_FIELD, c.id, c.gravityScale)
                    + hashOfOwn(DAMPING_FIELD, c.id, c.damping)
                    + hashOfOwn(GREATEST_SPEED_FIELD, c.id, c.greatestSpeed);
            sum += hashOfTurning(c) + terrain.hashOfContacts(c);
            long h = absorb(absorb(CIRCLE, c.id), c.base);
            h = absorb(absorb(h, c.radius, c.mass), c.displacement);
            sum += absorb(absorb(absorb(h, c.velocity), c.restitution), c.wallImpulse);
            if (c.target != null) {
                sum += absorb(absorb(absorb(FIELD, TARGET), c.id), c.target);
            }
            if (c.stepsToGrow > 0) {
                int radius = Float.floatToRawIntBits(c.radiusGrownTo);
                sum += hashOfField(GROWTH_FIELD, c.id, (long) c.stepsToGrow << 32 | radius);
            }
        }
        for (Map.Entry<Contact.Pair, Impulses> entry : impulseCache.entrySet()) {
            Contact.Pair pair = entry.getKey();
            Impulses impulses = entry.getValue();
            sum += absorb(absorb(absorb(IMPULSE, pair.lower().id), pair.higher().id), impulses.normal());
            if (!areZeros(impulses.friction(), impulses.rolling())) {
                long h = absorb(absorb(GRIP, pair.lower().id), pair.higher().id);
                sum += absorb(h, impulses.friction(), impulses.rolling());
            }
        }
        return sum;
    }

    private static long hashOfTurning(Circle c) {
        long sum = hashOfField(TORQUE_FIELD, c.id, Float.floatToRawIntBits(c.torque));
        sum += hashOfField(APPLIED_TORQUE_FIELD, c.id, Float.floatToRawIntBits(c.appliedTorque));
        sum += hashOfOwn(FRICTION_FIELD, c.id, c.friction)
                + hashOfOwn(ROLLING_RESISTANCE_FIELD, c.id, c.rollingResistance);
        float[] grips = {c.wallFriction[0], c.wallFriction[1], c.wallRolling[0], c.wallRolling[1]};
        if (c.angle != 0 || !areZeros(c.angularVelocity) || !areZeros(grips)) {
            sum += absorb(absorb(absorb(absorb(TURN, c.id), c.angle), c.angularVelocity), grips);
        }
        return sum;
    }

    /** Not -0 either. */
    private static boolean areZeros(float... values) {
        int bits = 0;
        for (float value : values) {
            bits |= Float.floatToRawIntBits(value);
        }
        return bits == 0;
    }

    /** Of a field that has no number at first. */
    private static long hashOfOwn(int field, int id, float value) {
        long h = absorb(absorb(FIELD, field), id);
        int bits = Float.floatToRawIntBits(value);
        return Float.isNaN(value) ? 0 : absorb(absorb(h, bits), bits >> 31);
    }

    private static long hashOfField(int field, int id, long value) {
        long h = absorb(absorb(FIELD, field), id);
        return value == 0 ? 0 : absorb(absorb(h, (int) value), (int) (value >> 32));
    }

    /** Where the lower wall of an axis starts; the bounds if there is none. */
    private float start(int axis) {
        return arena.edges()[axis] == Edge.WALL ? startMin[axis] : arena.min()[axis];
    }

    private float startOfUpper(int axis) {
        return arena.edges()[axis] == Edge.WALL ? startMax[axis] : arena.max()[axis];
    }

    static long absorb(long hash, int word) {
        long h = (hash ^ (word & 0xFFFFFFFFL)) * 0x9E3779B97F4A7C15L;
        return h ^ (h >>> 32);
    }

    static long absorb(long hash, float... values) {
        long h = hash;
        for (float value : values) {
            h = absorb(h, Float.floatToRawIntBits(value));
        }
        return h;
    }
}
