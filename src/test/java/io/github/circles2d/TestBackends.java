package io.github.circles2d;

import io.github.circles2d.opencl.Device;
import io.github.circles2d.opencl.TestDevices;
import java.util.stream.Stream;

/** The back ends that tests run on: the JVM's, and those of the devices that there are. */
final class TestBackends {
    private TestBackends() {}

    static Backend[] all() {
        return Stream.concat(Stream.of(Backend.JVM), Stream.of(openCl())).toArray(Backend[]::new);
    }

    static Backend[] openCl() {
        return TestDevices.all().stream()
                .map(device -> device.kind() == Device.Kind.GPU ? Backend.OPENCL_GPU : Backend.OPENCL_CPU)
                .distinct()
                .toArray(Backend[]::new);
    }
}
