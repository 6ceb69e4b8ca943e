package io.github.circles2d;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Fast circles that hit others at rest or slow ones, at any restitution, leave no overlap. */
class WorldImpactsTest {
    private static final float STEP = 1 / 60f;
    private static final float R = 0.5f;
    private static final float[] RADII_PER_STEP = {2, 2.7f, 5, 20, 60};
    private static final int PHASES = 4;

    /** A circle; its speed is in units of the world. */
    private record Ball(float x, float y, float r, float vx) {}

    @ParameterizedTest
    @ValueSource(floats = {0, 0.1f, 0.3f, 0.5f, 0.9f, 1})
    void anImpactLeavesNoOverlap(float restitution) {
        for (float offset : new float[] {0, 0.3f, 0.8f, 1.5f}) {
            assertNoOverlap(restitution, 0.05f, new Ball(0, offset * R, R, 0));
        }
        for (float ratio : new float[] {1 / 10f, 1 / 3f, 2 / 3f, 1.5f, 3, 10, 30}) {
            assertNoOverlap(restitution, 0.05f, new Ball(0, 0, ratio * R, 0));
        }
    }

    @ParameterizedTest
    @ValueSource(floats = {0, 0.1f, 0.3f, 0.5f, 0.9f})
    void anImpactOnOneThatMovesLeavesNoOverlap(float restitution) {
        for (float speed : new float[] {-0.24f, 0.24f}) {
            assertNoOverlap(restitution, 0.05f, new Ball(0, 0.1f * R, R, speed * R / STEP));
        }
    }

    @ParameterizedTest
    @ValueSource(floats = {0, 0.1f, 0.3f, 0.5f, 0.9f, 1})
    void anImpactOnOneThatFliesAheadLeavesNoOverlap(float restitution) {
        for (float radiiPerStep : RADII_PER_STEP) {
            for (int phase = 0; phase < PHASES; phase++) {
                float speed = radiiPerStep * R / STEP;
                assertNoOverlap(restitution, 0.05f, radiiPerStep, phase, new Ball(0, 0, R, 0.25f * phase * speed));
            }
        }
    }

    @ParameterizedTest
    @ValueSource(floats = {0, 0.1f, 0.3f, 0.5f, 0.9f, 1})
    void anImpactOnARowLeavesNoOverlap(float restitution) {
        assertNoOverlap(restitution, 0.05f, new Ball(0, 0, R, 0), new Ball(2 * R, 0, R, 0));
        assertNoOverlap(restitution, 0.05f, new Ball(0, R, R, 0), new Ball(0, -R, R, 0));
    }

    private static void assertNoOverlap(float restitution, float most, Ball... others) {
        for (float radiiPerStep : RADII_PER_STEP) {
            for (int phase = 0; phase < PHASES; phase++) {
                assertNoOverlap(restitution, most, radiiPerStep, phase, others);
            }
        }
    }

    /** Another phase begins at another distance, so that the hit comes at another time of its step. */
    private static void assertNoOverlap(float restitution, float most, float radiiPerStep, int phase, Ball... others) {
        float speed = radiiPerStep * R / STEP;
        List<Ball> balls = new ArrayList<>();
        balls.add(new Ball(-(others[0].r + R + 1.3f + 0.31f * phase * radiiPerStep * R), 0, R, speed));
        balls.addAll(List.of(others));
        try (World world = WorldScenes.jvm()
                .bounds(-2000, -2000, 2000, 2000)
                .edges(Edge.OPEN, Edge.OPEN)
                .restitution(restitution)
                .build()) {
            balls.forEach(b -> world.add(b.x, b.y, b.r, b.r * b.r, b.vx, 0));
            double momentum = momentum(balls, world);
            double energy = energy(balls, world);
            float[] circles = new float[4 * balls.size()];
            for (int step = 0; step < 25; step++) {
                world.step(STEP);
                world.read(circles);
                assertThat(overlap(balls, circles))
                        .as(
                                "overlap in lesser radii, %s radii a step, phase %d, step %d, %s",
                                radiiPerStep, phase, step, balls)
                        .isLessThan(most);
            }
            assertThat(momentum(balls, world)).as("momentum").isBetween(momentum * (1 - 1e-6), momentum * (1 + 1e-6));
            assertThat(energy(balls, world)).as("energy").isLessThan(energy * (1 + 2e-6));
        }
    }

    private static double overlap(List<Ball> balls, float[] circles) {
        double most = 0;
        for (int i = 0; i < balls.size(); i++) {
            for (int j = 0; j < i; j++) {
                double distance = Math.hypot(circles[4 * i] - circles[4 * j], circles[4 * i + 1] - circles[4 * j + 1]);
                double depth = balls.get(i).r + balls.get(j).r - distance;
                most = Math.max(most, depth / Math.min(balls.get(i).r, balls.get(j).r));
            }
        }
        return most;
    }

    private static double momentum(List<Ball> balls, World world) {
        float[] velocities = velocities(balls, world);
        double sum = 0;
        for (int i = 0; i < balls.size(); i++) {
            sum += (double) balls.get(i).r * balls.get(i).r * velocities[2 * i];
        }
        return sum;
    }

    private static double energy(List<Ball> balls, World world) {
        float[] velocities = velocities(balls, world);
        double sum = 0;
        for (int i = 0; i < balls.size(); i++) {
            double vx = velocities[2 * i];
            double vy = velocities[2 * i + 1];
            sum += (double) balls.get(i).r * balls.get(i).r * (vx * vx + vy * vy);
        }
        return sum;
    }

    private static float[] velocities(List<Ball> balls, World world) {
        float[] velocities = new float[2 * balls.size()];
        world.readVelocities(velocities);
        return velocities;
    }
}
