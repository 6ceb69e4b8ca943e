package io.github.circles2d.world.model;

/** Velocities and paths, by component. */
public final class Velocity {
    private Velocity() {}

    public static float limitSpeed(float v) {
        return CircleMath.clamp(v, -Tuning.GREATEST_SPEED, Tuning.GREATEST_SPEED);
    }

    public static float afterImpulse(float v, float w, float impulse) {
        return limitSpeed(v + w * impulse);
    }

    /** A factor of 1 changes no bit. */
    public static float beforeImpulse(float v, float gain, float dampingFactor) {
        return (v + gain) * dampingFactor;
    }

    public static float shareWithin(float x, float y, float most) {
        float length = CircleMath.length(x, y);
        return length > most ? most / length : 1f;
    }

    /** Speed by one component of gravity in a sub-step. */
    public static float gravityGain(float gravity, float scale, float h) {
        return limitSpeed(gravity * scale) * h;
    }

    /** Share of velocity that a sub-step leaves. */
    public static float dampingFactor(float damping, float h) {
        return 1f / (1f + damping * h);
    }

    /** Path per velocity in a step. */
    public static float dampedTime(float factor, int subSteps, float h, float dt) {
        float power = 1f;
        float powers = 0f;
        for (int subStep = 0; subStep < subSteps; subStep++) {
            power *= factor;
            powers += power;
        }
        return factor == 1f ? dt : h * powers;
    }

    /** How often a sub-step's gain moves a circle in a step. */
    public static float dampedFalls(float factor, int subSteps) {
        float power = 1f;
        float powers = 0f;
        float falls = 0f;
        for (int subStep = 0; subStep < subSteps; subStep++) {
            power *= factor;
            powers += power;
            falls += powers;
        }
        return falls;
    }

    /** In a sub-step; a force of 0 changes no bit. */
    public static float gain(float gravityGain, float force, float w, float h) {
        return force == 0f ? gravityGain : limitSpeed(gravityGain + force * w * h);
    }

    /** The path if nothing is in its way; fall is gravity's part. */
    public static float plan(float v, float dt, float fall) {
        return v * dt + fall;
    }

    /** Too small if the way is very long. */
    public static float travelSpeed(float from, float to, float dt, float period) {
        return limitSpeed(CircleMath.shortWay(to - from, period) / dt);
    }
}
