package io.github.circles2d.world;

import io.github.circles2d.opencl.Device;
import io.github.circles2d.opencl.Kernel;
import java.util.Locale;

/**
 * Whole steps in one launch on a device; {@code kernels/world/Resident.cl}. A launch costs the host several microseconds, a
 * barrier over resident work-groups one or two; a large world has other costs, and is better off with launches.
 */
final class ClResident {
    /** Worlds of more circles use a launch a pass. */
    private static final int MOST_CIRCLES = 80_000;

    /** Work-items of a work-group. */
    static final int GROUP = 256;

    /** Work-groups that surely run at once on a compute unit. */
    private static final int GROUPS_A_UNIT = 2;

    private final Kernel tiled;
    private final Kernel coloured;
    private final int mostGroups;

    ClResident(ClKernels kernels, Device device) {
        tiled = kernels.staged("resident_tiles");
        coloured = kernels.staged("resident_colours");
        mostGroups = mostGroups(device);
    }

    /** Whether a device is known to run work-groups that wait for each other. */
    static boolean fits(Device device) {
        return device.vendor().toUpperCase(Locale.ROOT).contains("NVIDIA");
    }

    /** How many work-groups run at once for sure. */
    static int mostGroups(Device device) {
        return GROUPS_A_UNIT * device.computeUnits();
    }

    static boolean suits(int circles) {
        return circles <= MOST_CIRCLES;
    }

    /** Makes steps by tiles. */
    void runTiles(int tiles, int circles, int steps) {
        run(tiled, Math.max(tiles, groups(circles)), steps);
    }

    /** Makes steps colour by colour. */
    void runColours(int circles, int steps) {
        run(coloured, groups(circles), steps);
    }

    private static int groups(int circles) {
        return (circles + GROUP - 1) / GROUP;
    }

    private void run(Kernel kernel, int groups, int steps) {
        kernel.arg(ClBuffers.COUNT, steps).run((long) Math.min(groups, mostGroups) * GROUP, GROUP);
    }
}
