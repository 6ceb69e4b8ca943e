package io.github.circles2d.world.device;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.circles2d.opencl.Device;
import io.github.circles2d.opencl.OnEachDevice;
import io.github.circles2d.opencl.TestScale;
import io.github.circles2d.scenes.HardScenes;
import io.github.circles2d.scenes.Scene;
import io.github.circles2d.scenes.Scenes;
import io.github.circles2d.world.circles.Commands;
import io.github.circles2d.world.device.plan.Plan;
import io.github.circles2d.world.device.plan.Plans;
import io.github.circles2d.world.device.plan.Tiles;
import io.github.circles2d.world.events.ContactEvents;
import io.github.circles2d.world.jvm.JvmPipeline;
import io.github.circles2d.world.model.AxisEdge;
import io.github.circles2d.world.model.Bounds;
import io.github.circles2d.world.model.ContactSettings;
import io.github.circles2d.world.model.Features;
import io.github.circles2d.world.model.Tuning;
import io.github.circles2d.world.shared.Pipeline;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Tag;

/** Worlds with axes that are open or wrap have the same bits on every device, by every plan, and for any number of threads. */
class EdgesAgreeTest {
    private static final AxisEdge[][] ALL_EDGES = {
        {AxisEdge.WRAP, AxisEdge.WALL},
        {AxisEdge.OPEN, AxisEdge.WRAP},
        {AxisEdge.WRAP, AxisEdge.WRAP},
        {AxisEdge.OPEN, AxisEdge.OPEN}
    };

    private static final AxisEdge[][] EDGES = Arrays.copyOf(ALL_EDGES, TestScale.of(2, ALL_EDGES.length));

    private static Pipeline[] pipelines(Device device) {
        List<Pipeline> pipelines = new ArrayList<>();
        pipelines.add(new JvmPipeline(1, JvmPipeline.LEAST_SHARE, 0, false));
        pipelines.add(new JvmPipeline(TestScale.of(2, 3), 1, 0, false));
        if (!TestScale.LONG) {
            pipelines.add(of(device, Plans.COLOURS.of(device)));
            return pipelines.toArray(Pipeline[]::new);
        }
        pipelines.add(of(device, Pipelines.plans(device, Plans.COLOURS)));
        if (Tiles.fit(device)) {
            pipelines.add(of(device, Pipelines.plans(device, Plans.TILES)));
        }
        if (Plans.choose(device) != Plans.TILES && Plans.choose(device) != Plans.COLOURS) {
            pipelines.add(of(device, Pipelines.plans(device, Plans.choose(device))));
        }
        return pipelines.toArray(Pipeline[]::new);
    }

    private static Pipeline of(Device device, List<Plan> plans) {
        return Pipelines.of(device, plans, false, Pipelines.INSIDE_EDGES);
    }

    @OnEachDevice
    void edgesTakeNoMemory(Device device) {
        try (Pipeline pipeline = Pipelines.of(device, Plans.COLOURS.of(device), false)) {
            long walled = pipeline.bytesHeld();
            pipeline.prepare(ContactSettings.DEFAULT, Features.EDGES);
            assertThat(pipeline.bytesHeld()).isEqualTo(walled);
        }
    }

    /** From crowds at one point to fast circles, of one size and of many. */
    @OnEachDevice
    @Tag("long")
    void scenesHaveTheSameBits(Device device) {
        Scene[] scenes = {
            Scenes.thesis(1250, 1),
            Scenes.gas(1250, 1),
            Scenes.mixed(600, 1),
            Scenes.onePoint(200, 1),
            HardScenes.squeezed(28, 1),
            Scenes.bouncy(1)
        };
        try (Twins twins = Twins.load(Scenes.thesis(10, 1), pipelines(device))) {
            for (Scene scene : scenes) {
                for (AxisEdge[] edges : EDGES) {
                    twins.loadInPlace(scene, edges[0], edges[1]);
                    for (int k = 0; k < 6; k++) {
                        twins.step(k == 4 ? 0.3f : scene.timeStep(), 1 + k % 3);
                        twins.assertEqual(scene.name() + " " + edges[0] + " " + edges[1] + ", call " + k);
                        twins.assertSameFigures();
                    }
                }
            }
        }
    }

    /** Circles come, go and are moved, static ones travel, states are exchanged, and events are the same. */
    @OnEachDevice
    @Tag("long")
    void changesHaveTheSameBitsAndEvents(Device device) {
        for (Scene scene : new Scene[] {Scenes.thesis(300, 2), Scenes.mixed(300, 2)}) {
            try (Twins twins = Twins.load(scene, pipelines(device))) {
                SplittableRandom random = new SplittableRandom(3);
                int events = 0;
                for (AxisEdge[] edges : EDGES) {
                    twins.loadInPlace(scene, edges[0], edges[1]);
                    twins.report(ContactEvents.ALL);
                    for (int k = 0; k < TestScale.of(5, 8); k++) {
                        for (int changes = 0; changes < 30; changes++) {
                            twins.change(scene, random);
                        }
                        twins.step(k % 7 == TestScale.of(3, 6) ? 0.3f : 1 / 60f, 1 + k % 3);
                        events += twins.assertSameEvents(scene.name() + " after change " + k);
                        if (k == 4) {
                            twins.exchange();
                        }
                    }
                    twins.report(0);
                    twins.step(1 / 60f, 3);
                    twins.assertEqual(scene.name() + " " + edges[0] + " " + edges[1]);
                }
                assertThat(events).isPositive();
            }
        }
    }

    /** Static circles that cross the seam, by their velocity or to a place beyond it, take others along. */
    @OnEachDevice
    void staticCirclesThatCrossTheSeamHaveTheSameBits(Device device) {
        Scene scene = HardScenes.paddles(20, 30, 1);
        try (Twins twins = Twins.load(scene, pipelines(device))) {
            for (AxisEdge[] edges : EDGES) {
                twins.loadInPlace(scene, edges[0], edges[1]);
                for (int k = 0; k < 8; k++) {
                    for (int id = 0; id < 12; id++) {
                        twins.set(Commands.MASS, id, Float.POSITIVE_INFINITY, 0);
                        twins.set(Commands.VELOCITY, id, 3f * k * (id - 6), 40f);
                    }
                    twins.move(3 + k, scene.maxX() - 0.01f * k, scene.minY() + 0.02f * k);
                    twins.step(scene.timeStep(), 2);
                    twins.assertEqual(edges[0] + " " + edges[1] + ", call " + k);
                }
            }
        }
    }

    /** Around an axis that wraps there may be so few cells that a tile with its border goes round further than once. */
    @OnEachDevice
    @Tag("long")
    void axesOfFewCellsHaveTheSameBits(Device device) {
        float cell = 2 * (1 + Tuning.MARGIN + Tuning.CAP);
        for (int cells :
                TestScale.EXHAUSTIVE ? new int[] {4, 6, 8, 10, 12, 14, 16, 18, 20, 22, 34} : new int[] {4, 10, 18}) {
            float side = (cells + 0.5f) * cell;
            SplittableRandom random = new SplittableRandom(cells);
            try (Twins twins =
                    Twins.empty(new Bounds(0, 0, side, side, AxisEdge.WRAP, AxisEdge.WRAP), pipelines(device))) {
                for (int i = 0; i < 1.6 * cells * cells; i++) {
                    float x = (float) random.nextDouble(side);
                    float y = (float) random.nextDouble(side);
                    twins.add(x, y, 1, 1, 0.5f, 20 * (float) random.nextDouble(), 20 * (float) random.nextDouble());
                }
                for (int k = 0; k < 10; k++) {
                    twins.step(1 / 60f, 1);
                    twins.assertEqual(cells + " cells, step " + k);
                }
            }
        }
    }
}
