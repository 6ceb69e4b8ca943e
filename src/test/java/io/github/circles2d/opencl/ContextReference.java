package io.github.circles2d.opencl;

import static org.assertj.core.api.Assertions.assertThat;

import com.nativelibs4java.opencl.CLContext;
import com.nativelibs4java.opencl.library.OpenCLLibrary;
import java.lang.reflect.Field;
import org.bridj.Pointer;

/** A reference of a test's own to the context of a session, through which it sees how many others there are. */
final class ContextReference implements AutoCloseable {
    private static final int CL_CONTEXT_REFERENCE_COUNT = 0x1080;

    private final OpenCLLibrary openCl = new OpenCLLibrary();
    private final long context;

    ContextReference(Session session) throws ReflectiveOperationException {
        // JavaCL keeps the address of an object to itself.
        Field address = CLContext.class.getSuperclass().getDeclaredField("entityPeer");
        address.setAccessible(true);
        context = address.getLong(session.context());
        assertThat(openCl.clRetainContext(context)).isZero();
    }

    /** Counts the references to the context, this one included. */
    int count() {
        Pointer<Integer> count = Pointer.allocateInt();
        assertThat(openCl.clGetContextInfo(
                        context, CL_CONTEXT_REFERENCE_COUNT, Integer.BYTES, Pointer.getPeer(count), 0))
                .isZero();
        return count.getInt();
    }

    /**
     * Counts again until there is no other reference. A driver's own threads take a moment to let go of theirs, and may
     * take seconds while it closes contexts that earlier tests have left to the garbage collector.
     */
    int countAfterAMoment() throws InterruptedException {
        int count = count();
        for (int k = 0; k < 1500 && count > 1; k++) {
            Thread.sleep(20);
            count = count();
        }
        return count;
    }

    @Override
    public void close() {
        openCl.clReleaseContext(context);
    }
}
