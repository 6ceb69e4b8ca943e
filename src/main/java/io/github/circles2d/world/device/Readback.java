package io.github.circles2d.world.device;

import io.github.circles2d.opencl.DeviceBuffer;
import io.github.circles2d.opencl.HostBuffer;
import io.github.circles2d.opencl.Kernel;
import io.github.circles2d.opencl.Session;
import io.github.circles2d.world.circles.HandleTable;
import io.github.circles2d.world.circles.IdMask;
import io.github.circles2d.world.device.memory.DeviceArray;
import io.github.circles2d.world.device.memory.DeviceArrays;
import io.github.circles2d.world.device.memory.GrownBuffer;
import io.github.circles2d.world.device.memory.StageKernels;
import io.github.circles2d.world.model.Sleep;
import java.nio.FloatBuffer;
import java.nio.IntBuffer;

/** Reads the state back in the order of ids; {@code kernels/world/stages/Readback.cl}. */
final class Readback {
    /** Bytes of x, y, radius and mass. */
    private static final long CIRCLE_BYTES = 4L * Float.BYTES;

    /** Bytes of x and y. */
    static final long POINT_BYTES = 2L * Float.BYTES;

    /** Ints of how a circle comes to rest: rest, bits of the drift x, y, turned. */
    static final int SLEEP_INTS = 4;

    private final DeviceArrays arrays;
    private final Kernel circles;
    private final Kernel velocities;
    private final Kernel positions;

    /** Null unless circles turn. */
    private Kernel turns;

    /** Null unless circles sleep. */
    private Kernel asleep;

    private final GrownBuffer byId;
    private final GrownBuffer.OnHost host;

    /** What callers look into; no other read may touch it. */
    private final GrownBuffer.OnHost shared;

    private FloatBuffer sharedView;
    private final IdMask living = new IdMask();

    Readback(Session session, StageKernels kernels, DeviceArrays arrays) {
        this.arrays = arrays;
        circles = kernels.plain("readback_circles");
        velocities = kernels.plain("readback_velocities");
        positions = kernels.plain("readback_positions");
        byId = new GrownBuffer(session, "read-back");
        host = new GrownBuffer.OnHost(session);
        shared = new GrownBuffer.OnHost(session);
    }

    void circles(HandleTable handles, int slots, float[] to) {
        readRows(circles, DeviceArray.HOME_CIRCLE, CIRCLE_BYTES, handles, slots, to);
    }

    void velocities(HandleTable handles, int slots, float[] to) {
        readRows(velocities, DeviceArray.HOME_MOTION, POINT_BYTES, handles, slots, to);
    }

    /** Closes the gaps that removed ids have left; while nothing was removed, that is one copy. */
    private void readRows(Kernel kernel, DeviceArray state, long rowBytes, HandleTable handles, int slots, float[] to) {
        FloatBuffer read = read(kernel, state, rowBytes * handles.end(), slots).floats();
        int floats = (int) rowBytes / Float.BYTES;
        int written = 0;
        for (int id = 0; id < handles.end(); ) {
            if (!handles.lives(id)) {
                id++;
                continue;
            }
            int first = id;
            while (id < handles.end() && handles.lives(id)) {
                id++;
            }
            int length = (id - first) * floats;
            read.get(first * floats, to, written, length);
            written += length;
        }
    }

    /** Reads back how circles turn, too, by kernels for circles that can rotate. */
    void useTurning(StageKernels kernels) {
        turns = kernels.plain("readback_turns");
    }

    /** Angles, of circles that turn. */
    void angles(HandleTable handles, int slots, int[] to) {
        IntBuffer read = readTurns(handles, slots, false).ints();
        int k = 0;
        for (int id = 0; id < handles.end(); id++) {
            if (handles.lives(id)) {
                to[k++] = read.get(id);
            }
        }
    }

    void angularVelocities(HandleTable handles, int slots, float[] to) {
        FloatBuffer read = readTurns(handles, slots, true).floats();
        int k = 0;
        for (int id = 0; id < handles.end(); id++) {
            if (handles.lives(id)) {
                to[k++] = read.get(id);
            }
        }
    }

    private HostBuffer readTurns(HandleTable handles, int slots, boolean areVelocities) {
        turns.arg(4, areVelocities ? 1 : 0);
        return read(turns, DeviceArray.HOME_TURN, (long) Integer.BYTES * handles.end(), slots);
    }

    /** Reads back who sleeps, too, by kernels for that. */
    void useSleeping(StageKernels kernels) {
        asleep = kernels.plain("readback_asleep");
    }

    boolean isAsleep(int id) {
        HostBuffer one = host.ensure(Integer.BYTES);
        arrays.get(DeviceArray.SLOT_OF).read((long) Integer.BYTES * id, one, 0, Integer.BYTES);
        long slot = one.ints().get(0);
        arrays.get(DeviceArray.HOME_SLEEP).read(SLEEP_INTS * Integer.BYTES * slot, one, 0, Integer.BYTES);
        return Sleep.isAsleep(one.ints().get(0));
    }

    /** Sets the bits of the ids of circles that sleep. */
    void asleep(long[] to) {
        int ids = Math.min(Long.SIZE * to.length, arrays.idCapacity());
        int words = (ids + Integer.SIZE - 1) / Integer.SIZE;
        DeviceBuffer bits = byId.ensureRoomy((long) Integer.BYTES * words);
        asleep.arg(0, arrays.get(DeviceArray.SLOT_OF))
                .arg(1, arrays.get(DeviceArray.HOME_SLEEP))
                .arg(2, ids)
                .arg(3, bits)
                .run(words);
        IntBuffer read = readTo(host, (long) Integer.BYTES * words).ints();
        for (int word = 0; word < words; word++) {
            to[word / 2] |= Integer.toUnsignedLong(read.get(word)) << Integer.SIZE * (word % 2);
        }
    }

    FloatBuffer positions(HandleTable handles, boolean lieById, int slots) {
        long bytes = POINT_BYTES * handles.end();
        layOut(positions, DeviceArray.HOME_CIRCLE, bytes, slots);
        HostBuffer before = shared.get();
        HostBuffer read = readTo(shared, bytes);
        if (read != before) {
            sharedView = read.floats().asReadOnlyBuffer();
        }
        if (handles.size() < handles.end()) {
            living.copy(handles);
            if (lieById) {
                living.markGaps(read.floats(), 2);
            } else {
                living.closeGaps(read.floats(), 2);
            }
        }
        return sharedView.clear().limit(2 * (lieById ? handles.end() : handles.size()));
    }

    private HostBuffer read(Kernel kernel, DeviceArray state, long bytes, int slots) {
        layOut(kernel, state, bytes, slots);
        return readTo(host, bytes);
    }

    private void layOut(Kernel kernel, DeviceArray state, long bytes, int slots) {
        kernel.arg(0, arrays.get(DeviceArray.HOME_ID))
                .arg(1, arrays.get(state))
                .arg(2, slots)
                .arg(3, byId.ensureRoomy(bytes))
                .run(slots);
    }

    private HostBuffer readTo(GrownBuffer.OnHost memory, long bytes) {
        HostBuffer to = memory.ensure(bytes);
        byId.get().read(0, to, 0, bytes);
        return to;
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
