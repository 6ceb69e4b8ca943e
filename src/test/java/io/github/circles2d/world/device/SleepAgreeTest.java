package io.github.circles2d.world.device;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.circles2d.opencl.Device;
import io.github.circles2d.opencl.OnEachDevice;
import io.github.circles2d.opencl.TestScale;
import io.github.circles2d.world.circles.Commands;
import io.github.circles2d.world.events.ContactEvents;
import io.github.circles2d.world.jvm.JvmPipeline;
import io.github.circles2d.world.model.AxisEdge;
import io.github.circles2d.world.model.Bounds;
import io.github.circles2d.world.model.KindField;
import java.util.Map;
import java.util.SplittableRandom;
import java.util.TreeMap;
import org.junit.jupiter.api.Tag;

/** Circles fall asleep and wake in the same steps on every device as in Java, to the bit. */
class SleepAgreeTest {
    private static final float DT = 1 / 60f;
    private static final Bounds BOX = new Bounds(0, 0, 4, 6);

    /** A heap of circles that have friction, and report all. */
    private static Twins heap(Device device, Bounds bounds, int circles, float ratio) {
        Twins twins = Twins.sleeping(bounds, 4, 10, Pipelines.ready(device, Pipelines.INSIDE_EDGES));
        twins.setKind(KindField.FRICTION, 0, Float.floatToRawIntBits(0.6f));
        twins.setKind(KindField.ROLLING_RESISTANCE, 0, Float.floatToRawIntBits(0.1f));
        twins.report(ContactEvents.ALL);
        SplittableRandom random = new SplittableRandom(3);
        for (int k = 0; k < circles; k++) {
            float r = (k % 7 == 0 ? ratio : 1f) * (0.1f + 0.04f * (float) random.nextDouble());
            float x = 0.5f + 3 * (float) random.nextDouble();
            twins.add(x, 0.3f + 2.5f * k / circles, r, r * r, 0, 0, 0);
        }
        return twins;
    }

    /** Compares all, every few steps. Returns how many sleep at most. */
    private static int run(Twins twins, String what, float dt, int steps) {
        int most = 0;
        for (int k = 0; k < steps; k += 10) {
            String when = what + ", step " + k;
            twins.step(dt, 1 + k % 3);
            twins.assertEqual(when);
            twins.step(dt, 9 - k % 3);
            twins.assertEqual(when);
            twins.assertSameEvents(when);
            most = Math.max(most, twins.assertSameSleepers(when));
            twins.assertDevicesKnowWhoIsAwake(when);
        }
        return most;
    }

    /** A ball falls on a heap, walls come in, gravity tilts, steps get longer, circles change and go. */
    private static void disturb(Twins twins, String what) {
        twins.add(2, 4, 0.2f, 0.1f, 0, 0, -6);
        run(twins, what + ", a ball", DT, 50);
        twins.exchange();
        run(twins, what + ", exchanged", DT, 20);
        twins.move(3, 2, 4);
        run(twins, what + ", one moved", DT, 60);
        twins.remove(5);
        twins.set(Commands.RADIUS, 8, 0.15f, 0);
        twins.set(Commands.MASS, 9, Float.POSITIVE_INFINITY, 0);
        run(twins, what + ", one removed", DT, 60);
        twins.setGravity(3, -9);
        run(twins, what + ", tilted", DT, 40);
        twins.set(Commands.VELOCITY, 9, 0.05f, 0);
        run(twins, what + ", a static one moves", DT, 30);
        twins.set(Commands.VELOCITY, 9, 0, 0);
        run(twins, what + ", in longer steps", 1 / 30f, 60);
        twins.wakeAll();
        twins.set(Commands.WAKE, 2, 0, 0);
        run(twins, what + ", all awake", DT, 30);
    }

    @OnEachDevice
    void aHeapSleepsAndWakesAlike(Device device) {
        try (Twins twins = heap(device, BOX, 20, 1)) {
            assertThat(run(twins, "a heap", DT, 240)).isGreaterThan(10);
            disturb(twins, "a heap");
            assertThat(run(twins, "at rest again", DT, TestScale.of(60, 240))).isPositive();
            twins.moveWalls(new SplittableRandom(1), 0.02f);
            run(twins, "walls move", DT, 20);
            assertThat(twins.size()).isEqualTo(20);
        }
    }

    @OnEachDevice
    void aChangeOfAKindOrAWallWakesTheSame(Device device) {
        try (Twins twins = heap(device, BOX, 20, 1)) {
            twins.setKinds(3);
            twins.set(Commands.MASS, 4, Float.POSITIVE_INFINITY, 0);
            assertThat(run(twins, "a heap", DT, 240)).isGreaterThan(10);
            SplittableRandom random = new SplittableRandom(2);
            int most = 0;
            for (int k = 0; k < TestScale.of(3, 20); k++) {
                twins.setKind(KindField.FRICTION, k % 3, Float.floatToRawIntBits(0.5f + 0.01f * k));
                most = Math.max(most, twins.assertSameSleepers("another friction"));
                run(twins, "another friction " + k, DT, 90);
                twins.setWall(k % 4, 0.7f + 0.01f * k);
                most = Math.max(most, twins.assertSameSleepers("another wall"));
                run(twins, "another wall " + k, DT, 90);
                twins.changeSurfaces(random);
                twins.setKind(KindField.CATEGORY, 2, k % 2 == 0 ? 3 : 1);
                twins.setKind(KindField.MASK, 2, k % 2 == 0 ? 2 : -1);
                twins.assertSameSleepers("another mask");
                run(twins, "another mask " + k, DT, 60);
            }
            assertThat(most).as("circles that sleep on").isGreaterThan(5);
        }
    }

    /** Nothing is launched while all sleep, until something is new. */
    @OnEachDevice
    void stepsInWhichAllSleepCostNothing(Device device) {
        DevicePipeline profiled = Pipelines.of(device, Pipelines.colours(device), true, Pipelines.INSIDE);
        try (Twins twins = Twins.sleeping(BOX, 4, 10, jvm(), profiled)) {
            for (int k = 0; k < 4; k++) {
                twins.add(0.5f + 0.4f * k, 0.15f, 0.15f, 1, 0, 0, 0);
            }
            twins.step(DT, 200);
            twins.step(DT, 1);
            assertThat(twins.assertSameSleepers("at rest")).isEqualTo(4);
            Map<String, Long> before = kernelsOfSteps(profiled);
            twins.step(DT, 50);
            twins.assertEqual("at rest");
            assertThat(kernelsOfSteps(profiled)).isEqualTo(before);
            twins.set(Commands.VELOCITY, 1, 0, 1);
            twins.step(DT, 20);
            twins.assertEqual("one moves");
            assertThat(twins.assertSameSleepers("one moves")).isLessThan(4);
            assertThat(kernelsOfSteps(profiled)).isNotEqualTo(before);
            twins.step(DT, 500);
            twins.assertEqual("at rest again");
            assertThat(twins.assertSameSleepers("at rest again")).isEqualTo(4);
        }
    }

    /** Their times, without those of reads. */
    private static Map<String, Long> kernelsOfSteps(DevicePipeline pipeline) {
        Map<String, Long> kernels = new TreeMap<>(pipeline.kernelNanos());
        kernels.keySet().removeIf(kernel -> kernel.startsWith("readback"));
        return kernels;
    }

    private static JvmPipeline jvm() {
        return new JvmPipeline(1, JvmPipeline.LEAST_SHARE, 0, false);
    }

    /** Those that fell asleep elsewhere have more impulses and events than there is room for at first. */
    @OnEachDevice
    @Tag("long")
    void manyThatSleepAreTakenOver(Device device) {
        Bounds bounds = new Bounds(0, 0, 6, 12);
        try (Twins asleep = Twins.sleeping(bounds, 4, 10, jvm());
                Twins twins = Twins.sleeping(bounds, 4, 10, Pipelines.ready(device, Pipelines.INSIDE_EDGES))) {
            asleep.setKind(KindField.FRICTION, 0, Float.floatToRawIntBits(0.6f));
            asleep.setKind(KindField.ROLLING_RESISTANCE, 0, Float.floatToRawIntBits(0.1f));
            for (int k = 0; k < 400; k++) {
                asleep.add(0.3f + 0.27f * (k % 20) + 0.02f * (k / 20 % 2), 0.15f + 0.25f * (k / 20), 0.12f, 1, 0, 0, 0);
            }
            asleep.step(DT, 600);
            twins.takeOver(asleep);
            assertThat(twins.assertSameSleepers("at first")).isGreaterThan(200);
            twins.report(ContactEvents.ALL);
            twins.setHitSpeed(0);
            twins.add(3, 8, 0.2f, 2, 0, 0, -8);
            run(twins, "a ball", DT, 60);
            twins.wakeAll();
            run(twins, "all awake", DT, 30);
            assertThat(run(twins, "at rest", DT, 90)).isPositive();
        }
    }

    @OnEachDevice
    @Tag("long")
    void heapsOfUnlikeRadiiSleepAndWakeAlike(Device device) {
        for (float ratio : new float[] {3, 8}) {
            try (Twins twins = heap(device, new Bounds(0, 0, 4, 12), 40, ratio)) {
                assertThat(run(twins, "radii of 1:" + ratio, DT, 300)).isGreaterThan(5);
                disturb(twins, "radii of 1:" + ratio);
            }
        }
    }

    @OnEachDevice
    @Tag("long")
    void theySleepAndWakeAlikeOnTerrain(Device device) {
        try (Twins twins = heap(device, BOX, 20, 1)) {
            twins.addPlate(1, 0.2f, 1.5f, false);
            long lift = twins.addPlate(3, 0.15f, 1.5f, true);
            assertThat(run(twins, "on terrain", DT, 240)).isGreaterThan(5);
            twins.moveBody(lift, 0, 0.02f);
            run(twins, "on a lift", DT, 40);
            twins.moveBody(lift, 0, 0);
            assertThat(run(twins, "at rest", DT, 150)).isPositive();
            disturb(twins, "on terrain");
        }
    }

    @OnEachDevice
    @Tag("long")
    void theySleepAndWakeAlikeOverASeam(Device device) {
        try (Twins twins = heap(device, BOX.with(AxisEdge.WRAP, AxisEdge.WALL), 30, 2)) {
            assertThat(run(twins, "wrapped", DT, 300)).isPositive();
            disturb(twins, "wrapped");
        }
    }

    @OnEachDevice
    @Tag("long")
    void whatJointsHoldSleepsAndWakesAlike(Device device) {
        try (Twins twins = heap(device, BOX, 20, 1)) {
            assertThat(run(twins, "before", DT, 240)).isGreaterThan(10);
            twins.addRod(0, 1);
            twins.addRod(2, 3);
            assertThat(run(twins, "held", DT, 150)).isPositive();
            twins.addJoints(4, 30);
            run(twins, "with random joints", DT, 60);
            disturb(twins, "with joints");
            run(twins, "at rest again", DT, TestScale.of(60, 240));
        }
    }

    /** Kinds that are sensed, never sleep, or fall otherwise; forces and torques. */
    @OnEachDevice
    @Tag("long")
    void kindsAndForcesAreHeededAlike(Device device) {
        try (Twins twins = heap(device, BOX, 30, 1)) {
            twins.setKind(KindField.AWAKE, 1, 1);
            twins.setKind(KindField.DAMPING, 2, Float.floatToRawIntBits(2f));
            twins.giveKinds();
            twins.giveMotions();
            twins.giveSensors(3, 6);
            assertThat(run(twins, "kinds", DT, 240)).isPositive();
            SplittableRandom random = new SplittableRandom(5);
            for (int k = 0; k < TestScale.of(8, 40); k++) {
                twins.turnExtremely(random.nextInt(30), random);
                run(twins, "behind change " + k, DT, 40);
            }
            twins.setGravity(0, 0);
            run(twins, "without gravity", DT, 90);
        }
    }
}
