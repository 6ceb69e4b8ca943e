package io.github.circles2d.reference;

/** A circle and the nearer wall of an axis. The circle counts as one of mass 1, so impulses are speeds. */
final class Wall extends Constraint {
    private final Circle circle;
    private final Circle.Axis axis;
    private final StepParameters.Walls walls;

    /** The direction away from the wall: 1 for the lower wall, -1 for the upper. */
    private final float normal;

    Wall(Circle circle, Circle.Axis axis, StepParameters.Walls walls, StepParameters step) {
        super(step, step.wallSoftness, 2f * circle.radius, circle.restitution, 1f);
        this.circle = circle;
        this.axis = axis;
        this.walls = walls;
        normal = axis.base - walls.low() <= walls.high() - axis.base ? 1f : -1f;
        normalImpulse = Numbers.max(normal * axis.wallImpulse, 0f);
    }

    void measure() {
        separation = normal > 0f
                ? ((axis.base - walls.low()) - circle.radius) + axis.displacement
                : ((walls.high() - axis.base) - circle.radius) - axis.displacement;
    }

    void storeImpulse() {
        axis.wallImpulse = bounceSpeed > 0f ? 0f : normal * normalImpulse;
    }

    @Override
    float normalVelocity() {
        return normal * axis.velocity;
    }

    @Override
    float normalVelocityBeforeImpulses() {
        return normal * axis.velocityBeforeImpulses;
    }

    @Override
    boolean isLoaded() {
        return circle.loaded;
    }

    @Override
    void apply(float impulse) {
        axis.velocity += normal * impulse;
    }

    /** Lets the circle fly on to the wall before it turns, unless it flies farther than its radius in a step. */
    @Override
    void applyFreeBounce(float impulse) {
        float speed = -normalVelocity();
        if (separation > 0f && speed * step.dt <= circle.radius) {
            axis.displacement -= normal * impulse * (separation / speed);
        }
        apply(impulse);
    }
}
