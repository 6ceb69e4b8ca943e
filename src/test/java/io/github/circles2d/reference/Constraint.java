package io.github.circles2d.reference;

import static io.github.circles2d.reference.Numbers.max;

import java.util.function.Function;

/**
 * What a contact and a wall have in common: two surfaces that must not overlap, and the normal impulse that keeps them apart. It
 * is never negative. (Soft constraints: E. Catto, "Solver2D", 2024.)
 */
abstract class Constraint {
    private static final float GREATEST_FREQUENCY = 0.3f;
    private static final float PUSH = 0.4f;
    private static final float DEEP = 0.2f;
    private static final float DEEP_RATE = 15f;
    private static final float BOUNCE_DEPTH = 0.01f / PUSH;
    private static final float BOUNCE_THRESHOLD = 0.4f;
    private static final float REST_SPEED = 1f;
    private static final float NEARLY_ELASTIC = 0.9f;

    final StepParameters step;
    final float radii;
    final float restitution;

    /** The sum of the inverse masses of the two sides. */
    private final float inverseMasses;

    /** The effective mass, if the constraint is solved. */
    float mass;

    private final float squaredThreshold;

    /** 1 for a restitution that is not nearly 1; from there it goes down to 0 at 1. */
    final float inelasticity;

    /** Gravity's part of the square of the threshold, per sum of radii. */
    final float gravityRate;

    private final boolean isThresholdFixed;
    private final float pushSpeed;
    private final float deepRate;
    private final float biasRate;
    private final float massScale;
    private final float impulseScale;

    /** Distance of the surfaces; negative if they overlap. */
    float separation;

    float normalImpulse;

    /** The speed at which the surfaces part after a bounce in this sub-step; 0 if there is none. */
    float bounceSpeed;

    /** How much friction the normal impulse allows; 0 if there is none. */
    float frictionCoefficient;

    /** How much the normal impulse allows against rolling; 0 if nothing. */
    float rollingCoefficient;

    /** The effective masses of friction and of what stops the rolling. */
    float tangentMass;

    float rollingMass;

    /** The impulse along the tangent, which is the normal turned anticlockwise; both sides turn against it. */
    float friction;

    /** The speed of the circles along the tangent as a visit begins. */
    private float along;

    /** The impulse that stops the rolling. */
    float rolling;

    /**
     * A constraint of a step.
     *
     * @param gravity the part of gravity that decides which impacts bounce, at least 0
     */
    Constraint(
            StepParameters step, float stiffness, float gravity, float radii, float restitution, float inverseMasses) {
        this.step = step;
        this.radii = radii;
        this.restitution = restitution;
        this.inverseMasses = inverseMasses;
        mass = 1f / inverseMasses;
        inelasticity = Numbers.min((1f - restitution) * (1f / (1f - NEARLY_ELASTIC)), 1f);
        float creep = REST_SPEED * 0.5f * (inelasticity * radii);
        gravityRate = BOUNCE_THRESHOLD * BOUNCE_THRESHOLD * 0.5f * gravity;
        Settings settings = step.settings();
        isThresholdFixed = settings.threshold() >= 0f;
        squaredThreshold = isThresholdFixed
                ? settings.threshold() * settings.threshold()
                : gravityRate * (inelasticity * radii) + creep * creep;
        float push = 0.5f * settings.pushOutSpeed();
        pushSpeed = push * radii;
        deepRate = DEEP_RATE * (push / PUSH);
        float omega = stiffness * (2f * 3.14159265f * Numbers.min(settings.frequency() * step.h(), GREATEST_FREQUENCY));
        float a1 = 2f * settings.damping() + omega;
        float a2 = omega * a1;
        impulseScale = 1f / (1f + a2);
        massScale = a2 * impulseScale;
        biasRate = (omega / a1) * step.inverseH();
    }

    /** The speed at which the surfaces part, by given velocities of the circles; negative if they approach. */
    abstract float normalVelocity(Function<Circle, float[]> velocity);

    /** Whether a contact or a wall carries one of the circles. */
    abstract boolean isLoaded();

    abstract void apply(float impulse);

    /** The speed of the surfaces against each other, along the tangent. */
    final float slip() {
        return slip(along);
    }

    /** The same, by the speed of the circles along the tangent. */
    abstract float slip(float speed);

    /** The speed of the circles along the tangent. */
    abstract float tangentSpeed();

    /** What the normal speed loses in a biased visit. */
    float bend() {
        return 0f;
    }

    /** The speed of rolling. */
    abstract float rollingSpeed();

    abstract void applyFriction(float impulse);

    abstract void applyRolling(float impulse);

    /**
     * Lets the surfaces grip, as far as a normal impulse allows: first against rolling, then against sliding.
     *
     * @param keep whether the impulses are those that the next visit goes on from
     */
    private void grip(float normal, boolean keep) {
        if (rollingCoefficient > 0f) {
            float next = held(rolling - rollingMass * rollingSpeed(), rollingCoefficient * normal);
            applyRolling(next - rolling);
            rolling = keep ? next : 0f;
        }
        if (frictionCoefficient > 0f) {
            float next = held(friction - tangentMass * slip(), frictionCoefficient * normal);
            applyFriction(next - friction);
            friction = keep ? next : 0f;
        }
    }

    private static float held(float impulse, float most) {
        return most > 0f ? Numbers.clamp(impulse, -most, most) : 0f;
    }

    /** Forgets impulses of what does not grip. */
    void forgetGrips() {
        friction = frictionCoefficient > 0f ? friction : 0f;
        rolling = rollingCoefficient > 0f ? rolling : 0f;
    }

    /** The velocity of a circle as a visit sees it. */
    float[] velocityNow(Circle c) {
        return c.velocity;
    }

    /** Whether surfaces overlap and would not part by themselves for long; in the biased pass they are not left alone then. */
    boolean lingers() {
        return false;
    }

    /** The square of the threshold of circles that nothing carries, unless it is fixed. */
    float squaredFlightThreshold() {
        return squaredThreshold;
    }

    /** The square of the speed that a hit exceeds: the threshold of surfaces without restitution. */
    final float squaredHitSpeed() {
        float creep = REST_SPEED * 0.5f * radii;
        return isThresholdFixed ? squaredThreshold : gravityRate * radii + creep * creep;
    }

    /** Whether a speed is an impact, or a parting, of circles that nothing carries. */
    private boolean isImpactInFlight(float vn) {
        return vn * vn > (isThresholdFixed ? squaredThreshold : squaredFlightThreshold());
    }

    /** What gravity adds to the normal speed in half a sub-step; a free bounce leaves it out. */
    float halfFall() {
        return 0f;
    }

    /** Whether circles that are to bounce in free flight wait for it. */
    boolean waits(boolean biased, float vn) {
        return false;
    }

    /** Takes note of an impulse that the constraint does not keep. */
    void note(float impulse) {}

    /** Applies the impulse of a bounce in free flight. */
    void applyFreeBounce(float impulse) {
        apply(impulse);
    }

    /** The biased visit: decides whether there is a bounce, stops an approach, pushes an overlap out. */
    final void solve() {
        float v0 = normalVelocity(c -> c.velocityBeforeImpulses);
        boolean isDeep = separation + BOUNCE_DEPTH * pushSpeed < 0f;
        boolean meets = v0 < 0f && isImpact(v0) && separation + v0 * step.h() < 0f;
        bounceSpeed = restitution > 0f && isLoaded() && meets && !isDeep ? -restitution * v0 : 0f;
        visit(true);
    }

    /** The visit without bias, which takes the speed of the push-out away again. Returns whether the constraint carries. */
    final boolean relax() {
        boolean idle = separation > 0f && normalImpulse == 0f && bounceSpeed == 0f && friction == 0f && rolling == 0f;
        float old = normalImpulse;
        boolean carries = !idle && visit(false);
        if (bounceSpeed > 0f) {
            note(old + (normalImpulse - old));
            normalImpulse = 0f;
        }
        return carries;
    }

    private boolean visit(boolean biased) {
        along = tangentSpeed();
        float vn = normalVelocity(this::velocityNow) - bend();
        boolean flies = restitution > 0f && !isLoaded() && normalImpulse == 0f;
        if (flies && isImpactInFlight(vn)) {
            boolean meets = !biased || separation * step.inverseH() + vn < 0f;
            boolean bounces = vn < 0f && meets && !waits(biased, vn);
            if (bounces) {
                float speed = biased ? vn - halfFall() : vn;
                float impulse = -(1f + restitution) * speed * (1f / inverseMasses);
                applyFreeBounce(impulse);
                note(impulse);
                grip(impulse, false);
            }
            if (vn > 0f ? !(biased && lingers()) : meets) {
                if (!biased && !bounces) {
                    grip(0f, false);
                }
                return false;
            }
        }
        float old = normalImpulse;
        if (bounceSpeed > 0f) {
            normalImpulse = old - mass * (vn - bounceSpeed);
        } else if (separation > 0f) {
            normalImpulse = old - mass * (vn + separation * step.inverseH());
        } else if (biased) {
            float deep = deepRate * separation + (DEEP * DEEP_RATE / PUSH - 1f) * pushSpeed;
            float bias = massScale * max(biasRate * separation, Numbers.min(-pushSpeed, deep));
            normalImpulse = (old - mass * (massScale * vn + bias)) - impulseScale * old;
        } else {
            normalImpulse = old - mass * vn;
        }
        normalImpulse = max(normalImpulse, 0f);
        float applied = normalImpulse - old;
        apply(applied);
        if (!biased) {
            grip(normalImpulse, !(bounceSpeed > 0f));
        }
        return carries(vn + applied * inverseMasses);
    }

    /** Whether the constraint presses without a bounce, or its surfaces touch at a speed that is no impact. */
    final boolean carries(float vn) {
        return (bounceSpeed == 0f && normalImpulse > 0f) || (separation < 0f && !isImpact(vn));
    }

    /** Whether a speed is too great for circles at rest on each other. */
    private boolean isImpact(float vn) {
        return vn * vn > squaredThreshold;
    }
}
