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
            assertThat(world.bodies().isAwake(cart)).isTrue();
        }
    }

    // ---- bodies

    private static World.Builder wide() {
        return box().bounds(-50, 0, 50, 60).restitution(0);
    }

    private static void sleepAll(World world, int within) {
        for (int k = 0; k < within && world.bodies().awake() > 0; k++) {
            world.step(DT);
        }
        assertThat(world.bodies().awake()).isZero();
    }

    private static long[] pyramid(World world, int rows) {
        long[] crates = new long[rows * (rows + 1) / 2];
        int n = 0;
        for (int row = 0; row < rows; row++) {
            for (int k = 0; k < rows - row; k++) {
                crates[n++] = world.bodies().add(CRATE, 1.05f * k + 0.525f * row - 10, 0.5f + row, 0, 1);
            }
        }
        return crates;
    }

    @Test
    void aPyramidOfTwentyRowsSleepsWithinThreeSecondsAndStays() {
        try (World world = wide().build()) {
            Bodies bodies = world.bodies();
            long[] crates = pyramid(world, 20);
            float x = bodies.x(crates[209]);
            float y = bodies.y(crates[209]);
            world.step(DT);
            sleepAll(world, 179);
            double movedX = 0;
            double movedY = 0;
            for (int n = 0, row = 0; row < 20; row++) {
                for (int k = 0; k < 20 - row; k++, n++) {
                    movedX += bodies.x(crates[n]) - (1.05 * k + 0.525 * row - 10);
                    movedY += bodies.y(crates[n]) - (0.5 + row);
                }
            }
            assertThat(Math.hypot(movedX, movedY) / crates.length).isLessThan(0.01);
            world.step(DT); // in which the last one learns what it is out of balance
            long hash = world.hash();
            world.step(DT, 1000);
            assertThat(world.hash()).isEqualTo(hash);
            assertThat(Math.hypot(bodies.x(crates[209]) - x, bodies.y(crates[209]) - y))
                    .isLessThan(0.05);
            world.setGravity(0.2f, -10);
            world.step(DT);
            assertThat(bodies.awake()).as("tilted").isEqualTo(crates.length);
            world.setGravity(0, -10);
            sleepAll(world, 400);
            world.step(DT);
            world.setGravity(0, 0);
            world.step(DT);
            assertThat(bodies.awake()).as("without gravity").isEqualTo(crates.length);
        }
    }

    @Test
    void aBallWakesAPartOfAPyramidAndAllSleepAgain() {
        try (World world = wide().build()) {
            long[] crates = pyramid(world, 20);
            sleepAll(world, 300);
            world.add(0.3f, 22, 0.5f, 1);
            world.step(DT, 30);
            assertThat(world.bodies().awake()).as("before the hit").isZero();
            world.step(DT, 10);
            assertThat(world.bodies().awake()).as("after the hit").isBetween(3, crates.length / 2);
            world.step(DT, 500); // the ball rolls down the side
            assertThat(world.bodies().awake()).isZero();
        }
    }

    @Test
    void aCrateSleepsOnASlopeOnWhichItRestsAndNeverOnASteeperOne() {
        for (float more : new float[] {-0.005f, 0.005f}) {
            try (World world = wide().build()) {
                double slope = Math.atan(0.6) + more;
                world.setGravity((float) (10 * Math.sin(slope)), (float) (-10 * Math.cos(slope)));
                long crate = world.bodies().add(CRATE, -40, 0.5f, 0, 1);
                int asleep = 0;
                for (int k = 0; k < 400; k++) {
                    world.step(DT);
                    asleep += world.bodies().isAwake(crate) ? 0 : 1;
                }
                if (more > 0) {
                    assertThat(asleep).isZero();
                    assertThat(world.bodies().x(crate)).isGreaterThan(-39);
                } else {
                    assertThat(asleep).isGreaterThan(200);
                    assertThat(world.bodies().x(crate)).isCloseTo(-40, within(0.01f));
                }
            }
        }
    }

    @Test
    void aColumnFallsWithinTenStepsAfterItsSupportGoes() {
        try (World world = wide().build()) {
            long base = world.bodies().add(Outline.box(3, 1), 0, 0.5f, 0, 5);
            long[] column = new long[10];
            for (int k = 0; k < column.length; k++) {
                column[k] = world.bodies().add(CRATE, 0, 1.5f + k, 0, 1);
            }
            sleepAll(world, 400);
            world.bodies().remove(base);
            world.step(DT, 10);
            assertThat(world.bodies().vy(column[9])).isLessThan(-0.5f);
        }
    }

    @Test
    void aSeeSawInBalanceSleepsAndABallOnItsEndWakesIt() {
        try (World world = wide().build()) {
            long plank = world.bodies().add(Outline.box(4, 0.2f), 20, 3, 0, 2);
            long joint = world.joints().add(plank, 0, 0, 20, 3, Joint.pin());
            sleepAll(world, 120);
            world.step(DT, 100);
            assertThat(world.bodies().isAwake(plank)).isFalse();
            world.add(21.8f, 3.5f, 0.2f, 0.3f);
            world.step(DT, 60);
            assertThat(world.bodies().angle(plank)).isLessThan(-0.2f);
            world.joints().remove(joint);
            assertThat(world.bodies().isAwake(plank)).isTrue();
        }
    }

    @Test
    void hingesSleepAndAPullAtOneEndWakesTheOthers() {
        try (World world = wide().build()) {
            long[] chain = new long[4];
            Outline link = Outline.box(1, 0.2f);
            world.kind(0).setDamping(2).setAngularDamping(2);
            for (int k = 0; k < chain.length; k++) {
                chain[k] = world.bodies().add(link, 0, 20 - k, (float) (Math.PI / 2), 1);
                if (k == 0) {
                    world.joints().add(chain[0], 0.5f, 0, 0, 20.5f, Joint.pin());
                } else {
                    world.joints().add(chain[k - 1], -0.5f, 0, chain[k], 0.5f, 0, Joint.pin());
                }
            }
            sleepAll(world, 900);
            world.step(DT, 60);
            assertThat(world.bodies().awake()).isZero();
            world.bodies().applyImpulse(chain[3], 3, 0);
            world.step(DT, 20);
            assertThat(Math.abs(world.bodies().angularVelocity(chain[0]))).isGreaterThan(1e-3f);
        }
    }

    @Test
    void aTorqueThatIsSetHoldsOrWakes() {
        try (World world = wide().build()) {
            Bodies bodies = world.bodies();
            long crate = bodies.add(CRATE, 0, 0.5f, 0, 1);
            bodies.setTorque(crate, 2);
            sleepAll(world, 120);
            assertThat(bodies.angle(crate)).isCloseTo(0, within(1e-3f));
            bodies.setTorque(crate, 6);
            world.step(DT, 10);
            assertThat(bodies.angle(crate)).isGreaterThan(0.01f);
            bodies.setTorque(crate, 0);
            sleepAll(world, 300);
            bodies.applyForce(crate, 0, 20);
            world.step(DT);
            assertThat(bodies.vy(crate)).as("a force of one step").isGreaterThan(0.1f);
        }
    }

    @Test
    void aRowKeepsTheMomentumOfACrateThatHitsItSlowly() {
        try (World world = wide().friction(0).build()) {
            long[] row = new long[5];
            for (int k = 0; k < row.length; k++) {
                row[k] = world.bodies().add(CRATE, k, 0.5f, 0, 1);
            }
            sleepAll(world, 200);
            long crate = world.bodies().add(CRATE, -1.2f, 0.5f, 0, 1);
            world.bodies().setVelocity(crate, 0.1f, 0);
            for (int k = 0; k < 600; k++) {
                world.step(DT);
                float momentum = world.bodies().vx(crate);
                for (long each : row) {
                    momentum += world.bodies().vx(each);
                }
                assertThat(momentum).as("after step %d", k).isCloseTo(0.1f, within(0.001f));
            }
            assertThat(world.bodies().vx(row[4])).isGreaterThan(0.01f);
        }
    }

    @Test
    void circlesAndCratesSleepInOnePitWithEqualBitsOnAnyNumberOfThreads() {
        long hash = 0;
        for (int threads : new int[] {1, 2, 7}) {
            try (World world = WorldScenes.onThreads(threads, wide().bounds(0, 0, 12, 30))) {
                for (int k = 0; k < 60; k++) {
                    world.add(0.7f + k % 10 * 1.1f, 0.5f + k / 10, 0.4f, 0.5f);
                }
                for (int k = 0; k < 12; k++) {
                    world.bodies()
                            .add(k % 3 == 0 ? Outline.box(2, 0.5f) : CRATE, 1.5f + k % 4 * 3, 8 + k / 4 * 2, k, 1);
                }
                for (int k = 0;
                        k < 2400 && world.stats().awake() + world.bodies().awake() > 0;
                        k++) {
                    world.step(DT);
                }
                assertThat(world.stats().awake()).isZero();
                assertThat(world.bodies().awake()).isZero();
                world.bodies().remove(world.bodies().handle(0));
                world.step(DT, 100);
                hash = hash == 0 ? world.hash() : hash;
                assertThat(world.hash()).isEqualTo(hash);
            }
        }
    }

    @Test
    void whatCarriesABodyWakesItAsItGoesOrMoves() {
        try (World world = wide().build()) {
            Bodies bodies = world.bodies();
            TerrainBody lift = world.terrain().addBody(0, 2, 0);
            lift.addSegment(-2, 0, 2, 0, 0.1f, 0);
            long pedestal = world.add(20, 1, 1, Float.POSITIVE_INFINITY);
            long onLift = bodies.add(CRATE, 0, 2.65f, 0, 1);
            long onCircle = bodies.add(Outline.box(1, 0.2f), 20, 2.1f, 0, 1);
            long onWall = bodies.add(CRATE, -20, 0.5f, 0, 1);
            sleepAll(world, 200);
            lift.setVelocity(0, 0.5f);
            world.step(DT, 20);
            assertThat(bodies.y(onLift)).isGreaterThan(2.75f);
            assertThat(bodies.isAwake(onCircle)).isFalse();
            lift.setVelocity(0, 0);
            sleepAll(world, 200);
            world.setBounds(-50, 0.01f, 50, 60);
            world.step(DT, 2);
            assertThat(bodies.isAwake(onWall)).isTrue();
            assertThat(bodies.isAwake(onCircle)).isFalse();
            sleepAll(world, 200);
            world.setPosition(pedestal, 20, 1.01f);
            world.step(DT, 2);
            assertThat(bodies.isAwake(onCircle)).isTrue();
            sleepAll(world, 200);
            world.remove(pedestal);
            assertThat(bodies.isAwake(onCircle)).isTrue();
            assertThat(bodies.isAwake(onLift)).isFalse();
            world.kind(3).setSleeps(false);
            bodies.setKind(onWall, 3);
            world.step(DT, 200);
            assertThat(bodies.awake()).isEqualTo(1);
            bodies.wake(onLift);
            assertThat(bodies.isAwake(onLift)).isTrue();
            world.wakeAll();
            assertThat(bodies.awake()).isEqualTo(3);
        }
    }

    @Test
    void eventsAreAsIfNobodySlept() {
        try (World world = wide().build()) {
            Bodies bodies = world.bodies();
            bodies.report(true);
            long lower = bodies.add(CRATE, 0, 0.5f, 0, 1);
            bodies.add(CRATE, 0, 1.5f, 0, 1);
            long ball = world.add(20, 0.5f, 0.5f, 1);
            world.kind(1).setSleeps(false);
            world.setKind(ball, 1);
            sleepAll(world, 200);
            bodies.events();
            world.step(DT, 100);
            BodyEvents quiet = bodies.events();
            assertThat(quiet.size()).isZero();
            bodies.wake(lower);
            world.step(DT, 200);
            assertThat(bodies.awake()).isZero();
            assertThat(bodies.events().size()).isZero();
            bodies.remove(lower);
            world.step(DT);
            assertThat(bodies.events().size()).isEqualTo(2);
        }
    }

    @Test
    void theEndOfForcesOfAStepIsNoticed() {
        try (World world = box().bounds(0, 0, 20, 10).build()) {
            long crate = world.bodies().add(CRATE, 5, 9.5f, 0, 2);
            for (int k = 0; k < 240; k++) {
                world.bodies().applyForce(crate, 0, 40);
                world.step(DT);
            }
            assertThat(world.bodies().isAwake(crate)).isFalse();
            world.step(DT, 60);
            assertThat(world.bodies().y(crate)).isLessThan(6);
        }
    }

    @Test
    void aCrateThatTumblesIsFeltByACrateThatSleeps() {
        double most = 0;
        try (World world = box().build()) {
            long crate = world.bodies().add(CRATE, 10, 0.5f, 0, 2);
            world.step(DT, 100);
            assertThat(world.bodies().isAwake(crate)).isFalse();
            long tumbling = world.bodies().add(CRATE, 7, 1.73f, 4.46f, 2);
            world.bodies().setVelocity(tumbling, 7.6f, 0);
            world.bodies().setAngularVelocity(tumbling, 10);
            for (int k = 0; k < 90; k++) {
                world.step(DT);
                most = Math.max(most, world.bodies().vx(crate));
            }
        }
        assertThat(most).isGreaterThan(2);
    }

    @Test
    void whatAWallTakesAlongWakesABodyThatLiesOnIt() {
        try (World world = box().build()) {
            long post = world.add(10, 0.8f, 0.8f, Float.POSITIVE_INFINITY);
            long plank = world.bodies().add(Outline.box(6, 0.3f), 10, 1.75f, 0, 3);
            world.step(DT, 120);
            assertThat(world.bodies().isAwake(plank)).isFalse();
            for (int k = 0; k <= 140; k++) {
                world.setBounds(0, k * 0.01f, 20, 20);
                world.step(DT);
            }
            assertThat(world.y(post)).isGreaterThan(1.3f);
            assertThat(world.bodies().y(plank)).isCloseTo(world.y(post) + 0.95f, within(0.15f));
        }
    }

    @Test
    void iceUnderACrateLetsItGo() {
        for (boolean sleeps : new boolean[] {false, true}) {
            try (World world = box().sleep(sleeps).build()) {
                long crate = world.bodies().add(CRATE, 5, 0.5f, 0, 2);
                world.bodies().setForce(crate, 5, 0);
                world.step(DT, 240);
                world.setWallSurface(Wall.MIN_Y, 0, 0, 0);
                world.step(DT, 60);
                assertThat(world.bodies().x(crate)).isCloseTo(6.25f, within(0.05f));
            }
        }
    }
}
