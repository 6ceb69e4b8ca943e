package io.github.circles2d.opencl;

import com.nativelibs4java.opencl.CLException;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;

/**
 * Finds the OpenCL devices of this machine. The search runs once in a JVM, and a failed one gives the same exception at
 * every call.
 *
 * <p>BridJ's native library holds on to its classes until the process ends, so a class loader in which devices were looked
 * for is never collected. If programs are loaded and unloaded in one process, load this library, JavaCL and BridJ once, in a
 * parent loader.
 */
// The JVM loads the exceptions of a class's catch clauses before the first of its methods runs. So this class, which is
// used even if the jars of JavaCL are missing, catches none of theirs.
public final class OpenCl {
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
            throw failure.again();
        }
        if (found == null) {
            try {
                found = List.copyOf(searchByOwnLoader());
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
                .orElseThrow(() -> refusal()
                        .map(OpenClUnavailableException::new)
                        .orElseGet(() -> OpenClUnavailableException.withoutDriver(
                                "no OpenCL driver for the CPU is installed; there is " + devices(), null)));
    }

    /**
     * Returns why the OpenCL driver of the CPU, POCL, is not used, though it is installed: it lacks a linker, a cache that can be
     * written, threads or address space, without which POCL ends the process. This is looked for once, on Linux, before the first
     * search for devices.
     *
     * @return what is missing, and what to do; empty if POCL is used, is not installed, or was not looked for yet
     */
    public static Optional<String> refusal() {
        return PoclGate.refusal();
    }

    /**
     * BridJ looks in the thread's context class loader for the classes that it is to implement. In an application server, or
     * with plug-ins, that loader may not know them.
     */
    private static List<Device> searchByOwnLoader() {
        Thread thread = Thread.currentThread();
        ClassLoader context = thread.getContextClassLoader();
        thread.setContextClassLoader(OpenCl.class.getClassLoader());
        try {
            return search();
        } finally {
            thread.setContextClassLoader(context);
        }
    }

    private static List<Device> search() {
        NativeAccess.prepare();
        CompilerFolder compilerFolder = CompilerFolder.find();
        List<String> platforms = new ArrayList<>();
        List<Device> devices;
        try {
            devices = DriverCalls.make(() -> Platforms.devices(platforms));
        } catch (LinkageError | RuntimeException e) {
            if (refusal().isPresent()) {
                throw new OpenClUnavailableException(refusal().get(), e);
            }
            Throwable root = rootOf(e);
            if (root instanceof CLException) {
                // The loader is there, but no driver is registered with it.
                String code = ErrorCodes.name(((CLException) root).getCode());
                throw OpenClUnavailableException.withoutDriver("no OpenCL driver is registered (" + code + ")", e);
            }
            throw OpenClUnavailableException.withoutDriver("no OpenCL driver could be loaded: " + root, e);
        }
        if (devices.isEmpty() && refusal().isPresent()) {
            throw new OpenClUnavailableException(refusal().get());
        }
        if (devices.isEmpty()) {
            throw withoutDevice(platforms);
        }
        compilerFolder.useInJavaCl();
        devices.sort(Comparator.comparing((Device device) -> rank(device.kind()))
                .thenComparing(device -> -(long) device.computeUnits() * Math.max(1, device.clockMegahertz())));
        return devices;
    }

    private static OpenClUnavailableException withoutDevice(List<String> platforms) {
        if (platforms.contains(PoclGate.PLATFORM)) {
            return new OpenClUnavailableException(
                    "POCL is installed, but it offers no device, as it does when it cannot"
                            + " write to its cache. Set the environment variable POCL_CACHE_DIR to a folder that exists and can"
                            + " be written.");
        }
        return OpenClUnavailableException.withoutDriver(
                "an OpenCL driver is installed, but it offers no device: " + platforms, null);
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

    private static Throwable rootOf(Throwable e) {
        Throwable root = e;
        while (root.getCause() != null && root.getCause() != root) {
            root = root.getCause();
        }
        return root;
    }
}
