package io.github.circles2d.opencl;

import com.nativelibs4java.opencl.CLContext;
import com.nativelibs4java.opencl.CLQueue;
import java.lang.System.Logger.Level;
import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;

/** Everything that a session has open. {@link #run} releases it: newest first, then the queue, then the context. */
final class HandleRegistry implements Runnable {
    private static final System.Logger LOG = System.getLogger(HandleRegistry.class.getName());

    private final CLQueue queue;
    private final Handle queueHandle;
    private final Handle contextHandle;
    private final Set<Handle> handles = new LinkedHashSet<>();

    HandleRegistry(CLContext context, CLQueue queue) {
        this.queue = queue;
        queueHandle = new Handle(queue::release);
        contextHandle = new Handle(context::release);
    }

    synchronized void add(Handle handle) {
        handles.add(handle);
    }

    /** Releases one handle before its time. */
    synchronized void release(Handle handle) {
        handles.remove(handle);
        handle.release();
    }

    @Override
    public synchronized void run() {
        if (queueHandle.isReleased()) {
            return;
        }
        try {
            queue.finish();
        } catch (RuntimeException e) {
            LOG.log(Level.WARNING, "waiting for the device before closing failed", e);
        }
        List<Handle> newestFirst = new ArrayList<>(handles);
        Collections.reverse(newestFirst);
        newestFirst.forEach(Handle::release);
        handles.clear();
        queueHandle.release();
        contextHandle.release();
    }
}
