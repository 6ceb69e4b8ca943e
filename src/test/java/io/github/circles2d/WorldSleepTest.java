package io.github.circles2d;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.ByteBuffer;
import org.junit.jupiter.api.Test;

/** Circles that sleep, as a user sees them. {@link ReferenceSleepTest} has the rule. */
class WorldSleepTest {
    private static final float DT = 1 / 60f;

    private static World.Builder box() {
        return WorldScenes.jvm().bounds(0, 0, 10, 20).gravity(0, -10).restitution(0.2f);
    }

    /** A heap of twelve; returns the handles. */
    private static long[] heap(World world) {
        float[] circles = new float[4 * 12];
        for (int k = 0; k < 12; k++) {
            circles[4 * k] = 1.5f + k % 6 * 1.2f + 0.1f * (k / 6);
            circles[4 * k + 1] = 0.5f + k / 6 * 1.1f;
            circles[4 * k + 2] = 0.5f;
            circles[4 * k + 3] = 1f;
        }
        long[] handles = new long[12];
        world.addAll(circles, handles);
        return handles;
    }

    private static void sleepAll(World world) {
        for (int k = 0; k < 1_200 && world.stats().awake() > 0; k++) {
            world.step(DT);
        }
        assertThat(world.stats().awake()).isZero();
    }

    @Test
    void aHeapSleepsAndStaysWhereItIs() {
        try (World world =
                box().friction(0.5f).rollingResistance(0.05f).sleep(true).build()) {
            long[] heap = heap(world);
            sleepAll(world);
            long hash = world.hash();
            world.step(DT, 600);
            assertThat(world.hash()).isEqualTo(hash);
            assertThat(world.vx(heap[3])).isZero();
            long[] awake = {-1};
            world.readAwakeById(awake);
            assertThat(awake[0]).isZero();
            float[] loads = new float[2 * world.idLimit()];
            world.readLoadsById(loads, null);
            assertThat(loads[1]).as("a circle that sleeps is pressed").isGreaterThan(9f);
        }
    }

    @Test
    void whoLosesItsSupportFalls() {
        try (World world = WorldScenes.jvm()
                .bounds(0, -50, 1, 50)
                .gravity(0, -10)
                .sleep(true)
                .build()) {
            long support = world.add(0.5f, 0, 0.5f, Float.POSITIVE_INFINITY);
            long[] column = new long[20];
            for (int k = 0; k < column.length; k++) {
                column[k] = world.add(0.5f, 1 + 0.9999f * k, 0.5f, 1);
            }
            sleepAll(world);
            world.remove(support);
            world.step(DT, 10);
            assertThat(world.vy(column[19])).as("the top").isLessThan(-0.3f);
        }
    }

    @Test
    void slowSlopesAndGravityThatGoesAreNoticed() {
        try (World slope = WorldScenes.jvm()
                        .bounds(-100, 0, 100, 50)
                        .gravity(0.02f, -10)
                        .friction(0.6f)
                        .sleep(true)
                        .build();
                World heap = box().sleep(true).build()) {
            long ball = slope.add(0, 0.5f, 0.5f, 1);
            slope.step(DT, 600);
            assertThat(slope.x(ball)).isBetween(0.66f, 0.68f);
            heap(heap);
            sleepAll(heap);
            heap.setGravity(0, 10);
            heap.step(DT, 30);
            assertThat(heap.stats().awake()).isEqualTo(12);
        }
    }

    @Test
    void callsWakeAndKindsStayAwake() {
        try (World world = box().sleep(true).build()) {
            long[] heap = heap(world);
            long hero = world.add(9.3f, 0.5f, 0.5f, 1, 0, 0, 1);
            world.kind(1).setSleeps(false);
            world.step(DT, 900);
            assertThat(world.isAwake(hero)).isTrue();
            assertThat(world.isAwake(heap[0])).isFalse();
            world.wake(heap[0]);
            assertThat(world.isAwake(heap[0])).isTrue();
            assertThat(world.isAwake(heap[11])).isFalse();
            world.wakeAll();
            assertThat(world.stats().awake()).isEqualTo(13);
            assertThatThrownBy(() -> world.wake(42)).isInstanceOf(IllegalArgumentException.class);
            assertThatThrownBy(() -> world.isAwake(42)).isInstanceOf(IllegalArgumentException.class);
            assertThatThrownBy(() -> world.readAwakeById(new long[0])).hasMessageContaining("awake has room for 0");
        }
    }

    @Test
    void aWorldThatHasMadeNoStepHasASnapshotToo() {
        try (World world = box().sleep(true).build();
                World taker = box().sleep(true).build()) {
            heap(world);
            goOnAlike(world, taker);
            world.clear();
            heap(world);
            goOnAlike(world, taker);
        }
    }

    /** A snapshot says whether its world sleeps, whatever the world does that takes it. */
    @Test
    void aSnapshotBringsItsSleepAlong() {
        try (World sleeps = box().sleep(true).build();
                World never = box().build();
                World taker = box().sleep(true).build();
                World other = box().build()) {
            heap(sleeps);
            heap(never);
            heap(taker);
            sleepAll(sleeps);
            sleepAll(taker);
            never.step(DT, 100);
            goOnAlike(never, taker);
            goOnAlike(sleeps, other);
            assertThat(taker.sleeps()).isFalse();
            assertThat(other.sleeps()).isTrue();
            assertThat(other.stats().awake())
                    .isGreaterThan(0)
                    .isEqualTo(sleeps.stats().awake());
        }
    }

    private static void goOnAlike(World from, World taker) {
        ByteBuffer snapshot = ByteBuffer.allocate(from.snapshotBytes());
        from.snapshot(snapshot);
        snapshot.flip();
        taker.restore(snapshot);
        for (World world : new World[] {from, taker}) {
            world.teleport(world.handle(0), 5, 10);
        }
        assertThat(taker.hash()).isEqualTo(from.hash());
        for (int k = 0; k < 100; k++) {
            from.step(DT);
            taker.step(DT);
            assertThat(taker.hash()).isEqualTo(from.hash());
        }
    }
}
