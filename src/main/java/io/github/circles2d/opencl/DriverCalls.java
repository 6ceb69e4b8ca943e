package io.github.circles2d.opencl;

import java.io.File;
import java.lang.System.Logger.Level;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.Future;
import java.util.concurrent.SynchronousQueue;
import java.util.concurrent.ThreadPoolExecutor;
import java.util.concurrent.TimeUnit;
import java.util.function.Supplier;

/**
 * Makes the calls of OpenCL that may load a driver or compile, so that they leave the signal handlers of this process alone.
 *
 * <p>The compiler in POCL (LLVM) takes over most signals when it compiles for the first time. Java stops its threads by SIGSEGV:
 * if two of them meet the compiler's handler at the same moment, the process ends without a message. On Linux such calls are
 * therefore made on threads that cannot set a handler ({@link SignalFilter}). The compiler does not notice, and does not try
 * again. If the system refuses the filter, the handlers are put back after the call, and the danger lasts for the length of the
 * first compilation.
 *
 * <p>On other systems the calls are made as they are.
 */
final class DriverCalls {
    private static final System.Logger LOG = System.getLogger(DriverCalls.class.getName());

    /** Threads end soon, so that they keep no class loader alive. */
    private static final int IDLE_SECONDS = 1;

    /** The race detector of Oclgrind works on the thread alone that has made the context; elsewhere it ends the process. */
    private static final String BOUND_TO_THREAD = "Oclgrind";

    /** Null until {@link #protectSignals}, and on other systems than Linux. */
    private static DriverCalls protectedCalls;

    private final SignalHandlers handlers;
    private final ThreadPoolExecutor threads = new ThreadPoolExecutor(
            0, Integer.MAX_VALUE, IDLE_SECONDS, TimeUnit.SECONDS, new SynchronousQueue<>(), DriverCalls::newThread);

    /** Whether a thread could not be given its filter. */
    private static volatile boolean filterRefused;

    /** Calls that have not returned. */
    private int underWay;

    private DriverCalls(SignalHandlers handlers) {
        this.handlers = handlers;
    }

    /** Protects the signal handlers from now on; before the first call of OpenCL. */
    static synchronized void protectSignals(SignalHandlers handlers) {
        protectedCalls = new DriverCalls(handlers);
    }

    /**
     * Makes a call and waits for its end, even if this thread is interrupted.
     *
     * @param call the call; what it throws is thrown here
     * @return what it returns
     */
    static <T> T make(Supplier<T> call) {
        DriverCalls calls = protectedCalls();
        return calls == null ? call.get() : calls.makeProtected(call);
    }

    /**
     * Makes a call that concerns one device.
     *
     * @param device the device
     * @param call the call; what it throws is thrown here
     * @return what it returns
     */
    static <T> T make(Device device, Supplier<T> call) {
        DriverCalls calls = protectedCalls();
        return calls != null && device.platform().equals(BOUND_TO_THREAD) ? calls.makeHere(call) : make(call);
    }

    /**
     * Whether NVIDIA's driver will load a kernel module when it is called, as it does once after the system has started. It does so
     * by a program that gets the rights of the superuser, which a thread with a filter cannot start.
     */
    private static boolean lacksKernelModule() {
        return new File("/proc/driver/nvidia").exists() && !new File("/dev/nvidia-uvm").exists();
    }

    private static synchronized DriverCalls protectedCalls() {
        return protectedCalls;
    }

    private <T> T makeProtected(Supplier<T> call) {
        if (lacksKernelModule()) {
            return makeHere(call);
        }
        begin();
        try {
            return result(threads.submit(call::get));
        } finally {
            end(filterRefused);
        }
    }

    private <T> T makeHere(Supplier<T> call) {
        begin();
        try {
            return call.get();
        } finally {
            end(true);
        }
    }

    private synchronized void begin() {
        if (underWay++ == 0) {
            handlers.save();
        }
    }

    private synchronized void end(boolean restore) {
        if (restore) {
            handlers.restore();
        }
        underWay--;
    }

    private static <T> T result(Future<T> future) {
        boolean interrupted = false;
        try {
            while (true) {
                try {
                    return future.get();
                } catch (InterruptedException e) {
                    interrupted = true;
                }
            }
        } catch (ExecutionException e) {
            if (e.getCause() instanceof Error error) {
                throw error;
            }
            throw (RuntimeException) e.getCause();
        } finally {
            if (interrupted) {
                Thread.currentThread().interrupt();
            }
        }
    }

    private static Thread newThread(Runnable work) {
        Runnable filtered = () -> {
            if (!SignalFilter.install()) {
                filterRefused = true;
                LOG.log(Level.DEBUG, "no filter of system calls: signal handlers are put back after each call instead");
            }
            work.run();
        };
        Thread thread = new Thread(null, filtered, "circles2d-OpenCL", 0, false);
        thread.setDaemon(true);
        // BridJ looks for JavaCL's classes in it.
        thread.setContextClassLoader(DriverCalls.class.getClassLoader());
        return thread;
    }
}
