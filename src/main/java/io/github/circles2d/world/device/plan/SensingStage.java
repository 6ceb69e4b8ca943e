package io.github.circles2d.world.device.plan;

import io.github.circles2d.opencl.Kernel;
import io.github.circles2d.world.device.memory.DeviceArray;
import io.github.circles2d.world.device.memory.DeviceArrays;
import io.github.circles2d.world.device.memory.EventArrays;
import io.github.circles2d.world.device.memory.SensingArrays;
import io.github.circles2d.world.device.memory.StageKernels;
import java.util.function.Supplier;

/** Sensed pairs, around a step of any plan, {@code kernels/world/stages/Sensing.cl} and {@code StaticSensing.cl}; {@code world.jvm.Sensing} does the same. */
public final class SensingStage {
    private final DeviceArrays arrays;
    private final EventArrays events;
    private final Kernel begin;
    private final Supplier<Kernel> find;
    private final StageKernels kernels;

    /** Null if no static circles sense each other. */
    private Kernel findStatics;

    /** Null if no static circles sense pieces of bodies. */
    private Kernel findPieces;

    SensingStage(StageKernels kernels, DeviceArrays arrays, EventArrays events) {
        this.kernels = kernels;
        this.arrays = arrays;
        this.events = events;
        begin = kernels.plain("sensing_begin");
        find = kernels.later("sensing_find");
    }

    /** Compiles what the steps to come need to find static circles that sense each other, and pieces. */
    public void prepare(boolean statics, boolean bodies) {
        findStatics = statics ? kernels.staged("statics_find") : null;
        findPieces = bodies && arrays.features().terrain() ? kernels.staged("statics_findPieces") : null;
    }

    /** Enqueues what comes before a step. */
    public void begin(SensingArrays sensing, int slots) {
        begin.arg(0, arrays.get(DeviceArray.HOME_ID))
                .arg(1, arrays.get(DeviceArray.HOME_CIRCLE))
                .arg(2, slots)
                .arg(3, arrays.get(DeviceArray.STATUS))
                .arg(4, sensing.start())
                .run(slots);
    }

    /** Enqueues what comes behind a step, which has bound the arrays: tells of the pairs. */
    public void find(SensingArrays sensing, int circles) {
        run(find.get(), sensing, circles);
        if (findStatics != null) {
            run(findStatics, sensing, circles);
        }
        if (findPieces != null) {
            run(findPieces, sensing, circles);
        }
    }

    private void run(Kernel kernel, SensingArrays sensing, int circles) {
        kernel.arg(StageKernels.own(0), sensing.start()).arg(StageKernels.own(1), sensing.seeking());
        events.bind(kernel, 2).run(circles);
    }
}
