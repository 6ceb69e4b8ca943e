package io.github.circles2d;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.nio.ByteBuffer;
import org.junit.jupiter.api.Test;

/** Sleep in worlds with bodies, as a user sees it. {@link ReferenceSleepTest} has the rule. */
class WorldBodySleepTest {
    private static final float DT = 1 / 60f;
    private static final Outline CRATE = Outline.box(1, 1);

    private static World.Builder box() {
        return WorldScenes.jvm()
                .bounds(0, 0, 20, 20)
                .gravity(0, -10)
                .friction(0.6f)
                .rollingResistance(0.05f)
                .sleep(true);
    }

    private static void sleepsWithin(World world, long circle, int steps) {
        for (int k = 0; k < steps && world.isAwake(circle); k++) {
            world.step(DT);
        }
        assertThat(world.isAwake(circle)).isFalse();
    }

    @Test
    void aCircleSleepsOnACrateAndFallsAsThatGoes() {
        try (World world = box().build()) {
            long crate = world.bodies().add(CRATE, 5, 0.5f, 0, 1);
            long ball = world.add(5, 1.25f, 0.25f, 0.2f);
            long beside = world.add(15, 0.25f, 0.25f, 0.2f);
            sleepsWithin(world, ball, 120);
            sleepsWithin(world, beside, 120);
            world.step(DT, 600);
            assertThat(world.isAwake(ball)).isFalse();
            assertThat(world.y(ball)).isCloseTo(1.25f, within(0.01f));
            world.bodies().remove(crate);
            assertThat(world.isAwake(ball)).isTrue();
            assertThat(world.isAwake(beside)).isFalse();
            world.step(DT, 60);
            assertThat(world.y(ball)).isLessThan(0.5f);
        }
    }

    @Test
    void aCrateThatIsPushedAwayOrComesWakesWhoItTouchesAlone() {
        try (World world = box().build()) {
            long crate = world.bodies().add(CRATE, 5, 0.5f, 0, 1);
            long ball = world.add(5, 1.25f, 0.25f, 0.2f);
            long inItsWay = world.add(9, 0.25f, 0.25f, 0.2f);
            long beside = world.add(18, 0.25f, 0.25f, 0.2f);
            world.step(DT, 120);
            assertThat(world.stats().awake()).isZero();
            world.bodies().setVelocity(crate, 9, 0);
            world.step(DT, 3);
            assertThat(world.isAwake(ball)).as("on the crate").isTrue();
            assertThat(world.isAwake(inItsWay)).isFalse();
            world.step(DT, 60);
            assertThat(world.x(inItsWay)).isGreaterThan(9.5f);
            assertThat(world.isAwake(beside)).isFalse();
        }
    }

    @Test
    void whoACrateHitsSlowlyTakesItsMomentum() {
        try (World world = WorldScenes.jvm()
                .bounds(0, 0, 20, 20)
                .gravity(0, -10)
                .restitution(0)
                .sleep(true)
                .build()) {
            long[] row = new long[5];
            for (int k = 0; k < row.length; k++) {
                row[k] = world.add(8 + k, 0.5f, 0.5f, 1);
            }
            world.step(DT, 120);
            assertThat(world.stats().awake()).isZero();
            long crate = world.bodies().add(Outline.capsule(0.5f, 0.5f), 6.5f, 0.5f, 0, 1);
            world.bodies().setVelocity(crate, 0.1f, 0);
            float most = 0;
            for (int k = 0; k < 900; k++) {
                world.step(DT);
                float momentum = world.bodies().vx(crate);
                for (long ball : row) {
                    momentum += world.vx(ball);
                }
                assertThat(momentum).as("after step %d", k).isCloseTo(0.1f, within(0.001f));
                most = Math.max(most, world.vx(row[4]));
            }
            assertThat(most).as("the last one").isGreaterThan(0.015f);
        }
    }

    @Test
    void callsOnABodyWakeWhoIsNearAndASnapshotBringsItAlong() {
        try (World world = box().build()) {
            Bodies bodies = world.bodies();
            long ball = world.add(5, 0.25f, 0.25f, 0.2f);
            long far = world.add(15, 0.25f, 0.25f, 0.2f);
            long crate = bodies.add(CRATE, 10, 0.5f, 0, 1);
            world.step(DT, 120);
            assertThat(world.stats().awake()).isZero();
            long[] added = new long[1];
            Runnable[] calls = {
                () -> bodies.teleport(crate, 5.9f, 0.5f, 0),
                () -> bodies.setKind(crate, 1),
                () -> bodies.setGroup(crate, 1),
                () -> bodies.teleport(crate, 10, 0.5f, 0),
                () -> added[0] = bodies.add(CRATE, 5.9f, 0.5f, 0, 1),
                () -> bodies.remove(added[0])
            };
            for (int k = 0; k < calls.length; k++) {
                calls[k].run();
                ByteBuffer saved = ByteBuffer.allocate(world.snapshotBytes());
                world.snapshot(saved);
                assertThat(world.isAwake(ball)).as("call %d", k).isTrue();
                assertThat(world.isAwake(far)).as("call %d", k).isFalse();
                world.step(DT, 200);
                long hash = world.hash();
                assertThat(world.isAwake(ball)).isFalse();
                world.restore(saved.flip());
                assertThat(world.isAwake(ball)).isTrue();
                world.step(DT, 200);
                assertThat(world.hash()).isEqualTo(hash);
            }
            bodies.clear();
            assertThat(world.isAwake(far)).isTrue();
        }
    }

    @Test
    void aCircleThatAJointHoldsToABodyStaysAwake() {
        try (World world = box().build()) {
            long cart = world.bodies().add(Outline.box(2, 0.4f), 5, 1, 0, 2);
            long wheel = world.add(4.2f, 0.5f, 0.5f, 1);
            world.joints().add(cart, -0.8f, -0.5f, wheel, Joint.pin());
            world.step(DT, 300);
            assertThat(world.isAwake(wheel)).isTrue();
        }
    }
}
