package io.github.circles2d.world.model;

/**
 * Formulas of a constraint: a contact, or a circle and a wall (E. Catto, "Solver2D", 2024).
 *
 * <p>A normal impulse is accumulated and never negative, a separation never -0, a threshold the square of a speed. A bounce speed is 0
 * without a bounce. loaded is greater than 0 if something carries a circle; before is vn without impulses. Integers are all bits for yes,
 * none for no. Which constraints press is as good as random, so code branches only on what is rare ({@link Branchless}).
 */
public final class Constraints {
    public static final int SOLVE = 0;

    static final int LEAVE = 1;

    /** Without an impulse to store. */
    public static final int BOUNCE = 2;

    /** Of {@link #meets} without bias. */
    public static final int ALWAYS = -1;

    private Constraints() {}

    /** Whether a visit without bias changes nothing. */
    public static int isIdle(float separation, float normalImpulse, float bounceSpeed) {
        return Branchless.isPositive(separation)
                & ~Branchless.isPositive(normalImpulse)
                & ~Branchless.isPositive(bounceSpeed);
    }

    private static int overlapAfter(float time, float separation, float vn) {
        return Branchless.isNegative(separation + vn * time);
    }

    private static int isImpact(float vn, float threshold) {
        return Branchless.isPositive(vn * vn - threshold);
    }

    public static float bounceSpeed(
            float restitution,
            float loaded,
            float before,
            float separation,
            float h,
            float threshold,
            float pushSpeed) {
        int strikes = isImpact(before, threshold)
                & ~Branchless.isNegative(separation + Tuning.BOUNCE_DEPTH * pushSpeed)
                & Branchless.isPositive(loaded)
                & Branchless.isNegative(before)
                & overlapAfter(h, separation, before);
        // a restitution may be -0, of which the product would be -0 too
        return strikes != 0 && restitution > 0f ? -restitution * before : 0f;
    }

    /** The speed that a visit aims at, against the normal. */
    private static float bias(float separation, float bounceSpeed, float inverseH, float soft) {
        return bounceSpeed > 0f
                ? -bounceSpeed
                : Branchless.choose(Branchless.isPositive(separation), separation * inverseH, soft);
    }

    /** Whether the surfaces would meet within the sub-step. */
    public static int meets(float separation, float vn, float inverseH) {
        return Branchless.isNegative(separation * inverseH + vn);
    }

    /** By the whole relative speed before impulses. */
    public static int lingers(float separation, float squaredSpeed) {
        float way = Tuning.LINGER * Tuning.LINGER * squaredSpeed;
        return Branchless.isNegative(separation) & Branchless.isNegative(way - separation * separation);
    }

    /** In free flight, if the restitution is greater than 0. */
    public static int flies(float loaded, float normalImpulse, float vn, float threshold) {
        return isImpact(vn, threshold) & ~(Branchless.isPositive(loaded) | Branchless.isPositive(normalImpulse));
    }

    /** {@link #SOLVE}, {@link #LEAVE} or {@link #BOUNCE}. */
    public static int visitOf(
            float restitution, float loaded, int lingers, float normalImpulse, float vn, int meets, float threshold) {
        if (flies(loaded, normalImpulse, vn, threshold) != 0 && restitution > 0f) {
            return vn > 0f ? lingers != 0 ? SOLVE : LEAVE : meets != 0 ? BOUNCE : SOLVE;
        }
        return SOLVE;
    }

    /** The normal impulse after a visit with bias. */
    public static float solve(
            float normalImpulse,
            float mass,
            float vn,
            float separation,
            float bounceSpeed,
            float pushSpeed,
            Softness softness,
            StepConstants k) {
        int rigid = Branchless.isPositive(separation) | Branchless.isPositive(bounceSpeed);
        float soft = softBias(separation, pushSpeed, softness, k);
        float bias = bias(separation, bounceSpeed, k.inverseH, soft);
        float decay = Branchless.choose(rigid, 0f, softness.impulseScale) * normalImpulse;
        return visit(normalImpulse, mass, Branchless.choose(rigid, 1f, softness.massScale), vn, bias, decay);
    }

    /** What {@link #solve} aims at where surfaces overlap. */
    public static float softBias(float separation, float pushSpeed, Softness softness, StepConstants k) {
        return softness.massScale * pushOut(separation, pushSpeed, k.deepRate, softness.biasRate);
    }

    /** Negative: in proportion to the depth, then constant, so that piles do not burst, then growing, so that no pair stays deep. */
    private static float pushOut(float separation, float pushSpeed, float deepRate, float biasRate) {
        float deep = deepRate * separation + Tuning.DEEP_OFFSET * pushSpeed;
        return CircleMath.max(biasRate * separation, CircleMath.min(-pushSpeed, deep));
    }

    /** The same without bias. */
    public static float relax(
            float normalImpulse, float mass, float vn, float separation, float bounceSpeed, float inverseH) {
        return visit(normalImpulse, mass, 1f, vn, bias(separation, bounceSpeed, inverseH, 0f), 0f);
    }

    /** The normal impulse after a visit by the terms of {@link #solve}. */
    public static float visit(float normalImpulse, float mass, float massScale, float vn, float bias, float decay) {
        return Branchless.positive((normalImpulse - mass * (massScale * vn + bias)) - decay);
    }

    public static int carries(float normalImpulse, float separation, float vn, float threshold) {
        return Branchless.isPositive(normalImpulse) | Branchless.isNegative(separation) & ~isImpact(vn, threshold);
    }

    /** Whether a visit with bias changes nothing. */
    public static int staysClear(
            float separation, float normalImpulse, float vn, float before, float h, float inverseH) {
        return isIdle(separation, normalImpulse, 0f)
                & ~meets(separation, vn, inverseH)
                & ~overlapAfter(h, separation, before);
    }
}
