package io.github.circles2d.world.model;

/** Which pairs may meet within a step; -1 if they may, else 0, without a branch, since chance decides. */
public final class PairRule {
    private PairRule() {}

    /** Whether speculative distances meet. */
    public static int isNear(float dx, float dy, float speculativeDistance, float otherSpeculativeDistance) {
        float limit = speculativeDistance + otherSpeculativeDistance;
        return Branchless.isNegative(dx * dx + dy * dy - limit * limit);
    }

    /**
     * No only if {@link TimeOfImpact#timeOfImpact} is at least 1. There circles touch if max(c, 0) is less than b and a root of b *
     * b - a * c. For a positive c that root is at most b; 2.5 b is more than both, also if b * b is inexact.
     */
    public static int mayTouch(float dx, float dy, float ux, float uy, float sum) {
        float b = dx * ux + dy * uy;
        float c = (dx * dx + dy * dy) - sum * sum;
        return Branchless.isNegative(CircleMath.max(c, 0f) - 2.5f * b);
    }
}
