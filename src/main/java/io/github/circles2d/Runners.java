package io.github.circles2d;

import io.github.circles2d.calibration.Runner;
import io.github.circles2d.opencl.Device;
import io.github.circles2d.world.device.DevicePipeline;
import java.io.BufferedReader;
import java.io.FileReader;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;

/** What identifies a device in a calibration, and the versions of all that its speed depends on. */
final class Runners {
    private Runners() {}

    /** The JVM with a number of threads. The processor has a name, for home folders are shared among machines. */
    static Runner jvm(int threads) {
        return new Runner(
                "JVM, " + threads + (threads == 1 ? " thread, " : " threads, ") + processor(),
                "Java " + Runtime.version() + ", " + System.getProperty("java.vm.name") + ", circles2d " + library());
    }

    /** A device that World runs on. */
    static Runner world(Device device) {
        return new Runner(name(device), version(device, DevicePipeline.kernels()));
    }

    /** A device that Circles2D runs on, with one indexing. */
    static Runner circles2d(Device device, PairIndexing indexing) {
        return new Runner(name(device), version(device, Circles2D.kernels(indexing, device)));
    }

    /** The same for two devices that are alike. */
    static String name(Device device) {
        return device.name() + ", " + device.computeUnits() + " compute units, " + device.platform();
    }

    private static String version(Device device, String kernels) {
        return "driver " + device.driverVersion() + ", " + device.openClVersion() + ", kernels " + kernels
                + ", circles2d " + library();
    }

    /** The version of this library, which the build has put into a file. */
    private static String library() {
        try (InputStream in = Runners.class.getResourceAsStream("version.txt")) {
            return in == null ? "of no version" : new String(in.readAllBytes(), StandardCharsets.UTF_8);
        } catch (IOException e) {
            return "of no version";
        }
    }

    private static String processor() {
        String windows = System.getenv("PROCESSOR_IDENTIFIER");
        if (windows != null) {
            return windows;
        }
        // Not by a channel, which an interrupt may close.
        try (BufferedReader linux = new BufferedReader(new FileReader("/proc/cpuinfo", StandardCharsets.ISO_8859_1))) {
            for (String line = linux.readLine(); line != null && !line.isEmpty(); line = linux.readLine()) {
                if (line.startsWith("model name")) {
                    return line.substring(line.indexOf(':') + 1);
                }
            }
        } catch (IOException e) {
            // Not on Linux, or /proc is hidden.
        }
        return System.getProperty("os.arch");
    }
}
