package io.github.circles2d.calibration;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.junit.jupiter.api.Test;

class PickTest {
    private static final List<Integer> SIZES = List.of(250, 1_000, 3_000, 10_000, 30_000, 100_000);
    private static final List<Double> RATIOS = List.of(Crowd.LIKE, 3.0, 10.0, 100.0);

    /** The host's time grows with the number of circles, a device's only with the ratio of radii. */
    private static CurvesByRatio times(boolean host, List<Double> ratios) {
        Map<Double, Curve> curves = new TreeMap<>();
        for (double ratio : ratios) {
            Map<Integer, Double> millis = new TreeMap<>();
            SIZES.forEach(n -> millis.put(n, host ? n / 1000.0 : Math.max(1, ratio == Crowd.LIKE ? 1 : ratio)));
            curves.put(ratio, new Curve(Workload.WORLD, millis));
        }
        return new CurvesByRatio(curves);
    }

    private static Map<String, CurvesByRatio> candidates(List<Double> ofHost, List<Double> ofDevice) {
        Map<String, CurvesByRatio> candidates = new LinkedHashMap<>();
        candidates.put("host", times(true, ofHost));
        candidates.put("device", times(false, ofDevice));
        return candidates;
    }

    private static Pick<String> pick(int circles, double ratio) {
        return Pick.among(candidates(RATIOS, RATIOS), new Crowd(circles, ratio), name -> name.toUpperCase());
    }

    @Test
    void theFastestForTheNumberOfCirclesIsTakenAndTheReasonHasAllTimes() {
        assertThat(pick(500, 1).taken()).isEqualTo("host");
        assertThat(pick(500, 1).reason()).contains("500 circles", "HOST 0.5", "DEVICE 1.0");
        assertThat(pick(5_000, 1).taken()).isEqualTo("device");
        assertThat(pick(5_000, 1).reason()).contains("5000 circles", "HOST 5.", "DEVICE 1.0");
    }

    @Test
    void theRadiiDecideToo() {
        assertThat(pick(5_000, 1.5).taken()).isEqualTo("device");
        assertThat(pick(5_000, 10).taken()).isEqualTo("host");
        assertThat(pick(5_000, 10).reason()).contains("5000 circles of radii 1:10: HOST 5.");
        assertThat(pick(20_000, 10).taken()).isEqualTo("device");
        assertThat(pick(20_000, 50).taken()).isEqualTo("host");
    }

    @Test
    void likeRadiiDecideWhereMixedOnesHaveNotBeenMeasuredOfAllAndTheReasonSaysSo() {
        List<Double> like = List.of(Crowd.LIKE);
        for (Map<String, CurvesByRatio> partly : List.of(candidates(RATIOS, like), candidates(like, like))) {
            Pick<String> mixed = Pick.among(partly, new Crowd(5_000, 10), name -> name);
            assertThat(mixed.taken()).isEqualTo("device");
            assertThat(mixed.reason()).contains("5000 circles: host 5.", "device 1", "mixed radii are not calibrated");
            assertThat(Pick.among(partly, Crowd.like(5_000), name -> name).reason())
                    .doesNotContain("mixed");
        }
    }
}
