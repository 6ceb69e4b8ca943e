package io.github.circles2d.opencl;

import com.nativelibs4java.opencl.CLException;
import com.nativelibs4java.opencl.CLProgram;
import java.util.Objects;

/** A compiled {@link KernelSource}. */
public final class Program implements AutoCloseable {
    private final Session session;
    private final KernelSource source;
    private final CLProgram program;
    private final Handle handle;

    Program(Session session, KernelSource source, CLProgram program) {
        this.session = session;
        this.source = source;
        this.program = program;
        handle = new Handle(program::release);
        session.own(handle);
    }

    /**
     * Makes one of the program's kernels. Each call makes a new one with arguments of its own.
     *
     * @param name the name of the kernel function
     * @return the kernel
     * @throws OpenClException if the program has no such kernel
     */
    public Kernel kernel(String name) {
        Objects.requireNonNull(name, "name");
        if (handle.isReleased()) {
            throw new IllegalStateException("the program of " + source + " is closed");
        }
        try {
            return new Kernel(session, name, DriverCalls.make(session.device(), () -> program.createKernel(name)));
        } catch (CLException e) {
            throw session.failed("make kernel " + name + " of " + source, e);
        }
    }

    /** Releases the program; its kernels stay usable. Later calls do nothing. */
    @Override
    public void close() {
        session.release(handle, 0);
    }
}
