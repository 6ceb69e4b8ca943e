package io.github.circles2d.opencl;

import com.nativelibs4java.opencl.CLDevice;
import com.nativelibs4java.opencl.CLException;
import com.nativelibs4java.opencl.CLPlatform;
import com.nativelibs4java.opencl.JavaCL;
import java.lang.System.Logger.Level;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;

/**
 * Finds the OpenCL devices of this machine. The search runs once in a JVM, and a failed one gives the same exception at
 * every call.
 */
public final class OpenCl {
    private static final System.Logger LOG = System.getLogger(OpenCl.class.getName());

    private static List<Device> found;
    private static OpenClUnavailableException failure;

    private OpenCl() {}

    /**
     * Lists every available device: GPUs first, then other accelerators, then CPUs, within a kind the one with the most
     * compute units times clock first.
     *
     * @return at least one device, unmodifiable
     * @throws OpenClUnavailableException if there is none; the message says what is missing and what to install
     */
    public static synchronized List<Device> devices() {
        if (failure != null) {
            throw new OpenClUnavailableException(failure.getMessage(), failure);
        }
        if (found == null) {
            try {
                found = List.copyOf(search());
            } catch (OpenClUnavailableException e) {
                failure = e;
                throw e;
            }
        }
        return found;
    }

    /**
     * Returns the best device: the best GPU where there is one.
     *
     * @return the first of {@link #devices()}
     * @throws OpenClUnavailableException if there is no device
     */
    public static Device bestDevice() {
        return devices().get(0);
    }

    /**
     * Returns the best CPU device.
     *
     * @return the first CPU of {@link #devices()}
     * @throws OpenClUnavailableException if there is no device, or none that is a CPU
     */
    public static Device cpuDevice() {
        return devices().stream()
                .filter(device -> device.kind() == Device.Kind.CPU)
                .findFirst()
                .orElseThrow(() -> new OpenClUnavailableException(
                        "no OpenCL driver for the CPU is installed; there is " + devices() + ". " + Advice.INSTALL));
    }

    private static List<Device> search() {
        NativeAccess.prepare();
        List<Device> devices = new ArrayList<>();
        try {
            for (CLPlatform platform : JavaCL.listPlatforms()) {
                addDevices(platform, devices);
            }
        } catch (LinkageError | RuntimeException e) {
            Throwable root = rootOf(e);
            if (root instanceof CLException) {
                // The loader is there, but no driver is registered with it.
                String code = ErrorCodes.name(((CLException) root).getCode());
                throw new OpenClUnavailableException(
                        "no OpenCL driver is registered (" + code + "). " + Advice.INSTALL, e);
            }
            throw new OpenClUnavailableException(
                    "no OpenCL driver could be loaded: " + root + ". " + Advice.INSTALL, e);
        }
        if (devices.isEmpty()) {
            throw new OpenClUnavailableException("an OpenCL driver is installed, but it offers no device (POCL needs a"
                    + " POCL_CACHE_DIR, or a home directory, that exists and can be written). " + Advice.INSTALL);
        }
        devices.sort(Comparator.comparing((Device device) -> rank(device.kind()))
                .thenComparing(device -> -(long) device.computeUnits() * Math.max(1, device.clockMegahertz())));
        return devices;
    }

    private static int rank(Device.Kind kind) {
        switch (kind) {
            case GPU:
                return 0;
            case ACCELERATOR:
                return 1;
            default:
                return 2;
        }
    }

    /** A platform without devices answers with an error code: it must not hide the others. */
    private static void addDevices(CLPlatform platform, List<Device> devices) {
        String name = platform.getName();
        try {
            for (CLDevice device : platform.listDevices(CLDevice.Type.All, true)) {
                devices.add(new Device(name, device));
            }
        } catch (CLException e) {
            LOG.log(Level.DEBUG, "platform {0} has no device: {1}", name, ErrorCodes.name(e.getCode()));
        }
    }

    private static Throwable rootOf(Throwable e) {
        Throwable root = e;
        while (root.getCause() != null && root.getCause() != root) {
            root = root.getCause();
        }
        return root;
    }
}
