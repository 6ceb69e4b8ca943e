package io.github.circles2d.world;

/**
 * Every floating-point formula of the World engine, in small functions of scalars. The file {@code
 * kernels/world/CircleMath.cl} has the same functions under the same names, and both give the same bits: nothing but
 * {@code + - * /}, square roots, comparisons and integer operations, each written in one fixed bracketing, never
 * contracted.
 *
 * <p>Units: lengths, masses and seconds are the caller's. n is the contact normal, a unit vector from the circle of the
 * lower id to that of the higher; s the separation of two surfaces, negative where they overlap; vn the relative speed
 * along n, negative where they approach; w an inverse mass, 0 for a fixed circle.
 */
public final class CircleMath {
    private CircleMath() {}

    // ---- geometry
    // ----------------------------------------------------------------------------------------------------

    /**
     * Length of a vector.
     *
     * @param x component
     * @param y component
     * @return the length
     */
    public static float norm(float x, float y) {
        return (float) Math.sqrt(x * x + y * y);
    }

    /**
     * The lesser of two numbers; the second where they are equal.
     *
     * @param a a number, not NaN
     * @param b a number, not NaN
     * @return the lesser
     */
    public static float least(float a, float b) {
        return a < b ? a : b;
    }

    /**
     * The greater of two numbers; the second where they are equal.
     *
     * @param a a number, not NaN
     * @param b a number, not NaN
     * @return the greater
     */
    public static float greatest(float a, float b) {
        return a > b ? a : b;
    }

    /**
     * A number brought into a range.
     *
     * @param a a number, not NaN
     * @param low the least result
     * @param high the greatest result; where it is less than low, low wins
     * @return a, or the end of the range nearest to it
     */
    public static float bounded(float a, float low, float high) {
        return greatest(least(a, high), low);
    }

    /**
     * Difference of two positions, each given as a base that stays for a step and a displacement since.
     *
     * @param base difference of the bases
     * @param from displacement of the first
     * @param to displacement of the second
     * @return second minus first
     */
    public static float difference(float base, float from, float to) {
        return base + (to - from);
    }

    /**
     * What the sum of a base and a displacement lost by rounding (the exact error of an addition, after Knuth).
     *
     * @param base a
     * @param displacement b
     * @param sum fl(a + b)
     * @return a + b - fl(a + b), exactly
     */
    public static float lostByRounding(float base, float displacement, float sum) {
        float part = sum - base;
        return (base - (sum - part)) + (displacement - part);
    }

    /**
     * Inverse mass.
     *
     * @param mass greater than 0; infinite for a fixed circle
     * @return 1 / mass, exactly 0 for a fixed circle
     */
    public static float inverseMass(float mass) {
        return 1f / mass;
    }

    /**
     * One component of a velocity after an impulse.
     *
     * @param v before
     * @param w inverse mass
     * @param impulse component of the impulse
     * @return after
     */
    public static float afterImpulse(float v, float w, float impulse) {
        return bounded(v + w * impulse, -Tuning.GREATEST_SPEED, Tuning.GREATEST_SPEED);
    }

    // ---- broad phase
    // -------------------------------------------------------------------------------------------------

    /**
     * How far from its centre a circle looks for contacts: its radius, a margin, and what it moves in a step, up to a limit.
     * Two circles are listed as a contact where the distance of their centres is less than the sum of their reaches.
     *
     * @param r radius
     * @param vx velocity
     * @param vy velocity
     * @param dt length of the step
     * @param margin margin, in radii
     * @param cap greatest motion looked ahead for, in radii
     * @return the reach
     */
    public static float reach(float r, float vx, float vy, float dt, float margin, float cap) {
        return (r + margin * r) + least(norm(vx, vy) * dt, cap * r);
    }

    /**
     * The level of a radius: level k holds radii in (rmax / 2^(k+1), rmax / 2^k], the last level all smaller ones too.
     *
     * @param r radius
     * @param rmax greatest radius of all circles
     * @return 0 to {@link Levels#COUNT} - 1
     */
    public static int level(float r, float rmax) {
        int level = 0;
        float half = rmax * 0.5f;
        while (r <= half && level < Levels.COUNT - 1) {
            level++;
            half *= 0.5f;
        }
        return level;
    }

    /**
     * The number of the grid column (or row) of a coordinate.
     *
     * @param x coordinate, not less than min
     * @param min where column 0 begins
     * @param inverseEdge 1 / the edge of a cell
     * @return the column, at least 0
     */
    public static int cell(float x, float min, float inverseEdge) {
        return (int) greatest((x - min) * inverseEdge, 0f);
    }

    /**
     * The first of two columns (or rows) that are equal or next to each other on a ring.
     *
     * @param a a column
     * @param b a column
     * @param mask columns of the ring, a power of two of at least 4, minus 1
     * @return b where a follows b, else a
     */
    public static int ringFirst(int a, int b, int mask) {
        return ((b + 1) & mask) == a ? b : a;
    }

    /**
     * A well-mixed number of a pair of ids (the finalizer of MurmurHash3, twice).
     *
     * @param lo the lower id
     * @param hi the higher id
     * @return 32 mixed bits
     */
    public static int pairHash(int lo, int hi) {
        return mix(mix(lo) + hi);
    }

    private static int mix(int h) {
        h = (h ^ (h >>> 16)) * 0x85ebca6b;
        h = (h ^ (h >>> 13)) * 0xc2b2ae35;
        return h ^ (h >>> 16);
    }

    /**
     * x of the direction in which two circles with one centre part; not of unit length, never zero.
     *
     * @param hash the hash of the pair
     * @return a number from -511.5 to 511.5
     */
    public static float partingX(int hash) {
        return (float) (hash & 1023) - 511.5f;
    }

    /**
     * y of the direction in which two circles with one centre part.
     *
     * @param hash the hash of the pair
     * @return a number from -511.5 to 511.5
     */
    public static float partingY(int hash) {
        return (float) ((hash >>> 10) & 1023) - 511.5f;
    }

    // ---- contacts
    // ----------------------------------------------------------------------------------------------------

    /**
     * Component of a relative velocity along a normal.
     *
     * @param nx normal
     * @param ny normal
     * @param vx velocity of the second minus that of the first
     * @param vy velocity of the second minus that of the first
     * @return vn
     */
    public static float along(float nx, float ny, float vx, float vy) {
        return nx * vx + ny * vy;
    }

    /**
     * Whether a speed is an approach fast enough to bounce.
     *
     * @param vn normal speed
     * @param thr2 square of the bounce threshold
     * @return vn is less than minus the threshold
     */
    public static boolean approaches(float vn, float thr2) {
        return vn < 0f && vn * vn > thr2;
    }

    /**
     * Whether a speed is a separation that no contact should brake.
     *
     * @param vn normal speed
     * @param thr2 square of the bounce threshold
     * @return vn is greater than the threshold
     */
    public static boolean separates(float vn, float thr2) {
        return vn > 0f && vn * vn > thr2;
    }

    /**
     * Whether a contact carries its circles: it presses, or touches at rest.
     *
     * @param lambda its impulse
     * @param s separation
     * @param vn normal speed
     * @param thr2 square of the bounce threshold
     * @return true where it does
     */
    public static boolean carries(float lambda, float s, float vn, float thr2) {
        return lambda > 0f || (s < 0f && vn * vn <= thr2);
    }

    /**
     * The separation speed that a loaded contact bounces to, or 0 where it does not bounce in this sub-step.
     *
     * @param e restitution of the pair
     * @param vn normal speed at the start of the sub-step, before any impulse
     * @param s separation
     * @param h length of the sub-step
     * @param thr2 square of the bounce threshold
     * @return a speed greater than 0, or 0
     */
    public static float bounceSpeed(float e, float vn, float s, float h, float thr2) {
        return approaches(vn, thr2) && s + vn * h < 0f ? -e * vn : 0f;
    }

    /**
     * Impulse by which two free circles bounce.
     *
     * @param e restitution of the pair
     * @param vn normal speed, negative
     * @param k effective mass 1 / (w_lo + w_hi)
     * @return an impulse greater than 0
     */
    public static float freeBounce(float e, float vn, float k) {
        return -(1f + e) * vn * k;
    }

    /**
     * The accumulated impulse of a rigid contact after one visit: it stops the approach, or as much of it as would close the
     * gap within the sub-step, or brings the pair to a target speed.
     *
     * @param lambda accumulated impulse before
     * @param k effective mass
     * @param vn normal speed
     * @param b bias speed: gap / h where there is a gap, minus the target speed of a bounce, else 0
     * @return accumulated impulse, at least 0
     */
    public static float rigid(float lambda, float k, float vn, float b) {
        return greatest(lambda - k * (vn + b), 0f);
    }

    /**
     * The accumulated impulse of a soft contact after one visit (soft constraints: E. Catto, "Solver2D", 2024).
     *
     * @param lambda accumulated impulse before
     * @param k effective mass
     * @param vn normal speed
     * @param s separation, at most 0
     * @param push greatest push-out speed
     * @param biasRate push-out speed per depth
     * @param massScale softness: share of the impulse
     * @param impulseScale softness: decay of the impulse
     * @return accumulated impulse, at least 0
     */
    public static float soft(
            float lambda, float k, float vn, float s, float push, float biasRate, float massScale, float impulseScale) {
        float b = massScale * greatest(biasRate * s, -push);
        return greatest((lambda - k * (massScale * vn + b)) - impulseScale * lambda, 0f);
    }

    /**
     * Greatest push-out speed of a pair.
     *
     * @param sum sum of the radii
     * @param perLength the part that grows with the radii, speed per length
     * @param perRoot the part that grows with gravity, speed per root of a length
     * @return the greater of the two
     */
    public static float pushSpeed(float sum, float perLength, float perRoot) {
        return greatest(perLength * sum, perRoot * (float) Math.sqrt(sum));
    }

    // ---- walls
    // -------------------------------------------------------------------------------------------------------

    /**
     * The wall of an axis that a circle is nearer to: its direction away from that wall.
     *
     * @param x coordinate
     * @param min lower wall
     * @param max upper wall
     * @return 1 for the lower wall, -1 for the upper
     */
    public static float wallSide(float x, float min, float max) {
        return x - min <= max - x ? 1f : -1f;
    }

    /**
     * Separation of a circle from a wall.
     *
     * @param base coordinate at the start of the step
     * @param displacement displacement since
     * @param r radius
     * @param side the wall, by {@link #wallSide}
     * @param min lower wall
     * @param max upper wall
     * @return s
     */
    public static float wallGap(float base, float displacement, float r, float side, float min, float max) {
        return side > 0f ? ((base - min) - r) + displacement : ((max - base) - r) - displacement;
    }

    /**
     * The part of a circle's stored wall impulse that belongs to one side.
     *
     * @param signed stored impulse, positive where the lower wall pushes
     * @param side the wall
     * @return at least 0
     */
    public static float wallImpulse(float signed, float side) {
        return greatest(side * signed, 0f);
    }

    /**
     * A displacement, cut so that a coordinate stays in a range.
     *
     * @param base coordinate at the start of the step
     * @param displacement displacement since
     * @param low least coordinate
     * @param high greatest coordinate
     * @return the displacement, or what leads to the end of the range
     */
    public static float within(float base, float displacement, float low, float high) {
        float x = base + displacement;
        return x < low ? low - base : x > high ? high - base : displacement;
    }
}
