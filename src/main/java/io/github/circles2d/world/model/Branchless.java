package io.github.circles2d.world.model;

/** Choices that a processor could not predict, with the bits of the plain form. */
public final class Branchless {
    private static final int SIGN = 0x80000000;

    private Branchless() {}

    /** Not for NaN. */
    static float positive(float a) {
        int bits = Float.floatToRawIntBits(a);
        return Float.intBitsToFloat(bits & ~(bits >> 31));
    }

    /** All bits or none; not for NaN or -0. */
    static int isPositive(float a) {
        return -Float.floatToRawIntBits(a) >> 31;
    }

    /** All bits or none. */
    public static int isNotZero(float a) {
        return -(Float.floatToRawIntBits(a) & ~SIGN) >> 31;
    }

    /** All bits or none; all for -0; not for NaN. */
    static int isNegative(float a) {
        return Float.floatToRawIntBits(a) >> 31;
    }

    /** As {@link CircleMath#max}. */
    public static float greater(float a, float b) {
        return choose(isPositive(a - b), a, b);
    }

    public static float choose(int mask, float a, float b) {
        int other = Float.floatToRawIntBits(b);
        return Float.intBitsToFloat(other ^ ((Float.floatToRawIntBits(a) ^ other) & mask));
    }
}
