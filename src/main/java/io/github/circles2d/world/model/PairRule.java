package io.github.circles2d.world.model;

/** -1 for yes, else 0, without a branch, since chance decides. */
public final class PairRule {
    private PairRule() {}

    public static int isNear(float dx, float dy, float speculativeDistance, float otherSpeculativeDistance) {
        float limit = speculativeDistance + otherSpeculativeDistance;
        return Branchless.isNegative(dx * dx + dy * dy - limit * limit);
    }

    /** No only if {@link TimeOfImpact#timeOfImpact} is at least 1: its divisor is at most 2 b, and 2.5 b covers rounding. */
    public static int mayTouch(float dx, float dy, float ux, float uy, float sum) {
        float b = dx * ux + dy * uy;
        float c = (dx * dx + dy * dy) - sum * sum;
        return Branchless.isNegative(CircleMath.max(c, 0f) - 2.5f * b);
    }
}
