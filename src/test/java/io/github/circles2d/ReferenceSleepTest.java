package io.github.circles2d;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.circles2d.reference.BodyOutline;
import io.github.circles2d.reference.ChainShape;
import io.github.circles2d.reference.Event;
import io.github.circles2d.reference.JointPlan;
import io.github.circles2d.reference.ReferenceWorld;
import io.github.circles2d.reference.RigidEvent;
import io.github.circles2d.reference.Surfaces;
import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import java.util.function.Consumer;
import org.junit.jupiter.api.Test;

/**
 * Random heaps that fall asleep, and calls that disturb them: World has the same bits, events and sleepers as its description in the plainest
 * form, after every call. The system property circles2d.fuzz.sleep sets the number of programs, circles2d.fuzz.seed the first one's seed.
 */
class ReferenceSleepTest {
    private static final int PROGRAMS = Integer.getInteger("circles2d.fuzz.sleep", 60);
    private static final long SEED = Long.getLong("circles2d.fuzz.seed", 1);
    private static final float SIZE = 10f;
    private static final int SENSOR = 7;
    private static final long GROUND = 0;

    @Test
    void heapsSleepAndWakeAsTheReferencesDo() {
        run(false, false);
    }

    @Test
    void whatJointsHoldSleepsAndWakesAsTheReferencesDo() {
        run(true, false);
    }

    @Test
    void heapsWithBodiesSleepAndWakeAsTheReferencesDo() {
        run(false, true);
    }

    @Test
    void bodiesThatJointsHoldSleepAndWakeAsTheReferencesDo() {
        run(true, true);
    }

    private static void run(boolean jointed, boolean crated) {
        int asleep = 0;
        int woken = 0;
        int bodiesAsleep = 0;
        for (int k = 0; k < PROGRAMS; k++) {
            Program program = new Program(SEED + k, jointed, crated);
            program.run();
            asleep += program.fellAsleep;
            woken += program.woke;
            bodiesAsleep += program.bodiesFellAsleep;
        }
        assertThat(bodiesAsleep)
                .as("bodies that fell asleep")
                .isGreaterThanOrEqualTo(!crated ? 0 : jointed ? PROGRAMS : 2 * PROGRAMS);
        assertThat(asleep).as("circles that fell asleep").isGreaterThan(3 * PROGRAMS);
        assertThat(woken).as("circles that woke").isGreaterThan(PROGRAMS);
    }

    private static final class Program {
        private final long seed;
        private final SplittableRandom random;
        private final boolean mixed;
        private final boolean wraps;
        private final boolean terrain;
        private final boolean jointed;
        private final boolean crated;
        private final Surfaces surfaces;
        private World world;
        private ReferenceWorld reference;
        private List<Consumer<WorldCalls>> calls = new ArrayList<>();
        private ByteBuffer snapshot;
        private List<Consumer<WorldCalls>> callsUpToSnapshot;
        private final List<Long> bodies = new ArrayList<>();
        private List<Long> bodiesOfSnapshot;
        private final List<Consumer<WorldCalls>> reports = new ArrayList<>();
        private List<Long> sleeping = List.of();
        int fellAsleep;
        int bodiesFellAsleep;
        int woke;

        Program(long seed, boolean jointed, boolean crated) {
            this.seed = seed;
            this.jointed = jointed;
            this.crated = crated;
            random = new SplittableRandom(seed);
            mixed = random.nextInt(3) == 0;
            wraps = random.nextInt(4) == 0;
            terrain = random.nextInt(3) == 0;
            surfaces = random.nextInt(3) == 0
                    ? Surfaces.NONE
                    : new Surfaces(0.6f, random.nextInt(2) == 0 ? 0f : 0.1f, new float[][] {
                        {0.6f, 0f, 0f}, {0.6f, 0f, 0f}, {0.6f, 0f, 0f}, {0.6f, 0f, 0f}
                    });
        }

        void run() {
            world = newWorld();
            reference = newReference();
            try {
                if (random.nextBoolean()) {
                    setReport(c -> c.report(Events.BEGIN | Events.END | Events.HIT | Events.WALL));
                }
                both("setGravity", c -> c.setGravity(0f, -10f));
                if (terrain) {
                    addTerrain();
                }
                int count = 3 + random.nextInt(10);
                for (int k = 0; k < count; k++) {
                    add(0.5f + 9f * (float) random.nextDouble(), 0.6f + 3f * (float) random.nextDouble());
                }
                if (crated) {
                    setReport(c -> c.reportRigids(true));
                    both("setPairs", c -> c.setPairs(SENSOR, 1, -1, true));
                    both("add", c -> c.add(5f, 0.5f, 0.9f, Float.POSITIVE_INFINITY, 0f, 0f, SENSOR));
                }
                for (int k = 0; k < (crated ? 1 + random.nextInt(4) : 0); k++) {
                    addCrate(0.5f + 9f * (float) random.nextDouble(), 0.6f + 3f * (float) random.nextDouble());
                }
                if (jointed) {
                    both("setMotion", c -> c.setMotion(0, 1f, 2f, 50f));
                    for (int k = 0; k < count; k++) {
                        addJoint();
                    }
                }
                step(0.1f, 25);
                for (int k = 0; k < 25; k++) {
                    if (jointed && random.nextBoolean()) {
                        changeJoints();
                    } else if (crated && random.nextBoolean()) {
                        changeCrates();
                    } else {
                        disturb();
                    }
                    step(random.nextInt(3) == 0 ? 0.1f : 1 / 60f, 1 + random.nextInt(12));
                    if (random.nextInt(3) == 0) {
                        step(0.1f, 14);
                    }
                }
            } finally {
                world.close();
            }
        }

        private World newWorld() {
            World.Builder builder = WorldScenes.jvm()
                    .bounds(0, 0, SIZE, SIZE)
                    .edges(wraps ? Edge.WRAP : Edge.WALL, Edge.WALL)
                    .restitution(0.2f)
                    .sleep(true);
            World built = WorldScenes.onThreads(seed % 3 == 0 ? 3 : 1, WorldScenes.with(surfaces, builder));
            reports.forEach(report -> report.accept(WorldCalls.of(built)));
            return built;
        }

        private ReferenceWorld newReference() {
            ReferenceWorld fresh = new ReferenceWorld(0.2f, 4);
            fresh.setBounds(0, 0, SIZE, SIZE);
            return fresh.edges(wraps ? Edge.WRAP : Edge.WALL, Edge.WALL)
                    .surfaces(surfaces)
                    .sleep();
        }

        private void setReport(Consumer<WorldCalls> report) {
            reports.add(report);
            both("report", report);
        }

        private void addTerrain() {
            both("addSegment", c -> c.addSegment(GROUND, 0f, 2f, 4f, 1f, 0f, 1));
            both(
                    "addChain",
                    c -> c.addChain(
                            GROUND,
                            new ChainShape(5f, 1.5f, new float[][] {{7f, 1f}, {9f, 1.5f}}, false),
                            0,
                            new long[4]));
            long[] body = new long[1];
            both("addBody", c -> body[0] = c.addBody(8f, 3f, 0f));
            bodies.add(body[0]);
            both("addSegment", c -> c.addSegment(bodies.get(0), -1f, 0f, 1f, 0f, 0.2f, 2));
        }

        private void add(float x, float y) {
            float radius =
                    mixed ? 0.15f + 0.6f * (float) random.nextDouble() : 0.4f + 0.2f * (float) random.nextDouble();
            float mass = random.nextInt(8) == 0 ? Float.POSITIVE_INFINITY : radius * radius;
            int kind = Math.max(0, random.nextInt(5) - 2);
            both("add", c -> c.add(x, y, radius, mass, 0f, 0f, kind));
        }

        private void addCrate(float x, float y) {
            float size = 0.5f + 0.6f * (float) random.nextDouble();
            BodyOutline outline =
                    switch (random.nextInt(3)) {
                        case 0 -> BodyOutline.box(size, 0.6f * size);
                        case 1 -> BodyOutline.capsule(size, 0.3f * size);
                        default -> BodyOutline.box(1.5f * size, 0.2f);
                    };
            float mass = random.nextInt(4) == 0 ? 5f : size * size;
            int kind = Math.max(0, random.nextInt(5) - 2);
            float angle = random.nextBoolean() ? 0f : little();
            both("addRigid", c -> c.addRigid(outline, x, y, angle, mass, kind));
        }

        private void changeCrates() {
            long[] all = reference.rigids();
            float a = little();
            float b = little();
            if (all.length == 0 || random.nextInt(12) == 0) {
                addCrate(5f + 20f * a, 3f + 5f * b);
                return;
            }
            long body = all[random.nextInt(all.length)];
            switch (random.nextInt(16)) {
                case 0 -> both("removeRigid", c -> c.removeRigid(body));
                case 1 -> both("setRigidVelocity", c -> c.setRigidVelocity(body, 5f * a, 5f * b, a));
                case 2 -> both("teleportRigid", c -> c.teleportRigid(body, 5f + 20f * a, 3f + 5f * b, a));
                case 3 -> {
                    float x = world.bodies().x(body) + a;
                    both("pushRigid", c -> c.pushRigid(body, a, b, x, 1f));
                }
                case 4 -> both("turnRigid", c -> c.turnRigid(body, a));
                case 5 -> both("pressRigid", c -> c.pressRigid(body, 10f * a, 10f * b, a));
                case 6 -> both("driveRigid", c -> c.driveRigid(body, 4f * a, 4f * b, a > 0f ? a : 0f));
                case 7 -> both("driveRigid", c -> c.driveRigid(body, 0f, 0f, 0f));
                case 8 -> both("setRigidKind", c -> c.setRigidKind(body, a > 0f ? 1 : 0));
                case 9 -> both("setRigidGroup", c -> c.setRigidGroup(body, a > 0f ? 1 : 0));
                case 10 -> both("setRigidRestitution", c -> c.setRigidRestitution(body, Math.abs(a)));
                case 11 -> {
                    float share = a > 0f ? Float.POSITIVE_INFINITY : 1f;
                    both("setRigidInertia", c -> c.setRigidInertia(body, share));
                }
                case 12 -> both("clearRigids", WorldCalls::clearRigids);
                case 14 -> both("wakeRigid", c -> c.wakeRigid(body));
                case 13 -> both("pressRigidAt", c -> c.pressRigidAt(body, 10f * a, 10f * b, 5f, 1f));
                default -> both("setRigidVelocity", c -> c.setRigidVelocity(body, 0.3f * a, 0.3f * b, 0f));
            }
        }

        private long some() {
            long[] handles = new long[world.size()];
            world.readHandles(handles);
            return handles[random.nextInt(handles.length)];
        }

        private float little() {
            return 0.4f * ((float) random.nextDouble() - 0.5f);
        }

        private void disturb() {
            if (world.size() == 0) {
                add(5f, 1f);
                return;
            }
            long one = some();
            float a = little();
            float b = little();
            switch (random.nextInt(46)) {
                case 0 -> add(0.5f + 9f * (float) random.nextDouble(), 4f + 4f * (float) random.nextDouble());
                case 1 -> both("remove", c -> c.remove(one));
                case 2 -> both("setVelocity", c -> c.setVelocity(one, 10f * a, 10f * b));
                case 3 -> both("applyImpulse", c -> c.applyImpulse(one, a, b));
                case 4 -> both("setGravity", c -> c.setGravity(a, -10f));
                case 5 -> both("setGravity", c -> c.setGravity(0f, a > 0f ? 0f : -10f));
                case 6 -> both("setBounds", c -> c.setBounds(0f, 0f, wraps ? SIZE : SIZE + a, SIZE));
                case 7 -> both("setBounds", c -> c.setBounds(0f, 0.5f * b, SIZE, SIZE));
                case 8 -> both("setForce", c -> c.setForce(one, 10f * a, 10f * b));
                case 9 -> both("setForce", c -> c.setForce(one, 0f, 0f));
                case 10 -> both("applyForce", c -> c.applyForce(one, 10f * a, 0f));
                case 11 -> both("wake", c -> c.wake(one));
                case 12 -> both("wakeAll", WorldCalls::wakeAll);
                case 13 -> both("setSleeps", c -> c.setSleeps(1, a > 0f));
                case 14 -> both("setPosition", c -> c.setPosition(one, 5f + 20f * a, 3f + 5f * b));
                case 15 -> both("teleport", c -> c.teleport(one, 5f + 20f * a, 3f + 5f * b));
                case 16 -> both("setRadius", c -> c.setRadius(one, 0.5f + a));
                case 17 -> both("setMass", c -> c.setMass(one, a > 0f ? 1f + a : Float.POSITIVE_INFINITY));
                case 18 -> both("grow", c -> c.grow(one, 0.5f + a, 3));
                case 19 -> both("setKind", c -> c.setKind(one, a > 0f ? 1 : 0));
                case 20 -> both("setGroup", c -> c.setGroup(one, a > 0f ? 1 : 0));
                case 21 -> saveOrRestore();
                case 22 -> joint(one);
                case 23 -> {
                    if (terrain) {
                        moveBody(a, b);
                    } else {
                        both("setTorque", c -> c.setTorque(one, a > 0f ? a : 0f));
                    }
                }
                case 24 -> both("applyForce", c -> c.applyForce(one, 100f * a, 100f * b));
                case 25 -> both("setAngularVelocity", c -> c.setAngularVelocity(one, 10f * a));
                case 26 -> both("setFriction", c -> c.setFriction(one, a > 0f ? 0.5f : 0f));
                case 27 -> both("setRollingResistance", c -> c.setRollingResistance(one, a > 0f ? 0.1f : 0f));
                case 28 -> both("setBounds", c -> c.setBounds(0f, a > 0f ? 0f : -2f, SIZE, SIZE));
                case 30 -> both("setMotion", c -> c.setMotion(1, 1f, a > 0f ? 4f : 0f, 50f));
                case 29 -> both("setGravity", c -> c.setGravity(0.02f * a, -10f + 0.02f * b));
                case 31 -> both("setGravityScale", c -> c.setGravityScale(one, a > 0f ? 1f + 0.1f * b : Float.NaN));
                case 32 -> both("setDamping", c -> c.setDamping(one, a > 0f ? 4f : Float.NaN));
                case 33 -> both("setGreatestSpeed", c -> c.setGreatestSpeed(one, a > 0f ? 5f : Float.NaN));
                case 34, 35, 36, 37, 38, 39, 40, 41 -> changeKind(random.nextInt(3), a, b);
                case 44 -> both("setAngle", c -> c.setAngle(one, 8f * a));
                case 42 -> both("setWallSurface", c -> c.setWallSurface(Wall.MIN_Y, a > 0f ? 0.5f : 0f, 0f, b));
                case 43 -> both("setWallSurface", c -> c.setWallSurface(Wall.MAX_X, 0.5f + a, 0f, 0f));
                default -> both("setVelocity", c -> c.setVelocity(one, a, 0f));
            }
        }

        /** Wakes circles of the kind, and perhaps others. Kinds are soon what they were: what falls through all never sleeps again. */
        private void changeKind(int kind, float a, float b) {
            int other = random.nextInt(3);
            switch (random.nextInt(7)) {
                case 0 -> {
                    Response response = a > 0f ? Response.IGNORE : Response.SENSE;
                    both("setResponse", c -> c.setResponse(kind, other, response));
                    step(1 / 60f, 1 + random.nextInt(3));
                    both("setResponse", c -> c.setResponse(kind, other, Response.BY_MASK));
                }
                case 1 -> {
                    both("setPairs", c -> c.setPairs(kind, 1 << kind, ~(1 << other), a > 0.1f));
                    step(1 / 60f, 1 + random.nextInt(3));
                    both("setPairs", c -> c.setPairs(kind, 1, -1, false));
                }
                case 2 -> both("setSurface", c -> c.setSurface(kind, a > 0f ? 0.5f + a : Float.NaN, 0f, b));
                case 3 -> both("setTurning", c -> c.setTurning(kind, a > 0f ? Inertia.RING : Inertia.DISC, 1f + b));
                case 4 -> both("setOneWay", c -> c.setOneWay(kind, a > 0f));
                case 5 -> both("setMotion", c -> c.setMotion(kind, 1f + a, 1f + b, 50f));
                default -> both("setSensesStatic", c -> c.setSensesStatic(kind, a > 0f));
            }
        }

        private void moveBody(float a, float b) {
            long body = bodies.get(0);
            if (random.nextBoolean()) {
                both("setBodyVelocity", c -> c.setBodyVelocity(body, 2f * a, 2f * b, a > 0.1f ? 3f * a : 0f));
            } else {
                both("setBodyVelocity", c -> c.setBodyVelocity(body, 0f, 0f, 0f));
            }
        }

        private void joint(long one) {
            if (random.nextBoolean()) {
                both("clearJoints", WorldCalls::clearJoints);
            } else if (world.mass(one) < Float.POSITIVE_INFINITY) {
                both("addJoint", c -> c.addJoint(one, 5f, 5f, JointPlan.of(JointPlan.Kind.DISTANCE)));
            }
        }

        private void changeJoints() {
            int limit = world.joints().idLimit();
            long joint = limit == 0 ? 0 : world.joints().handle(random.nextInt(limit));
            if (joint == 0) {
                addJoint();
                return;
            }
            float a = little();
            switch (random.nextInt(14)) {
                case 0 -> both("removeJoint", c -> c.removeJoint(joint));
                case 1 -> both("setJointColliding", c -> c.setJointColliding(joint, a > 0f));
                case 2 -> both("setJointBreaking", c -> c.setJointBreaking(joint, 200f * Math.abs(a), 100f));
                case 3 -> ifAllowed("setJointLength", c -> c.setJointLength(joint, 1f + a));
                case 4 -> ifAllowed("setJointLimits", c -> c.setJointLimits(joint, 0.5f, 2f + a));
                case 5 -> ifAllowed("setJointSpring", c -> c.setJointSpring(joint, 4f + 10f * a, 0.5f));
                case 6 -> ifAllowed("setJointSpeed", c -> c.setJointSpeed(joint, a > 0f ? a : 0f));
                case 7 -> ifAllowed("setJointAngle", c -> c.setJointAngle(joint, a));
                case 8 -> ifAllowed("setJointMaxTorque", c -> c.setJointMaxTorque(joint, a > 0f ? 10f : 0f));
                case 9 -> ifAllowed("setJointAnchor", c -> c.setJointAnchor(joint, 5f + a, a > 0f ? 5f : 6f));
                default -> addJoint();
            }
        }

        /** Mostly of two bodies, or of one and a place: a circle that is held by a body never sleeps. */
        private void joinCrates() {
            long[] all = reference.rigids();
            if (all.length == 0) {
                return;
            }
            long body = all[random.nextInt(all.length)];
            long other = all[random.nextInt(all.length)];
            JointPlan plan = plan();
            float x = world.bodies().x(body) + little();
            float y = world.bodies().y(body) + 1f + little();
            float a = little();
            float b = little();
            switch (random.nextInt(12)) {
                case 0, 1, 2, 3 -> ifAllowed("join crates", c -> c.addRigidJoint(body, a, b, other, b, a, plan));
                case 4, 5, 6, 7 -> ifAllowed("join a crate", c -> c.addRigidJointToPlace(body, a, b, x, y, plan));
                case 8, 9 -> ifAllowed("join a crate alone", c -> c.addJoint(body, plan));
                case 10 -> {
                    if (terrain) {
                        long on = bodies.get(0);
                        ifAllowed("join a crate to a body", c -> c.addRigidJointToBody(body, a, b, on, a, 0.2f, plan));
                    }
                }
                default -> {
                    if (random.nextInt(4) == 0 && world.size() > 0) {
                        long circle = some();
                        ifAllowed("join a crate to a circle", c -> c.addRigidJointToCircle(body, a, b, circle, plan));
                    }
                }
            }
        }

        private void addJoint() {
            if (crated && random.nextInt(3) > 0) {
                joinCrates();
                return;
            }
            long one = some();
            long other = some();
            JointPlan plan = plan();
            float x = world.x(one) + little();
            float a = little();
            switch (random.nextInt(6)) {
                case 0 -> ifAllowed("addJoint at a place", c -> c.addJoint(one, x, 6f, plan));
                case 1 -> ifAllowed("addJoint alone", c -> c.addJoint(one, plan));
                case 2 -> {
                    if (terrain) {
                        long body = bodies.get(0);
                        ifAllowed("addJoint on a body", c -> c.addJointToBody(one, body, a, 0.2f, plan));
                    }
                }
                default -> {
                    if (one != other) {
                        ifAllowed("addJoint", c -> c.addJoint(one, other, plan));
                    }
                }
            }
        }

        private JointPlan plan() {
            JointPlan.Kind[] kinds = JointPlan.Kind.values();
            JointPlan.Kind kind = kinds[random.nextInt(kinds.length)];
            float much = 1f + 4f * (float) random.nextDouble();
            float[] numbers =
                    switch (kind) {
                        case SPRING, SOFT_PIN -> new float[] {much, 0.7f};
                        case MOUSE -> new float[] {much, 0.7f, 20f * much};
                        case MOTOR -> new float[] {random.nextInt(3) == 0 ? much : 0f, 2f * much};
                        case SERVO -> new float[] {little(), much, 0.7f, 4f * much};
                        case FRICTION -> new float[] {much, much};
                        default -> new float[0];
                    };
            JointPlan plan = JointPlan.of(kind, numbers);
            if (kind == JointPlan.Kind.LIMITS) {
                plan = plan.withLimits(random.nextInt(3) == 0 ? 0.8f : 0f, much);
            }
            plan = random.nextInt(5) == 0 ? plan.breakingAt(30f * much, 30f * much) : plan;
            return random.nextInt(3) == 0 ? plan.colliding(true) : plan;
        }

        /** Makes a call if World does not refuse it. */
        private void ifAllowed(String what, Consumer<WorldCalls> call) {
            try {
                call.accept(WorldCalls.of(world));
            } catch (IllegalArgumentException e) {
                return;
            }
            call.accept(reference);
            calls.add(call);
            compare(what);
        }

        private void saveOrRestore() {
            if (snapshot == null || random.nextBoolean()) {
                snapshot = ByteBuffer.allocate(world.snapshotBytes());
                world.snapshot(snapshot);
                snapshot.flip();
                callsUpToSnapshot = new ArrayList<>(calls);
                bodiesOfSnapshot = List.copyOf(bodies);
                return;
            }
            world.close();
            world = newWorld();
            world.restore(snapshot.duplicate());
            reference = newReference();
            calls = new ArrayList<>(callsUpToSnapshot);
            bodies.clear();
            bodies.addAll(bodiesOfSnapshot);
            calls.forEach(call -> call.accept(reference));
            reference.takeEvents();
            reference.takeJointEvents();
            reference.takeRigidEvents();
            world.events();
            compare("restore");
            compareRigids();
        }

        private void step(float dt, int steps) {
            for (int k = 0; k < steps; k++) {
                both("step " + dt, c -> c.step(dt, 1));
                List<Long> now = new ArrayList<>();
                long[] handles = new long[world.size()];
                world.readHandles(handles);
                for (long handle : handles) {
                    assertThat(world.isAwake(handle)).isEqualTo(reference.isAwake(handle));
                    if (!world.isAwake(handle)) {
                        now.add(handle);
                    }
                }
                for (long body : crated ? reference.rigids() : new long[0]) {
                    assertThat(world.bodies().isAwake(body)).isEqualTo(reference.isRigidAwake(body));
                    if (!world.bodies().isAwake(body)) {
                        now.add(body);
                        bodiesFellAsleep += sleeping.contains(body) ? 0 : 1;
                    }
                }
                fellAsleep +=
                        (int) now.stream().filter(c -> !sleeping.contains(c)).count();
                woke += (int) sleeping.stream().filter(c -> !now.contains(c)).count();
                sleeping = now;
            }
            assertThat(Event.of(world.events()))
                    .as("events of the program of seed %d after call %d", seed, calls.size())
                    .isEqualTo(reference.takeEvents());
            compareRigids();
        }

        private void compareRigids() {
            assertThat(RigidEvent.of(world.bodies().events()))
                    .as("events of bodies of the program of seed %d after call %d", seed, calls.size())
                    .isEqualTo(reference.takeRigidEvents());
        }

        private void both(String what, Consumer<WorldCalls> call) {
            call.accept(WorldCalls.of(world));
            call.accept(reference);
            calls.add(call);
            compare(what);
        }

        private void compare(String what) {
            assertThat(world.hash())
                    .as("hash of the program of seed %d after call %d: %s", seed, calls.size(), what)
                    .isEqualTo(reference.hash());
        }
    }
}
