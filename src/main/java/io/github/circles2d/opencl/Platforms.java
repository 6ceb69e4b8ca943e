package io.github.circles2d.opencl;

import com.nativelibs4java.opencl.CLDevice;
import com.nativelibs4java.opencl.CLEvent;
import com.nativelibs4java.opencl.CLException;
import com.nativelibs4java.opencl.CLPlatform;
import com.nativelibs4java.opencl.JavaCL;
import java.lang.System.Logger.Level;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;

/** The platforms that JavaCL finds. Apart from {@link OpenCl}, which must load where JavaCL is missing. */
final class Platforms {
    private static final System.Logger LOG = System.getLogger(OpenCl.class.getName());

    private Platforms() {}

    /**
     * Lists the devices of all platforms.
     *
     * @param names takes the names of the platforms, also of those without a device
     */
    static List<Device> devices(List<String> names) {
        List<Device> devices = new ArrayList<>();
        for (CLPlatform platform : JavaCL.listPlatforms()) {
            names.add(platform.getName());
            addDevices(platform, devices);
        }
        initialiseCallbacks();
        return devices;
    }

    /**
     * BridJ implements JavaCL's callbacks in a class loader whose parent is the context class loader of the thread that first
     * needs one: now, while that is known to be this library's own.
     */
    private static void initialiseCallbacks() {
        Objects.requireNonNull(CLEvent.FIRE_AND_FORGET, "initialises the class");
    }

    /** A platform without devices answers with an error code: it must not hide the others. */
    private static void addDevices(CLPlatform platform, List<Device> devices) {
        String name = platform.getName();
        if (OpenCl.refusal().isPresent() && name.equals(PoclGate.PLATFORM)) {
            return; // Some other part of this program has loaded it.
        }
        try {
            for (CLDevice device : platform.listDevices(CLDevice.Type.All, true)) {
                devices.add(new Device(name, device));
            }
        } catch (CLException e) {
            LOG.log(Level.DEBUG, "platform {0} has no device: {1}", name, ErrorCodes.name(e.getCode()));
        }
    }
}
