package io.github.circles2d.world.device;

import io.github.circles2d.opencl.Kernel;
import io.github.circles2d.world.model.GridLevels;

/** Stage Contacts on a device; {@code kernels/world/Contacts.cl}. The same as {@code world.jvm.Contacts}. */
final class ContactsStage {
    private final DeviceArrays buffers;
    private final Scan scan;
    private final Kernel crowd;
    private final Kernel count;
    private final Kernel list;
    private final Kernel fill;

    ContactsStage(StageKernels kernels, DeviceArrays buffers, Scan scan) {
        this.buffers = buffers;
        this.scan = scan;
        crowd = kernels.staged("contacts_crowd");
        count = kernels.staged("contacts_count");
        list = kernels.staged("contacts_list");
        fill = kernels.staged("contacts_fill");
    }

    /**
     * Lists and fills the contacts.
     *
     * @param thinning whether to thin crowds out
     */
    void list(GridLevels levels, int circles, boolean thinning) {
        if (thinning) {
            crowd.run(circles);
        }
        count.run(circles);
        scan.run(buffers, levels.buckets() + 1, DeviceArrays.GROUP_START);
        list.run(2L * circles);
        Colours.run(levels, fill);
    }
}
