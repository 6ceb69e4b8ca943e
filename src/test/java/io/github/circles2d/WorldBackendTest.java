package io.github.circles2d;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import com.sun.management.ThreadMXBean;
import io.github.circles2d.opencl.ForkedJvm;
import io.github.circles2d.opencl.OpenClUnavailableException;
import io.github.circles2d.opencl.TestDevices;
import io.github.circles2d.scenes.Scene;
import io.github.circles2d.scenes.Scenes;
import java.lang.management.ManagementFactory;
import java.nio.ByteBuffer;
import java.nio.FloatBuffer;
import java.nio.file.Path;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** What a world runs on: the choice, and that nothing but speed depends on it. */
@Tag("each-jdk")
class WorldBackendTest {
    private static final ThreadMXBean THREADS = (ThreadMXBean) ManagementFactory.getThreadMXBean();

    @Test
    void aPhoneHasTwoThreadsUnasked() {
        assertThat(World.Builder.defaultThreads(8, true)).isEqualTo(2);
        assertThat(World.Builder.defaultThreads(1, true)).isEqualTo(1);
        assertThat(World.Builder.defaultThreads(8, false)).isEqualTo(8);
        assertThat(World.Builder.defaultThreads(64, false)).isEqualTo(16);
    }

    @OnEachOpenClBackend
    void aBackEndAskedForIsTakenAndHasTheSameHashAsTheJvm(Backend backend) {
        Scene scene = Scenes.thesis(1250, Scenes.SEED);
        try (World world = WorldScenes.world(scene, WorldScenes.builder(scene).backend(backend));
                World jvm = WorldScenes.world(scene, WorldScenes.builder(scene).backend(Backend.JVM))) {
            for (int frame = 0; frame < 20; frame++) {
                world.step(scene.timeStep());
                jvm.step(scene.timeStep());
                assertThat(world.hash()).isEqualTo(jvm.hash());
            }
            WorldStats stats = world.stats();
            assertThat(stats.backend()).isEqualTo(backend);
            assertThat(stats.reason()).isEqualTo("asked for");
            assertThat(stats.contacts()).isEqualTo(jvm.stats().contacts());
            assertThat(stats.candidatePairs()).isEqualTo(jvm.stats().candidatePairs());
            assertThat(stats.bytesHeld()).isGreaterThan(100L * scene.size());
        }
    }

    @OnEachOpenClBackend
    @Tag("long")
    void aWorldThatReportsSensorsAloneTakesNoMemoryForContacts(Backend backend) {
        Scene scene = Scenes.packed(5_000, Scenes.SEED);
        long[] held = new long[2];
        for (int k = 0; k < 2; k++) {
            try (World world =
                    WorldScenes.world(scene, WorldScenes.builder(scene).backend(backend))) {
                world.kind(1).setSensor(true);
                long sensor = world.add(0.5f, 0.5f, 0.1f, 1, 0, 0, 1);
                if (k == 1) {
                    world.report(0, 1, Events.BEGIN | Events.END);
                }
                world.step(scene.timeStep(), 3);
                assertThat(world.events().size() == 0).isEqualTo(k == 0);
                held[k] = world.stats().bytesHeld();
                assertThat(world.contains(sensor)).isTrue();
            }
        }
        // What a sensor's world has besides: where circles began the step, records, pairs and tables of kinds.
        assertThat(held[1] - held[0]).isBetween(1L, 100L * scene.size());
    }

    @OnEachOpenClBackend
    void aSnapshotTakenAtAnyStepGoesOnTheSameOnAnotherBackEnd(Backend backend) {
        Scene scene = Scenes.packed(500, Scenes.SEED);
        try (World world = WorldScenes.world(scene, WorldScenes.builder(scene).backend(backend));
                World jvm = WorldScenes.jvm().build();
                World back = World.builder().backend(backend).build()) {
            long[] handles = new long[scene.size()];
            world.readHandles(handles);
            for (int frame = 0; frame < 30; frame++) {
                world.setTag(handles[frame], -frame);
                world.step(scene.timeStep());
                ByteBuffer bytes = ByteBuffer.allocate(world.snapshotBytes());
                world.snapshot(bytes);
                jvm.restore(bytes.flip());
                jvm.step(scene.timeStep());
                ByteBuffer returned = ByteBuffer.allocate(jvm.snapshotBytes());
                jvm.snapshot(returned);
                back.restore(returned.flip());
                assertThat(back.hash()).isEqualTo(jvm.hash());
                back.step(scene.timeStep());
                world.step(scene.timeStep(), 2);
                assertThat(back.hash()).isEqualTo(world.hash());
            }
        }
    }

    @OnEachOpenClBackend
    void positionsRequestedAreWhatTheJvmReadsAtTheRequestWhoeverComesAndGoesBehindIt(Backend backend) {
        Scene scene = Scenes.packed(800, Scenes.SEED);
        try (World world = WorldScenes.world(scene, WorldScenes.builder(scene).backend(backend));
                World jvm = WorldScenes.world(scene, WorldScenes.builder(scene))) {
            for (int frame = 0; frame < 40; frame++) {
                FloatBuffer expected = FloatBuffer.allocate(2 * jvm.size());
                expected.put(jvm.positions()).flip();
                world.requestPositions();
                for (World each : new World[] {world, jvm}) {
                    long[] handles = new long[each.size()];
                    each.readHandles(handles);
                    each.remove(handles[7 * frame % handles.length]);
                    if (frame % 3 == 0) {
                        each.step(scene.timeStep());
                    }
                    each.add(0.2f + 0.01f * frame, 0.95f, 0.002f, 1);
                    each.add(0.2f + 0.01f * frame, 0.9f, 0.002f, 1);
                    if (frame % 2 == 0) {
                        each.step(scene.timeStep(), 2);
                    }
                }
                assertThat(world.takePositions()).as("frame " + frame).isEqualTo(expected);
            }
        }
    }

    @OnEachOpenClBackend
    void stepsAndReadsAllocateLessThanAKibibyteWhateverTheNumberOfCircles(Backend backend) {
        for (int n : new int[] {200, 5000}) {
            Scene scene = Scenes.packed(n, Scenes.SEED);
            float[] circles = new float[4 * n];
            try (World world =
                    WorldScenes.world(scene, WorldScenes.builder(scene).backend(backend))) {
                int frames = 20;
                long least = Long.MAX_VALUE;
                // Buffers grow, and code is compiled, at first.
                for (int round = 0; round < 40 && least >= 1024 * frames; round++) {
                    long before = THREADS.getCurrentThreadAllocatedBytes();
                    for (int frame = 0; frame < frames; frame++) {
                        world.step(scene.timeStep());
                        world.read(circles);
                        world.requestPositions();
                        world.step(scene.timeStep());
                        world.takePositions();
                    }
                    least = Math.min(least, THREADS.getCurrentThreadAllocatedBytes() - before);
                }
                assertThat(least / frames).isLessThan(1024);
            }
        }
    }

    @Test
    void aWorldForFewCirclesRunsOnTheJvmAndSaysWhy() {
        try (World world = World.builder().build()) {
            assertThat(world.stats().backend()).isEqualTo(Backend.JVM);
            assertThat(world.stats().reason()).contains("GPU").contains("1024");
        }
    }

    /** Builds worlds where there is no driver. */
    static final class WithoutDriver {
        public static void main(String[] args) {
            try (World world = World.builder().capacity(1_000_000).build()) {
                world.add(0.5f, 0.5f, 0.1f, 1);
                world.step(1 / 60f); // nothing is opened beside the first step
                world.step(1 / 60f);
                while (world.stats().reason().contains("made ready")) {
                    Thread.onSpinWait();
                }
                System.out.println(
                        "took " + world.stats().backend() + ": " + world.stats().reason());
            }
            for (Backend backend : new Backend[] {Backend.OPENCL_CPU, Backend.OPENCL_GPU}) {
                assertThatThrownBy(() -> World.builder().backend(backend).build())
                        .isInstanceOf(OpenClUnavailableException.class);
            }
            System.out.println("done");
        }
    }

    @Test
    void withoutOpenClTheFastestIsTheJvmAndAnythingElseIsRefused(@TempDir Path noDrivers) {
        ForkedJvm.Result result = new ForkedJvm()
                .environment("OCL_ICD_VENDORS", noDrivers.toString())
                .run(WithoutDriver.class);
        assertThat(result.output()).contains("took JVM: no GPU can be used: ", "done");
        assertThat(result.output()).as("nobody has asked for a GPU").doesNotContain("INFO");
        assertThat(result.exitStatus()).isZero();
    }

    /** Starts all that needs no GPU. */
    static final class Quiet {
        public static void main(String[] args) {
            for (Backend backend : new Backend[] {Backend.AUTO, Backend.JVM, Backend.OPENCL_CPU}) {
                try (World world = World.builder().backend(backend).build()) {
                    world.add(0.5f, 0.5f, 0.1f, 1);
                    world.step(1 / 60f);
                }
            }
            new Circles2D(false).close();
            System.out.println("done");
        }
    }

    @Test
    void aStartIsSilent() {
        TestDevices.all();
        ForkedJvm.Result result = new ForkedJvm().run(Quiet.class);
        // newer JDKs warn of native access, which only the command line of a program can allow; POCL may compile for
        // long
        assertThat(result.output()
                        .lines()
                        .filter(line -> !line.isEmpty()
                                && !line.startsWith("WARNING: ")
                                && !line.contains("DevicePipeline compile")
                                && !line.contains("until kernels were compiled")))
                .containsExactly("done");
    }
}
