package io.github.circles2d.world;

import io.github.circles2d.opencl.Kernel;

/** Stage Solver on a device; {@code kernels/world/Solver.cl}. The same as {@link JvmSolver}. */
final class ClSolver {
    private final Kernel accelerate;
    private final Kernel push;
    private final Kernel move;
    private final Kernel relax;
    private final Kernel finish;

    ClSolver(ClKernels kernels) {
        accelerate = kernels.staged("solver_accelerate");
        push = kernels.staged("solver_push");
        move = kernels.staged("solver_move");
        relax = kernels.staged("solver_relax");
        finish = kernels.staged("solver_finish");
    }

    void solve(Levels levels, int circles, int subSteps) {
        for (int sub = 0; sub < subSteps; sub++) {
            accelerate.run(circles);
            ClColours.run(levels, push);
            move.run(circles);
            relax.arg(ClBuffers.COUNT + 2, sub == subSteps - 1 ? 1 : 0);
            ClColours.run(levels, relax);
        }
        finish.run(circles);
    }
}
