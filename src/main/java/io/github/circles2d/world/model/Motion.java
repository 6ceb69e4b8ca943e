package io.github.circles2d.world.model;

/** How velocities and paths follow from impulses, gravity, forces and limits. One component each. */
public final class Motion {
    private Motion() {}

    public static float afterImpulse(float v, float w, float impulse) {
        return limitSpeed(v + w * impulse);
    }

    public static float limitSpeed(float v) {
        return CircleMath.clamp(v, -Tuning.GREATEST_SPEED, Tuning.GREATEST_SPEED);
    }

    /** A factor of 1 changes no bit. */
    public static float beforeImpulse(float v, float gain, float dampingFactor) {
        return (v + gain) * dampingFactor;
    }

    /** The factor that makes a vector no longer than a length. */
    public static float shareWithin(float x, float y, float most) {
        float length = CircleMath.length(x, y);
        return length > most ? most / length : 1f;
    }

    /** What gravity and a force add in a sub-step; a force of 0 changes no bit. */
    public static float gain(float gravityGain, float force, float w, float h) {
        return force == 0f ? gravityGain : limitSpeed(gravityGain + force * w * h);
    }

    /** The path of a step if nothing is in its way; fall is what gravity adds to it. */
    public static float plan(float v, float dt, float fall) {
        return v * dt + fall;
    }

    /** May be too small if the way is very long. */
    public static float travelSpeed(float from, float to, float dt, float period) {
        return limitSpeed(Wrapping.shortWay(to - from, period) / dt);
    }
}
