package io.github.circles2d.world.model;

/**
 * The sign of belts. Callers give the speed to the right of the surface's normal, so that a floor carries to greater x. The engine, its
 * snapshots and its logs have that of kinds anticlockwise, as angular velocities, and that of walls towards greater coordinates. Each
 * method is its own inverse, and has no -0, since bits are compared.
 */
public final class BeltSpeed {
    private BeltSpeed() {}

    /** Of circles and pieces of a kind. */
    public static float ofKind(float speed) {
        return 0f - Limits.beltSpeed(speed);
    }

    /** Of a wall, by {@link WallMotion#of}: the right of the normal of the left and of the upper one is towards lesser coordinates. */
    public static float ofWall(int wall, float speed) {
        return wall == 0 || wall == 3 ? 0f - Limits.beltSpeed(speed) : Limits.beltSpeed(speed) + 0f;
    }
}
