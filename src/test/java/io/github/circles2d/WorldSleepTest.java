package io.github.circles2d;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.ByteBuffer;
import java.util.List;
import java.util.function.BiConsumer;
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
            world.step(DT); // in which the last one learns what it is out of balance
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

    /** A ball that sleeps on the floor, or on a static circle. */
    private static World ball(boolean onCircle, World.Builder builder) {
        World world = builder.bounds(-50, 0, 50, 50).gravity(0, -10).sleep(true).build();
        if (onCircle) {
            world.add(0, 5, 1, Float.POSITIVE_INFINITY);
            world.add(-1.1f, 6, 0.5f, Float.POSITIVE_INFINITY);
            world.add(1.1f, 6, 0.5f, Float.POSITIVE_INFINITY);
        }
        world.add(0, onCircle ? 6.5f : 0.5f, 0.5f, 1);
        sleepAll(world);
        return world;
    }

    @Test
    void aWallThatJumpsAwayLetsWhoLiesOnItFall() {
        try (World world = ball(false, WorldScenes.jvm())) {
            world.setBounds(-50, -20, 50, 50);
            world.step(DT, 60);
            assertThat(world.y(world.handle(0))).isLessThan(-4f);
        }
    }

    @Test
    void aForceOfOneStepIsFelt() {
        for (float force : new float[] {0.5f, 20, 1000}) {
            try (World world = ball(false, WorldScenes.jvm())) {
                long ball = world.handle(0);
                world.applyForce(ball, force, 0);
                world.step(DT, 2);
                assertThat(world.vx(ball)).as("force %f", force).isGreaterThan(0.99f * force * DT);
            }
        }
    }

    @Test
    void gravityIsFeltOnceItsChangesAddUpButNotIfItTrembles() {
        try (World world = ball(false, WorldScenes.jvm())) {
            for (int k = 0; k < 300; k++) {
                world.setGravity(k % 2 * 1e-4f, -10);
                world.step(DT);
            }
            assertThat(world.stats().awake()).isZero();
            for (int k = 0; k < 300; k++) {
                world.setGravity(k * 1e-4f, -10);
                world.step(DT);
            }
            assertThat(world.vx(world.handle(0))).isGreaterThan(0.06f);
        }
    }

    @Test
    void aStaticCircleThatChangesWakesWhoLiesOnIt() {
        List<BiConsumer<World, Long>> changes = List.of(
                (world, support) -> world.grow(support, 0.2f, 20),
                (world, support) -> world.setAngularVelocity(support, 1),
                (world, support) ->
                        world.setAngularVelocities(new long[] {support}, 1, new float[] {1}, StaleHandles.REFUSE),
                (world, support) -> world.setFriction(support, 0),
                (world, support) -> world.setRollingResistance(support, 0));
        for (BiConsumer<World, Long> change : changes) {
            try (World world = ball(true, WorldScenes.jvm().friction(0.6f).rollingResistance(0.1f))) {
                change.accept(world, world.handle(0));
                world.step(DT);
                assertThat(world.isAwake(world.handle(3))).isTrue();
            }
        }
    }

    @Test
    void aChangeOfHowOneCircleMovesWakesItAndWithoutGravityItsDampingLetsItSleep() {
        try (World world = WorldScenes.jvm()
                .bounds(0, 0, 10, 10)
                .gravity(0, -10)
                .sleep(true)
                .build()) {
            long ball = world.add(5, 0.5f, 0.5f, 1);
            world.step(DT, 120);
            List<BiConsumer<World, Float>> changes = List.of(
                    (w, value) -> w.setGravityScale(ball, value),
                    (w, value) -> w.setDamping(ball, value),
                    (w, value) -> w.setGreatestSpeed(ball, value));
            for (BiConsumer<World, Float> change : changes) {
                assertThat(world.isAwake(ball)).isFalse();
                change.accept(world, 1f);
                world.step(DT);
                assertThat(world.isAwake(ball)).isTrue();
                world.step(DT, 120);
            }
            world.setGravityScale(ball, -1);
            world.step(DT, 30);
            assertThat(world.y(ball)).isGreaterThan(0.6f);
            world.setGravityScale(ball, 0);
            world.setVelocity(ball, 0, 0);
            world.step(DT, 120);
            assertThat(world.isAwake(ball)).isFalse();
            world.setDamping(ball, 0);
            world.step(DT, 120);
            assertThat(world.isAwake(ball)).isTrue();
        }
    }

    @Test
    void whatTheSolverLeavesOutOfBalanceKeepsNobodyAwake() {
        try (World valley = WorldScenes.jvm()
                .bounds(-10, 0, 10, 10)
                .gravity(0, -10)
                .sleep(true)
                .build()) {
            valley.terrain().ground().addChain(Chain.from(-5, 1).lineTo(0, 0.5f).lineTo(5, 1));
            long ball = valley.add(0.3f, 1.2f, 0.5f, 1);
            valley.kind(1).setDamping(5);
            long damped = valley.add(7, 0.5f, 0.5f, 1, 0, 0, 1);
            long onIt = valley.add(7, 1.5f, 0.5f, 1, 0, 0, 1);
            valley.step(DT, 900);
            for (int k = 0; k < 300; k++) {
                valley.step(DT);
                assertThat(valley.isAwake(ball) || valley.isAwake(damped) || valley.isAwake(onIt))
                        .as("step %d", k)
                        .isFalse();
            }
        }
    }

    @Test
    void aBallThatTurnsWholeTurnsInAStepKeepsTurning() {
        try (World world = WorldScenes.jvm()
                .bounds(-50, 0, 50, 50)
                .gravity(0, -10)
                .friction(0)
                .sleep(true)
                .build()) {
            long ball = world.add(0, 0.5f, 0.5f, 1);
            float speed = (float) (120 * Math.PI);
            world.setAngularVelocity(ball, speed);
            world.step(DT, 200);
            assertThat(world.angularVelocity(ball)).isEqualTo(speed);
        }
    }
}
