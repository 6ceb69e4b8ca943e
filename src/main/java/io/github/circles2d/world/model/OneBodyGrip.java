package io.github.circles2d.world.model;

/**
 * The grip of a circle and something that is no circle, as {@link OneBody} is their visit; it leaves its results in the fields. Impulses are
 * speeds. B is the circle; t is the normal, which points to the circle, rotated 90 degrees anticlockwise.
 */
public final class OneBodyGrip {
    /** Of the circle: to be set before, and found after. */
    public float surfaceSpeed;

    /** Accumulated, along t: to be set before, and found after. */
    public float friction;

    /** Accumulated, on the circle, by its radius: to be set before, and found after. */
    public float rolling;

    /** To be added to the circle's velocity along t. */
    public float impulse;

    /** Of the pair. */
    public float mu;

    public float resistance;

    /** {@link KindSurface#INERTIA} */
    public float inertia;

    public void between(
            float ofCircle, float other, float resistanceOfCircle, float otherResistance, float itsInertia) {
        mu = Surface.friction(ofCircle, other);
        resistance = CircleMath.max(resistanceOfCircle, otherResistance);
        inertia = itsInertia;
    }

    /** Whether surfaces do anything. */
    public boolean acts() {
        return mu > 0f || resistance > 0f;
    }

    /** Before the visits of a sub-step: what is accumulated acts again, unless the surfaces have changed. */
    public void warmStart() {
        friction = mu > 0f ? friction : 0f;
        rolling = resistance > 0f && inertia > 0f ? rolling : 0f;
        impulse = friction;
        surfaceSpeed += inertia * (rolling - friction);
    }

    /** By the normal impulse; along: the circle's speed along t, against the other's surface; keep: whether the impulse accumulates. */
    public void visit(float normalImpulse, float along, float belt, boolean keep) {
        impulse = 0f;
        if (resistance > 0f && inertia > 0f) {
            float next = Surface.rolling(rolling, 1f / inertia, surfaceSpeed, resistance * normalImpulse);
            surfaceSpeed += inertia * (next - rolling);
            rolling = keep ? next : 0f;
        }
        if (mu > 0f) {
            float slip = Surface.slip(along, 0f, surfaceSpeed, belt);
            float mass = Surface.tangentMass(0f, 0f, 1f, inertia);
            float next = Surface.grip(friction, mass, slip, mu * normalImpulse);
            impulse = next - friction;
            surfaceSpeed += inertia * -impulse;
            friction = keep ? next : 0f;
        }
    }
}
