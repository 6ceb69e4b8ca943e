package io.github.circles2d.world.model;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

class ReachTest {
    private static final float GREATEST_RADIUS = 0.3f;

    private final int top = Reach.topExponent(GREATEST_RADIUS);

    @Test
    void classesSpanAFactorOfTwo() {
        SplittableRandom random = new SplittableRandom(1);
        for (int k = 0; k < 10_000; k++) {
            float r = GREATEST_RADIUS * (float) Math.pow(2, -19 * random.nextDouble());
            float reach = Reach.reachOf(r, r * Tuning.TRAVEL * (float) random.nextDouble(), false);
            int reachClass = Reach.reachClassOf(reach, top);
            assertThat(reachClass).isBetween(0, 31);
            assertThat(reach)
                    .isLessThan(Reach.topReach(reachClass, top))
                    .isGreaterThanOrEqualTo(Reach.topReach(reachClass, top) / 2);
        }
    }

    @Test
    void theGreatestReachIsOfClass0AndTheLeastOfTheLast() {
        float greatest = Reach.reachOf(GREATEST_RADIUS, Tuning.TRAVEL * GREATEST_RADIUS, false);
        assertThat(Reach.reachClassOf(greatest, top)).isZero();
        assertThat(Reach.reachClassOf(1e-30f, top)).isEqualTo(31);
    }

    @Test
    void aReachCoversThePathAndMore() {
        assertThat(Reach.reachOf(1f, 2f, false)).isGreaterThan(3f);
        assertThat(Reach.reachOf(1f, 2f, true))
                .isGreaterThan(1f + Tuning.MARGIN)
                .isLessThan(1.1f);
    }

    /** Of two circles whose reaches meet, the one of the lesser reach finds the other in few cells of its class. */
    @Test
    void circlesWhoseReachesMeetAreFoundInFewCells() {
        SplittableRandom random = new SplittableRandom(2);
        for (int k = 0; k < 100_000; k++) {
            float min = (float) random.nextDouble(-100, 100);
            float x = min + (float) random.nextDouble(200);
            float reach = (float) Math.pow(2, -10 * random.nextDouble());
            float others = reach * (1f + 9f * (float) random.nextDouble());
            float other = x + (reach + others) * (float) random.nextDouble(-1, 1);
            int reachClass = Reach.reachClassOf(others, top);
            float inverseEdge = Reach.inverseReachEdge(reachClass, top);
            float far = 1.001f * (reach + Reach.topReach(reachClass, top));
            int from = Reach.reachCell(x - far, min, inverseEdge);
            int to = Reach.reachCell(x + far, min, inverseEdge);
            assertThat(Reach.reachCell(other, min, inverseEdge)).isBetween(from, to);
            assertThat(to - from).isLessThan(5);
        }
    }

    @Test
    void cellsFarAwayAreOne() {
        float inverseEdge = Reach.inverseReachEdge(20, top);
        assertThat(Reach.reachCell(1e9f, 0f, inverseEdge)).isEqualTo(Reach.reachCell(0.9e9f, 0f, inverseEdge));
        assertThat(Reach.reachCell(-1e9f, 0f, inverseEdge)).isLessThan(0);
    }

    /** Also those of a lattice, whose cells have many factors in common. */
    @Test
    void bucketsAreSharedByFew() {
        int buckets = Reach.reachBuckets(1 << 12);
        assertThat(buckets).isEqualTo(1 << 13);
        for (int spacing : new int[] {1, 64, 1024}) {
            int[] circles = new int[buckets];
            for (int k = 0; k < 1 << 12; k++) {
                circles[Reach.reachBucket(spacing * (k & 63), spacing * (k >> 6), 7, buckets)]++;
            }
            assertThat(Arrays.stream(circles).max().orElseThrow()).isLessThan(12);
        }
    }
}
