package io.github.circles2d.reference;

/** The walls, the gravity and the times that a step is made with. Arrays hold a value for x and one for y. */
record StepParameters(float[] min, float[] max, float[] gravity, float dt, int subSteps) {
    float h() {
        return dt / subSteps;
    }

    float inverseH() {
        return subSteps / dt;
    }

    float gravityStep(int axis) {
        return gravity[axis] * h();
    }

    /** How far gravity moves a circle in a step. */
    float fall(int axis) {
        return gravityStep(axis) * h() * (0.5f * subSteps * (subSteps + 1));
    }
}
