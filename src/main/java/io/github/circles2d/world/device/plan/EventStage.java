package io.github.circles2d.world.device.plan;

import io.github.circles2d.opencl.DeviceBuffer;
import io.github.circles2d.opencl.Kernel;
import io.github.circles2d.world.device.memory.DeviceArray;
import io.github.circles2d.world.device.memory.DeviceArrays;
import io.github.circles2d.world.device.memory.EventArrays;
import io.github.circles2d.world.device.memory.Scan;
import io.github.circles2d.world.device.memory.StageKernels;

/** Decides what a step reports, behind a step of any plan that does not do so itself; {@code kernels/world/stages/Events.cl}. */
public final class EventStage {
    /** Work-items of kernels that take what there is in turn: enough for any device. */
    private static final int MOST_ITEMS = 1 << 17;

    /** The first argument behind the status and the fields. */
    private static final int FIRST = 2;

    private static final int LEAST_ITEMS = 1 << 10;

    private final DeviceArrays arrays;
    private final EventArrays events;
    private final Scan scan;
    private final Kernel begin;
    private final Kernel end;
    private final Kernel settle;
    private final Kernel write;
    private final Kernel clear;
    private final Kernel add;
    private final Kernel move;
    private final Kernel mark;
    private final Kernel ofMarked;

    EventStage(StageKernels kernels, DeviceArrays arrays, Scan scan, EventArrays events) {
        this.arrays = arrays;
        this.scan = scan;
        this.events = events;
        begin = kernels.plain("events_begin");
        end = kernels.plain("events_end");
        settle = kernels.plain("events_settle");
        write = kernels.plain("events_write");
        clear = kernels.plain("events_clear");
        add = kernels.plain("events_add");
        move = kernels.plain("events_move");
        mark = kernels.plain("events_mark");
        ofMarked = kernels.plain("events_ofMarked");
    }

    private Kernel bind(Kernel kernel) {
        kernel.arg(0, arrays.get(DeviceArray.STATUS)).arg(1, arrays.get(DeviceArray.FIELDS));
        return events.bindAt(kernel, FIRST);
    }

    private static int items(long count) {
        return (int) Math.max(LEAST_ITEMS, Math.min(MOST_ITEMS, count));
    }

    /** Enqueues what comes before a step. */
    public void begin() {
        bind(begin).run(1);
    }

    /** Enqueues what comes behind a step, once its pairs have been told of. circles: of the step. */
    public void decide(int circles) {
        bind(end);
        int next = FIRST + EventArrays.ARGUMENTS;
        if (arrays.features().terrain()) {
            end.arg(next++, arrays.get(DeviceArray.KIND_MOTION));
        }
        if (arrays.features().sleeping()) {
            end.arg(next, arrays.get(DeviceArray.SLOT_OF))
                    .arg(next + 1, arrays.get(DeviceArray.HOME_TRAITS))
                    .arg(next + 2, arrays.get(DeviceArray.HOME_SLEEP));
        }
        end.run(items(events.places()));
        scan.run(events.tally(), events.ids() + 1, events.blockSums(), events.starts(), arrays.get(DeviceArray.STATUS));
        bind(settle).run(items(circles));
        bind(write).run(items(circles));
    }

    /** Empties the table of pairs. */
    public void clear() {
        clear.arg(0, events.touching()).arg(1, events.places() - 1).run(items(events.places()));
    }

    /** Puts the first newcomers into the table. */
    public void add(int count) {
        bind(add).arg(FIRST + EventArrays.ARGUMENTS, count).run(items(count));
    }

    /** Puts the pairs of another table into the table. */
    public void move(DeviceBuffer from, int places) {
        bind(move)
                .arg(FIRST + EventArrays.ARGUMENTS, from)
                .arg(FIRST + EventArrays.ARGUMENTS + 1, places - 1)
                .run(items(places));
    }

    /** Lists the pairs of circles among the newcomers, or forgets them. */
    public void ofCircles(DeviceBuffer ids, int count, boolean forgets) {
        mark(ids, count, 1);
        bind(ofMarked).arg(FIRST + EventArrays.ARGUMENTS, forgets ? 1 : 0).run(items(events.places()));
        mark(ids, count, 0);
    }

    private void mark(DeviceBuffer ids, int count, int as) {
        mark.arg(0, ids)
                .arg(1, count)
                .arg(2, events.tally())
                .arg(3, as)
                .arg(4, arrays.get(DeviceArray.STATUS))
                .run(count);
    }
}
