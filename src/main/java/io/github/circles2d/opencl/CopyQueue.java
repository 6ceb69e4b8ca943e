package io.github.circles2d.opencl;

import com.nativelibs4java.opencl.CLEvent;
import com.nativelibs4java.opencl.CLException;
import com.nativelibs4java.opencl.CLQueue;

/**
 * A further in-order queue of a session: what it copies to the host runs beside what the session is given afterwards. It
 * belongs to the session's thread, and is closed with the session.
 */
public final class CopyQueue {
    private final Session session;
    private final CLQueue queue;

    CopyQueue(Session session, CLQueue queue) {
        this.session = session;
        this.queue = queue;
    }

    /**
     * Enqueues a read of a buffer's first bytes, behind all that the session has been given, and does not wait. Until {@link
     * #finish}, keep the target open and untouched, and let no kernel write to the source.
     *
     * @param source a buffer of the same session
     * @param target transfer memory of the same session; takes the bytes at its start
     * @param length number of bytes
     * @throws OpenClException if the driver refuses
     */
    @SuppressWarnings("deprecation") // Of JavaCL, for clEnqueueMarker, which it calls before OpenCL 1.2 alone.
    public void read(DeviceBuffer source, HostBuffer target, long length) {
        if (source.session() != session) {
            throw new IllegalArgumentException("the buffer belongs to another session than the queue for copies");
        }
        try {
            CLEvent given = session.queue().enqueueMarker();
            try {
                // What waits for another queue may wait for ever unless that one has been flushed.
                session.flush();
                source.readBehind(given, queue, target, length);
                queue.flush();
            } finally {
                given.release();
            }
        } catch (CLException e) {
            throw session.failed("copy beside the kernels", e);
        }
    }

    /**
     * Waits until all reads have ended.
     *
     * @throws OpenClException if one of them failed
     */
    public void finish() {
        session.requireOpen();
        try {
            queue.finish();
        } catch (CLException e) {
            throw session.failed("finish copying", e);
        }
    }
}
