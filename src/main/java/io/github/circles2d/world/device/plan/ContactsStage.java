package io.github.circles2d.world.device.plan;

import io.github.circles2d.opencl.Kernel;
import io.github.circles2d.world.device.memory.DeviceArray;
import io.github.circles2d.world.device.memory.DeviceArrays;
import io.github.circles2d.world.device.memory.Scan;
import io.github.circles2d.world.device.memory.StageKernels;
import io.github.circles2d.world.model.GridLevels;

/** Lists the contacts on a device, in no order within a group; {@code kernels/world/stages/Neighbours.cl} and {@code ContactList.cl}. */
final class ContactsStage {
    private final DeviceArrays arrays;
    private final Scan scan;
    private final Kernel crowd;
    private final Kernel count;
    private final Kernel countByLevel;
    private final Kernel countBySheet;
    private final Kernel countByLevelAndSheet;
    private final Kernel list;

    ContactsStage(StageKernels kernels, DeviceArrays arrays, Scan scan) {
        this.arrays = arrays;
        this.scan = scan;
        crowd = kernels.staged("contacts_crowd");
        count = kernels.staged("contacts_count");
        countByLevel = kernels.staged("contacts_countByLevel");
        countBySheet = kernels.staged("contacts_countBySheet");
        countByLevelAndSheet = kernels.staged("contacts_countByLevelAndSheet");
        list = kernels.staged("contacts_list");
    }

    void list(GridLevels levels, int circles, boolean thinning) {
        if (thinning) {
            crowd.run(circles);
        }
        boolean bySheet = levels.haveSheets();
        if (levels.usedCount == 1) {
            (bySheet ? countBySheet : count).run(circles);
        } else {
            (bySheet ? countByLevelAndSheet : countByLevel).run((long) levels.usedCount * circles);
        }
        scan.run(arrays, levels.groups(circles) + 1, DeviceArray.GROUP_START);
        list.run(2L * circles);
    }
}
