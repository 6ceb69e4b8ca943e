package io.github.circles2d.world.model;

/** When impacts bounce, and by how much. e is a restitution, sum the sum of the radii. */
public final class Bounce {
    private Bounce() {}

    /**
     * The square of the speed up to which impacts do not bounce: that of a fall from a part of a radius, so piles rest, and a
     * creeping speed, so clumps rest without gravity. 0 for elastic pairs.
     */
    public static float bounceThreshold(float sum, float e, float gravityRate, float lengthRate, float fixed) {
        float length = inelasticity(e) * sum;
        float creep = lengthRate * length;
        return gravityRate * length + creep * creep + fixed;
    }

    /** The same of circles that nothing carries; their creeping speed is lower. */
    public static float flightThreshold(float sum, float e, float gravityRate, float lengthRate, float fixed) {
        float creep = lengthRate * ((1f - e) * sum);
        return gravityRate * (inelasticity(e) * sum) + creep * creep + fixed;
    }

    public static float freeBounce(float e, float vn, float k) {
        return -(1f + e) * vn * k;
    }

    /**
     * What gravity adds to vn in half a sub-step: velocities are so far ahead of positions. A free bounce turns the velocity of the
     * position, so it keeps the height.
     */
    public static float halfFall(float fall, float wLo, float wHi) {
        float half = 0.5f * fall;
        return wLo == 0f ? half : wHi == 0f ? -half : 0f;
    }

    /** By how much a bounce off a wall would end too far from it, since it turns too early; 0 if the path is longer than r. */
    public static float leftBehind(float gap, float vn, float gain, float dt, float r) {
        return gap > 0f && vn < 0f && -vn * dt <= r ? gain * (gap / -vn) : 0f;
    }

    private static float inelasticity(float e) {
        return CircleMath.min((1f - e) * (1f / (1f - Tuning.NEARLY_ELASTIC)), 1f);
    }
}
