package io.github.circles2d.world.device.plan;

import io.github.circles2d.opencl.Kernel;
import io.github.circles2d.world.device.memory.DeviceArray;
import io.github.circles2d.world.device.memory.DeviceArrays;
import io.github.circles2d.world.device.memory.EventArrays;
import io.github.circles2d.world.device.memory.SensingArrays;
import io.github.circles2d.world.device.memory.StageKernels;

/** Sensed pairs, around a step of any plan, {@code kernels/world/stages/Sensing.cl}; {@code world.jvm.Sensing} does the same. */
public final class SensingStage {
    private final DeviceArrays arrays;
    private final EventArrays events;
    private final Kernel begin;
    private final Kernel find;

    SensingStage(StageKernels kernels, DeviceArrays arrays, EventArrays events) {
        this.arrays = arrays;
        this.events = events;
        begin = kernels.plain("sensing_begin");
        find = kernels.staged("sensing_find");
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
        find.arg(StageKernels.own(0), sensing.start()).arg(StageKernels.own(1), sensing.seeking());
        events.bind(find, 2).run(circles);
    }
}
