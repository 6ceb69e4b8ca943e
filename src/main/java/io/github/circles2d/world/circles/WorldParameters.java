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
        SurfaceSettings surfaces,
        boolean sleeps) {
    /** Parameters of a world whose walls are at rest, whose contacts are as by default, and in which nothing grips or sleeps. */
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
                SurfaceSettings.NONE,
                false);
    }

    /** The same with walls that start somewhere. */
    public WorldParameters startingAt(Bounds start) {
        return with(contacts, start, surfaces, sleeps);
    }

    /** The same with other contacts. */
    public WorldParameters with(ContactSettings settings) {
        return with(settings, wallStart, surfaces, sleeps);
    }

    /** The same with other surfaces. */
    public WorldParameters with(SurfaceSettings settings) {
        return with(contacts, wallStart, settings, sleeps);
    }

    /** The same of a world whose circles sleep, or do not. */
    public WorldParameters sleeping(boolean does) {
        return with(contacts, wallStart, surfaces, does);
    }

    private WorldParameters with(
            ContactSettings newContacts, Bounds newStart, SurfaceSettings newSurfaces, boolean sleep) {
        return new WorldParameters(
                bounds,
                gravityX,
                gravityY,
                restitution,
                subSteps,
                previousTimeStep,
                newContacts,
                newStart,
                newSurfaces,
                sleep);
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
}
