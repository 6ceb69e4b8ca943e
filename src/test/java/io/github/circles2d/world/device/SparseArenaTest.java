package io.github.circles2d.world.device;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.circles2d.opencl.Device;
import io.github.circles2d.opencl.OnEachDevice;
import io.github.circles2d.world.jvm.JvmPipeline;
import io.github.circles2d.world.jvm.SparseArena;
import io.github.circles2d.world.model.Bounds;
import io.github.circles2d.world.shared.Pipeline;
import java.util.Random;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Few circles in a vast arena, where far cells share buckets: the work stays in proportion, and the bits are the same. */
class SparseArenaTest {
    /** Candidate pairs of a circle: of the same level, and of a coarser one. */
    private static final int MOST_PAIRS = 8;

    private static final Bounds UNIT = new Bounds(0, 0, 1, 1);

    private static Pipeline java() {
        return new JvmPipeline(1, JvmPipeline.LEAST_SHARE, 0, false);
    }

    @ParameterizedTest
    @ValueSource(ints = {10_000, 2500})
    void latticesHaveFewCandidatePairs(int circles) {
        int side = (int) Math.sqrt(circles);
        for (int spacing : new int[] {32, 64, 100, 127, 128, 256}) {
            assertFewCandidatePairs(side, spacing, java());
        }
    }

    @OnEachDevice
    @Tag("long")
    void latticesHaveFewCandidatePairsOnDevices(Device device) {
        for (int spacing : new int[] {32, 64, 100, 128, 256}) {
            assertFewCandidatePairs(50, spacing, PipelinesAgreeTest.pipelines(device));
        }
    }

    private static void assertFewCandidatePairs(int side, int spacing, Pipeline... pipelines) {
        try (Twins twins = Twins.empty(UNIT, pipelines)) {
            SparseArena.lattice(side, spacing, twins::add);
            twins.step(1 / 60f, 1);
            twins.assertEqual("spacing " + spacing);
            twins.assertSameFigures();
            assertThat(pipelines[0].candidatePairs())
                    .as("candidate pairs of %d circles, %d cells apart", side * side, spacing)
                    .isLessThan((long) MOST_PAIRS * side * side);
        }
    }

    @Test
    void latticesOfTwoLevelsHaveFewCandidatePairs() {
        for (int spacing : new int[] {32, 64, 100, 128, 256}) {
            Pipeline pipeline = java();
            try (Twins twins = Twins.empty(UNIT, pipeline)) {
                SparseArena.lattice(50, spacing, twins::add);
                SparseArena.lattice(100, 4 * spacing, twins::add);
                twins.step(1 / 60f, 1);
                assertThat(pipeline.candidatePairs())
                        .as("candidate pairs of two lattices, %d and %d cells apart", spacing, 4 * spacing)
                        .isLessThan(2 * MOST_PAIRS * 12_500L);
            }
        }
    }

    /** From the smallest torus to one of several tiles; an arena with many times as many columns. */
    @OnEachDevice
    @Tag("long")
    void neighboursAcrossTheEdgesOfTheTorusHaveTheSameBitsOnTheDeviceAsInJava(Device device) {
        for (int groups : new int[] {40, 150, 600, 2000}) {
            try (Twins twins = Twins.empty(UNIT, PipelinesAgreeTest.pipelines(device))) {
                SparseArena.groups(groups, 3000, new Random(groups), twins::add);
                for (int k = 0; k < 4; k++) {
                    twins.step(1 / 60f, 2);
                    twins.assertEqual(groups + " groups after " + 2 * (k + 1) + " steps");
                }
                twins.assertSameFigures();
            }
        }
    }
}
