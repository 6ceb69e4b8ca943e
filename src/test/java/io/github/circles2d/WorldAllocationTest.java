package io.github.circles2d;

import static org.assertj.core.api.Assertions.assertThat;

import com.sun.management.ThreadMXBean;
import io.github.circles2d.scenes.Scene;
import io.github.circles2d.scenes.Scenes;
import java.io.IOException;
import java.io.OutputStream;
import java.lang.management.ManagementFactory;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.FloatBuffer;
import java.nio.LongBuffer;
import java.util.Arrays;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** A game that runs leaves no garbage. */
@Tag("each-jdk")
class WorldAllocationTest {
    private static final float STEP = 1 / 60f;
    private static final int SENSOR = 9;

    /** So many that compilers come to an end in between, also on a busy machine. */
    private static final int ROUNDS = 200;

    private static final ThreadMXBean THREADS = (ThreadMXBean) ManagementFactory.getThreadMXBean();

    @ParameterizedTest
    @ValueSource(ints = {1, 3})
    void stepsAndReadsAllocateNothingOnTheJvm(int threads) {
        Scene scene = Scenes.thesis(1250, Scenes.SEED);
        int n = scene.size();
        float[] circles = new float[4 * n];
        float[] velocities = new float[2 * n];
        long[] handles = new long[n];
        FloatBuffer circleBuffer =
                ByteBuffer.allocateDirect(16 * n).order(ByteOrder.nativeOrder()).asFloatBuffer();
        FloatBuffer velocityBuffer = FloatBuffer.allocate(2 * n);
        LongBuffer handleBuffer = LongBuffer.allocate(n);
        World empty = WorldScenes.onThreads(threads, true, WorldScenes.builder(scene));
        try (World world = WorldScenes.load(scene, empty)) {
            world.report(Events.BEGIN | Events.HIT | Events.END | Events.WALL);
            world.report(2, 2, Events.BEGIN);
            world.kind(SENSOR).setSensor(true);
            world.readHandles(handles);
            for (int k = 20; k < n; k += 50) {
                world.setKind(handles[k], SENSOR);
            }
            long[] pairs = new long[2 * n];
            Runnable frame = () -> {
                world.readHandles(handles);
                world.setVelocity(handles[7], 0.01f, 0);
                world.applyImpulse(handles[8], 0.01f, 0);
                world.setTag(handles[9], world.tag(handles[9]) + 1);
                world.setKind(handles[10], 1 + (world.kindOf(handles[10]) & 1));
                world.kind(2).setDamping(world.kind(2).damping() + 0.01f).setMask(~1);
                world.setResponse(1, 2, world.response(1, 1) == Response.IGNORE ? Response.SOLID : Response.IGNORE);
                world.setGroup(handles[11], world.group(handles[11]) + 1);
                world.setForce(handles[12], world.forceX(handles[12]) + 0.01f, 0);
                world.applyForce(handles[13], 0.01f, 0);
                turn(world, handles);
                world.step(scene.timeStep());
                world.step(scene.timeStep(), 2);
                world.read(circles);
                world.readVelocities(velocities);
                world.read(circleBuffer.clear());
                world.readVelocities(velocityBuffer.clear());
                world.readHandles(handleBuffer.clear());
                consume(world.positions().get(5));
                world.requestPositions();
                world.step(scene.timeStep());
                consume(world.takePositions().get(5));
                consume(world.events());
                consume(world.touching(0, SENSOR, pairs) + pairs[0]);
                world.requestEvents();
                world.step(scene.timeStep());
                consume(world.takeEvents());
                consume(world.x(handles[3]) + world.vy(handles[4]) + world.hash() + world.size());
                consume(world.angle(handles[3])
                        + world.angularVelocity(handles[4])
                        + world.angles().get(5));
            };
            assertAllocatesNothing(frame);
        }
    }

    private static void turn(World world, long[] handles) {
        world.setAngle(handles[14], world.angle(handles[14]) + 1);
        world.setAngularVelocity(handles[15], 1);
        world.applyAngularImpulse(handles[16], 1e-3f);
        world.setTorque(handles[17], 1e-3f);
        world.applyTorque(handles[18], 1e-3f);
        world.setFriction(handles[19], world.friction(handles[19]) + 1e-3f);
        world.setRollingResistance(handles[19], 0.1f);
        world.setGravityScale(handles[19], world.gravityScale(handles[19]) + 1e-3f);
        world.setDamping(handles[19], world.damping(handles[19]) + 1e-3f);
        world.setGreatestSpeed(handles[19], world.greatestSpeed(handles[19]) < 1 ? Float.NaN : 0.5f);
        world.kind(1).setFriction(0.5f).setBeltSpeed(1).setInertia(Inertia.RING);
    }

    @Test
    void bulkCallsReadsByIdAndTheGameLoopAllocateNothingOnTheJvm() {
        Scene scene = Scenes.thesis(1250, Scenes.SEED);
        int n = scene.size() + 2; // two come and go
        float[] byId = new float[4 * n];
        float[] velocities = new float[2 * n];
        long[] living = new long[(n + 63) / 64];
        long[] some = new long[40];
        float[] added = {0.3f, 0.9f, 0.01f, 1, 0.4f, 0.9f, 0.01f, 1};
        float[] forces = new float[60];
        int[] kinds = {3, 9};
        int[] kindsOfSome = new int[30];
        long[] handles = new long[2];
        int[] kindsById = new int[2 * n];
        long[] tagsById = new long[2 * n];
        float[] radii = new float[n];
        float[] angles = new float[n];
        try (World world = WorldScenes.load(scene, WorldScenes.onThreads(1, true, WorldScenes.builder(scene)))) {
            FixedStep loop = new FixedStep(world, scene.timeStep());
            Runnable before = () -> {
                world.applyImpulses(some, 30, velocities, StaleHandles.SKIP);
                consume(world.explode(0.5f, 0.1f, 0.05f, 1e-4f, 0.1f));
            };
            Runnable frame = () -> {
                for (int k = 0; k < some.length; k++) {
                    some[k] = world.handle(k);
                }
                world.readById(byId, living);
                world.readVelocitiesById(velocities, living);
                world.removeAll(some, 5, StaleHandles.REFUSE);
                consume(world.positionsById(living).get(900));
                world.requestPositions();
                for (int k = 0; k < 5; k++) {
                    world.add(0.1f + 0.1f * k, 0.9f, scene.radius(0), 1);
                }
                world.addAll(added, null, kinds, handles);
                world.removeAll(handles, 2, StaleHandles.REFUSE);
                world.setPositions(some, 0, byId, StaleHandles.REFUSE);
                world.setForces(some, 30, forces, StaleHandles.SKIP);
                world.setKinds(some, 30, kindsOfSome, StaleHandles.SKIP);
                world.readKindsById(kindsById, living);
                world.setAngularVelocities(some, 30, velocities, StaleHandles.SKIP);
                world.readAnglesById(angles, living);
                world.readAngularVelocitiesById(angles, null);
                world.readTagsById(tagsById, living);
                world.setVelocities(some, some.length, velocities, StaleHandles.SKIP);
                consume(world.takePositionsById(living).get(900));
                loop.advance(1.5f * scene.timeStep(), before);
                consume(loop.positions(living).get(900) + loop.alpha() + world.idLimit());
                consume(loop.radii().get(900));
                consume(loop.angles().get(900));
                world.readRadiiById(radii, living);
                world.grow(some[6], scene.radius(6) * (1.5f - loop.alpha()), 3);
                Arrays.fill(velocities, 1e-4f);
            };
            assertAllocatesNothing(frame);
        }
    }

    @Test
    @Tag("long")
    void terrainAllocatesNothingOnTheJvm() throws IOException {
        Scene scene = Scenes.thesis(1250, Scenes.SEED);
        float width = scene.maxX() - scene.minX();
        float height = scene.maxY() - scene.minY();
        float[] pieces = new float[Terrain.PIECE_STRIDE * 100];
        long[] handles = new long[100];
        long[] added = new long[2];
        float[] ends = {0, 0, 0.1f, 0.1f, 0.2f, 0.1f, 0.3f, 0};
        float[] pose = new float[3];
        try (World world = WorldScenes.load(scene, WorldScenes.onThreads(1, true, WorldScenes.builder(scene)));
                Recording recording = new Recording(world, OutputStream.nullOutputStream(), 1)) {
            Terrain terrain = world.terrain();
            Chain chain = Chain.of(width, 0.1f * height, 0.5f * width, 0.2f * height, 0, 0.1f * height);
            terrain.addChain(chain);
            TerrainBody drum = terrain.addBody(0.5f * width, 0.5f * height, 0);
            drum.addArc(0, 0, 0.2f * height, 0, 3, ArcSide.INNER);
            drum.setAngularVelocity(2);
            Rewind rewind = new Rewind(world, 3);
            FixedStep loop = new FixedStep(world, scene.timeStep());
            int[] frames = new int[1];
            Runnable frame = () -> {
                long segment = terrain.addSegment(0, 0.3f * height, 0.2f * width, 0.3f * height, 0.01f, 3);
                terrain.setKind(segment, 1 + terrain.kindOf(segment));
                rewind.save(frames[0]);
                drum.setVelocity(0.01f * (frames[0]++ % 3 - 1), 0);
                loop.advance(1.5f * scene.timeStep(), null);
                rewind.restore(frames[0] - 1);
                loop.reset();
                drum.moveTo(0.5f * width, 0.5f * height, 1);
                loop.advance(2.5f * scene.timeStep(), null);
                consume(terrain.readPieces(pieces, handles) + loop.pieces(pieces, null));
                loop.pose(drum, pose);
                consume(drum.x() + drum.angle() + drum.vx() + terrain.size() + terrain.idLimit());
                terrain.addSegments(ends, 0, added);
                terrain.remove(added[0]);
                terrain.remove(added[1]);
                drum.addChain(chain, 5, added);
                drum.teleport(0.5f * width, 0.5f * height, 0);
                world.step(scene.timeStep());
                terrain.remove(added[0]);
                terrain.remove(added[1]);
                terrain.remove(segment);
                consume(terrain.contains(segment) ? 1 : world.hash());
                consume(terrain.bodyOf(terrain.handle(0)) == terrain.ground() ? 1 : 0);
            };
            assertAllocatesNothing(frame);
            assertThat(recording.hasFailed()).isFalse();
        }
    }

    @Test
    void jointsAllocateNothingOnTheJvm() throws IOException {
        Scene scene = Scenes.thesis(1250, Scenes.SEED);
        long[] handles = new long[scene.size()];
        long[] left = new long[300];
        long[] right = new long[300];
        long[] added = new long[300];
        long[] some = new long[40];
        float[] ends = new float[4 * 1_000];
        Joint spring = Joint.spring(5, 0.5f);
        Joint weak = Joint.rope(0).breakingAt(1e-9f, 1e-9f);
        Joint pin = Joint.pin();
        try (World world = WorldScenes.load(scene, WorldScenes.onThreads(1, true, WorldScenes.builder(scene)));
                Recording recording = new Recording(world, OutputStream.nullOutputStream(), 1)) {
            Joints joints = world.joints();
            joints.report(true);
            world.readHandles(handles);
            System.arraycopy(handles, 0, left, 0, 300);
            System.arraycopy(handles, 300, right, 0, 300);
            joints.addAll(left, right, Joint.distance(), added);
            long motor = joints.add(left[0], Joint.motor(2, 1e-3f));
            TerrainBody lift = world.terrain().addBody(0.5f, 0.5f, 0);
            lift.setAngularVelocity(1);
            joints.add(left[2], lift, 0.1f, 0, spring);
            FixedStep loop = new FixedStep(world, scene.timeStep());
            Rewind rewind = new Rewind(world, 3);
            int[] frames = new int[1];
            Runnable frame = () -> {
                loop.reset();
                loop.advance(1.5f * scene.timeStep(), null);
                consume(loop.jointEnds(ends, handles));
                long broken = joints.add(left[1], right[2], weak);
                world.step(scene.timeStep());
                consume(joints.contains(broken) ? 1 : joints.events().size());
                rewind.save(frames[0]++);
                joints.setSpeed(motor, frames[0] % 3);
                joints.addAll(left, right, spring, added);
                world.step(scene.timeStep());
                consume(joints.readEnds(ends) + joints.ofCircle(left[3], some) + joints.force(added[0]));
                joints.removeAll(added);
                long guest = world.add(0.5f, 0.5f, scene.radius(0), 1);
                joints.add(guest, 0.5f, 0.5f, pin);
                world.step(scene.timeStep());
                world.remove(guest);
                JointEvents gone = joints.events();
                consume(gone.size() + gone.force(0) + gone.circle(0) + world.hash());
                rewind.restore(frames[0] - 1);
                consume(joints.size() + joints.idLimit() + joints.length(motor));
            };
            assertAllocatesNothing(frame);
            assertThat(recording.hasFailed()).isFalse();
        }
    }

    @Test
    void bodiesAllocateNothing() throws IOException {
        World.Builder builder =
                WorldScenes.jvm().bounds(0, 0, 40, 20).gravity(0, -10).friction(0.5f);
        try (World world = builder.threads(1).build();
                Recording recording = new Recording(world, OutputStream.nullOutputStream(), 1)) {
            Bodies bodies = world.bodies();
            Outline crate = Outline.box(1, 0.7f);
            Outline bar = Outline.capsule(2, 0.2f);
            bodies.report(true);
            world.terrain().addSegment(0, 2, 20, 1);
            world.kind(5).setSensor(true);
            world.terrain().addSegment(0, 4, 40, 4, 0, 5);
            world.add(20, 5, 1.5f, Float.POSITIVE_INFINITY, 0, 0, 5);
            bodies.add(Outline.box(6, 6), 20, 8, 0.3f, 1, 5);
            for (int k = 0; k < 40; k++) {
                bodies.add(k % 3 == 0 ? bar : crate, 5 + k % 8 * 3, 3 + k / 8 * 2, k, 1);
                world.add(4 + k % 10 * 3, 14 + k / 10, 0.4f, 1);
            }
            world.step(1 / 60f, 300); // the heap settles, and arrays have grown
            bodies.events();
            long first = bodies.handle(0);
            float[] poses = new float[3 * 50];
            long[] living = new long[1];
            long[] handles = new long[50];
            float[] hits = new float[Queries.HIT_STRIDE * handles.length];
            BodyQueries queries = world.queries().withMask(1).bodies();
            FixedStep loop = new FixedStep(world, 1 / 60f);
            Rewind rewind = new Rewind(world, 3);
            int[] frames = new int[1];
            Runnable frame = () -> {
                loop.reset();
                loop.advance(1.5f / 60, null);
                loop.bodies(poses, living);
                long guest = bodies.add(crate, 20, 18, 1, 1);
                bodies.applyImpulse(guest, 1, 0, 20, 18.2f);
                bodies.applyForce(first, 3, 1);
                world.step(1 / 60f);
                rewind.save(frames[0]++);
                bodies.readById(poses, living);
                bodies.readVelocitiesById(poses, null);
                bodies.readHandles(handles);
                bodies.remove(guest);
                world.step(1 / 60f);
                BodyEvents touches = bodies.events();
                consume(touches.size() + bodies.touching(first, handles) + bodies.x(first) + world.hash());
                consume(world.explodeInSight(20, 5, 3, 0.1f, 3, 1));
                consume(queries.pick(5, 3)
                        + queries.overlapCircle(20, 5, 9, handles)
                        + queries.overlapBox(5, 2, 30, 9, handles)
                        + queries.nearest(20, 5, Float.POSITIVE_INFINITY, 50, handles, hits)
                        + queries.rayCast(0, 5, 40, 0, hits)
                        + queries.circleCastAll(0, 5, 0.5f, 40, 0, handles, hits));
                rewind.restore(frames[0] - 1);
                bodies.remove(guest);
            };
            assertAllocatesNothing(frame);
            assertThat(recording.hasFailed()).isFalse();
        }
    }

    @Test
    void rewindingAllocatesNothingOnTheJvm() {
        Scene scene = Scenes.thesis(1250, Scenes.SEED);
        long[] handles = new long[scene.size()];
        int[] now = new int[1];
        try (World world = WorldScenes.load(scene, WorldScenes.onThreads(1, true, WorldScenes.builder(scene)))) {
            Rewind rewind = new Rewind(world, 20);
            world.setWallSurface(Wall.MIN_Y, 0.5f, 0.1f, 0);
            rewind.save(now[0]);
            Runnable frame = () -> {
                world.readHandles(handles);
                world.setTag(handles[9], 7);
                turn(world, handles);
                for (int k = 0; k < 3; k++) {
                    world.applyImpulse(handles[k], 0.01f, 0);
                    world.step(scene.timeStep());
                    rewind.save(++now[0]);
                }
                now[0] -= 2;
                rewind.restore(now[0]);
                consume(rewind.size() + rewind.oldest() + rewind.newest());
            };
            assertAllocatesNothing(frame);
        }
    }

    @Test
    @Tag("long")
    void rollingBackAllocatesNothingOnTheJvm() {
        Scene scene = Scenes.thesis(1250, Scenes.SEED);
        long[] handles = new long[scene.size()];
        try (World world = WorldScenes.load(scene, WorldScenes.onThreads(1, true, WorldScenes.builder(scene)))) {
            world.report(0, 1, Events.BEGIN | Events.HIT | Events.END);
            world.kind(0).setFriction(0.5f).setRollingResistance(0.1f);
            world.setWallSurface(Wall.MIN_Y, 0.5f, 0.1f, 0);
            world.readHandles(handles);
            for (int k = 0; k < 5; k++) {
                world.setKind(
                        handles[k], 1); // the pairs that touch are few: to save many of them, Java's sort takes memory
            }
            Rollback rollback = new Rollback(
                    world,
                    new Rollback.Game() {
                        @Override
                        public void beforeStep(int frame, long[] inputs) {
                            world.readHandles(handles);
                            world.applyImpulse(handles[3], 1e-3f * inputs[1], 0);
                        }

                        @Override
                        public void save(ByteBuffer to) {
                            to.putInt(7);
                        }

                        @Override
                        public void restore(ByteBuffer from) {
                            consume(from.getInt());
                        }

                        @Override
                        public void confirmed(int frame, Events events) {
                            consume(events.size());
                        }
                    },
                    scene.timeStep(),
                    2,
                    6);
            assertAllocatesNothing(() -> {
                int frame = rollback.frame();
                rollback.setInput(0, frame, 1);
                if (frame >= 4) {
                    rollback.setInput(1, frame - 4, frame % 3);
                }
                rollback.advance();
            });
            assertThat(rollback.rollbacks()).isGreaterThan(10);
        }
    }

    @Test
    void recordingAllocatesNothingOnTheJvm() throws IOException {
        Scene scene = Scenes.thesis(1250, Scenes.SEED);
        long[] handles = new long[scene.size()];
        float[] some = new float[40];
        try (World world = WorldScenes.load(scene, WorldScenes.onThreads(1, true, WorldScenes.builder(scene)));
                Recording recording = new Recording(world, OutputStream.nullOutputStream(), 1)) {
            Rewind rewind = new Rewind(world, 1);
            Runnable frame = () -> {
                world.readHandles(handles);
                world.remove(handles[3]);
                world.add(0.5f, 0.9f, scene.radius(0), 1);
                world.setVelocities(handles, 3, some, StaleHandles.REFUSE);
                world.setTag(handles[9], world.tag(handles[9]) + 1);
                world.setGravity(0, world.gravityY());
                turn(world, handles);
                rewind.save(0);
                world.step(scene.timeStep(), 2);
                rewind.restore(0);
                world.step(scene.timeStep());
                consume(recording.bytes() + recording.steps());
            };
            assertAllocatesNothing(frame);
            assertThat(recording.hasFailed()).isFalse();
        }
    }

    @Test
    @Tag("long")
    void queriesAllocateNothing() {
        Scene scene = Scenes.packed(1250, Scenes.SEED);
        int batch = 100;
        long[] found = new long[20_000];
        int[] ends = new int[batch];
        float[] hits = new float[Queries.HIT_STRIDE * found.length];
        float[] numbers = new float[5 * batch];
        for (int k = 0; k < numbers.length; k++) {
            numbers[k] = 0.3f + 0.4f * k / numbers.length;
        }
        try (World world = WorldScenes.world(scene, WorldScenes.builder(scene))) {
            Queries queries = world.queries();
            Queries some = queries.withMask(1);
            Runnable frame = () -> {
                world.step(scene.timeStep());
                consume(world.explode(0.5f, 0.5f, 0.1f, 0, 0, 1));
                consume(some.pick(0.5f, 0.5f)
                        + some.overlapCircle(numbers, batch, ends, found)
                        + some.rayCast(numbers, batch, found, hits)
                        + some.nearest(numbers, batch, 0.1f, 9, found, hits));
                int sum = queries.overlapCircle(0.5f, 0.5f, 0.2f, found)
                        + queries.overlapBox(0.2f, 0.2f, 0.8f, 0.8f, found)
                        + queries.nearest(0.5f, 0.5f, Float.POSITIVE_INFINITY, 200, found, hits)
                        + queries.rayCastAll(0, 0, 1, 1, found, hits)
                        + queries.circleCastAll(0, 0, 0.1f, 1, 1, found, hits);
                sum += queries.overlapCircle(numbers, batch, ends, found)
                        + queries.pick(numbers, batch, found)
                        + queries.nearest(numbers, batch, 0.1f, 9, found, hits)
                        + queries.rayCast(numbers, batch, found, hits)
                        + queries.rayCastAll(numbers, batch, ends, found, hits)
                        + queries.circleCast(numbers, batch, found, hits)
                        + queries.circleCastAll(numbers, batch, ends, found, hits);
                consume(sum
                        + queries.pick(0.5f, 0.5f)
                        + queries.rayCast(0, 0, 1, 1, hits)
                        + queries.circleCast(0, 0, 0.1f, 1, 1, hits));
            };
            assertAllocatesNothing(frame);
        }
    }

    @Test
    void terrainAllocatesNothing() {
        Scene scene = Scenes.packed(1250, Scenes.SEED);
        int batch = 20;
        long[] found = new long[20_000];
        int[] ends = new int[batch];
        float[] hits = new float[Queries.HIT_STRIDE * found.length];
        float[] numbers = new float[5 * batch];
        for (int k = 0; k < numbers.length; k++) {
            numbers[k] = 0.3f + 0.4f * k / numbers.length;
        }
        try (World world = WorldScenes.world(scene, WorldScenes.builder(scene))) {
            world.terrain().addChain(Chain.of(0.9f, 0.2f, 0.5f, 0.1f, 0.1f, 0.2f));
            TerrainBody body = world.terrain().addBody(0.5f, 0.5f, 0);
            body.addSegment(-0.2f, 0, 0.2f, 0);
            body.addArc(0, 0.1f, 0.1f, 0, 3, ArcSide.OUTER, 3);
            body.setAngularVelocity(1);
            world.kind(3).setSensor(true);
            world.report(Events.BEGIN | Events.HIT | Events.END);
            TerrainQueries queries = world.queries().terrain();
            TerrainQueries some = queries.withMask(1);
            Runnable frame = () -> {
                world.step(scene.timeStep());
                consume(world.events());
                consume(world.explodeInSight(0.5f, 0.5f, 0.1f, 0, 0, 1));
                consume(some.pick(0.5f, 0.5f, 1)
                        + some.rayCast(numbers, batch, found, hits)
                        + queries.overlapCircle(0.5f, 0.5f, 0.2f, found)
                        + queries.overlapBox(0.2f, 0.2f, 0.8f, 0.8f, found)
                        + queries.nearest(0.5f, 0.5f, Float.POSITIVE_INFINITY, 200, found, hits)
                        + queries.rayCastAll(0, 0, 1, 1, found, hits)
                        + queries.circleCastAll(0, 0, 0.1f, 1, 1, found, hits)
                        + queries.nearest(numbers, batch, 0.1f, 9, found, hits)
                        + queries.circleCastAll(numbers, batch, ends, found, hits));
            };
            assertAllocatesNothing(frame);
        }
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 3})
    @Tag("long")
    void jointsAllocateNothing(int threads) {
        World.Builder builder = WorldScenes.jvm().bounds(0, 0, 100, 100).gravity(0, -10);
        try (World world = WorldScenes.onThreads(threads, builder)) {
            Joints joints = world.joints();
            joints.report(true);
            long[] circles = new long[1000];
            long[] some = new long[900];
            long[] others = new long[900];
            long[] added = new long[900];
            long[] found = new long[50];
            for (int k = 0; k < circles.length; k++) {
                circles[k] = world.add(1 + k % 50 * 1.9f, 1 + k / 50 * 1.9f, 0.4f, k == 999 ? 10 : 1);
                if (k < 900) {
                    some[k] = circles[k];
                } else {
                    joints.add(circles[k], circles[k - 900], Joint.spring(2, 1));
                }
            }
            System.arraycopy(circles, 50, others, 0, others.length);
            for (int k = 0; k < 40; k++) {
                joints.add(circles[999], circles[500 + k], Joint.rope(90)); // more than colours
            }
            TerrainBody lift = world.terrain().addBody(50, 50, 0);
            lift.setAngularVelocity(1);
            long mouse = joints.add(circles[7], 3, 3, Joint.mouse(5, 1, 100));
            long pin = joints.add(circles[8], lift, 3, 3, Joint.pin());
            long motor = joints.add(circles[9], Joint.motor(1, 1));
            long servo = joints.add(circles[10], Joint.servo(1, 1, 1, 1));
            Joint link = Joint.distance().breakingAt(1e6f, 1e6f);
            Joint weak = Joint.distance(9).breakingAt(1, 1);
            Joint weld = Joint.weld();
            Joint slow = Joint.friction(1, 1);
            float[] ends = new float[4000 * 4];
            int[] frames = new int[1];
            Runnable frame = () -> {
                float turn = frames[0]++ % 3;
                joints.addAll(some, others, link, added);
                long soft = joints.add(circles[11], circles[12], weak);
                long body = joints.add(circles[13], circles[14], weld);
                long alone = joints.add(circles[15], slow);
                consume(soft);
                joints.setAnchor(mouse, 3 + turn, 4);
                joints.setMaxForce(mouse, 100 + turn);
                joints.setSpring(mouse, 5 + turn, 1);
                joints.setSpeed(motor, turn);
                joints.setMaxTorque(motor, 1 + turn);
                joints.setAngle(servo, turn);
                joints.setLength(added[3], 1 + turn);
                joints.setBreaking(added[4], 1e5f, 1e5f);
                joints.setColliding(added[5], true);
                joints.setAnchor(pin, turn, 3);
                world.step(STEP);
                world.step(STEP, 2);
                consume(joints.size() + joints.idLimit() + joints.handle(7));
                consume(joints.force(added[6]) + joints.forceX(pin) + joints.forceY(pin) + joints.torque(motor));
                consume(joints.length(added[7]) + joints.anchorX(pin) + joints.anchorY(mouse));
                consume(joints.readEnds(ends) + joints.pick(5, 5, 3) + joints.ofCircle(circles[999], found));
                consume(joints.circle(pin) + joints.other(added[8]));
                joints.remove(body);
                joints.remove(alone);
                world.remove(circles[20]);
                circles[20] = world.add(50, 90, 0.4f, 1);
                some[20] = circles[20]; // it is none of the others
                JointEvents gone = joints.events();
                for (int k = 0; k < gone.size(); k++) {
                    consume(gone.joint(k) + gone.circle(k) + gone.other(k) + gone.force(k) + gone.torque(k));
                    consume(gone.reason(k) == JointEvents.Reason.BROKEN ? 1 : 0);
                }
                consume(world.hash());
                for (int k = 0; k < added.length; k++) {
                    if (joints.contains(added[k])) {
                        joints.remove(added[k]);
                    }
                }
            };
            assertAllocatesNothing(frame);
        }
    }

    private static void assertAllocatesNothing(Runnable frame) {
        for (int k = 0; k < 200; k++) { // the list of contacts grows to its greatest length, and compilers settle
            frame.run();
        }
        // the virtual machine may still leave some hundred bytes now and then; what a frame leaves, every frame does
        long least = Long.MAX_VALUE;
        for (int k = 0; k < ROUNDS && least != 0; k++) {
            least = Math.min(least, allocatedBy(frame, 50));
        }
        assertThat(least).isZero();
    }

    @Test
    void theMeasurementSeesWhatIsAllocated() {
        byte[][] own = new byte[1][];
        assertThat(allocatedBy(() -> own[0] = new byte[100_000], 10)).isGreaterThanOrEqualTo(1_000_000);
    }

    private static volatile double sink;

    private static void consume(Events events) {
        for (int i = 0; i < events.size(); i++) {
            consume(events.type(i) + events.speed(i) + events.x(i));
            consume(events.side(i) == Events.Side.LEFT ? 1 : 0);
        }
    }

    private static void consume(double value) {
        sink = value;
    }

    /**
     * Bytes that the threads which live throughout, but those of the test's runner, allocate in some runs, without those for
     * measuring.
     */
    private static long allocatedBy(Runnable action, int runs) {
        long[] ids = Thread.getAllStackTraces().keySet().stream()
                .filter(thread -> !thread.getName().startsWith("surefire"))
                .mapToLong(Thread::getId)
                .toArray();
        long[] start = new long[ids.length];
        long[] before = new long[ids.length];
        long[] after = new long[ids.length];
        measure(ids, after);
        measure(ids, start);
        measure(ids, before);
        for (int k = 0; k < runs; k++) {
            action.run();
        }
        measure(ids, after);
        long sum = 0;
        for (int k = 0; k < ids.length; k++) {
            boolean lives = after[k] >= 0; // -1 of a thread that has ended
            sum += lives ? after[k] - before[k] - (before[k] - start[k]) : 0;
        }
        return sum;
    }

    private static void measure(long[] ids, long[] bytes) {
        for (int k = 0; k < ids.length; k++) {
            bytes[k] = THREADS.getThreadAllocatedBytes(ids[k]);
        }
    }
}
