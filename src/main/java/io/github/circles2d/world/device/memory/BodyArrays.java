package io.github.circles2d.world.device.memory;

import io.github.circles2d.opencl.DeviceBuffer;
import io.github.circles2d.opencl.HostBuffer;
import io.github.circles2d.opencl.Session;

/** Memory by which circles near to bodies that are pushed travel between a device and the host. */
public final class BodyArrays implements AutoCloseable {
    private final Session session;
    private DeviceBuffer found;
    private DeviceBuffer held;

    /** Null as long as there has been no step in which somebody slept. */
    private DeviceBuffer sleepers;

    private DeviceBuffer slots;
    private DeviceBuffer rows;
    private HostBuffer host;

    public BodyArrays(Session session) {
        this.session = session;
        ensureFound(0);
        ensureHeld(0);
        ensureRows(0, 0);
        ensureHost(0);
    }

    /** Makes room for so many bytes; what has been found is lost. */
    public void ensureFound(long bytes) {
        found = GrownBuffer.of(session, "circles near to bodies", found, bytes, roomier(bytes));
        ensureHost(bytes);
    }

    /** Makes room for so many bytes of ids; what there was is lost. */
    public void ensureHeld(long bytes) {
        held = GrownBuffer.of(session, "circles that joints hold to bodies", held, bytes, roomier(bytes));
        ensureHost(bytes);
    }

    /** Makes room for so many bytes of circles that sleep at bodies; what there was is lost. */
    public void ensureSleepers(long bytes) {
        sleepers = GrownBuffer.of(session, "circles that sleep at bodies", sleepers, bytes, roomier(bytes));
        ensureHost(bytes);
    }

    /** Makes room for so many bytes of slots, and of rows; what they had is lost. */
    public void ensureRows(long slotBytes, long rowBytes) {
        slots = GrownBuffer.of(session, "slots of circles at bodies", slots, slotBytes, roomier(slotBytes));
        rows = GrownBuffer.of(session, "circles at bodies", rows, rowBytes, roomier(rowBytes));
        ensureHost(Math.max(slotBytes, rowBytes));
    }

    private void ensureHost(long bytes) {
        if (host == null || host.size() < bytes) {
            HostBuffer larger = session.hostBuffer(roomier(bytes));
            if (host != null) {
                host.close();
            }
            host = larger;
        }
    }

    private static long roomier(long bytes) {
        return Math.max(4096, bytes + (bytes >> 1));
    }

    public DeviceBuffer found() {
        return found;
    }

    public DeviceBuffer held() {
        return held;
    }

    public DeviceBuffer sleepers() {
        if (sleepers == null) {
            ensureSleepers(0);
        }
        return sleepers;
    }

    public DeviceBuffer slots() {
        return slots;
    }

    public DeviceBuffer rows() {
        return rows;
    }

    /** As large as the largest of the others needs it. */
    public HostBuffer host() {
        return host;
    }

    @Override
    public void close() {
        GrownBuffer.close(found, held, sleepers, slots, rows);
        host.close();
    }
}
