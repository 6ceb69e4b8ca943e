package io.github.circles2d.world.model;

/** How soft constraints are: a spring of a frequency and a damping ratio, as a visit needs it (E. Catto, "Soft Constraints", 2011). */
public final class Softness {
    /** Push-out speed per depth, 1/s. */
    public float biasRate;

    /** Share of the impulse of a rigid constraint. */
    public float massScale;

    /** Share of the accumulated impulse that a visit takes away. */
    public float impulseScale;

    Softness() {}

    /**
     * Sets it for sub-steps of a length.
     *
     * @param omega angular frequency times that length
     * @param damping twice the damping ratio
     * @param inverseH 1 / that length
     */
    void set(float omega, float damping, float inverseH) {
        biasRate = (omega / (damping + omega)) * inverseH;
        float a2 = omega * (damping + omega);
        impulseScale = 1f / (1f + a2);
        massScale = a2 * impulseScale;
    }
}
