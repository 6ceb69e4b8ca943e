package io.github.circles2d.playground;

import io.github.circles2d.Backend;
import io.github.circles2d.opencl.Device;
import io.github.circles2d.opencl.OpenCl;
import io.github.circles2d.opencl.OpenClException;
import java.util.ArrayList;
import java.util.List;

/** The back ends that this machine has, to switch between. */
final class BackendSwitch {
    private final SessionLoop loop;
    private final List<Backend> available;

    BackendSwitch(SessionLoop loop) {
        this.loop = loop;
        available = find();
    }

    private static List<Backend> find() {
        List<Backend> found = new ArrayList<>(List.of(Backend.JVM));
        try {
            List<Device> devices = OpenCl.devices();
            if (devices.stream().anyMatch(device -> device.kind() == Device.Kind.CPU)) {
                found.add(Backend.OPENCL_CPU);
            }
            if (devices.stream().anyMatch(device -> device.kind() != Device.Kind.CPU)) {
                found.add(Backend.OPENCL_GPU);
            }
        } catch (OpenClException e) {
            return found; // World needs no driver
        }
        return found;
    }

    boolean has(Backend backend) {
        return available.contains(backend);
    }

    /** The world goes on there. At its first start a driver compiles for seconds: so a line comes first. */
    void to(Backend backend) {
        loop.ask(session -> session.say("switching to " + backend + " ..."));
        loop.askLater(session -> session.switchTo(backend));
    }

    /** The next one in turn. */
    void next() {
        loop.askLater(session -> {
            int now = available.indexOf(session.sandbox().stats().backend());
            session.switchTo(available.get((now + 1) % available.size()));
        });
        loop.ask(session -> session.say("switching ..."));
    }
}
