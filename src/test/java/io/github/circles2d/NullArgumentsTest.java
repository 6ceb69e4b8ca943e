package io.github.circles2d;

import static io.github.circles2d.WorldScenes.snapshot;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.assertThatNullPointerException;

import java.io.ByteArrayInputStream;
import java.io.OutputStream;
import java.lang.reflect.Executable;
import java.lang.reflect.Modifier;
import java.nio.ByteBuffer;
import java.nio.FloatBuffer;
import java.nio.LongBuffer;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.assertj.core.api.ThrowableAssert.ThrowingCallable;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/** An argument that is null and must not be is refused by the name of its public parameter, and nothing has changed. */
@Tag("each-jdk")
class NullArgumentsTest {
    private static final Rollback.Game NO_GAME = new Rollback.Game() {
        @Override
        public void beforeStep(int frame, long[] inputs) {}

        @Override
        public void save(ByteBuffer to) {}

        @Override
        public void restore(ByteBuffer from) {}
    };

    private final World world = WorldScenes.jvm().threads(1).build();

    @AfterEach
    void close() {
        world.close();
    }

    /** By method: the name of a parameter, and a call in which it alone is null. */
    private Map<String, Map<String, ThrowingCallable>> calls() {
        long[] handles = {};
        float[] values = {};
        StaleHandles stale = StaleHandles.REFUSE;
        FixedStep loop = new FixedStep(world, 1 / 60f);
        Map<String, Map<String, ThrowingCallable>> calls = new TreeMap<>();
        calls.put(
                "Builder.edges",
                Map.of(
                        "x", () -> World.builder().edges(null, Edge.WALL),
                        "y", () -> World.builder().edges(Edge.WALL, null)));
        calls.put("World.touching", Map.of("handles", () -> world.touching(0, 0, null)));
        calls.put("World.touchingPieces", Map.of("handles", () -> world.touchingPieces(0, 0, null)));
        calls.put("World.contactsOf", Map.of("partners", () -> world.contactsOf(1, null, null)));
        calls.put("World.readLoadsById", Map.of("loads", () -> world.readLoadsById(null, null)));
        calls.put("World.addAll", Map.of("circles", () -> world.addAll(null, values, new int[0], handles)));
        calls.put(
                "World.removeAll",
                Map.of(
                        "handles", () -> world.removeAll(null, 0, stale),
                        "stale", () -> world.removeAll(handles, 0, null)));
        calls.put("World.setPositions", many("positions", (h, v, s) -> world.setPositions(h, 0, v, s)));
        calls.put("World.setVelocities", many("velocities", (h, v, s) -> world.setVelocities(h, 0, v, s)));
        calls.put("World.applyImpulses", many("impulses", (h, v, s) -> world.applyImpulses(h, 0, v, s)));
        calls.put("World.setForces", many("forces", (h, v, s) -> world.setForces(h, 0, v, s)));
        calls.put(
                "World.setAngularVelocities",
                many("angularVelocities", (h, v, s) -> world.setAngularVelocities(h, 0, v, s)));
        calls.put("World.setWallSurface", Map.of("wall", () -> world.setWallSurface(null, 0, 0, 0)));
        calls.put("World.wallFriction", Map.of("wall", () -> world.wallFriction(null)));
        calls.put("World.wallRollingResistance", Map.of("wall", () -> world.wallRollingResistance(null)));
        calls.put("World.wallBeltSpeed", Map.of("wall", () -> world.wallBeltSpeed(null)));
        calls.put("Builder.wallSurface", Map.of("wall", () -> World.builder().wallSurface(null, 0, 0, 0)));
        calls.put("Kind.copyFrom", Map.of("other", () -> world.kind(0).copyFrom(null)));
        calls.put("Kind.setInertia", Map.of("inertia", () -> world.kind(0).setInertia(null)));
        calls.put("World.readAnglesById", Map.of("angles", () -> world.readAnglesById(null, null)));
        calls.put(
                "World.readAngularVelocitiesById",
                Map.of("angularVelocities", () -> world.readAngularVelocitiesById(null, null)));
        calls.put("World.setKinds", many("kinds", (h, v, s) -> world.setKinds(h, 0, v == null ? null : new int[0], s)));
        calls.put("World.setResponse", Map.of("response", () -> world.setResponse(0, 0, null)));
        calls.put("World.read", Map.of("circles", () -> {
            refusal(() -> world.read((FloatBuffer) null), "circles");
            world.read((float[]) null);
        }));
        calls.put("World.readVelocities", Map.of("velocities", () -> {
            refusal(() -> world.readVelocities((FloatBuffer) null), "velocities");
            world.readVelocities((float[]) null);
        }));
        calls.put("World.readHandles", Map.of("handles", () -> {
            refusal(() -> world.readHandles((LongBuffer) null), "handles");
            world.readHandles((long[]) null);
        }));
        calls.put("World.readById", Map.of("circles", () -> world.readById(null, null)));
        calls.put("World.readVelocitiesById", Map.of("velocities", () -> world.readVelocitiesById(null, null)));
        calls.put("World.readAwakeById", Map.of("awake", () -> world.readAwakeById(null)));
        calls.put("World.readKindsById", Map.of("kinds", () -> world.readKindsById(null, null)));
        calls.put("World.readRadiiById", Map.of("radii", () -> world.readRadiiById(null, null)));
        calls.put("World.readTagsById", Map.of("tags", () -> world.readTagsById(null, null)));
        calls.put("FixedStep.jointEnds", Map.of("ends", () -> loop.jointEnds(null, null)));
        calls.put("FixedStep.bodies", Map.of("bodies", () -> loop.bodies(null, null)));
        calls.put("FixedStep.pieces", Map.of("pieces", () -> loop.pieces(null, null)));
        calls.put(
                "FixedStep.pose",
                Map.of(
                        "body", () -> loop.pose(null, new float[3]),
                        "pose", () -> loop.pose(world.terrain().ground(), null)));
        calls.put("Chain.of", Map.of("points", () -> Chain.of((float[]) null)));
        Terrain terrain = world.terrain();
        calls.put("Terrain.addArc", Map.of("side", () -> {
            refusal(() -> terrain.addArc(0, 0, 1, 0, 1, null), "side");
            terrain.addArc(0, 0, 1, 0, 1, null, 0);
        }));
        calls.put("Terrain.addChain", Map.of("chain", () -> {
            refusal(() -> terrain.addChain(null), "chain");
            terrain.addChain(null, 0, null);
        }));
        calls.put("Terrain.addSegments", Map.of("ends", () -> terrain.addSegments(null, 0, null)));
        calls.put("Terrain.readPieces", Map.of("pieces", () -> terrain.readPieces(null, null)));
        calls.put("TerrainBody.addArc", Map.of("side", () -> {
            refusal(() -> terrain.ground().addArc(0, 0, 1, 0, 1, null), "side");
            terrain.ground().addArc(0, 0, 1, 0, 1, null, 0);
        }));
        calls.put("TerrainBody.addChain", Map.of("chain", () -> {
            refusal(() -> terrain.ground().addChain(null), "chain");
            terrain.ground().addChain(null, 0, null);
        }));
        calls.put(
                "TerrainBody.addSegments", Map.of("ends", () -> terrain.ground().addSegments(null, 0, null)));
        Bodies bodies = world.bodies();
        calls.put("Bodies.add", Map.of("outline", () -> {
            refusal(() -> bodies.add(null, 0, 0, 0, 1), "outline");
            bodies.add(null, 0, 0, 0, 1, 2);
        }));
        calls.put(
                "Bodies.addAll",
                Map.of(
                        "outline", () -> bodies.addAll((Outline) null, new float[4], null, null),
                        "outlines", () -> bodies.addAll((Outline[]) null, new float[4], null, null),
                        "outline 1",
                                () -> bodies.addAll(new Outline[] {Outline.box(1, 1), null}, new float[8], null, null),
                        "bodies", () -> bodies.addAll(Outline.box(1, 1), null, null, null)));
        calls.put(
                "Bodies.removeAll",
                Map.of(
                        "handles", () -> bodies.removeAll(null, 0, stale),
                        "stale", () -> bodies.removeAll(handles, 0, null)));
        calls.put("Bodies.teleportAll", many("poses", (h, v, s) -> bodies.teleportAll(h, 0, v, s)));
        calls.put("Bodies.setVelocities", many("velocities", (h, v, s) -> bodies.setVelocities(h, 0, v, s)));
        calls.put("Bodies.applyImpulses", many("impulses", (h, v, s) -> bodies.applyImpulses(h, 0, v, s)));
        calls.put("Bodies.setForces", many("forces", (h, v, s) -> bodies.setForces(h, 0, v, s)));
        calls.put(
                "Bodies.setKinds", many("kinds", (h, v, s) -> bodies.setKinds(h, 0, v == null ? null : new int[0], s)));
        calls.put("Bodies.readById", Map.of("bodies", () -> bodies.readById(null, null)));
        calls.put("Bodies.readVelocitiesById", Map.of("velocities", () -> bodies.readVelocitiesById(null, null)));
        calls.put("Bodies.touching", Map.of("handles", () -> bodies.touching(0, null)));
        calls.put("Bodies.readHandles", Map.of("handles", () -> bodies.readHandles(null)));
        calls.put("Outline.polygon", Map.of("points", () -> Outline.polygon((float[]) null)));
        calls.put("Outline.of", Map.of("chain", () -> Outline.of((Chain) null)));
        Joints joints = world.joints();
        calls.put(
                "Joints.add",
                Map.of(
                        "joint",
                                () -> {
                                    refusal(() -> joints.add(1, 2, null), "joint");
                                    refusal(() -> joints.add(1, 0, 0, null), "joint");
                                    refusal(() -> joints.add(1, terrain.ground(), 0, 0, null), "joint");
                                    joints.add(1, null);
                                },
                        "body", () -> joints.add(1, null, 0, 0, Joint.pin()),
                        "terrain", () -> joints.add(1, 0, 0, null, 0, 0, Joint.pin())));
        calls.put(
                "Joints.addAll",
                Map.of(
                        "circles",
                                () -> {
                                    refusal(() -> joints.addAll(null, handles, Joint.weld(), null), "circles");
                                    joints.addAll(null, Joint.motor(1, 1), null);
                                },
                        "others", () -> joints.addAll(handles, null, Joint.weld(), null),
                        "joint",
                                () -> {
                                    refusal(() -> joints.addAll(handles, handles, null, null), "joint");
                                    joints.addAll(handles, null, null);
                                }));
        calls.put("Joints.removeAll", Map.of("joints", () -> joints.removeAll(null)));
        calls.put("Joints.ofCircle", Map.of("joints", () -> joints.ofCircle(world.handle(0), null)));
        calls.put("Joints.ofBody", Map.of("joints", () -> joints.ofBody(1, null)));
        calls.put("Joints.readEnds", Map.of("ends", () -> joints.readEnds(null)));
        Ropes.End end = Ropes.at(0, 0);
        calls.put("Ropes.on", Map.of("body", () -> Ropes.on(null, 0, 0)));
        calls.put(
                "Ropes.rope",
                Map.of(
                        "world",
                                () -> {
                                    refusal(() -> Ropes.rope(null, end, end, 3, 1, 1, 0), "world");
                                    Ropes.rope(null, end, end, 3, 1, 1, 0, Joint.distance());
                                },
                        "from",
                                () -> {
                                    refusal(() -> Ropes.rope(world, null, end, 3, 1, 1, 0), "from");
                                    Ropes.rope(world, null, end, 3, 1, 1, 0, Joint.distance());
                                },
                        "to",
                                () -> {
                                    refusal(() -> Ropes.rope(world, end, null, 3, 1, 1, 0), "to");
                                    Ropes.rope(world, end, null, 3, 1, 1, 0, Joint.distance());
                                },
                        "link", () -> Ropes.rope(world, end, end, 3, 1, 1, 0, null)));
        calls.put(
                "Ropes.bridge",
                Map.of(
                        "world", () -> Ropes.bridge(null, end, end, 3, 1, 1, 0),
                        "from", () -> Ropes.bridge(world, null, end, 3, 1, 1, 0),
                        "to", () -> Ropes.bridge(world, end, null, 3, 1, 1, 0)));
        calls.put("Blobs.ring", Map.of("world", () -> Blobs.ring(null, 0, 0, 1, 9, 0.1f, 1, 5, 1)));
        calls.put("Blobs.lattice", Map.of("world", () -> Blobs.lattice(null, 0, 0, 3, 3, 1, 0.1f, 1, 5, 1)));
        calls.put("Blobs.cloth", Map.of("world", () -> Blobs.cloth(null, 0, 0, 3, 3, 1, 0.1f, 1, 5, 1)));
        calls.put("World.snapshot", Map.of("to", () -> world.snapshot(null)));
        calls.put("World.restore", Map.of("from", () -> world.restore(null)));
        calls.put("Builder.backend", Map.of("backend", () -> World.builder().backend(null)));
        calls.put("Builder.device", Map.of("device", () -> World.builder().device(null)));
        calls.put("FixedStep.FixedStep", Map.of("world", () -> new FixedStep(null, 1)));
        calls.put("FixedStep.advanceReplay", Map.of("replay", () -> loop.advanceReplay(1, null)));
        calls.put("Rewind.Rewind", Map.of("world", () -> new Rewind(null, 1)));
        calls.put(
                "Rollback.Rollback",
                Map.of(
                        "world", () -> new Rollback(null, NO_GAME, 1, 1, 1),
                        "game", () -> new Rollback(world, null, 1, 1, 1)));
        calls.put(
                "Recording.Recording",
                Map.of(
                        "world", () -> new Recording(null, OutputStream.nullOutputStream(), 1),
                        "out", () -> new Recording(world, null, 1)));
        calls.put(
                "Replay.Replay",
                Map.of(
                        "world", () -> new Replay(new ByteArrayInputStream(new byte[0]), null),
                        "in", () -> new Replay(null, world)));
        return calls;
    }

    /** A call about many handles. */
    private interface Many {
        void call(long[] handles, float[] values, StaleHandles stale);
    }

    private static Map<String, ThrowingCallable> many(String values, Many call) {
        return Map.of(
                "handles",
                () -> call.call(null, new float[0], StaleHandles.REFUSE),
                values,
                () -> call.call(new long[0], null, StaleHandles.REFUSE),
                "stale",
                () -> call.call(new long[0], new float[0], null));
    }

    /** Methods whose arguments may all be null. */
    private static final Set<String> OPTIONAL = Set.of(
            "Outline.equals",
            "World.positionsById",
            "World.takePositionsById",
            "FixedStep.advance",
            "FixedStep.positions");

    @Test
    void aNullIsRefusedByTheNameOfItsParameter() {
        world.add(0.5f, 0.5f, 0.1f, 1);
        ByteBuffer before = snapshot(world);
        calls().forEach((method, byParameter) -> byParameter.forEach((name, call) -> refusal(call, name)));
        assertThat(snapshot(world)).isEqualTo(before);
    }

    private static void refusal(ThrowingCallable call, String name) {
        assertThatNullPointerException().isThrownBy(call).withMessage(name + " must not be null");
    }

    @Test
    void everyMethodThatTakesAnObjectIsAsked() {
        Set<String> known = new TreeSet<>(calls().keySet());
        known.addAll(OPTIONAL);
        Set<String> all = Stream.of(
                        World.class,
                        World.Builder.class,
                        Kind.class,
                        Terrain.class,
                        TerrainBody.class,
                        Joints.class,
                        Bodies.class,
                        Outline.class,
                        Ropes.class,
                        Blobs.class,
                        Chain.class,
                        FixedStep.class,
                        Rewind.class,
                        Rollback.class,
                        Recording.class,
                        Replay.class)
                .flatMap(type -> Stream.of(type.getConstructors(), type.getDeclaredMethods())
                        .flatMap(Arrays::<Executable>stream)
                        .filter(each -> Modifier.isPublic(each.getModifiers()))
                        .filter(each ->
                                !List.of(each.getParameterTypes()).stream().allMatch(Class::isPrimitive))
                        .map(each -> type.getSimpleName() + "." + each.getName().replaceFirst(".*\\.", "")))
                .collect(Collectors.toCollection(TreeSet::new));
        assertThat(known).isEqualTo(all);
    }

    @Test
    void theLengthsOfTheSameArraysAreNamedToo() {
        long[] handles = {world.add(0.5f, 0.5f, 0.1f, 1)};
        assertThat(world.setForces(handles, 1, new float[2], StaleHandles.REFUSE))
                .isZero();
        assertThatIllegalArgumentException()
                .isThrownBy(() -> world.setForces(handles, 2, new float[4], StaleHandles.REFUSE))
                .withMessage("count is 2, but must be from 0 to 1, the number of elements of handles");
    }
}
