package io.github.circles2d.opencl;

import com.nativelibs4java.opencl.CLDevice;
import java.util.EnumSet;
import java.util.Locale;

/** One OpenCL device, described once when it was found. Immutable; {@link OpenCl} lists them. */
public final class Device {
    /** What a device is. */
    public enum Kind {
        /** The processor that the JVM runs on. */
        CPU,
        /** A graphics processor. */
        GPU,
        /** Any other device. */
        ACCELERATOR
    }

    private final CLDevice handle;
    private final String platform;
    private final String name;
    private final String vendor;
    private final String driverVersion;
    private final String openClVersion;
    private final Kind kind;
    private final int computeUnits;
    private final int clockMegahertz;
    private final int maxWorkGroupSize;
    private final long memoryBytes;
    private final long maxBufferBytes;
    private final long localMemoryBytes;
    private final boolean correctlyRounded;

    Device(String platform, CLDevice handle) {
        this.handle = handle;
        this.platform = platform.trim();
        name = handle.getName().trim();
        vendor = handle.getVendor().trim();
        driverVersion = handle.getDriverVersion().trim();
        openClVersion = handle.getVersion().trim();
        EnumSet<CLDevice.Type> types = handle.getType();
        // A debugger such as Oclgrind claims to be everything at once; it runs on the processor.
        kind = types.contains(CLDevice.Type.CPU)
                ? Kind.CPU
                : types.contains(CLDevice.Type.GPU) ? Kind.GPU : Kind.ACCELERATOR;
        computeUnits = handle.getMaxComputeUnits();
        clockMegahertz = handle.getMaxClockFrequency();
        maxWorkGroupSize = (int) Math.min(handle.getMaxWorkGroupSize(), handle.getMaxWorkItemSizes()[0]);
        memoryBytes = handle.getGlobalMemSize();
        maxBufferBytes = handle.getMaxMemAllocSize();
        localMemoryBytes = handle.getLocalMemSize();
        correctlyRounded = handle.getSingleFPConfig().contains(CLDevice.FpConfig.CorrectlyRoundedDivideSqrt);
    }

    CLDevice handle() {
        return handle;
    }

    /** {@return the name that its driver gives the device} */
    public String name() {
        return name;
    }

    /** {@return the vendor that the driver names} */
    public String vendor() {
        return vendor;
    }

    /** {@return the name of the OpenCL platform that the device belongs to} */
    public String platform() {
        return platform;
    }

    /** {@return the version of the driver, in the driver's own text} */
    public String driverVersion() {
        return driverVersion;
    }

    /** {@return the version of OpenCL that the device speaks, for example {@code OpenCL 3.0 CUDA}} */
    public String openClVersion() {
        return openClVersion;
    }

    /** {@return what the device is} */
    public Kind kind() {
        return kind;
    }

    /** {@return the number of compute units, at least 1: cores of a CPU, multiprocessors of a GPU} */
    public int computeUnits() {
        return computeUnits;
    }

    /** {@return the greatest clock frequency in megahertz, 0 where the driver does not say} */
    public int clockMegahertz() {
        return clockMegahertz;
    }

    /** {@return the greatest number of work-items in a work-group of one dimension, at least 1} */
    public int maxWorkGroupSize() {
        return maxWorkGroupSize;
    }

    /** {@return the size of the device's memory in bytes} */
    public long memoryBytes() {
        return memoryBytes;
    }

    /** {@return the size of the largest single buffer in bytes} */
    public long maxBufferBytes() {
        return maxBufferBytes;
    }

    /** {@return the size of a work-group's local memory in bytes} */
    public long localMemoryBytes() {
        return localMemoryBytes;
    }

    /**
     * {@return whether the device can round single-precision division and square root correctly} Where it cannot,
     * results may differ from those of other devices in the last bit.
     */
    public boolean correctlyRounded() {
        return correctlyRounded;
    }

    /** {@return whether the device computes in double precision, which OpenCL then requires to round correctly} */
    public boolean doublePrecision() {
        return handle.isDoubleSupportedKHR(); // a long text of the driver's, which few ask for
    }

    /** Returns one line for people: name, kind, compute units, memory, platform and driver. */
    @Override
    public String toString() {
        return String.format(
                Locale.ROOT,
                "%s (%s, %d compute units, %.1f GiB, %s, driver %s)",
                name,
                kind,
                computeUnits,
                memoryBytes / (double) (1L << 30),
                platform,
                driverVersion);
    }
}
