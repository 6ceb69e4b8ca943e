package io.github.circles2d;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.circles2d.calibration.Crowd;
import java.util.Random;
import org.junit.jupiter.api.Test;

class MixedCrowdTest {
    private static final int N = 2_000;

    @Test
    void itFillsTheArenaWithRadiiOfTheRatioAndHardlyOverlaps() {
        for (double ratio : new double[] {3, 10, 100}) {
            float[] circles = MixedCrowd.of(new Crowd(N, ratio), new Random(1));
            double area = 0;
            double below = 0;
            float least = Float.POSITIVE_INFINITY;
            float greatest = 0;
            for (int i = 0; i < N; i++) {
                float r = circles[4 * i + 2];
                area += Math.PI * r * r;
                least = Math.min(least, r);
                greatest = Math.max(greatest, r);
                assertThat(circles[4 * i]).isBetween(r, 1 - r);
                assertThat(circles[4 * i + 1]).isBetween(r, 1 - r);
            }
            int overlaps = 0;
            for (int i = 0; i < N; i++) {
                float r = circles[4 * i + 2];
                below += r < Math.sqrt((double) least * greatest) ? 1 : 0;
                assertThat(circles[4 * i + 3] / (10 * r * r / (greatest * greatest)))
                        .isCloseTo(1, within(1e-5f));
                for (int j = 0; j < i; j++) {
                    double dx = circles[4 * i] - circles[4 * j];
                    double dy = circles[4 * i + 1] - circles[4 * j + 1];
                    overlaps += Math.hypot(dx, dy) < r + circles[4 * j + 2] ? 1 : 0;
                }
            }
            assertThat(area).isCloseTo(0.62, within(1e-4));
            assertThat(greatest / least).isBetween((float) (0.97 * ratio), (float) ratio);
            assertThat(below / N).as("the logarithms are spread evenly").isCloseTo(0.5, within(0.05));
            assertThat(overlaps).isLessThan(N / 5);
            assertThat(MixedCrowd.of(new Crowd(N, ratio), new Random(1))).isEqualTo(circles);
        }
    }
}
