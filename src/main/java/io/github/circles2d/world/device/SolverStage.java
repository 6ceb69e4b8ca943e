package io.github.circles2d.world.device;

import io.github.circles2d.opencl.Kernel;
import io.github.circles2d.world.model.GridLevels;

/** Stage Solver on a device; {@code kernels/world/Solver.cl}. The same as {@code world.jvm.Solver}. */
final class SolverStage {
    private final Kernel accelerate;
    private final Kernel push;
    private final Kernel move;
    private final Kernel relax;
    private final Kernel finish;

    SolverStage(StageKernels kernels) {
        accelerate = kernels.staged("solver_accelerate");
        push = kernels.staged("solver_push");
        move = kernels.staged("solver_move");
        relax = kernels.staged("solver_relax");
        finish = kernels.staged("solver_finish");
    }

    void solve(GridLevels levels, int circles, int subSteps) {
        for (int sub = 0; sub < subSteps; sub++) {
            accelerate.run(circles);
            Colours.run(levels, push);
            move.run(circles);
            relax.arg(DeviceArrays.COUNT + 2, sub == subSteps - 1 ? 1 : 0);
            Colours.run(levels, relax);
        }
        finish.run(circles);
    }
}
