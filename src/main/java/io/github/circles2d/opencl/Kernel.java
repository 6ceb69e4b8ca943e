package io.github.circles2d.opencl;

import com.nativelibs4java.opencl.CLBuffer;
import com.nativelibs4java.opencl.CLDevice;
import com.nativelibs4java.opencl.CLEvent;
import com.nativelibs4java.opencl.CLException;
import com.nativelibs4java.opencl.CLKernel;
import java.util.Arrays;
import java.util.Locale;

/**
 * A kernel and its arguments. It belongs to one thread at a time: an OpenCL kernel shared by threads gives wrong results.
 *
 * <p>It holds on to the buffers that are its arguments; OpenCL does not, and a buffer that the garbage collector takes
 * while a kernel runs on it ends the process.
 */
public final class Kernel implements AutoCloseable {
    /** Many enough for a GPU to hide latency, few enough for every device. */
    private static final int WORK_GROUP_SIZE = 256;

    /** OpenCL takes a handle of zeros for no buffer. */
    private static final long NO_BUFFER = 0;

    private static final CLEvent[] WITHOUT_EVENT = {CLEvent.FIRE_AND_FORGET};
    private static final CLEvent[] WITH_EVENT = {};

    private final Session session;
    private final String name;
    private final CLKernel kernel;
    private final Handle handle;
    private final int maxWorkGroupSize;
    private int usualSize;
    private final long[] globalSize = new long[1];
    private final long[] localSize = new long[1];
    private boolean hasRun;

    /** By argument: the buffer; null of numbers. */
    private DeviceBuffer[] buffers = new DeviceBuffer[8];

    /** By argument: the bits of the number, and the bytes that it has; 0 if none has been set. Calls into the driver cost more. */
    private long[] numbers = new long[8];

    private byte[] numberBytes = new byte[8];

    Kernel(Session session, String name, CLKernel kernel) {
        this.session = session;
        this.name = name;
        this.kernel = kernel;
        CLDevice device = session.device().handle();
        long[] required = kernel.getCompileWorkGroupSize().get(device);
        boolean isRequired = required != null && required[0] > 0;
        long limit = isRequired ? limit(device, required[0]) : limit(device);
        maxWorkGroupSize = (int) Math.min(limit, session.device().maxWorkGroupSize());
        usualSize = isRequired ? maxWorkGroupSize : Math.min(WORK_GROUP_SIZE, maxWorkGroupSize);
        handle = new Handle(kernel::release);
        session.own(handle);
    }

    private long limit(CLDevice device) {
        Long limit = kernel.getWorkGroupSize().get(device);
        return limit == null ? WORK_GROUP_SIZE : limit;
    }

    /** NVIDIA's driver tells of 256 even where a kernel requires more, and runs it. */
    private long limit(CLDevice device, long required) {
        boolean understates = session.device().vendor().toUpperCase(Locale.ROOT).contains("NVIDIA");
        return understates ? required : Math.min(required, limit(device));
    }

    /** {@return the name of the kernel function} */
    public String name() {
        return name;
    }

    /**
     * {@return the greatest work-group that this kernel can run in on this device, at least 1 work-item} If its text
     * requires a size, it is no more than that.
     */
    public int maxWorkGroupSize() {
        return maxWorkGroupSize;
    }

    /**
     * Sets a buffer argument.
     *
     * @param index position in the kernel's argument list, from 0
     * @param buffer a buffer of the same session
     * @return this kernel
     */
    public Kernel arg(int index, DeviceBuffer buffer) {
        if (buffer.session() != session) {
            throw new IllegalArgumentException("argument " + index + " of " + name + " belongs to another session");
        }
        CLBuffer<Byte> memory = buffer.buffer();
        if (index >= 0 && index < buffers.length && buffers[index] == buffer) {
            return this;
        }
        try {
            kernel.setArg(index, memory);
        } catch (CLException e) {
            throw failedArgument(index, e);
        }
        ensureArguments(index);
        buffers[index] = buffer;
        numberBytes[index] = 0;
        return this;
    }

    /**
     * Sets no buffer as a buffer argument, of which the kernel must then read and write nothing.
     *
     * @param index position in the kernel's argument list, from 0
     * @return this kernel
     */
    public Kernel withoutBuffer(int index) {
        return arg(index, NO_BUFFER);
    }

    private void ensureArguments(int index) {
        if (index >= buffers.length) {
            int longer = Math.max(index + 1, 2 * buffers.length);
            buffers = Arrays.copyOf(buffers, longer);
            numbers = Arrays.copyOf(numbers, longer);
            numberBytes = Arrays.copyOf(numberBytes, longer);
        }
    }

    /** Sets the bits of a number, unless they are set. */
    private Kernel number(int index, long bits, int bytes) {
        if (index >= 0 && index < buffers.length && numberBytes[index] == bytes && numbers[index] == bits) {
            return this;
        }
        try {
            if (bytes == Integer.BYTES) {
                kernel.setArg(index, (int) bits);
            } else {
                kernel.setArg(index, bits);
            }
        } catch (CLException e) {
            throw failedArgument(index, e);
        }
        ensureArguments(index);
        buffers[index] = null;
        numbers[index] = bits;
        numberBytes[index] = (byte) bytes;
        return this;
    }

    /**
     * Sets an {@code int} or {@code uint} argument.
     *
     * @param index position in the kernel's argument list, from 0
     * @param value its value
     * @return this kernel
     */
    public Kernel arg(int index, int value) {
        return number(index, value, Integer.BYTES);
    }

    /**
     * Sets a {@code long} or {@code ulong} argument.
     *
     * @param index position in the kernel's argument list, from 0
     * @param value its value
     * @return this kernel
     */
    public Kernel arg(int index, long value) {
        return number(index, value, Long.BYTES);
    }

    /**
     * Sets a {@code float} argument.
     *
     * @param index position in the kernel's argument list, from 0
     * @param value its value
     * @return this kernel
     */
    public Kernel arg(int index, float value) {
        return number(index, Float.floatToRawIntBits(value), Float.BYTES); // a driver takes bits
    }

    /**
     * Enqueues the kernel in work-groups of a size that suits the device. The number of work-items is rounded up to
     * whole work-groups, so the kernel must guard by its own count.
     *
     * @param workItems how many work-items are needed; none are run for 0
     */
    public void run(long workItems) {
        run(workItems, usualSize);
    }

    /**
     * Sets the size of the work-groups of {@link #run(long)}.
     *
     * @param size work-items a work-group, from 1 to {@link #maxWorkGroupSize}
     * @return this
     */
    public Kernel workGroupSize(int size) {
        checkSize(size);
        usualSize = size;
        return this;
    }

    private void checkSize(int workGroupSize) {
        if (workGroupSize < 1 || workGroupSize > maxWorkGroupSize) {
            throw new IllegalArgumentException("kernel " + name + " runs in work-groups of 1 to " + maxWorkGroupSize
                    + " work-items on " + session.device().name() + ", not " + workGroupSize);
        }
    }

    /**
     * Enqueues the kernel in work-groups of a given size.
     *
     * @param workItems how many work-items are needed, rounded up to whole work-groups; none are run for 0
     * @param workGroupSize work-items a work-group, from 1 to {@link #maxWorkGroupSize}
     */
    public void run(long workItems, int workGroupSize) {
        if (handle.isReleased()) {
            throw new IllegalStateException("kernel " + name + " is closed");
        }
        if (workItems < 0) {
            throw new IllegalArgumentException("the number of work-items must not be negative: " + workItems);
        }
        checkSize(workGroupSize);
        if (workItems == 0) {
            return;
        }
        globalSize[0] = (workItems + workGroupSize - 1) / workGroupSize * workGroupSize;
        localSize[0] = workGroupSize;
        Profile profile = session.profile();
        try {
            CLEvent event = hasRun ? enqueue() : DriverCalls.make(session.device(), this::enqueueFirst);
            if (profile != null) {
                profile.add(name, event);
            }
        } catch (CLException e) {
            throw session.failed("run kernel " + name + " on " + workItems + " work-items", e);
        }
    }

    private CLEvent enqueue() {
        return kernel.enqueueNDRange(
                session.queue(), null, globalSize, localSize, session.profile() == null ? WITHOUT_EVENT : WITH_EVENT);
    }

    /** A driver may compile once more when a kernel first runs, on threads of its own, so this waits until it has run. */
    private CLEvent enqueueFirst() {
        CLEvent event = enqueue();
        session.queue().finish();
        hasRun = true;
        return event;
    }

    /** Releases the kernel. Later calls do nothing. */
    @Override
    public void close() {
        session.release(handle, 0);
        Arrays.fill(buffers, null);
    }

    private OpenClException failedArgument(int index, CLException cause) {
        return session.failed("set argument " + index + " of kernel " + name, cause);
    }
}
