package io.github.circles2d;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Random;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Static circles that move push ahead what they meet, crowds too, and never pass through it. */
class WorldKinematicTest {
    private static final float STEP = 1 / 60f;
    private static final float R = 0.5f;
    private static final int POSTS = 20;
    private static final int BALLS = 120;

    @ParameterizedTest
    @CsvSource({"0.5, 0.2, 2", "0.5, 1, 2", "0.5, 2, 4", "0, 5, 2", "0.5, 10, 4", "0.9, 10, 2"})
    void aFenceLeavesNoneOfACrowdBehind(float restitution, float radiiPerStep, int seeds) {
        for (int seed = 1; seed <= seeds; seed++) {
            assertThat(leftBehind(1, radiiPerStep, restitution, seed, false))
                    .as("balls behind the fence, seed %d", seed)
                    .isZero();
        }
    }

    @ParameterizedTest
    @CsvSource({"0.3, 0.5", "0.3, 2", "0.3, 10"})
    void aFenceLeavesNoSmallBallsBehind(float radius, float radiiPerStep) {
        assertThat(leftBehind(radius, radiiPerStep, 0.5f, 5, false)).isZero();
    }

    @ParameterizedTest
    @ValueSource(floats = {0.2f, 2, 5})
    void aFenceThatSetPositionMovesLeavesNoneBehind(float radiiPerStep) {
        assertThat(leftBehind(1, radiiPerStep, 0.5f, 6, true)).isZero();
    }

    @ParameterizedTest
    @CsvSource({"0, 1", "0, 2", "0.5, 5", "0.9, 1", "0.9, 2", "1, 5"})
    @Tag("exhaustive")
    void aFenceLeavesNoneBehindForManySeeds(float restitution, float radiiPerStep) {
        for (int seed = 10; seed < 30; seed++) {
            assertThat(leftBehind(1, radiiPerStep, restitution, seed, seed % 2 == 0))
                    .as("balls behind the fence, seed %d", seed)
                    .isZero();
        }
    }

    /**
     * Twenty static circles side by side, from wall to wall, rise by 60 radii through balls at rest, of which some touch.
     *
     * @param size mean radius of the balls, in radii of the posts
     * @return the balls that are below the fence at the end
     */
    private static int leftBehind(float size, float radiiPerStep, float restitution, int seed, boolean dragged) {
        Random random = new Random(seed);
        int steps = (int) Math.ceil(60 / radiiPerStep);
        float way = radiiPerStep * R;
        try (World world = WorldScenes.jvm()
                .bounds(0, 0, 2 * R * POSTS, 100)
                .restitution(restitution)
                .build()) {
            long[] posts = new long[POSTS];
            for (int i = 0; i < POSTS; i++) {
                posts[i] = world.add(R + 2 * R * i, 1, R, Float.POSITIVE_INFINITY, 0, dragged ? 0 : way / STEP);
            }
            for (int i = 0; i < BALLS; i++) {
                float r = size * R * (0.8f + 0.4f * random.nextFloat());
                float x = 1.2f + 1.03f * (i % 18) + 0.05f * random.nextFloat();
                world.add(x, 2.3f + 1.1f * (i / 18) + 0.1f * random.nextFloat(), r, r * r);
            }
            for (int step = 1; step <= steps; step++) {
                for (int i = 0; i < POSTS && dragged; i++) {
                    world.setPosition(posts[i], R + 2 * R * i, 1 + step * way);
                }
                world.step(STEP);
            }
            float[] circles = new float[4 * world.size()];
            world.read(circles);
            int behind = 0;
            for (int i = 0; i < BALLS; i++) {
                behind += circles[4 * (POSTS + i) + 1] < circles[1] ? 1 : 0;
            }
            return behind;
        }
    }

    /** A ball rests on the way of a fast paddle, held by a fixed static circle on its other side: it is the paddle that wins. */
    @Test
    void aBallThatStopsAtAnotherIsTakenAlongAllTheSame() {
        try (World world = WorldScenes.jvm().bounds(0, 0, 40, 40).restitution(0).build()) {
            long paddle = world.add(10, 5, 1, Float.POSITIVE_INFINITY, 0, 2 / STEP);
            long flying = world.add(10, 6.6f, R, 1, 0, 2.2f / STEP);
            long heavy = world.add(10, 8.3f, R, 1e6f);
            for (int step = 0; step < 8; step++) {
                world.step(STEP);
                assertThat(world.y(flying)).isGreaterThan(world.y(paddle) + 1);
                assertThat(world.y(heavy)).isGreaterThan(world.y(paddle) + 1);
            }
        }
    }

    /** The walls end the paths of static circles: those that are told to fly far away look no farther. */
    @Test
    void aStaticCircleThatIsToFlyFarStopsAtTheBoundsAndPushesWhatIsThere() {
        try (World world = WorldScenes.jvm().bounds(0, 0, 40, 40).restitution(0).build()) {
            long paddle = world.add(10, 5, 1, Float.POSITIVE_INFINITY, 0, 1e6f);
            long inTheWay = world.add(10, 20, R, 1);
            long beside = world.add(13, 20, R, 1);
            world.step(STEP);
            assertThat(world.y(paddle)).isEqualTo(40);
            assertThat(world.vy(paddle)).isZero();
            assertThat(world.y(inTheWay)).isEqualTo(40 - R);
            assertThat(world.y(beside)).isEqualTo(20);
        }
    }

    @ParameterizedTest
    @ValueSource(floats = {0.03f, 0.97f})
    void aFastCircleInAWallFliesOnAlongIt(float x) {
        try (World world = WorldScenes.jvm().build()) {
            long ball = world.add(x, 0.2f, 0.05f, 1, 0, 0.1f / STEP);
            world.step(STEP);
            assertThat(world.y(ball)).isGreaterThan(0.29f);
        }
    }
}
