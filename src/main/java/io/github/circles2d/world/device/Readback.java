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
import java.util.function.IntPredicate;

/** Reads the state back in the order of ids; {@code kernels/world/stages/Readback.cl}. */
final class Readback {
    /** Bytes of x, y, radius and mass. */
    private static final long CIRCLE_BYTES = 4L * Float.BYTES;

    /** Bytes of x and y. */
    static final long POINT_BYTES = 2L * Float.BYTES;

    /** Ints of how a circle comes to rest: rest, bits of the drift x, y, turned. */
    static final int SLEEP_INTS = 4;

    private final Session session;
    private final DeviceArrays arrays;
    private final Kernel circles;
    private final Kernel velocities;
    private final Kernel positions;

    /** Null unless circles turn. */
    private Kernel turns;

    /** Null unless circles sleep. */
    private Kernel asleep;

    private DeviceBuffer byId;
    private HostBuffer host;

    /** What callers look into; no other read may touch it. */
    private HostBuffer shared;

    private FloatBuffer sharedView;
    private final IdMask living = new IdMask();

    Readback(Session session, StageKernels kernels, DeviceArrays arrays) {
        this.session = session;
        this.arrays = arrays;
        circles = kernels.plain("readback_circles");
        velocities = kernels.plain("readback_velocities");
        positions = kernels.plain("readback_positions");
        byId = session.allocate("read-back", 1024);
        host = session.hostBuffer(1024);
        shared = session.hostBuffer(1024);
        sharedView = shared.floats().asReadOnlyBuffer();
    }

    void circles(HandleTable handles, int slots, float[] to) {
        ensureHost(CIRCLE_BYTES * handles.end());
        layOut(circles, DeviceArray.HOME_CIRCLE, slots);
        byId.read(0, host, 0, CIRCLE_BYTES * handles.end());
        FloatBuffer read = host.floats();
        compact(handles::lives, handles.end(), 4, (at, written, length) -> read.get(at, to, written, length));
    }

    void velocities(HandleTable handles, int slots, float[] to) {
        ensureHost(POINT_BYTES * handles.end());
        layOut(velocities, DeviceArray.HOME_MOTION, slots);
        byId.read(0, host, 0, POINT_BYTES * handles.end());
        FloatBuffer read = host.floats();
        compact(handles::lives, handles.end(), 2, (at, written, length) -> read.get(at, to, written, length));
    }

    /** Reads back how circles turn, too, by kernels for circles that can rotate. */
    void useTurning(StageKernels kernels) {
        turns = kernels.plain("readback_turns");
    }

    /** Angles, of circles that turn. */
    void angles(HandleTable handles, int slots, int[] to) {
        layOutTurns(handles, slots, false);
        IntBuffer read = host.ints();
        int k = 0;
        for (int id = 0; id < handles.end(); id++) {
            if (handles.lives(id)) {
                to[k++] = read.get(id);
            }
        }
    }

    void angularVelocities(HandleTable handles, int slots, float[] to) {
        layOutTurns(handles, slots, true);
        FloatBuffer read = host.floats();
        int k = 0;
        for (int id = 0; id < handles.end(); id++) {
            if (handles.lives(id)) {
                to[k++] = read.get(id);
            }
        }
    }

    private void layOutTurns(HandleTable handles, int slots, boolean areVelocities) {
        long bytes = (long) Integer.BYTES * handles.end();
        ensureHost(bytes);
        turns.arg(4, areVelocities ? 1 : 0);
        layOut(turns, DeviceArray.HOME_TURN, slots);
        byId.read(0, host, 0, bytes);
    }

    /** Reads back who sleeps, too, by kernels for that. */
    void useSleeping(StageKernels kernels) {
        asleep = kernels.plain("readback_asleep");
    }

    boolean isAsleep(int id) {
        ensureHost(Integer.BYTES);
        arrays.get(DeviceArray.SLOT_OF).read((long) Integer.BYTES * id, host, 0, Integer.BYTES);
        long slot = host.ints().get(0);
        arrays.get(DeviceArray.HOME_SLEEP).read(SLEEP_INTS * Integer.BYTES * slot, host, 0, Integer.BYTES);
        return Sleep.isAsleep(host.ints().get(0));
    }

    /** Sets the bits of the ids of circles that sleep. */
    void asleep(long[] to) {
        int ids = Math.min(Long.SIZE * to.length, arrays.idCapacity());
        int words = (ids + Integer.SIZE - 1) / Integer.SIZE;
        ensureHost((long) Integer.BYTES * words);
        asleep.arg(0, arrays.get(DeviceArray.SLOT_OF))
                .arg(1, arrays.get(DeviceArray.HOME_SLEEP))
                .arg(2, ids)
                .arg(3, byId)
                .run(words);
        byId.read(0, host, 0, (long) Integer.BYTES * words);
        IntBuffer read = host.ints();
        for (int word = 0; word < words; word++) {
            to[word / 2] |= Integer.toUnsignedLong(read.get(word)) << Integer.SIZE * (word % 2);
        }
    }

    FloatBuffer positions(HandleTable handles, boolean lieById, int slots) {
        ensureShared(POINT_BYTES * handles.end());
        layOut(positions, DeviceArray.HOME_CIRCLE, slots);
        byId.read(0, shared, 0, POINT_BYTES * handles.end());
        if (handles.size() < handles.end()) {
            living.copy(handles);
            if (lieById) {
                living.markGaps(shared.floats(), 2);
            } else {
                living.closeGaps(shared.floats(), 2);
            }
        }
        return sharedView.clear().limit(2 * (lieById ? handles.end() : handles.size()));
    }

    private void layOut(Kernel kernel, DeviceArray state, int slots) {
        kernel.arg(0, arrays.get(DeviceArray.HOME_ID))
                .arg(1, arrays.get(state))
                .arg(2, slots)
                .arg(3, byId)
                .run(slots);
    }

    /** Closes the gaps that removed ids have left; while nothing was removed, that is one copy. */
    private static void compact(IntPredicate lives, int end, int floats, Copy copy) {
        int written = 0;
        for (int id = 0; id < end; ) {
            if (!lives.test(id)) {
                id++;
                continue;
            }
            int first = id;
            while (id < end && lives.test(id)) {
                id++;
            }
            int length = (id - first) * floats;
            copy.copy(first * floats, written, length);
            written += length;
        }
    }

    /** Copies floats of living ids that follow each other. */
    private interface Copy {
        void copy(int from, int to, int length);
    }

    private void ensureHost(long bytes) {
        ensureDevice(bytes);
        if (host.size() < bytes) {
            HostBuffer larger = session.hostBuffer(roomier(bytes));
            host.close();
            host = larger;
        }
    }

    private void ensureShared(long bytes) {
        ensureDevice(bytes);
        if (shared.size() < bytes) {
            HostBuffer larger = session.hostBuffer(roomier(bytes));
            sharedView = larger.floats().asReadOnlyBuffer();
            shared.close();
            shared = larger;
        }
    }

    private void ensureDevice(long bytes) {
        byId = GrownBuffer.of(session, "read-back", byId, bytes, bytes + (bytes >> 1));
    }

    /** Room for so many bytes on the host, and for some growth. */
    static long roomier(long bytes) {
        return Math.min(bytes + (bytes >> 1), Integer.MAX_VALUE - 4096);
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
