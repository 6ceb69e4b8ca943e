package io.github.circles2d.world;

import io.github.circles2d.opencl.DeviceBuffer;
import io.github.circles2d.opencl.HostBuffer;
import io.github.circles2d.opencl.Kernel;
import io.github.circles2d.opencl.Session;
import java.nio.FloatBuffer;
import java.nio.IntBuffer;

/** Reads the state back in the order of ids; {@code kernels/world/Readback.cl}. */
final class ClReadback {
    private final Session session;
    private final ClBuffers buffers;
    private final Kernel circles;
    private final Kernel velocities;
    private DeviceBuffer byId;
    private HostBuffer host;

    ClReadback(Session session, ClKernels kernels, ClBuffers buffers) {
        this.session = session;
        this.buffers = buffers;
        circles = kernels.plain("readback_circles");
        velocities = kernels.plain("readback_velocities");
        byId = session.allocate("read-back", 1024);
        host = session.hostBuffer(1024);
    }

    void circles(Roster roster, int slots, float[] to) {
        ensure(16L * roster.end());
        circles.arg(0, buffers.get(ClBuffers.HOME_ID))
                .arg(1, buffers.get(ClBuffers.HOME_CIRCLE))
                .arg(2, slots)
                .arg(3, byId)
                .run(slots);
        byId.read(0, host, 0, 16L * roster.end());
        compact(roster, 4, to);
    }

    void velocities(Roster roster, int slots, float[] to) {
        ensure(8L * roster.end());
        velocities
                .arg(0, buffers.get(ClBuffers.HOME_ID))
                .arg(1, buffers.get(ClBuffers.HOME_MOTION))
                .arg(2, slots)
                .arg(3, byId)
                .run(slots);
        byId.read(0, host, 0, 8L * roster.end());
        compact(roster, 2, to);
    }

    /** Copies runs of living ids; while nothing was removed, that is one copy. */
    private void compact(Roster roster, int floats, float[] to) {
        FloatBuffer from = host.floats();
        int written = 0;
        for (int id = 0; id < roster.end(); ) {
            if (!roster.lives(id)) {
                id++;
                continue;
            }
            int first = id;
            while (id < roster.end() && roster.lives(id)) {
                id++;
            }
            int length = (id - first) * floats;
            from.get(first * floats, to, written, length);
            written += length;
        }
    }

    private void ensure(long bytes) {
        if (byId.bytes() < bytes) {
            DeviceBuffer larger = session.allocate("read-back", bytes + (bytes >> 1));
            byId.close();
            byId = larger;
        }
        if (host.size() < bytes) {
            HostBuffer larger = session.hostBuffer(Math.min(bytes + (bytes >> 1), Integer.MAX_VALUE - 4096));
            host.close();
            host = larger;
        }
    }

    /** Reads ints of a buffer; for what is needed seldom. */
    static int[] ints(DeviceBuffer buffer, int count) {
        int[] values = new int[count];
        buffer.read(IntBuffer.wrap(values));
        return values;
    }

    /** Reads floats of a buffer; for what is needed seldom. */
    static float[] floats(DeviceBuffer buffer, int count) {
        float[] values = new float[count];
        buffer.read(FloatBuffer.wrap(values));
        return values;
    }
}
