package io.github.circles2d;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.circles2d.scenes.Scene;
import io.github.circles2d.scenes.Scenes;
import java.util.BitSet;
import java.util.Random;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Fast circles meet what is in their way. */
class WorldTunnellingTest {
    private static final float STEP = 1 / 60f;

    @ParameterizedTest
    @ValueSource(floats = {1, 5, 20, 60, 200, 5000})
    void bulletsDoNotPassAFence(float speed) {
        Random random = new Random(7);
        try (World world =
                WorldScenes.jvm().bounds(-10, -10, 10, 10).restitution(0.8f).build()) {
            for (int i = 0; i <= 200; i++) {
                world.add(0, -10 + 0.1f * i, 0.05f, Float.POSITIVE_INFINITY);
            }
            int bullets = 100;
            for (int i = 0; i < bullets; i++) {
                float angle = (random.nextFloat() - 0.5f) * 2.6f;
                world.add(
                        -9 + 6 * random.nextFloat(),
                        -9 + 18 * random.nextFloat(),
                        0.02f + 0.05f * random.nextFloat(),
                        1 + random.nextFloat(),
                        speed * (float) StrictMath.cos(angle),
                        speed * (float) StrictMath.sin(angle));
            }
            float[] circles = new float[4 * world.size()];
            for (int step = 0; step < 300; step++) {
                world.step(STEP);
                world.read(circles);
                for (int i = 201; i < 201 + bullets; i++) {
                    assertThat(circles[4 * i])
                            .as("x of bullet %d, step %d", i - 201, step)
                            .isNegative();
                }
            }
        }
    }

    @ParameterizedTest
    @ValueSource(floats = {20, 60})
    void noBulletLeavesACorridor(float radiiPerStep) {
        assertNoneLeavesACorridor(radiiPerStep);
    }

    @ParameterizedTest
    @ValueSource(floats = {5, 10, 100, 200})
    @Tag("exhaustive")
    void noBulletLeavesACorridorAtAnySpeed(float radiiPerStep) {
        assertNoneLeavesACorridor(radiiPerStep);
    }

    private static void assertNoneLeavesACorridor(float radiiPerStep) {
        for (int seed = 100; seed < 103; seed++) {
            assertThat(bulletsThatLeaveACorridor(radiiPerStep, new Random(seed)))
                    .as("seed %d", seed)
                    .isZero();
        }
    }

    /** Shoots 100 bullets of restitution 1 between two fences for 300 steps; counts those that have been outside. */
    private static int bulletsThatLeaveACorridor(float radiiPerStep, Random random) {
        int fences = 402;
        int bullets = 100;
        try (World world =
                WorldScenes.jvm().bounds(-10, -10, 10, 10).restitution(1).build()) {
            for (int i = 0; i < fences; i++) {
                world.add(i < 201 ? 0 : 5, -10 + 0.1f * (i % 201), 0.05f, Float.POSITIVE_INFINITY);
            }
            for (int i = 0; i < bullets; i++) {
                double angle = random.nextDouble() * 2 * Math.PI;
                float r = 0.02f + 0.05f * random.nextFloat();
                float speed = radiiPerStep * r / STEP;
                world.add(
                        0.15f + 4.7f * random.nextFloat(),
                        -9 + 18 * random.nextFloat(),
                        r,
                        1 + random.nextFloat(),
                        speed * (float) StrictMath.cos(angle),
                        speed * (float) StrictMath.sin(angle));
            }
            float[] circles = new float[4 * world.size()];
            BitSet outside = new BitSet();
            for (int step = 0; step < 300; step++) {
                world.step(STEP);
                world.read(circles);
                for (int i = 0; i < bullets; i++) {
                    float x = circles[4 * (fences + i)];
                    if (x < 0 || x > 5) {
                        outside.set(i);
                    }
                }
            }
            return outside.cardinality();
        }
    }

    @ParameterizedTest
    @ValueSource(floats = {3, 30})
    void headOnBulletsDoNotPassEachOther(float speed) {
        assertDoNotPassEachOther(speed);
    }

    @ParameterizedTest
    @ValueSource(floats = 300)
    @Tag("exhaustive")
    void veryFastHeadOnBulletsDoNotPassEachOther(float speed) {
        assertDoNotPassEachOther(speed);
    }

    private static void assertDoNotPassEachOther(float speed) {
        Random random = new Random(8);
        int pairs = 200;
        try (World world =
                WorldScenes.jvm().bounds(-10, -100, 10, 100).restitution(1).build()) {
            for (int i = 0; i < pairs; i++) {
                float y = -99 + 198f * i / pairs;
                world.add(-5 + 4 * random.nextFloat(), y, 0.05f, 1, speed * (0.3f + random.nextFloat()), 0);
                world.add(1 + 4 * random.nextFloat(), y, 0.05f, 1, -speed * (0.3f + random.nextFloat()), 0);
            }
            float[] circles = new float[8 * pairs];
            float[] velocities = new float[4 * pairs];
            boolean[] met = new boolean[pairs];
            for (int step = 0; step < 300; step++) {
                world.step(STEP);
                world.read(circles);
                world.readVelocities(velocities);
                for (int i = 0; i < pairs; i++) {
                    // once they have bounced, walls and unseen turns come in
                    met[i] |= velocities[4 * i] < 0 || velocities[4 * i + 2] > 0;
                    if (!met[i]) {
                        assertThat(circles[8 * i])
                                .as("left of pair %d, step %d", i, step)
                                .isLessThan(circles[8 * i + 4]);
                    }
                }
            }
            for (int i = 0; i < pairs; i++) {
                assertThat(met[i]).as("pair %d has met", i).isTrue();
            }
        }
    }

    @ParameterizedTest
    @CsvSource({"20, 1", "20, 50", "50, 5", "200, 0.5", "200, 64", "200, 200"})
    void noBallPassesAFenceOfTinyPosts(float ratio, float radiiPerStep) {
        float r = 0.5f;
        float post = r / ratio;
        Random random = new Random(11);
        try (World world =
                WorldScenes.jvm().bounds(-200, -60, 200, 60).restitution(1).build()) {
            int balls = 50;
            for (int i = 0; i < balls; i++) {
                float way = r + post + (0.1f + random.nextFloat()) * Math.min(radiiPerStep, 64) * r;
                float speed = radiiPerStep * r / STEP;
                float slope = random.nextFloat() - 0.5f;
                world.add(
                        -way,
                        -50 + 2 * i + 0.5f * random.nextFloat() - slope * Math.min(way, 1),
                        r,
                        1,
                        speed,
                        slope * speed);
            }
            for (float y = -60; y <= 60; y += r) {
                world.add(0, y, post, Float.POSITIVE_INFINITY);
            }
            assertStayLeft(world, balls, post + r / 2);
        }
    }

    @ParameterizedTest
    @CsvSource({"0.9, 0.5", "0.9, 3", "0.9, 50", "0.95, 1", "0.95, 2", "0.95, 5", "0.95, 200"})
    void noBallSqueezesThroughAGapThatIsTooNarrow(float diameters, float radiiPerStep) {
        float r = 0.5f;
        Random random = new Random(12);
        try (World world =
                WorldScenes.jvm().bounds(-200, -200, 200, 200).restitution(0.5f).build()) {
            float pitch = 2 * r * (1 + diameters);
            int balls = 60;
            for (int i = 0; i < balls; i++) {
                float way = 2 * r + (0.1f + random.nextFloat()) * Math.min(radiiPerStep, 64) * r;
                float speed = radiiPerStep * r / STEP;
                float slope = 0.3f * (random.nextFloat() - 0.5f);
                float aside = 0.5f * r * (2 * random.nextFloat() - 1) - slope * Math.min(way, 2 * r);
                world.add(-way, (3 * (i - 30) + 0.5f) * pitch + aside, r, 1, speed, slope * speed);
            }
            int posts = (int) (200 / pitch); // up to the walls
            for (int k = -posts; k <= posts; k++) {
                world.add(0, k * pitch, r, Float.POSITIVE_INFINITY);
            }
            assertStayLeft(world, balls, 1.5f * r);
        }
    }

    private static void assertStayLeft(World world, int balls, float most) {
        float[] circles = new float[4 * world.size()];
        for (int step = 0; step < 60; step++) {
            world.step(STEP);
            world.read(circles);
            for (int i = 0; i < balls; i++) {
                assertThat(circles[4 * i]).as("x of ball %d, step %d", i, step).isLessThan(most);
            }
        }
    }

    @ParameterizedTest
    @CsvSource({"0.05, 10, 10", "0.05, 10, 0", "0.1, 2, 5", "0.3, 5, 0.5", "1, 1, 10", "1, 10, 10"})
    void noBallComesBehindAPaddleThatItMeets(float r, float rising, float falling) {
        Random random = new Random(13);
        int lanes = 40;
        float lane = 8 * (1 + r + r * (rising + falling));
        try (World world = WorldScenes.jvm()
                .bounds(0, -100, lanes * lane, 200)
                .restitution(0.5f)
                .build()) {
            for (int i = 0; i < lanes; i++) {
                float x = (i + 0.5f) * lane;
                float aside = 0.5f * (1 + r) * (2 * random.nextFloat() - 1);
                float gap = 0.01f * r + 2 * random.nextFloat() * (rising + falling) * r;
                world.add(x, 0, 1, Float.POSITIVE_INFINITY, 0, rising * r / STEP);
                world.add(x + aside, 1 + r + gap, r, 1, 0, -falling * r / STEP);
            }
            world.step(STEP, 4 + (int) Math.ceil(2.2f * (1 + r) / ((rising + falling) * r)));
            float[] circles = new float[8 * lanes];
            world.read(circles);
            for (int i = 0; i < lanes; i++) {
                assertThat(circles[8 * i + 5]).as("y of ball %d", i).isGreaterThan(circles[8 * i + 1]);
            }
        }
    }

    /** Elastic, equal, without gravity: the one that was hit leaves along the line of the centres as they touched. */
    @ParameterizedTest
    @ValueSource(floats = {0.3f, 0.5f, 0.8f, 1, 1.1f})
    void circlesThatMeetNeitherOverlapNorLeaveInAWrongDirection(float radiiPerStep) {
        float r = 0.5f;
        int pairs = 200;
        Random random = new Random(4);
        try (World world = WorldScenes.jvm()
                .bounds(-20, -20, 20, 16 * pairs)
                .restitution(1)
                .build()) {
            for (int i = 0; i < pairs; i++) {
                float offset = 1.9f * r * (2 * (i + 0.5f) / pairs - 1);
                world.add(-1.2f - random.nextFloat(), 16 * i, r, 1, radiiPerStep * r / STEP, 0);
                world.add(0, 16 * i + offset, r, 1, 0, 0);
            }
            float[] circles = new float[8 * pairs];
            float[] velocities = new float[4 * pairs];
            for (int step = 0; step < (int) (8 / radiiPerStep); step++) {
                world.step(STEP);
                world.read(circles);
                for (int i = 0; i < pairs; i++) {
                    double distance =
                            Math.hypot(circles[8 * i + 4] - circles[8 * i], circles[8 * i + 5] - circles[8 * i + 1]);
                    assertThat(distance)
                            .as("distance of pair %d, step %d", i, step)
                            .isGreaterThan(1.95 * r);
                }
            }
            world.readVelocities(velocities);
            double errors = 0;
            for (int i = 0; i < pairs; i++) {
                double ny = 1.9 * (2 * (i + 0.5) / pairs - 1) / 2;
                errors += Math.abs(Math.atan2(velocities[4 * i + 3], velocities[4 * i + 2]) - Math.asin(ny));
            }
            assertThat(Math.toDegrees(errors / pairs)).as("mean error, degrees").isLessThan(0.7);
        }
    }

    @Test
    void aFastBallSwallowsHardlyAnyPebble() {
        for (float radiiPerStep : new float[] {0.5f, 0.7f, 0.9f, 1.1f}) {
            Random random = new Random(5);
            int lanes = 10;
            try (World world = WorldScenes.jvm()
                    .bounds(0, 0, 40, 8 * lanes)
                    .restitution(0.5f)
                    .build()) {
                for (int lane = 0; lane < lanes; lane++) {
                    world.add(9 - 1.5f * random.nextFloat(), 8 * lane + 4, 1, 3.14f, radiiPerStep / STEP, 0);
                }
                for (int i = 0; i < 60 * lanes; i++) {
                    float x = 10.1f + i % 10 + 0.8f * random.nextFloat();
                    float y = 1.1f + 8 * (i / 60) + i / 10 % 6 + 0.8f * random.nextFloat();
                    world.add(x, y, 0.1f, 0.0314f);
                }
                float[] circles = new float[4 * world.size()];
                BitSet swallowed = new BitSet();
                for (int step = 0; step < 15 / radiiPerStep; step++) {
                    world.step(STEP);
                    world.read(circles);
                    for (int i = 0; i < 60 * lanes; i++) {
                        int ball = 4 * (i / 60);
                        int pebble = 4 * (lanes + i);
                        double dx = circles[pebble] - circles[ball];
                        double dy = circles[pebble + 1] - circles[ball + 1];
                        swallowed.set(i, swallowed.get(i) || Math.hypot(dx, dy) < 0.9);
                    }
                }
                assertThat(swallowed.cardinality())
                        .as("of the 200 pebbles in the way, at %s radii a step", radiiPerStep)
                        .isLessThanOrEqualTo(4);
            }
        }
    }

    @Test
    void aFastCueBallDoesNotPassTheRack() {
        for (float speed : new float[] {2, 5, 10, 20, 40, 100}) {
            Scene scene = Scenes.billiards(speed);
            try (World world = WorldScenes.world(scene, WorldScenes.builder(scene))) {
                float[] circles = new float[4 * world.size()];
                float[] velocities = new float[2 * world.size()];
                float reach = scene.x(0) - 2 * scene.radius(0);
                for (int step = 0; step < 60; step++) {
                    world.read(circles);
                    world.readVelocities(velocities);
                    if (velocities[2 * 15] < 0.9f * speed) {
                        break;
                    }
                    assertThat(circles[4 * 15])
                            .as("cue ball at speed %s", speed)
                            .isLessThanOrEqualTo(reach + 1e-3f);
                    world.step(scene.timeStep());
                }
                assertThat(velocities[2 * 15])
                        .as("cue ball after the hit at speed %s", speed)
                        .isLessThan(0.2f * speed);
            }
        }
    }
}
