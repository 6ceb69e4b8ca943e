package io.github.circles2d.world.device.plan;

import io.github.circles2d.opencl.Kernel;
import io.github.circles2d.world.device.memory.StageKernels;
import io.github.circles2d.world.device.memory.TouchArrays;

/** The sub-steps of {@link ByColours} that record what contacts and walls do; {@code kernels/world/stages/Touches.cl}. */
final class RecordedSubSteps {
    private final Stages stages;
    private final CrossKernels cross;
    private final Kernel begin;
    private final Kernel integrateVelocities;
    private final Kernel solve;
    private final Kernel integratePositions;
    private final Kernel relax;
    private final Kernel finalizePositions;
    private final Kernel tell;

    RecordedSubSteps(Stages stages, CrossKernels cross, Kernel finalizePositions) {
        this.stages = stages;
        this.cross = cross;
        this.finalizePositions = finalizePositions;
        begin = stages.kernel("touches_begin");
        integrateVelocities = stages.kernel("touches_integrateVelocities");
        solve = stages.kernel("touches_solve");
        integratePositions = stages.kernel("touches_integratePositions");
        relax = stages.kernel("touches_relax");
        tell = stages.kernel("touches_tell");
    }

    /** Enqueues what follows the filling of contacts. */
    void make(Steps steps) {
        TouchArrays touches = stages.touches();
        stages.record(begin, 0).run(2L * steps.circles());
        for (int sub = 0; sub < steps.subSteps(); sub++) {
            move(integrateVelocities, sub, steps);
            ByColours.runByColour(steps.levels(), solve.arg(StageKernels.own(1), touches.contacts()));
            cross.solve(steps);
            move(integratePositions, sub, steps);
            boolean last = sub == steps.subSteps() - 1;
            relax.arg(StageKernels.own(1), last ? 1 : 0).arg(StageKernels.own(2), touches.contacts());
            ByColours.runByColour(steps.levels(), relax);
            cross.relax(steps, last);
        }
        finalizePositions.run(steps.circles());
    }

    /** Enqueues what tells of the contacts and walls of the step. */
    void tell(int circles) {
        stages.tell(tell, 0).run(2L * circles);
    }

    private void move(Kernel kernel, int sub, Steps steps) {
        kernel.arg(StageKernels.own(0), sub)
                .arg(StageKernels.own(1), stages.touches().slots())
                .run(steps.circles());
    }
}
