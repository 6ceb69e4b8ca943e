package io.github.circles2d.reference;

/** The walls, the gravity and the times that a step is made with. Arrays hold a value for x and one for y. */
record StepParameters(float[] min, float[] max, float[] gravity, float dt, int subSteps) {
    float h() {
        return dt / subSteps;
    }

    float inverseH() {
        return subSteps / dt;
    }
}
