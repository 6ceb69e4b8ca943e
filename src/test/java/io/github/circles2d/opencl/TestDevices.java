package io.github.circles2d.opencl;

import java.util.List;
import java.util.stream.Collectors;
import org.opentest4j.TestAbortedException;

/** The devices that tests run on: all there are, or those whose name contains {@code -Dcircles2d.device}. */
public final class TestDevices {
    static {
        // Else the first steps of a test would go by the plan whose kernels come first, on some devices.
        System.setProperty("circles2d.plans.wait", "true");
    }

    private TestDevices() {}

    /** Returns at least one device. Without any the test fails where one is required, and is skipped elsewhere. */
    public static List<Device> all() {
        String wanted = System.getProperty("circles2d.device", "");
        List<Device> devices;
        try {
            devices = OpenCl.devices().stream()
                    .filter(device -> device.toString().contains(wanted))
                    .collect(Collectors.toList());
        } catch (OpenClUnavailableException e) {
            if (required()) {
                throw e;
            }
            throw new TestAbortedException(e.getMessage());
        }
        if (devices.isEmpty()) {
            throw new IllegalStateException("no device's description contains '" + wanted + "': " + OpenCl.devices());
        }
        return devices;
    }

    /** Tells whether the lack of a device, or of a tool that the tests need, is a failure. */
    public static boolean required() {
        return Boolean.getBoolean("circles2d.device.required");
    }
}
