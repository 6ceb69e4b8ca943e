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
import io.github.circles2d.world.model.ContactSettings;
import io.github.circles2d.world.model.Features;
import io.github.circles2d.world.shared.Pipeline;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Tag;

/** Circles that grip and turn have the same bits on every device as in Java. */
class SurfacesAgreeTest {

    private static Pipeline[] pipelines(Device device) {
        return Pipelines.ready(device);
    }

    /** From the first surface in mid-life on, in steps of several lengths, also with fast circles. */
    @OnEachDevice
    @Tag("long")
    void scenesHaveTheSameBits(Device device) {
        Scene[] scenes = {
            Scenes.thesis(600, 1),
            Scenes.mixed(600, 1),
            Scenes.pyramid(),
            Scenes.gas(600, 1),
            Scenes.bouncy(1),
            Scenes.onePoint(200, 1),
            HardScenes.blend(500, 10, 1),
            HardScenes.blend(300, 100, 2)
        };
        for (int i = 0; i < scenes.length; i++) {
            Scene scene = scenes[i];
            boolean turnsLater = i < TestScale.of(2, scenes.length);
            Pipeline[] pipelines = turnsLater ? PipelinesAgreeTest.pipelines(device) : pipelines(device);
            try (Twins twins = Twins.load(scene, pipelines)) {
                SplittableRandom random = new SplittableRandom(5);
                twins.step(scene.timeStep(), 5);
                if (turnsLater) {
                    Pipelines.makeReady(pipelines);
                }
                twins.assertEqual(scene.name() + " before it turns");
                for (int k = 0; k < TestScale.of(6, 20); k++) {
                    for (int changes = 0; changes < 5; changes++) {
                        twins.changeSurfaces(random);
                    }
                    twins.assertEqual(scene.name() + " behind change " + k);
                    for (int step = 0; step < 4; step++) {
                        twins.step(k == 4 ? 0.2f : k == 5 ? 1 / 100f : scene.timeStep(), 1);
                        twins.assertEqual(scene.name() + " behind change " + k + ", step " + step);
                    }
                }
                twins.assertSameTurns(scene.name());
                twins.assertSameFigures();
            }
        }
    }

    /** Circles come, go, change radii and masses; walls move; states are exchanged. */
    @OnEachDevice
    @Tag("long")
    void changesHaveTheSameBits(Device device) {
        for (Scene scene : new Scene[] {Scenes.thesis(300, 3), Scenes.mixed(300, 3), HardScenes.blend(200, 10, 3)}) {
            try (Twins twins = Twins.load(scene, pipelines(device))) {
                SplittableRandom random = new SplittableRandom(7);
                for (int k = 0; k < TestScale.of(12, 40); k++) {
                    twins.changeSurfaces(random);
                    if (k == 6) {
                        twins.letChangesTurn();
                    }
                    for (int changes = 0; changes < 10; changes++) {
                        twins.change(scene, random);
                    }
                    twins.assertEqual(scene.name() + " behind change " + k);
                    if (k % 3 == 1) {
                        twins.moveWalls(random, 0.5f * scene.radius(0));
                    }
                    twins.step(k % 7 == 6 ? 0.3f : scene.timeStep(), 1 + k % 3);
                    twins.assertEqual(scene.name() + " after change " + k);
                    twins.assertSameTurns(scene.name() + " after change " + k);
                    if (k % 4 == 3) {
                        twins.exchange();
                        twins.assertEqual(scene.name() + " exchanged " + k);
                    }
                }
            }
        }
    }

    /** A world that is empty at first grows, step by step, from the room that there is at first. */
    @OnEachDevice
    @Tag("long")
    void aWorldThatGrowsHasTheSameBits(Device device) {
        Scene scene = Scenes.mixed(40, 9);
        try (Twins twins = Twins.load(scene, pipelines(device))) {
            SplittableRandom random = new SplittableRandom(1);
            twins.changeSurfaces(random);
            for (int k = 0; k < TestScale.of(12, 40); k++) {
                for (int i = 0; i < 60; i++) {
                    float x = scene.minX() + (float) random.nextDouble() * (scene.maxX() - scene.minX());
                    float y = scene.minY() + (float) random.nextDouble() * (scene.maxY() - scene.minY());
                    twins.add(x, y, scene.radius(i % scene.size()), 1 + i % 3, 0.1f * (i % 10), 0, -1);
                }
                twins.changeSurfaces(random);
                twins.step(scene.timeStep(), 2);
                twins.assertEqual("with " + twins.size() + " circles");
            }
            twins.exchange();
            twins.assertSameTurns("at the end");
        }
    }

    @OnEachDevice
    @Tag("long")
    void eventsAreTheSame(Device device) {
        for (Scene scene : new Scene[] {Scenes.thesis(300, 4), HardScenes.blend(300, 10, 4), Scenes.bouncy(2)}) {
            Pipeline[] pipelines = Pipelines.ready(device, Pipelines.INSIDE_EDGES);
            try (Twins twins = Twins.load(scene, pipelines)) {
                SplittableRandom random = new SplittableRandom(9);
                twins.report(ContactEvents.ALL);
                int events = 0;
                for (int k = 0; k < TestScale.of(8, 20); k++) {
                    if (k > 1) {
                        twins.changeSurfaces(random);
                    }
                    twins.step(scene.timeStep(), 1 + k % 3);
                    events += twins.assertSameEvents(scene.name() + ", call " + k);
                    twins.change(scene, random);
                }
                assertThat(events).as(scene.name()).isPositive();
                twins.assertEqual(scene.name());
            }
        }
    }

    @OnEachDevice
    @Tag("long")
    void edgesHaveTheSameBits(Device device) {
        Scene scene = Scenes.mixed(300, 5);
        AxisEdge[][] all = {{AxisEdge.WRAP, AxisEdge.WALL}, {AxisEdge.OPEN, AxisEdge.WRAP}};
        try (Twins twins = Twins.load(Scenes.thesis(10, 1), Pipelines.ready(device, Pipelines.INSIDE_EDGES))) {
            SplittableRandom random = new SplittableRandom(3);
            for (AxisEdge[] edges : all) {
                twins.loadInPlace(scene, edges[0], edges[1]);
                for (int k = 0; k < 8; k++) {
                    twins.changeSurfaces(random);
                    twins.step(scene.timeStep(), 2);
                    twins.assertEqual(edges[0] + " " + edges[1] + ", call " + k);
                }
            }
        }
    }

    /** Static circles turn, and belts run, under circles that lie on them. */
    @OnEachDevice
    @Tag("long")
    void staticRollersHaveTheSameBits(Device device) {
        Scene scene = HardScenes.pile(12, 12, 1);
        try (Twins twins = Twins.load(scene, pipelines(device))) {
            SplittableRandom random = new SplittableRandom(2);
            for (int id = 0; id < 30; id += 3) {
                twins.set(Commands.MASS, id, Float.POSITIVE_INFINITY, 0);
                twins.set(Commands.ANGULAR_VELOCITY, id, id - 10, 0);
            }
            for (int k = 0; k < 15; k++) {
                twins.changeSurfaces(random);
                twins.step(scene.timeStep(), 4);
                twins.assertEqual("call " + k);
            }
            twins.assertSameTurns("at the end");
        }
    }

    /** Masses, speeds, frictions and torques of any magnitude, now and then one of a few. */
    @OnEachDevice
    @Tag("long")
    void extremeCirclesHaveTheSameBits(Device device) {
        for (Scene scene : new Scene[] {Scenes.thesis(600, 6), Scenes.mixed(600, 6)}) {
            try (Twins twins = Twins.load(scene, pipelines(device))) {
                SplittableRandom random = new SplittableRandom(8);
                for (int k = 0; k < TestScale.of(6, 20); k++) {
                    twins.changeSurfaces(random);
                    for (int changes = 0; changes < 200; changes++) {
                        PipelinesAgreeTest.makeExtreme(twins, random.nextInt(scene.size()), random);
                        twins.turnExtremely(random.nextInt(scene.size()), random);
                    }
                    for (int step = 0; step < 3; step++) {
                        twins.step(scene.timeStep(), 1);
                        twins.assertEqual(scene.name() + " behind change " + k + ", step " + step);
                    }
                    twins.exchange();
                }
            }
        }
    }

    @OnEachDevice
    void onlyAWorldThatTurnsHasMemoryForIt(Device device) {
        try (Pipeline pipeline = Pipelines.of(device, Plans.COLOURS.of(device), false)) {
            long still = pipeline.bytesHeld();
            pipeline.prepare(ContactSettings.DEFAULT, Features.TURNING);
            long turning = pipeline.bytesHeld();
            // at home: angle, angular velocity, rows of walls, fields; in a step: as at home, spin and surface; by
            // contact
            assertThat(turning - still).isGreaterThan((2 * (8 + 16 + 16) + 16 + 16 + 16 + 16 + 8) * 1024);
            pipeline.prepare(ContactSettings.DEFAULT, Features.TURNING);
            assertThat(pipeline.bytesHeld()).isEqualTo(turning);
        }
    }

    /** That a world turns shows in nothing: not in bits, not in snapshots. */
    @OnEachDevice
    @Tag("long")
    void aWorldThatTurnsWithoutGripHasTheBitsOfOneThatDoesNot(Device device) {
        for (Scene scene : new Scene[] {Scenes.thesis(300, 6), Scenes.mixed(300, 6)}) {
            try (Twins still = Twins.load(scene, PipelinesAgreeTest.pipelines(device));
                    Twins turning = Twins.load(scene, pipelines(device))) {
                for (int k = 0; k < 10; k++) {
                    if (k == 3) {
                        turning.turnWithoutGrip();
                    }
                    if (k == 7) {
                        turning.exchange();
                    }
                    still.step(scene.timeStep(), 3);
                    turning.step(scene.timeStep(), 3);
                    turning.assertEqual(scene.name() + ", call " + k);
                    assertThat(turning.hash()).as(scene.name() + ", call " + k).isEqualTo(still.hash());
                }
            }
        }
    }
}
