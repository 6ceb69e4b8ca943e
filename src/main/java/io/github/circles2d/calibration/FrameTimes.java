package io.github.circles2d.calibration;

import java.util.Arrays;

/**
 * What loops took. Other programs only add time, and to some frames more than to others, so a wide middle half tells of
 * them.
 *
 * @param lower the time, in milliseconds, that a quarter of the frames stay below
 * @param median the time that half of the frames stay below
 * @param upper the time that a quarter of the frames go beyond
 */
public record FrameTimes(double lower, double median, double upper) {
    /**
     * Frames that all took as long.
     *
     * @param millis milliseconds
     * @return the times
     */
    public static FrameTimes steady(double millis) {
        return new FrameTimes(millis, millis, millis);
    }

    /**
     * Sums frames up.
     *
     * @param nanos what each took; sorted by it
     * @param count how many there are, at least 1
     * @return the times
     */
    public static FrameTimes of(long[] nanos, int count) {
        Arrays.sort(nanos, 0, count);
        return new FrameTimes(millis(nanos[count / 4]), millis(nanos[count / 2]), millis(nanos[3 * count / 4]));
    }

    private static double millis(long nanos) {
        return Math.max(1, nanos) / 1e6;
    }

    /**
     * How wide the middle half is.
     *
     * @return its upper end over its lower one, at least 1
     */
    double spread() {
        return upper / lower;
    }
}
