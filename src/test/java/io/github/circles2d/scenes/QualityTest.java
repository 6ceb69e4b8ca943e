package io.github.circles2d.scenes;

import static io.github.circles2d.Refusals.assertIllegalArgument;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.Random;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

class QualityTest {
    static Stream<Scene> scenes() {
        return Stream.of(
                Scenes.thesis(1250, 1),
                Scenes.thesis(5000, 2),
                Scenes.packed(7000, 3),
                Scenes.gas(3000, 4),
                Scenes.pyramid(),
                Scenes.barrel(5),
                Scenes.confined(),
                Scenes.restitution(),
                Scenes.bouncy(6),
                Scenes.noCollide(),
                Scenes.billiards(10),
                Scenes.mixed(6000, 7),
                Scenes.onePoint(500, 8),
                Scenes.oneCell(500, 9));
    }

    @ParameterizedTest
    @MethodSource("scenes")
    void agreesWithAllPairsBruteForce(Scene scene) {
        assertSame(Quality.of(scene), bruteForce(scene, scene.x(), scene.y()));
    }

    @Test
    void agreesWithBruteForceFarFromTheOriginAndOnNegativeCoordinates() {
        Scene scene = Scenes.mixed(2000, 11);
        float[] x = scene.x();
        float[] y = scene.y();
        for (int i = 0; i < x.length; i++) {
            x[i] = x[i] - 3;
            y[i] = i % 100 == 0 ? 1e30f * y[i] : y[i] - 0.5f;
        }
        Quality quality = Quality.of(x, y, scene.radius(), scene.mass(), scene.vx(), scene.vy(), x.length);
        assertThat(quality.overlapping()).isPositive();
        assertSame(quality, bruteForce(scene, x, y));
    }

    @Test
    void twoCirclesThatOverlapByHalfARadiusHaveThatDepth() {
        float[] r = {1, 1};
        float[] m = {3, 5};
        float[] zero = {0, 0};
        Quality quality = Quality.of(new float[] {0, 1.5f}, zero, r, m, new float[] {2, 0}, new float[] {0, 1}, 2);
        assertThat(quality).isEqualTo(new Quality(0.5, 0.5, 1, 1, (0.5 * 3 * 4 + 0.5 * 5) / 2));
    }

    @Test
    void depthIsCountedInMeanRadiiOfAllCircles() {
        float[] x = {0, 3.5f, 100};
        float[] zero = {0, 0, 0};
        // overlap 1 + 3 - 3.5 = 0.5, mean radius (1 + 3 + 8) / 3 = 4
        Quality quality = Quality.of(x, zero, new float[] {1, 3, 8}, new float[] {1, 1, 1}, zero, zero, 3);
        assertThat(quality).isEqualTo(new Quality(0.125, 0.125, 1, 1, 0));
    }

    @Test
    void circlesThatOnlyTouchDoNotOverlap() {
        float[] zero = {0, 0};
        float[] one = {1, 1};
        assertThat(Quality.of(new float[] {0, 2}, zero, one, one, zero, zero, 2))
                .isEqualTo(new Quality(0, 0, 0, 0, 0));
    }

    @Test
    void onlyTheFirstNCirclesCount() {
        float[] zero = {0, 0};
        float[] one = {1, 1};
        assertThat(Quality.of(zero, zero, one, one, zero, zero, 1).overlapping())
                .isZero();
        assertThat(Quality.of(zero, zero, one, one, zero, zero, 2).overlapping())
                .isOne();
    }

    @Test
    void infiniteMassAtRestHasNoKineticEnergy() {
        float[] zero = {0};
        float[] one = {1};
        float[] infinite = {Float.POSITIVE_INFINITY};
        assertThat(Quality.of(zero, zero, one, infinite, zero, zero, 1).kineticEnergyPerCircle())
                .isZero();
    }

    @Test
    void aStateThatIsNotFiniteIsRefusedWithTheCircleThatIsAtFault() {
        float[] zero = {0, 0};
        float[] one = {1, 1};
        float[] bad = {0, Float.NaN};
        assertThatThrownBy(() -> Quality.of(zero, bad, one, one, zero, zero, 2))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessage("circle 1: y is NaN");
        assertThatThrownBy(() -> Quality.of(zero, zero, zero, one, zero, zero, 2))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessage("circle 0: radius is 0.0");
        assertIllegalArgument("vy has 1 elements", () -> Quality.of(zero, zero, one, one, zero, new float[1], 2));
        assertIllegalArgument("at least 1: 0", () -> Quality.of(zero, zero, one, one, zero, zero, 0));
    }

    @Test
    @Tag("long")
    void aMillionCirclesAgreeWithTheSameCrowdTiledFromSmallOnes() {
        // 400 tiles of 2,500 circles, far apart: every count is 400 times that of one tile.
        Scene tile = Scenes.packed(2500, 12);
        int n = 400 * tile.size();
        float[][] s = new float[6][n];
        for (int i = 0; i < n; i++) {
            int t = i / tile.size();
            int k = i % tile.size();
            // multiples of 2^-20, so that shifting a tile is exact and the overlaps stay the same to the bit
            s[0][i] = round(tile.x(k), 1 << 18) + 2 * (t % 20);
            s[1][i] = round(tile.y(k), 1 << 18) + 2 * (t / 20);
            s[2][i] = tile.radius(k);
            s[3][i] = tile.mass(k);
        }
        Quality all = Quality.of(s[0], s[1], s[2], s[3], s[4], s[5], n);
        Quality one = Quality.of(s[0], s[1], s[2], s[3], s[4], s[5], tile.size());
        assertThat(one.overlapping()).isPositive();
        assertThat(all.overlapping()).isEqualTo(400 * one.overlapping());
        assertThat(all.deep()).isEqualTo(400 * one.deep());
        assertThat(all.maxDepth()).isCloseTo(one.maxDepth(), within(1e-9));
        assertThat(all.meanDepth()).isCloseTo(one.meanDepth(), within(1e-9));
    }

    @Test
    void theOrderOfTheCirclesDoesNotMatter() {
        Scene scene = Scenes.mixed(3000, 13);
        float[][] s = {scene.x(), scene.y(), scene.radius(), scene.mass(), scene.vx(), scene.vy()};
        Random random = new Random(14);
        for (int i = s[0].length - 1; i > 0; i--) {
            int j = random.nextInt(i + 1);
            for (float[] a : s) {
                float t = a[i];
                a[i] = a[j];
                a[j] = t;
            }
        }
        assertSame(Quality.of(s[0], s[1], s[2], s[3], s[4], s[5], s[0].length), Quality.of(scene));
    }

    private static float round(float value, int steps) {
        return (float) Math.round(value * steps) / steps;
    }

    private static void assertSame(Quality actual, Quality expected) {
        assertThat(actual.overlapping()).isEqualTo(expected.overlapping());
        assertThat(actual.deep()).isEqualTo(expected.deep());
        assertThat(actual.maxDepth()).isCloseTo(expected.maxDepth(), within(1e-9 * expected.maxDepth()));
        assertThat(actual.meanDepth()).isCloseTo(expected.meanDepth(), within(1e-9 * expected.meanDepth()));
        assertThat(actual.kineticEnergyPerCircle())
                .isCloseTo(expected.kineticEnergyPerCircle(), within(1e-9 * expected.kineticEnergyPerCircle()));
    }

    private static Quality bruteForce(Scene scene, float[] x, float[] y) {
        int n = scene.size();
        double meanRadius = 0;
        double energy = 0;
        for (int i = 0; i < n; i++) {
            meanRadius += (double) scene.radius(i) / n;
            energy += 0.5 * scene.mass(i) * (Math.pow(scene.vx(i), 2) + Math.pow(scene.vy(i), 2)) / n;
        }
        double sum = 0;
        double max = 0;
        long overlapping = 0;
        long deep = 0;
        for (int i = 0; i < n; i++) {
            for (int j = i + 1; j < n; j++) {
                double dx = (double) x[i] - x[j];
                double dy = (double) y[i] - y[j];
                double overlap = (double) scene.radius(i) + scene.radius(j) - Math.sqrt(dx * dx + dy * dy);
                if (overlap > 0) {
                    sum += overlap / meanRadius;
                    max = Math.max(max, overlap / meanRadius);
                    overlapping++;
                    deep += overlap / meanRadius > Quality.DEEP ? 1 : 0;
                }
            }
        }
        return new Quality(overlapping == 0 ? 0 : sum / overlapping, max, overlapping, deep, energy);
    }
}
