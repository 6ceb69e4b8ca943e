package io.github.circles2d.opencl;

import java.lang.System.Logger.Level;

/**
 * Owns one OpenCL object and releases it once; JavaCL throws at a second release. It knows nothing of the session, so
 * that an abandoned session can be found unreachable and cleaned up through its handles.
 */
final class Handle {
    private static final System.Logger LOG = System.getLogger(Handle.class.getName());

    private Runnable release;

    /** Takes what releases the object, and with it everything that must stay alive until then. */
    Handle(Runnable release) {
        this.release = release;
    }

    synchronized boolean isReleased() {
        return release == null;
    }

    /** Releases the object; later calls do nothing. */
    synchronized void release() {
        if (release == null) {
            return;
        }
        try {
            release.run();
        } catch (RuntimeException e) {
            // The object is gone either way, and closing must go on with the others.
            LOG.log(Level.WARNING, "releasing an OpenCL object failed", e);
        } finally {
            release = null;
        }
    }
}
