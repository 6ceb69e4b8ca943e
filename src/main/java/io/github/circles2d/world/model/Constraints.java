package io.github.circles2d.world.model;

/**
 * The physics of a constraint, which is a contact of two circles, or a circle and the nearer wall of an axis: a wall counts as a
 * contact of effective mass 1. (Soft constraints: E. Catto, "Solver2D", 2024.)
 *
 * <p>The units are those of {@link CircleMath}. The normal impulse is accumulated and never negative. The bounce speed is the
 * speed at which the surfaces part after a bounce; 0 if there is none. Thresholds are squares of speeds. The separation is never
 * -0. Functions of type int return all bits for yes and no bit for no. Which constraints press is as good as random, so the
 * functions branch only on what is rare ({@link Branchless}).
 */
public final class Constraints {
    /** Solve the constraint. */
    public static final int SOLVE = 0;

    /** Leave the constraint alone. */
    static final int LEAVE = 1;

    /** Let the circles bounce, and store no impulse. */
    public static final int BOUNCE = 2;

    /** The answer of {@link #meets} in a visit without bias. */
    public static final int ALWAYS = -1;

    private Constraints() {}

    // ---- made ready: independent of the visits before it
    // ---------------------------------------------------------------------

    /** Whether the surfaces have a gap, and nothing is to be taken back or to bounce: a visit without bias changes nothing. */
    public static int isIdle(float separation, float normalImpulse, float bounceSpeed) {
        return Branchless.isPositive(separation)
                & ~Branchless.isPositive(normalImpulse)
                & ~Branchless.isPositive(bounceSpeed);
    }

    /** Whether the surfaces overlap at the end of a time if they move at a normal speed. */
    private static int overlapAfter(float time, float separation, float vn) {
        return Branchless.isNegative(separation + vn * time);
    }

    private static int isImpact(float vn, float threshold) {
        return Branchless.isPositive(vn * vn - threshold);
    }

    /**
     * The speed at which surfaces part that meet in this sub-step, if something carries one of the circles.
     *
     * @param loaded greater than 0 if something does
     * @param before normal speed at the start of the sub-step, before any impulse
     * @param pushSpeed push-out speed of what is not deep
     */
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

    /** The speed that a visit aims at, against the normal: of a bounce, of what closes the gap, or soft, of the push-out. */
    private static float bias(float separation, float bounceSpeed, float inverseH, float soft) {
        return bounceSpeed > 0f
                ? -bounceSpeed
                : Branchless.choose(Branchless.isPositive(separation), separation * inverseH, soft);
    }

    // ---- visited
    // -----------------------------------------------------------------------------------------------------

    /** Whether the surfaces would meet within the sub-step. */
    public static int meets(float separation, float vn, float inverseH) {
        return Branchless.isNegative(separation * inverseH + vn);
    }

    /**
     * Whether surfaces overlap and would need longer than {@link Tuning#LINGER} to move as far as they are deep. The speed is the
     * whole relative one: by that along the normal alone, more pairs of an elastic gas would be pushed out, and it would lose energy.
     *
     * @param squaredSpeed square of the relative speed at the start of the sub-step, before any impulse
     */
    public static int lingers(float separation, float squaredSpeed) {
        float way = Tuning.LINGER * Tuning.LINGER * squaredSpeed;
        return Branchless.isNegative(separation) & Branchless.isNegative(way - separation * separation);
    }

    /**
     * Whether circles of a restitution greater than 0 fly free of each other: nothing carries them, they do not press, and they move
     * against each other faster than the threshold. All others are solved.
     *
     * @param loaded greater than 0 if something carries one of the circles
     */
    public static int flies(float loaded, float normalImpulse, float vn, float threshold) {
        return isImpact(vn, threshold) & ~(Branchless.isPositive(loaded) | Branchless.isPositive(normalImpulse));
    }

    /**
     * How to treat a constraint. Circles in free flight, which move against each other faster than the threshold, bounce if they
     * meet, and are left alone if they part, unless they linger. All others are solved.
     *
     * @param loaded greater than 0 if something carries one of the circles
     * @param lingers by {@link #lingers}
     * @param meets by {@link #meets}, or {@link #ALWAYS}
     * @return {@link #SOLVE}, {@link #LEAVE} or {@link #BOUNCE}
     */
    public static int visitOf(
            float restitution, float loaded, int lingers, float normalImpulse, float vn, int meets, float threshold) {
        if (flies(loaded, normalImpulse, vn, threshold) != 0 && restitution > 0f) {
            return vn > 0f ? lingers != 0 ? SOLVE : LEAVE : meets != 0 ? BOUNCE : SOLVE;
        }
        return SOLVE;
    }

    /**
     * The normal impulse after a visit with bias: it stops the approach, or as much of it as would close the gap within the
     * sub-step; pushes an overlap out softly; or brings the surfaces to the bounce speed.
     *
     * @param mass effective mass
     * @param pushSpeed greatest push-out speed of overlaps that are not deep
     */
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
        float soft = softness.massScale * pushOut(separation, pushSpeed, k.deepRate, softness.biasRate);
        float bias = bias(separation, bounceSpeed, k.inverseH, soft);
        float decay = Branchless.choose(rigid, 0f, softness.impulseScale) * normalImpulse;
        return visit(normalImpulse, mass, Branchless.choose(rigid, 1f, softness.massScale), vn, bias, decay);
    }

    /**
     * The speed at which an overlap is pushed out, negative. It has three pieces: in proportion to the depth, then constant, then
     * growing again if the pair is deep; it never exceeds the proportion of the first. The constant piece is slow, so that a pile of
     * which many pairs overlap at once does not burst. The last piece keeps single pairs from staying deep where there is too little
     * space for all.
     */
    private static float pushOut(float separation, float pushSpeed, float deepRate, float biasRate) {
        float deep = deepRate * separation + Tuning.DEEP_OFFSET * pushSpeed;
        return CircleMath.max(biasRate * separation, CircleMath.min(-pushSpeed, deep));
    }

    /** The normal impulse after a visit without bias, which takes the speed of the push-out away again. */
    public static float relax(
            float normalImpulse, float mass, float vn, float separation, float bounceSpeed, float inverseH) {
        return visit(normalImpulse, mass, 1f, vn, bias(separation, bounceSpeed, inverseH, 0f), 0f);
    }

    private static float visit(float normalImpulse, float mass, float massScale, float vn, float bias, float decay) {
        return Branchless.positive((normalImpulse - mass * (massScale * vn + bias)) - decay);
    }

    /** Whether the constraint carries its circles: it presses, or touches at rest. */
    public static int carries(float normalImpulse, float separation, float vn, float threshold) {
        return Branchless.isPositive(normalImpulse) | Branchless.isNegative(separation) & ~isImpact(vn, threshold);
    }

    /**
     * Whether a visit with bias, of a warm start without impulse, changes nothing: the surfaces have a gap that closes neither
     * at the normal speed nor at the one before impulses.
     */
    public static int staysClear(
            float separation, float normalImpulse, float vn, float before, float h, float inverseH) {
        return isIdle(separation, normalImpulse, 0f)
                & ~meets(separation, vn, inverseH)
                & ~overlapAfter(h, separation, before);
    }
}
