package io.github.circles2d.world.model;

/**
 * Choices between floats without a branch, for loops in which the processor cannot predict a branch: a wrong guess costs more than
 * both sides. They give the bits of the plain form for every number that a state can hold.
 */
public final class Branchless {
    private static final int SIGN = 0x80000000;

    private Branchless() {}

    /** a where it is greater than 0, else 0; a must not be NaN. */
    static float positive(float a) {
        int bits = Float.floatToRawIntBits(a);
        return Float.intBitsToFloat(bits & ~(bits >> 31));
    }

    /** All bits set where a is greater than 0, else none; a must be neither NaN nor -0. */
    static int isPositive(float a) {
        return -Float.floatToRawIntBits(a) >> 31;
    }

    /** All bits set where a is neither 0 nor -0, else none. */
    public static int isNotZero(float a) {
        return -(Float.floatToRawIntBits(a) & ~SIGN) >> 31;
    }

    /** All bits set where a is less than 0, else none; all bits for -0; a must not be NaN. */
    static int isNegative(float a) {
        return Float.floatToRawIntBits(a) >> 31;
    }

    /** a where the mask has all bits set, b where it has none. */
    public static float choose(int mask, float a, float b) {
        int other = Float.floatToRawIntBits(b);
        return Float.intBitsToFloat(other ^ ((Float.floatToRawIntBits(a) ^ other) & mask));
    }
}
