package io.github.circles2d.calibration;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.junit.jupiter.api.Test;

class CurvesByRatioTest {
    private static final List<Integer> SIZES = List.of(250, 1_000, 3_000, 10_000, 30_000, 100_000);
    private static final List<Double> RATIOS = List.of(Crowd.LIKE, 3.0, 10.0, 100.0);

    /** The time of a frame, made up. */
    private interface Engine {
        double millis(double circles, double ratio);
    }

    private static Curve curve(Map<Integer, Double> millis) {
        return new Curve(Workload.WORLD, millis);
    }

    private static CurvesByRatio measured(Engine engine, List<Double> ratios) {
        Map<Double, Curve> curves = new TreeMap<>();
        for (double ratio : ratios) {
            Map<Integer, Double> millis = new TreeMap<>();
            SIZES.forEach(n -> millis.put(n, engine.millis(n, ratio)));
            curves.put(ratio, curve(millis));
        }
        return new CurvesByRatio(curves);
    }

    private static double millis(CurvesByRatio curves, double ratio, int circles) {
        return CurvesByRatio.at(ratio, Map.of("it", curves)).get("it").millis(circles);
    }

    @Test
    void aPowerLawIsMetBetweenTheRatiosAndSizesThatWereMeasured() {
        Engine law = (n, ratio) -> 0.01 * Math.pow(n, 0.7) * Math.pow(ratio, 0.3);
        CurvesByRatio curves = measured(law, RATIOS);
        for (double ratio : new double[] {1.5, 1.6, 3, 10, 42, 100}) {
            for (int n : new int[] {250, 600, 1_000, 54_321, 100_000}) {
                assertThat(millis(curves, ratio, n) / law.millis(n, ratio)).isCloseTo(1, within(1e-9));
            }
        }
        assertThat(millis(curves, 1, 600)).isEqualTo(millis(curves, Crowd.LIKE, 600));
        assertThat(millis(curves, 1e6, 600)).isEqualTo(millis(curves, 100, 600));
    }

    @Test
    void aRatioThatWasMeasuredAtFewerSizesTakesPartAtAll() {
        CurvesByRatio curves = new CurvesByRatio(
                Map.of(Crowd.LIKE, curve(Map.of(100, 1.0, 1_000, 1.0, 10_000, 16.0)), 6.0, curve(Map.of(1_000, 4.0))));
        assertThat(millis(curves, 3, 1_000)).isCloseTo(2, within(1e-9));
        assertThat(millis(curves, 3, 10_000)).isCloseTo(Math.sqrt(16 * 40), within(1e-9));
        assertThat(millis(curves, 3, 100)).isCloseTo(2, within(1e-9));
        assertThat(millis(curves, 3, 100_000)).isCloseTo(Math.sqrt(160 * 400), within(1e-9));
    }

    @Test
    void allAreComparedByTheRatiosThatEachWasMeasuredAt() {
        CurvesByRatio known = measured((n, ratio) -> ratio, RATIOS);
        CurvesByRatio partly = measured((n, ratio) -> 2 * ratio, List.of(Crowd.LIKE, 10.0));
        CurvesByRatio old = measured((n, ratio) -> 3 * ratio, List.of(Crowd.LIKE));
        Map<String, CurvesByRatio> all = new LinkedHashMap<>(Map.of("known", known, "partly", partly));
        assertThat(CurvesByRatio.common(all.values())).containsExactly(Crowd.LIKE, 10.0);
        assertThat(CurvesByRatio.at(100, all).get("known").millis(500)).isCloseTo(10, within(1e-9));
        assertThat(CurvesByRatio.at(100, all).get("partly").millis(500)).isCloseTo(20, within(1e-9));
        all.put("old", old);
        assertThat(CurvesByRatio.common(all.values())).containsExactly(Crowd.LIKE);
        for (double ratio : new double[] {1, 10, 100}) {
            assertThat(CurvesByRatio.at(ratio, all).get("known").millis(500)).isCloseTo(1.5, within(1e-9));
            assertThat(CurvesByRatio.at(ratio, all).get("old").millis(500)).isCloseTo(4.5, within(1e-9));
        }
    }

    /**
     * A processor whose work grows with the circles, a device that is slow to launch and slower with radii, and one that shares
     * work well and dislikes mixed radii less.
     */
    @Test
    void thePickIsWithinTenPercentOfTheBestBetweenTheSizesAndRatiosThatWereMeasured() {
        Map<String, Engine> engines = new LinkedHashMap<>();
        engines.put("processor", (n, ratio) -> 0.02 + 3e-5 * Math.pow(n, 1.05) * Math.pow(ratio, 0.15));
        engines.put("device", (n, ratio) -> 0.12 * Math.pow(ratio, 0.65) + 2.5e-6 * n * Math.pow(ratio, 0.1));
        engines.put("threads", (n, ratio) -> 0.08 * Math.pow(ratio, 0.4) + 2e-5 * n * Math.pow(ratio, 0.12));
        Map<String, CurvesByRatio> measured = new LinkedHashMap<>();
        engines.forEach((name, engine) -> measured.put(name, measured(engine, RATIOS)));

        Map<String, Integer> picks = new TreeMap<>();
        double worstByLikeRadii = 1;
        for (double ratio = 1.5; ratio <= 100; ratio *= 1.1) {
            for (int n = 250; n <= 200_000; n += n / 9) {
                double r = ratio;
                int circles = n;
                double best = engines.values().stream()
                        .mapToDouble(engine -> engine.millis(circles, r))
                        .min()
                        .orElseThrow();
                String pick = Timings.fastest(CurvesByRatio.at(r, measured), n);
                assertThat(engines.get(pick).millis(n, r))
                        .as("%s for %d circles of 1:%s", pick, n, r)
                        .isLessThanOrEqualTo(1.1 * best);
                picks.merge(pick, 1, Integer::sum);
                String byLikeRadii = Timings.fastest(CurvesByRatio.at(1, measured), n);
                worstByLikeRadii =
                        Math.max(worstByLikeRadii, engines.get(byLikeRadii).millis(n, r) / best);
            }
        }
        assertThat(picks).containsOnlyKeys("processor", "device", "threads");
        assertThat(worstByLikeRadii).isGreaterThan(2);
    }

    @Test
    void aRatioHasANameThatIsReadAgain() {
        assertThat(CurvesByRatio.variant(Crowd.LIKE)).isEmpty();
        assertThat(CurvesByRatio.variant(10)).isEqualTo("1:10");
        for (double ratio : new double[] {Crowd.LIKE, 2, 2.5, 10, 1e6}) {
            assertThat(CurvesByRatio.ratio(CurvesByRatio.variant(ratio))).isEqualTo(ratio);
        }
    }

    @Test
    void withoutLikeRadiiNothingCanBeCompared() {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new CurvesByRatio(Map.of(10.0, curve(Map.of(1, 1.0)))))
                .withMessageContaining("like radii");
    }
}
