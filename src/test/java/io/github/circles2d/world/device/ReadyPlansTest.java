package io.github.circles2d.world.device;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.circles2d.opencl.Device;
import io.github.circles2d.opencl.TestDevices;
import io.github.circles2d.scenes.Scenes;
import io.github.circles2d.world.device.memory.StageKernels;
import io.github.circles2d.world.device.plan.ByColours;
import io.github.circles2d.world.device.plan.Plan;
import io.github.circles2d.world.device.plan.Plans;
import io.github.circles2d.world.device.plan.Tiles;
import io.github.circles2d.world.events.ContactEvents;
import io.github.circles2d.world.jvm.JvmPipeline;
import io.github.circles2d.world.model.Bounds;
import io.github.circles2d.world.model.Features;
import io.github.circles2d.world.model.Readiness;
import io.github.circles2d.world.model.Tuning;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** A device makes steps before the kernels of its fastest plan have been compiled. */
class ReadyPlansTest {
    static List<Device> devices() {
        return TestDevices.all().stream().filter(Tiles::fit).toList();
    }

    private static DevicePipeline pipeline(Device device, boolean waits) {
        return new DevicePipeline(device, 0, false, Plans.TILES.of(device), StageKernels.USUAL_GROUPS, waits);
    }

    @ParameterizedTest
    @MethodSource("devices")
    @Timeout(value = 300, unit = TimeUnit.SECONDS)
    void stepsGoByColoursUntilTheKernelsOfTilesAreThereAndNoBitDiffers(Device device) throws InterruptedException {
        DevicePipeline beside = pipeline(device, false);
        assertThat(beside.readyPlans()).isEmpty();
        try (Twins twins =
                Twins.load(Scenes.packed(300, 1), new JvmPipeline(1, JvmPipeline.LEAST_SHARE, 0, false), beside)) {
            twins.step(1 / 60f, 1);
            assertThat(beside.readyPlans()).last().isInstanceOf(ByColours.class);
            while (beside.readyPlans().size() < 2) {
                Thread.sleep(10);
                twins.step(1 / 60f, 1);
            }
            twins.assertEqual("when tiles are ready");
            assertThat(beside.readyPlans()).first().isInstanceOf(Tiles.class);
            twins.step(1 / 60f, 5);
            twins.assertEqual("by tiles");
        }
    }

    @ParameterizedTest
    @MethodSource("devices")
    void aPipelineThatWaitsHasAllPlansAtItsFirstStep(Device device) {
        DevicePipeline waiting = pipeline(device, true);
        try (Twins twins =
                Twins.load(Scenes.packed(100, 1), new JvmPipeline(1, JvmPipeline.LEAST_SHARE, 0, false), waiting)) {
            twins.step(1 / 60f, 1);
            assertThat(waiting.readyPlans()).hasSize(2);
        }
    }

    /** As a world that moves has it done, which no step then waits for. */
    @ParameterizedTest
    @MethodSource("devices")
    void whatIsCompiledAheadIsThereAtTheFirstStep(Device device) {
        DevicePipeline ahead = pipeline(device, false);
        assertThat(ahead.isReady(Readiness.USUAL)).isFalse();
        ahead.compile(Readiness.USUAL);
        assertThat(ahead.isReady(Readiness.USUAL)).isTrue();
        assertThat(ahead.isReady(new Readiness(true, Features.NONE, false, false)))
                .isFalse();
        try (Twins twins =
                Twins.load(Scenes.packed(100, 1), new JvmPipeline(1, JvmPipeline.LEAST_SHARE, 0, false), ahead)) {
            twins.step(1 / 60f, 1);
            assertThat(ahead.readyPlans()).hasSize(2);
            twins.assertEqual("by tiles");
        }
    }

    /** The first step needs all of them: it waits for none of those beside it. */
    @ParameterizedTest
    @MethodSource("devices")
    void whatOnlySomeStepsNeedIsCompiledWhenAStepNeedsIt(Device device) {
        DevicePipeline some = pipeline(device, false);
        JvmPipeline jvm = new JvmPipeline(1, JvmPipeline.LEAST_SHARE, 0, false);
        try (Twins twins = Twins.sleeping(new Bounds(0, 0, 1, 1), 4, 10, jvm, some)) {
            twins.report(ContactEvents.ALL);
            twins.addCrowd(1 + Tuning.CROWD / 2);
            twins.add(0.8f, 0.2f, 0.2f, 1, 0, 0, 0); // of a coarser level
            twins.add(0.1f, 0.9f, 0.01f, 1, 0, 300, 0); // fast
            twins.giveSensors(1, 5);
            twins.sense(0, 1);
            twins.addJoints(1, 40);
            twins.step(1 / 60f, 1);
            twins.assertEqual("first step");
            twins.assertSameEvents("first step");
            twins.assertSameFigures();
            twins.add(0.8f, 0.6f, 0.1f, 1, 0, 0, 0); // falls on those that sleep
            int most = 0;
            for (int step = 0; step < 400; step += 10) {
                twins.step(1 / 60f, 10);
                twins.assertEqual("step " + step);
                twins.assertSameEvents("step " + step);
                most = Math.max(most, twins.assertSameSleepers("step " + step));
            }
            assertThat(most).isPositive();
        }
    }

    @ParameterizedTest
    @MethodSource("devices")
    @Tag("long")
    void worldsCloseWhileKernelsAreCompiled(Device device) {
        for (int i = 0; i < 2; i++) {
            DevicePipeline closing = pipeline(device, false);
            try (Twins twins =
                    Twins.load(Scenes.packed(100, i), new JvmPipeline(1, JvmPipeline.LEAST_SHARE, 0, false), closing)) {
                twins.step(1 / 60f, 1);
            }
        }
        List<Plan> none = pipeline(device, false).readyPlans();
        assertThat(none).isEmpty();
    }
}
