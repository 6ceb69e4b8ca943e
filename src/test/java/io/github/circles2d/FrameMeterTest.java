package io.github.circles2d;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.circles2d.calibration.Crowd;
import java.util.Optional;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

class FrameMeterTest {
    private static final int N = 2_000;

    @Test
    void mixedCirclesFillTheArenaWithRadiiOfTheirRatioAndMassesByArea() {
        for (double ratio : new double[] {3, 10, 100}) {
            float[] circles = FrameMeter.mixed(new Crowd(N, ratio));
            double area = 0;
            float least = Float.POSITIVE_INFINITY;
            float greatest = 0;
            for (int i = 0; i < N; i++) {
                float r = circles[4 * i + 2];
                area += Math.PI * r * r;
                least = Math.min(least, r);
                greatest = Math.max(greatest, r);
                assertThat(circles[4 * i]).isBetween(r, 1 - r);
                assertThat(circles[4 * i + 1]).isBetween(r, 1 - r);
                assertThat(circles[4 * i + 3] / (r * r)).isCloseTo(1e5f, within(1f));
            }
            int below = 0;
            for (int i = 0; i < N; i++) {
                below += circles[4 * i + 2] < Math.sqrt((double) least * greatest) ? 1 : 0;
            }
            assertThat(area).isCloseTo(0.62, within(1e-4));
            assertThat(greatest / least).isBetween((float) (0.97 * ratio), (float) ratio);
            assertThat((double) below / N)
                    .as("the logarithms are spread evenly")
                    .isCloseTo(0.5, within(0.05));
            assertThat(FrameMeter.mixed(new Crowd(N, ratio))).isEqualTo(circles);
        }
    }

    @Test
    @Tag("long")
    void aWorldTakesTheFewestAndTheMostUnlikeCirclesThatAreMeasured() {
        FrameMeter meter = new FrameMeter();
        for (double ratio : Calibration.RATIOS) {
            assertThat(meter.world(Optional.empty(), new Crowd(Calibration.WORLD_SIZES.get(0), ratio))
                            .lower())
                    .isPositive();
        }
        Crowd most = new Crowd(Calibration.WORLD_SIZES.get(Calibration.WORLD_SIZES.size() - 1), 100);
        try (World world = World.builder().backend(Backend.JVM).build()) {
            world.addAll(FrameMeter.mixed(most), null);
            assertThat(world.size()).isEqualTo(most.circles());
        }
    }
}
