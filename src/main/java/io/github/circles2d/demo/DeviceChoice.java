package io.github.circles2d.demo;

import io.github.circles2d.opencl.Device;
import io.github.circles2d.opencl.OpenCl;
import java.util.List;
import java.util.Locale;
import java.util.function.Predicate;

/** Finds the device that the command line asks for. */
final class DeviceChoice {
    private DeviceChoice() {}

    /**
     * @param wanted "best", "gpu", "cpu", a number in {@link OpenCl#devices} from 0, or a part of a device's
     *     description
     * @throws EngineException if no device is called that; the message lists those that there are
     */
    static Device find(String wanted) throws EngineException {
        String name = wanted.toLowerCase(Locale.ROOT);
        switch (name) {
            case "best":
                return OpenCl.bestDevice();
            case "cpu":
                return OpenCl.cpuDevice();
            case "gpu":
                return first(device -> device.kind() == Device.Kind.GPU, "no GPU");
            default:
                return name.matches("\\d{1,9}")
                        ? numbered(Integer.parseInt(name))
                        : first(
                                device -> device.toString()
                                        .toLowerCase(Locale.ROOT)
                                        .contains(name),
                                "no device called '" + wanted + "'");
        }
    }

    private static Device numbered(int number) throws EngineException {
        List<Device> devices = OpenCl.devices();
        if (number >= devices.size()) {
            throw missing("no device " + number);
        }
        return devices.get(number);
    }

    private static Device first(Predicate<Device> wanted, String otherwise) throws EngineException {
        return OpenCl.devices().stream().filter(wanted).findFirst().orElseThrow(() -> missing(otherwise));
    }

    private static EngineException missing(String what) {
        StringBuilder message = new StringBuilder("there is " + what + "; the devices are");
        List<Device> devices = OpenCl.devices();
        for (int k = 0; k < devices.size(); k++) {
            message.append(String.format("%n  %d: %s", k, devices.get(k)));
        }
        return new EngineException(message.toString(), null);
    }
}
