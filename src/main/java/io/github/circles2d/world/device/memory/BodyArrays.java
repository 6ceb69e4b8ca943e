package io.github.circles2d.world.device.memory;

import io.github.circles2d.opencl.HostBuffer;
import io.github.circles2d.opencl.Session;

/** Memory by which circles near to bodies that are pushed travel between a device and the host. */
public final class BodyArrays {
    public final GrownBuffer found;

    /** Ids of circles that joints hold to bodies, or that the host names. */
    public final GrownBuffer held;

    public final GrownBuffer sleepers;
    public final GrownBuffer slots;
    public final GrownBuffer rows;

    private final GrownBuffer.OnHost host;

    public BodyArrays(Session session) {
        found = new GrownBuffer(session, "circles near to bodies");
        held = new GrownBuffer(session, "circles that joints hold to bodies");
        sleepers = new GrownBuffer(session, "circles that sleep at bodies");
        slots = new GrownBuffer(session, "slots of circles at bodies");
        rows = new GrownBuffer(session, "circles at bodies");
        host = new GrownBuffer.OnHost(session);
        for (GrownBuffer buffer : new GrownBuffer[] {found, held, sleepers, slots, rows}) {
            ensure(buffer, 0);
        }
    }

    /** Makes room for so many bytes in one of these, and on the host; what there was is lost. */
    public void ensure(GrownBuffer buffer, long bytes) {
        host.ensure(buffer.ensureRoomy(bytes).bytes());
    }

    /** As large as the largest of the others needs it. */
    public HostBuffer host() {
        return host.get();
    }

    /** Writes what the first bytes of the host are. */
    public void send(GrownBuffer buffer, long bytes) {
        buffer.get().write(0, host(), 0, bytes);
    }

    /** Reads as many bytes to the host. */
    public void receive(GrownBuffer buffer, long bytes) {
        buffer.get().read(0, host(), 0, bytes);
    }
}
