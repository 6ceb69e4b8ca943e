package io.github.circles2d;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.circles2d.scenes.Scene;
import io.github.circles2d.scenes.Scenes;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Collisions against their closed forms. */
class WorldCollisionTest {
    private static final double RELATIVE = 1e-4;

    @ParameterizedTest
    @CsvSource({
        "1, 1, 1, 2, -3",
        "1, 1, 0.5, 2, -3",
        "1, 1, 0, 2, -3",
        "1, 1000, 1, 5, 0",
        "1000, 1, 0.3, 5, 1",
        "0.001, 7, 0.9, 1, -8",
        "1, Infinity, 0.7, 4, 0",
        "3, 4, 1, 40, -30"
    })
    void twoCirclesThatMeetHeadOnPartAsNewtonSays(float m1, float m2, float e, float v1, float v2) {
        try (World world =
                WorldScenes.jvm().bounds(-50, -50, 50, 50).restitution(e).build()) {
            long a = world.add(-2, 1, 0.5f, m1, v1, 0);
            long b = world.add(2, 1, 0.5f, m2, v2, 0);
            world.step(1 / 60f, (int) (3.5f / (v1 - v2) * 60) + 10);
            double w1 = 1.0 / m1;
            double w2 = 1.0 / m2;
            double p = (1 + e) * (v1 - v2) / (w1 + w2);
            assertClose(world.vx(a), v1 - p * w1, v1 - v2);
            assertClose(world.vx(b), v2 + p * w2, v1 - v2);
            assertThat(world.vy(a)).isZero();
            assertThat(world.vy(b)).isZero();
        }
    }

    @ParameterizedTest
    @CsvSource({"0.2, 1, 1, 1", "0.5, 1, 2, 1", "0.9, 3, 1, 0.5", "-0.7, 5, 1, 0", "0.3, 1, Infinity, 0.8"})
    void anObliqueCollisionChangesTheNormalSpeedAlone(float offset, float m1, float m2, float e) {
        try (World world =
                WorldScenes.jvm().bounds(-50, -50, 50, 50).restitution(e).build()) {
            // lengths in diameters: centres at an offset touch where the normal is (sqrt(1 - offset^2), offset)
            double nx = Math.sqrt(1 - (double) offset * offset);
            double ny = offset;
            float gap = 0.01f;
            long a = world.add((float) -nx - gap, 0, 0.5f, m1, 1, 0.25f);
            long b = world.add(0, offset, 0.5f, m2, 0, 0.25f);
            world.step(1e-4f, 200);
            double w1 = 1.0 / m1;
            double w2 = 1.0 / m2;
            double p = (1 + e) * nx / (w1 + w2);
            assertClose(world.vx(a), 1 - p * w1 * nx, 1);
            assertClose(world.vy(a), 0.25 - p * w1 * ny, 1);
            assertClose(world.vx(b), p * w2 * nx, 1);
            assertClose(world.vy(b), 0.25 + p * w2 * ny, 1);
        }
    }

    @ParameterizedTest
    @CsvSource({"1", "0.6", "0"})
    void aWallTurnsTheNormalSpeedAlone(float e) {
        try (World world = WorldScenes.jvm().bounds(0, 0, 10, 10).restitution(e).build()) {
            long a = world.add(8, 5, 0.5f, 2, 3, 1);
            world.step(1 / 60f, 50);
            assertClose(world.vx(a), -3 * e, 3);
            assertClose(world.vy(a), 1, 1);
        }
    }

    @Test
    void freeFallIsAParabola() {
        try (World world =
                WorldScenes.jvm().bounds(0, 0, 100, 100).gravity(0, -10).build()) {
            long a = world.add(10, 90, 0.5f, 2, 4, 3);
            world.step(1 / 60f, 120);
            assertThat((double) world.x(a)).isCloseTo(18, within(1e-4));
            // steps of h: the exact sum is -g h^2 k (k + 1) / 2 after k sub-steps
            assertThat((double) world.y(a)).isCloseTo(90 + 6 - 10 * 480.0 * 481 / 2 / (240 * 240), within(2e-4));
            assertThat((double) world.vy(a)).isCloseTo(3 - 20, within(1e-4));
        }
    }

    @Test
    void ballsOfAnyRestitutionBounceToTheirHeights() {
        Scene scene = Scenes.restitution();
        try (World world = WorldScenes.world(scene, WorldScenes.builder(scene))) {
            int n = scene.size();
            float[] circles = new float[4 * n];
            float[] velocities = new float[2 * n];
            boolean[] bounced = new boolean[n];
            boolean[] over = new boolean[n];
            double[] height = new double[n];
            for (int step = 0; step < 600; step++) {
                world.step(scene.timeStep());
                world.read(circles);
                world.readVelocities(velocities);
                for (int i = 0; i < n; i++) {
                    bounced[i] |= velocities[2 * i + 1] >= 0;
                    over[i] |= height[i] > 0 && velocities[2 * i + 1] < 0;
                    if (bounced[i] && !over[i]) {
                        height[i] = Math.max(height[i], circles[4 * i + 1] - 0.5);
                    }
                }
            }
            for (int i = 0; i < n; i++) {
                double fall = scene.y(i) - 0.5;
                double e = scene.restitution(i);
                assertThat(height[i])
                        .as("e = %s, fall %s", e, fall)
                        .isCloseTo(e * e * fall, within(0.02 * e * e * fall));
            }
        }
    }

    @Test
    void aPlatformStoppedAtTheBoundsCarriesWhatLiesOnIt() {
        try (World world = World.builder().bounds(0, 0, 20, 20).gravity(0, -10).build()) {
            long platform = world.add(10, 5, 2, Float.POSITIVE_INFINITY, 0, -20);
            long ball = world.add(10, 8, 1, 1);
            world.step(1 / 60f, 600);
            assertThat(world.y(platform)).isEqualTo(0f);
            assertThat(world.vy(platform)).isEqualTo(0f);
            assertThat((double) world.y(ball)).isCloseTo(3, within(0.01));
        }
    }

    @Test
    void aSmallBallFallsAsFastAsGravityHasIt() {
        try (World world = World.builder().bounds(0, 0, 10, 30).gravity(0, -10).build()) {
            long ball = world.add(5, 25, 0.01f, 1);
            world.step(1 / 60f, 115);
            double t = 115 / 60.0;
            assertThat((double) world.y(ball)).isCloseTo(25 - 5 * t * t, within(0.05));
            assertThat((double) world.vy(ball)).isCloseTo(-10 * t, within(0.01));
        }
    }

    @Test
    void aStepOfAnotherLengthDoesNotBlowAPileApart() {
        try (World world = World.builder().bounds(0, 0, 20, 60).gravity(0, -10).build()) {
            for (int i = 0; i < 200; i++) {
                world.add(1 + i % 10 * 1.9f, 1 + i / 10 * 1.9f, 0.9f, 1);
            }
            world.step(1 / 60f, 1500);
            float[] circles = new float[4 * world.size()];
            float before = top(world, circles);
            world.step(1 / 1000f);
            for (int step = 0; step < 60; step++) {
                world.step(1 / 60f);
                assertThat(top(world, circles)).isLessThan(before + 0.5f);
            }
        }
    }

    private static float top(World world, float[] circles) {
        world.read(circles);
        float top = 0;
        for (int i = 1; i < circles.length; i += 4) {
            top = Math.max(top, circles[i]);
        }
        return top;
    }

    private static void assertClose(float actual, double expected, double scale) {
        assertThat((double) actual).isCloseTo(expected, within(RELATIVE * Math.abs(scale)));
    }
}
