package io.github.circles2d.world.device;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.circles2d.opencl.Device;
import io.github.circles2d.opencl.OnEachDevice;
import io.github.circles2d.opencl.TestScale;
import io.github.circles2d.scenes.HardScenes;
import io.github.circles2d.scenes.Scene;
import io.github.circles2d.scenes.Scenes;
import io.github.circles2d.world.Simulation;
import io.github.circles2d.world.circles.Commands;
import io.github.circles2d.world.circles.WorldParameters;
import io.github.circles2d.world.device.plan.Plans;
import io.github.circles2d.world.jvm.JvmPipeline;
import io.github.circles2d.world.model.Bounds;
import io.github.circles2d.world.model.ContactSettings;
import io.github.circles2d.world.model.Features;
import io.github.circles2d.world.shared.Pipeline;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Tag;

/** Every plan of the OpenCL pipeline has the same bits as the pipeline in Java, on every device. */
class PipelinesAgreeTest {

    /** The pipeline in Java, and one for each plan that a device can follow. */
    static Pipeline[] pipelines(Device device) {
        return Pipelines.all(device, Features.NONE);
    }

    private static void compare(Device device, Scene scene, int rounds, int steps, float dt) {
        try (Twins twins = Twins.load(scene, pipelines(device))) {
            for (int k = 0; k < rounds; k++) {
                twins.step(dt, steps);
                twins.assertEqual(scene.name() + " after " + steps * (k + 1) + " steps");
            }
        }
    }

    @OnEachDevice
    @Tag("each-jdk")
    void scenesHaveTheSameBitsOnTheDeviceAsInJava(Device device) {
        int rounds = TestScale.of(4, 20);
        int roundsOfLarge = TestScale.of(1, 3);
        compare(device, Scenes.thesis(1250, 1), rounds, 5, 1 / 60f);
        compare(device, Scenes.packed(5000, 1), 2 * roundsOfLarge, 5, 1 / 60f);
        compare(device, Scenes.gas(1250, 1), rounds, 5, 1 / 60f);
        compare(device, Scenes.pyramid(), rounds, 5, 1 / 60f);
        compare(device, Scenes.mixed(1250, 1), rounds, 5, 1 / 60f);
        compare(device, Scenes.barrel(1), roundsOfLarge, 10, Scenes.barrel(1).timeStep());
        compare(device, Scenes.noCollide(), rounds, 5, Scenes.noCollide().timeStep());
    }

    @OnEachDevice
    @Tag("long")
    void staticCirclesThatMoveAndStopHaveTheSameBitsOnTheDeviceAsInJava(Device device) {
        Scene scene = Scenes.thesis(300, 4);
        try (Twins twins = Twins.load(scene, pipelines(device))) {
            for (int id = 0; id < 20; id++) {
                twins.set(Commands.MASS, id, Float.POSITIVE_INFINITY, 0);
                twins.set(Commands.VELOCITY, id, 0.3f - 0.03f * id, 0.5f);
            }
            for (int k = 0; k < 30; k++) {
                twins.step(1 / 60f, 5);
                twins.assertEqual("after " + 5 * (k + 1) + " steps");
            }
        }
    }

    @OnEachDevice
    @Tag("long")
    void theSizeOfWorkGroupsDoesNotShow(Device device) {
        compareSizesOfWorkGroups(device, 3);
    }

    @OnEachDevice
    @Tag("exhaustive")
    void otherSizesOfWorkGroupsDoNotShow(Device device) {
        compareSizesOfWorkGroups(device, 1, 32, 256);
    }

    /** A driver may compile every kernel anew for each size. */
    private static void compareSizesOfWorkGroups(Device device, int... sizes) {
        for (int size : sizes) {
            Pipeline other = new DevicePipeline(device, 0, false, Plans.COLOURS.of(device), size, true);
            Pipeline java = new JvmPipeline(1, JvmPipeline.LEAST_SHARE, 0, false);
            try (Twins twins = Twins.load(Scenes.mixed(600, 3), java, other)) {
                for (int k = 0; k < 10; k++) {
                    twins.step(1 / 60f, 5);
                    twins.assertEqual(size + " work-items a work-group, " + 5 * (k + 1) + " steps");
                }
            }
        }
    }

    @OnEachDevice
    @Tag("long")
    void fastCirclesHaveTheSameBitsOnTheDeviceAsInJava(Device device) {
        compare(
                device,
                Scenes.billiards(1000),
                TestScale.of(7, 20),
                3,
                Scenes.billiards(1000).timeStep());
        compare(device, Scenes.gas(1250, 2), 6, 3, 1f);
        compare(device, Scenes.mixed(1250, 2), 6, 3, 1f);
        compare(device, Scenes.bouncy(1), 6, 3, 1f);
    }

    @OnEachDevice
    @Tag("long")
    void circlesOfSeveralKindsHaveTheSameBitsOnTheDeviceAsInJava(Device device) {
        Scene[] scenes = {
            Scenes.thesis(1250, 2),
            Scenes.mixed(600, 2),
            Scenes.onePoint(200, 2),
            HardScenes.squeezed(28, 2),
            Scenes.billiards(200)
        };
        for (int i = 0; i < scenes.length; i++) {
            Scene scene = scenes[i];
            boolean moves = i % 2 == 1;
            Features features = moves ? Pipelines.INSIDE : Features.NONE;
            try (Twins twins = Twins.load(scene, Pipelines.all(device, features))) {
                twins.step(scene.timeStep(), 3);
                twins.giveKinds();
                if (moves || TestScale.EXHAUSTIVE) {
                    twins.giveMotions();
                }
                for (int k = 0; k < 6; k++) {
                    twins.step(k % 3 == 2 ? 0.5f : scene.timeStep(), 3);
                    twins.assertEqual(scene.name() + " with kinds, round " + k);
                    twins.assertSameFigures();
                }
                twins.exchange();
                twins.step(scene.timeStep(), 3);
                twins.assertEqual(scene.name() + " restored");
            }
        }
    }

    @OnEachDevice
    @Tag("long")
    void crowdsHaveTheSameBitsOnTheDeviceAsInJava(Device device) {
        compare(device, Scenes.onePoint(300, 1), 10, 3, 1 / 60f);
        compare(device, Scenes.onePoint(2000, 1), 3, 1, 1 / 60f);
        compare(device, HardScenes.squeezed(35, 1), 10, 3, 1 / 60f);
        compare(device, Scenes.oneCell(1250, 1), 10, 3, 1 / 60f);
    }

    @OnEachDevice
    @Tag("long")
    void extremeCirclesOfOneSizeHaveTheSameBitsOnTheDeviceAsInJava(Device device) {
        for (int subSteps : TestScale.EXHAUSTIVE ? new int[] {1, 4, 5} : new int[] {1, 5}) {
            Scene scene = Scenes.thesis(1250, 6);
            try (Twins twins = Twins.load(scene, subSteps, pipelines(device))) {
                SplittableRandom random = new SplittableRandom(subSteps);
                for (int k = 0; k < TestScale.of(4, 12); k++) {
                    for (int changes = 0; changes < 400; changes++) {
                        makeExtreme(twins, random.nextInt(scene.size()), random);
                    }
                    for (int steps = 0; steps < 3; steps++) {
                        twins.step(1 / 60f, 1);
                        twins.assertEqual(subSteps + " sub-steps, change " + k + ", step " + steps);
                    }
                }
            }
        }
    }

    @OnEachDevice
    void stepsThatNobodyLooksAtInBetweenHaveTheSameBitsOnTheDeviceAsInJava(Device device) {
        // Among them such as are refused at first, and such as those behind them find other circumstances than.
        for (Scene scene : new Scene[] {Scenes.thesis(600, 6), Scenes.mixed(600, 6), Scenes.onePoint(200, 6)}) {
            try (Twins twins = Twins.load(scene, pipelines(device))) {
                SplittableRandom random = new SplittableRandom(7);
                for (int k = 0; k < TestScale.of(20, 70); k++) {
                    twins.step(1 / 60f, 1);
                }
                twins.assertEqual(scene.name() + " after many steps");
                for (float dt : new float[] {1 / 60f, 1 / 120f, 1 / 120f, 1 / 240f, 0.5f, 0.5f, 1 / 60f, 1 / 60f}) {
                    twins.step(dt, 2);
                    twins.step(dt, 1);
                    if (dt == 0.5f) {
                        twins.change(scene, random);
                    }
                }
                twins.assertEqual(scene.name() + " after steps of several lengths");
                for (int subSteps : new int[] {2, 4}) {
                    twins.restoreWithSubSteps(subSteps);
                    twins.step(1 / 60f, 1);
                }
                twins.assertEqual(scene.name() + " after steps of several sub-steps");
                twins.assertSameFigures();
            }
        }
    }

    /** Asks for a mass and a speed of any magnitude, and for a place in the world, now and then one of a few. */
    static void makeExtreme(Twins twins, int id, SplittableRandom random) {
        float mass = random.nextInt(16) == 0 ? Float.POSITIVE_INFINITY : power(random, -9, 9);
        twins.set(Commands.MASS, id, mass, 0);
        twins.set(Commands.RESTITUTION, id, random.nextInt(3) / 2f, 0);
        float speed = power(random, -6, random.nextInt(8) == 0 ? 6 : 0);
        twins.set(Commands.VELOCITY, id, (random.nextInt(3) - 1) * speed, (random.nextInt(3) - 1) * speed);
        if (random.nextInt(8) == 0) {
            twins.move(id, random.nextInt(8) / 8f, random.nextInt(8) / 8f);
        }
    }

    static float power(SplittableRandom random, double least, double greatest) {
        return (float) Math.pow(10, least + random.nextDouble() * (greatest - least));
    }

    @OnEachDevice
    @Tag("long")
    void changesHaveTheSameEffectOnTheDeviceAsInJava(Device device) {
        for (Scene scene : new Scene[] {Scenes.thesis(1250, 3), Scenes.mixed(1250, 3), Scenes.gas(1250, 3)}) {
            try (Twins twins = Twins.load(scene, pipelines(device))) {
                SplittableRandom random = new SplittableRandom(7);
                for (int k = 0; k < TestScale.of(11, 40); k++) {
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

    @OnEachDevice
    @Tag("long")
    void wallsThatMovePushTheSameOnTheDeviceAsInJava(Device device) {
        // By up to about the largest radius: some circles are pushed, others brought inside.
        for (Scene scene : new Scene[] {Scenes.thesis(1250, 3), Scenes.mixed(1250, 3), Scenes.gas(1250, 3)}) {
            try (Twins twins = Twins.load(scene, pipelines(device))) {
                SplittableRandom random = new SplittableRandom(11);
                for (int k = 0; k < TestScale.of(12, 40); k++) {
                    twins.moveWalls(random, 1.5f * scene.radius(0));
                    if (k % 10 == 9) {
                        twins.exchange();
                    }
                    twins.step(scene.timeStep(), 1 + k % 3);
                    twins.assertEqual(scene.name() + " after move " + k);
                }
            }
        }
    }

    @OnEachDevice
    @Tag("long")
    void contactsOfAnySettingsHaveTheSameBitsOnTheDeviceAsInJava(Device device) {
        ContactSettings[] settings = {
            new ContactSettings(0f, 30f, 5f, 3f), new ContactSettings(0.05f, 67f, 20f, 0.1f), ContactSettings.DEFAULT
        };
        for (Scene scene : new Scene[] {Scenes.thesis(1250, 3), Scenes.mixed(1250, 3)}) {
            try (Twins twins = Twins.load(scene, pipelines(device))) {
                for (ContactSettings each : settings) {
                    twins.step(scene.timeStep(), 30);
                    twins.restoreWith(each);
                    for (int k = 0; k < 6; k++) {
                        twins.step(scene.timeStep(), 5);
                        twins.assertEqual(scene.name() + " with " + each);
                    }
                    twins.exchange();
                }
            }
        }
    }

    @OnEachDevice
    @Tag("long")
    void positionsRequestedAreThoseOfTheRequestWhateverIsDoneBehindIt(Device device) {
        // With steps that are refused at first, before requests and behind them: no room yet, a crowd, fast circles.
        for (Scene scene : new Scene[] {Scenes.thesis(600, 8), Scenes.mixed(600, 8), Scenes.onePoint(200, 8)}) {
            try (Twins twins = Twins.load(scene, pipelines(device))) {
                SplittableRandom random = new SplittableRandom(9);
                twins.requestPositions();
                twins.assertSameRequestedPositions();
                for (int k = 0; k < TestScale.of(21, 80); k++) {
                    float dt = k % 20 == 19 ? 0.5f : 1 / 60f;
                    twins.step(dt, 1 + k % 3);
                    if (k % 7 == 0) {
                        twins.requestPositions();
                        twins.step(dt, 2);
                    }
                    twins.requestPositions();
                    twins.step(k % 20 == 10 ? 0.5f : dt, 1);
                    for (int changes = 0; changes < k % 4; changes++) {
                        twins.change(scene, random);
                    }
                    if (k % 9 == 8) {
                        twins.exchange();
                    }
                    twins.assertSameRequestedPositions();
                }
                twins.assertEqual(scene.name());
            }
        }
    }

    @OnEachDevice
    @Tag("long")
    void aStateSavedOnOneGoesOnTheSameOnAnother(Device device) {
        for (Scene scene : new Scene[] {Scenes.thesis(1250, 5), Scenes.mixed(1250, 5)}) {
            try (Twins twins = Twins.load(scene, pipelines(device))) {
                SplittableRandom random = new SplittableRandom(7);
                for (int k = 0; k < TestScale.of(8, 20); k++) {
                    twins.step(scene.timeStep(), 1 + k % 3);
                    twins.change(scene, random);
                    twins.exchange();
                    twins.assertEqual(scene.name() + " after exchange " + k);
                }
            }
        }
    }

    @OnEachDevice
    @Tag("long")
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
                twins.assertEqual("with all changes");
                twins.assertSameFigures();
            }
        }
    }

    /** The next request would arrive where none has been. */
    @OnEachDevice
    void aDeviceIsLeftOnceOneRequestHasBeenTaken(Device device) {
        DevicePipeline pipeline = Pipelines.of(device, Plans.COLOURS.of(device), false);
        WorldParameters parameters = new WorldParameters(new Bounds(0, 0, 9, 9), 0, -10, 0, 4, 0);
        try (Simulation simulation = new Simulation(pipeline, parameters)) {
            simulation.newCircles.add(4, 5, 1, 1, 0, 0, 0);
            simulation.readings.requestPositions();
            assertThat(simulation.readings.takePositions().get(1)).isEqualTo(5);
            pipeline.leave();
            simulation.step(1 / 60f, 1);
            assertThat(simulation.circles.size()).isOne();
        }
    }
}
