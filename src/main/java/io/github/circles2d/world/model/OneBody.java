package io.github.circles2d.world.model;

/**
 * The visit of a one-body constraint: a circle and what it meets that is no circle. Walls are the first kind. A kind finds how far away
 * it is and how fast it comes along its normal; the visit is the same for all. The effective mass is 1, so impulses are speeds. A circle
 * visits its own in their order.
 *
 * <p>A visit leaves its results in the fields. {@link Constraints} has the formulas.
 */
public final class OneBody {
    private static final float MASS = 1f;

    /** Target speed of a bounce, which the relaxing pass of the sub-step needs; 0 if there is none. */
    public float bounceSpeed;

    /** The impulse to apply. */
    public float impulse;

    /** The accumulated normal impulse. */
    public float normalImpulse;

    /** Whether the circle has been left alone. */
    public boolean leaves;

    /** Whether the circle has bounced freely. */
    public boolean bounced;

    /**
     * The visit with bias.
     *
     * @param gap distance of the surfaces at the end of the sub-step
     * @param thresholdRate gravity's part of the restitution threshold, by length
     * @param loaded greater than 0 if something carries the circle
     * @param before normal speed before any impulse
     * @param vn normal speed
     * @param accumulated the normal impulse so far
     */
    public void solve(
            float gap,
            float r,
            float restitution,
            float thresholdRate,
            float loaded,
            float before,
            float vn,
            float accumulated,
            StepConstants k) {
        float threshold = threshold(r, restitution, thresholdRate, k);
        float pushSpeed = k.pushRate * (2f * r);
        bounceSpeed = Constraints.bounceSpeed(restitution, loaded, before, gap, k.h, threshold, pushSpeed);
        int meets = Constraints.meets(gap, vn, k.inverseH);
        int visit = Constraints.visitOf(restitution, loaded, 0, accumulated, vn, meets, threshold);
        leaveOrBounce(visit, restitution, vn, accumulated);
        if (visit == Constraints.SOLVE) {
            normalImpulse = Constraints.solve(accumulated, MASS, vn, gap, bounceSpeed, pushSpeed, k.oneBodySoftness, k);
            impulse = normalImpulse - accumulated;
        }
    }

    /**
     * The visit without bias; parameters are those of {@link #solve}. The impulse of a bounce is not to be kept.
     *
     * @param bounce the target speed that {@link #solve} has found
     */
    public void relax(
            float gap,
            float r,
            float restitution,
            float thresholdRate,
            float loaded,
            float bounce,
            float vn,
            float accumulated,
            StepConstants k) {
        float threshold = threshold(r, restitution, thresholdRate, k);
        int visit = Constraints.visitOf(restitution, loaded, 0, accumulated, vn, Constraints.ALWAYS, threshold);
        leaveOrBounce(visit, restitution, vn, accumulated);
        if (visit == Constraints.SOLVE) {
            normalImpulse = Constraints.relax(accumulated, MASS, vn, gap, bounce, k.inverseH);
            impulse = normalImpulse - accumulated;
        }
    }

    private void leaveOrBounce(int visit, float restitution, float vn, float accumulated) {
        leaves = visit == Constraints.LEAVE;
        bounced = visit == Constraints.BOUNCE;
        impulse = bounced ? Bounce.freeBounce(restitution, vn, MASS) : 0f;
        normalImpulse = accumulated;
    }

    private static float threshold(float r, float restitution, float thresholdRate, StepConstants k) {
        return Bounce.bounceThreshold(2f * r, restitution, thresholdRate, k.restRate, k.fixedThreshold);
    }
}
