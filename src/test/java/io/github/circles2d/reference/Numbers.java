package io.github.circles2d.reference;

/** Arithmetic whose result is defined to the bit, also for zeros of both signs. A vector is an array of its x and its y. */
final class Numbers {
    private static final float GREATEST_SPEED = 1e9f;

    private Numbers() {}

    /** The second if they are equal. */
    static float min(float a, float b) {
        return a < b ? a : b;
    }

    /** The second if they are equal. */
    static float max(float a, float b) {
        return a > b ? a : b;
    }

    static float clamp(float a, float low, float high) {
        return max(min(a, high), low);
    }

    static float limitSpeed(float v) {
        return clamp(v, -GREATEST_SPEED, GREATEST_SPEED);
    }

    static float sqrt(float a) {
        return (float) Math.sqrt(a);
    }

    static float dot(float[] a, float[] b) {
        return a[0] * b[0] + a[1] * b[1];
    }

    static float length(float... a) {
        return sqrt(dot(a, a));
    }

    static float[] unit(float... a) {
        return new float[] {a[0] / length(a), a[1] / length(a)};
    }

    static float[] minus(float[] a, float[] b) {
        return new float[] {a[0] - b[0], a[1] - b[1]};
    }

    static float[] plus(float[] a, float[] b) {
        return new float[] {a[0] + b[0], a[1] + b[1]};
    }
}
