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
        Bounds bounds, float gravityX, float gravityY, float restitution, int subSteps, float previousTimeStep) {}
