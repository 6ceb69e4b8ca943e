package io.github.circles2d.bench.measure;

import io.github.circles2d.bench.Devices;
import io.github.circles2d.opencl.Device;
import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.LocalDate;
import java.time.ZoneOffset;
import java.util.LinkedHashMap;
import java.util.Map;

/** What this machine is. */
public final class Machine {
    private Machine() {}

    /** A name for the results folder: processor, cores and graphics processors. */
    public static String name(Map<String, Device> devices) {
        StringBuilder name =
                new StringBuilder(Devices.slug(processor())).append("-").append(cores());
        devices.forEach((device, description) -> {
            if (description.kind() != Device.Kind.CPU) {
                name.append("-").append(device);
            }
        });
        return name.toString();
    }

    /** Properties for people, by name. */
    public static Map<String, String> properties(Map<String, Device> devices) {
        Map<String, String> properties = new LinkedHashMap<>();
        properties.put("date", LocalDate.now(ZoneOffset.UTC).toString());
        properties.put("processor", processor());
        properties.put("cores", Integer.toString(cores()));
        properties.put("memory GiB", memoryGiB());
        properties.put("system", System.getProperty("os.name") + " on " + System.getProperty("os.arch"));
        properties.put("java", System.getProperty("java.vm.name") + " " + System.getProperty("java.version"));
        String version = Machine.class.getPackage().getImplementationVersion();
        properties.put("circles2d", version == null ? "" : version);
        devices.forEach((name, device) -> properties.put("device " + name, device.toString()));
        return properties;
    }

    private static int cores() {
        return Runtime.getRuntime().availableProcessors();
    }

    private static String processor() {
        try {
            for (String line : Files.readAllLines(Path.of("/proc/cpuinfo"))) {
                if (line.startsWith("model name")) {
                    return line.substring(line.indexOf(':') + 1).trim();
                }
            }
        } catch (IOException e) {
            return System.getProperty("os.arch");
        }
        return System.getProperty("os.arch");
    }

    private static String memoryGiB() {
        long bytes = ((com.sun.management.OperatingSystemMXBean) ManagementFactory.getOperatingSystemMXBean())
                .getTotalMemorySize();
        return Long.toString(Math.round(bytes / (double) (1L << 30)));
    }
}
