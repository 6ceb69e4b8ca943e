package io.github.circles2d.world.device.plan;

import io.github.circles2d.opencl.Kernel;
import io.github.circles2d.world.device.memory.DeviceArray;
import io.github.circles2d.world.device.memory.StageKernels;
import io.github.circles2d.world.model.GridLevels;
import java.util.List;

/** One launch per stage, and per colour of contacts. It takes any world; {@code kernels/world/stages/Solver.cl}. */
public final class ByColours implements Plan, SubSteps.Passes {
    private static final int COLOURS = 4;

    private Stages stages;
    private Kernel fill;
    private Kernel integrateVelocities;
    private Kernel solve;
    private Kernel integratePositions;
    private Kernel relax;
    private SubSteps subSteps;
    private Kernel finalizePositions;

    /** Null, as the next, if steps do not record what contacts do. */
    private Kernel begin;

    private Kernel tell;

    @Override
    public List<String> files() {
        return List.of(
                "world/stages/Solver.cl",
                "world/stages/Touches.cl",
                "world/stages/CrossSolver.cl",
                "world/stages/Joints.cl",
                "world/stages/Bodies.cl",
                "world/stages/Sleeping.cl");
    }

    @Override
    public void load(Stages shared) {
        stages = shared;
        fill = stages.kernel("contacts_fill");
        begin = stages.recording() ? stages.kernel("touches_begin") : null;
        tell = stages.recording() ? stages.kernel("touches_tell") : null;
        integrateVelocities = stages.kernel("solver_integrateVelocities");
        solve = stages.kernel("solver_solve");
        integratePositions = stages.kernel("solver_integratePositions");
        relax = stages.kernel("solver_relax");
        finalizePositions = stages.kernel("solver_finalizePositions");
        subSteps = new SubSteps(stages);
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
        runByColour(steps.levels(), fill);
        subSteps.begin(steps, true);
        if (stages.recording()) {
            stages.record(begin, 0).run(2L * steps.circles());
        }
        BodyStage bodies = stages.findBodies(steps.circles()); // contacts may have refused the step as they were filled
        stages.record(integrateVelocities, 1);
        stages.record(solve, 1);
        stages.record(integratePositions, 1);
        stages.record(relax, 2);
        subSteps.make(steps, true, bodies, this);
    }

    @Override
    public void start(Steps steps, int sub) {
        integrateVelocities.arg(StageKernels.own(0), sub).run(steps.circles());
    }

    @Override
    public void solve(Steps steps, int sub) {
        runByColour(steps.levels(), solve);
    }

    @Override
    public void move(Steps steps, int sub) {
        integratePositions.arg(StageKernels.own(0), sub).run(steps.circles());
    }

    @Override
    public void relax(Steps steps, int sub, boolean last) {
        relax.arg(StageKernels.own(1), last ? 1 : 0);
        runByColour(steps.levels(), relax);
    }

    @Override
    public void finish(Steps steps) {
        finalizePositions.run(steps.circles());
    }

    @Override
    public void tell(int circles) {
        stages.tell(tell, 0).run(2L * circles);
    }

    /** Runs a kernel that works on groups of contacts colour by colour, a work-item per group. Its first argument of its own is the colour. */
    private static void runByColour(GridLevels levels, Kernel kernel) {
        for (int colour = 0; colour < COLOURS; colour++) {
            kernel.arg(StageKernels.own(0), colour).run(levels.buckets() / COLOURS);
        }
    }

    @Override
    public void countDegrees(int contacts) {
        stages.countDegrees(DeviceArray.PAIR, contacts);
    }
}
