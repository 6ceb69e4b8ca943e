package io.github.circles2d;

import static io.github.circles2d.WorldScenes.snapshot;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import io.github.circles2d.opencl.Device;
import io.github.circles2d.opencl.DeviceMemoryException;
import io.github.circles2d.opencl.OpenClException;
import io.github.circles2d.opencl.TestDevices;
import io.github.circles2d.opencl.TestScale;
import io.github.circles2d.world.jvm.JvmPipeline;
import io.github.circles2d.world.shared.Pipeline;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.lang.reflect.InvocationHandler;
import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Method;
import java.lang.reflect.Proxy;
import java.nio.ByteBuffer;
import java.util.List;
import java.util.Random;
import java.util.Set;
import java.util.function.Consumer;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** A world that moves between two steps gives the bits, events and bytes of one that stays. */
class MovesTest {
    private static final float STEP = 1 / 60f;

    /** What a device may refuse without any change. */
    private static final Set<String> REFUSED = Set.of("prepare", "prepareSteps", "makeRoom", "makeRoomToReport");

    /** {@link GoldenScene#cost} times steps that a scene may take. */
    private static final long AFFORDABLE = TestScale.of(20_000, 60_000, 1_000_000);

    private static final long ON_DEVICE = TestScale.of(150_000, 1_000_000);

    static List<GoldenScene> scenes() {
        return GoldenScene.all().stream()
                .filter(scene -> scene.cost() <= TestScale.of(2_000, 5_000, 5_000))
                .toList();
    }

    /** One of each variant of kernels, and of each kind of change. */
    static List<GoldenScene> scenesOnDevices() {
        List<String> names = TestScale.EXHAUSTIVE
                ? scenes().stream().map(GoldenScene::name).toList()
                : List.of("pile-growth", "dragged", "billiards-spin", "hourglass", "carts");
        return scenes().stream().filter(scene -> names.contains(scene.name())).toList();
    }

    @ParameterizedTest
    @MethodSource("scenes")
    void aSceneHasTheHashesOnRecordWhereverItsStepsAreMade(GoldenScene scene) throws IOException {
        try (World world = scene.builder().backend(Backend.JVM).build()) {
            RandomMoves moves = RandomMoves.of(world, scene.name().hashCode(), 2);
            check(scene, world, AFFORDABLE);
            assertThat(moves.moves()).isPositive();
        }
    }

    @ParameterizedTest
    @MethodSource("scenesOnDevices")
    @Tag("long")
    void aSceneHasThemOnTheWayToADeviceAndBack(GoldenScene scene) throws IOException {
        for (Device device : TestDevices.all()) {
            try (World world = scene.builder().backend(Backend.JVM).build()) {
                RandomMoves moves = RandomMoves.of(world, 1, device, 2);
                check(scene, world, ON_DEVICE);
                assertThat(moves.movesToDevice()).isPositive();
            }
        }
    }

    private static void check(GoldenScene scene, World world, long affordable) throws IOException {
        GoldenHashes golden = GoldenHashes.load();
        int steps = 0;
        try (GoldenScene.Run run = scene.start(world)) {
            for (int mark : GoldenHashes.MARKS) {
                if ((long) mark * scene.cost() <= affordable) {
                    for (; steps < mark; steps++) {
                        run.advanceTo(steps + 1);
                    }
                    assertThat(Long.toHexString(world.hash()))
                            .as("hash after %d steps", mark)
                            .isEqualTo(Long.toHexString(golden.hash(scene, mark)));
                }
            }
        }
    }

    /** A pipeline in Java that lacks memory now and then, and fails for good at one of its calls, as a device may. */
    private static final class Unreliable implements InvocationHandler {
        /** What a device that has failed still does. */
        private static final Set<String> HARMLESS =
                Set.of("close", "device", "watch", "isReady", "bytesHeld", "toString", "equals", "hashCode");

        /** Calls that make steps, and may lack memory in the midst of one. */
        private static final Set<String> STEPS = Set.of("step", "finish");

        private final Pipeline inner = new JvmPipeline(1, 1, 0, false);
        private final Random random;
        private Consumer<Throwable> watcher = failure -> {};

        /** Calls that it still makes. */
        private int left;

        /** Whether it fails for want of memory in the midst of a step. */
        private final boolean lacksRoom;

        private Unreliable(Random random, int calls, boolean lacksRoom) {
            this.random = random;
            left = calls;
            this.lacksRoom = lacksRoom;
        }

        static Pipeline lackingMemory(Random random) {
            return of(new Unreliable(random, Integer.MAX_VALUE, false));
        }

        static Pipeline failing(Random random) {
            return of(new Unreliable(random, random.nextInt(200), random.nextInt(4) == 0));
        }

        private static Pipeline of(Unreliable device) {
            return (Pipeline)
                    Proxy.newProxyInstance(Pipeline.class.getClassLoader(), new Class<?>[] {Pipeline.class}, device);
        }

        @Override
        @SuppressWarnings("unchecked")
        public Object invoke(Object proxy, Method method, Object[] arguments) throws Throwable {
            String name = method.getName();
            if (name.equals("watch")) {
                watcher = (Consumer<Throwable>) arguments[0];
            }
            if (lacksRoom ? STEPS.contains(name) && --left < 0 : !HARMLESS.contains(name) && --left < 0) {
                if (lacksRoom) {
                    throw new DeviceMemoryException("no room for contacts", 2, 1);
                }
                OpenClException failure = new OpenClException("could not " + name + " on a lost device");
                watcher.accept(failure);
                throw failure;
            }
            if (REFUSED.contains(name) && random.nextInt(8) == 0) {
                throw new DeviceMemoryException("none left", 2, 1);
            }
            try {
                return method.invoke(inner, arguments);
            } catch (InvocationTargetException e) {
                throw e.getCause();
            }
        }
    }

    @Test
    void aWorldGoesOnAtHomeWhateverADeviceRefuses() {
        int refusals = 0;
        int movesOfNeed = 0;
        for (int seed = 0; seed < TestScale.of(30, 1000); seed++) {
            try (World world = game();
                    World stays = game()) {
                RandomMoves moves = RandomMoves.of(world, seed, Unreliable.lackingMemory(new Random(seed)));
                Random random = new Random(seed);
                Random same = new Random(seed);
                for (int frame = 0; frame < 60; frame++) {
                    change(world, random);
                    change(stays, same);
                    world.step(STEP);
                    stays.step(STEP);
                    assertThat(world.hash())
                            .as("seed %d, frame %d", seed, frame)
                            .isEqualTo(stays.hash());
                    assertThat(text(world.events())).isEqualTo(text(stays.events()));
                }
                refusals += moves.refusals();
                movesOfNeed += moves.movesOfNeed();
            }
        }
        assertThat(refusals).isPositive();
        assertThat(movesOfNeed).isPositive();
    }

    @Test
    void aWorldWhoseDeviceFailsGoesOnAtHomeWithAFrameOrASnapshot() throws IOException {
        int losses = 0;
        for (int seed = 0; seed < TestScale.of(20, 60, 1000); seed++) {
            ByteArrayOutputStream log = new ByteArrayOutputStream();
            try (World world = game();
                    World stays = game();
                    World player = WorldScenes.jvm().build()) {
                RandomMoves moves = RandomMoves.of(world, seed, Unreliable.failing(new Random(seed)));
                Recording recording = new Recording(world, log, 1);
                losses += frames(seed, world, stays, moves);
                try {
                    recording.close();
                } catch (OpenClException lost) {
                    continue; // in the last hash
                }
                Replay replay = new Replay(new ByteArrayInputStream(log.toByteArray()), player).run();
                assertThat(replay.differs()).as(replay.difference()).isFalse();
                assertThat(player.hash()).isEqualTo(stays.hash());
            }
        }
        assertThat(losses).isGreaterThan(5);
    }

    /** Makes frames in both, and goes back to the last save when the device fails. Returns how often it did. */
    private static int frames(int seed, World world, World stays, RandomMoves moves) {
        Rewind rewind = new Rewind(stays, 1);
        ByteBuffer saved = snapshot(world);
        rewind.save(0);
        int losses = 0;
        for (int frame = 0; frame < 60; frame++) {
            long next = 1000L * seed + frame;
            long hash;
            String events;
            try {
                change(world, new Random(next));
                world.step(STEP);
                hash = world.hash();
                events = text(world.events());
                if (frame % 7 == 0) {
                    saved = snapshot(world);
                }
            } catch (OpenClException lost) {
                losses++;
                assertThat(moves.losses()).isEqualTo(losses);
                assertThatThrownBy(world::hash)
                        .isInstanceOf(IllegalStateException.class)
                        .hasMessageContaining("restore")
                        .hasCause(lost);
                world.restore(saved.duplicate());
                rewind.restore(rewind.newest());
                world.report(0); // what is reported is no state, and the call may have failed
                stays.report(0);
                assertThat(world.hash()).as("seed %d, frame %d", seed, frame).isEqualTo(stays.hash());
                continue;
            }
            change(stays, new Random(next));
            stays.step(STEP);
            if (frame % 7 == 0) {
                rewind.save(frame + 1);
            }
            assertThat(hash).as("seed %d, frame %d", seed, frame).isEqualTo(stays.hash());
            assertThat(events).isEqualTo(text(stays.events()));
        }
        return losses;
    }

    static String text(Events events) {
        StringBuilder text = new StringBuilder();
        for (int i = 0; i < events.size(); i++) {
            text.append(events.type(i))
                    .append(' ')
                    .append(events.a(i))
                    .append(' ')
                    .append(events.b(i))
                    .append('\n');
        }
        return text.toString();
    }

    private static World game() {
        World world = WorldScenes.jvm()
                .bounds(0, 0, 10, 10)
                .gravity(0, -10)
                .threads(1)
                .build();
        for (int i = 0; i < 30; i++) {
            world.add(1 + 1.1f * (i % 8), 2 + 1.2f * (i / 8), 0.5f, 1);
        }
        return world;
    }

    private static void change(World world, Random random) {
        long[] handles = new long[world.size()];
        world.readHandles(handles);
        long some = handles[random.nextInt(handles.length)];
        switch (random.nextInt(14)) {
            case 0 -> world.add(5, 9, 0.3f, 1);
            case 1 -> {
                if (handles.length > 5) {
                    world.remove(some);
                }
            }
            case 2 -> world.setFriction(some, random.nextFloat());
            case 3 -> world.report(random.nextInt(16));
            case 4 -> world.terrain().addSegment(0, random.nextFloat(), 10, 1 + random.nextFloat());
            case 5 -> world.joints().add(some, 5, 9, Joint.rope(3).breakingAt(50, 50));
            case 6 -> world.applyForce(some, 100 * random.nextFloat(), 100);
            case 7 -> world.setRadius(some, 0.2f + 0.3f * random.nextFloat());
            case 8 -> world.kind(1).setSensor(random.nextBoolean());
            case 9 -> world.setKind(some, random.nextInt(3));
            case 10 -> {
                ByteBuffer bytes = ByteBuffer.allocate(world.snapshotBytes());
                world.snapshot(bytes);
                world.step(STEP);
                world.restore(bytes.flip());
            }
            case 11 -> {
                world.requestPositions();
                world.step(STEP);
                assertThat(world.takePositions().remaining()).isEqualTo(2 * handles.length);
            }
            case 12 -> world.setBounds(-random.nextFloat(), 0, 10, 10);
            default -> {}
        }
    }
}
