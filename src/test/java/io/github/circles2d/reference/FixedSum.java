package io.github.circles2d.reference;

import java.util.Arrays;

/** A sum of vectors in whole units, which comes out the same in any order. The third component of two vectors is that along their surfaces. */
final class FixedSum {
    private static final int BITS = 44;
    private static final int LEAST_EXPONENT = -80;
    private static final float GREATEST_TERM = 0x1p56f;

    private final float unit;
    private final float scale;
    private final long[] sum = new long[4];

    /** A sum of which the power of two below a range is 2^44 units. */
    FixedSum(float range) {
        int exponent = Math.max(Math.getExponent(range), LEAST_EXPONENT);
        unit = Math.scalb(1f, exponent - BITS);
        scale = Math.scalb(1f, BITS - exponent);
    }

    void add(int axis, float term) {
        sum[axis] += (long) Numbers.clamp(term * scale, -GREATEST_TERM, GREATEST_TERM);
    }

    /** Returns the sum, and begins anew. */
    float[] take() {
        float[] taken = {(float) sum[0] * unit, (float) sum[1] * unit, (float) sum[2] * unit, (float) sum[3] * unit};
        Arrays.fill(sum, 0);
        return taken;
    }
}
