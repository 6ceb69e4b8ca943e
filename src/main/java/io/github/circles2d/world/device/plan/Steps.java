package io.github.circles2d.world.device.plan;

import io.github.circles2d.world.model.GridLevels;

/**
 * Steps to enqueue.
 *
 * @param count how many
 * @param levels shape of the grids
 * @param slots slots at home before the first step; later steps have as many as circles
 * @param circles circles
 * @param subSteps sub-steps of a step
 * @param warmScale what impulses of the step before the first are multiplied by
 * @param sweeping whether the steps take fast circles
 * @param thinning whether the steps thin crowds out
 * @param recording whether the steps record what contacts do, for events
 * @param sensing whether pairs are looked for that are only sensed
 */
public record Steps(
        int count,
        GridLevels levels,
        int slots,
        int circles,
        int subSteps,
        float warmScale,
        boolean sweeping,
        boolean thinning,
        boolean recording,
        boolean sensing) {
    /** Whether all circles are of one level. */
    boolean haveOneLevel() {
        return levels.usedCount == 1;
    }

    /** The level of all circles, where they are of one. */
    int level() {
        return levels.used[0];
    }
}
