package io.github.circles2d.world.device;

import io.github.circles2d.opencl.Kernel;
import io.github.circles2d.world.model.GridLevels;

/** Runs a kernel that works on groups of contacts: level by level, colour by colour, a work-item a group. */
final class Colours {
    private Colours() {}

    /** The kernel's arguments behind the shared ones are the level and the colour. */
    static void run(GridLevels levels, Kernel kernel) {
        for (int l = 0; l < levels.usedCount; l++) {
            int level = levels.used[l];
            int groups = levels.firstOfColour(level, 1) - levels.firstOfColour(level, 0);
            for (int colour = 0; colour < 4; colour++) {
                kernel.arg(DeviceArrays.COUNT, level)
                        .arg(DeviceArrays.COUNT + 1, colour)
                        .run(groups);
            }
        }
    }
}
