package io.github.circles2d.bench;

import io.github.circles2d.opencl.Device;
import io.github.circles2d.opencl.OpenCl;
import io.github.circles2d.opencl.OpenClUnavailableException;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;

/** The OpenCL devices of this machine under short names, the same in every process. */
public final class Devices {
    private Devices() {}

    /** Returns every device by its name, the best one first; empty where there is none. */
    public static Map<String, Device> all() {
        List<Device> devices;
        try {
            devices = OpenCl.devices();
        } catch (OpenClUnavailableException e) {
            return Map.of();
        }
        Map<String, Device> named = new LinkedHashMap<>();
        for (Device device : devices) {
            String name = slug(device.name());
            if (device.kind() == Device.Kind.CPU) {
                name = "cpu-" + device.computeUnits();
            }
            String unique = name;
            for (int copy = 2; named.containsKey(unique); copy++) {
                unique = name + "-" + copy;
            }
            named.put(unique, device);
        }
        return named;
    }

    /**
     * Finds a device.
     *
     * @param name {@code best}, {@code cpu}, or a name out of {@link #all}
     */
    public static Device find(String name) {
        switch (name) {
            case "best":
                return OpenCl.bestDevice();
            case "cpu":
                return OpenCl.cpuDevice();
            default:
                Device device = all().get(name);
                if (device == null) {
                    throw new IllegalArgumentException("there is no device '" + name + "'; there is best, cpu, "
                            + String.join(", ", all().keySet()));
                }
                return device;
        }
    }

    /** Lower-case letters, digits and dashes: fit for a folder's name and for a JMH parameter. */
    public static String slug(String name) {
        return name.toLowerCase(Locale.ROOT)
                .replaceAll("\\((r|tm)\\)", "")
                .replaceAll("[^a-z0-9]+", "-")
                .replaceAll("^-|-$", "");
    }
}
