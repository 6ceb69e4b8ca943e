package io.github.circles2d.world.device.plan;

import io.github.circles2d.opencl.Kernel;
import io.github.circles2d.world.device.memory.DeviceArray;
import io.github.circles2d.world.device.memory.StageKernels;
import io.github.circles2d.world.model.GridLevels;
import java.util.List;

/**
 * One launch per stage, and per colour of contacts. It takes any world, and suits devices with cheap launches;
 * {@code kernels/world/stages/Solver.cl}. {@code world.jvm.Solver} does the same.
 */
public final class ByColours implements Plan {
    private static final int COLOURS = 4;

    private Stages stages;
    private Kernel fill;
    private Kernel integrateVelocities;
    private Kernel solve;
    private Kernel integratePositions;
    private Kernel relax;
    private Kernel finalizePositions;
    private RecordedSubSteps recorded;

    @Override
    public List<String> files() {
        return List.of("world/stages/Solver.cl", "world/stages/Touches.cl");
    }

    @Override
    public void load(Stages shared) {
        stages = shared;
        fill = stages.kernel("contacts_fill");
        integrateVelocities = stages.kernel("solver_integrateVelocities");
        solve = stages.kernel("solver_solve");
        integratePositions = stages.kernel("solver_integratePositions");
        relax = stages.kernel("solver_relax");
        finalizePositions = stages.kernel("solver_finalizePositions");
        recorded = stages.recording() ? new RecordedSubSteps(stages, finalizePositions) : null;
    }

    @Override
    public boolean suits(Steps steps) {
        return true;
    }

    @Override
    public void enqueue(Steps steps) {
        stages.enqueueEach(steps, false, () -> makeSubSteps(steps));
    }

    private void makeSubSteps(Steps steps) {
        GridLevels levels = steps.levels();
        runByColour(levels, fill);
        if (steps.recording()) {
            recorded.make(steps);
            return;
        }
        for (int sub = 0; sub < steps.subSteps(); sub++) {
            integrateVelocities.arg(StageKernels.own(0), sub).run(steps.circles());
            runByColour(levels, solve);
            integratePositions.arg(StageKernels.own(0), sub).run(steps.circles());
            relax.arg(StageKernels.own(2), sub == steps.subSteps() - 1 ? 1 : 0);
            runByColour(levels, relax);
        }
        finalizePositions.run(steps.circles());
    }

    /**
     * Runs a kernel that works on groups of contacts: level by level, colour by colour, a work-item per group. The kernel's
     * first arguments of its own are the level and the colour.
     */
    static void runByColour(GridLevels levels, Kernel kernel) {
        for (int l = 0; l < levels.usedCount; l++) {
            int level = levels.used[l];
            int groups = levels.firstOfColour(level, 1) - levels.firstOfColour(level, 0);
            for (int colour = 0; colour < COLOURS; colour++) {
                kernel.arg(StageKernels.own(0), level)
                        .arg(StageKernels.own(1), colour)
                        .run(groups);
            }
        }
    }

    @Override
    public void countDegrees(int contacts) {
        stages.countDegrees(DeviceArray.PAIR, contacts);
    }
}
