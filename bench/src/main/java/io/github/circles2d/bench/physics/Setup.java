package io.github.circles2d.bench.physics;

/**
 * What a scene asks of the world that it runs in. Lengths are metres, gravity points down.
 *
 * @param gravity magnitude of gravity
 * @param restitution of every circle and wall
 * @param subSteps of World, per step
 * @param fast whether Box2D is to treat the circles as bullets
 */
record Setup(
        float minX, float minY, float maxX, float maxY, float gravity, float restitution, int subSteps, boolean fast) {
    /** A box with its lower left corner at the origin, without gravity, with restitution 0.5 and 4 sub-steps. */
    static Setup box(double width, double height) {
        return new Setup(0, 0, (float) width, (float) height, 0, 0.5f, 4, false);
    }

    /** A box around the origin, without gravity, with restitution 0.5 and 4 sub-steps. */
    static Setup around(double halfWidth, double halfHeight) {
        return new Setup(
                (float) -halfWidth, (float) -halfHeight, (float) halfWidth, (float) halfHeight, 0, 0.5f, 4, false);
    }

    Setup withGravity(double gravity) {
        return new Setup(minX, minY, maxX, maxY, (float) gravity, restitution, subSteps, fast);
    }

    Setup withRestitution(double restitution) {
        return new Setup(minX, minY, maxX, maxY, gravity, (float) restitution, subSteps, fast);
    }

    Setup withSubSteps(int subSteps) {
        return new Setup(minX, minY, maxX, maxY, gravity, restitution, subSteps, fast);
    }

    Setup withFastCircles() {
        return new Setup(minX, minY, maxX, maxY, gravity, restitution, subSteps, true);
    }

    float width() {
        return maxX - minX;
    }

    float height() {
        return maxY - minY;
    }
}
