package io.github.circles2d.world.bodies;

import io.github.circles2d.world.model.Bounds;
import io.github.circles2d.world.model.CircleMath;
import io.github.circles2d.world.model.Limits;

/** What rigid bodies may be. */
public final class RigidLimits {
    /** Most bodies of a world. */
    public static final int MOST = 65_536;

    /** The least moment of inertia, by that of the outline. */
    private static final float LEAST_INERTIA = 1e-3f;

    private RigidLimits() {}

    /** Refuses more bodies than a world may have. */
    public static void room(int bodies, int more) {
        if (more > MOST - bodies) {
            throw new IllegalArgumentException(
                    "a world has at most " + MOST + " bodies, not " + ((long) bodies + more));
        }
    }

    public static void mass(float mass) {
        if (mass == 0f || mass == Float.POSITIVE_INFINITY) {
            throw new IllegalArgumentException("mass is " + mass + ", but must be from " + Limits.LEAST_MASS + " to "
                    + Limits.GREATEST_MASS
                    + ": no body is static. Make what stands still of terrain (World.terrain: segments, "
                    + "chains, bodies of terrain), or hold a body by a pin (Joint.pin)");
        }
        Limits.within("mass", mass, Limits.LEAST_MASS, Limits.GREATEST_MASS);
    }

    public static void inertia(float inertia, float mass, OutlineShape outline) {
        Limits.within("the inertia", inertia, LEAST_INERTIA * (mass * outline.inertia()), Float.POSITIVE_INFINITY);
    }

    /** Refuses an outline that has no room in bounds. */
    public static void reach(OutlineShape outline, Bounds bounds) {
        Limits.radius("the reach of the outline from its centroid", outline.reach(), bounds);
    }

    /** The sum of two forces or torques, within the greatest one, which is the same for both; never -0. */
    static float sum(float a, float b) {
        return CircleMath.clamp(a + b, -Limits.FORCE, Limits.FORCE) + 0f;
    }
}
