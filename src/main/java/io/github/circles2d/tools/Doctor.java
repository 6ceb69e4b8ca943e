package io.github.circles2d.tools;

import io.github.circles2d.opencl.Device;
import io.github.circles2d.opencl.OpenCl;
import io.github.circles2d.opencl.OpenClUnavailableException;
import java.io.PrintStream;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.stream.Collectors;

/**
 * Says whether OpenCL works on this machine: lists platforms and devices, compiles and runs a tiny kernel on each and
 * checks its result, and says what is missing and how to install it.
 *
 * <p>Exit status: 0 if at least one device works, 1 if none does, 2 for a wrong call.
 */
public final class Doctor {
    private static final double GIB = 1L << 30;

    private final PrintStream out;

    private Doctor(PrintStream out) {
        this.out = out;
    }

    /**
     * Examines this machine.
     *
     * @param args none
     */
    public static void main(String[] args) {
        System.exit(run(System.out, args));
    }

    /**
     * Examines this machine.
     *
     * @param out where the findings go
     * @param args none
     * @return the exit status
     */
    static int run(PrintStream out, String... args) {
        if (args.length > 0) {
            boolean help = args[0].equals("--help") || args[0].equals("-h");
            out.println("usage: doctor (no arguments): lists the OpenCL devices, tries each, says what is missing");
            return help ? 0 : 2;
        }
        return new Doctor(out).examine();
    }

    private int examine() {
        out.printf("Java     %s (%s)%n", System.getProperty("java.version"), System.getProperty("java.vendor"));
        out.printf(
                "System   %s %s, %s%n",
                System.getProperty("os.name"), System.getProperty("os.version"), System.getProperty("os.arch"));
        List<Device> devices;
        try {
            devices = OpenCl.devices();
        } catch (OpenClUnavailableException e) {
            out.printf("OpenCL   does not work: %s%n", e.getMessage());
            if (e.isDriverMissing()) {
                prescribe(Prescription.forThisMachine().forMissingDriver());
            }
            return 1;
        }
        int working = examineAll(devices);
        OpenCl.refusal().ifPresent(why -> out.printf("%nPlatform Portable Computing Language%n  not used: %s%n", why));
        out.println();
        out.printf("Working devices: %d of %d%n", working, devices.size());
        if (working < devices.size()) {
            prescribe(Prescription.forThisMachine().forFailingDevice());
        }
        return working == 0 ? 1 : 0;
    }

    private int examineAll(List<Device> devices) {
        Map<String, List<Device>> byPlatform = devices.stream()
                .collect(Collectors.groupingBy(Device::platform, LinkedHashMap::new, Collectors.toList()));
        int working = 0;
        for (Map.Entry<String, List<Device>> platform : byPlatform.entrySet()) {
            out.printf("%nPlatform %s%n", platform.getKey());
            for (Device device : platform.getValue()) {
                DeviceCheck check = DeviceCheck.of(device);
                working += check.works() ? 1 : 0;
                describe(device, check);
            }
        }
        return working;
    }

    private void describe(Device device, DeviceCheck check) {
        out.printf("  %-11s %s, by %s%n", device.kind(), device.name(), device.vendor());
        out.printf("    %s, driver %s%n", device.openClVersion(), device.driverVersion());
        out.printf(
                Locale.ROOT,
                "    %d compute units, work-groups of up to %d work-items%n",
                device.computeUnits(),
                device.maxWorkGroupSize());
        out.printf(
                Locale.ROOT,
                "    %.1f GiB of memory, buffers of up to %.1f GiB, %d KiB of local memory%n",
                device.memoryBytes() / GIB,
                device.maxBufferBytes() / GIB,
                device.localMemoryBytes() / 1024);
        out.printf(
                "    divides and takes roots %s%n",
                device.correctlyRounded() ? "correctly rounded" : "without promising correct rounding");
        out.printf("    %s%n", check.finding());
    }

    private void prescribe(List<String> lines) {
        if (lines.isEmpty()) {
            return; // the failure above names the cure
        }
        out.println();
        out.println("What to do:");
        lines.forEach(line -> out.println("  " + line));
    }
}
