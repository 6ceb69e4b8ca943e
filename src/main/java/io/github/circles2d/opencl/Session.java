package io.github.circles2d.opencl;

import com.nativelibs4java.opencl.CLBuffer;
import com.nativelibs4java.opencl.CLBuildException;
import com.nativelibs4java.opencl.CLContext;
import com.nativelibs4java.opencl.CLException;
import com.nativelibs4java.opencl.CLMem;
import com.nativelibs4java.opencl.CLProgram;
import com.nativelibs4java.opencl.CLQueue;
import java.lang.System.Logger.Level;
import java.lang.ref.Cleaner;
import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import java.util.function.Consumer;

/**
 * One context and one in-order queue on one device, and everything made from them; further queues for copies alone.
 *
 * <p>Commands run in the order in which they were given. A session and what it made belong to one thread at a time.
 * {@link #close} closes all of it in the right order, and may be called again; a session that becomes unreachable
 * without being closed is closed by the garbage collector, late.
 */
public final class Session implements AutoCloseable {
    private static final Cleaner CLEANER = Cleaner.create();

    /** Transfers through the heap go in pieces of this size. */
    private static final int STAGING_BYTES = 4 << 20;

    private final Device device;
    private final CLContext context;
    private final CLQueue queue;
    private final HandleRegistry registry;
    private final Cleaner.Cleanable cleanable;
    private final Profile profile;
    private Consumer<Throwable> watcher = failure -> {};
    private HostBuffer staging;
    private long allocatedBytes;
    private volatile boolean closed;

    private Session(Device device, CLContext context, CLQueue queue, boolean profiling) {
        this.device = device;
        this.context = context;
        this.queue = queue;
        profile = profiling ? new Profile() : null;
        registry = new HandleRegistry(context, queue);
        if (profile != null) {
            registry.add(new Handle(profile::release));
        }
        cleanable = CLEANER.register(this, registry);
    }

    /**
     * Opens a session.
     *
     * @param device the device to work on
     * @return the session
     * @throws OpenClException if the driver refuses
     */
    public static Session open(Device device) {
        return open(device, false);
    }

    /**
     * Opens a session.
     *
     * @param device the device to work on
     * @param profiling whether to measure the device time of every kernel; costs an event a kernel
     * @return the session
     * @throws OpenClException if the driver refuses
     */
    public static Session open(Device device, boolean profiling) {
        Objects.requireNonNull(device, "device");
        try {
            return DriverCalls.make(device, () -> {
                CLContext context = device.handle().getPlatform().createContext(null, device.handle());
                CLQueue queue = profiling
                        ? device.handle().createProfilingQueue(context)
                        : device.handle().createQueue(context);
                return new Session(device, context, queue, profiling);
            });
        } catch (CLException e) {
            throw ErrorCodes.failed("open a session", device, e);
        }
    }

    /** {@return the device given to {@link #open}} */
    public Device device() {
        return device;
    }

    /** {@return how many bytes of device memory the open buffers take} */
    public long allocatedBytes() {
        return allocatedBytes;
    }

    /**
     * {@return how many bytes this session may still allocate, never negative: the device's memory less what is
     * allocated here} Other programs on the device are not seen.
     */
    public long freeBytes() {
        return Math.max(0, device.memoryBytes() - allocatedBytes);
    }

    /**
     * Checks a set of buffers before the first of them is allocated. Drivers do not all do this: some hand out memory
     * that is not there, and the process ends at its first use.
     *
     * @param what what the buffers are for, for the message
     * @param totalBytes bytes of all buffers together
     * @param largestBufferBytes bytes of the largest one
     * @throws DeviceMemoryException if they do not fit
     */
    public void requireRoom(String what, long totalBytes, long largestBufferBytes) {
        if (totalBytes > freeBytes()) {
            throw new DeviceMemoryException(
                    what + " needs " + totalBytes + " bytes; " + device.name() + " has " + freeBytes() + " left of "
                            + device.memoryBytes(),
                    totalBytes,
                    Math.min(freeBytes(), device.maxBufferBytes()));
        }
        if (largestBufferBytes > device.maxBufferBytes()) {
            throw new DeviceMemoryException(
                    what + " needs a buffer of " + largestBufferBytes + " bytes; the largest that " + device.name()
                            + " allows is " + device.maxBufferBytes(),
                    largestBufferBytes,
                    Math.min(freeBytes(), device.maxBufferBytes()));
        }
    }

    /**
     * Allocates device memory. Its content is undefined.
     *
     * @param name what it holds, for messages
     * @param bytes its size, at least 0; of size 0 it can be an argument of a kernel, but not be read or written
     * @return the buffer
     * @throws DeviceMemoryException if it does not fit
     */
    public DeviceBuffer allocate(String name, long bytes) {
        requireOpen();
        if (bytes < 0) {
            throw new IllegalArgumentException("the size of buffer '" + name + "' must not be negative: " + bytes);
        }
        requireRoom("buffer '" + name + "'", bytes, bytes);
        try {
            // OpenCL has no empty buffers.
            CLBuffer<Byte> buffer = context.createByteBuffer(CLMem.Usage.InputOutput, Math.max(bytes, 4));
            allocatedBytes += bytes;
            return new DeviceBuffer(this, name, bytes, buffer);
        } catch (CLException | OutOfMemoryError e) {
            RuntimeException cause = e instanceof CLException ? (CLException) e : new IllegalStateException(e);
            throw failed("allocate " + bytes + " bytes for buffer '" + name + "'", cause);
        }
    }

    /**
     * Allocates memory of the host for transfers, page-locked where the driver can. Keep and reuse it.
     *
     * @param bytes its size, from 0 to 2 GiB - 4 KiB
     * @return the memory, zeroed
     */
    public HostBuffer hostBuffer(long bytes) {
        requireOpen();
        return new HostBuffer(this, bytes);
    }

    /**
     * Compiles a program.
     *
     * @param source the source; its definitions become {@code -D} options
     * @param options further compiler options, each without spaces
     * @return the program
     * @throws KernelBuildException if the compiler refuses it; the message ends with the build log
     */
    public Program build(KernelSource source, String... options) {
        requireOpen();
        CLProgram program = context.createProgram(source.text());
        NoIncludes.of(program);
        if (device.platform().equals(PoclGate.PLATFORM)) {
            // POCL keeps what it compiles by itself, kernel by kernel. To give JavaCL a binary it would compile all of
            // them first.
            program.setCached(false);
        }
        try {
            for (String option : source.buildOptions()) {
                program.addBuildOption(option);
            }
            for (String option : options) {
                program.addBuildOption(option);
            }
            RunningBuilds.make(() -> DriverCalls.make(device, program::build));
            return new Program(this, source, program);
        } catch (CLBuildException e) {
            throw new KernelBuildException(
                    "could not compile " + source + " for " + device.name() + ": " + e.getMessage(), e);
        } catch (RuntimeException e) { // JavaCL throws others if it cannot write
            throw ErrorCodes.failed("compile " + source, device, e);
        }
    }

    /**
     * Opens a further in-order queue, on which reads run beside the kernels that are enqueued after them.
     *
     * @return the queue; closed with the session
     * @throws OpenClException if the driver refuses
     */
    public CopyQueue copyQueue() {
        requireOpen();
        try {
            CLQueue further = device.handle().createQueue(context);
            registry.add(further);
            return new CopyQueue(this, further);
        } catch (CLException e) {
            throw failed("open a queue for copies", e);
        }
    }

    /**
     * Waits until the device has done everything that it was given, except what a {@link CopyQueue} copies.
     *
     * @throws OpenClException if one of the commands failed
     */
    public void finish() {
        requireOpen();
        try {
            queue.finish();
        } catch (CLException e) {
            throw failed("finish what was enqueued", e);
        }
    }

    /** Hands what was enqueued to the device without waiting for it. */
    public void flush() {
        requireOpen();
        queue.flush();
    }

    /**
     * Returns the device time by kernel, in nanoseconds, since the session was opened; waits for
     * the device.
     *
     * @return nanoseconds by name of the kernel; empty unless the session was opened for profiling
     */
    public Map<String, Long> profileNanos() {
        finish();
        return profile == null ? Map.of() : profile.nanosByKernel();
    }

    /** Leaves out of {@link #profileNanos} what has run so far; waits for the device. */
    public void forgetProfile() {
        finish();
        if (profile != null) {
            profile.forget();
        }
    }

    /**
     * Names whom it tells of commands that the device refuses or fails, after which its memory may have anything in it. A build is no command, and
     * a refused allocation changes no memory.
     *
     * @param watcher gets what is about to be thrown
     */
    public void watch(Consumer<Throwable> watcher) {
        this.watcher = watcher;
    }

    /** Tells of a command that has failed, and returns what to throw; {@code what} completes "could not ...". */
    OpenClException failed(String what, RuntimeException cause) {
        OpenClException failure = ErrorCodes.failed(what, device, cause);
        if (!(failure instanceof DeviceMemoryException)) {
            watcher.accept(failure);
        }
        return failure;
    }

    @Override
    public void close() {
        closed = true;
        cleanable.clean();
    }

    CLQueue queue() {
        requireOpen();
        return queue;
    }

    CLContext context() {
        return context;
    }

    Profile profile() {
        return profile;
    }

    /** Takes charge of an object that was made from this session. */
    void own(Handle handle) {
        registry.add(handle);
    }

    void release(Handle handle, long deviceBytes) {
        if (!handle.isReleased()) {
            allocatedBytes -= deviceBytes;
            registry.release(handle);
        }
    }

    void requireOpen() {
        if (closed) {
            throw new IllegalStateException("the session on " + device.name() + " is closed");
        }
    }

    /** Memory that transfers from and to the Java heap pass through. */
    HostBuffer staging() {
        if (staging == null) {
            staging = hostBuffer(STAGING_BYTES);
        }
        return staging;
    }

    /** Everything that a session has open. {@link #run} releases it: newest first, then the queues, then the context. */
    private static final class HandleRegistry implements Runnable {
        private static final System.Logger LOG = System.getLogger(HandleRegistry.class.getName());

        private final List<CLQueue> queues = new ArrayList<>();
        private final Handle contextHandle;
        private final Set<Handle> handles = new LinkedHashSet<>();

        HandleRegistry(CLContext context, CLQueue queue) {
            queues.add(queue);
            contextHandle = new Handle(context::release);
        }

        /** Adds a queue of the context, which is finished before anything is released. */
        synchronized void add(CLQueue queue) {
            queues.add(queue);
        }

        /** Adds a handle; one that was made while the session closed is released at once. */
        synchronized void add(Handle handle) {
            if (contextHandle.isReleased()) {
                handle.release();
            } else {
                handles.add(handle);
            }
        }

        /** Releases one handle before its time. */
        synchronized void release(Handle handle) {
            handles.remove(handle);
            handle.release();
        }

        @Override
        public synchronized void run() {
            if (contextHandle.isReleased()) {
                return;
            }
            queues.forEach(HandleRegistry::finish);
            List<Handle> newestFirst = new ArrayList<>(handles);
            Collections.reverse(newestFirst);
            newestFirst.forEach(Handle::release);
            handles.clear();
            queues.forEach(queue -> new Handle(queue::release).release());
            contextHandle.release();
        }

        private static void finish(CLQueue queue) {
            try {
                queue.finish();
            } catch (RuntimeException e) {
                LOG.log(Level.WARNING, "waiting for the device before closing failed", e);
            }
        }
    }
}
