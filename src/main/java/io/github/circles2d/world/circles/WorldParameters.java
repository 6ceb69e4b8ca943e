package io.github.circles2d.world.circles;

import io.github.circles2d.world.model.Bounds;
import io.github.circles2d.world.model.ContactSettings;
import io.github.circles2d.world.model.SurfaceSettings;

/**
 * What a world has besides its circles. The last time step is 0 before the first. Walls start elsewhere than at the bounds if they have
 * been moved since. Gravity of the last step is 0 before the first, and in worlds whose circles never sleep.
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
        boolean sleeps,
        float previousGravityX,
        float previousGravityY) {
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
                false,
                0,
                0);
    }

    /** The same with walls that start somewhere. */
    public WorldParameters startingAt(Bounds start) {
        return with(contacts, start, surfaces, sleeps, previousGravityX, previousGravityY);
    }

    /** The same with other contacts. */
    public WorldParameters with(ContactSettings settings) {
        return with(settings, wallStart, surfaces, sleeps, previousGravityX, previousGravityY);
    }

    /** The same with other surfaces. */
    public WorldParameters with(SurfaceSettings settings) {
        return with(contacts, wallStart, settings, sleeps, previousGravityX, previousGravityY);
    }

    /** The same of a world whose circles sleep, or do not. */
    public WorldParameters sleeping(boolean does) {
        return does ? sleeping(0, 0) : this;
    }

    /** The same of a world whose circles sleep, with the gravity of the last step. */
    public WorldParameters sleeping(float gravityBeforeX, float gravityBeforeY) {
        return with(contacts, wallStart, surfaces, true, gravityBeforeX, gravityBeforeY);
    }

    private WorldParameters with(
            ContactSettings newContacts,
            Bounds newStart,
            SurfaceSettings newSurfaces,
            boolean sleep,
            float gravityBeforeX,
            float gravityBeforeY) {
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
                sleep,
                gravityBeforeX,
                gravityBeforeY);
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
            SurfaceSettings otherSurfaces,
            boolean othersSleep,
            float otherPreviousX,
            float otherPreviousY) {
        return bounds == otherBounds
                && same(gravityX, otherGravityX)
                && same(gravityY, otherGravityY)
                && same(restitution, otherRestitution)
                && subSteps == otherSubSteps
                && same(previousTimeStep, otherTimeStep)
                && contacts == otherContacts
                && wallStart == otherStart
                && surfaces == otherSurfaces
                && sleeps == othersSleep
                && same(previousGravityX, otherPreviousX)
                && same(previousGravityY, otherPreviousY);
    }

    private static boolean same(float a, float b) {
        return Float.floatToRawIntBits(a) == Float.floatToRawIntBits(b);
    }
}
