package io.github.circles2d.world.device;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.circles2d.opencl.Device;
import io.github.circles2d.opencl.OnEachDevice;
import io.github.circles2d.opencl.TestScale;
import io.github.circles2d.scenes.HardScenes;
import io.github.circles2d.scenes.Scene;
import io.github.circles2d.scenes.Scenes;
import io.github.circles2d.world.circles.Commands;
import io.github.circles2d.world.events.ContactEvents;
import io.github.circles2d.world.model.AxisEdge;
import io.github.circles2d.world.model.Bounds;
import io.github.circles2d.world.model.Tuning;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Tag;

/** Circles of very different sizes have the same bits and events by every plan and in Java, whatever else is the matter with them. */
class MixedRadiiAgreeTest {
    private static final AxisEdge[][] EDGES = {
        {AxisEdge.WALL, AxisEdge.WALL}, {AxisEdge.WRAP, AxisEdge.WRAP}, {AxisEdge.OPEN, AxisEdge.WRAP}
    };

    @OnEachDevice
    @Tag("long")
    void blendsHaveTheSameBitsWithAllEdges(Device device) {
        Scene[] scenes = {HardScenes.blend(500, 10, 1), HardScenes.blend(1200, 100, 2), HardScenes.blend(200, 3, 3)};
        try (Twins twins = Twins.load(Scenes.thesis(10, 1), Pipelines.all(device, Pipelines.INSIDE_EDGES))) {
            for (int s = 0; s < scenes.length; s++) {
                Scene scene = scenes[s];
                AxisEdge[][] some = TestScale.EXHAUSTIVE ? EDGES : new AxisEdge[][] {EDGES[s]};
                for (AxisEdge[] edges : some) {
                    String name = scene.name() + " " + edges[0] + " " + edges[1];
                    twins.loadInPlace(scene, edges[0], edges[1]);
                    for (int k = 0; k < 5; k++) {
                        twins.step(k == 3 ? 0.2f : 1 / 60f, 1 + k % 3);
                        twins.assertEqual(name + ", call " + k);
                    }
                    twins.assertSameFigures();
                    twins.exchange();
                    twins.step(1 / 60f, 2);
                    twins.assertEqual(name + " behind an exchange");
                }
            }
        }
    }

    @OnEachDevice
    @Tag("long")
    void blendsHaveTheSameEvents(Device device) {
        for (Scene scene : new Scene[] {HardScenes.blend(500, 10, 4), HardScenes.blend(900, 100, 5)}) {
            try (Twins twins = Twins.load(scene, PipelinesAgreeTest.pipelines(device))) {
                SplittableRandom random = new SplittableRandom(5);
                twins.report(ContactEvents.ALL);
                int events = 0;
                for (int k = 0; k < TestScale.of(4, 10); k++) {
                    twins.step(1 / 60f, 1 + k % 3);
                    events += twins.assertSameEvents(scene.name() + ", call " + k);
                    twins.change(scene, random);
                }
                assertThat(events).as(scene.name()).isPositive();
                twins.assertEqual(scene.name());
            }
        }
    }

    /** The step finds out about it late: other circles have no contacts that could tell. */
    @OnEachDevice
    @Tag("long")
    void aCrowdOfCrossContactsAloneHasTheSameBits(Device device) {
        Bounds bounds = new Bounds(0, 0, 1, 1);
        try (Twins twins = Twins.empty(bounds, PipelinesAgreeTest.pipelines(device))) {
            twins.addCrossCrowd(Tuning.CROWD + 8);
            for (int k = 0; k < 4; k++) {
                twins.step(1 / 60f, 1 + k);
                twins.assertEqual("call " + k);
                twins.assertSameFigures();
            }
        }
    }

    /** Groups have more like contacts than a tile takes, and circles more candidates than are kept, in more than one level. */
    @OnEachDevice
    @Tag("long")
    void crowdsOfSeveralLevelsHaveTheSameBits(Device device) {
        for (int circles : new int[] {40, 300}) {
            Scene scene = Scenes.onePoint(circles, 3);
            try (Twins twins = Twins.load(scene, PipelinesAgreeTest.pipelines(device))) {
                for (int id = 0; id < circles; id += 30) {
                    twins.set(Commands.RADIUS, id, 4 * scene.radius(id), 0);
                }
                for (int k = 0; k < TestScale.of(2, 4); k++) {
                    twins.step(1 / 60f, 1 + k);
                    twins.assertEqual(circles + " circles, call " + k);
                    twins.assertSameFigures();
                }
            }
        }
    }

    /** A level comes and goes with the one circle that is in it: the smallest, the largest, and one between. */
    @OnEachDevice
    void levelsComeAndGo(Device device) {
        Scene scene = Scenes.thesis(1250, 9);
        float[] factors = {1, 0.05f, 1, 6, 2.5f, 1};
        try (Twins twins = Twins.load(scene, PipelinesAgreeTest.pipelines(device))) {
            for (int k = 0; k < 2 * factors.length; k++) {
                twins.set(Commands.RADIUS, 17, factors[k % factors.length] * scene.radius(17), 0);
                if (k == 7) {
                    twins.set(Commands.MASS, 17, Float.POSITIVE_INFINITY, 0);
                    twins.set(Commands.VELOCITY, 17, 0.4f, 0.3f);
                }
                twins.step(1 / 60f, 1 + k % 3);
                twins.assertEqual("change " + k);
                twins.assertSameFigures();
            }
        }
    }
}
