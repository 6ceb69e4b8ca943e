package io.github.circles2d;

import static io.github.circles2d.Refusals.assertIllegalArgument;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;

import java.nio.ByteBuffer;
import java.util.Arrays;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

/** What forces and kinds do to the motion of circles. */
class WorldForcesTest {
    private static final float STEP = 1 / 60f;

    private final World world = world();

    private static World world() {
        return WorldScenes.jvm().bounds(0, 0, 1000, 1000).gravity(0, -10).build();
    }

    @AfterEach
    void close() {
        world.close();
    }

    @Test
    void aKindScalesGravity() {
        float[] scales = {1, 0, 0.5f, -2};
        for (int k = 0; k < scales.length; k++) {
            world.kind(k).setGravityScale(scales[k]);
            world.add(100 + 10 * k, 500, 1, 1 + k, 0, 0, k);
        }
        world.step(STEP, 60);
        long[] handles = new long[scales.length];
        world.readHandles(handles);
        for (int k = 0; k < scales.length; k++) {
            assertThat(world.vy(handles[k])).isCloseTo(-10 * scales[k], within(1e-3f));
            assertThat(world.y(handles[k])).isCloseTo(500 - 5 * scales[k], within(0.05f));
        }
    }

    @Test
    void dampingTakesAShareOfTheVelocityAway() {
        world.setGravity(0, 0);
        world.kind(1).setDamping(0.5f);
        long ball = world.add(100, 500, 1, 1, 40, 0, 1);
        world.step(STEP, 120);
        assertThat(world.vx(ball)).isCloseTo((float) (40 * Math.exp(-1)), within(0.1f));
        assertThat(world.x(ball)).isCloseTo((float) (100 + 80 * (1 - Math.exp(-1))), within(0.2f));
    }

    @Test
    void aCircleIsNoFasterThanItsKind() {
        world.kind(1).setGreatestSpeed(5);
        long falling = world.add(100, 900, 1, 1, 0, 0, 1);
        long shot = world.add(300, 900, 1, 1, 300, 400, 1);
        world.step(STEP);
        assertThat((float) Math.hypot(world.vx(shot), world.vy(shot))).isCloseTo(5, within(0.1f));
        assertThat(world.vx(shot)).isCloseTo(3, within(0.2f));
        assertThat(world.x(shot)).isCloseTo(300 + 3 * STEP, within(0.01f));
        for (int k = 0; k < 200; k++) {
            world.step(STEP);
            assertThat(-world.vy(falling)).isLessThanOrEqualTo(5.001f);
        }
        assertThat(-world.vy(falling)).isCloseTo(5, within(0.01f));
    }

    @Test
    void oneCircleFallsByItsOwnScaleWhateverItsKindHas() {
        world.kind(1).setGravityScale(3);
        float[] scales = {1, 0, -1, -0.5f};
        long[] balls = new long[scales.length];
        for (int k = 0; k < scales.length; k++) {
            balls[k] = world.add(100 + 10 * k, 500, 1, 1 + k, 0, 0, k % 2);
            world.setGravityScale(balls[k], scales[k]);
        }
        long other = world.add(200, 500, 1, 1, 0, 0, 1);
        world.step(STEP, 60);
        for (int k = 0; k < scales.length; k++) {
            assertThat(world.vy(balls[k])).isCloseTo(-10 * scales[k], within(1e-3f));
            assertThat(world.y(balls[k])).isCloseTo(500 - 5 * scales[k], within(0.05f));
        }
        assertThat(world.y(balls[1])).isEqualTo(500);
        assertThat(world.vy(other)).isCloseTo(-30, within(1e-2f));
        world.setGravityScale(balls[1], Float.NaN);
        world.step(STEP, 60);
        assertThat(world.vy(balls[1])).isCloseTo(-30, within(1e-2f));
    }

    /** By the specification a sub-step leaves 1 / (1 + damping * h) of the velocity. */
    @Test
    void oneCircleIsSlowedByItsOwnDamping() {
        world.setGravity(0, 0);
        world.kind(1).setDamping(7);
        long ball = world.add(100, 500, 1, 1, 40, 0, 1);
        long other = world.add(100, 600, 1, 1, 40, 0, 0);
        world.setDamping(ball, 0.5f);
        world.step(STEP, 120);
        int subSteps = 120 * world.subSteps();
        double left = Math.pow(1 / (1 + 0.5 * 2 / subSteps), subSteps);
        assertThat(world.vx(ball)).isCloseTo((float) (40 * left), within(1e-3f));
        assertThat(world.vx(ball)).isCloseTo((float) (40 * Math.exp(-1)), within(0.1f));
        assertThat(world.x(ball)).isCloseTo((float) (100 + 80 * (1 - left)), within(0.01f));
        assertThat(world.vx(other)).isEqualTo(40);
        assertThat(world.x(other)).isCloseTo(180, within(0.01f));
    }

    @Test
    void oneCircleIsNoFasterThanItsOwnGreatestSpeed() {
        world.kind(1).setGreatestSpeed(50);
        long shot = world.add(300, 900, 1, 1, 300, 400, 1);
        long falling = world.add(100, 900, 1, 1, 0, 0, 1);
        long free = world.add(500, 900, 1, 1, 0, -100, 1);
        world.setGreatestSpeed(shot, 5);
        world.setGreatestSpeed(falling, 5);
        world.setGreatestSpeed(free, Float.POSITIVE_INFINITY);
        world.step(STEP);
        assertThat((float) Math.hypot(world.vx(shot), world.vy(shot))).isCloseTo(5, within(0.1f));
        assertThat(world.x(shot)).isCloseTo(300 + 3 * STEP, within(0.01f));
        world.step(STEP, 119);
        assertThat(-world.vy(falling)).isCloseTo(5, within(0.01f));
        assertThat(-world.vy(free)).isCloseTo(120, within(0.01f));
    }

    /** One circle with values of its own moves to the bit as one of a kind that has them. */
    @Test
    void valuesOfOneCircleDoWhatThoseOfAKindDo() {
        long hash = 0;
        for (boolean ofKind : new boolean[] {true, false}) {
            try (World other = world()) {
                other.kind(1).setGravityScale(-0.5f).setDamping(1.5f).setGreatestSpeed(12);
                other.kind(2).setMask(-1);
                for (int k = 0; k < 300; k++) {
                    long ball = other.add(50 + k % 20 * 2.5f, 3 + k / 20 * 2.5f, 1, 1 + k % 3, k % 7 * 20 - 60, 0, 1);
                    if (k % 3 == 0 && !ofKind) {
                        other.setGravityScale(ball, 2);
                        other.setDamping(ball, 0.3f);
                        other.setGreatestSpeed(ball, 40);
                    } else if (k % 3 == 0) {
                        other.kind(2).setGravityScale(2).setDamping(0.3f).setGreatestSpeed(40);
                        other.setKind(ball, 2);
                    }
                }
                other.step(STEP, 240);
                float[] circles = new float[4 * other.size()];
                other.read(circles);
                long sum = Arrays.hashCode(circles);
                assertThat(ofKind || sum == hash).isTrue();
                hash = sum;
            }
        }
    }

    @Test
    void valuesOfOneCircleAreInSnapshotsAndTheHashAndNotWithTheNextCircleOfAnId() {
        long ball = world.add(100, 500, 1, 2);
        long hash = world.hash();
        int plain = world.snapshotBytes();
        assertThat(world.gravityScale(ball)).isEqualTo(1);
        assertThat(world.damping(ball)).isZero();
        assertThat(world.greatestSpeed(ball)).isEqualTo(Float.POSITIVE_INFINITY);
        world.setGravityScale(ball, -0f);
        world.setDamping(ball, 2);
        world.setGreatestSpeed(ball, 3);
        assertThat(world.gravityScale(ball)).isZero();
        assertThat(world.hash()).isNotEqualTo(hash);
        assertThat(world.snapshotBytes()).isEqualTo(plain + 3 * (8 + 1 + 4));
        ByteBuffer snapshot = ByteBuffer.allocate(world.snapshotBytes());
        world.snapshot(snapshot);
        world.setVelocity(ball, 10, 0);
        world.step(STEP, 3);
        long after = world.hash();
        try (World other = world()) {
            other.restore(snapshot.flip());
            assertThat(other.damping(ball)).isEqualTo(2);
            other.setVelocity(ball, 10, 0);
            other.step(STEP, 3);
            assertThat(other.hash()).isEqualTo(after);
        }
        world.restore(snapshot.rewind());
        world.setGravityScale(ball, Float.NaN);
        world.setDamping(ball, Float.NaN);
        world.setGreatestSpeed(ball, Float.NaN);
        assertThat(world.hash()).isEqualTo(hash);
        world.setDamping(ball, 2);
        world.remove(ball);
        long next = world.add(100, 500, 1, 2);
        assertThat((int) next).isEqualTo((int) ball);
        assertThat(world.damping(next)).isZero();
        assertThat(world.hash()).isEqualTo(hash);
    }

    /** A free bounce off a static circle leaves out half a sub-step of what accelerates the ball, which is not gravity here. */
    @Test
    void elasticBallsOnAStaticCircleKeepTheirHeightWhateverAcceleratesThem() {
        world.setGravity(0, -10);
        world.kind(1).setGravityScale(3);
        world.kind(2).setGravityScale(0);
        world.kind(3).setGravityScale(0.2f);
        for (int k = 0; k < 4; k++) {
            world.add(100 + 100 * k, 100, 10, Float.POSITIVE_INFINITY);
        }
        long[] balls = new long[4];
        for (int k = 0; k < 4; k++) {
            balls[k] = world.add(100 + 100 * k, 121, 1, 2, 0, 0, k);
            world.setRestitution(balls[k], 1);
        }
        world.setForce(balls[2], 0, -14);
        float[] highest = new float[4];
        for (int k = 0; k < 6000; k++) {
            world.step(STEP);
            for (int b = 0; b < 4; b++) {
                highest[b] = k < 5000 ? 0 : Math.max(highest[b], world.y(balls[b]));
            }
        }
        for (int b = 0; b < 4; b++) {
            assertThat(highest[b]).as("ball %d", b).isCloseTo(121, within(0.4f));
        }
    }

    @Test
    void aForceActsUntilItIsChanged() {
        world.setGravity(0, 0);
        long light = world.add(100, 500, 1, 2);
        long heavy = world.add(200, 500, 1, 20);
        long post = world.add(300, 500, 1, Float.POSITIVE_INFINITY);
        for (long circle : new long[] {light, heavy, post}) {
            world.setForce(circle, 4, -2);
        }
        world.step(STEP, 60);
        assertThat(world.vx(light)).isCloseTo(2, within(1e-3f));
        assertThat(world.vy(light)).isCloseTo(-1, within(1e-3f));
        assertThat(world.vx(heavy)).isCloseTo(0.2f, within(1e-3f));
        assertThat(world.vx(post)).isZero();
        assertThat(world.forceX(light)).isEqualTo(4);
        assertThat(world.forceY(light)).isEqualTo(-2);
        world.setForce(light, 0, 0);
        float vx = world.vx(light);
        world.step(STEP, 60);
        assertThat(world.vx(light)).isEqualTo(vx);
    }

    @Test
    void anAppliedForceActsInOneStepHoweverManyAreMade() {
        world.setGravity(0, 0);
        long ball = world.add(100, 500, 1, 2);
        world.applyForce(ball, 100, 0);
        world.applyForce(ball, 20, 60);
        assertThat(world.forceX(ball)).isZero();
        world.step(STEP, 10);
        assertThat(world.vx(ball)).isCloseTo(60 * STEP, within(1e-4f));
        assertThat(world.vy(ball)).isCloseTo(30 * STEP, within(1e-4f));
        world.step(STEP);
        assertThat(world.vx(ball)).isCloseTo(60 * STEP, within(1e-4f));
        world.setForce(ball, 0, 6);
        world.applyForce(ball, 0, -6);
        float vy = world.vy(ball);
        world.step(STEP);
        assertThat(world.vy(ball)).isEqualTo(vy);
        world.step(STEP);
        assertThat(world.vy(ball)).isCloseTo(vy + 3 * STEP, within(1e-4f));
    }

    @Test
    void aForceThatWaitsIsInSnapshotsAndTheHashAndNotWithTheNextCircleOfAnId() {
        long ball = world.add(100, 500, 1, 2);
        long hash = world.hash();
        int plain = world.snapshotBytes();
        world.setForce(ball, 1, 2);
        world.applyForce(ball, 30, 0);
        assertThat(world.hash()).isNotEqualTo(hash);
        ByteBuffer snapshot = ByteBuffer.allocate(world.snapshotBytes());
        world.snapshot(snapshot);
        world.step(STEP, 3);
        long after = world.hash();
        try (World other = world()) {
            other.restore(snapshot.flip());
            other.step(STEP);
            other.step(STEP, 2);
            assertThat(other.hash()).isEqualTo(after);
        }
        world.restore(snapshot.rewind());
        world.remove(ball);
        long next = world.add(100, 500, 1, 2);
        assertThat((int) next).isEqualTo((int) ball);
        assertThat(world.forceX(next)).isZero();
        assertThat(world.hash()).isEqualTo(hash);
        world.step(STEP);
        assertThat(world.vx(next)).isZero();
        assertThat(world.snapshotBytes()).isEqualTo(plain + 1);
    }

    @Test
    void whatIsAsAtFirstChangesNoBit() {
        try (World other = world()) {
            for (World each : new World[] {world, other}) {
                each.setGravity(-0f, -10);
                for (int k = 0; k < 200; k++) {
                    each.add(50 + k % 20, 50 + 2.1f * (k / 20), 1, 1 + k % 3, k % 5 == 0 ? -0f : k % 7 * 20 - 60, 0);
                }
            }
            // One of the worlds looks at kinds and forces in each step: some kind, and some circle once, have others.
            other.kind(9).setDamping(3).setMask(0);
            long[] handles = new long[200];
            other.readHandles(handles);
            other.setForce(handles[3], 5, 5);
            other.applyForce(handles[4], 5, 5);
            other.applyForce(handles[4], -5, -5);
            other.setGroup(handles[5], 7);
            other.setForce(handles[3], 0, -0f);
            other.setGroup(handles[5], 0);
            for (int k = 0; k < 30; k++) {
                world.step(STEP, 5);
                other.step(STEP, 5);
                other.kind(9).setDamping(0).setMask(-1);
                assertThat(other.hash()).isEqualTo(world.hash());
                other.kind(9).setDamping(3).setMask(0);
            }
        }
    }

    @Test
    void badValuesAreNamed() {
        long ball = world.add(100, 500, 1, 2);
        assertIllegalArgument("force x is -Infinity", () -> world.setForce(ball, Float.NEGATIVE_INFINITY, 0));
        assertIllegalArgument("force y is NaN", () -> world.applyForce(ball, 0, Float.NaN));
        assertThatIllegalArgumentException().isThrownBy(() -> world.applyForce(99, 0, 0));
        assertIllegalArgument("gravity scale is 1001", () -> world.kind(1).setGravityScale(1001));
        assertIllegalArgument("damping is -1", () -> world.kind(1).setDamping(-1));
        assertIllegalArgument("greatest speed is NaN", () -> world.kind(1).setGreatestSpeed(Float.NaN));
        assertIllegalArgument("gravity scale is -1001", () -> world.setGravityScale(ball, -1001));
        assertIllegalArgument("damping is -1", () -> world.setDamping(ball, -1));
        assertIllegalArgument("greatest speed is -1", () -> world.setGreatestSpeed(ball, -1));
        assertThatIllegalArgumentException().isThrownBy(() -> world.setDamping(99, 0));
        assertThatIllegalArgumentException().isThrownBy(() -> world.greatestSpeed(99));
        assertThat(world.kind(1).gravityScale()).isEqualTo(1);
        assertThat(world.kind(1).damping()).isZero();
        assertThat(world.kind(1).greatestSpeed()).isEqualTo(Float.POSITIVE_INFINITY);
    }
}
