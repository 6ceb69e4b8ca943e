package io.github.circles2d.world.model;

/**
 * Scalar formulas of several topics. {@code kernels/world/shared} has the functions of this room to the bit: they use {@code + - * /},
 * square roots, floors, comparisons and integers, in one bracketing, without contraction.
 *
 * <p>n is a normal from the lower id to the higher, vn the speed along n, negative in an approach, w an inverse mass.
 */
public final class CircleMath {
    private CircleMath() {}

    /** Like max, the second of +0 and -0; not for NaN. */
    public static float min(float a, float b) {
        return a < b ? a : b;
    }

    public static float max(float a, float b) {
        return a > b ? a : b;
    }

    /** If low is above high, low wins; a zero at a bound is the bound's. */
    public static float clamp(float a, float low, float high) {
        return max(min(a, high), low);
    }

    /** A period is infinite if its axis does not wrap; then nothing changes. */
    public static float shortWay(float d, float period) {
        float half = 0.5f * period;
        return d > half ? d - period : d < -half ? d + period : d;
    }

    /** Whole periods between min and a coordinate. */
    public static float laps(float x, float min, float period) {
        return (float) Math.floor((x - min) / period); // the floor of a float is exact
    }

    /** Of a path: at most an eighth, so circles meet the short way alone. */
    public static float shareOfPeriod(float p, float period) {
        float most = 0.125f * period;
        float way = Math.abs(p);
        return way > most ? most / way : 1f;
    }

    public static float length(float x, float y) {
        return (float) Math.sqrt(x * x + y * y);
    }

    public static float dot(float nx, float ny, float vx, float vy) {
        return nx * vx + ny * vy;
    }

    public static boolean isLonger(float ux, float uy, float length) {
        return ux * ux + uy * uy > length * length;
    }

    /** Of positions: of bases, and of displacements. */
    public static float difference(float base, float from, float to) {
        return base + (to - from);
    }

    /** base + displacement - sum, exactly (Knuth). */
    public static float lostByRounding(float base, float displacement, float sum) {
        float part = sum - base;
        return (base - (sum - part)) + (displacement - part);
    }

    /** Exactly 0 for a static circle. */
    public static float inverseMass(float mass) {
        return 1f / mass;
    }

    /** A circle's own value, or that of its kind if it is NaN; likewise of a kind and the world. */
    public static float orOfKind(float own, float ofKind) {
        return Float.isNaN(own) ? ofKind : own;
    }

    /** The displacement that keeps the sum in a range. */
    public static float within(float base, float displacement, float low, float high) {
        float x = base + displacement;
        return x < low ? low - base : x > high ? high - base : displacement;
    }
}
