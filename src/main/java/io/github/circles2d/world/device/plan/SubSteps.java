package io.github.circles2d.world.device.plan;

import io.github.circles2d.opencl.Kernel;
import io.github.circles2d.world.device.memory.StageKernels;
import java.util.function.Supplier;

/**
 * The sub-steps of a step with launches for each pass: those of a plan over contacts of one level, and behind them joints ({@link JointKernels}), bodies
 * that are pushed ({@link BodyStage}), and cross contacts: light circles visit theirs, then heavy circles take the sums;
 * {@code kernels/world/stages/CrossSolver.cl}.
 */
final class SubSteps {
    /** What a plan enqueues of a sub-step: for circles, and for contacts of one level. */
    interface Passes {
        void start(Steps steps, int sub);

        void solve(Steps steps, int sub);

        void move(Steps steps, int sub);

        void relax(Steps steps, int sub, boolean last);

        /** Behind the last sub-step. */
        void finish(Steps steps);
    }

    private final Stages stages;

    /** Null in a world without joints. */
    private final JointKernels joints;

    private final Supplier<Kernel> fill;
    private final Supplier<Kernel> solve;
    private final Supplier<Kernel> relax;
    private final Supplier<Kernel> take;

    SubSteps(Stages stages) {
        this.stages = stages;
        joints = stages.joints();
        fill = stages.later("cross_fill");
        solve = stages.later("cross_solve");
        relax = stages.later("cross_relax");
        take = stages.later("cross_take");
    }

    /**
     * Enqueues what joints and cross contacts begin with.
     *
     * @param takes whether heavy circles take their sums in a launch; else they do so as they start or move
     */
    void begin(Steps steps, boolean takes) {
        if (joints != null) {
            joints.prepare();
        }
        if (!steps.haveOneLevel()) {
            fill.get().run(steps.circles());
            take(steps, takes, false, true);
        }
    }

    /** Enqueues the sub-steps. Without bodies that are pushed, they are null. */
    void make(Steps steps, boolean takes, BodyStage bodies, Passes plan) {
        if (bodies != null) {
            bodies.begin();
        }
        for (int sub = 0; sub < steps.subSteps(); sub++) {
            boolean last = sub == steps.subSteps() - 1;
            plan.start(steps, sub);
            plan.solve(steps, sub);
            if (joints != null) {
                joints.solve(sub);
            }
            if (bodies != null) {
                bodies.solveJoints(sub);
            }
            if (!steps.haveOneLevel()) {
                stages.record(solve.get(), 0).run(steps.circles());
                take(steps, takes, true, false);
            }
            if (bodies != null) {
                bodies.solve(sub);
            }
            plan.move(steps, sub);
            plan.relax(steps, sub, last);
            if (joints != null) {
                joints.relax(sub, last);
            }
            if (bodies != null) {
                bodies.relaxJoints(sub, last);
            }
            if (!steps.haveOneLevel()) {
                stages.record(relax.get().arg(StageKernels.own(0), last ? 1 : 0), 1)
                        .run(steps.circles());
                take(steps, takes, true, !last);
            }
            if (bodies != null) {
                bodies.relax(sub, last);
            }
        }
        plan.finish(steps);
        if (bodies != null) {
            bodies.end(steps.circles());
        }
    }

    private void take(Steps steps, boolean takes, boolean velocities, boolean impulses) {
        if (takes) {
            take.get()
                    .arg(StageKernels.own(0), velocities ? 1 : 0)
                    .arg(StageKernels.own(1), impulses ? 1 : 0)
                    .run(steps.circles());
        }
    }
}
