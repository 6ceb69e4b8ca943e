package io.github.circles2d.world.device.plan;

import io.github.circles2d.opencl.Device;
import java.util.Locale;

/** Work-groups that wait for each other within a launch; {@code kernels/world/shared/DeviceBarrier.cl}. */
public final class ResidentGroups {
    private ResidentGroups() {}

    /** Whether a device is known to run work-groups that wait for each other. */
    public static boolean fit(Device device) {
        return device.vendor().toUpperCase(Locale.ROOT).contains("NVIDIA");
    }

    /** Work-groups that surely run at once, or 1: that a unit runs two depends on registers, and one that does not run is waited for. */
    static int most(Device device) {
        return fit(device) ? device.computeUnits() : 1;
    }
}
