package io.github.circles2d.world.device;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import io.github.circles2d.opencl.Device;
import io.github.circles2d.opencl.TestDevices;
import io.github.circles2d.world.Simulation;
import io.github.circles2d.world.bodies.OutlineShape;
import io.github.circles2d.world.circles.Commands;
import io.github.circles2d.world.circles.WorldParameters;
import io.github.circles2d.world.device.plan.Plans;
import io.github.circles2d.world.device.plan.Tiles;
import io.github.circles2d.world.joints.JointEndType;
import io.github.circles2d.world.joints.JointForm;
import io.github.circles2d.world.jvm.JvmPipeline;
import io.github.circles2d.world.model.AxisEdge;
import io.github.circles2d.world.model.Bounds;
import io.github.circles2d.world.model.JointRow;
import io.github.circles2d.world.shared.Pipeline;
import io.github.circles2d.world.terrain.ChainPath;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Worlds with bodies that are pushed have the same bits on the JVM and, by each plan, on devices. */
class BodiesAgreeTest {
    private static final int STEPS = 40;

    static List<Device> devices() {
        return TestDevices.all();
    }

    @ParameterizedTest
    @MethodSource("devices")
    void byColours(Device device) {
        agree(new JvmPipeline(2, 1, 0, false), Pipelines.of(device, Plans.COLOURS.of(device), false), Edges.WALLS);
    }

    @ParameterizedTest
    @MethodSource("devices")
    @Tag("long")
    void byTiles(Device device) {
        if (Tiles.fit(device)) {
            for (Edges edges : Edges.values()) {
                agree(new JvmPipeline(1, 1, 0, false), Pipelines.of(device, Plans.TILES.of(device), true), edges);
            }
        }
    }

    private enum Edges {
        WALLS,
        WRAPPED,
        OPEN
    }

    /** Circles of several sizes among boxes, with a hinge, motors, fast circles, a crowd, calls in between, and a time without circles. */
    private static void agree(Pipeline java, DevicePipeline device, Edges edges) {
        boolean walls = edges == Edges.WALLS;
        Bounds bounds = walls
                ? new Bounds(0, 0, 12, 12)
                : new Bounds(0, 0, 12, 12, edges == Edges.OPEN ? AxisEdge.OPEN : AxisEdge.WRAP, AxisEdge.WALL);
        WorldParameters parameters = new WorldParameters(bounds, 1, -10, 0.3f, 4, 0);
        try (Simulation one = new Simulation(java, parameters);
                Simulation other = new Simulation(device, parameters)) {
            World[] worlds = {new World(one), new World(other)};
            for (int step = 0; step < STEPS; step++) {
                for (World world : worlds) {
                    world.change(step);
                    world.simulation.step(step % 9 == 5 ? 1 / 100f : 1 / 60f, 1 + step % 2);
                }
                assertThat(other.hash()).as(edges + ", step " + step).isEqualTo(one.hash());
                assertThat(worlds[1].poses()).isEqualTo(worlds[0].poses());
            }
            if (device.readyPlans().get(0) instanceof Tiles) {
                assertThat(device.kernelNanos()).containsKeys("solver_solveLevels", "bodies_give");
            }
        }
    }

    /** The calls that both get. */
    private static final class World {
        private final Simulation simulation;
        private final SplittableRandom random = new SplittableRandom(7);
        private final List<Long> bodies = new ArrayList<>();
        private final List<Long> circles = new ArrayList<>();

        World(Simulation simulation) {
            this.simulation = simulation;
        }

        void change(int step) {
            if (step == 0) {
                addCircles(150);
                addBodies(6);
                join();
            } else if (step == 22) {
                circles.forEach(simulation.circles::remove);
                circles.clear();
            } else if (step == 26) {
                addCircles(60);
            } else if (step == 30) {
                addCrowd();
            }
            if (!circles.isEmpty() && step % 3 == 1) {
                long fast = circles.get(random.nextInt(circles.size()));
                simulation.circles.set(Commands.VELOCITY, fast, between(-400, 400), between(-400, 400));
            }
            long body = bodies.get(random.nextInt(bodies.size()));
            switch (step % 5) {
                case 1 -> simulation.rigids.applyImpulse(body, between(-9, 9), between(-9, 9));
                case 2 -> simulation.rigids.applyForce(body, between(-90, 90), between(-90, 90), between(-9, 9));
                case 3 -> simulation.rigids.teleport(body, between(2, 10), between(2, 10), between(-3, 3));
                case 4 -> addBodies(1);
                default -> {}
            }
        }

        private void addCircles(int n) {
            for (int k = 0; k < n; k++) {
                float r = k % 5 == 0 ? 0.5f : between(0.08f, 0.2f);
                float mass = k % 23 == 3 ? Float.POSITIVE_INFINITY : r * r;
                circles.add(simulation.newCircles.add(
                        between(1, 11), between(1, 11), r, mass, between(-4, 4), between(-4, 4), 0));
            }
        }

        private void addCrowd() {
            for (int k = 0; k < 90; k++) {
                circles.add(simulation.newCircles.add(6 + 1e-3f * k, 6, 0.2f, 0.1f, 0, 0, 0));
            }
        }

        private void addBodies(int n) {
            for (int k = 0; k < n; k++) {
                bodies.add(simulation.rigids.add(
                        box(between(0.4f, 2), between(0.3f, 1)),
                        between(2, 10),
                        between(2, 10),
                        between(-3, 3),
                        between(0.2f, 5),
                        0));
            }
        }

        /** A hinge at the world, and a rod between two bodies. */
        private void join() {
            JointForm rod = new JointForm(JointRow.AXIAL | JointRow.RIGID);
            JointForm pin = new JointForm(JointRow.POINT | JointRow.RIGID);
            simulation.joints.add(
                    JointEndType.RIGID, bodies.get(0), 0.1f, 0, JointEndType.RIGID, bodies.get(1), 0, 0.1f, rod);
            simulation.joints.add(JointEndType.RIGID, bodies.get(2), 0.1f, 0, JointEndType.ANCHOR, simulation.bodies.ground(), 6, 6, pin);
        }

        private static OutlineShape box(float width, float height) {
            ChainPath path = new ChainPath(0, 0);
            path.lineTo(width, 0);
            path.lineTo(width, height);
            path.lineTo(0, height);
            path.close();
            return OutlineShape.of(path, Float.NaN);
        }

        private float between(float from, float to) {
            return from + (to - from) * (float) random.nextDouble();
        }

        float[] poses() {
            float[] poses = new float[3 * simulation.rigidReads.idLimit()];
            simulation.rigidReads.readById(poses, null);
            return poses;
        }
    }

    @ParameterizedTest
    @MethodSource("devices")
    void aDeviceRefusesBodiesThatSleepAndGoesOn(Device device) {
        WorldParameters parameters = new WorldParameters(new Bounds(0, 0, 9, 9), 0, -10, 0, 4, 0).sleeping(true);
        try (Simulation simulation =
                new Simulation(Pipelines.of(device, Plans.COLOURS.of(device), false), parameters)) {
            simulation.newCircles.add(4, 4, 1, 1, 0, 0, 0);
            assertThatThrownBy(() -> simulation.rigids.add(World.box(1, 1), 2, 2, 0, 1, 0))
                    .isInstanceOf(UnsupportedOperationException.class)
                    .hasMessageContaining("sleep");
            simulation.step(1 / 60f, 3);
            assertThat(simulation.rigidReads.size()).isZero();
        }
    }
}
