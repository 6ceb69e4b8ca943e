package io.github.circles2d.world.model;

/** The rule for which pairs of circles may meet within a step. */
public final class PairRule {
    private PairRule() {}

    /**
     * Whether the speculative distances of two circles meet. No branch, which would be taken as if by chance.
     *
     * @param dx difference of the positions
     * @param dy difference of the positions
     * @param speculativeDistance speculative distance of the one ({@link CircleMath#speculativeDistance})
     * @param otherSpeculativeDistance speculative distance of the other
     * @return -1 if they do, else 0
     */
    public static int isNear(float dx, float dy, float speculativeDistance, float otherSpeculativeDistance) {
        float limit = speculativeDistance + otherSpeculativeDistance;
        return Branchless.isNegative(dx * dx + dy * dy - limit * limit);
    }
}
