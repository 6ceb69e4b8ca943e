package io.github.circles2d.bench.broadphase;

/**
 * Finds the pairs of circles whose reaches overlap. All implementations find the same pairs, to the bit: {@link Circles#near}
 * decides about every pair that is not ruled out before.
 */
interface BroadPhase {
    /**
     * What rounding may move a bound by, with circles in the unit square. A bound that is widened by it rules out no pair that
     * {@link Circles#near} accepts.
     */
    float SLACK = 0x1p-20f;

    /**
     * Takes over circles and forgets all earlier ones.
     *
     * @param reach radius of each circle, greater than 0; it stays the same in all steps
     */
    void start(float[] reach);

    /**
     * Adds each pair once, in any order.
     *
     * @param x where each circle is in this step, within [0, 1]
     * @param y likewise
     */
    void findPairs(float[] x, float[] y, PairList pairs);

    /** Work since {@link #start}. It is counted outside the innermost loops, so a timed step counts as well. */
    Counts counts();

    /** Whether a step depends on the step before it, by what it costs, not by what it finds. */
    boolean isIncremental();
}
