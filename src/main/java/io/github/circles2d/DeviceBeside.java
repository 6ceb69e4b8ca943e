package io.github.circles2d;

import io.github.circles2d.opencl.RunningBuilds;
import io.github.circles2d.world.model.Readiness;
import io.github.circles2d.world.shared.Pipeline;
import java.util.HashSet;
import java.util.Set;
import java.util.function.IntFunction;

/**
 * Opens a device for a world, and compiles kernels for it, on a thread beside the world's. The thread ends when it has done what it was asked for, and
 * keeps no JVM alive; an exit waits for the program that is being compiled, and not for the next.
 */
final class DeviceBeside {
    /** Opens a pipeline with room for so many circles, or throws why there is none. */
    private final IntFunction<Pipeline> opens;

    /** What the device was ready for when it was asked last: to ask in each step would be garbage. */
    private Readiness last;

    /** Null until it is open. Belongs to the thread beside while that is at work. */
    private Pipeline device;

    private Thread thread;
    private boolean closed;

    /** What a compiler has refused. */
    private final Set<Readiness> refused = new HashSet<>();

    /** Why a compiler has refused the last of them, if nobody has asked yet; else null. */
    private Throwable refusal;

    /** Why there is no device, and never will be; null if there may be one. */
    private Throwable failure;

    DeviceBeside(IntFunction<Pipeline> opens) {
        this.opens = opens;
    }

    /** The pipeline, if it is ready; else null. */
    synchronized Pipeline ready(Readiness wanted) {
        if (thread != null || device == null) {
            return null;
        }
        if (wanted != last && device.isReady(wanted)) {
            last = wanted;
        }
        return wanted == last ? device : null;
    }

    /** Begins to open it, unless that goes on or is of no use. */
    void open(int circles) {
        prepare(null, circles);
    }

    /** Begins to make it ready, likewise; null opens it alone. */
    synchronized void prepare(Readiness wanted, int circles) {
        if (thread == null && failure == null && !closed && !refused.contains(wanted)) {
            last = null;
            thread = new Thread(() -> work(wanted, circles), "circles2d beside");
            thread.setDaemon(true);
            thread.start();
        }
    }

    /** Why there is no device; null if there is one, or may be. */
    synchronized Throwable failure() {
        return failure;
    }

    /** Why a compiler has refused kernels, once; else null. */
    synchronized Throwable takeRefusal() {
        Throwable taken = refusal;
        refusal = null;
        return taken;
    }

    private void work(Readiness wanted, int circles) {
        Throwable thrown = null;
        try {
            if (device == null) {
                RunningBuilds.make(() -> take(opens.apply(circles)));
            }
            if (wanted != null && !isClosed()) {
                device.compile(wanted);
            }
        } catch (RuntimeException | Error e) {
            thrown = e;
        }
        end(wanted, thrown);
    }

    private synchronized void take(Pipeline opened) {
        device = opened;
    }

    private synchronized boolean isClosed() {
        return closed;
    }

    private synchronized void end(Readiness wanted, Throwable thrown) {
        thread = null;
        if (device == null) {
            failure = thrown;
        } else if (thrown != null) {
            refused.add(wanted);
            refusal = thrown;
        }
        if (closed) {
            closeDevice();
        }
    }

    /** Frees the device, which may be opened again. */
    synchronized void free() {
        if (thread == null) {
            closeDevice();
        }
    }

    /** Closes the device: at once, or behind what the thread is at. */
    synchronized void close() {
        closed = true;
        if (thread == null) {
            closeDevice();
        }
    }

    private void closeDevice() {
        Pipeline open = device;
        device = null;
        last = null;
        if (open != null) {
            open.close();
        }
    }
}
