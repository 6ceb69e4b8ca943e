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
    private final List<Backend> available = new ArrayList<>(List.of(Backend.JVM));

    /** Why a back end is missing; none if the device is. */
    private String failure = "";

    BackendSwitch(SessionLoop loop) {
        this.loop = loop;
        find();
        available.add(Backend.AUTO);
    }

    private void find() {
        try {
            List<Device> devices = OpenCl.devices();
            if (devices.stream().anyMatch(device -> device.kind() == Device.Kind.CPU)) {
                available.add(Backend.OPENCL_CPU);
            }
            if (devices.stream().anyMatch(device -> device.kind() != Device.Kind.CPU)) {
                available.add(Backend.OPENCL_GPU);
            }
            OpenCl.refusal().ifPresent(why -> failure = why);
        } catch (OpenClException e) { // World needs no driver
            failure = e.getMessage();
        }
    }

    /** Why a back end cannot be chosen, in a few words; empty if it can. */
    String lack(Backend backend) {
        if (has(backend)) {
            return "";
        }
        return backend == Backend.OPENCL_GPU ? "no GPU with an OpenCL driver" : "no OpenCL driver for the processor";
    }

    /** What the search for devices has said; empty if nothing. */
    String failure() {
        return failure;
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
            int now = available.indexOf(session.sandbox().asked());
            session.switchTo(available.get((now + 1) % available.size()));
        });
        loop.ask(session -> session.say("switching ..."));
    }
}
