package io.github.circles2d.world.circles;

import io.github.circles2d.world.model.Bounds;

/**
 * What a world has besides its circles.
 *
 * @param bounds the arena
 * @param gravityX gravity
 * @param gravityY gravity
 * @param restitution what new circles get
 * @param subSteps sub-steps per step
 * @param previousTimeStep length of the last step, seconds; 0 before the first
 */
public record WorldParameters(
        Bounds bounds, float gravityX, float gravityY, float restitution, int subSteps, float previousTimeStep) {
    /** Whether all components are the same. Unlike equals, this leaves no garbage, nor does an object that is made for it. */
    public boolean isSame(WorldParameters other) {
        return other != null
                && bounds == other.bounds
                && same(gravityX, other.gravityX)
                && same(gravityY, other.gravityY)
                && same(restitution, other.restitution)
                && subSteps == other.subSteps
                && same(previousTimeStep, other.previousTimeStep);
    }

    private static boolean same(float a, float b) {
        return Float.floatToRawIntBits(a) == Float.floatToRawIntBits(b);
    }
}
