package io.github.circles2d.reference;

/** Arithmetic whose result is defined to the bit, also for zeros of both signs. */
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

    static float length(float x, float y) {
        return (float) Math.sqrt(x * x + y * y);
    }

    static float limitSpeed(float v) {
        return clamp(v, -GREATEST_SPEED, GREATEST_SPEED);
    }
}
