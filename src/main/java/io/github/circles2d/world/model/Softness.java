package io.github.circles2d.world.model;

/** A damped spring, as a visit needs it (E. Catto, "Soft Constraints", 2011). */
public final class Softness {
    /** Push-out speed per depth, 1/s. */
    public float biasRate;

    /** Share of a rigid impulse. */
    public float massScale;

    /** Share of the accumulated impulse that goes. */
    public float impulseScale;

    /** Angular frequency times h; twice the damping ratio. */
    void set(float omega, float damping, float inverseH) {
        biasRate = (omega / (damping + omega)) * inverseH;
        float a2 = omega * (damping + omega);
        impulseScale = 1f / (1f + a2);
        massScale = a2 * impulseScale;
    }
}
