package io.github.circles2d.world.model;

/** The rule for which pairs of circles may meet within a step. */
public final class PairRule {
    private PairRule() {}

    /**
     * Whether the speculative distances of two circles meet. No branch, which would be taken as if by chance.
     *
     * @param dx difference of the positions
     * @param dy difference of the positions
     * @param speculativeDistance speculative distance of the one ({@link Paths#speculativeDistance})
     * @param otherSpeculativeDistance speculative distance of the other
     * @return -1 if they do, else 0
     */
    public static int isNear(float dx, float dy, float speculativeDistance, float otherSpeculativeDistance) {
        float limit = speculativeDistance + otherSpeculativeDistance;
        return Branchless.isNegative(dx * dx + dy * dy - limit * limit);
    }

    /**
     * Whether two circles may touch within the step, by their paths: no only where {@link TimeOfImpact#timeOfImpact} is at least 1. There
     * a circle touches another if max(c, 0) is less than b and a root of b * b - a * c. If c is positive, that root is at most b; 2.5 b
     * is more than both, also where b * b is too small a number to be exact. No root and no branch, since most pairs fail here.
     *
     * @param dx second position minus first
     * @param dy second position minus first
     * @param ux path of the first minus that of the second
     * @param uy path of the first minus that of the second
     * @param sum sum of the radii
     * @return -1 if they may, else 0
     */
    public static int mayTouch(float dx, float dy, float ux, float uy, float sum) {
        float b = dx * ux + dy * uy;
        float c = (dx * dx + dy * dy) - sum * sum;
        return Branchless.isNegative(CircleMath.max(c, 0f) - 2.5f * b);
    }
}
