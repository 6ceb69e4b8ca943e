package io.github.circles2d.world.model;

/**
 * Formulas of scalars that several topics need: {@link Wrapping}, {@link Motion}, {@link Paths}, {@link TimeOfImpact}, {@link
 * Cells}, {@link Bounce}, {@link Walls}, and visits in {@link Constraints}.
 *
 * <p>{@code kernels/world/shared} has the same functions, with the same bits: they use {@code + - * /}, square roots, floors,
 * comparisons and integers, in one bracketing, without contraction.
 *
 * <p>n is a normal from the lower id to the higher; vn the relative speed along n, negative in an approach; w an inverse mass, 0
 * for a static circle.
 */
public final class CircleMath {
    private CircleMath() {}

    public static float length(float x, float y) {
        return (float) Math.sqrt(x * x + y * y);
    }

    /** Of +0 and -0 the second, unlike {@link Math#min}. Not for NaN. */
    public static float min(float a, float b) {
        return a < b ? a : b;
    }

    /** Of +0 and -0 the second, unlike {@link Math#max}. Not for NaN. */
    public static float max(float a, float b) {
        return a > b ? a : b;
    }

    /** If low is above high, low wins. A zero at a bound has the sign of the bound. */
    public static float clamp(float a, float low, float high) {
        return max(min(a, high), low);
    }

    public static float dot(float nx, float ny, float vx, float vy) {
        return nx * vx + ny * vy;
    }

    public static boolean isLonger(float ux, float uy, float length) {
        return ux * ux + uy * uy > length * length;
    }

    /** Of two positions, each a base that stays for a step and a displacement since. */
    public static float difference(float base, float from, float to) {
        return base + (to - from);
    }

    /** base + displacement - sum, exactly (Knuth); sum is the rounded sum of both. */
    public static float lostByRounding(float base, float displacement, float sum) {
        float part = sum - base;
        return (base - (sum - part)) + (displacement - part);
    }

    /** Exactly 0 for a static circle, whose mass is infinite. */
    public static float inverseMass(float mass) {
        return 1f / mass;
    }

    /** The displacement, cut so that base + displacement stays in a range. */
    public static float within(float base, float displacement, float low, float high) {
        float x = base + displacement;
        return x < low ? low - base : x > high ? high - base : displacement;
    }
}
