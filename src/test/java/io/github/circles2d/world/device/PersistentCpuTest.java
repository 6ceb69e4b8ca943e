package io.github.circles2d.world.device;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assumptions.assumeThat;

import io.github.circles2d.opencl.Device;
import io.github.circles2d.opencl.TestDevices;
import io.github.circles2d.scenes.HardScenes;
import io.github.circles2d.scenes.Scene;
import io.github.circles2d.scenes.Scenes;
import io.github.circles2d.world.Pipeline;
import io.github.circles2d.world.circles.Commands;
import io.github.circles2d.world.device.plan.ByColours;
import io.github.circles2d.world.device.plan.PersistentCpu;
import io.github.circles2d.world.device.plan.Plans;
import io.github.circles2d.world.device.plan.WorkGroups;
import io.github.circles2d.world.jvm.JvmPipeline;
import io.github.circles2d.world.model.Bounds;
import io.github.circles2d.world.model.Tuning;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import java.util.concurrent.Callable;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Whole steps in one launch on a processor, whose work-groups wait for each other. */
class PersistentCpuTest {
    static Iterable<Device> processors() {
        List<Device> processors = new ArrayList<>();
        for (Device device : TestDevices.all()) {
            if (PersistentCpu.fits(device)) {
                processors.add(device);
            }
        }
        return processors;
    }

    /** Work-groups of which one may be awaited that does not come, until the launch is called off. */
    private static final class Absent extends WorkGroups {
        private static final int FEW_LOOKS = 1000;

        private int most;
        private boolean waitsForNobody;

        Absent(Device device) {
            super(device.computeUnits());
            most = super.most();
        }

        @Override
        public int most() {
            return Math.min(most, super.most());
        }

        @Override
        public int awaited(int groups) {
            return waitsForNobody ? groups + 1 : groups;
        }

        @Override
        public int patience() {
            return waitsForNobody ? FEW_LOOKS : super.patience();
        }

        @Override
        public void calledOff() {
            super.calledOff();
            waitsForNobody = false;
        }
    }

    /** Work-groups that leave further steps to the host after each step, as if they had waited for long. */
    private static final class Hindered extends WorkGroups {
        private final List<Integer> made = new ArrayList<>();

        Hindered(Device device) {
            super(device.computeUnits());
        }

        @Override
        public int mostWaiting() {
            return -1;
        }

        @Override
        public void learn(int groups, int useful, int steps, long took, long waited) {
            if (groups > 1) {
                made.add(steps);
            }
        }
    }

    private static DevicePipeline pipeline(Device device, WorkGroups workGroups) {
        return pipeline(device, workGroups, false);
    }

    private static DevicePipeline pipeline(Device device, WorkGroups workGroups, boolean profiling) {
        return Pipelines.of(device, List.of(new PersistentCpu(workGroups), new ByColours()), profiling);
    }

    private static Pipeline java() {
        return new JvmPipeline(1, JvmPipeline.LEAST_SHARE, 0, false);
    }

    @ParameterizedTest
    @MethodSource("processors")
    void aLaunchThatAWorkGroupDoesNotComeToChangesNothingAndIsMadeByOne(Device device) {
        Absent workGroups = new Absent(device);
        try (Twins twins = Twins.load(Scenes.packed(5000, 1), java(), pipeline(device, workGroups))) {
            twins.step(1 / 60f, 3);
            twins.assertEqual("together");
            workGroups.waitsForNobody = true;
            twins.step(1 / 60f, 3);
            twins.assertEqual("waited for nobody");
            assertThat(workGroups.most()).isOne();
            twins.step(1 / 60f, 3);
            twins.assertEqual("alone");
        }
    }

    @ParameterizedTest
    @MethodSource("processors")
    void launchesBehindOneThatWasCalledOffMakeNoStepsEither(Device device) {
        Scene scene = Scenes.packed(3000, 2);
        Absent workGroups = new Absent(device);
        try (Twins twins = Twins.load(scene, java(), pipeline(device, workGroups))) {
            twins.step(1 / 60f, 2);
            twins.assertEqual("before");
            // The next step finds more slots than circles, those behind it count on finding as many.
            SplittableRandom random = new SplittableRandom(2);
            for (int k = 0; k < 200; k++) {
                twins.change(scene, random);
            }
            workGroups.waitsForNobody = true;
            twins.step(1 / 60f, 1);
            workGroups.waitsForNobody = false;
            twins.step(1 / 60f, 1);
            twins.step(1 / 60f, 1);
            twins.assertEqual("after");
        }
    }

    @ParameterizedTest
    @MethodSource("processors")
    void stepsThatWorkGroupsLeaveOutAreMadeByLaterLaunches(Device device) {
        assumeThat(device.computeUnits()).isGreaterThan(1);
        Scene scene = Scenes.packed(3000, 6);
        Hindered workGroups = new Hindered(device);
        try (Twins twins = Twins.load(scene, java(), pipeline(device, workGroups))) {
            twins.step(1 / 60f, 2);
            twins.assertEqual("before");
            SplittableRandom random = new SplittableRandom(6);
            for (int k = 0; k < 200; k++) {
                twins.change(scene, random);
            }
            twins.step(1 / 60f, 10);
            twins.step(1 / 60f, 3);
            twins.step(1 / 60f, 1);
            twins.assertEqual("after");
        }
        assertThat(workGroups.made).hasSizeGreaterThanOrEqualTo(16).containsOnly(0, 1);
    }

    @ParameterizedTest
    @MethodSource("processors")
    void workGroupsMeasureTheirTime(Device device) {
        List<Long> times = new ArrayList<>();
        WorkGroups workGroups = new WorkGroups(device.computeUnits()) {
            @Override
            public void learn(int groups, int useful, int steps, long took, long waited) {
                times.add(took);
                assertThat(waited).isBetween(0L, took);
            }
        };
        try (Twins twins = Twins.load(Scenes.packed(5000, 7), java(), pipeline(device, workGroups))) {
            for (int k = 0; k < 5; k++) {
                twins.step(1 / 60f, 20);
                twins.assertEqual("steps");
            }
        }
        assertThat(times).hasSizeGreaterThanOrEqualTo(5).allMatch(took -> took > 0);
    }

    @ParameterizedTest
    @MethodSource("processors")
    void theNumberOfWorkGroupsDoesNotShow(Device device) {
        Absent workGroups = new Absent(device);
        try (Twins twins = Twins.load(Scenes.packed(12_000, 3), java(), pipeline(device, workGroups))) {
            for (int k = 0; k < 6; k++) {
                workGroups.most = 1 + k % device.computeUnits();
                twins.step(1 / 60f, 3);
                twins.assertEqual(workGroups.most() + " work-groups");
            }
        }
    }

    /** Every tenth circle is static or very heavy, so that in some pairs the larger circle is the light one. */
    @ParameterizedTest
    @MethodSource("processors")
    void circlesOfManySizesHaveTheSameBitsInAnyNumberOfWorkGroups(Device device) {
        Scene scene = Scenes.mixed(8000, 3);
        Absent workGroups = new Absent(device);
        try (Twins twins = Twins.load(scene, java(), pipeline(device, workGroups))) {
            for (int id = 0; id < scene.size(); id += 10) {
                float mass = id % 20 == 0 ? Float.POSITIVE_INFINITY : 1e5f * scene.mass(id);
                twins.set(Commands.MASS, id, mass, 0);
            }
            for (int k = 0; k < 6; k++) {
                workGroups.most = 1 + k % device.computeUnits();
                twins.step(scene.timeStep(), 3);
                twins.assertEqual(workGroups.most() + " work-groups");
                twins.assertSameFigures();
            }
        }
    }

    /** Contacts for which there is no room at first: what is noted for other work-groups needs room, too. */
    @ParameterizedTest
    @MethodSource("processors")
    void roomIsMadeForContactsOfManySizes(Device device) {
        Scene scene = Scenes.mixed(4000, 6);
        try (Twins twins = Twins.load(scene, java(), Pipelines.of(device, Plans.PERSISTENT_CPU))) {
            for (int id = 0; id < scene.size(); id++) {
                twins.set(Commands.POSITION, id, 0.3f * scene.x(id), 0.3f * scene.y(id));
            }
            twins.step(scene.timeStep(), 2);
            twins.assertEqual("close together");
            twins.assertSameFigures();
        }
    }

    @ParameterizedTest
    @MethodSource("processors")
    void aStepWithACrowdStaysWithLanes(Device device) {
        DevicePipeline pipeline = Pipelines.of(device, Plans.PERSISTENT_CPU, true);
        try (Twins twins = Twins.empty(new Bounds(0, 0, 1, 1), java(), pipeline)) {
            twins.addCrowd(1 + Tuning.CROWD / 2);
            for (int k = 0; k < 2; k++) {
                twins.step(1 / 60f, 1);
                twins.assertEqual("step " + k);
                twins.assertSameFigures();
            }
            assertThat(pipeline.greatestContacts()).isGreaterThan(Tuning.CROWD);
            assertThat(pipeline.kernelNanos())
                    .containsKey("persistentCpu_steps")
                    .doesNotContainKey("contacts_crowd");
        }
    }

    @ParameterizedTest
    @MethodSource("processors")
    void crowdsAreThinnedOutByAllWorkGroups(Device device) {
        Absent workGroups = new Absent(device);
        DevicePipeline pipeline = pipeline(device, workGroups, true);
        try (Twins twins = Twins.load(HardScenes.squeezed(55, 5), java(), pipeline)) {
            workGroups.most = device.computeUnits();
            twins.step(1 / 60f, 1);
            assertThat(pipeline.kernelNanos())
                    .containsKey("persistentCpu_steps")
                    .doesNotContainKey("contacts_crowd");
            twins.assertEqual("all work-groups");
            twins.assertSameFigures();
            assertThat(pipeline.greatestContacts()).isGreaterThan(Tuning.CROWD);
        }
    }

    /** Nearly all circles of all levels have more candidates than pairs are kept of; static ones have none among themselves. */
    @ParameterizedTest
    @MethodSource("processors")
    void crowdsOfManySizesAreThinnedOutByLanesInAnyNumberOfWorkGroups(Device device) {
        Scene scene = Scenes.mixed(3000, 4);
        Absent workGroups = new Absent(device);
        DevicePipeline pipeline = pipeline(device, workGroups, true);
        try (Twins twins = Twins.load(scene, java(), pipeline)) {
            for (int id = 0; id < scene.size(); id++) {
                twins.set(Commands.POSITION, id, 0.15f * scene.x(id), scene.y(id));
                if (id % 10 == 0) {
                    twins.set(Commands.MASS, id, Float.POSITIVE_INFINITY, 0);
                }
            }
            for (int k = 0; k < 6; k++) {
                workGroups.most = 1 + k % device.computeUnits();
                twins.step(scene.timeStep(), 1 + k);
                twins.assertEqual("step " + k);
                twins.assertSameFigures();
                assertThat(k > 0 || pipeline.greatestContacts() > Tuning.CROWD).isTrue();
            }
            assertThat(pipeline.kernelNanos())
                    .containsKey("persistentCpu_mixedSteps")
                    .doesNotContainKey("contacts_crowd");
        }
    }

    @ParameterizedTest
    @MethodSource("processors")
    void crowdsThatAreTooCloseForLanesGoByColoursForAWhile(Device device) {
        int circles = Tuning.CROWD + 2; // 1,891 pairs: a crowd that lanes take
        DevicePipeline pipeline = Pipelines.of(device, Plans.PERSISTENT_CPU, true);
        try (Twins twins = Twins.load(Scenes.onePoint(2 * circles, 3), java(), pipeline)) {
            twins.step(1 / 60f, 3);
            twins.assertEqual("too many pairs in one group");
            assertThat(pipeline.kernelNanos()).containsKey("contacts_crowd");
            for (int id = circles; id < 2 * circles; id++) {
                twins.set(Commands.POSITION, id, 0.012f * (id - circles) + 0.1f, 0.9f);
            }
            long before = 0;
            for (int k = 0; k < 300; k++) {
                for (int id = 0; id < circles; id++) {
                    twins.set(Commands.POSITION, id, 0.5f, 0.5f);
                }
                before = k < 280 ? pipeline.kernelNanos().get("contacts_crowd") : before;
                twins.step(1 / 60f, 1);
                twins.assertEqual("fewer, step " + k);
            }
            assertThat(pipeline.kernelNanos().get("contacts_crowd")).isEqualTo(before);
        }
    }

    @ParameterizedTest
    @MethodSource("processors")
    void worldsOfHardlyAnyRowsHaveTheSameBitsOnTheDeviceAsInJava(Device device) {
        for (int circles : new int[] {1, 2, 7, 15, 40}) {
            Scene scene = Scenes.thesis(circles, 1);
            try (Twins twins = Twins.load(scene, java(), Pipelines.of(device, Plans.PERSISTENT_CPU))) {
                for (int k = 0; k < 10; k++) {
                    twins.step(scene.timeStep(), 10);
                    twins.assertEqual(circles + " circles");
                    twins.assertSameFigures();
                }
            }
        }
    }

    @ParameterizedTest
    @MethodSource("processors")
    void figuresAndReadingsAreTheSameOnTheDeviceAsInJava(Device device) {
        Scene scene = Scenes.packed(3000, 4);
        try (Twins twins = Twins.load(scene, java(), Pipelines.of(device, Plans.PERSISTENT_CPU))) {
            for (int k = 0; k < 5; k++) {
                twins.step(scene.timeStep(), 3);
                twins.assertSameFigures();
                twins.assertSameReadings();
            }
        }
    }

    @ParameterizedTest
    @MethodSource("processors")
    void stepsOfOneLevelAndOfSeveralMayTakeTurns(Device device) {
        Scene scene = Scenes.packed(3000, 5);
        DevicePipeline pipeline = Pipelines.of(device, Plans.PERSISTENT_CPU);
        try (Twins twins = Twins.load(scene, java(), pipeline)) {
            for (int k = 0; k < 8; k++) {
                // One circle that is much larger makes a second level.
                twins.set(Commands.RADIUS, 0, (k % 2 == 0 ? 1 : 5) * scene.radius(0), 0);
                twins.step(scene.timeStep(), 1 + k % 3);
                twins.assertEqual("turn " + k);
                twins.assertSameFigures();
                if (k % 3 == 0) {
                    twins.exchange();
                }
            }
        }
    }

    @ParameterizedTest
    @MethodSource("processors")
    void worldsThatStepAtTheSameTimeOnOneProcessorDoNotMindEachOther(Device device) throws Exception {
        ExecutorService threads = Executors.newFixedThreadPool(3);
        try {
            List<Callable<Void>> worlds = new ArrayList<>();
            for (int seed = 1; seed <= 3; seed++) {
                Scene scene = Scenes.packed(2000, seed);
                worlds.add(() -> {
                    try (Twins twins = Twins.load(scene, java(), Pipelines.of(device, Plans.PERSISTENT_CPU))) {
                        for (int k = 0; k < 20; k++) {
                            twins.step(scene.timeStep(), 2);
                            twins.assertEqual("step " + 2 * k);
                        }
                    }
                    return null;
                });
            }
            for (Future<Void> world : threads.invokeAll(worlds)) {
                world.get();
            }
        } finally {
            threads.shutdownNow();
        }
    }
}
