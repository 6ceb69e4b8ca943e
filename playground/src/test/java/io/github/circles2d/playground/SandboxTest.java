package io.github.circles2d.playground;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import io.github.circles2d.Backend;
import io.github.circles2d.opencl.Device;
import io.github.circles2d.opencl.OpenCl;
import io.github.circles2d.opencl.OpenClException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.opentest4j.TestAbortedException;

/** The past of a world, other back ends, and files. */
class SandboxTest {
    private static final Runnable NOTHING = () -> {};

    private static void steps(Sandbox sandbox, int count) {
        for (int k = 0; k < count; k++) {
            sandbox.stepOnce(NOTHING);
        }
    }

    static Backend[] backends() {
        return devices().stream()
                .map(device -> device.kind() == Device.Kind.CPU ? Backend.OPENCL_CPU : Backend.OPENCL_GPU)
                .distinct()
                .toArray(Backend[]::new);
    }

    /** At least one. Without any the test fails if one is required, and is skipped otherwise. */
    private static List<Device> devices() {
        try {
            return OpenCl.devices();
        } catch (OpenClException e) {
            if (Boolean.getBoolean("circles2d.device.required")) {
                throw e;
            }
            throw new TestAbortedException(e.getMessage());
        }
    }

    @ParameterizedTest
    @MethodSource("backends")
    void aSwitchOfTheBackEndChangesNoBitOfWhatFollows(Backend backend) {
        requireSameBits("sandbox", backend);
        requireSameBits("blobs", backend);
    }

    private static void requireSameBits(String stage, Backend backend) {
        try (Sandbox straight = new Sandbox(Stages.named(stage), Backend.JVM);
                Sandbox switched = new Sandbox(Stages.named(stage), Backend.JVM)) {
            steps(straight, 60);
            steps(switched, 20);
            switched.switchTo(backend);
            assertThat(switched.stats().backend()).isEqualTo(backend);
            assertThat(switched.step()).isEqualTo(20);
            steps(switched, 20);
            switched.switchTo(Backend.JVM);
            steps(switched, 20);
            assertThat(switched.world().hash())
                    .as(stage)
                    .isEqualTo(straight.world().hash());
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"pegs", "wrecking-ball"})
    void goingBackLeadsThroughTheSameStatesInTheOtherOrder(String stage) {
        try (Sandbox sandbox = new Sandbox(Stages.named(stage), Backend.JVM)) {
            long[] hashes = new long[50];
            for (int step = 0; step < 50; step++) {
                hashes[step] = sandbox.world().hash();
                sandbox.stepOnce(NOTHING);
            }
            for (int step = 49; step >= 0; step--) {
                assertThat(sandbox.back()).isTrue();
                assertThat(sandbox.step()).isEqualTo(step);
                assertThat(sandbox.world().hash()).isEqualTo(hashes[step]);
            }
            assertThat(sandbox.back()).as("there is nothing before the start").isFalse();
            steps(sandbox, 30);
            assertThat(sandbox.world().hash()).isEqualTo(hashes[30]);
        }
    }

    @Test
    void thePastTakesNoMoreMemoryThanItMay() {
        try (Sandbox sandbox = new Sandbox(Stages.named("marbles"), Backend.JVM)) {
            Timeline timeline = new Timeline(sandbox.world(), 40_000);
            for (int step = 0; step < 400; step++) {
                timeline.save(step);
                sandbox.world().step(Sandbox.TIME_STEP);
                assertThat(timeline.bytes()).isLessThan(50_000);
            }
            assertThat(timeline.stepsBefore(400)).isBetween(4, 40);
            assertThat(timeline.back(400)).isEqualTo(399);
        }
    }

    @Test
    void aSavedWorldIsOpenedWhereItWas(@TempDir Path folder) throws Exception {
        Path file = folder.resolve("world.circles2d");
        try (Sandbox sandbox = new Sandbox(Stages.named("pegs"), Backend.JVM);
                Sandbox other = new Sandbox(Stages.named("empty"), Backend.JVM)) {
            steps(sandbox, 25);
            sandbox.save(file);
            other.open(file);
            assertThat(other.world().hash()).isEqualTo(sandbox.world().hash());
            assertThat(other.stage().name()).isEqualTo("world.circles2d");
            assertThat(other.grain().radius()).isEqualTo(sandbox.grain().radius());
            steps(sandbox, 25);
            steps(other, 25);
            assertThat(other.world().hash()).isEqualTo(sandbox.world().hash());
        }
    }

    @Test
    void aFileThatIsNoWorldIsRefusedAndChangesNothing(@TempDir Path folder) throws Exception {
        Path file = Files.write(folder.resolve("world.circles2d"), new byte[100]);
        try (Sandbox sandbox = new Sandbox(Stages.named("pegs"), Backend.JVM)) {
            steps(sandbox, 5);
            long hash = sandbox.world().hash();
            assertThatIllegalArgumentException().isThrownBy(() -> sandbox.open(file));
            assertThat(sandbox.world().hash()).isEqualTo(hash);
            assertThat(sandbox.step()).isEqualTo(5);
        }
    }

    @Test
    void everyStageOpensAndMakesSteps() {
        try (Sandbox sandbox = new Sandbox(Stages.all().get(0), Backend.JVM)) {
            for (Stage stage : Stages.all()) {
                if (stage.name().equals("nexus-balls2")) {
                    continue; // 61,504 circles
                }
                sandbox.load(stage, Backend.JVM);
                steps(sandbox, 2);
                assertThat(sandbox.world().size() + sandbox.world().bodies().size() > 0)
                        .as(stage.name())
                        .isEqualTo(!stage.name().equals("empty"));
                assertThat(sandbox.grain().radius()).isGreaterThan(0);
                assertThat(sandbox.grain().highSpeed()).isGreaterThan(0);
            }
        }
    }
}
