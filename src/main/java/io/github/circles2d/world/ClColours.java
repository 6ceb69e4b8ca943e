package io.github.circles2d.world;

import io.github.circles2d.opencl.Kernel;

/** Runs a kernel that works on groups of contacts: level by level, colour by colour, a work-item a group. */
final class ClColours {
    private ClColours() {}

    /** The kernel's arguments behind the shared ones are the first group of the colour and the number of its groups. */
    static void run(Levels levels, Kernel kernel) {
        for (int l = 0; l < levels.usedCount; l++) {
            int level = levels.used[l];
            for (int colour = 0; colour < 4; colour++) {
                int first = levels.firstOfColour(level, colour);
                int groups = levels.firstOfColour(level, colour + 1) - first;
                kernel.arg(ClBuffers.COUNT, first)
                        .arg(ClBuffers.COUNT + 1, groups)
                        .run(groups);
            }
        }
    }
}
