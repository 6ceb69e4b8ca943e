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
    /**
     * Whether these are the components, in their order. Comparing with an object of them would leave garbage.
     *
     * @return true if all bits are the same
     */
    public boolean has(
            Bounds otherBounds,
            float otherGravityX,
            float otherGravityY,
            float otherRestitution,
            int otherSubSteps,
            float otherTimeStep) {
        return bounds == otherBounds
                && same(gravityX, otherGravityX)
                && same(gravityY, otherGravityY)
                && same(restitution, otherRestitution)
                && subSteps == otherSubSteps
                && same(previousTimeStep, otherTimeStep);
    }

    private static boolean same(float a, float b) {
        return Float.floatToRawIntBits(a) == Float.floatToRawIntBits(b);
    }
}
