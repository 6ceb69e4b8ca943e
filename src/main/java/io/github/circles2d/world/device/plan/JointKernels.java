package io.github.circles2d.world.device.plan;

import io.github.circles2d.opencl.Kernel;
import io.github.circles2d.opencl.KernelSource;
import io.github.circles2d.world.device.memory.JointUpload;
import io.github.circles2d.world.device.memory.StageKernels;
import java.util.function.Supplier;

/**
 * The joints of a pass, between its like and its cross contacts; {@code kernels/world/stages/Joints.cl}. It does nothing in steps without joints.
 */
final class JointKernels {
    /** Work-items that visit a batch. */
    private static final int GROUP = StageKernels.SMALL_GROUPS ? 4 : 128;

    // what a pass does
    private static final int PREPARE = 0;
    private static final int SOLVE = 1;
    private static final int RELAX = 2;

    // bits of what a step knows of a joint
    private static final int RELAXES = 1;
    private static final int STILL_A = 2;
    private static final int STILL_B = 4;

    private final JointUpload joints;
    private final Kernel find;
    private final Kernel begin;
    private final Supplier<Kernel> passBatches;
    private final Supplier<Kernel> passColour;
    private final Supplier<Kernel> passSplit;
    private final Supplier<Kernel> takeSums;

    /** Of a world that has joints. */
    JointKernels(StageKernels kernels, JointUpload joints) {
        this.joints = joints;
        find = kernels.staged("joints_find");
        begin = kernels.staged("joints_begin");
        passBatches = kernels.later("joints_passBatches");
        passColour = kernels.later("joints_passColour");
        passSplit = kernels.later("joints_passSplit");
        takeSums = kernels.later("joints_takeSums");
    }

    /** Adds the numbers that the kernels share with the host. */
    static KernelSource define(KernelSource source) {
        return source.define("JOINT_GROUP", GROUP)
                .define("JOINT_PREPARE", PREPARE)
                .define("JOINT_SOLVE", SOLVE)
                .define("JOINT_RELAX", RELAX)
                .define("JOINT_RELAXES", RELAXES)
                .define("JOINT_STILL_A", STILL_A)
                .define("JOINT_STILL_B", STILL_B);
    }

    /** Whether the joints need a part of the kernels. */
    boolean need(String part) {
        return joints.any()
                && switch (part) {
                    case Plans.JOINT_BATCHES -> joints.batches() > 0;
                    case Plans.JOINT_COLOURS -> areInColours();
                    case Plans.SPLIT_JOINTS -> joints.split() > 0;
                    default -> false;
                };
    }

    private boolean areInColours() {
        for (int colour = 0; colour < joints.colours(); colour++) {
            if (joints.ofColour(colour) > 0) {
                return true;
            }
        }
        return false;
    }

    /** Finds the circles of joints, once circles are sorted. */
    void find() {
        if (joints.any()) {
            find.run(Math.max(joints.count(), joints.splitCircles()));
        }
    }

    /** Makes joints ready, once it is known that the step is not refused; circles get the impulses that they begin with. */
    void prepare() {
        if (joints.any()) {
            begin.run(joints.count());
            pass(PREPARE, 0, false, true);
        }
    }

    /** The biased pass. */
    void solve(int subStep) {
        if (joints.any()) {
            pass(SOLVE, subStep, true, false);
        }
    }

    void relax(int subStep, boolean last) {
        if (joints.any()) {
            pass(RELAX, subStep, true, !last);
        }
    }

    private void pass(int what, int subStep, boolean speeds, boolean impulses) {
        if (joints.batches() > 0) {
            set(passBatches.get(), what, subStep).run((long) joints.batches() * GROUP, GROUP);
        }
        for (int colour = 0; colour < joints.colours(); colour++) {
            if (joints.ofColour(colour) > 0) {
                set(passColour.get(), what, subStep)
                        .arg(StageKernels.own(2), colour)
                        .run(joints.ofColour(colour));
            }
        }
        if (joints.split() > 0) {
            set(passSplit.get(), what, subStep).run(joints.split());
            takeSums.get()
                    .arg(StageKernels.own(0), speeds ? 1 : 0)
                    .arg(StageKernels.own(1), impulses ? 1 : 0)
                    .run(joints.splitCircles());
        }
    }

    private static Kernel set(Kernel kernel, int what, int subStep) {
        return kernel.arg(StageKernels.own(0), what).arg(StageKernels.own(1), subStep);
    }
}
