package io.github.circles2d.world.device;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.circles2d.opencl.Device;
import io.github.circles2d.opencl.OnEachDevice;
import io.github.circles2d.opencl.TestScale;
import io.github.circles2d.world.Simulation;
import io.github.circles2d.world.circles.WorldParameters;
import io.github.circles2d.world.device.plan.Plans;
import io.github.circles2d.world.device.plan.Tiles;
import io.github.circles2d.world.jvm.JvmPipeline;
import io.github.circles2d.world.model.AxisEdge;
import io.github.circles2d.world.model.Bounds;
import io.github.circles2d.world.model.Features;
import io.github.circles2d.world.model.KindField;
import io.github.circles2d.world.shared.Call;
import io.github.circles2d.world.shared.Pipeline;
import java.util.Map;
import java.util.SplittableRandom;
import java.util.TreeMap;
import org.junit.jupiter.api.Tag;

/** Worlds with bodies that are pushed have the same bits on the JVM and, by each plan, on devices. */
class BodiesAgreeTest {
    private static final int STEPS = 40;
    private static final int CIRCLES = 150;

    @OnEachDevice
    void byColours(Device device) {
        agree(new JvmPipeline(2, 1, 0, false), Pipelines.of(device, Plans.COLOURS.of(device), false), Edges.WALLS);
    }

    @OnEachDevice
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
            BodyChanges[] worlds = {new BodyChanges(one, CIRCLES), new BodyChanges(other, CIRCLES)};
            for (int step = 0; step < STEPS; step++) {
                for (BodyChanges world : worlds) {
                    world.change(step);
                    world.simulation().step(step % 9 == 5 ? 1 / 100f : 1 / 60f, 1 + step % 2);
                }
                assertThat(other.hash()).as(edges + ", step " + step).isEqualTo(one.hash());
                assertThat(worlds[1].poses()).isEqualTo(worlds[0].poses());
                assertThat(worlds[1].touches()).isEqualTo(worlds[0].touches());
            }
            assertThat(worlds[1].sensed()).isGreaterThan(20);
            if (device.readyPlans().get(0) instanceof Tiles) {
                assertThat(device.kernelNanos()).containsKeys("solver_solveLevels", "bodies_give");
            }
        }
    }

    @OnEachDevice
    void bodiesAlone(Device device) {
        WorldParameters parameters = new WorldParameters(new Bounds(0, 0, 12, 12), 1, -10, 0.3f, 4, 0);
        try (Simulation one = new Simulation(new JvmPipeline(1, 1, 0, false), parameters);
                Simulation other = new Simulation(Pipelines.of(device, Plans.COLOURS.of(device), false), parameters)) {
            for (int step = 0; step < STEPS; step++) {
                for (Simulation each : new Simulation[] {one, other}) {
                    if (step == 0) {
                        BodyChanges.addChain(each, 5);
                    }
                    each.step(1 / 60f, 1);
                }
                assertThat(other.hash()).as("step " + step).isEqualTo(one.hash());
            }
        }
    }

    @OnEachDevice
    void asleepByColours(Device device) {
        agreeAsleep(device, Plans.COLOURS, TestScale.of(2, 3), Edges.WALLS);
    }

    @OnEachDevice
    @Tag("long")
    void asleepByTiles(Device device) {
        if (Tiles.fit(device)) {
            for (Edges edges : Edges.values()) {
                agreeAsleep(device, Plans.TILES, 4 + edges.ordinal(), edges);
            }
        }
    }

    /** Circles and bodies come to rest upon each other, and something wakes some of them, again and again. */
    private static void agreeAsleep(Device device, Plans plans, int seed, Edges edges) {
        try (Simulation one = new Simulation(new JvmPipeline(2, 1, 0, false), sleeping(edges));
                Simulation other = new Simulation(pipeline(device, plans), sleeping(edges))) {
            SleepingBodies[] worlds = {new SleepingBodies(one, seed), new SleepingBodies(other, seed)};
            for (SleepingBodies world : worlds) {
                world.fill();
            }
            run(worlds, 20, true, "at first");
            run(worlds, 400, false, "at rest");
            SplittableRandom random = new SplittableRandom(seed);
            for (int k = 0; k < SleepingBodies.DISTURBANCES * TestScale.of(1, 3); k++) {
                int which = (seed + 7 * k) % SleepingBodies.DISTURBANCES;
                for (SleepingBodies world : worlds) {
                    world.disturb(which);
                }
                run(worlds, random.nextInt(4) == 0 ? 80 : 10, k % 5 == 4, "disturbance " + which + ", the " + k + "th");
                if (k % 6 == 2) {
                    byte[] saved = worlds[0].snapshot();
                    assertThat(worlds[1].snapshot()).as("disturbance " + which).isEqualTo(saved);
                    worlds[k / 6 % 2].restore(saved);
                }
            }
            assertThat(worlds[1].mostSleepers()).isGreaterThan(3);
            assertThat(worlds[1].mostSleepingBodies()).isGreaterThan(edges == Edges.WALLS ? 5 : 0);
        }
    }

    /** A call wakes circles and bodies on the other side of a seam, and all that are near, whoever wakes first. */
    @OnEachDevice
    void aCallWakesTheSameAcrossASeam(Device device) {
        try (Simulation one = new Simulation(new JvmPipeline(1, 1, 0, false), sleeping(Edges.WRAPPED));
                Simulation other = new Simulation(pipeline(device, Plans.COLOURS), sleeping(Edges.WRAPPED))) {
            for (Simulation each : new Simulation[] {one, other}) {
                each.kinds.set(KindField.FRICTION, 0, Float.floatToRawIntBits(0.6f));
                each.kinds.set(KindField.ROLLING_RESISTANCE, 0, Float.floatToRawIntBits(0.1f));
                long circle = each.newCircles.add(0.25f, 0.25f, 0.25f, 0.2f, 0, 0, 0);
                for (int k = 0; k < 3; k++) {
                    each.newCircles.add(11.74f - 0.51f * k, 0.25f, 0.25f, 0.2f, 0, 0, 0);
                }
                each.rigids.add(BodyChanges.box(0.5f, 0.5f), 0.8f, 0.25f, 0, 0.2f, 0);
                long crate = each.rigids.add(BodyChanges.box(0.5f, 0.5f), 11.75f, 1, 0, 0.2f, 0);
                each.calls.change(Call.REMOVE_RIGID, crate);
                each.step(1 / 60f, 150);
                assertThat(each.figures().awake()).isZero();
                assertThat(each.rigidReads.awake()).isZero();
                each.circles.remove(circle);
                each.rigids.add(BodyChanges.box(0.1f, 0.1f), 0.1f, 1, 0, 0.2f, 0);
                each.hash();
                assertThat(each.figures().awake()).isOne();
                assertThat(each.rigidReads.awake()).isEqualTo(2);
                each.step(1 / 60f, 3);
            }
            assertThat(other.hash()).isEqualTo(one.hash());
        }
    }

    /** Nothing is launched, and no circle copied, while all sleep, until something is new. */
    @OnEachDevice
    void stepsInWhichAllSleepCostNothing(Device device) {
        DevicePipeline profiled = pipeline(device, Plans.COLOURS);
        try (Simulation one = new Simulation(new JvmPipeline(1, 1, 0, false), sleeping(Edges.WALLS));
                Simulation other = new Simulation(profiled, sleeping(Edges.WALLS))) {
            Simulation[] each = {one, other};
            long crate = 0;
            for (Simulation simulation : each) {
                crate = simulation.rigids.add(BodyChanges.box(1, 1), 4, 0.5f, 0, 1, 0);
                simulation.rigids.add(BodyChanges.box(1, 0.5f), 4, 1.25f, 0, 1, 0);
                simulation.newCircles.add(2, 0.25f, 0.25f, 0.2f, 0, 0, 0);
                simulation.newCircles.add(8, 0.25f, 0.25f, 0.2f, 0, 0, 0);
                simulation.step(1 / 60f, 200);
                simulation.step(1 / 60f, 1);
            }
            assertThat(other.rigidReads.awake()).isZero();
            assertThat(other.figures().awake()).isZero();
            Map<String, Long> before = profiled.kernelNanos();
            step(each, 50);
            assertThat(launches(profiled)).isEqualTo(withoutReads(before));
            assertThat(other.hash()).isEqualTo(one.hash());
            for (Simulation simulation : each) {
                simulation.calls.changeByFloats(Call.RIGID_LASTING_TORQUE, crate, 20, 0, 0, 0);
            }
            step(each, 30);
            assertThat(launches(profiled)).isNotEqualTo(withoutReads(before));
            assertThat(other.rigidReads.awake()).isPositive();
            assertThat(other.hash()).isEqualTo(one.hash());
        }
    }

    private static void step(Simulation[] each, int steps) {
        for (Simulation simulation : each) {
            simulation.step(1 / 60f, steps);
        }
    }

    private static Map<String, Long> launches(DevicePipeline pipeline) {
        return withoutReads(pipeline.kernelNanos());
    }

    private static Map<String, Long> withoutReads(Map<String, Long> kernels) {
        Map<String, Long> others = new TreeMap<>(kernels);
        others.keySet().removeIf(kernel -> kernel.startsWith("readback"));
        return others;
    }

    private static WorldParameters sleeping(Edges edges) {
        Bounds bounds = edges == Edges.WALLS
                ? new Bounds(0, 0, 12, 8)
                : new Bounds(0, 0, 12, 8, edges == Edges.OPEN ? AxisEdge.OPEN : AxisEdge.WRAP, AxisEdge.WALL);
        return new WorldParameters(bounds, 0, -10, 0.1f, 4, 0).sleeping(true);
    }

    private static DevicePipeline pipeline(Device device, Plans plans) {
        Features all = Features.EDGES
                .and(Features.TURNING)
                .and(Features.TERRAIN)
                .and(Features.JOINTS)
                .and(Features.SLEEPING)
                .and(Features.OWN_MOTION)
                .and(Features.BODIES);
        return Pipelines.of(device, plans.of(device), true, all);
    }

    private static void run(SleepingBodies[] worlds, int steps, boolean uneven, String what) {
        for (int step = 0; step < steps; step++) {
            for (SleepingBodies world : worlds) {
                world.simulation().step(uneven && step == 5 ? 1 / 100f : 1 / 60f, step % 8 == 3 ? 2 : 1);
            }
            String as = what + ", step " + step;
            assertThat(worlds[1].awake()).as(as).isEqualTo(worlds[0].awake());
            assertThat(worlds[1].simulation().hash())
                    .as(as)
                    .isEqualTo(worlds[0].simulation().hash());
            assertThat(worlds[1].poses()).as(as).isEqualTo(worlds[0].poses());
            assertThat(worlds[1].touches()).as(as).isEqualTo(worlds[0].touches());
        }
    }
}
