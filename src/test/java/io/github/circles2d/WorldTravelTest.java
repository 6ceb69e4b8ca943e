package io.github.circles2d;

import static io.github.circles2d.Refusals.assertIllegalArgument;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.ByteBuffer;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Static circles that setPosition moves travel in the next step; teleport puts them elsewhere at once. */
class WorldTravelTest {
    private static final float STEP = 1 / 60f;

    private final World world =
            WorldScenes.jvm().bounds(0, 0, 40, 40).restitution(0.5f).build();
    private final long paddle = world.add(10, 10, 1, Float.POSITIVE_INFINITY, 3, 0);

    @AfterEach
    void close() {
        world.close();
    }

    private void assertIsAt(float x, float y) {
        assertThat(world.x(paddle)).isEqualTo(x);
        assertThat(world.y(paddle)).isEqualTo(y);
    }

    @Test
    void readsGiveTheOldPlaceUntilTheStepAndThenExactlyTheNewOne() {
        world.setPosition(paddle, 11.3f, 10.7f);
        assertIsAt(10, 10);
        world.step(STEP);
        assertIsAt(11.3f, 10.7f);
    }

    @Test
    void theOwnVelocityComesBackAfterTheStep() {
        world.setPosition(paddle, 12, 10);
        world.step(STEP);
        assertIsAt(12, 10);
        assertThat(world.vx(paddle)).isEqualTo(3);
        assertThat(world.vy(paddle)).isZero();
        world.step(STEP);
        assertThat(world.x(paddle)).isBetween(12.0499f, 12.0501f);
    }

    @Test
    void theFirstOfSeveralStepsEndsTheWay() {
        world.setVelocity(paddle, 0, 0);
        world.setPosition(paddle, 12, 14);
        world.step(STEP, 3);
        assertIsAt(12, 14);
    }

    @Test
    void aVelocityThatIsSetMeanwhileBeginsAfterTheStep() {
        world.setPosition(paddle, 12, 10);
        world.setVelocity(paddle, 0, 6);
        world.step(STEP);
        assertIsAt(12, 10);
        assertThat(world.vy(paddle)).isEqualTo(6);
    }

    @Test
    void theLastOfSeveralCallsCounts() {
        world.setPosition(paddle, 20, 20);
        world.setPosition(paddle, 12, 10);
        world.step(STEP);
        assertIsAt(12, 10);
    }

    /** Two worlds, one of which has been told of the first target too, have the same future. */
    @Test
    void whatIsReplacedLeavesNoTrace() {
        try (World other =
                WorldScenes.jvm().bounds(0, 0, 40, 40).restitution(0.5f).build()) {
            other.add(10, 10, 1, Float.POSITIVE_INFINITY, 3, 0);
            world.setPosition(paddle, 20, 20);
            assertThat(world.hash()).isNotEqualTo(other.hash());
            world.teleport(paddle, 10, 10);
            assertThat(world.hash()).isEqualTo(other.hash());
            world.setPosition(paddle, 12, 10);
            other.setPosition(paddle, 12, 10);
            world.step(STEP);
            other.step(STEP);
            assertThat(world.hash()).isEqualTo(other.hash());
        }
    }

    @Test
    void itPushesWhatIsInItsWay() {
        long ball = world.add(12, 10, 0.4f, 1);
        for (int step = 1; step <= 10; step++) {
            world.setPosition(paddle, 10 + 2f * step, 10);
            world.step(STEP);
            assertThat(world.x(ball)).isGreaterThan(world.x(paddle) + 1.3f);
        }
        assertThat(world.vx(ball)).isGreaterThanOrEqualTo(0.9f * 2 / STEP);
    }

    @ParameterizedTest
    @CsvSource({"0.1, 0", "0.5, 0.2", "1, -0.3", "2, 0.4", "10, 0.4"})
    void noBallComesBehindIt(float way, float aside) {
        long ball = world.add(11.5f, 10 + aside, 0.4f, 1);
        for (int step = 1; step <= 25 / way; step++) {
            world.setPosition(paddle, 10 + way * step, 10);
            world.step(STEP);
            assertThat(world.x(ball)).isGreaterThan(world.x(paddle));
        }
    }

    @Test
    void teleportIsThereAtOnceAndPassesWhatLiesBetween() {
        long ball = world.add(15, 10, 0.4f, 1);
        world.setVelocity(paddle, 0, 0);
        world.setPosition(paddle, 30, 30);
        world.teleport(paddle, 20, 10);
        assertIsAt(20, 10);
        world.step(STEP);
        assertIsAt(20, 10);
        assertThat(world.x(ball)).isEqualTo(15);
    }

    @Test
    void aCircleThatIsNotStaticIsThereAtOnce() {
        long ball = world.add(15, 10, 0.4f, 1, 2, 3);
        world.setPosition(ball, 20, 30);
        assertThat(world.x(ball)).isEqualTo(20);
        world.teleport(ball, 21, 31);
        assertThat(world.y(ball)).isEqualTo(31);
        assertThat(world.vx(ball)).isEqualTo(2);
    }

    @Test
    void aCircleThatIsNoLongerStaticIsThereAtOnce() {
        world.setPosition(paddle, 20, 20);
        world.setMass(paddle, 1);
        assertIsAt(20, 20);
        world.step(STEP);
        assertThat(world.x(paddle)).isBetween(20.04f, 20.06f);
    }

    @Test
    void aCircleThatBecomesStaticTravels() {
        long ball = world.add(15, 20, 0.4f, 1);
        world.setMass(ball, Float.POSITIVE_INFINITY);
        world.setPosition(ball, 20, 30);
        assertThat(world.x(ball)).isEqualTo(15);
        world.step(STEP);
        assertThat(world.x(ball)).isEqualTo(20);
    }

    @Test
    void newBoundsBringThePlaceInside() {
        world.setPosition(paddle, 35, 10);
        world.setBounds(0, 0, 30, 40);
        world.step(STEP);
        assertIsAt(30, 10);
    }

    @Test
    void aCircleThatTakesThePlaceOfARemovedOneStaysWhereItIs() {
        world.setPosition(paddle, 20, 20);
        world.remove(paddle);
        long next = world.add(5, 5, 1, Float.POSITIVE_INFINITY);
        assertThat((int) next).isEqualTo((int) paddle);
        world.step(STEP);
        assertThat(world.x(next)).isEqualTo(5);
        world.setPosition(next, 6, 5);
        world.step(STEP);
        assertThat(world.x(next)).isEqualTo(6);
    }

    @Test
    void aSnapshotHoldsTheWay() {
        world.add(12, 10, 0.4f, 1);
        world.setPosition(paddle, 13, 10);
        ByteBuffer snapshot = ByteBuffer.allocate(world.snapshotBytes());
        world.snapshot(snapshot);
        long hash = world.hash();
        world.step(STEP);
        long after = world.hash();
        world.teleport(paddle, 1, 1);
        world.restore(snapshot.flip());
        assertThat(world.hash()).isEqualTo(hash);
        assertIsAt(10, 10);
        world.step(STEP);
        assertThat(world.hash()).isEqualTo(after);
    }

    @Test
    void aPlaceOutsideIsRefused() {
        assertIllegalArgument("41", () -> world.setPosition(paddle, 41, 10));
        assertThatThrownBy(() -> world.teleport(paddle, Float.NaN, 10)).isInstanceOf(IllegalArgumentException.class);
        world.setVelocity(paddle, 0, 0);
        world.step(STEP);
        assertIsAt(10, 10);
    }
}
