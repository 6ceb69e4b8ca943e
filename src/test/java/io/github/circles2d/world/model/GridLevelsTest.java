package io.github.circles2d.world.model;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.HashSet;
import java.util.Set;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

@Tag("each-jdk")
class GridLevelsTest {
    private static final float[] PLACES = {
        -3e9f, -1e9f, -64f, -0f, 0f, 1e-30f, 1e-6f, 0.5f, 1f, 64f, 1e5f, 0.9999e9f, 1e9f, 2e9f, 3e9f, Float.MAX_VALUE
    };

    private final SplittableRandom random = new SplittableRandom(8);
    private final GridLevels levels = new GridLevels();

    /** Bounds and radii of any size, also at the ends of the ranges; places that are far outside of the bounds, too. */
    @ParameterizedTest
    @EnumSource
    void everyPlaceHasACellOfTheTorusAndNoRangeOverflows(AxisEdge edge) {
        for (int k = 0; k < 2000; k++) {
            Bounds bounds = bounds(edge);
            int[] counts = new int[GridLevels.COUNT];
            counts[0] = 1;
            counts[random.nextInt(GridLevels.COUNT)] += 1 + random.nextInt(1 << random.nextInt(1, 20));
            float greatest = random.nextBoolean() ? bounds.greatestRadius() : bounds.leastRadius();
            levels.layOut(bounds, greatest, counts, random.nextBoolean());
            assertCells();
            float width = (float) random.nextDouble(bounds.maxX() - bounds.minX());
            levels.fit(1 + random.nextInt(1 << random.nextInt(1, 20)), width, random.nextFloat() * width);
            assertCells();
        }
    }

    /** A torus of 1,024 buckets has room for a floor of 250 by 2 cells, be the arena as high as it is wide. */
    @ParameterizedTest
    @EnumSource(names = {"WALL", "OPEN"})
    void cellsOfABoxThatHasAllCirclesShareNoBucketIfThereAreEnough(AxisEdge edge) {
        int[] counts = new int[GridLevels.COUNT];
        counts[0] = 1000;
        levels.layOut(Limits.bounds(0, 0, 1000, 1000).with(edge, edge), 0.5f, counts, false);
        float cell = 1 / levels.inverseEdge[0];
        assertThat(levels.areRoomy()).isTrue();
        assertThat(levels.folded[0]).isTrue();

        levels.fit(1000, 249 * cell, 1.9f * cell);

        assertThat(levels.folded[0]).isFalse();
        Set<Integer> buckets = new HashSet<>();
        for (int column = 0; column < 250; column++) {
            for (int row = 0; row < 2; row++) {
                float x = 200 + (column + 0.5f) * cell;
                float y = 100 + (row + 0.5f) * cell;
                buckets.add(levels.rowStart(0, levels.row(y, 0)) + levels.column(x, 0));
            }
        }
        assertThat(buckets).hasSizeGreaterThan(495).allMatch(bucket -> bucket < levels.buckets());
    }

    /** Its circles are spread over its cells: where they are does not matter. */
    @Test
    void anArenaThatCirclesFillIsNotRoomy() {
        int[] counts = new int[GridLevels.COUNT];
        counts[0] = 10_000;
        levels.layOut(Limits.bounds(0, 0, 120, 120), 0.5f, counts, false);
        assertThat(levels.areRoomy()).isFalse();
    }

    private void assertCells() {
        for (int l = 0; l < levels.usedCount; l++) {
            assertCellsOf(levels.used[l]);
        }
    }

    private Bounds bounds(AxisEdge edge) {
        float aspect = random.nextBoolean() ? 1 : 0.001f;
        double least = Limits.LEAST_EXTENT / aspect;
        float extent = random.nextInt(3) == 0
                ? 2e9f
                : (float) StrictMath.pow(10, random.nextDouble(StrictMath.log10(2 * least), 9));
        Bounds bounds = Limits.bounds(-extent / 2, -extent / 2 * aspect, extent / 2, extent / 2 * aspect)
                .with(edge, random.nextBoolean() ? edge : AxisEdge.OPEN);
        return Limits.edges(bounds);
    }

    private void assertCellsOf(int level) {
        float a = place();
        float b = place();
        float from = Math.min(a, b);
        float to = Math.max(a, b);
        assertThat(levels.column(a, level)).isBetween(0, levels.columnCount[level] - 1);
        assertThat(levels.row(a, level)).isBetween(0, levels.rowCount[level] - 1);
        int column = levels.columnFrom(from, level);
        int row = levels.rowFrom(from, level);
        assertThat(column).isNotNegative();
        assertThat(row).isNotNegative();
        assertThat(levels.columnTo(from, to, level) - column + 1).isPositive();
        assertThat(levels.rowTo(from, to, level) - row + 1).isPositive();
        assertThat(column + levels.columnCount[level]).isPositive();
        assertThat(row + levels.rowCount[level]).isPositive();
    }

    private float place() {
        return random.nextBoolean() ? PLACES[random.nextInt(PLACES.length)] : (float) random.nextDouble(-1e9, 1e9);
    }
}
