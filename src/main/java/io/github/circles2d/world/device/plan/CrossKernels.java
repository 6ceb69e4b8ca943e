package io.github.circles2d.world.device.plan;

import io.github.circles2d.opencl.Kernel;
import io.github.circles2d.world.device.memory.StageKernels;
import java.util.function.Supplier;

/**
 * The cross contacts of a pass, behind its like contacts, in two launches: light circles visit theirs, then heavy circles take the sums;
 * {@code kernels/world/stages/CrossSolver.cl}. It does nothing where there is one level.
 */
final class CrossKernels {
    private final Stages stages;
    private final Supplier<Kernel> fill;
    private final Supplier<Kernel> solve;
    private final Supplier<Kernel> relax;
    private final Supplier<Kernel> take;

    CrossKernels(Stages stages) {
        this.stages = stages;
        fill = stages.later("cross_fill");
        solve = stages.later("cross_solve");
        relax = stages.later("cross_relax");
        take = stages.later("cross_take");
    }

    /** Fills the contacts, and sums up the impulses that they begin with. */
    void fill(Steps steps) {
        if (!steps.haveOneLevel()) {
            fillLight(steps);
            take(steps, false, true);
        }
    }

    /** The biased pass. */
    void solve(Steps steps) {
        if (!steps.haveOneLevel()) {
            solveLight(steps);
            take(steps, true, false);
        }
    }

    void relax(Steps steps, boolean last) {
        if (!steps.haveOneLevel()) {
            relaxLight(steps, last);
            take(steps, true, !last);
        }
    }

    /** The first half of filling: light circles fill theirs. */
    void fillLight(Steps steps) {
        fill.get().run(steps.circles());
    }

    /** The first half of the biased pass. */
    void solveLight(Steps steps) {
        stages.record(solve.get(), 0).run(steps.circles());
    }

    /** The first half of the relaxing pass. */
    void relaxLight(Steps steps, boolean last) {
        stages.record(relax.get().arg(StageKernels.own(0), last ? 1 : 0), 1).run(steps.circles());
    }

    /** Gives heavy circles what a pass has summed up for them. */
    void take(Steps steps, boolean velocities, boolean impulses) {
        take.get()
                .arg(StageKernels.own(0), velocities ? 1 : 0)
                .arg(StageKernels.own(1), impulses ? 1 : 0)
                .run(steps.circles());
    }
}
