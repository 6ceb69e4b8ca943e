package io.github.circles2d;

import static io.github.circles2d.WorldScenes.snapshot;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

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
    void aSetterThatChangesNothingWakesNobody() {
        try (World world =
                box().friction(0.5f).rollingResistance(0.05f).sleep(true).build()) {
            heap(world);
            long piece = world.terrain().addSegment(0, 10, 1, 10, 0, 1);
            sleepAll(world);
            world.kind(0).setDamping(world.kind(0).damping());
            world.kind(0).setSleeps(true);
            world.setResponse(0, 1, world.response(0, 1));
            world.terrain().setKind(piece, 1);
            assertThat(world.stats().awake()).isZero();
            world.kind(1).setDamping(1);
            assertThat(world.stats().awake()).isEqualTo(12);
        }
    }

    /** A heap of circles of kind 0, and three of kind 1 in a corner of their own, which sleep. */
    private static long[] twoKinds(World world) {
        heap(world);
        world.terrain().addSegment(8.4f, 0, 8.4f, 3, 0, 3);
        long[] corner = new long[3];
        for (int k = 0; k < corner.length; k++) {
            corner[k] = world.add(9.4f, 0.5f + 1.001f * k, 0.5f, 1, 0, 0, 1);
        }
        sleepAll(world);
        return corner;
    }

    private static void assertAwake(World world, int count, Runnable change) {
        sleepAll(world);
        change.run();
        assertThat(world.stats().awake()).isEqualTo(count);
    }

    @Test
    void aChangeOfAKindWakesWhomItConcerns() {
        try (World world =
                box().friction(0.5f).rollingResistance(0.05f).sleep(true).build()) {
            twoKinds(world);
            Kind kind = world.kind(1);
            assertAwake(world, 3, () -> kind.setGravityScale(1.5f).setDamping(0.1f));
            assertAwake(world, 3, () -> kind.setFriction(0.4f).setInertia(Inertia.RING));
            assertAwake(world, 3, () -> kind.setSleeps(false));
            kind.setSleeps(true);
            assertAwake(world, 0, () -> world.kind(2).setFriction(0.7f).setDamping(2));
            assertAwake(world, 3, () -> world.setResponse(1, 2, Response.IGNORE));
            assertAwake(world, 12, () -> world.setResponse(0, 2, Response.IGNORE));
            assertAwake(world, 3, () -> kind.setCategory(3));
            assertAwake(world, 15, () -> kind.setMask(2)); // it ignores kind 0 now
        }
    }

    /** Circles that sleep on what has no balance of its own: they do not notice by themselves. */
    @Test
    void aChangeOfAKindThatTerrainOrStaticCirclesHaveWakesWhoLiesOnThem() {
        for (boolean terrain : new boolean[] {true, false}) {
            try (World world = WorldScenes.jvm()
                    .bounds(0, 0, 30, 10)
                    .gravity(0, -10)
                    .friction(0.6f)
                    .rollingResistance(0.6f)
                    .sleep(true)
                    .build()) {
                world.kind(2).setFriction(0.6f);
                if (terrain) {
                    world.terrain().addSegment(2, 4, 12, 6, 0, 2);
                } else {
                    for (int k = 0; k <= 50; k++) {
                        world.add(2 + 0.2f * k, 4 + 0.04f * k, 0.4f, Float.POSITIVE_INFINITY, 0, 0, 2);
                    }
                }
                long sleeper = world.add(7, terrain ? 5.52f : 5.9f, 0.5f, 1);
                long other = world.add(20, 0.5f, 0.5f, 1, 0, 0, 1);
                sleepAll(world);
                float x = world.x(sleeper);
                world.setResponse(1, 2, Response.IGNORE);
                assertThat(world.isAwake(sleeper)).isFalse();
                sleepAll(world);
                world.kind(2).setFriction(0);
                world.kind(0).setInertia(Inertia.NONE);
                assertThat(world.isAwake(other)).as("what ignores the kind").isFalse();
                world.step(DT, 30);
                assertThat(world.x(sleeper)).as("it slides").isLessThan(x - 0.1f);
                world.kind(0).setGravityScale(0);
                world.setVelocity(sleeper, 0, 0);
                world.kind(0).setDamping(3);
                sleepAll(world);
                world.kind(0).setGravityScale(1);
                world.kind(2).setMask(0);
                world.step(DT, 90);
                assertThat(world.y(sleeper)).as("it falls through").isLessThan(4);
            }
        }
    }

    /** A tower of other circles on two of the kind that loses its grip: it comes down as it does if all wake. */
    @Test
    void whoSleepsOnCirclesOfAKindThatChangesNoticesByItsBalance() {
        float[] tops = new float[2];
        for (int all = 0; all < 2; all++) {
            try (World world = WorldScenes.jvm()
                    .bounds(0, 0, 10, 20)
                    .gravity(0, -10)
                    .friction(0.8f)
                    .rollingResistance(0.8f)
                    .sleep(true)
                    .build()) {
                world.kind(1).setFriction(0.8f).setRollingResistance(0.8f);
                world.add(4.4f, 0.5f, 0.5f, 1, 0, 0, 1);
                world.add(5.6f, 0.5f, 0.5f, 1, 0, 0, 1);
                long top = -1;
                for (int k = 0; k < 8; k++) {
                    top = world.add(5, 1.3f + k, 0.5f, 1);
                }
                sleepAll(world);
                world.kind(1).setFriction(0).setRollingResistance(0);
                if (all == 1) {
                    world.wakeAll();
                } else {
                    assertThat(world.stats().awake()).isEqualTo(2);
                }
                world.step(DT, 20);
                tops[all] = world.y(top);
            }
        }
        assertThat(tops[1]).isLessThan(8);
        assertThat(tops[0]).isCloseTo(tops[1], within(0.1f));
    }

    @Test
    void aWallThatGetsAnotherSurfaceWakesWhoLeansOnIt() {
        try (World world =
                box().friction(0.5f).rollingResistance(0.05f).sleep(true).build()) {
            long[] corner = twoKinds(world);
            assertAwake(world, 0, () -> world.setWallSurface(Wall.MAX_Y, 0.5f, 0, 1));
            world.setWallSurface(Wall.MIN_Y, 0.3f, 0, 0);
            assertThat(world.isAwake(corner[0])).isTrue();
            assertThat(world.isAwake(corner[1])).isFalse();
            sleepAll(world);
            world.setWallSurface(Wall.MIN_Y, 0.3f, 0, 1);
            float x = world.x(corner[0]);
            world.step(DT, 30);
            assertThat(world.x(corner[0])).as("a belt takes it along").isNotEqualTo(x);
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
        ByteBuffer snapshot = snapshot(from);
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

    // ---- joints

    private static World.Builder wide() {
        return WorldScenes.jvm().bounds(-50, -50, 50, 50).gravity(0, -10).sleep(true);
    }

    /** A chain from (0, 0) on, to the right or down; returns the circles. */
    private static long[] chain(World world, int links, boolean level, Joint joint) {
        long[] beads = new long[links];
        for (int k = 0; k < links; k++) {
            float way = 0.5f * (k + 1);
            beads[k] = world.add(level ? way : 0, level ? 0 : -way, 0.25f, 1);
            if (k == 0) {
                world.joints().add(beads[0], 0, 0, joint);
            } else {
                world.joints().add(beads[k - 1], beads[k], joint);
            }
        }
        return beads;
    }

    private static long[] bridge(World world) {
        world.kind(0).setDamping(1);
        long[] beads = chain(world, 20, true, Joint.rope(0.55f));
        world.joints().add(beads[19], 10.5f, 0, Joint.rope(0.55f));
        return beads;
    }

    private static void sleepsLong(World world) {
        for (int k = 0; k < 3_000 && world.stats().awake() > 0; k++) {
            world.step(DT);
        }
        assertThat(world.stats().awake()).isZero();
    }

    @Test
    void aBridgeSleepsWhereItWouldHangAnyway() {
        try (World world = wide().build();
                World awake = wide().sleep(false).build()) {
            long[] beads = bridge(world);
            bridge(awake);
            sleepsLong(world);
            world.step(DT);
            long hash = world.hash();
            world.step(DT, 600);
            assertThat(world.hash()).isEqualTo(hash);
            awake.step(DT, 3_000);
            for (long bead : beads) {
                assertThat(world.y(bead)).isCloseTo(awake.y(bead), within(0.02f));
            }
            assertThat(world.joints().force(world.joints().handle(0)))
                    .isCloseTo(awake.joints().force(awake.joints().handle(0)), within(3f));
        }
    }

    @Test
    void aBallOnABridgeWakesItAndItSagsAsItWouldAnyway() {
        try (World world = wide().build();
                World awake = wide().sleep(false).build()) {
            long[] beads = bridge(world);
            bridge(awake);
            sleepsLong(world);
            awake.step(DT, 1_500);
            world.add(5, 3, 0.4f, 10, 0, 0, 1);
            awake.add(5, 3, 0.4f, 10, 0, 0, 1);
            world.step(DT, 60);
            awake.step(DT, 60);
            assertThat(world.isAwake(beads[0])).isTrue();
            assertThat(world.isAwake(beads[19])).isTrue();
            assertThat(world.y(beads[9])).isCloseTo(awake.y(beads[9]), within(0.05f));
        }
    }

    @Test
    void whatHappensToAJointWakesItsCircles() {
        List<BiConsumer<World, Long>> changes = List.of(
                (world, joint) -> world.joints().remove(joint),
                (world, joint) -> world.joints().removeAll(new long[] {joint}),
                (world, joint) -> world.joints().clear(),
                (world, joint) -> world.joints().setLength(joint, 0.6f),
                (world, joint) -> world.joints().setBreaking(joint, 1, 1),
                (world, joint) -> world.joints().setColliding(joint, true),
                (world, joint) -> world.remove(world.joints().circle(joint)),
                (world, joint) -> world.joints().add(world.joints().other(joint), Joint.motor(0, 1)));
        for (BiConsumer<World, Long> change : changes) {
            try (World world = wide().build()) {
                long[] beads = chain(world, 3, false, Joint.distance(0.5f));
                sleepsLong(world);
                world.joints().setLength(world.joints().handle(2), 0.5f);
                assertThat(world.stats().awake()).as("nothing has changed").isZero();
                change.accept(world, world.joints().handle(2));
                assertThat(world.isAwake(beads[2])).isTrue();
            }
        }
    }

    /** Far from each other, so that only the joint says so. */
    @Test
    void whatAStaticCircleHoldsWakesIfACallPutsItElsewhereOrTurnsIt() {
        try (World world = box().sleep(true).build()) {
            long post = world.add(2, 10, 0.5f, Float.POSITIVE_INFINITY);
            long hung = world.add(2, 5, 0.5f, 1);
            long pole = world.add(8, 10, 0.5f, Float.POSITIVE_INFINITY);
            long welded = world.add(8, 13, 0.5f, 1);
            world.joints().add(hung, post, Joint.rope(5));
            world.joints().add(pole, welded, Joint.weld());
            for (Runnable put : List.<Runnable>of(
                    () -> world.teleport(post, 2, 12),
                    () -> world.setPosition(post, 2, 13),
                    () -> world.setPositions(new long[] {hung}, 1, new float[] {2, 9}, StaleHandles.REFUSE),
                    () -> world.setAngle(pole, 1))) {
                sleepAll(world);
                put.run();
                float y = world.y(hung);
                float x = world.x(welded);
                world.step(DT, 60);
                assertThat(Math.abs(world.y(hung) - y) + Math.abs(world.x(welded) - x))
                        .isGreaterThan(0.5f);
            }
        }
    }

    /** A post in a wall goes along with it, under who lies on it, and with who hangs from it. */
    @Test
    void whatAWallTakesAlongWakesWhoLiesOnItAndWhoHangsFromIt() {
        try (World world = box().sleep(true).build()) {
            world.add(5, 0, 3, Float.POSITIVE_INFINITY);
            long lies = world.add(5, 3.5f, 0.5f, 1);
            long hook = world.add(9, world.maxY(), 0.2f, Float.POSITIVE_INFINITY);
            long hangs = world.add(9, world.maxY() - 5, 0.2f, 1);
            world.joints().add(hook, hangs, Joint.rope(5));
            long far = world.add(1, world.maxY() / 2 + 0.5f, 0.5f, 1);
            world.add(1, world.maxY() / 2 - 0.5f, 0.5f, Float.POSITIVE_INFINITY);
            sleepAll(world);
            float top = world.maxY();
            for (int k = 1; k <= 60; k++) {
                world.setBounds(0, 0.01f * k, world.maxX(), top - 0.01f * k);
                assertThat(world.isAwake(lies)).isTrue();
                assertThat(world.isAwake(hangs)).isTrue();
                assertThat(world.isAwake(far)).as("who is far from walls").isFalse();
                world.step(DT);
            }
            assertThat(world.y(lies)).isCloseTo(4.1f, within(0.1f));
            assertThat(world.y(hangs)).isCloseTo(top - 5.6f, within(0.02f));
            sleepAll(world);
            world.setBounds(0, 0, world.maxX(), top);
            assertThat(world.isAwake(hangs))
                    .as("walls that go out take nobody along")
                    .isFalse();
        }
    }

    /** The path of a static circle is at most a share of the period, but it arrives. */
    @Test
    void whereAStaticCircleArrivesNobodySleeps() {
        try (World world = WorldScenes.jvm()
                .bounds(0, 0, 10, 10)
                .edges(Edge.WRAP, Edge.WALL)
                .sleep(true)
                .build()) {
            world.kind(0).setDamping(1);
            long post = world.add(1, 5, 0.3f, Float.POSITIVE_INFINITY);
            long ball = world.add(4.9f, 5.1f, 0.3f, 1);
            sleepAll(world);
            world.setPosition(post, 5, 5);
            world.step(DT);
            assertThat(world.isAwake(ball)).isTrue();
            world.step(DT, 300);
            assertThat(Math.hypot(world.x(ball) - 5, world.y(ball) - 5)).isGreaterThan(0.59);
        }
    }

    /** What held it goes while it is about to fall asleep, and it has hardly moved when it does. */
    @Test
    void whoLosesWhatHeldItOnASlopeJustBeforeItSleepsSlides() {
        for (int slope = 1; slope <= 5; slope++) {
            for (int k = 50; k < 64; k++) {
                try (World world = box().gravity(0.4f * slope, -10).sleep(true).build()) {
                    float[] circles = {5, 0.5f, 0.5f, 1, 6, 0.5f, 0.5f, Float.POSITIVE_INFINITY};
                    long[] handles = new long[2];
                    world.addAll(circles, handles);
                    world.step(DT, k);
                    world.remove(handles[1]);
                    world.step(DT, 180);
                    assertThat(world.x(handles[0]))
                            .as("slope %d, step %d", slope, k)
                            .isGreaterThan(6f);
                }
            }
        }
    }

    @Test
    void whatSpringsStretchWithoutGravitySleeps() {
        try (World world = WorldScenes.jvm().bounds(0, 0, 5, 5).sleep(true).build()) {
            world.kind(0).setDamping(1).setAngularDamping(1);
            long last = 0;
            for (int k = 0; k < 10; k++) {
                long bead = world.add(0.5f + 0.4f * k, 2.5f, 0.1f, 1);
                if (k == 0) {
                    world.joints().add(bead, 0.2f, 2.5f, Joint.distance(0.3f));
                } else {
                    world.joints().add(last, bead, Joint.spring(3, 0.7f).withLength(0.3f));
                }
                last = bead;
            }
            world.joints().add(last, 4.8f, 2.5f, Joint.distance(0.7f));
            sleepAll(world);
            world.step(DT, 300);
            assertThat(world.stats().awake()).isZero();
            world.remove(last);
            world.step(DT, 3);
            assertThat(world.stats().awake()).as("who loses what stretches it").isPositive();
        }
    }

    /** It has slept at another side of the segment, which has turned since then. */
    @Test
    void whoSleepsAtTheEndOfASegmentMayBeSaved() {
        try (World world = box().gravity(0, 0).sleep(true).build();
                World other = box().gravity(0, 0).sleep(true).build()) {
            world.kind(0).setDamping(1);
            TerrainBody body = world.terrain().addBody(5, 5, 0);
            body.addSegment(-1, 0, 1, 0);
            long ball = world.add(6.69f, 4.98f, 0.5f, 1);
            sleepAll(world);
            body.moveTo(5, 5, -0.06f);
            world.step(DT, 2);
            assertThat(world.isAwake(ball)).as("it is too far from what moves").isFalse();
            ByteBuffer snapshot = ByteBuffer.allocate(world.snapshotBytes());
            world.snapshot(snapshot);
            other.restore(snapshot.flip());
            other.step(DT);
            world.step(DT);
            assertThat(other.hash()).isEqualTo(world.hash());
        }
    }

    @Test
    void aJointThatBreaksWakesBothEnds() {
        try (World world = wide().build()) {
            long[] beads = chain(world, 5, false, Joint.distance(0.5f));
            long last = world.joints().handle(4);
            sleepsLong(world);
            world.joints().setBreaking(last, 11, 11);
            sleepsLong(world);
            world.applyImpulse(beads[4], 0, -3);
            world.step(DT, 2);
            assertThat(world.joints().contains(last)).isFalse();
            assertThat(world.isAwake(beads[3])).isTrue();
            world.step(DT, 60);
            assertThat(world.y(beads[4])).isLessThan(-6f);
        }
    }

    @Test
    void aRopeWithSlackWakesTheOtherEndAsItGetsTaut() {
        try (World world = wide().bounds(-50, 0, 50, 50).friction(0.5f).build()) {
            long one = world.add(-2, 0.5f, 0.5f, 1);
            long other = world.add(2, 0.5f, 0.5f, 1);
            world.joints().add(one, other, Joint.rope(6));
            sleepsLong(world);
            world.setVelocity(other, 12, 0);
            world.setAngularVelocity(other, -24);
            for (int k = 0; k < 60 && !world.isAwake(one); k++) {
                assertThat(world.x(one)).isCloseTo(-2f, within(1e-3f));
                world.step(DT);
            }
            assertThat(world.x(other) - world.x(one)).isCloseTo(6f, within(0.05f));
            assertThat(world.vx(one) + world.vx(other)).as("momentum").isCloseTo(12f, within(1f));
        }
    }

    @Test
    void motorsKeepTheirCirclesAwakeAndBrakesDoNot() {
        try (World world = wide().bounds(-50, 0, 50, 50).friction(0.5f).build()) {
            long driven = world.add(-5, 0.5f, 0.5f, 1);
            long braked = world.add(5, 0.5f, 0.5f, 1);
            long motor = world.joints().add(driven, Joint.motor(0.001f, 10));
            world.joints().add(braked, Joint.motor(0, 10));
            world.step(DT, 200);
            assertThat(world.isAwake(driven)).isTrue();
            assertThat(world.isAwake(braked)).isFalse();
            world.joints().setSpeed(motor, 0);
            sleepsLong(world);
            world.joints().setSpeed(motor, 4);
            world.step(DT, 60);
            assertThat(Math.abs(world.angularVelocity(driven))).isCloseTo(4f, within(0.1f));
        }
    }

    @Test
    void aMouseJointSleepsUntilItsTargetMoves() {
        try (World world = wide().build()) {
            long ball = world.add(0, 0, 0.5f, 1);
            long mouse = world.joints().add(ball, 0, 0, Joint.mouse(4, 1, 1000));
            sleepsLong(world);
            for (int k = 0; k < 100; k++) {
                world.joints().setAnchor(mouse, 0, 0);
                world.step(DT);
                assertThat(world.isAwake(ball)).isFalse();
            }
            for (int k = 0; k < 100; k++) {
                world.joints().setAnchor(mouse, 0.01f * k, 0);
                world.step(DT);
            }
            assertThat(world.x(ball)).isBetween(0.7f, 1f);
        }
    }

    @Test
    void anAnchorOnABodyThatMovesWakes() {
        try (World world = wide().build()) {
            TerrainBody lift = world.terrain().addBody(0, 5, 0);
            long ball = world.add(0, 3, 0.5f, 1);
            world.joints().add(ball, lift, 0, 0, Joint.distance(2));
            sleepsLong(world);
            lift.setVelocity(0, 0.01f);
            world.step(DT, 100);
            assertThat(world.isAwake(ball)).isTrue();
            lift.setVelocity(0, 0);
            sleepsLong(world);
            assertThat(world.y(ball)).isCloseTo(3 + 100 * 0.01f * DT, within(0.005f));
        }
    }

    /** Twelve circles and one in the middle, held by springs, in a heap on the ground. */
    private static long[] blob(World world) {
        long[] ring = new long[13];
        ring[12] = world.add(0, 2, 0.3f, 1);
        for (int k = 0; k < 12; k++) {
            double angle = k * Math.PI / 6;
            ring[k] = world.add((float) Math.cos(angle), 2 + (float) Math.sin(angle), 0.25f, 1);
        }
        for (int k = 0; k < 12; k++) {
            Joint spring = Joint.spring(5, 0.7f);
            world.joints().add(ring[k], ring[(k + 1) % 12], spring);
            world.joints().add(ring[12], ring[k], spring);
            world.joints().add(ring[k], ring[(k + 3) % 12], spring);
        }
        return ring;
    }

    @Test
    void aSoftBodySleepsAndABeamOfWeldsDoes() {
        try (World world = wide().bounds(-50, 0, 50, 50)
                        .friction(0.5f)
                        .rollingResistance(0.05f)
                        .build();
                World beam = wide().build()) {
            long[] ring = blob(world);
            sleepsLong(world);
            world.step(DT, 300);
            assertThat(world.stats().awake()).isZero();
            world.applyImpulse(ring[3], 0, -20);
            world.step(DT, 10);
            assertThat(world.stats().awake()).isEqualTo(13);
            long support = beam.add(0, 0, 0.25f, Float.POSITIVE_INFINITY);
            long[] beads = new long[5];
            for (int k = 0; k < 5; k++) {
                beads[k] = beam.add(0.5f * (k + 1), 0, 0.25f, 1);
                beam.joints().add(k == 0 ? support : beads[k - 1], beads[k], Joint.weld());
            }
            sleepsLong(beam);
            beam.applyTorque(beads[4], 20);
            beam.step(DT, 1);
            beam.step(DT, 5);
            assertThat(beam.stats().awake()).as("a torque reaches the support").isEqualTo(5);
        }
    }
}
