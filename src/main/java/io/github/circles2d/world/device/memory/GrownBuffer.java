package io.github.circles2d.world.device.memory;

import io.github.circles2d.opencl.DeviceBuffer;
import io.github.circles2d.opencl.Session;

/** Buffers that give way to larger ones, which do not have what was in them. */
public final class GrownBuffer {
    private GrownBuffer() {}

    /** The buffer that is held, or null, if it has the bytes needed; else a larger one, and then the other is given back. */
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
