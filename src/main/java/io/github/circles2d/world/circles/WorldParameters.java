package io.github.circles2d.world.circles;

import io.github.circles2d.world.model.Bounds;
import io.github.circles2d.world.model.ContactSettings;
import io.github.circles2d.world.model.SurfaceSettings;

/**
 * What a world has besides its circles. The last time step is 0 before the first. Walls start elsewhere than at the bounds if they have
 * been moved since.
 */
public record WorldParameters(
        Bounds bounds,
        float gravityX,
        float gravityY,
        float restitution,
        int subSteps,
        float previousTimeStep,
        ContactSettings contacts,
        Bounds wallStart,
        SurfaceSettings surfaces) {
    /** Parameters of a world whose walls are at rest, whose contacts are as by default, and in which nothing grips. */
    public WorldParameters(
            Bounds bounds, float gravityX, float gravityY, float restitution, int subSteps, float previousTimeStep) {
        this(
                bounds,
                gravityX,
                gravityY,
                restitution,
                subSteps,
                previousTimeStep,
                ContactSettings.DEFAULT,
                bounds,
                SurfaceSettings.NONE);
    }

    /** The same with walls that start somewhere. */
    public WorldParameters startingAt(Bounds start) {
        return new WorldParameters(
                bounds, gravityX, gravityY, restitution, subSteps, previousTimeStep, contacts, start, surfaces);
    }

    /** The same with other contacts. */
    public WorldParameters with(ContactSettings settings) {
        return new WorldParameters(
                bounds, gravityX, gravityY, restitution, subSteps, previousTimeStep, settings, wallStart, surfaces);
    }

    /** The same with other surfaces. */
    public WorldParameters with(SurfaceSettings settings) {
        return new WorldParameters(
                bounds, gravityX, gravityY, restitution, subSteps, previousTimeStep, contacts, wallStart, settings);
    }

    public boolean wallsMove() {
        return wallStart.differs(bounds);
    }

    /**
     * In the hash of the state: where walls that move start, contacts that are not as by default, edges that are no walls, and surfaces
     * that grip.
     */
    public static long hash(Bounds bounds, Bounds wallStart, ContactSettings contacts, SurfaceSettings surfaces) {
        long walls = wallStart.differs(bounds) ? StateHash.walls(wallStart) : 0;
        long edges = bounds.isWalled() ? 0 : StateHash.edges(bounds);
        long grips = surfaces.any() ? StateHash.surfaces(surfaces) : 0;
        return walls + edges + grips + (contacts.isDefault() ? 0 : StateHash.contacts(contacts));
    }

    /** By bits and objects; comparing with another record would leave garbage. */
    public boolean has(
            Bounds otherBounds,
            float otherGravityX,
            float otherGravityY,
            float otherRestitution,
            int otherSubSteps,
            float otherTimeStep,
            ContactSettings otherContacts,
            Bounds otherStart,
            SurfaceSettings otherSurfaces) {
        return bounds == otherBounds
                && same(gravityX, otherGravityX)
                && same(gravityY, otherGravityY)
                && same(restitution, otherRestitution)
                && subSteps == otherSubSteps
                && same(previousTimeStep, otherTimeStep)
                && contacts == otherContacts
                && wallStart == otherStart
                && surfaces == otherSurfaces;
    }

    private static boolean same(float a, float b) {
        return Float.floatToRawIntBits(a) == Float.floatToRawIntBits(b);
    }
}
