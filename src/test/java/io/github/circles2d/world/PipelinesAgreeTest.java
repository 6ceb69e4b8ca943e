package io.github.circles2d.world;

import io.github.circles2d.opencl.Device;
import io.github.circles2d.opencl.TestDevices;
import io.github.circles2d.scenes.Scene;
import io.github.circles2d.scenes.Scenes;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Every plan of the OpenCL pipeline has the same bits as the pipeline in Java, on every device. */
class PipelinesAgreeTest {
    static Iterable<Device> devices() {
        return TestDevices.all();
    }

    /** The pipeline in Java, and one for each plan that a device can follow. */
    private static Pipeline[] pipelines(Device device) {
        List<Pipeline> pipelines = new ArrayList<>();
        pipelines.add(new JvmPipeline(1, JvmPipeline.LEAST_SHARE, 0, false));
        pipelines.add(new ClPipeline(device, 0, false, ClPlan.COLOURS));
        if (ClTiles.fit(device)) {
            pipelines.add(new ClPipeline(device, 0, false, ClPlan.TILES));
        }
        if (ClResident.fits(device)) {
            pipelines.add(new ClPipeline(device, 0, false, ClPlan.RESIDENT));
        }
        if (ClLanes.fits(device)) {
            pipelines.add(new ClPipeline(device, 0, false, ClPlan.LANES));
        }
        return pipelines.toArray(Pipeline[]::new);
    }

    private static void compare(Device device, Scene scene, int rounds, int steps, float dt) {
        try (Twins twins = Twins.load(scene, pipelines(device))) {
            for (int k = 0; k < rounds; k++) {
                twins.step(dt, steps);
                twins.assertEqual(scene.name() + " after " + steps * (k + 1) + " steps");
            }
        }
    }

    @ParameterizedTest
    @MethodSource("devices")
    void scenesHaveTheSameBitsOnTheDeviceAsInJava(Device device) {
        compare(device, Scenes.thesis(1250, 1), 20, 5, 1 / 60f);
        compare(device, Scenes.packed(5000, 1), 6, 5, 1 / 60f);
        compare(device, Scenes.gas(1250, 1), 20, 5, 1 / 60f);
        compare(device, Scenes.pyramid(), 20, 5, 1 / 60f);
        compare(device, Scenes.mixed(1250, 1), 20, 5, 1 / 60f);
        compare(device, Scenes.barrel(1), 3, 10, Scenes.barrel(1).timeStep());
        compare(device, Scenes.noCollide(), 20, 5, Scenes.noCollide().timeStep());
    }

    @ParameterizedTest
    @MethodSource("devices")
    void fixedCirclesThatMoveAndStopHaveTheSameBitsOnTheDeviceAsInJava(Device device) {
        Scene scene = Scenes.thesis(300, 4);
        try (Twins twins = Twins.load(scene, pipelines(device))) {
            for (int id = 0; id < 20; id++) {
                twins.commands().set(Commands.MASS, id, Float.POSITIVE_INFINITY, 0);
                twins.commands().set(Commands.VELOCITY, id, 0.3f - 0.03f * id, 0.5f);
            }
            for (int k = 0; k < 30; k++) {
                twins.step(1 / 60f, 5);
                twins.assertEqual("after " + 5 * (k + 1) + " steps");
            }
        }
    }

    @ParameterizedTest
    @MethodSource("devices")
    void theSizeOfWorkGroupsDoesNotShow(Device device) {
        for (int size : new int[] {1, 3, 32, 256}) {
            Pipeline other = new ClPipeline(device, 0, false, ClPlan.COLOURS).workGroupSize(size);
            Pipeline java = new JvmPipeline(1, JvmPipeline.LEAST_SHARE, 0, false);
            try (Twins twins = Twins.load(Scenes.mixed(600, 3), java, other)) {
                for (int k = 0; k < 10; k++) {
                    twins.step(1 / 60f, 5);
                    twins.assertEqual(size + " work-items a work-group, " + 5 * (k + 1) + " steps");
                }
            }
        }
    }

    @ParameterizedTest
    @MethodSource("devices")
    void fastCirclesHaveTheSameBitsOnTheDeviceAsInJava(Device device) {
        compare(device, Scenes.billiards(1000), 20, 3, Scenes.billiards(1000).timeStep());
        compare(device, Scenes.gas(1250, 2), 6, 3, 1f);
        compare(device, Scenes.mixed(1250, 2), 6, 3, 1f);
        compare(device, Scenes.bouncy(1), 6, 3, 1f);
    }

    @ParameterizedTest
    @MethodSource("devices")
    void crowdsHaveTheSameBitsOnTheDeviceAsInJava(Device device) {
        compare(device, Scenes.onePoint(300, 1), 10, 3, 1 / 60f);
        compare(device, Scenes.onePoint(2000, 1), 3, 1, 1 / 60f);
        compare(device, Scenes.oneCell(1250, 1), 10, 3, 1 / 60f);
    }

    @ParameterizedTest
    @MethodSource("devices")
    void changesHaveTheSameEffectOnTheDeviceAsInJava(Device device) {
        for (Scene scene : new Scene[] {Scenes.thesis(1250, 3), Scenes.mixed(1250, 3), Scenes.gas(1250, 3)}) {
            try (Twins twins = Twins.load(scene, pipelines(device))) {
                SplittableRandom random = new SplittableRandom(7);
                for (int k = 0; k < 40; k++) {
                    twins.step(scene.timeStep(), 2);
                    twins.assertEqual(scene.name() + " after change " + k);
                    for (int changes = 0; changes < 5; changes++) {
                        twins.change(scene, random);
                    }
                    if (k % 10 == 0) {
                        twins.confine();
                        twins.assertSameReadings();
                    }
                }
            }
        }
    }

    @ParameterizedTest
    @MethodSource("devices")
    void aStateSavedOnOneGoesOnTheSameOnAnother(Device device) {
        for (Scene scene : new Scene[] {Scenes.thesis(1250, 5), Scenes.mixed(1250, 5)}) {
            try (Twins twins = Twins.load(scene, pipelines(device))) {
                SplittableRandom random = new SplittableRandom(7);
                for (int k = 0; k < 20; k++) {
                    twins.step(scene.timeStep(), 1 + k % 3);
                    twins.change(scene, random);
                    twins.exchange();
                    twins.assertEqual(scene.name() + " after exchange " + k);
                }
            }
        }
    }

    @ParameterizedTest
    @MethodSource("devices")
    void figuresOfTheLastStepAreTheSameOnTheDeviceAsInJava(Device device) {
        Scene scene = Scenes.mixed(1250, 4);
        try (Twins twins = Twins.load(scene, pipelines(device))) {
            SplittableRandom random = new SplittableRandom(7);
            for (int k = 0; k < 5; k++) {
                twins.step(scene.timeStep(), 3);
                for (int changes = 0; changes < 2000; changes++) {
                    twins.change(scene, random);
                }
                twins.assertSameFigures();
                twins.apply();
                twins.assertSameFigures();
            }
        }
    }
}
