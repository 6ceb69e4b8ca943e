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
