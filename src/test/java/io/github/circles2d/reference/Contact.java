package io.github.circles2d.reference;

import static io.github.circles2d.reference.Numbers.length;
import static io.github.circles2d.reference.Numbers.minus;
import static io.github.circles2d.reference.Numbers.plus;
import static io.github.circles2d.reference.Numbers.unit;

import java.util.function.Function;

/** Two circles that may meet within the step. The normal is a unit vector from the circle of lower id to the other. */
final class Contact extends Constraint {
    private static final float COINCIDENT = 1e-6f;
    private static final float FLIGHT_REST_SPEED = 0.1f;
    private static final float LINGER = 1f;

    /** Two circles in the order of their ids. */
    record Pair(Circle lower, Circle higher) {
        /** A well-mixed number of the two ids. */
        int hash() {
            return mix(mix(lower.id) + higher.id);
        }

        /** Whether none of the two moves: one sleeps, and the other one sleeps or is static. */
        boolean rests() {
            return lower.isStatic() && higher.isStatic() && (lower.isAsleep() || higher.isAsleep());
        }

        /** The finalizer of MurmurHash3. */
        private static int mix(int h) {
            int a = (h ^ h >>> 16) * 0x85ebca6b;
            int b = (a ^ a >>> 13) * 0xc2b2ae35;
            return b ^ b >>> 16;
        }
    }

    final Pair pair;
    final Circle lower;
    final Circle higher;
    private float[] normal;

    /** Of a contact of two levels, the light circle and the heavy one; else null. */
    Circle light;

    Circle heavy;

    /** How much lighter the heavy circle counts. */
    private float heavyShare = 1f;

    /** Of a contact of one level. */
    int colour;

    /** What it does in the step. */
    final Touch touch = new Touch();

    /** What it does in the sub-step: the approach speed, how fast its surfaces slide, and the impulses that it does not keep. */
    private float approach;

    private float slip;

    private float notKept;

    Contact(Pair pair, StepParameters step) {
        super(
                step,
                1f,
                length(step.gravity()),
                pair.lower.radius + pair.higher.radius,
                Numbers.max(pair.lower.restitution, pair.higher.restitution),
                pair.lower.inverseMass() + pair.higher.inverseMass());
        // a circle that sleeps is pushed as if it would give way: else what lies on it would push the heap
        mass = 1f / (pair.lower.ownInverseMass() + pair.higher.ownInverseMass());
        this.pair = pair;
        lower = pair.lower;
        higher = pair.higher;
        int hash = pair.hash();
        normal = unit((hash & 1023) - 511.5f, (hash >>> 10 & 1023) - 511.5f);
    }

    /** Makes it a contact of two levels: the light circle is the one of greater inverse mass, or of the finer level. */
    void cross() {
        Circle finer = lower.level > higher.level ? lower : higher;
        Circle coarser = finer == lower ? higher : lower;
        light = finer.inverseMass() >= coarser.inverseMass() ? finer : coarser;
        heavy = light == finer ? coarser : finer;
    }

    boolean isCross() {
        return lower.level != higher.level;
    }

    /** Adds to what the contacts of the heavy circle add up to. */
    void join() {
        heavy.load += (int) (heavy.inverseMass() / (heavy.inverseMass() + light.inverseMass()) * 16_384f) + 1;
    }

    /** Counts the heavy circle as lighter, by its share. */
    void split() {
        float share = Numbers.max(heavy.load * (1f / 16_384f), 1f);
        mass = 1f / (light.ownInverseMass() + share * heavy.ownInverseMass());
        heavyShare = share;
    }

    /** Takes over the impulses of the step before, and finds out how the surfaces grip. */
    void begin(Impulses before, float warmScale) {
        Circle first = isCross() ? light : lower;
        Circle second = isCross() ? heavy : higher;
        normalImpulse = before.normal() * warmScale;
        frictionCoefficient = Numbers.sqrt(lower.turn.friction * higher.turn.friction);
        tangentMass = 1f
                / ((first.inverseMass() + first.turn.inverseInertia)
                        + heavyShare * (second.inverseMass() + second.turn.inverseInertia));
        rollingCoefficient = Numbers.max(lower.turn.rollingResistance, higher.turn.rollingResistance)
                * Numbers.max(lower.radius, higher.radius);
        rollingMass = 1f / (angular(first) + heavyShare * angular(second));
        if (rollingMass == Float.POSITIVE_INFINITY) {
            rollingCoefficient = 0f;
        }
        friction = before.friction() * warmScale;
        rolling = before.rolling() * warmScale;
        forgetGrips();
    }

    /** The inverse of the angular inertia. */
    private static float angular(Circle c) {
        return c.turn.inverseInertia / (c.radius * c.radius);
    }

    int level() {
        return Math.min(lower.level, higher.level);
    }

    void measure() {
        float[] d = plus(lower.wayTo(higher), minus(higher.displacement, lower.displacement));
        normal = length(d) > COINCIDENT * radii ? unit(d) : normal;
        separation = length(d) - radii;
    }

    /** Adds the normal impulse to those that the two circles begin their next sub-step with, and marks them as loaded then. */
    void warmStart(boolean carries) {
        for (int a = 0; a < 2; a++) {
            float impulse = normal[a] * normalImpulse;
            if (frictionCoefficient > 0f || rollingCoefficient > 0f) {
                impulse += tangent(a) * friction;
            }
            add(lower, lower.impulses, lower.heavyImpulse, a, -impulse);
            add(higher, higher.impulses, higher.heavyImpulse, a, impulse);
        }
        turnNext(lower, -friction - rolling / lower.radius);
        turnNext(higher, -friction + rolling / higher.radius);
        lower.loadedNext |= carries;
        higher.loadedNext |= carries;
    }

    @Override
    float normalVelocity(Function<Circle, float[]> velocity) {
        return Numbers.dot(normal, minus(velocity.apply(higher), velocity.apply(lower)));
    }

    /**
     * Two circles of different levels that meet claim a turn, unless they would be too deep, or one is static, or they lose energy
     * anyway. In the pass without bias only one light circle bounces off a heavy one, if it is no heavy one itself whose turn it is.
     */
    @Override
    boolean waits(boolean biased, float vn) {
        if (!isCross() || heavy.isStatic() || restitution <= 0.9f) {
            return false;
        }
        float depth = Numbers.min(0.25f * radii, 4f * Numbers.min(lower.radius, higher.radius));
        if ((biased ? separation + vn * step.h() : separation) + depth < 0f) {
            return false;
        }
        if (biased) {
            heavy.claim = Math.max(heavy.claim, light.id + 1);
        }
        return biased || heavy.claim != light.id + 1 || light.claim != 0;
    }

    /** By the relative velocity before any impulse: it takes longer than LINGER to cover the depth. */
    @Override
    boolean lingers() {
        float[] v = minus(higher.velocityBeforeImpulses, lower.velocityBeforeImpulses);
        return separation < 0f && LINGER * LINGER * Numbers.dot(v, v) < separation * separation;
    }

    /** By a lower threshold than that of circles that are carried: elastic ones bounce at any speed. */
    @Override
    float squaredFlightThreshold() {
        float creep = FLIGHT_REST_SPEED * 0.5f * ((1f - restitution) * radii);
        return gravityRate * (inelasticity * radii) + creep * creep;
    }

    /** Not 0 only if one circle is static, since circles that both fall gain no speed against each other. */
    @Override
    float halfFall() {
        float half = 0.5f * Numbers.dot(normal, lower.isStatic() ? higher.gain : lower.gain);
        return lower.inverseMass() == 0f ? half : higher.inverseMass() == 0f ? -half : 0f;
    }

    @Override
    void note(float impulse) {
        notKept += impulse;
    }

    /** Looks at the touch after the biased pass. */
    void lookAfterSolve() {
        approach = Numbers.max(-normalVelocity(c -> c.velocityBeforeImpulses), 0f);
        slip = frictionCoefficient > 0f ? Math.abs(slipBeforeImpulses()) : 0f;
        if (normalImpulse > 0f || notKept > 0f || separation <= 0f) {
            touch.seen(approach, slip, normal, point(), isFast());
        }
    }

    /** Looks at the touch after the relaxing pass. */
    void lookAfterRelax() {
        float sum = notKept + normalImpulse;
        notKept = 0f;
        touch.impulse += sum;
        if (sum > 0f) {
            touch.seen(approach, slip, normal, point(), isFast());
        }
    }

    /** Whether the place may be another after the step. */
    private boolean isFast() {
        return approach * step.dt() > Touch.SLACK * radii;
    }

    /** Looks at the touch after the step. */
    void lookAfterStep() {
        touch.separation = separation;
        touch.slack = Touch.SLACK * radii;
        touch.threshold = squaredHitSpeed();
        touch.normalVelocity = normalVelocity(c -> c.velocity);
        float[] place = new float[2];
        for (int a = 0; a < 2; a++) {
            place[a] = (lower.base[a] + 0f) + normal[a] * (lower.radius + 0.5f * separation);
        }
        touch.end(normal, place);
    }

    /** Half-way between the surfaces. */
    private float[] point() {
        float[] point = new float[2];
        for (int a = 0; a < 2; a++) {
            point[a] = (lower.base[a] + lower.displacement[a]) + normal[a] * (lower.radius + 0.5f * separation);
        }
        return point;
    }

    @Override
    boolean isLoaded() {
        return lower.loaded || higher.loaded;
    }

    @Override
    void apply(float impulse) {
        for (int a = 0; a < 2; a++) {
            add(lower, lower.velocity, lower.heavyGain, a, -(normal[a] * (lower.inverseMass() * impulse)));
            add(higher, higher.velocity, higher.heavyGain, a, normal[a] * (higher.inverseMass() * impulse));
        }
    }

    private float slipBeforeImpulses() {
        float along = tangentSpeed(higher.velocityBeforeImpulses, lower.velocityBeforeImpulses);
        return slip(along, lower.turn.speedBeforeImpulses, higher.turn.speedBeforeImpulses);
    }

    private float tangent(int axis) {
        return axis == 0 ? -normal[1] : normal[0];
    }

    @Override
    float tangentSpeed() {
        return tangentSpeed(velocityNow(higher), velocityNow(lower));
    }

    private float tangentSpeed(float[] ofHigher, float[] ofLower) {
        float[] v = minus(ofHigher, ofLower);
        return tangent(0) * v[0] + tangent(1) * v[1];
    }

    @Override
    float slip(float speed) {
        return slip(speed, speedNow(lower), speedNow(higher));
    }

    private float slip(float speed, float ofLower, float ofHigher) {
        return (speed - (ofLower + ofHigher)) - (lower.turn.belt + higher.turn.belt);
    }

    @Override
    float rollingSpeed() {
        return speedNow(higher) / higher.radius - speedNow(lower) / lower.radius;
    }

    @Override
    void applyFriction(float impulse) {
        for (int a = 0; a < 2; a++) {
            add(lower, lower.velocity, lower.heavyGain, a, -(tangent(a) * (lower.inverseMass() * impulse)));
            add(higher, higher.velocity, higher.heavyGain, a, tangent(a) * (higher.inverseMass() * impulse));
        }
        turn(lower, -impulse);
        turn(higher, -impulse);
    }

    @Override
    void applyRolling(float impulse) {
        turn(lower, -impulse / lower.radius);
        turn(higher, impulse / higher.radius);
    }

    private void turn(Circle c, float impulse) {
        float gain = c.turn.inverseInertia * impulse;
        if (c == heavy) {
            c.heavyGain.add(2, gain);
        } else {
            c.turn.speed += gain;
        }
    }

    /** Adds to the impulse with which a circle begins to turn in its next sub-step. */
    private void turnNext(Circle c, float impulse) {
        if (c == heavy) {
            c.heavyImpulse.add(2, impulse);
        } else {
            c.turn.impulse += impulse;
        }
    }

    private float speedNow(Circle c) {
        return c == heavy ? c.turn.speedBeforePass : c.turn.speed;
    }

    /** Adds to a vector of a circle, or to its sum if it is the heavy one. */
    private void add(Circle c, float[] own, FixedSum sum, int axis, float term) {
        if (c == heavy) {
            sum.add(axis, term);
        } else {
            own[axis] += term;
        }
    }

    /** A heavy circle is seen as before the pass. */
    @Override
    float[] velocityNow(Circle c) {
        return c == heavy ? c.velocityBeforePass : c.velocity;
    }
}
