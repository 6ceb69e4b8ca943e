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
     * Checks the scalars of a simulation.
     *
     * @param timeStep seconds, finite and greater than 0
     * @param restitution from 0 to 1
     * @param gravity two finite values
     * @return the parameters
     * @throws IllegalArgumentException if one of them is out of its range
     */
    public static Parameters of(float timeStep, float restitution, float[] gravity) {
        Checks.positive("the time step", timeStep);
        if (!(restitution >= 0 && restitution <= 1)) {
            throw new IllegalArgumentException("the restitution must be from 0 to 1, not " + restitution);
        }
        Objects.requireNonNull(gravity, "gravity");
        if (gravity.length != 2) {
            throw new IllegalArgumentException("gravity must have two values, x and y, not " + gravity.length);
        }
        Checks.finite("the x of gravity", gravity[0]);
        Checks.finite("the y of gravity", gravity[1]);
        return new Parameters(timeStep, restitution, gravity[0], gravity[1]);
    }
}
