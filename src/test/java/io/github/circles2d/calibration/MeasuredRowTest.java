package io.github.circles2d.calibration;

import static io.github.circles2d.Refusals.assertIllegalState;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalStateException;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/** What a calibration takes for clean, what it measures again, and how it refuses. */
@Tag("each-jdk")
class MeasuredRowTest {
    private final Map<Integer, Deque<FrameTimes>> given = new HashMap<>();
    private final List<Integer> measured = new ArrayList<>();

    /** The times of a size, one after the other; the last of them for good. */
    private void give(int circles, FrameTimes... times) {
        given.put(circles, new ArrayDeque<>(List.of(times)));
    }

    private FrameTimes meter(int circles) {
        measured.add(circles);
        Deque<FrameTimes> times = given.get(circles);
        return times.size() > 1 ? times.poll() : times.peek();
    }

    private MeasuredRow measure(int... sizes) {
        MeasuredRow row = new MeasuredRow("Circles2D on a machine", this::meter);
        for (int circles : sizes) {
            row.measure(circles);
        }
        return row;
    }

    private static FrameTimes millis(double median) {
        return FrameTimes.steady(median);
    }

    @Test
    void timesThatGrowAsTheWorkDoesOrNotAtAllAreTakenOnce() {
        give(1_000, millis(1));
        give(3_000, new FrameTimes(2, 3, 3.9));
        give(10_000, millis(2.1)); // a plan that is made for more circles
        give(30_000, millis(2.1 * 8.9));
        MeasuredRow row = measure(1_000, 3_000, 10_000, 30_000);
        assertThat(measured).containsExactly(1_000, 3_000, 10_000, 30_000);
        assertThat(row.curve().measured()).isEqualTo(Map.of(1_000, 1.0, 3_000, 3.0, 10_000, 2.1, 30_000, 2.1 * 8.9));
    }

    @Test
    void aTimeOfLoopsMayGrowAsThePairsDo() {
        give(1_000, millis(1));
        give(8_000, millis(100));
        measure(1_000, 8_000);
        assertThat(measured).containsExactly(1_000, 8_000);
        give(8_000, millis(200));
        assertThatIllegalStateException().isThrownBy(() -> measure(1_000, 8_000));
    }

    @Test
    void aWideSizeIsMeasuredAgainAndTheCleanTimeIsKeptHoweverLong() {
        give(1_000, new FrameTimes(0.5, 0.9, 1.1), millis(1));
        MeasuredRow row = measure(1_000);
        assertThat(measured).containsExactly(1_000, 1_000);
        assertThat(row.curve().measured()).isEqualTo(Map.of(1_000, 1.0));
    }

    @Test
    void whatJumpsIsMeasuredAgainWithTheSizeBeforeIt() {
        give(1_000, millis(0.12));
        give(3_000, millis(4), millis(1));
        MeasuredRow row = measure(1_000, 3_000);
        assertThat(measured).containsExactly(1_000, 3_000, 1_000, 3_000);
        assertThat(row.curve().measured()).isEqualTo(Map.of(1_000, 0.12, 3_000, 1.0));
    }

    @Test
    void aSizeThatTookLongerThanALargerOneIsMeasuredAgain() {
        give(1_000, millis(0.9), millis(0.3));
        give(3_000, millis(0.5));
        MeasuredRow row = measure(1_000, 3_000);
        assertThat(row.curve().measured()).isEqualTo(Map.of(1_000, 0.3, 3_000, 0.5));
    }

    @Test
    void aRowThatJumpsForGoodIsRefusedWithItsNameAndFigures() {
        give(1_000, millis(0.12));
        give(3_000, millis(4));
        assertThatIllegalStateException()
                .isThrownBy(() -> measure(1_000, 3_000))
                .withMessage(
                        "the times of Circles2D on a machine are not clean after 4 attempts: 1,000 circles took 0.120 ms and"
                                + " 3,000 took 4.00, 33.3 times as long instead of 0.667 to 27.0. Other programs seem to use the"
                                + " machine: calibrate when they have ended");
        assertThat(measured).hasSize(8);
    }

    @Test
    void aRowThatFallsOrIsWideForGoodIsRefusedWithItsFigures() {
        give(1_000, millis(4));
        give(3_000, millis(2));
        assertIllegalState(
                "1,000 circles took 4.00 ms and 3,000 took 2.00, 0.500 times as long", () -> measure(1_000, 3_000));
        give(1_000, new FrameTimes(1, 2, 5));
        assertIllegalState(
                "the middle half of the frames of 1,000 circles took 1.00 to 5.00 ms, more than 2.00 times apart",
                () -> measure(1_000));
    }

    @Test
    void theTimesOfFramesAreTheirQuartiles() {
        long[] nanos = {9_000_000, 1_000_000, 3_000_000, 2_000_000, 4_000_000, 0};
        assertThat(FrameTimes.of(nanos, 5)).isEqualTo(new FrameTimes(2, 3, 4));
        assertThat(FrameTimes.of(new long[1], 1)).isEqualTo(FrameTimes.steady(1e-6));
    }
}
