package io.github.circles2d.world.device.plan;

import io.github.circles2d.opencl.Kernel;
import io.github.circles2d.opencl.KernelSource;
import io.github.circles2d.world.device.memory.JointUpload;
import io.github.circles2d.world.device.memory.StageKernels;

/** Circles that wake as a step begins, and those that fall asleep behind it; {@code kernels/world/stages/Sleeping.cl}. */
final class SleepStage {
    /** Work-items of the work-group that wakes from circle to circle. */
    private static final int GROUP = StageKernels.SMALL_GROUPS ? 16 : 256;

    private final Kernel press;
    private final Kernel wake;
    private final Kernel spread;
    private final Kernel keep;
    private final Kernel end;

    /** Null in a world without joints, as the next. */
    private final Kernel hold;

    private final Kernel held;

    private final JointUpload joints;

    SleepStage(StageKernels kernels, JointUpload joints, boolean haveJoints) {
        this.joints = joints;
        press = kernels.staged("sleeping_press");
        wake = kernels.staged("sleeping_wake");
        spread = kernels.staged("sleeping_spread");
        keep = kernels.staged("sleeping_keep");
        end = kernels.staged("sleeping_end");
        hold = haveJoints ? kernels.staged("sleeping_hold") : null;
        held = haveJoints ? kernels.staged("sleeping_held") : null;
    }

    /** Adds the numbers that the kernels share with the host. */
    static KernelSource define(KernelSource source) {
        return source.define("SLEEPING_GROUP", GROUP);
    }

    /** Behind the grid. */
    void wake(int circles) {
        press.run(circles);
        runOverJoints(hold);
        wake.run(circles);
        spread.run(GROUP, GROUP);
        keep.run(circles);
    }

    /** Behind the step and what it reports. */
    void end(int circles) {
        runOverJoints(held);
        end.run(circles);
    }

    private void runOverJoints(Kernel kernel) {
        if (kernel != null && joints.any()) {
            kernel.run(joints.count());
        }
    }
}
