package io.github.circles2d;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.circles2d.opencl.Device;
import io.github.circles2d.opencl.TestDevices;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * Closed forms of mechanics, for every pair indexing and restitution 0, 0.5 and 1. Positions and velocities are of order 1, so
 * a few steps of single precision stay within 2e-6.
 */
class Circles2DMotionTest {
    private static final float H = 1 / 64f;
    private static final float[] NO_GRAVITY = {0, 0};
    private static final double TOLERANCE = 2e-6;

    static List<Arguments> everyIndexingOnEveryDevice() {
        List<Arguments> cases = new ArrayList<>();
        for (Device device : TestDevices.all()) {
            for (PairIndexing indexing : PairIndexing.values()) {
                for (float restitution : new float[] {0, 0.5f, 1}) {
                    cases.add(Arguments.of(device, indexing, restitution));
                }
            }
        }
        return cases;
    }

    @ParameterizedTest
    @MethodSource("everyIndexingOnEveryDevice")
    void freeFallFollowsTheParabola(Device device, PairIndexing indexing, float e) throws IOException {
        try (Circles2D engine = new Circles2D(device)) {
            engine.addCircle(0.2f, 0.9f, 0.01f, 1, 0.1f, 0.05f);
            engine.addCircle(0.6f, 0.5f, 0.02f, 5);
            engine.init(H, indexing, e, new float[] {0.03f, -0.4f});
            float[][] circles = steps(engine, 48);
            double t = 48 * H;
            assertRow(circles[0], 0.2 + 0.1 * t + 0.5 * 0.03 * t * t, 0.6 + 0.5 * 0.03 * t * t);
            assertRow(circles[1], 0.9 + 0.05 * t - 0.5 * 0.4 * t * t, 0.5 - 0.5 * 0.4 * t * t);
            assertRow(engine.velocities()[0], 0.1 + 0.03 * t, 0.03 * t);
            assertRow(engine.velocities()[1], 0.05 - 0.4 * t, -0.4 * t);
            assertRow(circles[2], 0.01f, 0.02f);
            assertRow(circles[3], 1, 5);
        }
    }

    /** The axis that hits leaves at -e v; the thesis scales the other one by e as well. */
    @ParameterizedTest
    @MethodSource("everyIndexingOnEveryDevice")
    void everyWallReflectsTheOvershootAndScalesTheVelocity(Device device, PairIndexing indexing, float e)
            throws IOException {
        float r = 0.05f;
        float v = 0.8f;
        float along = 0.3f;
        double overshoot = v * H - 0.005;
        try (Circles2D engine = new Circles2D(device)) {
            engine.addCircle(r + 0.005f, 0.3f, r, 1, -v, along);
            engine.addCircle(1 - r - 0.005f, 0.3f, r, 1, v, along);
            engine.addCircle(0.3f, r + 0.005f, r, 1, along, -v);
            engine.addCircle(0.5f, 1 - r - 0.005f, r, 1, along, v);
            engine.init(H, indexing, e, NO_GRAVITY);
            float[][] circles = engine.loop();
            double moved = along * H;
            assertRow(circles[0], r + overshoot, 1 - r - overshoot, 0.3 + moved, 0.5 + moved);
            assertRow(circles[1], 0.3 + moved, 0.3 + moved, r + overshoot, 1 - r - overshoot);
            assertRow(engine.velocities()[0], e * v, -e * v, e * along, e * along);
            assertRow(engine.velocities()[1], e * along, e * along, e * v, -e * v);
        }
    }

    @ParameterizedTest
    @MethodSource("everyIndexingOnEveryDevice")
    void aBounceUnderGravityLeavesWithTheGainOfTheStepScaled(Device device, PairIndexing indexing, float e)
            throws IOException {
        float g = -0.5f;
        float v = -0.9f;
        try (Circles2D engine = new Circles2D(device)) {
            engine.addCircle(0.5f, 0.055f, 0.05f, 3, 0, v);
            engine.init(H, indexing, e, new float[] {0, g});
            float[][] circles = engine.loop();
            double fallen = 0.055 + v * H + 0.5 * g * H * H;
            assertRow(circles[1], 0.1 - fallen);
            assertRow(engine.velocities()[1], e * (v + g * H) - 2 * e * v);
        }
    }

    @ParameterizedTest
    @MethodSource("everyIndexingOnEveryDevice")
    @Tag("long")
    void aCornerReflectsBothAxes(Device device, PairIndexing indexing, float e) throws IOException {
        float r = 0.05f;
        try (Circles2D engine = new Circles2D(device)) {
            engine.addCircle(r, r, r, 1, -0.64f, -0.32f);
            engine.addCircle(1 - r, r, r, 2, 0.64f, -0.32f);
            engine.addCircle(r, 1 - r, r, 3, -0.64f, 0.32f);
            engine.addCircle(1 - r, 1 - r, r, 4, 0.64f, 0.32f);
            engine.init(H, indexing, e, NO_GRAVITY);
            float[][] circles = engine.loop();
            double dx = 0.01;
            double dy = 0.005;
            assertRow(circles[0], r + dx, 1 - r - dx, r + dx, 1 - r - dx);
            assertRow(circles[1], r + dy, r + dy, 1 - r - dy, 1 - r - dy);
            assertRow(engine.velocities()[0], 0.64 * e, -0.64 * e, 0.64 * e, -0.64 * e);
            assertRow(engine.velocities()[1], 0.32 * e, 0.32 * e, -0.32 * e, -0.32 * e);
        }
    }

    @ParameterizedTest
    @MethodSource("everyIndexingOnEveryDevice")
    @Tag("long")
    void aHeadOnImpactObeysMomentumAndRestitution(Device device, PairIndexing indexing, float e) throws IOException {
        for (double[] m : new double[][] {{1, 1}, {1, 3}, {8, 0.5}}) {
            try (Circles2D engine = new Circles2D(device)) {
                engine.addCircle(0.45f, 0.5f, 0.05f, (float) m[0], 0.32f, 0);
                engine.addCircle(0.55f, 0.5f, 0.05f, (float) m[1], -0.16f, 0);
                engine.init(H, indexing, e, NO_GRAVITY);
                float[][] circles = engine.loop();
                // They meet 0.0075 deep, and each gives way by half of that.
                assertRow(circles[0], 0.455 - 0.00375, 0.5475 + 0.00375);
                assertRow(circles[1], 0.5, 0.5);
                double common = (m[0] * 0.32 - m[1] * 0.16) / (m[0] + m[1]);
                double share = e * 0.48 / (m[0] + m[1]);
                assertRow(engine.velocities()[0], common - share * m[1], common + share * m[0]);
                assertRow(engine.velocities()[1], 0, 0);
            }
        }
    }

    /** The normal lies at 3-4-5: only the velocity along it changes. */
    @ParameterizedTest
    @MethodSource("everyIndexingOnEveryDevice")
    @Tag("long")
    void anObliqueImpactChangesTheNormalVelocityAlone(Device device, PairIndexing indexing, float e)
            throws IOException {
        double m1 = 2;
        double m2 = 3;
        try (Circles2D engine = new Circles2D(device)) {
            engine.addCircle(0.44f, 0.42f, 0.05f, (float) m1, 0.256f, 0.128f);
            engine.addCircle(0.5f, 0.5f, 0.05f, (float) m2, 0.256f, 0.128f);
            engine.addCircle(0.8f, 0.8f, 0.05f, 1);
            engine.init(H, indexing, e, NO_GRAVITY);
            // Both move alike, so they stay at touching distance, 0.1, and nothing happens.
            engine.loop();
            double[] v = {engine.velocities()[0][0], engine.velocities()[1][0]};
            assertThat(v[0]).isCloseTo(0.256, within(TOLERANCE));
            assertThat(v[1]).isCloseTo(0.128, within(TOLERANCE));
        }
        try (Circles2D engine = new Circles2D(device)) {
            engine.addCircle(0.44f, 0.42f, 0.06f, (float) m1, 0.256f, 0.128f);
            engine.addCircle(0.5f, 0.5f, 0.06f, (float) m2, -0.128f, 0.064f);
            engine.addCircle(0.8f, 0.8f, 0.05f, 1);
            engine.init(H, indexing, e, NO_GRAVITY);
            float[][] circles = engine.loop();
            double x1 = 0.44 + 0.256 * H;
            double y1 = 0.42 + 0.128 * H;
            double x2 = 0.5 - 0.128 * H;
            double y2 = 0.5 + 0.064 * H;
            double distance = Math.hypot(x2 - x1, y2 - y1);
            double nx = (x2 - x1) / distance;
            double ny = (y2 - y1) / distance;
            double push = 0.5 * (0.12 - distance);
            assertRow(circles[0], x1 - push * nx, x2 + push * nx, 0.8);
            assertRow(circles[1], y1 - push * ny, y2 + push * ny, 0.8);
            double impulse = (1 + e) * (0.384 * nx + 0.064 * ny) / (1 / m1 + 1 / m2);
            float[][] velocities = engine.velocities();
            assertRow(velocities[0], 0.256 - impulse / m1 * nx, -0.128 + impulse / m2 * nx, 0);
            assertRow(velocities[1], 0.128 - impulse / m1 * ny, 0.064 + impulse / m2 * ny, 0);
        }
    }

    static Stream<Arguments> everyElasticIndexingOnEveryDevice() {
        return everyIndexingOnEveryDevice().stream()
                .filter(arguments -> (float) arguments.get()[2] > 0);
    }

    /**
     * Two impacts one after the other, so that no step has a circle in two contacts. At restitution 0 there is no such chain:
     * the first two circles stay in touch.
     */
    @ParameterizedTest
    @MethodSource("everyElasticIndexingOnEveryDevice")
    void aChainOfThreeHandsTheMomentumOn(Device device, PairIndexing indexing, float e) throws IOException {
        try (Circles2D engine = new Circles2D(device)) {
            engine.addCircle(0.3f, 0.5f, 0.05f, 1, 0.64f, 0);
            engine.addCircle(0.405f, 0.5f, 0.05f, 1);
            engine.addCircle(0.555f, 0.5f, 0.05f, 1);
            engine.init(H, indexing, e, NO_GRAVITY);
            engine.loop();
            double first = 0.64 * (1 + e) / 2;
            assertRow(engine.velocities()[0], 0.64 - first, first, 0);
            for (int k = 0; k < 20 && engine.velocities()[0][2] == 0; k++) {
                engine.loop();
            }
            double second = first * (1 + e) / 2;
            assertRow(engine.velocities()[0], 0.64 - first, first - second, second);
        }
    }

    /** A property of the thesis: the impulse does not ask whether the pair approaches. */
    @ParameterizedTest
    @MethodSource("everyIndexingOnEveryDevice")
    void anOverlappingPairThatSeparatesIsPulledTogetherAgain(Device device, PairIndexing indexing, float e)
            throws IOException {
        try (Circles2D engine = new Circles2D(device)) {
            engine.addCircle(0.46f, 0.5f, 0.05f, 1, -0.064f, 0);
            engine.addCircle(0.54f, 0.5f, 0.05f, 1, 0.064f, 0);
            engine.init(H, indexing, e, NO_GRAVITY);
            engine.loop();
            assertRow(engine.velocities()[0], 0.064 * e, -0.064 * e);
        }
    }

    private static float[][] steps(Circles2D engine, int steps) {
        for (int k = 1; k < steps; k++) {
            engine.step();
        }
        return engine.loop();
    }

    private static void assertRow(float[] actual, double... expected) {
        assertThat(actual).hasSize(expected.length);
        for (int i = 0; i < expected.length; i++) {
            assertThat((double) actual[i]).as("circle " + i).isCloseTo(expected[i], within(TOLERANCE));
        }
    }
}
