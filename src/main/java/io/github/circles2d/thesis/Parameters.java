package io.github.circles2d.thesis;

import java.util.Objects;

/** The scalars of a simulation, checked. Immutable. */
public final class Parameters {
    final float timeStep;
    final float restitution;
    final float gravityX;
    final float gravityY;

    private Parameters(float timeStep, float restitution, float gravityX, float gravityY) {
        this.timeStep = timeStep;
        this.restitution = restitution;
        this.gravityX = gravityX;
        this.gravityY = gravityY;
    }

    /**
     * Takes seconds from 1e-6 to 1, a restitution from 0 to 1, and gravity along x and y from -1e4 to 1e4. Throws
     * IllegalArgumentException if one of them is out of its range.
     */
    public static Parameters of(float timeStep, float restitution, float[] gravity) {
        Ranges.timeStep(timeStep);
        Ranges.restitution(restitution);
        Objects.requireNonNull(gravity, "gravity");
        if (gravity.length != 2) {
            throw new IllegalArgumentException("gravity must have two values, x and y, not " + gravity.length);
        }
        // Each element is read once: another thread may write to the array.
        float x = gravity[0];
        float y = gravity[1];
        Ranges.gravity(x, y);
        return new Parameters(timeStep, restitution, x, y);
    }
}
