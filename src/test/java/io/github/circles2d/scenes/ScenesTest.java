package io.github.circles2d.scenes;

import static io.github.circles2d.Refusals.assertIllegalArgument;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.function.LongFunction;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

class ScenesTest {
    static Stream<Scene> all() {
        return Stream.of(
                Scenes.thesis(1250, 1),
                Scenes.packed(10_000, 1),
                Scenes.gas(2000, 1),
                Scenes.pyramid(),
                Scenes.barrel(1),
                Scenes.balls2(),
                Scenes.confined(),
                Scenes.restitution(),
                Scenes.nexusBalls2(),
                Scenes.bouncy(1),
                Scenes.noCollide(),
                Scenes.billiards(10),
                Scenes.mixed(5000, 1),
                Scenes.packedSimilar(10_000, 1),
                Scenes.mixed(1, 100, 1),
                Scenes.mixed(1250, 10, 1),
                Scenes.mixed(10_000, 100, 1),
                Scenes.boulder(2, 1),
                Scenes.boulder(1000, 1),
                Scenes.boulder(100_000, 1),
                Scenes.boulder(1_000_000, 1),
                Scenes.onePoint(100, 1),
                Scenes.oneCell(100, 1));
    }

    static Stream<LongFunction<Scene>> seeded() {
        return Stream.of(
                seed -> Scenes.thesis(100, seed),
                seed -> Scenes.packed(100, seed),
                seed -> Scenes.gas(100, seed),
                Scenes::barrel,
                Scenes::bouncy,
                seed -> Scenes.mixed(100, seed),
                seed -> Scenes.packedSimilar(100, seed),
                seed -> Scenes.mixed(100, 10, seed),
                seed -> Scenes.boulder(100, seed),
                seed -> Scenes.onePoint(100, seed),
                seed -> Scenes.oneCell(100, seed));
    }

    @ParameterizedTest
    @MethodSource("all")
    void everyCircleLiesWithinTheArenaAndEveryParameterIsInItsRange(Scene scene) {
        for (int i = 0; i < scene.size(); i++) {
            float r = scene.radius(i);
            assertThat(r).isPositive();
            assertThat(scene.x(i)).isBetween(scene.minX() + r, scene.maxX() - r);
            assertThat(scene.y(i)).isBetween(scene.minY() + r, scene.maxY() - r);
            assertThat(scene.mass(i)).isPositive().isFinite();
            assertThat(scene.restitution(i)).isBetween(0f, 1f);
        }
        assertThat(scene.restitution()).isBetween(0f, 1f);
        assertThat(scene.timeStep()).isEqualTo(1f / 60f);
    }

    @ParameterizedTest
    @MethodSource("all")
    void indexedAccessorsReadTheSameAsTheArrays(Scene scene) {
        int last = scene.size() - 1;
        assertThat(scene.x()).hasSize(scene.size()).endsWith(scene.x(last));
        assertThat(scene.y()).hasSize(scene.size()).endsWith(scene.y(last));
        assertThat(scene.radius()).hasSize(scene.size()).endsWith(scene.radius(last));
        assertThat(scene.mass()).hasSize(scene.size()).endsWith(scene.mass(last));
        assertThat(scene.vx()).hasSize(scene.size()).endsWith(scene.vx(last));
        assertThat(scene.vy()).hasSize(scene.size()).endsWith(scene.vy(last));
        assertThat(scene.restitutions()).hasSize(scene.size()).endsWith(scene.restitution(last));
        assertThat(scene.fixed()).hasSize(scene.size()).endsWith(scene.fixed(last));
    }

    @ParameterizedTest
    @MethodSource("seeded")
    void theSameSeedGivesTheSameSceneAndAnotherSeedAnother(LongFunction<Scene> factory) {
        assertThat(factory.apply(5).radius()).isEqualTo(factory.apply(5).radius());
        assertThat(factory.apply(5).x()).isEqualTo(factory.apply(5).x());
        assertThat(factory.apply(6).radius())
                .satisfiesAnyOf(
                        radii -> assertThat(radii).isNotEqualTo(factory.apply(5).radius()),
                        radii -> assertThat(factory.apply(6).x())
                                .isNotEqualTo(factory.apply(5).x()));
    }

    @Test
    void changingAnArrayThatWasReadLeavesTheSceneAsItIs() {
        Scene scene = Scenes.thesis(10, 1);
        float before = scene.x(0);
        scene.x()[0] = -1;
        assertThat(scene.x(0)).isEqualTo(before);
    }

    @Test
    void thesisDrawsWithinThePublishedRanges() {
        Scene scene = Scenes.thesis(15_000, Scenes.SEED);
        for (int i = 0; i < scene.size(); i++) {
            assertThat(scene.x(i)).isBetween(0.1f, 0.9f);
            assertThat(scene.y(i)).isBetween(0.1f, 0.9f);
            assertThat(scene.radius(i)).isBetween(0.01f, 0.015f);
            assertThat(scene.mass(i)).isBetween(1f, 10f);
        }
        assertThat(scene.gravityX()).isZero();
        assertThat(scene.gravityY()).isEqualTo(-0.01f);
        assertThat(scene.restitution()).isEqualTo(0.5f);
        assertThat(scene.fill()).isCloseTo(7.46, within(0.05));
    }

    @Test
    void packedSimilarHasTheCirclesOfPackedAndFallsAsFastInRadiiAtEverySize() {
        for (int n : new int[] {1250, 20_000, 1_000_000}) {
            Scene packed = Scenes.packed(n, Scenes.SEED);
            Scene similar = Scenes.packedSimilar(n, Scenes.SEED);
            assertThat(similar.x()).isEqualTo(packed.x());
            assertThat(similar.y()).isEqualTo(packed.y());
            assertThat(similar.radius()).isEqualTo(packed.radius());
            assertThat(similar.mass()).isEqualTo(packed.mass());
            double meanRadius = 0.0125 * Math.sqrt(1250.0 / n);
            assertThat(similar.gravityY() / meanRadius).isCloseTo(-0.8, within(1e-6));
        }
    }

    @Test
    void mixedRadiiAreLogUniformAtTheFillOfPackedWithMassesAsTheirSquares() {
        for (int ratio : new int[] {10, 100}) {
            Scene scene = Scenes.mixed(20_000, ratio, Scenes.SEED);
            float[] radii = scene.radius();
            Arrays.sort(radii);
            assertThat(scene.name()).isEqualTo("mixed-" + ratio);
            assertThat(scene.fill()).isCloseTo(0.62, within(1e-4));
            assertThat(radii[19_999] / radii[0]).isBetween(0.99f * ratio, (float) ratio);
            // The median of a log-uniform radius is the geometric mean of its ends.
            assertThat(radii[10_000] / radii[0]).isCloseTo((float) Math.sqrt(ratio), within(0.05f * ratio));
            assertThat(scene.mass(7)).isCloseTo(1e5f * scene.radius(7) * scene.radius(7), within(1e-4f));
            assertThat(scene.gravityY()).isEqualTo(-0.01f);
        }
    }

    @Test
    void aBoulderLiesOnABedOfGrainsAThousandTimesSmallerWithoutAnOverlap() {
        for (int n : new int[] {2, 5000, 100_000}) {
            Scene scene = Scenes.boulder(n, Scenes.SEED);
            double sum = 0;
            for (int i = 1; i < n; i++) {
                sum += scene.radius(i);
            }
            assertThat(scene.radius(0) / (sum / (n - 1))).isCloseTo(1000, within(n == 2 ? 250.0 : 10));
            assertThat(Quality.of(scene).overlapping()).isZero();
        }
        Scene scene = Scenes.boulder(100_000, Scenes.SEED);
        double under = scene.y(0) - scene.radius(0);
        assertThat(under).isBetween(0.05, 0.15);
        for (int i = 1; i < scene.size(); i++) {
            assertThat(scene.y(i)).isLessThan((float) under);
        }
    }

    @Test
    void sizesAndRatiosThatMakeNoSceneAreRefused() {
        assertIllegalArgument("at least 1: 0", () -> Scenes.mixed(100, 0, 1));
        assertIllegalArgument("at least 2 circles, not 1", () -> Scenes.boulder(1, 1));
    }

    @Test
    void packedIsTheThesisSceneAt1250AndKeepsItsFillAtEverySize() {
        Scene thesis = Scenes.thesis(1250, Scenes.SEED);
        Scene packed = Scenes.packed(1250, Scenes.SEED);
        assertThat(packed.x()).isEqualTo(thesis.x());
        assertThat(packed.y()).isEqualTo(thesis.y());
        assertThat(packed.radius()).isEqualTo(thesis.radius());
        assertThat(packed.mass()).isEqualTo(thesis.mass());
        for (int n : new int[] {1250, 15_000, 1_000_000}) {
            assertThat(Scenes.packed(n, Scenes.SEED).fill()).isCloseTo(0.62, within(0.01));
        }
    }

    @Test
    void gasStartsWithoutOverlapsAtItsFillAndSpeeds() {
        Scene scene = Scenes.gas(20_000, Scenes.SEED);
        assertThat(Quality.of(scene).overlapping()).isZero();
        assertThat(scene.fill()).isCloseTo(0.3, within(0.005));
        assertThat(scene.gravityY()).isZero();
        assertThat(scene.restitution()).isEqualTo(1);
        for (int i = 0; i < scene.size(); i++) {
            assertThat(Math.hypot(scene.vx(i), scene.vy(i))).isBetween(0.05 - 1e-6, 0.2 + 1e-6);
        }
    }

    @Test
    void pyramidNarrowsFromFiveCirclesBelowToOneOnTop() {
        Scene scene = Scenes.pyramid();
        float[] rows = scene.y();
        assertThat(scene.size()).isEqualTo(15);
        for (int row = 0; row < 5; row++) {
            float y = 0.6f - 0.1f * row;
            assertThat(Arrays.stream(toDoubles(rows)).filter(v -> (float) v == y))
                    .hasSize(row + 1);
        }
        // neighbours in a row touch, to rounding
        assertThat(Quality.of(scene).maxDepth()).isLessThan(1e-5);
    }

    @Test
    void sizesAreThePublishedOnes() {
        assertThat(Scenes.barrel(1).size()).isEqualTo(3900);
        assertThat(Scenes.balls2().size()).isEqualTo(12_500);
        assertThat(Scenes.confined().size()).isEqualTo(625);
        assertThat(Scenes.restitution().size()).isEqualTo(22);
        assertThat(Scenes.nexusBalls2().size()).isEqualTo(61_504);
        assertThat(Scenes.bouncy(1).size()).isEqualTo(500);
        assertThat(Scenes.noCollide().size()).isEqualTo(33 * 25 + 28);
        assertThat(Scenes.billiards(1).size()).isEqualTo(16);
    }

    @Test
    void onlyTheLowestRowOfBalls2IsFixed() {
        Scene scene = Scenes.balls2();
        for (int i = 0; i < scene.size(); i++) {
            assertThat(scene.fixed(i)).isEqualTo(scene.y(i) == 1);
        }
    }

    @Test
    void moversOfNoCollideNeverTouchOnTheirExactPaths() {
        Scene scene = Scenes.noCollide();
        int n = scene.size();
        float[] x = scene.x();
        float[] y = scene.y();
        // 60 s, some nine crossings each way, in steps short against the gaps between the circles
        for (int step = 0; step < 24_000; step++) {
            double t = step / 400.0;
            for (int i = n - 28; i < n; i++) {
                x[i] = (float) reflected(scene.x(i) + t * scene.vx(i), 330);
                y[i] = (float) reflected(scene.y(i) + t * scene.vy(i), 250);
            }
            for (int i = n - 28; i < n; i++) {
                for (int j = 0; j < i; j++) {
                    double dx = x[i] - x[j];
                    double dy = y[i] - y[j];
                    if (dx * dx + dy * dy < 9.5 * 9.5) {
                        throw new AssertionError("circles " + j + " and " + i + " meet at t = " + t);
                    }
                }
            }
        }
    }

    @Test
    void mixedSpansTwoDecadesOfRadiiAtItsFill() {
        Scene scene = Scenes.mixed(10_000, Scenes.SEED);
        float[] sorted = scene.radius();
        Arrays.sort(sorted);
        assertThat(sorted[0]).isBetween(0.0005f, 0.00052f);
        assertThat(sorted[sorted.length - 1]).isBetween(0.048f, 0.05f);
        assertThat(scene.fill()).isCloseTo(0.5, within(1e-4));
    }

    @Test
    void everyPairOverlapsWhereAllCirclesShareAPointOrACell() {
        long pairs = 300L * 299 / 2;
        assertThat(Quality.of(Scenes.onePoint(300, 1)).overlapping()).isEqualTo(pairs);
        assertThat(Quality.of(Scenes.oneCell(300, 1)).overlapping()).isEqualTo(pairs);
        assertThat(Scenes.onePoint(300, 1).x()).containsOnly(0.5f);
    }

    @Test
    void badParametersAreRefusedWithTheirValue() {
        assertIllegalArgument("at least 1 circle, not 0", () -> Scenes.thesis(0, 1));
        assertIllegalArgument("-3", () -> Scenes.packed(-3, 1));
        assertIllegalArgument("NaN", () -> Scenes.billiards(Float.NaN));
        assertIllegalArgument("not 0", () -> Scenes.gas(0, 1));
    }

    @Test
    void aGasOfOneCircleFits() {
        assertThat(Scenes.gas(1, 1).size()).isOne();
    }

    private static double reflected(double p, double half) {
        double q = Math.floorMod((long) Math.floor(p + half), (long) (4 * half)) + (p + half - Math.floor(p + half));
        return q <= 2 * half ? q - half : 3 * half - q;
    }

    private static double[] toDoubles(float[] a) {
        double[] d = new double[a.length];
        for (int i = 0; i < a.length; i++) {
            d[i] = a[i];
        }
        return d;
    }
}
