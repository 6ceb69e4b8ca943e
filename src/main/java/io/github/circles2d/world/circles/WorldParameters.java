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
 * @param wallStart where the walls start in the next step: not the bounds if they have been moved since the last
 */
public record WorldParameters(
        Bounds bounds,
        float gravityX,
        float gravityY,
        float restitution,
        int subSteps,
        float previousTimeStep,
        Bounds wallStart) {
    /** Parameters of a world whose walls are at rest. */
    public WorldParameters(
            Bounds bounds, float gravityX, float gravityY, float restitution, int subSteps, float previousTimeStep) {
        this(bounds, gravityX, gravityY, restitution, subSteps, previousTimeStep, bounds);
    }

    /** The same with walls that start somewhere. */
    WorldParameters startingAt(Bounds start) {
        return new WorldParameters(bounds, gravityX, gravityY, restitution, subSteps, previousTimeStep, start);
    }

    /** Whether the walls move in the next step. */
    boolean wallsMove() {
        return wallStart.minX() != bounds.minX()
                || wallStart.minY() != bounds.minY()
                || wallStart.maxX() != bounds.maxX()
                || wallStart.maxY() != bounds.maxY();
    }

    /** The part of the parameters in the hash of the state: where walls that move start; else 0. */
    public long hash() {
        return wallsMove() ? StateHash.walls(wallStart) : 0;
    }
}
