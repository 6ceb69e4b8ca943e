package io.github.circles2d.world.device.memory;

import io.github.circles2d.opencl.DeviceBuffer;
import io.github.circles2d.opencl.Session;

/** Buffers that give way to larger ones, which do not have what was in them. */
public final class GrownBuffer {
    private GrownBuffer() {}

    /**
     * Returns a buffer with room for what is needed: the one that is held, if it is large enough. Else that is given back, once there
     * is a larger one.
     *
     * @param held may be null
     * @param needed bytes
     * @param wanted bytes of a new buffer, at least those needed
     */
    public static DeviceBuffer of(Session session, String name, DeviceBuffer held, long needed, long wanted) {
        if (held != null && held.bytes() >= needed) {
            return held;
        }
        DeviceBuffer larger = session.allocate(name, wanted);
        close(held);
        return larger;
    }

    /** Gives buffers back; null is none. */
    public static void close(DeviceBuffer... buffers) {
        for (DeviceBuffer buffer : buffers) {
            if (buffer != null) {
                buffer.close();
            }
        }
    }
}
