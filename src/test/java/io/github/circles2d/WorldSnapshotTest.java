package io.github.circles2d;

import static io.github.circles2d.Refusals.assertIllegalArgument;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import io.github.circles2d.scenes.Scene;
import io.github.circles2d.scenes.Scenes;
import io.github.circles2d.world.snapshots.SnapshotCodec;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Random;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** What a snapshot keeps, what it costs, and what it refuses. */
class WorldSnapshotTest {
    private static final int AHEAD = 8;

    static Stream<Scene> settlingScenes() {
        return Stream.of(Scenes.thesis(1250, Scenes.SEED), Scenes.packed(4000, Scenes.SEED), Scenes.pyramid());
    }

    @ParameterizedTest
    @MethodSource("settlingScenes")
    @Tag("long")
    void takesAtMost64BytesACircleOnceSettled(Scene scene) {
        try (World world = WorldScenes.world(scene, WorldScenes.builder(scene))) {
            world.step(scene.timeStep(), 600);
            assertThat((world.snapshotBytes() - SnapshotCodec.HEADER) / (double) world.size())
                    .isLessThanOrEqualTo(64);
        }
    }

    @ParameterizedTest
    @MethodSource("settlingScenes")
    @Tag("long")
    void takesAtMost72BytesACircleOnceSettledWithFriction(Scene scene) {
        World.Builder builder = WorldScenes.builder(scene).friction(0.6f).rollingResistance(0.1f);
        try (World world = WorldScenes.world(scene, builder)) {
            world.step(scene.timeStep(), 600);
            assertThat((world.snapshotBytes() - SnapshotCodec.HEADER) / (double) world.size())
                    .isBetween(50.0, 72.0);
        }
    }

    static Stream<Scene> crowdedScenes() {
        return Stream.of(
                Scenes.thesis(500, 5),
                Scenes.onePoint(300, 5),
                Scenes.mixed(400, 5),
                Scenes.bouncy(5),
                Scenes.billiards(20));
    }

    @ParameterizedTest
    @MethodSource("crowdedScenes")
    @Tag("each-jdk")
    void restoredAfterAnyStepANewWorldGoesOnAsTheOldOne(Scene scene) {
        int steps = 60;
        long[] hashes = new long[steps + AHEAD];
        ByteBuffer[] snapshots = new ByteBuffer[steps];
        try (World world = WorldScenes.world(scene, WorldScenes.builder(scene))) {
            for (int step = 0; step < steps + AHEAD; step++) {
                hashes[step] = world.hash();
                if (step < steps) {
                    snapshots[step] = snapshot(world);
                }
                change(world, scene, step);
                world.step(stepLength(scene, step));
            }
        }
        for (int step = 0; step < steps; step++) {
            try (World restored = WorldScenes.onThreads(1 + step % 3, WorldScenes.jvm())) {
                restored.restore(snapshots[step]);
                assertThat(snapshots[step].hasRemaining()).isFalse();
                for (int k = step; k < step + AHEAD; k++) {
                    assertThat(restored.hash())
                            .as("%d, restored at %d", k, step)
                            .isEqualTo(hashes[k]);
                    change(restored, scene, k);
                    restored.step(stepLength(scene, k));
                }
            }
        }
    }

    /** Steps of two lengths, so that the length of the last one counts. */
    private static float stepLength(Scene scene, int step) {
        return step % 5 == 0 ? scene.timeStep() * 0.5f : scene.timeStep();
    }

    /** A change of some kind that depends on the number of the step alone. */
    private static void change(World world, Scene scene, int step) {
        long[] handles = new long[world.size()];
        world.readHandles(handles);
        long some = handles[step * 7 % handles.length];
        switch (step % 6) {
            case 1 -> world.remove(some);
            case 2 -> world.add(scene.minX() + 0.4f * (scene.maxX() - scene.minX()), world.y(some), scene.radius(0), 2);
            case 3 -> world.setVelocity(some, 0.1f, 0.2f);
            case 4 -> world.setMass(some, Float.POSITIVE_INFINITY);
            case 5 -> {
                world.setRestitution(some, 0.25f);
                world.setTag(some, -(long) step << 33);
            }
            default -> world.setGravity(0.01f * step, -0.02f);
        }
    }

    @Test
    void keepsHandlesAndStaleHandlesAndWhichIdsAreFree() {
        try (World world = WorldScenes.jvm().bounds(-2, -3, 4, 5).build();
                World restored = WorldScenes.jvm().build()) {
            long a = world.add(0, 0, 0.1f, 1);
            long b = world.add(1, 0, 0.1f, 1);
            long c = world.add(2, 0, 0.1f, 1);
            world.remove(a);
            world.remove(c);
            long d = world.add(0, 1, 0.1f, Float.POSITIVE_INFINITY);
            world.remove(d);
            restored.add(0.5f, 0.5f, 0.1f, 1);
            restored.restore(snapshot(world));
            assertThat(restored.size()).isEqualTo(1);
            assertThat(restored.contains(b)).isTrue();
            assertThat(restored.contains(a)).isFalse();
            assertThat(restored.contains(c)).isFalse();
            assertThat(restored.contains(d)).isFalse();
            for (int k = 0; k < 5; k++) {
                assertThat(restored.add(3, 4, 0.1f, 1)).isEqualTo(world.add(3, 4, 0.1f, 1));
            }
            assertThat(restored.hash()).isEqualTo(world.hash());
        }
    }

    @Test
    @Tag("each-jdk")
    void ofARestoredWorldIsTheSameBytes() {
        Scene scene = Scenes.thesis(600, 9);
        try (World world = WorldScenes.world(scene, WorldScenes.builder(scene).subSteps(3));
                World restored = WorldScenes.jvm().build()) {
            world.step(scene.timeStep(), 50);
            for (int k = 0; k < 300; k++) {
                world.remove(k % 2 == 0 ? handle(world, 0) : handle(world, world.size() - 1));
            }
            ByteBuffer snapshot = snapshot(world);
            restored.restore(snapshot);
            assertThat(snapshot(restored)).isEqualTo(snapshot.flip());
        }
    }

    private static long handle(World world, int place) {
        long[] handles = new long[world.size()];
        world.readHandles(handles);
        return handles[place];
    }

    @Test
    void keepsTagsAndTakesNoBytesForCirclesWithoutOne() {
        try (World world = settled();
                World restored = WorldScenes.jvm().build()) {
            int untagged = world.snapshotBytes();
            long[] handles = new long[world.size()];
            world.readHandles(handles);
            for (int k = 0; k < handles.length; k += 3) {
                world.setTag(handles[k], Long.MIN_VALUE + k);
            }
            assertThat(world.snapshotBytes()).isGreaterThan(untagged);
            restored.restore(snapshot(world));
            for (int k = 0; k < handles.length; k++) {
                assertThat(restored.tag(handles[k])).isEqualTo(k % 3 == 0 ? Long.MIN_VALUE + k : 0);
                world.setTag(handles[k], 0);
            }
            assertThat(world.snapshotBytes()).isEqualTo(untagged);
            restored.restore(snapshot(world));
            assertThat(restored.tag(handles[0])).isZero();
            assertThat(restored.hash()).isEqualTo(world.hash());
        }
    }

    @Test
    @Tag("each-jdk")
    void goesIntoAndOutOfTheMiddleOfAnyBuffer() {
        try (World world = settled();
                World restored = WorldScenes.jvm().build()) {
            ByteBuffer big =
                    ByteBuffer.allocateDirect(100 + world.snapshotBytes()).order(ByteOrder.BIG_ENDIAN);
            big.position(37);
            world.snapshot(big);
            assertThat(big.position()).isEqualTo(37 + world.snapshotBytes());
            big.position(37);
            restored.restore(big.asReadOnlyBuffer().order(ByteOrder.LITTLE_ENDIAN));
            assertThat(restored.hash()).isEqualTo(world.hash());
        }
    }

    @Test
    void ofAnEmptyWorldIsTheHeader() {
        try (World world = WorldScenes.jvm().build();
                World restored = settled()) {
            assertThat(world.snapshotBytes()).isEqualTo(SnapshotCodec.HEADER);
            restored.restore(snapshot(world));
            assertThat(restored.size()).isZero();
            restored.step(0.1f);
            assertThat(restored.hash()).isZero();
        }
    }

    @Test
    void withTooLittleRoomWritesNothing() {
        try (World world = settled()) {
            ByteBuffer small = ByteBuffer.allocate(world.snapshotBytes() - 1);
            assertIllegalArgument("room", () -> world.snapshot(small));
            assertThat(small.position()).isZero();
            assertThat(small.array()).containsOnly(0);
            ByteBuffer readOnly = ByteBuffer.allocate(world.snapshotBytes()).asReadOnlyBuffer();
            assertThatIllegalArgumentException().isThrownBy(() -> world.snapshot(readOnly));
        }
    }

    @Test
    void withAnyBitTurnedIsRefusedAndChangesNothing() {
        try (World world = settled();
                World other = unsettled()) {
            world.setTag(handle(world, 3), 1234567890123L);
            ByteBuffer good = snapshot(world);
            long hash = other.hash();
            for (int bit = 0; bit < 8 * good.limit(); bit++) {
                ByteBuffer bad = copy(good, good.limit());
                bad.put(bit / 8, (byte) (bad.get(bit / 8) ^ 1 << bit % 8));
                assertThatIllegalArgumentException().isThrownBy(() -> other.restore(bad));
                assertThat(bad.position()).isZero();
            }
            assertThat(other.hash()).isEqualTo(hash);
            other.restore(good);
            assertThat(other.hash()).isEqualTo(world.hash());
        }
    }

    @Test
    void cutOffAnywhereOrForeignIsRefused() {
        try (World world = settled();
                World other = unsettled()) {
            world.setTag(handle(world, 3), 1234567890123L);
            ByteBuffer good = snapshot(world);
            long hash = other.hash();
            for (int length = 0; length < good.limit(); length++) {
                ByteBuffer cut = copy(good, length);
                assertThatIllegalArgumentException().isThrownBy(() -> other.restore(cut));
            }
            Random random = new Random(6);
            for (int k = 0; k < 1000; k++) {
                byte[] foreign = new byte[random.nextInt(500)];
                random.nextBytes(foreign);
                assertThatIllegalArgumentException().isThrownBy(() -> other.restore(ByteBuffer.wrap(foreign)));
            }
            assertThat(other.hash()).isEqualTo(hash);
            assertThat(other.size()).isEqualTo(1);
        }
    }

    private static World settled() {
        Scene scene = Scenes.pyramid();
        World world = WorldScenes.world(scene, WorldScenes.builder(scene));
        world.step(scene.timeStep(), 600);
        return world;
    }

    private static World unsettled() {
        World world = WorldScenes.jvm().build();
        world.add(0.5f, 0.5f, 0.1f, 1, 0.1f, 0);
        world.step(1 / 60f);
        return world;
    }

    private static ByteBuffer snapshot(World world) {
        ByteBuffer buffer = ByteBuffer.allocate(world.snapshotBytes());
        world.snapshot(buffer);
        assertThat(buffer.hasRemaining()).isFalse();
        return buffer.flip();
    }

    private static ByteBuffer copy(ByteBuffer buffer, int length) {
        return ByteBuffer.allocate(length).put(0, buffer, 0, length);
    }
}
