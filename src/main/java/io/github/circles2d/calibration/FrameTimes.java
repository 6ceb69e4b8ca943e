package io.github.circles2d.calibration;

import java.util.Arrays;

/**
 * What loops took, in milliseconds: a quarter of the frames stay below lower, half below median, and a quarter go
 * beyond upper. Other programs only add time, and to some frames more than to others, so a wide middle half tells of
 * them.
 */
public record FrameTimes(double lower, double median, double upper) {
    /** Frames that all took as long. */
    public static FrameTimes steady(double millis) {
        return new FrameTimes(millis, millis, millis);
    }

    /** Sums up the first frames, at least 1, which it sorts. */
    public static FrameTimes of(long[] nanos, int count) {
        Arrays.sort(nanos, 0, count);
        return new FrameTimes(millis(nanos[count / 4]), millis(nanos[count / 2]), millis(nanos[3 * count / 4]));
    }

    private static double millis(long nanos) {
        return Math.max(1, nanos) / 1e6;
    }

    /** The upper end of the middle half over its lower one, at least 1. */
    double spread() {
        return upper / lower;
    }
}
