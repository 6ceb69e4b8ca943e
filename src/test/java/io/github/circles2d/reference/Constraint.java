package io.github.circles2d.reference;

/**
 * What a contact and a wall have in common: two surfaces that must not overlap, and the normal impulse that keeps them apart. It
 * is never negative. (Soft constraints: E. Catto, "Solver2D", 2024.)
 */
abstract class Constraint {
    final StepParameters step;
    final float radii;
    private final StepParameters.Softness softness;
    private final float restitution;

    /** The sum of the inverse masses of the two sides. */
    private final float inverseMasses;

    private final float squaredRestitutionThreshold;

    /** Distance of the surfaces; negative if they overlap. */
    float separation;

    float normalImpulse;

    /** The speed at which the surfaces part after a bounce in this sub-step; 0 if there is none. */
    float bounceSpeed;

    Constraint(
            StepParameters step,
            StepParameters.Softness softness,
            float radii,
            float restitution,
            float inverseMasses) {
        this.step = step;
        this.softness = softness;
        this.radii = radii;
        this.restitution = restitution;
        this.inverseMasses = inverseMasses;
        squaredRestitutionThreshold = step.squaredRestitutionThreshold(radii, restitution);
    }

    /** The speed at which the surfaces part; negative if they approach. */
    abstract float normalVelocity();

    /** The same, of the velocities before any impulse of this sub-step. */
    abstract float normalVelocityBeforeImpulses();

    /** Whether a contact or a wall carries one of the circles. */
    abstract boolean isLoaded();

    abstract void apply(float impulse);

    /** Applies the impulse of a bounce in free flight. */
    void applyFreeBounce(float impulse) {
        apply(impulse);
    }

    /** The biased visit: decides whether there is a bounce, stops an approach, pushes an overlap out. */
    final void solve() {
        float before = normalVelocityBeforeImpulses();
        boolean bounces =
                restitution > 0f && isLoaded() && before < 0f && isImpact(before) && separation + before * step.h < 0f;
        bounceSpeed = bounces ? -restitution * before : 0f;
        visit(true);
    }

    /** The visit without bias, which takes the speed of the push-out away again. Returns whether the constraint carries. */
    final boolean relax() {
        boolean idle = separation > 0f && normalImpulse == 0f && bounceSpeed == 0f;
        boolean carries = !idle && visit(false);
        normalImpulse = bounceSpeed > 0f ? 0f : normalImpulse;
        return carries;
    }

    private boolean visit(boolean biased) {
        float vn = normalVelocity();
        float mass = 1f / inverseMasses;
        if (restitution > 0f && !isLoaded() && normalImpulse == 0f && isImpact(vn)) {
            boolean meets = !biased || separation * step.inverseH + vn < 0f;
            if (vn < 0f && meets) {
                applyFreeBounce(-(1f + restitution) * vn * mass);
            }
            if (vn > 0f || meets) {
                return false;
            }
        }
        float next;
        if (bounceSpeed > 0f) {
            next = normalImpulse - mass * (vn + -bounceSpeed);
        } else if (separation > 0f) {
            next = normalImpulse - mass * (vn + separation * step.inverseH);
        } else if (biased) {
            float push = Numbers.max(softness.biasRate() * separation, -step.pushSpeed(radii));
            float bias = softness.massScale() * push;
            next = (normalImpulse - mass * (softness.massScale() * vn + bias))
                    - softness.impulseScale() * normalImpulse;
        } else {
            next = normalImpulse - mass * vn;
        }
        float impulse = Numbers.max(next, 0f) - normalImpulse;
        normalImpulse = Numbers.max(next, 0f);
        apply(impulse);
        return (bounceSpeed == 0f && normalImpulse > 0f) || isAtRest(vn + impulse * inverseMasses);
    }

    /** Whether the surfaces touch and part or approach more slowly than what bounces. */
    private boolean isAtRest(float vn) {
        return separation < 0f && !isImpact(vn);
    }

    /** Whether the constraint carries its circles at the beginning of a step: it presses, or touches at rest. */
    final boolean carries() {
        return normalImpulse > 0f || isAtRest(normalVelocity());
    }

    /** Whether a speed is too great for circles at rest on each other. */
    private boolean isImpact(float vn) {
        return vn * vn > squaredRestitutionThreshold;
    }
}
