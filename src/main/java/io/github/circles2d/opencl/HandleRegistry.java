package io.github.circles2d.opencl;

import com.nativelibs4java.opencl.CLContext;
import com.nativelibs4java.opencl.CLQueue;
import java.lang.System.Logger.Level;
import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;

/** Everything that a session has open. {@link #run} releases it: newest first, then the queues, then the context. */
final class HandleRegistry implements Runnable {
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
