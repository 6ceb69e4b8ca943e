package io.github.circles2d.world.model;

/** e is a restitution, sum that of the radii. */
public final class Bounce {
    private Bounce() {}

    /** The square of a fall's speed, so piles rest, plus that of a creep, so clumps rest without gravity; 0 if elastic. */
    public static float bounceThreshold(float sum, float e, float gravityRate, float lengthRate, float fixed) {
        float length = inelasticity(e) * sum;
        float creep = lengthRate * length;
        return gravityRate * length + creep * creep + fixed;
    }

    public static float flightThreshold(float sum, float e, float gravityRate, float lengthRate, float fixed) {
        float creep = lengthRate * ((1f - e) * sum);
        return gravityRate * (inelasticity(e) * sum) + creep * creep + fixed;
    }

    public static float freeBounce(float e, float vn, float k) {
        return -(1f + e) * vn * k;
    }

    /** What gravity adds to vn in half a sub-step: so far velocities are ahead of positions, and a free bounce keeps the height. */
    public static float halfFall(float fall, float wLo, float wHi) {
        float half = 0.5f * fall;
        return wLo == 0f ? half : wHi == 0f ? -half : 0f;
    }

    /** How much too far from a wall a bounce ends, since it turns early. */
    public static float leftBehind(float gap, float vn, float gain, float dt, float r) {
        return gap > 0f && vn < 0f && -vn * dt <= r ? gain * (gap / -vn) : 0f;
    }

    private static float inelasticity(float e) {
        return CircleMath.min((1f - e) * (1f / (1f - Tuning.NEARLY_ELASTIC)), 1f);
    }
}
