package io.github.circles2d.calibration;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;

import java.util.LinkedHashMap;
import java.util.Map;
import org.junit.jupiter.api.Test;

class CurveTest {
    @Test
    void aPowerLawIsMetBetweenTheSizesThatWereMeasured() {
        Curve curve = new Curve(Map.of(100, 2.0, 10_000, 20.0)); // 0.2 sqrt(n)
        assertThat(curve.millis(100)).isEqualTo(2);
        assertThat(curve.millis(10_000)).isEqualTo(20);
        for (int n : new int[] {101, 400, 1_000, 9_999}) {
            assertThat(curve.millis(n)).isCloseTo(0.2 * Math.sqrt(n), within(1e-9));
        }
    }

    @Test
    void belowTheLeastSizeTheTimeIsConstantAndAboveTheGreatestItGrowsAsThePairsDo() {
        Map<Integer, Double> measured = Map.of(100, 2.0, 1_000, 3.0);
        for (int n : new int[] {0, 1, 99}) {
            assertThat(new Curve(measured).millis(n)).isEqualTo(2);
        }
        assertThat(new Curve(measured).millis(5_000)).isCloseTo(75, within(1e-9));
    }

    @Test
    void whatIsNoMeasurementIsRefused() {
        assertThatIllegalArgumentException().isThrownBy(() -> new Curve(Map.of()));
        assertThatIllegalArgumentException().isThrownBy(() -> new Curve(Map.of(0, 1.0)));
        for (double time : new double[] {0, -1, Double.NaN, Double.POSITIVE_INFINITY}) {
            assertThatIllegalArgumentException().isThrownBy(() -> new Curve(Map.of(1, time)));
        }
    }

    @Test
    void theFastestWinsByMoreThanNoiseElseThePreferredOne() {
        Map<String, Curve> candidates = new LinkedHashMap<>();
        candidates.put("preferred", new Curve(Map.of(100, 1.0, 1_000, 10.0)));
        candidates.put("other", new Curve(Map.of(100, 0.97, 1_000, 5.0)));
        assertThat(Timings.fastest(candidates, 100)).isEqualTo("preferred");
        assertThat(Timings.fastest(candidates, 150)).isEqualTo("other");
        assertThat(Timings.fastest(candidates, 1_000_000)).isEqualTo("other");
        assertThat(Timings.words(candidates, 1_000, name -> name)).contains("1000 circles", "preferred 10", "other 5");
    }
}
