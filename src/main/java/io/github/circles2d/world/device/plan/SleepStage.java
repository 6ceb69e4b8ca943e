package io.github.circles2d.world.device.plan;

import io.github.circles2d.opencl.Kernel;
import io.github.circles2d.opencl.KernelSource;
import io.github.circles2d.world.device.memory.BodyArrays;
import io.github.circles2d.world.device.memory.JointUpload;
import io.github.circles2d.world.device.memory.StageKernels;
import io.github.circles2d.world.model.Sleep;
import java.util.function.Supplier;

/** Circles that wake as a step begins, and those that fall asleep behind it; {@code kernels/world/stages/Sleeping.cl}. */
final class SleepStage {
    /** Work-items of the work-group that wakes from circle to circle. */
    private static final int GROUP = StageKernels.SMALL_GROUPS ? 16 : 256;

    private final Supplier<Kernel> press;
    private final Supplier<Kernel> wake;
    private final Supplier<Kernel> spread;
    private final Supplier<Kernel> keep;
    private final Kernel end;

    /** Null in a world without joints, as the next. */
    private final Supplier<Kernel> hold;

    private final Kernel held;

    private final JointUpload joints;

    /** Null, as the next two, in a world without bodies that are pushed. */
    private final BodyArrays bodies;

    private final Supplier<Kernel> pressByBodies;

    /** Null also in a world without joints. */
    private final Kernel holdByBodies;

    SleepStage(StageKernels kernels, JointUpload joints, boolean haveJoints, BodyArrays bodies) {
        this.joints = joints;
        this.bodies = bodies;
        pressByBodies = bodies == null ? null : kernels.later("sleeping_pressByBodies");
        holdByBodies = bodies == null || !haveJoints ? null : kernels.staged("sleeping_holdByBodies");
        press = kernels.later("sleeping_press");
        wake = kernels.later("sleeping_wake");
        spread = kernels.later("sleeping_spread");
        keep = kernels.later("sleeping_keep");
        end = kernels.staged("sleeping_end");
        hold = haveJoints ? kernels.later("sleeping_hold") : null;
        held = haveJoints ? kernels.staged("sleeping_held") : null;
    }

    /** Adds the numbers that the kernels share with the host. */
    static KernelSource define(KernelSource source) {
        return source.define("SLEEPING_GROUP", GROUP);
    }

    /** Behind the grid. */
    void wake(int circles) {
        wake(circles, 0);
        spread(1, Sleep.RINGS, 0);
        keep(circles);
    }

    /** Finds out who wakes, but for whom others wake. sleepers: how many circles bodies press, which {@link BodyArrays#sleepers} has. */
    void wake(int circles, int sleepers) {
        press.get().run(circles);
        if (hold != null) {
            runOverJoints(hold.get());
        }
        if (sleepers > 0) {
            pressByBodies
                    .get()
                    .arg(StageKernels.own(0), bodies.sleepers.get())
                    .arg(StageKernels.own(1), sleepers)
                    .run(sleepers);
        }
        wake.get().run(circles);
    }

    /** Makes some rings of those that wake others. sleepers: how many circles bodies may wake. */
    void spread(int from, int to, int sleepers) {
        if (bodies != null) {
            spread.get()
                    .arg(StageKernels.own(0), from)
                    .arg(StageKernels.own(1), to)
                    .arg(StageKernels.own(2), bodies.sleepers.get())
                    .arg(StageKernels.own(3), sleepers);
        }
        spread.get().run(GROUP, GROUP);
    }

    /** Once all have woken: those that rest keep what they have. */
    void keep(int circles) {
        keep.get().run(circles);
    }

    /** Behind the step: so many circles, which {@link BodyArrays#held} has, do not fall asleep. */
    void keepAwake(int held) {
        holdByBodies
                .arg(StageKernels.own(0), bodies.held.get())
                .arg(StageKernels.own(1), held)
                .run(held);
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
