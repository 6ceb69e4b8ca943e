package io.github.circles2d.world.device.plan;

import io.github.circles2d.world.model.GridLevels;

/**
 * Steps to enqueue. Slots are those at home before the first step; later steps have as many as circles.
 *
 * @param bodies whether there may be bodies that are pushed
 * @param waking whether circles that sleep can wake; else steps do not take any
 * @param reportsBehind whether what the step reports is decided behind what its plan enqueues
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
        boolean reportsBehind,
        boolean recording,
        boolean sensing,
        boolean turning,
        boolean joints,
        boolean bodies,
        boolean sleeping,
        boolean waking) {
    boolean haveOneLevel() {
        return levels.usedCount == 1;
    }

    /** Whether others than contacts of circles of one level are visited in passes. */
    boolean sharePasses() {
        return joints || bodies || !haveOneLevel();
    }
}
