package io.github.circles2d.world.device;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import io.github.circles2d.Backend;
import io.github.circles2d.Events;
import io.github.circles2d.Joint;
import io.github.circles2d.World;
import io.github.circles2d.opencl.Device;
import io.github.circles2d.opencl.KernelSource;
import io.github.circles2d.opencl.OnEachDevice;
import io.github.circles2d.opencl.OpenClException;
import io.github.circles2d.opencl.TestDevices;
import io.github.circles2d.scenes.Scenes;
import io.github.circles2d.world.device.memory.StageKernels;
import io.github.circles2d.world.device.plan.Plans;
import io.github.circles2d.world.device.plan.Tiles;
import io.github.circles2d.world.jvm.JvmPipeline;
import io.github.circles2d.world.model.StepReports;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** If a compiler refuses the kernels of a feature that comes later, the step throws, and the world goes on without it. */
class RefusedKernelsTest {
    private static final float DT = 1 / 60f;

    /** Features that come later, named by the constants that their kernels are compiled with. Circles that can rotate stay so. */
    enum Feature {
        TURNING(world -> world.kind(0).setFriction(0.5f), world -> {}),
        TERRAIN(world -> world.terrain().addSegment(0, 1, 10, 1), world -> world.terrain()
                .clear()),
        JOINTS(world -> world.joints().add(handles(world)[0], 5, 9, Joint.rope(1)), world -> world.joints()
                .clear()),
        REPORTING(world -> world.report(Events.BEGIN), world -> world.report(0));

        private final Consumer<World> come;
        private final Consumer<World> go;

        Feature(Consumer<World> come, Consumer<World> go) {
            this.come = come;
            this.go = go;
        }
    }

    private static long[] handles(World world) {
        long[] handles = new long[world.size()];
        world.readHandles(handles);
        return handles;
    }

    @AfterEach
    void forgetTheFolder() {
        System.clearProperty(KernelSource.FOLDER_PROPERTY);
    }

    @ParameterizedTest
    @EnumSource
    void aWorldGoesOnWithoutAFeatureWhoseKernelsAreRefused(Feature feature, @TempDir Path folder) throws IOException {
        assumeTrue(!TestDevices.all().isEmpty(), "no OpenCL device");
        copyKernels(folder);
        Path everywhere = folder.resolve("world/stages/World.cl");
        Files.writeString(
                everywhere, Files.readString(everywhere) + "\n#ifdef " + feature + "\n#error refused\n#endif\n");
        System.setProperty(KernelSource.FOLDER_PROPERTY, folder.toString());
        try (World here = world(Backend.JVM);
                World device = world(Backend.OPENCL_CPU)) {
            here.step(DT, 5);
            device.step(DT, 5);
            feature.come.accept(here);
            feature.come.accept(device);
            for (int i = 0; i < 2; i++) {
                assertThatThrownBy(() -> device.step(DT))
                        .isInstanceOf(OpenClException.class)
                        .hasMessageContaining("refused");
            }
            assertThat(device.hash()).isEqualTo(here.hash());
            if (feature != Feature.TURNING) {
                feature.go.accept(here);
                feature.go.accept(device);
                here.step(DT, 20);
                device.step(DT, 20);
                assertThat(device.hash()).isEqualTo(here.hash());
            }
        }
    }

    /** The thread beside is refused them: no step begins that may need them. */
    @OnEachDevice
    @Timeout(value = 300, unit = TimeUnit.SECONDS)
    void stepsEndBeforeTheyBeginIfKernelsOfSomeOfThemAreRefused(Device device, @TempDir Path folder)
            throws IOException, InterruptedException {
        assumeTrue(Tiles.fit(device), "a device of one plan has one program");
        copyKernels(folder);
        Path fast = folder.resolve("world/stages/ContinuousCollision.cl");
        Files.writeString(
                fast, Files.readString(fast).replace("number < partsOfAllLooks(&w)", "refused_by_all(number)"));
        System.setProperty(KernelSource.FOLDER_PROPERTY, folder.toString());
        DevicePipeline pipeline =
                new DevicePipeline(device, 0, false, Plans.TILES.of(device), StageKernels.USUAL_GROUPS, false);
        JvmPipeline jvm = new JvmPipeline(1, JvmPipeline.LEAST_SHARE, 0, false);
        try (Twins twins = Twins.load(Scenes.packed(50, 1), jvm, pipeline)) {
            twins.step(DT, 1);
            while (!isRefused(pipeline)) {
                Thread.sleep(20);
            }
            twins.assertEqual("refused");
        }
    }

    private static boolean isRefused(DevicePipeline pipeline) {
        try {
            pipeline.prepareSteps(new StepReports());
            return false;
        } catch (OpenClException e) {
            assertThat(e).hasMessageContaining("refused_by_all");
            return true;
        }
    }

    private static World world(Backend backend) {
        World world = World.builder()
                .backend(backend)
                .bounds(0, 0, 10, 10)
                .gravity(0, -10)
                .build();
        for (int i = 0; i < 30; i++) {
            world.add(1 + 1.1f * (i % 8), 2 + 1.2f * (i / 8), 0.5f, 1);
        }
        return world;
    }

    private static void copyKernels(Path folder) throws IOException {
        Path kernels = Path.of("kernels");
        try (Stream<Path> files = Files.walk(kernels)) {
            for (Path file : (Iterable<Path>) files::iterator) {
                Path copy = folder.resolve(kernels.relativize(file).toString());
                if (Files.isDirectory(file)) {
                    Files.createDirectories(copy);
                } else {
                    Files.copy(file, copy);
                }
            }
        }
    }
}
