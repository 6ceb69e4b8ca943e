package io.github.circles2d.world.device;

import io.github.circles2d.opencl.Device;
import io.github.circles2d.opencl.Kernel;
import java.util.Locale;

/**
 * Whole steps in one launch on a device; {@code kernels/world/Resident.cl}. A launch costs the host several microseconds, a
 * barrier over resident work-groups one or two; a large world has other costs, and is better off with launches.
 */
final class PersistentGpu {
    /** Worlds of more circles use a launch a pass: with several tiles a work-group the barriers cost more than launches. */
    private static final int MOST_CIRCLES = 32_000;

    /** Work-items of a work-group. */
    static final int GROUP = 256;

    private final Kernel steps;
    private final int mostGroups;

    PersistentGpu(StageKernels kernels, Device device) {
        steps = kernels.staged("resident_steps");
        // Elsewhere nothing is known of work-groups that wait for each other.
        // On a compute unit one surely runs; whether two run at once hangs on registers, and one that does not would be
        // waited for.
        mostGroups = fits(device) ? device.computeUnits() : 1;
    }

    /** Whether a device is known to run work-groups that wait for each other. */
    static boolean fits(Device device) {
        return device.vendor().toUpperCase(Locale.ROOT).contains("NVIDIA");
    }

    /** How many work-groups run at once for sure. */
    int mostGroups() {
        return mostGroups;
    }

    static boolean suits(int circles) {
        return circles <= MOST_CIRCLES;
    }

    void run(int tiles, int circles, int count) {
        int needed = Math.max(tiles, (circles + GROUP - 1) / GROUP);
        int groups = Math.min(needed, mostGroups);
        steps.arg(DeviceArrays.COUNT, count).run((long) groups * GROUP, GROUP);
    }
}
