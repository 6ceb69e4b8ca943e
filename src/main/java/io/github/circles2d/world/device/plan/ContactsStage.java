package io.github.circles2d.world.device.plan;

import io.github.circles2d.opencl.Kernel;
import io.github.circles2d.world.device.memory.DeviceArray;
import io.github.circles2d.world.device.memory.DeviceArrays;
import io.github.circles2d.world.device.memory.Scan;
import io.github.circles2d.world.device.memory.StageKernels;
import io.github.circles2d.world.model.GridLevels;

/** Lists the contacts on a device, in no order within a group; {@code kernels/world/stages/Contacts.cl}. */
final class ContactsStage {
    private final DeviceArrays arrays;
    private final Scan scan;
    private final Kernel crowd;
    private final Kernel count;
    private final Kernel countByLevel;
    private final Kernel list;

    ContactsStage(StageKernels kernels, DeviceArrays arrays, Scan scan) {
        this.arrays = arrays;
        this.scan = scan;
        crowd = kernels.staged("contacts_crowd");
        count = kernels.staged("contacts_count");
        countByLevel = kernels.staged("contacts_countByLevel");
        list = kernels.staged("contacts_list");
    }

    /**
     * Lists the contacts.
     *
     * @param thinning whether to thin crowds out
     */
    void list(GridLevels levels, int circles, boolean thinning) {
        if (thinning) {
            crowd.run(circles);
        }
        if (levels.usedCount == 1) {
            count.run(circles);
        } else {
            countByLevel.run((long) levels.usedCount * circles);
        }
        scan.run(arrays, levels.groups(circles) + 1, DeviceArray.GROUP_START);
        list.run(2L * circles);
    }
}
