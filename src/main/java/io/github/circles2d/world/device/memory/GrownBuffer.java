package io.github.circles2d.world.device.memory;

import io.github.circles2d.opencl.DeviceBuffer;
import io.github.circles2d.opencl.HostBuffer;
import io.github.circles2d.opencl.Session;

/** Memory of a device that gives way to larger one, which does not have what was in it. There is none before the first use. */
public final class GrownBuffer implements AutoCloseable {
    private static final long LEAST_BYTES = 1024;

    /** What {@link #ensureRoomy} takes bytes by: those of the largest vector that is common. */
    private static final long WHOLE = 16;

    private final Session session;
    private final String name;
    private DeviceBuffer buffer;

    public GrownBuffer(Session session, String name) {
        this.session = session;
        this.name = name;
    }

    /** Has so many bytes. */
    public DeviceBuffer ensure(long bytes) {
        return ensure(bytes, bytes);
    }

    /** Has so many bytes, and if it grows, room for half as many more. */
    public DeviceBuffer ensureRoomy(long bytes) {
        return ensure(bytes, Math.max(LEAST_BYTES, roomier(bytes) & -WHOLE));
    }

    private DeviceBuffer ensure(long needed, long wanted) {
        if (!has(needed)) {
            DeviceBuffer larger = session.allocate(name, wanted);
            close();
            buffer = larger;
        }
        return buffer;
    }

    /** Whether it has so many bytes. */
    public boolean has(long bytes) {
        return buffer != null && buffer.bytes() >= bytes;
    }

    /** Null if there is none yet. */
    public DeviceBuffer get() {
        return buffer;
    }

    @Override
    public void close() {
        if (buffer != null) {
            buffer.close();
        }
    }

    private static long roomier(long bytes) {
        return bytes + (bytes >> 1);
    }

    /** The same of transfer memory of the host. */
    public static final class OnHost implements AutoCloseable {
        private static final long MOST_BYTES = Integer.MAX_VALUE - 4096;

        private final Session session;
        private HostBuffer buffer;

        public OnHost(Session session) {
            this.session = session;
        }

        /** Has so many bytes, and if it grows, room for half as many more. */
        public HostBuffer ensure(long bytes) {
            if (buffer == null || buffer.size() < bytes) {
                long wanted = Math.max(LEAST_BYTES, Math.min(roomier(bytes), MOST_BYTES));
                HostBuffer larger = session.hostBuffer(Math.max(bytes, wanted));
                close();
                buffer = larger;
            }
            return buffer;
        }

        /** Null if there is none yet. */
        public HostBuffer get() {
            return buffer;
        }

        @Override
        public void close() {
            if (buffer != null) {
                buffer.close();
            }
        }
    }
}
