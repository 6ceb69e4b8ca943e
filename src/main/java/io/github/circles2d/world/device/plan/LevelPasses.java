package io.github.circles2d.world.device.plan;

import io.github.circles2d.opencl.Kernel;
import io.github.circles2d.world.device.memory.StageKernels;
import io.github.circles2d.world.device.memory.TileRecord;

/** The sub-steps of {@link Tiles} where there are several levels, or joints, or bodies that are pushed; {@code kernels/world/tiles/TileLevels.cl}. */
final class LevelPasses {
    private final Stages stages;
    private final CrossKernels cross;

    /** Null in a world without joints. */
    private final JointKernels joints;

    private final Kernel start;
    private final Kernel solve;
    private final Kernel move;
    private final Kernel relax;
    private final Kernel finish;

    LevelPasses(Stages stages) {
        this.stages = stages;
        cross = new CrossKernels(stages);
        joints = stages.joints();
        start = stages.kernel("solver_startSlots");
        solve = stages.kernel("solver_solveLevels");
        move = stages.kernel("solver_moveSlots");
        relax = stages.kernel("solver_relaxLevels");
        finish = stages.kernel("solver_finishSlots");
    }

    /** Enqueues what follows the arranging of tiles, up to the end of the last sub-step. Without bodies that are pushed, they are null. */
    void make(Steps steps, int tiles, BodyStage bodies) {
        boolean crosses = !steps.haveOneLevel();
        if (joints != null) {
            joints.prepare();
        }
        if (crosses) {
            cross.fillLight(steps);
            takeBeforeBodies(steps, false, true);
        }
        if (bodies != null) {
            bodies.begin();
        }
        for (int sub = 0; sub < steps.subSteps(); sub++) {
            runEach(start, sub, steps);
            boolean last = sub == steps.subSteps() - 1;
            runTiles(solve, sub, tiles);
            if (joints != null) {
                joints.solve(sub);
            }
            if (bodies != null) {
                bodies.solveJoints(sub);
            }
            if (crosses) {
                cross.solveLight(steps);
                takeBeforeBodies(steps, true, false);
            }
            if (bodies != null) {
                bodies.solve(sub);
            }
            runEach(move, sub, steps);
            runTiles(relax, sub, tiles);
            if (joints != null) {
                joints.relax(sub, last);
            }
            if (bodies != null) {
                bodies.relaxJoints(sub, last);
            }
            if (crosses) {
                cross.relaxLight(steps, last);
                takeBeforeBodies(steps, true, !last);
            }
            if (bodies != null) {
                bodies.relax(sub, last);
            }
        }
        finish.run(steps.circles());
        if (bodies != null) {
            bodies.end(steps.circles());
        }
    }

    /** Kernels that are for bodies, too, do not take the sums of heavy circles as the circles start or move. */
    private void takeBeforeBodies(Steps steps, boolean velocities, boolean impulses) {
        if (steps.bodies()) {
            cross.take(steps, velocities, impulses);
        }
    }

    private void runEach(Kernel kernel, int sub, Steps steps) {
        stages.record(kernel.arg(StageKernels.own(0), sub), 1).run(steps.circles());
    }

    private void runTiles(Kernel kernel, int sub, int tiles) {
        stages.record(kernel.arg(StageKernels.own(0), sub), 1).run((long) tiles * TileRecord.GROUP, TileRecord.GROUP);
    }
}
