package io.github.circles2d.world.device.plan;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assumptions.assumeThat;

import io.github.circles2d.opencl.Device;
import io.github.circles2d.opencl.DeviceBuffer;
import io.github.circles2d.opencl.KernelSource;
import io.github.circles2d.opencl.OnEachDevice;
import io.github.circles2d.opencl.Session;
import io.github.circles2d.world.device.memory.StageKernels;
import io.github.circles2d.world.device.memory.TileRecord;
import io.github.circles2d.world.model.Bounds;
import io.github.circles2d.world.model.GridLevels;
import java.nio.IntBuffer;
import java.util.List;
import org.junit.jupiter.api.Test;

/** Which plan makes a step, and what a device compiles. */
class PlansTest {
    private static final int MANY_CIRCLES = 1_000_000;

    @OnEachDevice
    void theLastPlanOfEveryRowSuitsAllSteps(Device device) {
        for (Plans row : Plans.values()) {
            List<Plan> plans = row.of(device);
            assertThat(plans.get(plans.size() - 1).suits(steps(2, MANY_CIRCLES, true)))
                    .as(row.name())
                    .isTrue();
        }
    }

    @OnEachDevice
    void aStepGoesToTheFirstPlanThatSuitsIt(Device device) {
        List<Plan> gpu = Plans.PERSISTENT_GPU.of(device);
        assertThat(Plans.first(gpu, steps(1, 1000, false))).isInstanceOf(PersistentGpu.class);
        assertThat(Plans.first(gpu, steps(1, 1000, true))).isInstanceOf(Tiles.class);
        assertThat(Plans.first(gpu, steps(1, MANY_CIRCLES, false))).isInstanceOf(Tiles.class);
        assertThat(Plans.first(gpu, steps(2, 1000, false))).isInstanceOf(PersistentGpu.class);
        assertThat(Plans.first(gpu, steps(2, 1000, true))).isInstanceOf(Tiles.class);
    }

    @OnEachDevice
    void stepsInWhichCirclesSleepHaveALaunchAStage(Device device) {
        Steps steps = sleeping(steps(1, 1000, false));
        assertThat(Plans.first(Plans.PERSISTENT_GPU.of(device), steps)).isInstanceOf(Tiles.class);
        assertThat(Plans.first(Plans.COLOURS.of(device), steps)).isInstanceOf(ByColours.class);
    }

    @OnEachDevice
    void aProcessorMakesStepsByColours(Device device) {
        assumeThat(device.kind()).isEqualTo(Device.Kind.CPU);
        assertThat(Plans.choose(device)).isEqualTo(Plans.COLOURS);
        assertThat(Plans.COLOURS.of(device)).singleElement().isInstanceOf(ByColours.class);
    }

    @OnEachDevice
    void stepsThatRecordWhatContactsDoAreMadeByTheSamePlans(Device device) {
        for (Plans row : Plans.values()) {
            for (Steps silent : new Steps[] {steps(1, 1000, false), steps(2, 1000, false), steps(1, 1000, true)}) {
                assertThat(Plans.first(row.of(device), recording(silent)))
                        .hasSameClassAs(Plans.first(row.of(device), silent));
            }
        }
    }

    @OnEachDevice
    void stepsThatTurnAreMadeByTheSamePlansIfTilesHaveRoom(Device device) {
        assumeThat(Tiles.holdTurning(device)).isTrue();
        for (Plans row : Plans.values()) {
            Steps steps = steps(1, 1000, false);
            assertThat(Plans.first(row.of(device), turning(steps))).hasSameClassAs(Plans.first(row.of(device), steps));
        }
    }

    private static Steps turning(Steps s) {
        return with(s, s.recording(), true, s.sleeping());
    }

    private static Steps recording(Steps s) {
        return with(s, true, s.turning(), s.sleeping());
    }

    private static Steps sleeping(Steps s) {
        return with(s, s.recording(), s.turning(), true);
    }

    private static Steps with(Steps s, boolean recording, boolean turning, boolean sleeping) {
        return new Steps(
                s.count(),
                s.levels(),
                s.slots(),
                s.circles(),
                s.subSteps(),
                s.warmScale(),
                s.sweeping(),
                s.thinning(),
                s.reportsBehind(),
                recording,
                s.sensing(),
                turning,
                s.joints(),
                s.bodies(),
                sleeping,
                s.waking());
    }

    @OnEachDevice
    void tilesThatNeverDoAreGivenUpForAWhile(Device device) {
        List<Plan> plans = Plans.PERSISTENT_GPU.of(device);
        Steps steps = steps(1, 1000, false);
        plans.forEach(plan -> plan.learn(new Plan.TileUse(Integer.MAX_VALUE, 0, false), false));
        int looks = 0;
        while (Plans.first(plans, steps) instanceof ByColours) {
            plans.forEach(plan -> plan.learn(new Plan.TileUse(0, 0, false), false));
            looks++;
        }
        assertThat(looks).isEqualTo(16);
        assertThat(Plans.first(plans, steps)).isInstanceOf(PersistentGpu.class);
    }

    @OnEachDevice
    void aDeviceCompilesNoFileThatItsPlansDoNotNeed(Device device) {
        assertThat(Plans.source(Plans.COLOURS.of(device)).toString()).doesNotContain("Tile", "PersistentGpu");
        assertThat(Plans.source(Plans.TILES.of(device)).toString())
                .contains("TileSolver.cl")
                .doesNotContain("PersistentGpu");
    }

    /** Hopper gives work-groups 196 KiB of local memory, or takes 32 KiB more from its cache; the driver adds 1 KiB to each. */
    @OnEachDevice
    void sevenWorkGroupsOfAPassByTilesLeaveHopperItsCache(Device device) {
        KernelSource source = Plans.source(Plans.TILES.of(device), device)
                .and(KernelSource.ofText(
                        "probe", "kernel void probe(global int *out) { out[0] = (int) sizeof(Tile); }\n"));
        int[] bytes = new int[1];
        try (Session session = Session.open(device);
                DeviceBuffer out = session.allocate("bytes", 4)) {
            session.build(source, StageKernels.options(device))
                    .kernel("probe")
                    .arg(0, out)
                    .run(1);
            out.read(IntBuffer.wrap(bytes));
        }
        assertThat(bytes[0]).isBetween(20 * TileRecord.CIRCLES, 196 * 1024 / 7 - 1024);
    }

    @Test
    void noKernelIsCompiledForMoreWorkItemsThanTheDeviceRunsInAWorkGroup() {
        assertThat(Tiles.eventGroup(256)).isEqualTo(256);
        assertThat(Tiles.eventGroup(1024)).isEqualTo(512);
    }

    @Test
    void theFingerprintIsOfTheFilesOfAllPlans() {
        assertThat(Plans.source(Plans.all()).toString()).contains("Solver.cl", "TileSolver.cl", "PersistentGpu.cl");
    }

    private static Steps steps(int sizes, int circles, boolean thinning) {
        int[] counts = new int[GridLevels.COUNT];
        counts[0] = circles;
        // Three size classes apart, so that the levels do not join.
        counts[3 * (sizes - 1)] = circles;
        GridLevels levels = new GridLevels();
        levels.layOut(new Bounds(0, 0, 100, 100), 0.1f, counts, false);
        assertThat(levels.usedCount).isEqualTo(sizes);
        return new Steps(
                1, levels, circles, circles, 4, 1f, false, thinning, false, false, false, false, false, false, false,
                false);
    }
}
