package io.github.circles2d.reference;

import static io.github.circles2d.reference.Numbers.limitSpeed;

/** How a circle turns within a step, and what it touches others with. Speeds are those of its surface, positive anticlockwise. */
final class Turn {
    private static final float UNITS_PER_RADIAN = 683565275.576f;
    private static final float GREATEST_UNITS = 0x1p62f;

    final float friction;
    final float rollingResistance;
    final float belt;
    final float inverseInertia;

    /** The same, also of one that sleeps. */
    final float ownInverseInertia;

    final float radius;

    /** What is left of the speed after a sub-step's damping. */
    private final float dampingFactor;

    /** What a torque adds to the speed in a sub-step. */
    private final float gain;

    private final float speedAtFirst;
    float speed;

    /** The speed in the sub-step before any impulse. */
    float speedBeforeImpulses;

    /** The speed as a pass over the contacts of different levels begins. */
    float speedBeforePass;

    /** The sum of the impulses on the surface that the next sub-step begins with. */
    float impulse;

    /** The sum of the speeds of the sub-steps. */
    private float turned;

    Turn(Circle c, Kinds kinds, Surfaces surfaces, float h) {
        friction = friction(c.friction, c.kind, kinds, surfaces);
        rollingResistance = rollingResistance(c.rollingResistance, c.kind, kinds, surfaces);
        belt = kinds.getFloat(c.kind, Kinds.BELT_SPEED);
        inverseInertia = c.inverseMass() * kinds.inverseInertia(c.kind);
        ownInverseInertia = c.ownInverseMass() * kinds.inverseInertia(c.kind);
        radius = c.radius;
        dampingFactor = 1f / (1f + kinds.getFloat(c.kind, Kinds.ANGULAR_DAMPING) * h);
        gain = c.actingTorque == 0f ? 0f : limitSpeed(c.actingTorque / radius * inverseInertia * h);
        speedAtFirst = c.angularVelocity * radius;
        speed = speedAtFirst;
    }

    static float friction(float own, int kind, Kinds kinds, Surfaces surfaces) {
        return first(own, kinds.getFloat(kind, Kinds.FRICTION), surfaces.friction());
    }

    static float rollingResistance(float own, int kind, Kinds kinds, Surfaces surfaces) {
        return first(own, kinds.getFloat(kind, Kinds.ROLLING_RESISTANCE), surfaces.rollingResistance());
    }

    /** The first that is a number. */
    private static float first(float own, float ofKind, float ofWorld) {
        return !Float.isNaN(own) ? own : !Float.isNaN(ofKind) ? ofKind : ofWorld;
    }

    /** Begins a sub-step of a circle that is not static. */
    void accelerate() {
        speedBeforeImpulses = (speed + gain) * dampingFactor;
        speed = limitSpeed(speedBeforeImpulses + inverseInertia * impulse);
    }

    /** The sum of the speeds of the sub-steps so far. */
    float turned() {
        return turned;
    }

    void move() {
        speed = limitSpeed(speed);
        turned += speed;
        impulse = 0f;
    }

    /** Ends the step. Who has not been turned keeps the angular velocity, as it was. */
    void finish(Circle c, float h) {
        float units = turned * h / radius * UNITS_PER_RADIAN;
        int turned = (int) (long) Numbers.clamp(units, -GREATEST_UNITS, GREATEST_UNITS);
        c.angle += turned;
        c.turned += c.isStatic() ? 0 : turned;
        if (speed != speedAtFirst) {
            c.angularVelocity = limitSpeed(speed / radius);
        }
    }
}
