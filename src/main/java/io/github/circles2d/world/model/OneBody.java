package io.github.circles2d.world.model;

/**
 * The visit of a circle and something that is no circle, by {@link Constraints}; it leaves its results in the fields. Impulses are speeds.
 * Walls are the first kind: a kind finds how far away it is and how fast it comes along its normal.
 */
public final class OneBody {
    private static final float MASS = 1f;

    /** For the relaxing pass of the sub-step. */
    public float bounceSpeed;

    /** Before the visit. */
    float normalSpeed;

    /** To be applied. */
    public float impulse;

    /** Accumulated. */
    public float normalImpulse;

    public boolean leaves;

    /** In free flight. */
    public boolean bounced;

    /** With bias. The rate is gravity's part of the threshold, by length. */
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
        normalSpeed = vn;
        float threshold = threshold(r, restitution, thresholdRate, k);
        float pushSpeed = k.pushRate * (2f * r);
        bounceSpeed = Constraints.bounceSpeed(restitution, loaded, before, gap, k.h, threshold, pushSpeed);
        int meets = Constraints.meets(gap, vn, k.inverseH);
        int visit = Constraints.visitOf(restitution, loaded, 0, accumulated, vn, meets, threshold);
        leaveOrBounce(visit, restitution, accumulated);
        if (visit == Constraints.SOLVE) {
            normalImpulse = Constraints.solve(accumulated, MASS, vn, gap, bounceSpeed, pushSpeed, k.oneBodySoftness, k);
            impulse = normalImpulse - accumulated;
        }
    }

    /** Without bias; bounce is the speed that {@link #solve} has found. */
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
        normalSpeed = vn;
        float threshold = threshold(r, restitution, thresholdRate, k);
        int visit = Constraints.visitOf(restitution, loaded, 0, accumulated, vn, Constraints.ALWAYS, threshold);
        leaveOrBounce(visit, restitution, accumulated);
        if (visit == Constraints.SOLVE) {
            normalImpulse = Constraints.relax(accumulated, MASS, vn, gap, bounce, k.inverseH);
            impulse = normalImpulse - accumulated;
        }
    }

    /** Of the normal impulses of a visit, the one that bounds the other rows behind it. */
    float boundingImpulse() {
        return bounced ? impulse : normalImpulse;
    }

    /** Whether the impulses of the other rows accumulate; bounce: target speed. */
    boolean keepsRows(float bounce) {
        return !(bounced || leaves || bounce > 0f);
    }

    private void leaveOrBounce(int visit, float restitution, float accumulated) {
        leaves = visit == Constraints.LEAVE;
        bounced = visit == Constraints.BOUNCE;
        impulse = bounced ? Bounce.freeBounce(restitution, normalSpeed, MASS) : 0f;
        normalImpulse = accumulated;
    }

    private static float threshold(float r, float restitution, float thresholdRate, StepConstants k) {
        return Bounce.bounceThreshold(2f * r, restitution, thresholdRate, k.restRate, k.fixedThreshold);
    }
}
