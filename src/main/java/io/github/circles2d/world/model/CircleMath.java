package io.github.circles2d.world.model;

/**
 * Formulas of scalars that more than one topic needs. The topics have a class each: {@link Wrapping}, {@link Motion}, {@link
 * Paths},
 * {@link TimeOfImpact}, {@link Cells}, {@link Bounce} and {@link Walls}; visits are in {@link Constraints}.
 *
 * <p>The files in {@code kernels/world/shared} have the same functions, and both give the same bits: they use {@code + - * /},
 * square
 * roots, floors, comparisons and integer operations, in one fixed bracketing, and no contraction.
 *
 * <p>n is the normal of a contact, a unit vector from the circle of the lower id to that of the higher; vn the relative speed along
 * n,
 * negative if they approach; w an inverse mass, 0 for a static circle.
 */
public final class CircleMath {
    private CircleMath() {}

    public static float length(float x, float y) {
        return (float) Math.sqrt(x * x + y * y);
    }

    /** The second of two equal numbers: of +0 and -0 too, so it is no {@link Math#min}. No NaN. */
    public static float min(float a, float b) {
        return a < b ? a : b;
    }

    /** The second of two equal numbers: of +0 and -0 too, so it is no {@link Math#max}. No NaN. */
    public static float max(float a, float b) {
        return a > b ? a : b;
    }

    /** If low is greater than high, low wins. A zero at a bound has the sign of the bound. */
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
