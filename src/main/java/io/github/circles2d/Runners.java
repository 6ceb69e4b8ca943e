package io.github.circles2d;

import io.github.circles2d.calibration.Timings.Runner;
import io.github.circles2d.opencl.Device;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;

/** What identifies a device in a calibration, and the versions of all that its speed depends on. */
final class Runners {
    private Runners() {}

    /** A device that Circles2D runs on, with one indexing. */
    static Runner circles2d(Device device, PairIndexing indexing) {
        return new Runner(
                name(device),
                "driver " + device.driverVersion() + ", " + device.openClVersion() + ", kernels "
                        + Circles2D.kernels(indexing, device) + ", circles2d " + library());
    }

    /** The same for two devices that are alike. */
    static String name(Device device) {
        return device.name() + ", " + device.computeUnits() + " compute units, " + device.platform();
    }

    /** The version of this library, which the build has put into a file. */
    private static String library() {
        try (InputStream in = Runners.class.getResourceAsStream("version.txt")) {
            return in == null ? "of no version" : new String(in.readAllBytes(), StandardCharsets.UTF_8);
        } catch (IOException e) {
            return "of no version";
        }
    }
}
