package io.github.circles2d;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.circles2d.reference.BodyOutline;
import io.github.circles2d.reference.ChainShape;
import io.github.circles2d.reference.Event;
import io.github.circles2d.reference.JointEvent;
import io.github.circles2d.reference.JointLoad;
import io.github.circles2d.reference.JointPlan;
import io.github.circles2d.reference.ReferenceWorld;
import io.github.circles2d.reference.RigidEvent;
import io.github.circles2d.reference.Settings;
import io.github.circles2d.reference.Surfaces;
import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import java.util.function.Consumer;
import java.util.function.ToIntFunction;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/**
 * Random programs of calls with allowed values: World has the same bits as its description in the plainest form, after every
 * call. The system property circles2d.fuzz.reference sets the number of programs, circles2d.fuzz.seed the first one's seed.
 */
@Tag("each-jdk")
class ReferenceFuzzTest {
    private static final int PROGRAMS = Integer.getInteger("circles2d.fuzz.reference", 100);
    private static final long SEED = Long.getLong("circles2d.fuzz.seed", 1);

    @Test
    void everyCallOfAnyProgramLeavesTheReferencesState() {
        for (int k = 0; k < PROGRAMS; k++) {
            new Program(SEED + k).run();
        }
    }

    private static final class Program {
        private final long seed;
        private final SplittableRandom random;
        private final int subSteps;
        private final float restitution;
        private final Settings settings;
        private final Edge edgeX;
        private final Edge edgeY;
        private final boolean turns;
        private final Surfaces surfaces;
        private final boolean terrain;
        private final boolean joints;
        private final boolean rigids;

        /** For what was drawn later: other numbers stay as they are. */
        private final SplittableRandom ofRigids;

        private final List<Long> bodies = new ArrayList<>();
        private final float size;
        private final float fastest;
        private World world;
        private ReferenceWorld reference;
        private List<Consumer<WorldCalls>> calls = new ArrayList<>();
        private ByteBuffer snapshot;
        private List<Consumer<WorldCalls>> callsUpToSnapshot;
        private List<Long> bodiesOfSnapshot;
        private final List<Consumer<WorldCalls>> reports = new ArrayList<>();

        Program(long seed) {
            this.seed = seed;
            random = new SplittableRandom(seed);
            subSteps = random.nextInt(3) == 0 ? 1 + random.nextInt(16) : 4;
            restitution = new float[] {0f, -0f, 0.5f, 1f}[random.nextInt(4)];
            size = (float) StrictMath.pow(10, random.nextInt(9) - 4);
            fastest = size * (float) StrictMath.pow(10, random.nextInt(5) - 2);
            Settings usual = Settings.DEFAULT;
            SplittableRandom ofEdges = new SplittableRandom(~seed);
            boolean walled = ofEdges.nextInt(3) == 0;
            edgeX = walled ? Edge.WALL : Edge.values()[ofEdges.nextInt(3)];
            edgeY = walled ? Edge.WALL : Edge.values()[ofEdges.nextInt(3)];
            SplittableRandom ofSurfaces = new SplittableRandom(~(3 * seed));
            turns = ofSurfaces.nextInt(4) > 0;
            surfaces = turns && ofSurfaces.nextBoolean() ? surfaces(ofSurfaces) : Surfaces.NONE;
            terrain = new SplittableRandom(~(5 * seed)).nextInt(2) == 0;
            joints = new SplittableRandom(~(7 * seed)).nextInt(2) == 0;
            rigids = new SplittableRandom(~(11 * seed)).nextInt(2) == 0;
            ofRigids = new SplittableRandom(~(13 * seed));
            settings = new Settings(
                    random.nextInt(4) > 0 ? usual.threshold() : random.nextInt(2) * value(0f, 0.5f * size),
                    random.nextInt(4) > 0 ? usual.frequency() : value(1f, 100f),
                    random.nextInt(4) > 0 ? usual.damping() : random.nextInt(2) * value(0f, 30f),
                    random.nextInt(4) > 0 ? usual.pushOutSpeed() : random.nextInt(2) * value(0f, 10f));
        }

        /** Of walls some are smooth, and some run. */
        private Surfaces surfaces(SplittableRandom values) {
            float[][] walls = new float[4][];
            for (int wall = 0; wall < walls.length; wall++) {
                boolean runs = values.nextInt(3) == 0;
                walls[wall] = new float[] {
                    values.nextInt(4) == 0 ? 0f : 1.5f * (float) values.nextDouble(),
                    values.nextInt(2) == 0 ? 0f : 0.3f * (float) values.nextDouble(),
                    runs ? size * (float) (values.nextDouble() - 0.5) : 0f
                };
            }
            float friction = values.nextInt(4) == 0 ? 0f : (float) values.nextDouble();
            return new Surfaces(friction, values.nextInt(2) == 0 ? 0f : 0.3f * (float) values.nextDouble(), walls);
        }

        void run() {
            world = newWorld();
            reference = newReference();
            try {
                setBounds();
                setGravity();
                report();
                addSome(random.nextInt(6) == 0 ? 60 : 12);
                for (int k = 0; k < (terrain ? 6 : 0); k++) {
                    changeTerrain();
                }
                for (int k = 0; k < (joints ? 10 : 0); k++) {
                    changeJoints();
                }
                for (int k = 0; k < (rigids ? 8 : 0); k++) {
                    addRigid();
                }
                for (int k = 0; k < (joints && rigids ? 6 : 0); k++) {
                    joinRigid();
                }
                int count = 10 + random.nextInt(30);
                for (int k = 0; k < count; k++) {
                    call();
                }
            } finally {
                world.close();
            }
        }

        private World newWorld() {
            int[] threads = {3, 1, 2, 1, 7, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1};
            World.Builder builder = WorldScenes.jvm()
                    .bounds(0, 0, size, size)
                    .edges(edgeX, edgeY)
                    .restitution(restitution)
                    .subSteps(subSteps);
            WorldScenes.with(surfaces, with(settings, builder));
            World built = WorldScenes.onThreads(threads[(int) (seed % threads.length)], builder);
            built.joints().report(true);
            reports.forEach(report -> report.accept(WorldCalls.of(built)));
            return built;
        }

        private ReferenceWorld newReference() {
            ReferenceWorld fresh = new ReferenceWorld(restitution, subSteps, settings);
            fresh.setBounds(0, 0, size, size);
            return fresh.edges(edgeX, edgeY).surfaces(surfaces);
        }

        private static World.Builder with(Settings settings, World.Builder builder) {
            builder.contactFrequency(settings.frequency())
                    .contactDamping(settings.damping())
                    .greatestPushOutSpeed(settings.pushOutSpeed());
            return settings.threshold() < 0f ? builder : builder.restitutionThreshold(settings.threshold());
        }

        private void call() {
            if (terrain && random.nextInt(3) == 0) {
                changeTerrain();
            }
            if (joints && random.nextInt(2) == 0) {
                changeJoints();
            }
            if (rigids && random.nextInt(2) == 0) {
                changeRigids();
            }
            if (joints && rigids && random.nextInt(3) == 0) {
                joinRigid();
            }
            switch (random.nextInt(turns ? 50 : 38)) {
                case 0 -> addSome(1 + random.nextInt(8));
                case 1 -> withSome(this::remove);
                case 2 -> withSome(this::setPosition);
                case 3 -> withSome(this::setVelocity);
                case 4 -> withSome(this::setRadius);
                case 5 -> withSome(this::setMass);
                case 6 -> withSome(this::setRestitution);
                case 7 -> withSome(this::applyImpulse);
                case 8 -> setGravity();
                case 9 -> setBounds();
                case 10 -> saveOrRestore();
                case 11 -> withSome(this::setKind);
                case 12 -> withSome(this::setGroup);
                case 13 -> setPairs();
                case 14 -> setResponse();
                case 15 -> setMotion();
                case 16 -> withSome(this::setForce);
                case 17 -> withSome(this::applyForce);
                case 18 -> changeSome();
                case 19 -> explode();
                case 20 -> moveWalls();
                case 21 -> report();
                case 22 -> addAll();
                case 23 -> withSome(this::setTag);
                case 24 -> readKindsAndTags();
                case 25 -> touching();
                case 26 -> requestEvents();
                case 27, 28 -> withSome(this::grow);
                case 29 -> clearAndAdd();
                case 30 -> withSome(this::setOwnMotion);
                case 38 -> withSome(this::setFriction);
                case 39 -> withSome(this::setAngle);
                case 40 -> withSome(this::setAngularVelocity);
                case 41 -> withSome(this::setTorque);
                case 42 -> withSome(this::applyTorque);
                case 43 -> withSome(this::applyAngularImpulse);
                case 44 -> setSurface();
                case 45 -> setTurning();
                case 46 -> setAngularVelocities();
                case 47 -> setWallSurface();
                default -> step();
            }
        }

        private void bothGive(String what, ToIntFunction<WorldCalls> call) {
            assertThat(call.applyAsInt(WorldCalls.of(world))).as(what).isEqualTo(call.applyAsInt(reference));
            calls.add(call::applyAsInt);
            compare(what);
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

        private void compareEvents(String when) {
            assertThat(Event.of(world.events()))
                    .as("events of the program of seed %d after call %d: %s", seed, calls.size(), when)
                    .isEqualTo(reference.takeEvents());
        }

        private void compareRigids(String when) {
            assertThat(RigidEvent.of(world.bodies().events()))
                    .as("events of bodies of the program of seed %d after call %d: %s", seed, calls.size(), when)
                    .isEqualTo(reference.takeRigidEvents());
            for (long body : reference.rigids()) {
                long[] some = new long[ofRigids.nextInt(5)];
                long[] expected = new long[some.length];
                assertThat(world.bodies().touching(body, some)).isEqualTo(reference.touchingRigid(body, expected));
                assertThat(some)
                        .as("what touches a body of the program of seed %d", seed)
                        .isEqualTo(expected);
            }
        }

        private void compareJoints(String when) {
            assertThat(JointEvent.of(world.joints().events()))
                    .as("joints that went in the program of seed %d after call %d: %s", seed, calls.size(), when)
                    .isEqualTo(reference.takeJointEvents());
            assertThat(JointLoad.of(world.joints()))
                    .as("forces of joints of the program of seed %d after call %d: %s", seed, calls.size(), when)
                    .isEqualTo(reference.jointLoads());
        }

        /** What is reported is in no snapshot: so not after one has been taken. */
        private void report() {
            if (snapshot == null) {
                if (rigids) {
                    boolean on = ofRigids.nextInt(4) > 0;
                    setReport("report bodies " + on, c -> c.reportRigids(on));
                }
                int types = random.nextInt(4) == 0 ? 0 : random.nextInt(2 * Events.WALL);
                setReport("report " + types, c -> c.report(types));
                if (random.nextInt(4) == 0) {
                    float speed = random.nextBoolean() ? 0f : value(0f, fastest);
                    setReport("setHitSpeed " + speed, c -> c.setHitSpeed(speed));
                }
                for (int k = random.nextInt(4); k > 0; k--) {
                    int kind = kind();
                    int other = kind();
                    int ofPair = random.nextInt(Events.WALL);
                    if (random.nextInt(4) == 0) {
                        setReport("report walls", c -> c.reportWalls(kind, ofPair));
                    } else {
                        setReport("report kinds", c -> c.report(kind, other, ofPair));
                    }
                }
            }
        }

        private void setReport(String what, Consumer<WorldCalls> call) {
            reports.add(call);
            both(what, call);
        }

        /** Asks which pairs of two kinds touch. */
        private void touching() {
            int kind = kind();
            int other = kind();
            long[] some = new long[2 * random.nextInt(4) + random.nextInt(2)];
            long[] expected = new long[some.length];
            int pairs = reference.touching(kind, other, expected);
            assertThat(world.touching(kind, other, some)).isEqualTo(pairs);
            assertThat(some).as("pairs of the program of seed %d", seed).isEqualTo(expected);
        }

        /** Events that are asked for are those up to now, whatever comes then. */
        private void requestEvents() {
            both("requestEvents", WorldCalls::requestEvents);
            for (int k = random.nextInt(4); k > 0; k--) {
                int steps = 1 + random.nextInt(2);
                both("step " + steps, c -> c.step(1 / 60f, steps));
                if (random.nextInt(4) == 0) {
                    both("requestEvents", WorldCalls::requestEvents);
                }
                withSome(random.nextBoolean() ? this::setPosition : this::remove);
            }
            assertThat(Event.of(world.takeEvents()))
                    .as("requested events of the program of seed %d after call %d", seed, calls.size())
                    .isEqualTo(reference.takeRequestedEvents());
        }

        private void step() {
            float dt = random.nextInt(3) == 0 ? value(1e-3f, 0.1f) : 1 / 60f;
            int steps = 1 + random.nextInt(3);
            both("step " + dt + " " + steps, c -> c.step(dt, steps));
            if (random.nextInt(3) > 0) {
                compareEvents("step");
            }
            if (rigids && ofRigids.nextInt(3) > 0) {
                compareRigids("step");
            }
            if (random.nextInt(3) > 0) {
                compareJoints("step");
            }
        }

        private void addSome(int count) {
            boolean atOnePoint = random.nextInt(4) == 0;
            float sharedX = x();
            float sharedY = y();
            for (int k = 0; k < count; k++) {
                float x = atOnePoint ? sharedX : x();
                float y = atOnePoint ? sharedY : y();
                float radius = radius();
                float mass = mass();
                float vx = speed();
                float vy = speed();
                if (random.nextInt(4) == 0) {
                    int kind = kind();
                    both("add", c -> c.add(x, y, radius, mass, vx, vy, kind));
                } else {
                    both("add", c -> c.add(x, y, radius, mass, vx, vy));
                }
            }
        }

        private void addAll() {
            int count = random.nextInt(5);
            float[] circles = new float[4 * count];
            float[] velocities = random.nextInt(4) == 0 ? null : new float[2 * count];
            int[] kinds = random.nextInt(4) == 0 ? null : new int[count];
            for (int k = 0; k < count; k++) {
                circles[4 * k] = x();
                circles[4 * k + 1] = y();
                circles[4 * k + 2] = radius();
                circles[4 * k + 3] = mass();
                if (velocities != null) {
                    velocities[2 * k] = speed();
                    velocities[2 * k + 1] = speed();
                }
                if (kinds != null) {
                    kinds[k] = kind();
                }
            }
            long[] handles = new long[count];
            both("addAll", c -> c.addAll(circles, velocities, kinds, handles));
        }

        private void setTag(long handle) {
            long tag = random.nextLong() >> random.nextInt(64);
            both("setTag", c -> c.setTag(handle, tag));
        }

        private void readKindsAndTags() {
            int[] kinds = new int[world.idLimit() + 1];
            int[] expectedKinds = kinds.clone();
            long[] tags = new long[kinds.length];
            long[] expectedTags = tags.clone();
            long[] living = new long[kinds.length / Long.SIZE + 1];
            long[] expectedLiving = living.clone();
            world.readKindsById(kinds, living);
            reference.readKindsById(expectedKinds, expectedLiving);
            assertThat(living).isEqualTo(expectedLiving);
            world.readTagsById(tags, living);
            reference.readTagsById(expectedTags, expectedLiving);
            assertThat(kinds).isEqualTo(expectedKinds);
            assertThat(tags).isEqualTo(expectedTags);
            assertThat(living).isEqualTo(expectedLiving);
        }

        private void withSome(Consumer<Long> change) {
            long[] handles = new long[world.size()];
            world.readHandles(handles);
            if (handles.length > 0) {
                change.accept(handles[random.nextInt(handles.length)]);
            }
        }

        private void remove(long handle) {
            both("remove", c -> c.remove(handle));
        }

        private void setPosition(long handle) {
            float x = x();
            float y = y();
            if (random.nextInt(3) == 0) {
                both("teleport", c -> c.teleport(handle, x, y));
            } else {
                both("setPosition", c -> c.setPosition(handle, x, y));
            }
        }

        private void setVelocity(long handle) {
            float vx = speed();
            float vy = speed();
            both("setVelocity", c -> c.setVelocity(handle, vx, vy));
        }

        private void setRadius(long handle) {
            float radius = radius();
            both("setRadius", c -> c.setRadius(handle, radius));
        }

        private void grow(long handle) {
            float radius = radius();
            int steps = 1 + random.nextInt(random.nextInt(4) == 0 ? 100 : 5);
            both("grow", c -> c.grow(handle, radius, steps));
        }

        /** Now and then only: a program needs circles. */
        private void clearAndAdd() {
            if (random.nextInt(3) == 0) {
                if (random.nextBoolean()) {
                    addSome(2);
                }
                both("clear", WorldCalls::clear);
                addSome(random.nextInt(8));
            }
        }

        private void setMass(long handle) {
            float mass = mass();
            both("setMass", c -> c.setMass(handle, mass));
        }

        private void setRestitution(long handle) {
            float e = value(0f, 1f);
            both("setRestitution", c -> c.setRestitution(handle, e));
        }

        private void applyImpulse(long handle) {
            float impulseX = speed() * mass();
            float impulseY = speed();
            if (Math.abs(impulseX) < 1e18f) {
                both("applyImpulse", c -> c.applyImpulse(handle, impulseX, impulseY));
            }
        }

        private void setKind(long handle) {
            int kind = kind();
            both("setKind", c -> c.setKind(handle, kind));
        }

        private void setGroup(long handle) {
            int group = random.nextInt(4) - 1;
            both("setGroup", c -> c.setGroup(handle, group));
        }

        private void setPairs() {
            int kind = kind();
            int category = 1 << random.nextInt(2);
            int mask = random.nextInt(5) - 1;
            boolean sensor = random.nextInt(4) == 0;
            both("setPairs", c -> c.setPairs(kind, category, mask, sensor));
            boolean senses = random.nextBoolean();
            both("setSensesStatic", c -> c.setSensesStatic(kind, senses));
            float e = random.nextInt(3) == 0 ? Float.NaN : value(0f, 1f);
            both("setKindRestitution", c -> c.setKindRestitution(kind, e));
        }

        private void setFriction(long handle) {
            float friction = friction();
            float resistance = random.nextInt(3) == 0 ? Float.NaN : resistance();
            both("setFriction", c -> c.setFriction(handle, friction));
            both("setRollingResistance", c -> c.setRollingResistance(handle, resistance));
        }

        private float friction() {
            return switch (random.nextInt(8)) {
                case 0 -> Float.NaN;
                case 1 -> 0f;
                case 2 -> value(0f, 1000f);
                default -> value(0f, 1.5f);
            };
        }

        private float resistance() {
            return random.nextInt(3) == 0 ? 0f : value(0f, random.nextInt(8) == 0 ? 1000f : 0.5f);
        }

        private void setAngle(long handle) {
            float radians = value(-10f, 10f);
            both("setAngle", c -> c.setAngle(handle, radians));
        }

        private void setAngularVelocity(long handle) {
            float omega = angularVelocity();
            both("setAngularVelocity", c -> c.setAngularVelocity(handle, omega));
        }

        private float angularVelocity() {
            return switch (random.nextInt(8)) {
                case 0 -> -0f;
                case 1 -> value(-1e5f, 1e5f) * (random.nextInt(4) == 0 ? 1e4f : 1f);
                default -> value(-30f, 30f);
            };
        }

        /** Changes those of some circles at once, among them some that are gone or occur twice. */
        private void setAngularVelocities() {
            long[] live = new long[world.size()];
            world.readHandles(live);
            long[] some = new long[random.nextInt(6)];
            float[] all = new float[some.length];
            for (int k = 0; k < some.length; k++) {
                boolean stale = live.length == 0 || random.nextInt(5) == 0;
                some[k] = stale ? random.nextInt(4) : live[random.nextInt(live.length)];
                all[k] = angularVelocity();
            }
            bothGive("setAngularVelocities", c -> c.setAngularVelocities(some, some.length, all, StaleHandles.SKIP));
        }

        private void setTorque(long handle) {
            float torque = size * force();
            both("setTorque", c -> c.setTorque(handle, torque));
        }

        private void applyTorque(long handle) {
            float torque = size * force();
            both("applyTorque", c -> c.applyTorque(handle, torque));
        }

        private void applyAngularImpulse(long handle) {
            float impulse = size * speed();
            both("applyAngularImpulse", c -> c.applyAngularImpulse(handle, impulse));
        }

        private void setSurface() {
            int kind = kind();
            float friction = friction();
            float resistance = random.nextInt(3) == 0 ? Float.NaN : resistance();
            float belt = random.nextBoolean() ? 0f : value(-size, size);
            both("setSurface", c -> c.setSurface(kind, friction, resistance, belt));
        }

        private void setWallSurface() {
            Wall wall = Wall.values()[random.nextInt(4)];
            float friction = random.nextInt(4) == 0 ? 0f : value(0f, 1.5f);
            float resistance = resistance();
            float belt = random.nextBoolean() ? 0f : value(-size, size);
            both("setWallSurface", c -> c.setWallSurface(wall, friction, resistance, belt));
        }

        private void setTurning() {
            int kind = kind();
            Inertia inertia = Inertia.values()[random.nextInt(3)];
            float damping = random.nextBoolean() ? 0f : value(0f, random.nextInt(8) == 0 ? 1e4f : 5f);
            both("setTurning", c -> c.setTurning(kind, inertia, damping));
        }

        private void setForce(long handle) {
            float x = force();
            float y = force();
            both("setForce", c -> c.setForce(handle, x, y));
        }

        private void applyForce(long handle) {
            float x = force();
            float y = force();
            both("applyForce", c -> c.applyForce(handle, x, y));
        }

        private float force() {
            return random.nextInt(4) == 0 ? -0f : 10f * mass(2f) * value(-size, size);
        }

        private void setMotion() {
            int kind = kind();
            float scale = gravityScale();
            float damping = damping();
            float most = greatestSpeed();
            both("setMotion", c -> c.setMotion(kind, scale, damping, most));
        }

        private void setOwnMotion(long handle) {
            float scale = random.nextInt(3) == 0 ? Float.NaN : gravityScale();
            float damping = random.nextInt(3) == 0 ? Float.NaN : damping();
            float most = random.nextInt(3) == 0 ? Float.NaN : greatestSpeed();
            both("setGravityScale", c -> c.setGravityScale(handle, scale));
            both("setDamping", c -> c.setDamping(handle, damping));
            both("setGreatestSpeed", c -> c.setGreatestSpeed(handle, most));
        }

        private float gravityScale() {
            return random.nextInt(3) == 0 ? random.nextInt(3) - 1 : value(-2f, 3f);
        }

        private float damping() {
            return random.nextInt(2) == 0 ? 0f : value(0f, random.nextInt(8) == 0 ? 1e4f : 5f);
        }

        private float greatestSpeed() {
            return random.nextInt(2) == 0 ? Float.POSITIVE_INFINITY : random.nextInt(9) == 0 ? 0f : value(0f, size);
        }

        private void setResponse() {
            int kind = kind();
            int other = kind();
            Response response = Response.values()[random.nextInt(4)];
            both("setResponse", c -> c.setResponse(kind, other, response));
        }

        private int kind() {
            return random.nextInt(3) == 0 ? 255 - random.nextInt(2) : random.nextInt(3);
        }

        /** Changes some circles at once, among them some that are gone or occur twice. */
        private void changeSome() {
            long[] live = new long[world.size()];
            world.readHandles(live);
            int count = random.nextInt(6);
            long[] some = new long[count + 1];
            float[] positions = new float[2 * some.length];
            float[] speeds = new float[2 * some.length];
            float[] forces = new float[2 * some.length];
            int[] kinds = new int[some.length];
            for (int k = 0; k <= count; k++) {
                boolean stale = live.length == 0 || random.nextInt(5) == 0;
                some[k] = stale ? random.nextInt(4) : live[random.nextInt(live.length)];
                positions[2 * k] = x();
                positions[2 * k + 1] = y();
                speeds[2 * k] = speed();
                speeds[2 * k + 1] = speed();
                forces[2 * k] = force();
                forces[2 * k + 1] = force();
                kinds[k] = kind();
            }
            switch (random.nextInt(6)) {
                case 0 -> bothGive("removeAll", c -> c.removeAll(some, count, StaleHandles.SKIP));
                case 1 -> bothGive("setPositions", c -> c.setPositions(some, count, positions, StaleHandles.SKIP));
                case 2 -> bothGive("setForces", c -> c.setForces(some, count, forces, StaleHandles.SKIP));
                case 3 -> bothGive("setKinds", c -> c.setKinds(some, count, kinds, StaleHandles.SKIP));
                case 4 -> bothGive("setVelocities", c -> c.setVelocities(some, count, speeds, StaleHandles.SKIP));
                default -> bothGive("applyImpulses", c -> c.applyImpulses(some, count, speeds, StaleHandles.SKIP));
            }
        }

        private void explode() {
            long[] live = new long[world.size()];
            world.readHandles(live);
            boolean atCircle = live.length > 0 && random.nextInt(4) == 0;
            float x = atCircle ? world.x(live[0]) : x();
            float y = atCircle ? world.y(live[0]) : y();
            float radius = random.nextInt(4) == 0 ? 0f : value(0f, size);
            float falloff = random.nextInt(4) == 0 ? 0f : value(0f, size);
            float impulse = speed() * (random.nextBoolean() ? 1f : 10f);
            int mask = random.nextInt(5) - 1;
            boolean masked = random.nextBoolean();
            // docs/step-bodies.md does not specify yet how explosions push bodies
            if (reference.rigids().length == 0) {
                bothGive(
                        "explode",
                        c -> masked
                                ? c.explode(x, y, radius, impulse, falloff, mask)
                                : c.explode(x, y, radius, impulse, falloff));
            }
            query(mask);
        }

        /** Queries of some circles alone, of which the world says itself what they are. */
        private void query(int mask) {
            float radius = value(0f, size);
            float x = x();
            float y = y();
            float toX = x();
            float toY = y();
            if (edgeX != Edge.WRAP && edgeY != Edge.WRAP) { // across a seam: WorldEdgesTest
                new QueryComparison(world, mask).compare(x, y, radius, toX, toY);
            }
        }

        // ---- terrain

        private void addRigid() {
            BodyOutline outline = outline();
            float x = x();
            float y = y();
            float angle = value(-4f, 4f);
            float mass = value(0.1f, 10f);
            int kind = random.nextInt(3) == 0 ? kind() : 0;
            bothIfAllowed("add a body", c -> c.addRigid(outline, x, y, angle, mass, kind));
        }

        private BodyOutline outline() {
            float s = size * value(0.02f, 0.09f);
            float half = 0.5f * s;
            float pi = (float) Math.PI;
            BodyOutline outline =
                    switch (random.nextInt(9)) {
                        case 0, 1 -> BodyOutline.box(s, s * value(0.2f, 1f));
                        case 2 -> BodyOutline.capsule(0.7f * s, 0.2f * s);
                        case 3 -> BodyOutline.polygon(0f, 0f, value(0f, 0.9f) * s, s, s, 0.1f * s);
                        case 4 ->
                            BodyOutline.polygon(0f, 0f, s, 0f, s, 0.4f * s, 0.3f * s, 0.3f * s, 0.3f * s, s, 0f, s);
                        case 5 -> BodyOutline.closed(half, 0f, new float[] {0f, 0f, pi}, new float[] {0f, 0f, pi});
                        case 6 -> BodyOutline.closed(-half, 0f, new float[] {half, 0f}, new float[] {0f, 0f, pi});
                        case 7 -> BodyOutline.lens(s);
                        default ->
                            BodyOutline.closed(
                                    -half, half, new float[] {-half, -half}, new float[] {half, -half}, new float[] {
                                        half, 0f, value(0.5f, 1.5f)
                                    });
                    };
            return random.nextInt(3) == 0 ? outline.round(s * value(0.002f, 0.02f)) : outline;
        }

        private void changeRigids() {
            long[] all = reference.rigids();
            if (all.length == 0) {
                addRigid();
                return;
            }
            long body = all[random.nextInt(all.length)];
            float x = x();
            float y = y();
            float vx = speed();
            float vy = speed();
            float turn = value(-20f, 20f);
            switch (random.nextInt(17)) {
                case 0, 1 -> addRigid();
                case 2 -> both("remove a body", c -> c.removeRigid(body));
                case 3, 4, 5 -> both("setVelocity of a body", c -> c.setRigidVelocity(body, vx, vy, turn));
                case 6 -> both("teleport of a body", c -> c.teleportRigid(body, x, y, turn));
                case 7 -> both("applyImpulse of a body", c -> c.pushRigid(body, vx, vy, x, y));
                case 8 -> both("applyAngularImpulse of a body", c -> c.turnRigid(body, 1e-3f * size * size * turn));
                case 9 -> both("applyForce of a body", c -> c.pressRigid(body, vx, vy, 1e-3f * size * size * turn));
                case 10 -> {
                    int kind = kind();
                    both("setKind of a body", c -> c.setRigidKind(body, kind));
                }
                case 11 -> {
                    float e = value(0f, 1f);
                    both("setRestitution of a body", c -> c.setRigidRestitution(body, e));
                }
                case 12 -> {
                    float share = random.nextInt(3) == 0 ? Float.POSITIVE_INFINITY : value(0.1f, 3f);
                    both("setInertia of a body", c -> c.setRigidInertia(body, share));
                }
                case 13 -> both("applyForce of a body at a point", c -> c.pressRigidAt(body, vx, vy, x, y));
                case 14 -> both("setForce of a body", c -> c.driveRigid(body, vx, vy, 1e-3f * size * size * turn));
                case 15 -> {
                    int group = random.nextInt(4);
                    both("setGroup of a body", c -> c.setRigidGroup(body, group));
                }
                default -> {
                    both("setTag of a body", c -> c.setRigidTag(body, body));
                    if (random.nextInt(4) == 0) {
                        both("clear of bodies", WorldCalls::clearRigids);
                    }
                }
            }
        }

        private void changeTerrain() {
            switch (random.nextInt(17)) {
                case 0, 1 -> addSegment();
                case 2, 3 -> addArc();
                case 4, 5 -> addChain();
                case 6, 7 -> addBody();
                case 8 -> withSomePiece(piece -> both("remove piece", c -> c.removePiece(piece)));
                case 9 -> setPieceKind();
                case 10 -> setOneWay();
                case 11 -> withSomeBody(this::teleportBody);
                case 12 -> withSomeBody(this::moveBodyTo);
                case 13 -> removeBodyOrAll();
                case 14 -> addTiles();
                default -> withSomeBody(this::setBodyVelocity);
            }
        }

        /** A call that the world may refuse, for its numbers. */
        private boolean bothIfAllowed(String what, Consumer<WorldCalls> call) {
            try {
                call.accept(WorldCalls.of(world));
            } catch (IllegalArgumentException e) {
                compare("refused: " + what);
                return false;
            }
            call.accept(reference);
            calls.add(call);
            compare(what);
            return true;
        }

        /** The ground, or one that moves. */
        private long someBody() {
            return bodies.isEmpty() || random.nextBoolean() ? 0 : bodies.get(random.nextInt(bodies.size()));
        }

        private float x(long body) {
            return body == 0 ? x() : value(-0.3f * size, 0.3f * size);
        }

        private float y(long body) {
            return body == 0 ? y() : value(-0.3f * size, 0.3f * size);
        }

        private void addSegment() {
            long body = someBody();
            float x1 = x(body);
            float y1 = y(body);
            boolean level = random.nextInt(4) == 0;
            float x2 = random.nextBoolean() ? x(body) : x1 + value(-0.2f, 0.2f) * size;
            float y2 = level ? y1 : random.nextBoolean() ? y(body) : y1 + value(-0.2f, 0.2f) * size;
            float thickness = random.nextBoolean() ? 0f : value(0f, 0.05f * size);
            int kind = random.nextInt(3) == 0 ? 0 : kind();
            bothIfAllowed("addSegment", c -> c.addSegment(body, x1, y1, x2, y2, thickness, kind));
        }

        private void addArc() {
            long body = someBody();
            float x = x(body);
            float y = y(body);
            float radius = value(0.01f * size, 0.5f * size);
            float from = value(-4f, 4f);
            float to = from + (random.nextInt(3) == 0 ? 2f * (float) Math.PI : value(0.01f, 6f));
            ArcSide side = random.nextBoolean() ? ArcSide.INNER : ArcSide.OUTER;
            int kind = random.nextInt(3) == 0 ? 0 : kind();
            bothIfAllowed("addArc", c -> c.addArc(body, x, y, radius, from, to, side, kind));
        }

        private void addChain() {
            long body = someBody();
            float x = x(body);
            float y = y(body);
            float[][] ways = new float[1 + random.nextInt(6)][];
            float toX = x;
            float toY = y;
            for (int k = 0; k < ways.length; k++) {
                if (random.nextInt(3) > 0) {
                    toX += value(-0.2f, 0.2f) * size;
                    toY += random.nextInt(4) == 0 ? 0f : value(-0.2f, 0.2f) * size;
                    ways[k] = new float[] {toX, toY};
                } else {
                    float centreX = toX + value(-0.2f, 0.2f) * size;
                    float centreY = toY + value(-0.2f, 0.2f) * size;
                    ways[k] = new float[] {centreX, centreY, value(-3f, 3f)};
                }
            }
            ChainShape shape = new ChainShape(x, y, ways, random.nextInt(3) == 0);
            int kind = random.nextInt(3) == 0 ? 0 : kind();
            bothIfAllowed("addChain", c -> c.addChain(body, shape, kind, new long[ways.length + 1]));
        }

        /** Flush boxes, on one body or on two. */
        private void addTiles() {
            long body = someBody();
            long other = random.nextBoolean() ? body : someBody();
            float x = x(body);
            float y = y(body);
            float edge = value(0.01f * size, 0.2f * size);
            float high = random.nextInt(4) == 0 ? value(-0.001f, 0.001f) * size : 0f;
            int kind = random.nextInt(3) == 0 ? 0 : kind();
            for (int k = 0; k < 4; k++) {
                float left = x + k * edge;
                float right = x + (k + 1) * edge;
                float up = k % 2 == 0 ? y : y + high;
                float[][] ways = {{right, y - edge}, {right, up}, {left, up}};
                ChainShape shape = new ChainShape(left, y - edge, ways, true);
                long of = k % 2 == 0 ? body : other;
                bothIfAllowed("addTiles", c -> c.addChain(of, shape, kind, new long[ways.length + 1]));
            }
        }

        private void addBody() {
            float x = x();
            float y = y();
            float angle = value(-4f, 4f);
            long[] handle = new long[1];
            both("addBody", c -> handle[0] = c.addBody(x, y, angle));
            bodies.add(handle[0]);
            float length = value(0.05f * size, 0.3f * size);
            bothIfAllowed("addSegment", c -> c.addSegment(handle[0], -length, 0f, length, 0f, 0f, 0));
            setBodyVelocity(handle[0]);
        }

        private void withSomePiece(Consumer<Long> change) {
            int limit = world.terrain().idLimit();
            long piece = limit == 0 ? 0 : world.terrain().handle(random.nextInt(limit));
            if (piece != 0) {
                change.accept(piece);
            }
        }

        private void withSomeBody(Consumer<Long> change) {
            if (!bodies.isEmpty()) {
                change.accept(bodies.get(random.nextInt(bodies.size())));
            }
        }

        private void setPieceKind() {
            int kind = kind();
            withSomePiece(piece -> both("setKind of a piece", c -> c.setPieceKind(piece, kind)));
        }

        private void setOneWay() {
            int kind = kind();
            boolean oneWay = random.nextBoolean();
            both("setOneWay", c -> c.setOneWay(kind, oneWay));
        }

        private void setBodyVelocity(long body) {
            float vx = random.nextBoolean() ? 0f : speed();
            float vy = random.nextBoolean() ? 0f : speed();
            float omega = random.nextInt(3) == 0 ? 0f : angularVelocity();
            both("setVelocity of a body", c -> c.setBodyVelocity(body, vx, vy, omega));
        }

        private void moveBodyTo(long body) {
            float x = world.terrain().body(body).x() + value(-0.2f, 0.2f) * size;
            float y = random.nextBoolean() ? y() : world.terrain().body(body).y();
            float angle = value(-4f, 4f);
            both("moveTo", c -> c.moveBodyTo(body, x, y, angle));
        }

        private void teleportBody(long body) {
            float x = x();
            float y = y();
            float angle = random.nextBoolean() ? 0f : value(-4f, 4f);
            both("teleport of a body", c -> c.teleportBody(body, x, y, angle));
        }

        /** All but seldom. */
        private void removeBodyOrAll() {
            if (random.nextInt(4) == 0) {
                both("clear terrain", WorldCalls::clearTerrain);
                bodies.clear();
            } else {
                withSomeBody(body -> {
                    both("remove body", c -> c.removeBody(body));
                    bodies.remove(body);
                });
            }
        }

        // ---- joints

        private void changeJoints() {
            switch (random.nextInt(24)) {
                case 0, 1, 2 -> withSome(circle -> withSome(other -> joinCircles(circle, other)));
                case 3, 4 -> withSome(this::joinToPlace);
                case 5 -> withSome(this::joinToBody);
                case 6, 7 -> withSome(this::joinAlone);
                case 8 -> joinChain();
                case 9 -> withSome(this::joinHub);
                case 10 -> withSomeJoint(joint -> both("remove joint", c -> c.removeJoint(joint)));
                case 11 -> removeSomeJoints();
                default -> withSomeJoint(this::setJoint);
            }
        }

        private void withSomeJoint(Consumer<Long> change) {
            int limit = world.joints().idLimit();
            long joint = limit == 0 ? 0 : world.joints().handle(random.nextInt(limit));
            if (joint != 0) {
                change.accept(joint);
            }
        }

        /** One in a few breaks, some are apart, and some let their circles collide. */
        private JointPlan plan(JointPlan.Kind... kinds) {
            JointPlan.Kind kind = kinds[random.nextInt(kinds.length)];
            float[] numbers =
                    switch (kind) {
                        case SPRING, SOFT_PIN -> new float[] {frequency(), dampingRatio()};
                        case MOUSE -> new float[] {frequency(), dampingRatio(), most()};
                        case MOTOR -> new float[] {angularVelocity(), most()};
                        case SERVO -> new float[] {value(-5f, 5f), frequency(), dampingRatio(), most()};
                        case FRICTION -> new float[] {most(), most()};
                        default -> new float[0];
                    };
            JointPlan plan = JointPlan.of(kind, numbers);
            if (kind == JointPlan.Kind.LIMITS || kind == JointPlan.Kind.SPRING && random.nextInt(3) == 0) {
                float least = random.nextInt(3) == 0 ? 0f : value(0f, 0.2f * size);
                plan = plan.withLimits(
                        least, random.nextInt(3) == 0 ? Float.POSITIVE_INFINITY : value(least, least + 0.2f * size));
            }
            boolean sets = kind == JointPlan.Kind.DISTANCE || kind == JointPlan.Kind.SPRING;
            plan = sets && random.nextBoolean() ? plan.withLength(length()) : plan;
            plan = random.nextInt(3) == 0 ? plan.breakingAt(most(), most()) : plan;
            return random.nextInt(4) == 0 ? plan.colliding(true) : plan;
        }

        private float length() {
            return random.nextInt(6) == 0 ? 0f : value(0f, random.nextInt(6) == 0 ? 3f * size : 0.2f * size);
        }

        private float frequency() {
            return switch (random.nextInt(8)) {
                case 0 -> -0f;
                case 1 -> 1e4f;
                case 2 -> value(0f, 200f);
                default -> value(0.1f, 20f);
            };
        }

        private float dampingRatio() {
            return random.nextInt(4) == 0 ? 0f : value(0f, random.nextInt(8) == 0 ? 1000f : 2f);
        }

        /** A greatest force or torque. */
        private float most() {
            return random.nextInt(4) == 0
                    ? Float.POSITIVE_INFINITY
                    : random.nextInt(8) == 0 ? 0f : 10f * size * mass(2f) * value(0f, 3f);
        }

        private void joinCircles(long circle, long other) {
            JointPlan plan = plan(JointPlan.Kind.values());
            bothIfAllowed("add joint", c -> c.addJoint(circle, other, plan));
        }

        private void joinToPlace(long circle) {
            JointPlan plan = plan(JointPlan.Kind.values());
            float x = x();
            float y = y();
            bothIfAllowed("add joint at a place", c -> c.addJoint(circle, x, y, plan));
        }

        private void joinToBody(long circle) {
            JointPlan plan =
                    plan(JointPlan.Kind.PIN, JointPlan.Kind.SOFT_PIN, JointPlan.Kind.DISTANCE, JointPlan.Kind.SPRING);
            long body = someBody();
            float x = x(body);
            float y = y(body);
            bothIfAllowed("add joint on a body", c -> c.addJointToBody(circle, body, x, y, plan));
        }

        private void joinAlone(long circle) {
            JointPlan plan = plan(JointPlan.Kind.MOTOR, JointPlan.Kind.SERVO, JointPlan.Kind.FRICTION);
            bothIfAllowed("add joint of one circle", c -> c.addJoint(circle, plan));
        }

        /** A joint of a body with something, which may be far away. */
        private void joinRigid() {
            long[] all = reference.rigids();
            if (all.length == 0) {
                return;
            }
            long body = all[random.nextInt(all.length)];
            long other = all[random.nextInt(all.length)];
            float[] at = point(body);
            float[] to = point(other);
            JointPlan plan = plan(JointPlan.Kind.values());
            switch (random.nextInt(7)) {
                case 0, 1 ->
                    bothIfAllowed(
                            "join points of bodies",
                            c -> c.addRigidJoint(body, at[0], at[1], other, to[0], to[1], plan));
                case 2 -> bothIfAllowed("join bodies", c -> c.addJoint(body, other, plan));
                case 3 ->
                    withSome(circle -> bothIfAllowed(
                            "join a body to a circle", c -> c.addRigidJointToCircle(body, at[0], at[1], circle, plan)));
                case 4 ->
                    withSome(circle -> bothIfAllowed("join a circle to a body", c -> c.addJoint(circle, body, plan)));
                case 5 -> {
                    float x = x();
                    float y = y();
                    bothIfAllowed(
                            "join a body to a place", c -> c.addRigidJointToPlace(body, at[0], at[1], x, y, plan));
                }
                default -> joinRigidFurther(body, at, plan);
            }
        }

        private void joinRigidFurther(long body, float[] at, JointPlan plan) {
            if (random.nextBoolean()) {
                bothIfAllowed("join a body", c -> c.addJoint(body, plan));
                return;
            }
            long onBody = someBody();
            float x = x(onBody);
            float y = y(onBody);
            bothIfAllowed(
                    "join a body to one of terrain",
                    c -> c.addRigidJointToBody(body, at[0], at[1], onBody, x, y, plan));
        }

        /** Of a body, mostly within its reach. */
        private float[] point(long body) {
            float reach = world.bodies().outline(body).reach() * (random.nextInt(8) == 0 ? 20f : 1f);
            return random.nextInt(4) == 0
                    ? new float[] {-0f, 0f}
                    : new float[] {value(-reach, reach), value(-reach, reach)};
        }

        /** A chain of the circles behind one. */
        private void joinChain() {
            long[] all = new long[world.size()];
            world.readHandles(all);
            int from = random.nextInt(all.length + 1);
            int count = Math.max(Math.min(all.length - from - 1, random.nextInt(12)), 0);
            long[] circles = Arrays.copyOfRange(all, from, from + count);
            long[] others =
                    Arrays.copyOfRange(all, Math.min(from + 1, all.length), Math.min(from + 1, all.length) + count);
            JointPlan plan =
                    plan(JointPlan.Kind.DISTANCE, JointPlan.Kind.SPRING, JointPlan.Kind.WELD, JointPlan.Kind.LIMITS);
            bothIfAllowed("add chain", c -> c.addJoints(circles, others, plan, new long[count]));
        }

        /** More joints of a circle than there are colours. */
        private void joinHub(long hub) {
            long[] all = new long[world.size()];
            world.readHandles(all);
            JointPlan plan = plan(
                    JointPlan.Kind.DISTANCE,
                    JointPlan.Kind.SPRING,
                    JointPlan.Kind.WELD,
                    JointPlan.Kind.MOTOR,
                    JointPlan.Kind.SERVO);
            boolean twice = random.nextBoolean();
            long[] others = Arrays.stream(all)
                    .filter(other -> other != hub && !isStatic(other))
                    .toArray();
            long[] spokes = new long[twice ? 2 * others.length : others.length];
            long[] hubs = new long[spokes.length];
            for (int k = 0; k < spokes.length; k++) {
                spokes[k] = others[k % others.length];
                hubs[k] = hub;
            }
            bothIfAllowed("add hub", c -> c.addJoints(hubs, spokes, plan, new long[hubs.length]));
        }

        private boolean isStatic(long circle) {
            return world.mass(circle) == Float.POSITIVE_INFINITY;
        }

        private void removeSomeJoints() {
            if (random.nextInt(4) == 0) {
                both("clear joints", WorldCalls::clearJoints);
                return;
            }
            long[] some = IntStream.range(0, world.joints().idLimit())
                    .filter(id -> random.nextInt(3) == 0)
                    .mapToLong(world.joints()::handle)
                    .filter(handle -> handle != 0)
                    .toArray();
            both("remove joints", c -> c.removeJoints(some));
        }

        /** Sets something of a joint, which may not have it. */
        private void setJoint(long joint) {
            float a = random.nextBoolean() ? 0f : value(0f, 0.2f * size);
            float b = random.nextInt(3) == 0 ? Float.POSITIVE_INFINITY : a + value(0f, 0.2f * size);
            float x = x();
            float y = y();
            float most = most();
            float other = most();
            float frequency = frequency();
            float ratio = dampingRatio();
            float omega = angularVelocity();
            float angle = value(-10f, 10f);
            boolean collide = random.nextBoolean();
            bothIfAllowed("setAnchor", c -> c.setJointAnchor(joint, x, y));
            switch (random.nextInt(9)) {
                case 0 -> bothIfAllowed("setLength", c -> c.setJointLength(joint, a));
                case 1 -> bothIfAllowed("setLimits", c -> c.setJointLimits(joint, a, b));
                case 2 -> bothIfAllowed("setSpring", c -> c.setJointSpring(joint, frequency, ratio));
                case 3 -> bothIfAllowed("setSpeed", c -> c.setJointSpeed(joint, omega));
                case 4 -> bothIfAllowed("setAngle", c -> c.setJointAngle(joint, angle));
                case 5 -> bothIfAllowed("setMaxForce", c -> c.setJointMaxForce(joint, most));
                case 6 -> bothIfAllowed("setMaxTorque", c -> c.setJointMaxTorque(joint, most));
                case 7 -> bothIfAllowed("setBreaking", c -> c.setJointBreaking(joint, most, other));
                default -> bothIfAllowed("setColliding", c -> c.setJointColliding(joint, collide));
            }
        }

        private void setGravity() {
            float x = random.nextBoolean() ? 0f : value(-size, size);
            float y = random.nextInt(4) == 0 ? 0f : value(-10f * size, 0f);
            both("setGravity", c -> c.setGravity(x, y));
        }

        private void setBounds() {
            float minX = random.nextBoolean() ? -0f : value(-size, size);
            float minY = random.nextBoolean() ? 0f : value(-10f * size, 10f * size);
            float maxX = minX + value(0.5f * size, 2f * size);
            float maxY = minY + value(0.5f * size, 2f * size);
            setBounds("setBounds", minX, minY, maxX, maxY);
        }

        /** An axis that wraps keeps its bounds. */
        private void setBounds(String what, float minX, float minY, float maxX, float maxY) {
            float lowX = edgeX == Edge.WRAP ? world.minX() : minX;
            float lowY = edgeY == Edge.WRAP ? world.minY() : minY;
            float highX = edgeX == Edge.WRAP ? world.maxX() : maxX;
            float highY = edgeY == Edge.WRAP ? world.maxY() : maxY;
            both(what, c -> c.setBounds(lowX, lowY, highX, highY));
        }

        /** Moves walls by about as much as circles are large, for some steps. */
        private void moveWalls() {
            float[] way = new float[4];
            for (int wall = 0; wall < 4; wall++) {
                way[wall] = random.nextBoolean() ? 0f : value(-0.05f * size, 0.05f * size);
            }
            for (int times = random.nextInt(4); times >= 0; times--) {
                float minX = world.minX() + way[0];
                float minY = world.minY() + way[1];
                float maxX = Math.max(world.maxX() + way[2], minX + 0.5f * size);
                float maxY = Math.max(world.maxY() + way[3], minY + 0.5f * size);
                setBounds("move walls", minX, minY, maxX, maxY);
                if (random.nextInt(4) > 0) {
                    step();
                } else {
                    saveOrRestore();
                }
            }
        }

        /** A restored world goes on as one would on which the calls before the snapshot have been made, and no others. */
        private void saveOrRestore() {
            if (snapshot == null || random.nextBoolean()) {
                snapshot = ByteBuffer.allocate(world.snapshotBytes());
                world.snapshot(snapshot);
                snapshot.flip();
                callsUpToSnapshot = new ArrayList<>(calls);
                bodiesOfSnapshot = new ArrayList<>(bodies);
                return;
            }
            if (random.nextBoolean()) {
                world.close();
                world = newWorld();
            }
            world.restore(snapshot.duplicate());
            bodies.clear();
            bodies.addAll(bodiesOfSnapshot);
            calls = new ArrayList<>(callsUpToSnapshot);
            reference = newReference();
            calls.forEach(call -> call.accept(reference));
            reference.takeEvents();
            compare("restore");
            compareEvents("restore");
            reference.takeRigidEvents();
            compareRigids("restore");
            reference.takeJointEvents();
            compareJoints("restore");
        }

        // ---- values

        private float value(float low, float high) {
            return low + (high - low) * (random.nextInt(1 << 24) * 0x1p-24f);
        }

        private float x() {
            return far(edgeX)
                    + (random.nextInt(8) == 0
                            ? wall(world.minX())
                            : Math.min(value(world.minX(), world.maxX()), world.maxX()));
        }

        private float y() {
            return far(edgeY)
                    + (random.nextInt(8) == 0
                            ? wall(world.minY())
                            : Math.min(value(world.minY(), world.maxY()), world.maxY()));
        }

        /** Without walls some places are beyond the bounds, and few far out, where coordinates are coarse. */
        private float far(Edge edge) {
            if (edge == Edge.WALL || random.nextInt(6) > 0) {
                return -0f; // keeps the sign of a zero
            }
            return random.nextInt(20) == 0 ? (random.nextBoolean() ? 1e5f : -9e8f) : value(-3f, 3f) * size;
        }

        /** A coordinate at a wall, also where only the sign of a zero differs. */
        private float wall(float coordinate) {
            return coordinate == 0f && random.nextBoolean() ? -coordinate : coordinate;
        }

        private float radius() {
            boolean wraps = edgeX == Edge.WRAP || edgeY == Edge.WRAP;
            float most = wraps ? 0.09f : 0.2f;
            return size * (random.nextInt(3) == 0 ? value(1e-3f, most) : value(0.02f, 0.05f));
        }

        private float mass() {
            return random.nextInt(8) == 0 ? Float.POSITIVE_INFINITY : mass(2f);
        }

        private float mass(float most) {
            return (float) StrictMath.pow(10, random.nextInt(5) - 2) * value(1f, most);
        }

        private float speed() {
            return switch (random.nextInt(4)) {
                case 0 -> 0f;
                case 1 -> value(-fastest, fastest);
                default -> value(-size, size);
            };
        }
    }
}
