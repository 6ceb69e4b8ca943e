package io.github.circles2d.world;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.circles2d.opencl.Device;
import io.github.circles2d.opencl.TestDevices;
import io.github.circles2d.scenes.Scene;
import io.github.circles2d.scenes.Scenes;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

class PipelinesAgreeTest {
    static Iterable<Device> devices() {
        return TestDevices.all();
    }

    /** A world's host side, with as many pipelines as are to be compared. */
    private static final class Twins implements AutoCloseable {
        private final Roster roster = new Roster();
        private final Commands commands = new Commands();
        private final Levels levels = new Levels();
        private final Pipeline[] pipelines;
        private final Bounds bounds;
        private final float gx;
        private final float gy;

        Twins(Bounds bounds, float gx, float gy, Pipeline... pipelines) {
            this.bounds = bounds;
            this.gx = gx;
            this.gy = gy;
            this.pipelines = pipelines;
        }

        void step(float dt, int steps) {
            for (Pipeline pipeline : pipelines) {
                pipeline.apply(commands);
            }
            commands.clear();
            for (Pipeline pipeline : pipelines) {
                StepConstants constants = new StepConstants();
                constants.set(dt, 4, gx, gy, bounds, dt);
                levels.layOut(bounds, roster.greatestRadius(), roster.population());
                pipeline.step(constants, levels, steps);
            }
        }

        void assertEqual(String when) {
            long expected = pipelines[0].hash();
            for (Pipeline pipeline : pipelines) {
                assertThat(pipeline.hash())
                        .as(when + " on " + pipeline.device())
                        .isEqualTo(expected);
            }
        }

        @Override
        public void close() {
            for (Pipeline pipeline : pipelines) {
                pipeline.close();
            }
        }
    }

    private static Twins load(Scene scene, Pipeline... pipelines) {
        Twins twins = new Twins(
                new Bounds(scene.minX(), scene.minY(), scene.maxX(), scene.maxY()),
                scene.gravityX(),
                scene.gravityY(),
                pipelines);
        for (int i = 0; i < scene.size(); i++) {
            float m = scene.fixed()[i] ? Float.POSITIVE_INFINITY : scene.mass()[i];
            int id = twins.roster.add(scene.radius()[i]);
            twins.commands.add(
                    id,
                    scene.x()[i],
                    scene.y()[i],
                    scene.radius()[i],
                    m,
                    scene.restitution(),
                    scene.vx()[i],
                    scene.vy()[i]);
        }
        return twins;
    }

    /** The pipeline in Java, and one for each plan that a device can follow. */
    private static Pipeline[] pipelines(Device device) {
        List<Pipeline> pipelines = new ArrayList<>();
        pipelines.add(new JvmPipeline(1, 0, false));
        pipelines.add(new ClPipeline(device, 0, false, ClPlan.COLOURS));
        if (ClTiles.fit(device)) {
            pipelines.add(new ClPipeline(device, 0, false, ClPlan.TILES));
        }
        if (ClResident.fits(device)) {
            pipelines.add(new ClPipeline(device, 0, false, ClPlan.RESIDENT));
        }
        return pipelines.toArray(Pipeline[]::new);
    }

    @ParameterizedTest
    @MethodSource("devices")
    void scenesHaveTheSameBitsOnTheDeviceAsInJava(Device device) {
        Scene[] scenes = {Scenes.thesis(1250, 1), Scenes.gas(1250, 1), Scenes.pyramid()};
        for (Scene scene : scenes) {
            try (Twins twins = load(scene, pipelines(device))) {
                for (int k = 0; k < 20; k++) {
                    twins.step(1 / 60f, 5);
                    twins.assertEqual(scene.name() + " after " + 5 * (k + 1) + " steps");
                }
            }
        }
    }
}
