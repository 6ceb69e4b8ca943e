package io.github.circles2d.world.device;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.circles2d.opencl.Device;
import io.github.circles2d.opencl.OnEachDevice;
import io.github.circles2d.opencl.TestScale;
import io.github.circles2d.scenes.HardScenes;
import io.github.circles2d.scenes.Scene;
import io.github.circles2d.scenes.Scenes;
import io.github.circles2d.world.device.plan.Plans;
import io.github.circles2d.world.events.ContactEvents;
import io.github.circles2d.world.model.AxisEdge;
import io.github.circles2d.world.model.Bounds;
import io.github.circles2d.world.model.ContactSettings;
import io.github.circles2d.world.model.Features;
import io.github.circles2d.world.shared.Pipeline;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Tag;

/** Circles and pieces of terrain have the same bits on every device as in Java, by every plan. */
class TerrainAgreeTest {

    private static Pipeline[] pipelines(Device device) {
        return Pipelines.ready(device);
    }

    private static TerrainTwins terrain(Scene scene) {
        Bounds bounds = new Bounds(scene.minX(), scene.minY(), scene.maxX(), scene.maxY());
        return new TerrainTwins(bounds, 0.2f * (scene.maxX() - scene.minX()));
    }

    /** Random pieces at rest, in scenes of every sort. */
    @OnEachDevice
    @Tag("long")
    void piecesAtRestHaveTheSameBits(Device device) {
        compare(device, false, Scenes.thesis(600, 1), Scenes.mixed(600, 1), Scenes.gas(600, 1), Scenes.bouncy(1));
    }

    @OnEachDevice
    @Tag("long")
    void piecesThatMoveHaveTheSameBits(Device device) {
        compare(device, true, Scenes.thesis(600, 2), HardScenes.blend(500, 10, 1), Scenes.gas(600, 2));
    }

    private static void compare(Device device, boolean moving, Scene... scenes) {
        for (Scene scene : scenes) {
            TerrainTwins terrain = terrain(scene);
            SplittableRandom random = new SplittableRandom(3);
            try (Twins twins = Twins.load(scene, terrain.on(pipelines(device)))) {
                int contacts = 0;
                for (int k = 0; k < TestScale.of(8, 30); k++) {
                    terrain.make(k % 4 == 3 ? 3 : 20 + k, moving, random);
                    for (int step = 0; step < 6; step++) {
                        twins.step(k == 5 ? 0.2f : scene.timeStep(), moving ? 1 : 1 + step % 2);
                        String when = scene.name() + " behind change " + k + ", step " + step;
                        twins.assertEqual(when);
                        contacts += terrain.assertSameContacts(when);
                        if (moving) {
                            terrain.move(random);
                        }
                    }
                }
                assertThat(contacts).as(scene.name()).isPositive();
            }
        }
    }

    /** Surfaces, kinds and circles change beside pieces; walls move. */
    @OnEachDevice
    void changesHaveTheSameBits(Device device) {
        for (Scene scene : new Scene[] {Scenes.thesis(300, 3), Scenes.mixed(300, 3)}) {
            TerrainTwins terrain = terrain(scene);
            SplittableRandom random = new SplittableRandom(7);
            try (Twins twins = Twins.load(scene, terrain.on(pipelines(device)))) {
                for (int k = 0; k < TestScale.of(16, 60); k++) {
                    if (k % 4 == 0) {
                        terrain.make(25, k >= 8, random);
                    }
                    if (k > 4) {
                        twins.letChangesTurn();
                        twins.changeSurfaces(random);
                    }
                    for (int changes = 0; changes < 5; changes++) {
                        twins.change(scene, random);
                    }
                    if (k % 3 == 1) {
                        twins.moveWalls(random, 0.5f * scene.radius(0));
                    }
                    for (int step = 0; step < 3; step++) {
                        twins.step(k % 7 == 6 ? 0.3f : scene.timeStep(), k % 3 == 1 ? 1 : 2);
                        twins.assertEqual(scene.name() + " after change " + k + ", step " + step);
                        terrain.assertSameContacts(scene.name() + " after change " + k + ", step " + step);
                    }
                    twins.assertSameTurns(scene.name() + " after change " + k);
                }
            }
        }
    }

    /** Terrain is made by calls, in mid-life; states are exchanged, and restored into worlds without terrain. */
    @OnEachDevice
    @Tag("long")
    void callsHaveTheSameBits(Device device) {
        Scene[] scenes = {Scenes.thesis(300, 5), Scenes.mixed(300, 5), HardScenes.blend(200, 10, 3)};
        for (Scene scene : scenes) {
            SplittableRandom random = new SplittableRandom(11);
            Pipeline[] pipelines = PipelinesAgreeTest.pipelines(device);
            try (Twins twins = Twins.load(scene, pipelines)) {
                twins.step(scene.timeStep(), 3);
                Pipelines.makeReady(pipelines);
                for (int k = 0; k < TestScale.of(30, 100); k++) {
                    for (int changes = 0; changes < 8; changes++) {
                        twins.changeTerrain(random);
                    }
                    if (k > 10) {
                        twins.changeSurfaces(random);
                        twins.change(scene, random);
                    }
                    twins.assertEqual(scene.name() + " behind change " + k);
                    twins.step(k % 7 == 6 ? 0.1f : scene.timeStep(), 1 + k % 3);
                    twins.assertEqual(scene.name() + " after change " + k);
                    if (k % 5 == 4) {
                        twins.exchange();
                        twins.assertEqual(scene.name() + " exchanged " + k);
                    }
                }
                assertThat(twins.pieces()).as(scene.name()).isPositive();
                twins.assertGoOnIn(scene, pipelines(device));
            }
        }
    }

    @OnEachDevice
    @Tag("long")
    void edgesHaveTheSameBits(Device device) {
        Scene scene = Scenes.mixed(300, 5);
        AxisEdge[][] all = {{AxisEdge.WRAP, AxisEdge.WALL}, {AxisEdge.OPEN, AxisEdge.WRAP}};
        TerrainTwins terrain = terrain(scene);
        SplittableRandom random = new SplittableRandom(3);
        Pipeline[] pipelines = Pipelines.ready(device, Pipelines.INSIDE_EDGES);
        try (Twins twins = Twins.load(Scenes.thesis(10, 1), terrain.on(pipelines))) {
            for (AxisEdge[] edges : all) {
                twins.loadInPlace(scene, edges[0], edges[1]);
                for (int k = 0; k < 10; k++) {
                    terrain.make(25, k >= 5, random);
                    for (int step = 0; step < 5; step++) {
                        twins.step(scene.timeStep(), 1);
                        twins.assertEqual(edges[0] + " " + edges[1] + ", call " + k + ", step " + step);
                    }
                }
            }
        }
    }

    /** Masses, speeds, radii, frictions and torques of any magnitude, also in crowds, beside pieces at rest and such as move. */
    @OnEachDevice
    @Tag("long")
    void extremeCirclesHaveTheSameBits(Device device) {
        for (Scene scene : new Scene[] {Scenes.thesis(300, 6), Scenes.onePoint(200, 6)}) {
            TerrainTwins terrain = terrain(scene);
            SplittableRandom random = new SplittableRandom(8);
            try (Twins twins = Twins.load(scene, terrain.on(pipelines(device)))) {
                for (int k = 0; k < TestScale.of(8, 20); k++) {
                    terrain.make(20, k % 2 == 1, random);
                    twins.changeSurfaces(random);
                    for (int changes = 0; changes < 60; changes++) {
                        PipelinesAgreeTest.makeExtreme(twins, random.nextInt(scene.size()), random);
                        twins.turnExtremely(random.nextInt(scene.size()), random);
                    }
                    for (int step = 0; step < 3; step++) {
                        twins.step(scene.timeStep(), 1);
                        String when = scene.name() + " behind change " + k + ", step " + step;
                        twins.assertEqual(when);
                        terrain.assertSameContacts(when);
                    }
                }
            }
        }
    }

    /** Worlds that report have kernels of their own. */
    @OnEachDevice
    @Tag("long")
    void eventsOfCirclesAndWallsAreTheSame(Device device) {
        for (Scene scene : new Scene[] {Scenes.thesis(300, 4), Scenes.mixed(300, 4)}) {
            TerrainTwins terrain = terrain(scene);
            SplittableRandom random = new SplittableRandom(9);
            Pipeline[] pipelines = Pipelines.ready(device, Pipelines.INSIDE_EDGES);
            try (Twins twins = Twins.load(scene, terrain.on(pipelines))) {
                twins.report(ContactEvents.ALL);
                int events = 0;
                for (int k = 0; k < TestScale.of(8, 20); k++) {
                    terrain.make(20, k % 2 == 1, random);
                    if (k > 4) {
                        twins.changeSurfaces(random);
                    }
                    twins.step(scene.timeStep(), 1 + k % 3);
                    events += twins.assertSameEvents(scene.name() + ", call " + k);
                    twins.assertEqual(scene.name() + ", call " + k);
                }
                assertThat(events).as(scene.name()).isPositive();
            }
        }
    }

    @OnEachDevice
    @Tag("long")
    void onlyAWorldWithTerrainHasMemoryForIt(Device device) {
        try (Pipeline pipeline = Pipelines.of(device, Plans.COLOURS.of(device), false)) {
            long none = pipeline.bytesHeld();
            pipeline.prepare(ContactSettings.DEFAULT, Features.TERRAIN);
            long some = pipeline.bytesHeld();
            // ranges of piece contacts by slot, at home and in a step; by contact: as at home, and as measured
            assertThat(some - none).isGreaterThan((2 * 8 + 4 * (8 + 16 + 16 + 16 + 16 + 16)) * 64);
            pipeline.prepare(ContactSettings.DEFAULT, Features.TURNING.and(Features.TERRAIN));
            assertThat(pipeline.bytesHeld()).isGreaterThan(some);
            long both = pipeline.bytesHeld();
            pipeline.prepare(ContactSettings.DEFAULT, Features.TURNING.and(Features.TERRAIN));
            assertThat(pipeline.bytesHeld()).isEqualTo(both);
        }
    }
}
