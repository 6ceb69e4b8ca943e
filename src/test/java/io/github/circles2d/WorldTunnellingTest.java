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

    /** As the documentation of World says: the same circles slip through everywhere, so the bounds can be close. */
    @ParameterizedTest
    @CsvSource({"10, 0", "20, 8"})
    void fewBulletsLeaveACorridor(float radiiPerStep, int mostOfThreeHundred) {
        assertFewLeaveACorridor(radiiPerStep, mostOfThreeHundred);
    }

    @ParameterizedTest
    @CsvSource({"5, 0", "60, 30", "200, 30"})
    @Tag("exhaustive")
    void fewBulletsLeaveACorridorAtAnySpeed(float radiiPerStep, int mostOfThreeHundred) {
        assertFewLeaveACorridor(radiiPerStep, mostOfThreeHundred);
    }

    private static void assertFewLeaveACorridor(float radiiPerStep, int mostOfThreeHundred) {
        int slipped = 0;
        for (int seed = 100; seed < 103; seed++) {
            slipped += bulletsThatLeaveACorridor(radiiPerStep, new Random(seed));
        }
        assertThat(slipped).isLessThanOrEqualTo(mostOfThreeHundred);
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
