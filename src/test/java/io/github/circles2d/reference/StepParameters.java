package io.github.circles2d.reference;

/**
 * The walls, the gravity and the times that a step is made with. Arrays hold a value for x and one for y.
 *
 * @param arena where the circles are; without walls that move
 * @param min the lower walls at the end of the step
 * @param max the upper walls at the end of the step
 * @param minIn what the lower walls come in during the step; negative if they go out
 * @param maxIn what the upper walls come in during the step; negative if they go out
 * @param sleep whether circles sleep
 */
record StepParameters(
        Arena arena,
        float[] min,
        float[] max,
        float[] minIn,
        float[] maxIn,
        float[] gravity,
        float dt,
        int subSteps,
        Settings settings,
        Surfaces surfaces,
        boolean sleep) {
    float h() {
        return dt / subSteps;
    }

    float inverseH() {
        return subSteps / dt;
    }

    /** What a wall that comes in moves in a sub-step. */
    float sweep(float in) {
        return in > 0f ? in / subSteps : 0f;
    }

    /** How far a wall that comes in is from its last place at the end of a sub-step. */
    float behind(float in, int subStep) {
        return sweep(in) * (subSteps - 1 - subStep);
    }
}
