package io.github.circles2d.playground;

import java.util.Arrays;

/** The last values of a figure. */
final class History {
    static final int LENGTH = 300;

    private final float[] values = new float[LENGTH];
    private int count;

    void add(double value) {
        values[count++ % LENGTH] = (float) value;
    }

    void clear() {
        count = 0;
    }

    /** The values, the newest last. */
    float[] values() {
        if (count <= LENGTH) {
            return Arrays.copyOf(values, count);
        }
        float[] ordered = new float[LENGTH];
        int oldest = count % LENGTH;
        System.arraycopy(values, oldest, ordered, 0, LENGTH - oldest);
        System.arraycopy(values, 0, ordered, LENGTH - oldest, oldest);
        return ordered;
    }
}
