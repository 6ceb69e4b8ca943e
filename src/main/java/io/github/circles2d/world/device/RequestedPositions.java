package io.github.circles2d.world.device;

import io.github.circles2d.opencl.CopyQueue;
import io.github.circles2d.opencl.HostBuffer;
import io.github.circles2d.opencl.Kernel;
import io.github.circles2d.opencl.Session;
import io.github.circles2d.world.circles.HandleTable;
import io.github.circles2d.world.circles.IdMask;
import io.github.circles2d.world.device.memory.DeviceArray;
import io.github.circles2d.world.device.memory.DeviceArrays;
import io.github.circles2d.world.device.memory.GrownBuffer;
import io.github.circles2d.world.device.memory.StageKernels;
import java.nio.FloatBuffer;

/**
 * Positions that come to the host while the next steps run; {@code kernels/world/stages/Readback.cl}. A kernel lays
 * them out behind the pending steps, which may still be refused; the number of steps made comes with them and shows it.
 */
final class RequestedPositions {
    /** Bytes of the number of steps made, and of what keeps the positions behind it aligned. */
    private static final int HEADER = 8;

    private final Session session;
    private final DeviceArrays arrays;
    private final Kernel layOut;

    /** Null until the first request, as the memory below: few worlds have one. */
    private CopyQueue copies;

    private final GrownBuffer byId;

    /** Where a request arrives while callers look into what they took last. */
    private final Target[] targets;

    /** Where the next request arrives. */
    private int current;

    /** The circles at the request: how many, and their ids. */
    private int circles;

    private final IdMask living = new IdMask();

    /** Steps written home since the world was made that must have led to these positions. */
    private int stepsDue;

    /** Whether they have not been taken yet. */
    private boolean requested;

    /** Whether a copy may be under way. */
    private boolean copying;

    RequestedPositions(Session session, StageKernels kernels, DeviceArrays arrays) {
        this.session = session;
        byId = new GrownBuffer(session, "requested positions");
        targets = new Target[] {new Target(session), new Target(session)};
        this.arrays = arrays;
        layOut = kernels.plain("readback_request");
    }

    /** Asks for the positions behind all steps that have been enqueued. */
    void request(HandleTable handles, int slots, int steps) {
        awaitCopy();
        requested = false;
        ensure(HEADER + Readback.POINT_BYTES * handles.end());
        circles = handles.size();
        living.copy(handles);
        stepsDue = steps;
        layOut(slots);
        requested = true;
    }

    /** How many of the steps that precede the request are missing, where it has not been taken. */
    int missing(int stepsDone) {
        return requested ? Math.max(0, stepsDue - stepsDone) : 0;
    }

    /** Lays the positions out behind what has been enqueued, and has them copied. */
    void layOut(int slots) {
        awaitCopy();
        if (circles == 0) {
            return;
        }
        HostBuffer host = targets[current].host();
        host.ints().put(0, ~stepsDue); // what an earlier request has left there may be the same number
        layOut.arg(0, arrays.get(DeviceArray.HOME_ID))
                .arg(1, arrays.get(DeviceArray.HOME_CIRCLE))
                .arg(2, slots)
                .arg(3, arrays.get(DeviceArray.STATUS))
                .arg(4, byId.get())
                .run(slots);
        copies.read(byId.get(), host, HEADER + Readback.POINT_BYTES * living.end());
        copying = true;
    }

    /** Waits for the copy. Returns whether all steps that precede the request, if it has not been taken, had been made when it was laid out. */
    boolean arrived() {
        awaitCopy();
        return circles == 0 || !requested || targets[current].host().ints().get(0) == stepsDue;
    }

    /** By id, NaN for others, or all circles if shown is null. Valid until the request after the next. */
    FloatBuffer take(IdMask shown) {
        Target target = targets[current];
        if (shown != null) {
            shown.markGaps(target.positions, 2);
        } else if (circles < living.end()) {
            living.closeGaps(target.positions, 2);
        }
        requested = false;
        current = 1 - current;
        return target.view.clear().limit(2 * (shown == null ? circles : living.end()));
    }

    private void awaitCopy() {
        if (copying) {
            copies.finish();
            copying = false;
        }
    }

    private void ensure(long bytes) {
        if (copies == null) {
            copies = session.copyQueue();
        }
        byId.ensureRoomy(bytes);
        targets[current].ensure(bytes);
    }

    /** Memory that requests arrive in, with its views. */
    private static final class Target {
        private final GrownBuffer.OnHost memory;
        private FloatBuffer positions;
        private FloatBuffer view;

        Target(Session session) {
            memory = new GrownBuffer.OnHost(session);
        }

        HostBuffer host() {
            return memory.get();
        }

        void ensure(long bytes) {
            HostBuffer before = memory.get();
            FloatBuffer floats = memory.ensure(bytes).floats();
            if (memory.get() != before) {
                positions = floats.slice(HEADER / Float.BYTES, floats.capacity() - HEADER / Float.BYTES);
                view = positions.asReadOnlyBuffer();
            }
        }
    }
}
