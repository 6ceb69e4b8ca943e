package io.github.circles2d.teavm;

import org.teavm.backend.javascript.spi.InjectedBy;

/**
 * Numbers as Java has them, for JavaScript, whose numbers are all doubles. {@link StrictFloats} has the compiled program call these
 * methods; the casts in this class are those of JavaScript.
 */
public final class Floats {
    /** Whole numbers up to this magnitude are doubles. */
    private static final long EXACT = 1L << 53;

    /** The bits of a long that a double may lose. */
    private static final long LOST = 2047;

    private static final double INT_END = 0x1p31;
    private static final double LONG_END = 0x1p63;

    private Floats() {}

    /** The float that is nearest to a number. */
    @InjectedBy(Rounding.class)
    public static native float round(float value);

    /** A number, in brackets. */
    @InjectedBy(Brackets.class)
    public static native double inBrackets(double value);

    /** The float that is nearest to a whole number. */
    public static float ofLong(long value) {
        long kept = value;
        if (value >= EXACT || value <= -EXACT) {
            // A double has no room for the lowest bits. One bit says that some of them were set, so that rounding twice
            // is right.
            kept = value & ~LOST | ((value & LOST) == 0 ? 0 : LOST + 1);
        }
        return round((float) (double) kept);
    }

    /** The whole part of a number, or the nearest int; 0 for NaN. */
    public static int toInt(double value) {
        if (value >= INT_END) {
            return Integer.MAX_VALUE;
        }
        return value <= -INT_END ? Integer.MIN_VALUE : (int) value;
    }

    /** The whole part of a number, or the nearest long; 0 for NaN. */
    public static long toLong(double value) {
        if (value >= LONG_END) {
            return Long.MAX_VALUE;
        }
        if (value <= -LONG_END) {
            return Long.MIN_VALUE;
        }
        return value == value ? (long) value : 0;
    }
}
