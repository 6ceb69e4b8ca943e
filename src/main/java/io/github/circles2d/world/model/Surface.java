package io.github.circles2d.world.model;

/**
 * Friction, rolling resistance and rotation of discs.
 *
 * <p>The tangent t is the normal rotated 90 degrees anticlockwise. A surface speed is an angular velocity times a radius, positive anticlockwise. An
 * inverse inertia is the square of the radius over the angular inertia: what a surface speed gains by an impulse along the surface. Of a
 * disc it is twice the inverse mass, of a ring the inverse mass, of a circle that friction does not turn 0.
 *
 * <p>The lever arm of friction is the radius, whatever the overlap or gap. So rolling balls keep their height (E. Catto, "Solver2D", 2024,
 * turns the anchors with the bodies, and they rise). Angular momentum about a fixed point is kept up to the overlap or gap by the radii.
 */
public final class Surface {
    /** Units of an angle in a turn by its radians: 2^32 / (2 pi). */
    public static final float UNITS_PER_RADIAN = 683565275.576f;

    private static final double RADIANS_PER_UNIT = Math.PI / (1L << 31);

    /** In units of an angle: within a long, and more than a step turns. */
    static final float MOST_UNITS = 0x1p62f;

    private Surface() {}

    /** Of two circles, or of a circle and a wall. */
    public static float friction(float a, float b) {
        return (float) Math.sqrt(a * b);
    }

    /**
     * The effective mass along the surfaces; w, i: inverse masses and inertias; share: 1, or of B if it is heavy, and counts as lighter
     * ({@link CrossRule}).
     */
    public static float tangentMass(float wA, float iA, float wB, float iB, float share) {
        return 1f / ((wA + iA) + share * (wB + iB));
    }

    /** The speed of B's surface against A's along t: along: t . (vB - vA); s: surface speeds; belt: the sum of both. */
    public static float slip(float along, float sA, float sB, float belt) {
        return (along - (sA + sB)) - belt;
    }

    /** What events tell of a slip: how fast surfaces slide that grip by some friction; else 0. */
    public static float hitSlip(float friction, float along, float sA, float sB, float belt) {
        return friction > 0f ? Math.abs(slip(along, sA, sB, belt)) : 0f;
    }

    /** The accumulated impulse along t that takes the slip away, within a limit that is not negative. */
    public static float grip(float accumulated, float mass, float slip, float limit) {
        return limit > 0f ? CircleMath.clamp(accumulated - mass * slip, -limit, limit) : 0f;
    }

    /** One over the sum of the inverse angular inertias of two circles; infinite if nothing turns them. share: 1, or of B if it is heavy. */
    public static float rollingMass(float rA, float iA, float rB, float iB, float share) {
        return 1f / (iA / (rA * rA) + share * (iB / (rB * rB)));
    }

    /** The accumulated angular impulse on B that stops its turning against A, within a limit; omega: by B's angular velocity minus A's. */
    public static float rolling(float accumulated, float mass, float omega, float limit) {
        return grip(accumulated, mass, omega, limit);
    }

    /** The surface speed before impulses; gain: by a torque; a factor of 1 and a gain of 0 change no bit. */
    public static float beforeImpulse(float s, float gain, float dampingFactor) {
        return (s + gain) * dampingFactor;
    }

    public static float afterAngularImpulse(float omega, float impulse, float r, float inverseInertia) {
        return Velocity.limitSpeed(omega + impulse / r * inverseInertia / r);
    }

    /** What a torque adds to a surface speed in a sub-step. */
    public static float torqueGain(float torque, float inverseInertia, float r, float h) {
        return torque == 0f ? 0f : Velocity.limitSpeed(torque / r * inverseInertia * h);
    }

    /** An angle after a step; turned: the sum of the surface speeds in its sub-steps. */
    public static int turn(int angle, float turned, float h, float r) {
        float units = turned * h / r * UNITS_PER_RADIAN;
        return angle + (int) (long) CircleMath.clamp(units, -MOST_UNITS, MOST_UNITS);
    }

    /** After a step: before, after: surface speeds. A circle that nothing has turned keeps its angular velocity to the bit. */
    public static float angularVelocity(float omega, float before, float after, float r) {
        return after == before ? omega : Velocity.limitSpeed(after / r);
    }

    /** The angle in the unit of the state, of which a turn has 2^32, of an angle in radians. */
    public static int units(float radians) {
        return (int) Rotation.nearest(radians / RADIANS_PER_UNIT);
    }

    /** In [-pi, pi). */
    public static float radians(int units) {
        return (float) (units * RADIANS_PER_UNIT);
    }
}
