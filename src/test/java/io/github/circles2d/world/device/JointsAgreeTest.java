package io.github.circles2d.world.device;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.circles2d.opencl.Device;
import io.github.circles2d.opencl.OnEachDevice;
import io.github.circles2d.opencl.TestScale;
import io.github.circles2d.scenes.HardScenes;
import io.github.circles2d.scenes.Scene;
import io.github.circles2d.scenes.Scenes;
import io.github.circles2d.world.circles.Commands;
import io.github.circles2d.world.device.plan.Plans;
import io.github.circles2d.world.events.ContactEvents;
import io.github.circles2d.world.model.AxisEdge;
import io.github.circles2d.world.model.Bounds;
import io.github.circles2d.world.model.ContactSettings;
import io.github.circles2d.world.model.Features;
import io.github.circles2d.world.shared.Pipeline;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Tag;

/** Circles and joints have the same bits on every device as in Java, by every plan. */
class JointsAgreeTest {

    private static Pipeline[] pipelines(Device device) {
        return Pipelines.ready(device);
    }

    private static JointTwins joints(Scene scene) {
        Bounds bounds = new Bounds(scene.minX(), scene.minY(), scene.maxX(), scene.maxY());
        return new JointTwins(bounds, scene.radius(0));
    }

    /** Joints of every form, few and many: alone, in batches, in large components, and more of a circle than there are colours. */
    @OnEachDevice
    @Tag("long")
    void jointsHaveTheSameBits(Device device) {
        Scene[] scenes = {Scenes.thesis(400, 1), Scenes.mixed(400, 1), Scenes.gas(300, 1), HardScenes.blend(300, 10, 1)
        };
        for (Scene scene : scenes) {
            JointTwins joints = joints(scene);
            SplittableRandom random = new SplittableRandom(3);
            int circles = scene.size();
            int split = 0;
            int batches = 0;
            int inNoBatch = 0;
            int pushing = 0;
            try (Twins twins = Twins.load(scene, joints.on(pipelines(device)))) {
                for (int id = 0; id < 5; id++) {
                    twins.set(Commands.MASS, id, Float.POSITIVE_INFINITY, 0);
                }
                for (int k = 0; k < TestScale.of(8, 30); k++) {
                    if (k == 2) {
                        twins.letChangesTurn();
                        twins.changeSurfaces(random);
                        joints.turning = true;
                    }
                    joints.batch = k % 3 == 0 ? 12 : 512;
                    joints.make(k == 1 ? 1 : 60 * k, circles, k % 2 == 0 ? 0 : 2, random);
                    split += joints.split();
                    batches += joints.batches();
                    inNoBatch += joints.inNoBatch();
                    for (int step = 0; step < 4; step++) {
                        joints.moveAnchors(random);
                        String when = scene.name() + " behind change " + k + ", step " + step;
                        twins.step(k == 5 ? 0.1f : scene.timeStep(), 1 + step % 2);
                        twins.assertEqual(when);
                        pushing += joints.assertSameStates(when);
                        joints.assertSameBroken(when, circles);
                    }
                    twins.assertSameFigures();
                }
            }
            assertThat(split).as(scene.name()).isPositive();
            assertThat(batches).as(scene.name()).isPositive();
            assertThat(inNoBatch).as(scene.name()).isPositive();
            assertThat(pushing).as(scene.name()).isPositive();
        }
    }

    /** In the middle of steps that are enqueued together; then their circles may collide. */
    @OnEachDevice
    void jointsBreakInTheSameSteps(Device device) {
        for (Scene scene : new Scene[] {Scenes.thesis(300, 3), Scenes.mixed(300, 3)}) {
            JointTwins joints = joints(scene);
            SplittableRandom random = new SplittableRandom(5);
            int broken = 0;
            try (Twins twins = Twins.load(scene, joints.on(pipelines(device)))) {
                for (int k = 0; k < TestScale.of(6, 20); k++) {
                    joints.fragile = k % 2 == 1;
                    joints.make(200, scene.size(), 3, random);
                    twins.step(scene.timeStep(), 5);
                    String when = scene.name() + " behind change " + k;
                    twins.assertEqual(when);
                    joints.assertSameStates(when);
                    if (k % 3 == 2) {
                        twins.step(scene.timeStep(), 3);
                        twins.assertEqual(when);
                    }
                    broken += joints.assertSameBroken(when, scene.size());
                }
            }
            assertThat(broken).as(scene.name()).isPositive();
        }
    }

    @OnEachDevice
    @Tag("long")
    void edgesHaveTheSameBits(Device device) {
        Scene scene = Scenes.mixed(300, 5);
        AxisEdge[][] all = {{AxisEdge.WRAP, AxisEdge.WALL}, {AxisEdge.OPEN, AxisEdge.WRAP}};
        JointTwins joints = joints(scene);
        SplittableRandom random = new SplittableRandom(3);
        Pipeline[] pipelines = Pipelines.ready(device, Pipelines.INSIDE_EDGES);
        try (Twins twins = Twins.load(Scenes.thesis(10, 1), joints.on(pipelines))) {
            for (AxisEdge[] edges : all) {
                twins.loadInPlace(scene, edges[0], edges[1]);
                for (int k = 0; k < 6; k++) {
                    joints.make(200, scene.size(), 4, random);
                    for (int step = 0; step < 5; step++) {
                        twins.step(scene.timeStep(), 1);
                        String when = edges[0] + " " + edges[1] + ", call " + k + ", step " + step;
                        twins.assertEqual(when);
                        joints.assertSameStates(when);
                        joints.assertSameBroken(when, scene.size());
                    }
                }
            }
        }
    }

    /** Masses, speeds, radii, frictions and torques of any magnitude, also in crowds. */
    @OnEachDevice
    @Tag("long")
    void extremeCirclesHaveTheSameBits(Device device) {
        for (Scene scene : new Scene[] {Scenes.thesis(300, 6), Scenes.onePoint(200, 6)}) {
            JointTwins joints = joints(scene);
            SplittableRandom random = new SplittableRandom(8);
            try (Twins twins = Twins.load(scene, joints.on(pipelines(device)))) {
                twins.letChangesTurn();
                for (int k = 0; k < TestScale.of(8, 20); k++) {
                    twins.changeSurfaces(random);
                    joints.turning = true;
                    joints.make(200, scene.size(), 3, random);
                    for (int changes = 0; changes < 60; changes++) {
                        PipelinesAgreeTest.makeExtreme(twins, random.nextInt(scene.size()), random);
                        twins.turnExtremely(random.nextInt(scene.size()), random);
                    }
                    for (int step = 0; step < 3; step++) {
                        twins.step(scene.timeStep(), 1);
                        String when = scene.name() + " behind change " + k + ", step " + step;
                        twins.assertEqual(when);
                        joints.assertSameStates(when);
                        joints.assertSameBroken(when, scene.size());
                    }
                }
            }
        }
    }

    /** Worlds that report have kernels of their own. */
    @OnEachDevice
    @Tag("long")
    void eventsAreTheSame(Device device) {
        for (Scene scene : new Scene[] {Scenes.thesis(300, 4), Scenes.mixed(300, 4)}) {
            JointTwins joints = joints(scene);
            SplittableRandom random = new SplittableRandom(9);
            Pipeline[] pipelines = Pipelines.ready(device, Pipelines.INSIDE_EDGES);
            try (Twins twins = Twins.load(scene, joints.on(pipelines))) {
                twins.report(ContactEvents.ALL);
                int events = 0;
                for (int k = 0; k < TestScale.of(8, 20); k++) {
                    joints.make(150, scene.size(), 3, random);
                    if (k > 4) {
                        twins.letChangesTurn();
                        twins.changeSurfaces(random);
                        joints.turning = true;
                    }
                    twins.step(scene.timeStep(), 1 + k % 3);
                    String when = scene.name() + ", call " + k;
                    events += twins.assertSameEvents(when);
                    twins.assertEqual(when);
                    joints.assertSameBroken(when, scene.size());
                }
                assertThat(events).as(scene.name()).isPositive();
            }
        }
    }

    /** Joints are made by calls, in mid-life, also on bodies that move; states are exchanged, and restored into worlds without joints. */
    @OnEachDevice
    @Tag("long")
    void callsHaveTheSameBits(Device device) {
        for (Scene scene : new Scene[] {Scenes.thesis(200, 5), Scenes.mixed(200, 5)}) {
            SplittableRandom random = new SplittableRandom(11);
            Pipeline[] pipelines = PipelinesAgreeTest.pipelines(device);
            try (Twins twins = Twins.load(scene, pipelines)) {
                twins.step(scene.timeStep(), 3);
                Pipelines.makeReady(pipelines);
                int most = 0;
                for (int k = 0; k < TestScale.of(30, 100); k++) {
                    if (k == 12) {
                        twins.letChangesTurn();
                    }
                    for (int changes = 0; changes < 12; changes++) {
                        twins.changeJoints(random);
                    }
                    if (k > 4) {
                        twins.changeTerrain(random);
                    }
                    if (k > 15) {
                        twins.change(scene, random);
                    }
                    twins.assertEqual(scene.name() + " behind change " + k);
                    twins.step(k % 7 == 6 ? 0.1f : scene.timeStep(), 1 + k % 3);
                    twins.assertEqual(scene.name() + " after change " + k);
                    if (k % 5 == 4) {
                        twins.exchange();
                        twins.assertEqual(scene.name() + " exchanged " + k);
                    }
                    most = Math.max(most, twins.joints());
                }
                assertThat(most).as(scene.name()).isGreaterThan(30);
                twins.assertGoOnIn(scene, pipelines(device));
            }
        }
    }

    @OnEachDevice
    @Tag("long")
    void onlyAWorldWithJointsHasMemoryForThem(Device device) {
        try (Pipeline pipeline = Pipelines.of(device, Plans.COLOURS.of(device), false)) {
            long none = pipeline.bytesHeld();
            pipeline.prepare(ContactSettings.DEFAULT, Features.JOINTS);
            long some = pipeline.bytesHeld();
            assertThat(some).isGreaterThan(none);
            pipeline.prepare(ContactSettings.DEFAULT, Pipelines.INSIDE);
            assertThat(pipeline.bytesHeld()).isGreaterThan(some);
            long both = pipeline.bytesHeld();
            pipeline.prepare(ContactSettings.DEFAULT, Pipelines.INSIDE);
            assertThat(pipeline.bytesHeld()).isEqualTo(both);
        }
    }
}
