package io.github.circles2d.world;

import static org.assertj.core.api.Assertions.assertThat;

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

        void apply() {
            for (Pipeline pipeline : pipelines) {
                pipeline.apply(commands);
            }
            commands.clear();
        }

        void step(float dt, int steps) {
            apply();
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

        void assertSameFigures() {
            for (Pipeline pipeline : pipelines) {
                assertThat(pipeline.contacts()).isEqualTo(pipelines[0].contacts());
                assertThat(pipeline.greatestContacts()).isEqualTo(pipelines[0].greatestContacts());
                assertThat(pipeline.candidatePairs()).isEqualTo(pipelines[0].candidatePairs());
            }
        }

        /** Saves every pipeline, and lets each go on from what another has saved. */
        void exchange() {
            apply();
            SavedState[] saved = new SavedState[pipelines.length];
            for (int k = 0; k < pipelines.length; k++) {
                saved[k] = new SavedState();
                roster.save(saved[k]);
                pipelines[k].save(saved[k]);
            }
            for (int k = 0; k < pipelines.length; k++) {
                pipelines[k].load(saved[(k + 1) % pipelines.length]);
            }
        }

        /** Asks for some change of each kind. */
        void change(Scene scene, SplittableRandom random) {
            int id = random.nextInt(roster.end());
            if (roster.lives(id)) {
                roster.remove(id);
                commands.remove(id);
            }
            float r = scene.radius()[random.nextInt(scene.size())];
            if (random.nextInt(4) > 0) {
                float x = between(random, bounds.minX(), bounds.maxX());
                float y = between(random, bounds.minY(), bounds.maxY());
                int added = roster.add(r);
                commands.add(
                        added, x, y, r, between(random, 1, 2), 0.5f, between(random, -r, r), between(random, -r, r));
            }
            for (int operation = Commands.POSITION; operation <= Commands.IMPULSE; operation++) {
                id = random.nextInt(roster.end());
                if (!roster.lives(id)) {
                    continue;
                }
                switch (operation) {
                    case Commands.POSITION ->
                        commands.set(
                                operation,
                                id,
                                between(random, bounds.minX(), bounds.maxX()),
                                between(random, bounds.minY(), bounds.maxY()));
                    case Commands.VELOCITY, Commands.IMPULSE ->
                        commands.set(operation, id, between(random, -9 * r, 9 * r), between(random, -9 * r, 9 * r));
                    case Commands.RADIUS -> {
                        roster.setRadius(id, r);
                        commands.set(operation, id, r, 0);
                    }
                    default -> commands.set(operation, id, between(random, 0.1f, 1), 0);
                }
            }
        }

        private static float between(SplittableRandom random, float low, float high) {
            return low + (float) random.nextDouble() * (high - low);
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
        pipelines.add(new JvmPipeline(1, JvmPipeline.LEAST_SHARE, 0, false));
        pipelines.add(new ClPipeline(device, 0, false, ClPlan.COLOURS));
        if (ClTiles.fit(device)) {
            pipelines.add(new ClPipeline(device, 0, false, ClPlan.TILES));
        }
        if (ClResident.fits(device)) {
            pipelines.add(new ClPipeline(device, 0, false, ClPlan.RESIDENT));
        }
        return pipelines.toArray(Pipeline[]::new);
    }

    private static void compare(Device device, Scene scene, int rounds, int steps, float dt) {
        try (Twins twins = load(scene, pipelines(device))) {
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
            try (Twins twins = load(scene, pipelines(device))) {
                SplittableRandom random = new SplittableRandom(7);
                for (int k = 0; k < 40; k++) {
                    twins.step(scene.timeStep(), 2);
                    twins.assertEqual(scene.name() + " after change " + k);
                    for (int changes = 0; changes < 5; changes++) {
                        twins.change(scene, random);
                    }
                }
            }
        }
    }

    @ParameterizedTest
    @MethodSource("devices")
    void aStateSavedOnOneGoesOnTheSameOnAnother(Device device) {
        for (Scene scene : new Scene[] {Scenes.thesis(1250, 5), Scenes.mixed(1250, 5)}) {
            try (Twins twins = load(scene, pipelines(device))) {
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
        try (Twins twins = load(scene, pipelines(device))) {
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
