package io.github.circles2d;

import static io.github.circles2d.Refusals.assertIllegalState;
import static io.github.circles2d.WorldScenes.snapshot;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.catchThrowable;

import io.github.circles2d.opencl.DeviceMemoryException;
import io.github.circles2d.opencl.OpenClException;
import io.github.circles2d.world.jvm.JvmPipeline;
import io.github.circles2d.world.shared.Pipeline;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Proxy;
import java.nio.ByteBuffer;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Errors of the virtual machine and of devices: which of them lose the state of a world, and which do not. */
@Tag("each-jdk")
class WorldErrorsTest {
    private static final float STEP = 1 / 60f;

    private static final List<Throwable> OUT_OF_MEMORY = List.of(
            new OutOfMemoryError("none left"),
            new StackOverflowError("none left"),
            new DeviceMemoryException("none left", 2, 1));

    /** By method of a pipeline: what it throws. */
    private final Map<String, Throwable> failing = new HashMap<>();

    /** Whom a pipeline tells of a device that fails. */
    private Consumer<Throwable> losses;

    private World world() {
        return world(new JvmPipeline(1, 1, 0, false));
    }

    private World world(Pipeline inner) {
        Pipeline pipeline = (Pipeline) Proxy.newProxyInstance(
                Pipeline.class.getClassLoader(), new Class<?>[] {Pipeline.class}, (proxy, method, arguments) -> {
                    if (method.getName().equals("watch")) {
                        losses = losses(arguments[0]);
                    }
                    Throwable failure = failing.get(method.getName());
                    if (failure != null) {
                        if (failure instanceof OpenClException && !(failure instanceof DeviceMemoryException)) {
                            losses.accept(failure); // as a session does
                        }
                        throw failure;
                    }
                    try {
                        return method.invoke(inner, arguments);
                    } catch (InvocationTargetException e) {
                        throw e.getCause();
                    }
                });
        World world = new World(World.builder(), new BackendChoice(Backend.JVM, pipeline, "a test"));
        world.add(0.4f, 0.5f, 0.1f, 1);
        world.add(0.5f, 0.5f, 0.1f, 1);
        world.step(STEP);
        return world;
    }

    @SuppressWarnings("unchecked")
    private static Consumer<Throwable> losses(Object argument) {
        return (Consumer<Throwable>) argument;
    }

    private static void callRead(World world, String method) {
        switch (method) {
            case "readCircles" -> {
                assertThat(catchThrowable(() -> world.queries().pick(0.4f, 0.5f)))
                        .isNotNull();
                assertThat(catchThrowable(() -> world.x(1L << 32))).isNotNull();
                world.read(new float[8]);
            }
            case "readVelocities" -> {
                assertThat(catchThrowable(() -> world.vx(1L << 32))).isNotNull();
                world.readVelocities(new float[4]);
            }
            case "readAngles" -> {
                assertThat(catchThrowable(() -> world.angle(1L << 32))).isNotNull();
                assertThat(catchThrowable(world::angles)).isNotNull();
                world.readAnglesById(new float[4], null);
            }
            case "readAngularVelocities" -> {
                assertThat(catchThrowable(() -> world.angularVelocity(1L << 32)))
                        .isNotNull();
                world.readAngularVelocitiesById(new float[4], null);
            }
            case "positions" -> world.positions();
            case "requestPositions" -> world.requestPositions();
            case "takePositions" -> {
                world.requestPositions();
                world.takePositions();
            }
            case "save" -> {
                assertThat(catchThrowable(world::snapshotBytes)).isNotNull();
                world.snapshot(ByteBuffer.allocate(1000));
            }
            case "hash" -> world.hash();
            default -> world.stats();
        }
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "readCircles",
                "readVelocities",
                "readAngles",
                "readAngularVelocities",
                "positions",
                "requestPositions",
                "takePositions",
                "save",
                "hash",
                "candidatePairs",
                "contacts",
                "greatestContacts",
                "bytesHeld",
                "stageMillis"
            })
    void aReadThatFindsTooLittleMemoryLosesNothing(String method) {
        for (Throwable cause : OUT_OF_MEMORY) {
            try (World world = world()) {
                world.setAngle(1L << 32, 1);
                long hash = world.hash();
                failing.put(method, cause);
                assertThatThrownBy(() -> callRead(world, method)).isSameAs(cause);
                failing.clear();
                assertThat(world.hash()).isEqualTo(hash);
                float[] circles = new float[8];
                world.read(circles);
                assertThat(world.x(1L << 32)).isEqualTo(circles[0]);
                assertThat(world.angle(1L << 32)).isEqualTo(1);
                world.requestPositions();
                assertThat(world.takePositions().get(3)).isEqualTo(circles[5]);
            }
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"positions", "hash", "candidatePairs"})
    void aReadThatADeviceFailsLosesTheState(String method) {
        OpenClException cause = new OpenClException("the device is gone");
        try (World world = world()) {
            failing.put(method, cause);
            assertThatThrownBy(() -> callRead(world, method)).isSameAs(cause);
            failing.clear();
            assertFailed(world, cause);
        }
    }

    @Test
    void aRequestThatFindsTooLittleMemoryLeavesNoOlderOneInItsPlace() {
        try (World world = world()) {
            world.requestPositions();
            failing.put("requestPositions", OUT_OF_MEMORY.get(0));
            assertThatThrownBy(world::requestPositions).isSameAs(OUT_OF_MEMORY.get(0));
            assertIllegalState("no positions have been requested", world::takePositions);
        }
    }

    @Test
    void changesThatFindTooLittleMemoryWaitOn() {
        try (World world = world();
                World same = world()) {
            world.add(0.6f, 0.6f, 0.1f, 1);
            same.add(0.6f, 0.6f, 0.1f, 1);
            List<Consumer<World>> calls = List.of(World::hash, World::positions, each -> each.step(STEP));
            for (Consumer<World> call : calls) {
                for (Throwable cause : OUT_OF_MEMORY) {
                    failing.put("makeRoom", cause);
                    assertThatThrownBy(() -> call.accept(world)).isSameAs(cause);
                }
            }
            failing.clear();
            assertThat(world.hash()).isEqualTo(same.hash());
        }
    }

    @Test
    void aWorldThatFindsTooLittleMemoryToTurnOrForTerrainWaitsOn() {
        List<Consumer<World>> turns = List.of(
                each -> each.setAngularVelocity(1L << 32, 3),
                each -> each.setFriction(1L << 32, 0.5f),
                each -> each.applyTorque(1L << 32, 0.5f),
                each -> each.kind(0).setFriction(0.5f),
                each -> each.setWallSurface(Wall.MIN_Y, 0.5f, 0, 1),
                each -> each.terrain().addSegment(0, 0, 1, 0));
        for (Consumer<World> turn : turns) {
            try (World world = world();
                    World same = world()) {
                turn.accept(world);
                turn.accept(same);
                for (Throwable cause : OUT_OF_MEMORY) {
                    failing.put("prepare", cause);
                    assertThatThrownBy(() -> world.step(STEP)).isSameAs(cause);
                }
                failing.clear();
                assertThat(world.hash()).isEqualTo(same.hash());
                world.step(STEP);
                same.step(STEP);
                assertThat(world.hash()).isEqualTo(same.hash());
            }
        }
    }

    @Test
    void aRestoreThatFindsTooLittleMemoryChangesNothing() {
        try (World world = world()) {
            ByteBuffer snapshot = snapshot(world);
            world.remove(1L << 32);
            long hash = world.hash();
            for (String method : List.of("makeRoom", "prepare")) {
                failing.put(method, OUT_OF_MEMORY.get(0));
                assertThatThrownBy(() -> world.restore(snapshot)).isSameAs(OUT_OF_MEMORY.get(0));
                failing.clear();
                assertThat(snapshot.position()).isZero();
                assertThat(world.size()).isOne();
                assertThat(world.hash()).isEqualTo(hash);
            }
            world.restore(snapshot);
            assertThat(world.size()).isEqualTo(2);
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"apply", "step", "finish", "confine", "load"})
    void aChangeThatFailsInTheMidstLosesTheStateAndNothingHinders(String method) {
        for (Throwable cause : new Throwable[] {
            new OutOfMemoryError(), new StackOverflowError(), new AssertionError(), new IllegalStateException()
        }) {
            try (World world = world()) {
                ByteBuffer snapshot = snapshot(world);
                world.setVelocity(1L << 32, 1, 0);
                failing.put(method, cause);
                assertThatThrownBy(() -> {
                            switch (method) {
                                case "apply" -> world.hash();
                                case "step" -> world.step(STEP);
                                case "finish" -> world.finish();
                                case "confine" -> world.setBounds(0, 0, 2, 2);
                                default -> world.restore(snapshot);
                            }
                        })
                        .isSameAs(cause);
                failing.clear();
                assertFailed(world, cause);
            }
        }
    }

    private static void assertFailed(World world, Throwable cause) {
        assertThatThrownBy(world::hash)
                .isInstanceOf(IllegalStateException.class)
                .hasMessageContaining("failed earlier")
                .hasCause(cause);
        assertThatThrownBy(() -> world.step(STEP))
                .isInstanceOf(IllegalStateException.class)
                .hasCause(cause);
    }

    @Test
    void circlesGoOnToGrowBehindAStepThatIsNotMadeForWantOfMemory() {
        for (Throwable cause : OUT_OF_MEMORY) {
            try (World world = world()) {
                world.grow(world.handle(0), 0.2f, 3);
                long before = world.hash();
                failing.put("makeRoom", cause);
                assertThat(catchThrowable(() -> world.step(STEP))).isSameAs(cause);
                assertThat(catchThrowable(() -> world.step(STEP, 2))).isSameAs(cause);
                failing.clear();
                assertThat(world.hash()).isEqualTo(before);
                world.step(STEP, 2);
                assertThat(world.growthSteps(world.handle(0))).isOne();
                world.step(STEP);
                assertThat(world.radius(world.handle(0))).isEqualTo(0.2f);
            }
        }
    }

    @Test
    void aStepThatIsNotMadeForWantOfMemoryEndsTheLogAndNotTheWorld() throws IOException {
        for (Throwable cause : OUT_OF_MEMORY) {
            try (World world = world()) {
                Recording recording = new Recording(world, OutputStream.nullOutputStream(), 1);
                world.add(0.7f, 0.5f, 0.1f, 1);
                long hash = world.hash();
                world.setVelocity(world.handle(0), 1, 0);
                failing.put("makeRoom", cause);
                assertThat(catchThrowable(() -> world.step(STEP))).isSameAs(cause);
                failing.clear();
                assertThat(world.hash()).isNotEqualTo(hash);
                world.step(STEP);
                assertThat(recording.hasFailed()).isTrue();
                assertThatThrownBy(recording::close)
                        .isInstanceOf(IOException.class)
                        .hasMessage("the log ends early: a step in it could not be made");
            }
        }
    }

    @Test
    void aHashThatLacksMemoryEndsTheLogAndNotTheStep() throws IOException {
        for (Throwable cause : OUT_OF_MEMORY) {
            try (World world = world()) {
                Recording recording = new Recording(world, OutputStream.nullOutputStream(), 1);
                failing.put("hash", cause);
                world.step(STEP);
                failing.clear();
                assertThat(recording.hasFailed()).isTrue();
                assertThatThrownBy(recording::close)
                        .isInstanceOf(IOException.class)
                        .hasCause(cause);
                world.step(STEP);
            }
        }
    }

    /** Whoever looks for the reason wants the step that has lost the world, too. */
    @Test
    void theLogOfALostWorldEndsWithTheStepThatLostIt() throws IOException {
        ByteArrayOutputStream log = new ByteArrayOutputStream();
        try (World world = world();
                World player = WorldScenes.jvm().build()) {
            Recording recording = new Recording(world, log, 1);
            world.step(STEP);
            failing.put("step", new IllegalStateException("lost"));
            assertThatThrownBy(() -> world.step(STEP)).hasMessage("lost");
            assertThatThrownBy(world::hash).hasMessageContaining("lost its state");
            recording.close();
            Replay replay = new Replay(new ByteArrayInputStream(log.toByteArray()), player).run();
            assertThat(replay.steps()).isEqualTo(2);
            assertThat(replay.equalUpTo()).isEqualTo(1);
        }
    }
}
