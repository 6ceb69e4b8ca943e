package io.github.circles2d.world.device.plan;

import io.github.circles2d.opencl.Kernel;
import io.github.circles2d.world.device.memory.StageKernels;
import io.github.circles2d.world.model.GridLevels;

/** {@code kernels/world/stages/ContinuousCollision.cl}; {@code world.jvm.ContinuousCollision} does the same. */
final class ContinuousCollisionStage {
    /** Work-items of a kernel that has nothing to do in most steps. */
    private static final int MOST_CARRY_ITEMS = 1 << 15;

    private final Kernel prepare;
    private final Kernel look;
    private final Kernel carry;
    private final Kernel clamp;

    ContinuousCollisionStage(StageKernels kernels) {
        prepare = kernels.staged("continuousCollision_prepare");
        look = kernels.staged("continuousCollision_look");
        carry = kernels.staged("continuousCollision_carry");
        clamp = kernels.staged("continuousCollision_clamp");
    }

    void sweep(GridLevels levels, int circles) {
        prepare.run(circles);
        look.run((levels.usedCount + 1L) * circles);
        for (int note = 0; note < 2; note++) {
            carry.arg(StageKernels.own(0), note).run(Math.min(circles, MOST_CARRY_ITEMS));
        }
        clamp.run(circles);
    }
}
