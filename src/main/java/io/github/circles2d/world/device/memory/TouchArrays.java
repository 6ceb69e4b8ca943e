package io.github.circles2d.world.device.memory;

import io.github.circles2d.opencl.DeviceBuffer;
import io.github.circles2d.opencl.Kernel;
import io.github.circles2d.opencl.Session;
import java.nio.IntBuffer;

/** The memory in which a device records what contacts and walls do, if events are reported; {@code kernels/world/stages/Touches.cl}. */
public final class TouchArrays implements AutoCloseable {
    /** Ints of a record. */
    public static final int RECORD = 12;

    // Ints of a record, from its beginning.
    public static final int AT_ID = 0;
    public static final int AT_OTHER = 1;
    public static final int AT_SAYS = 2;
    public static final int AT_APPROACH = 3;
    public static final int AT_IMPULSE = 4;
    public static final int AT_VN = 5;
    public static final int AT_THRESHOLD = 6;
    public static final int AT_NORMAL_X = 7;
    public static final int AT_NORMAL_Y = 8;
    public static final int AT_POINT_X = 9;
    public static final int AT_POINT_Y = 10;

    // What a record says, as bits: see TouchRecords.cl.
    public static final int TOUCHING = 1;
    public static final int HOLDS = 2;
    public static final int PARTED = 4;

    private static final long CONTACT_BYTES = 32;
    private static final long SLOT_BYTES = 32;

    /** Records of walls that a circle may have in a step: of each axis that of the wall it has touched, and of the nearer one. */
    private static final int RECORDS_PER_SLOT = 4;

    private final Session session;
    private final boolean walls;
    private DeviceBuffer contacts;
    private DeviceBuffer slots;
    private final RecordBuffer records;
    private DeviceBuffer hits;

    /** A step's number is that of the steps made before it and this: 0, which is in memory at first, is of none. */
    private static final int FIRST_STEP = 2;

    private int step;

    private boolean all;
    private float hitSpeed;

    /**
     * No memory yet.
     *
     * @param walls whether walls are recorded
     */
    public TouchArrays(Session session, boolean walls) {
        this.session = session;
        this.walls = walls;
        records = new RecordBuffer(session, "records of touches", RECORD);
    }

    /**
     * What kernels have of this memory, if they are compiled for steps that record (RECORDING): a struct, and the arguments that fill
     * it. Other kernels have none of it.
     */
    static String text() {
        return """
                #ifdef RECORDING
                typedef struct {
                    global float4 *touch; // by contact: see the plan's files
                    global float4 *wallTouch; // by slot and axis: see Touches.cl
                    global int4 *records; // see writeRecord
                    global int *hitBy; // see hitOf
                    int room; // for records
                    int walls; // whether walls are recorded
                    int step; // its number: two more than steps were made before it
                    int all; // whether all pairs in touch are to be recorded
                    float hitSpeed; // that counts as a hit; negative: that of the pair
                    int numbers; // by tiles: see touchNumbers
                } Recording;
                #define RECORDING_PARAMETERS , global float4 *touch, global float4 *wallTouch, global int4 *records, \
                    global int *hitBy, int recordRoom, int withWalls, int stepNumber, int everyPair, float hitSpeed
                #define RECORD_IN(w) Recording recording = {touch, wallTouch, records, hitBy, recordRoom, withWalls, \
                    stepNumber, everyPair, hitSpeed}; (w).recording = recording
                #else
                #define RECORDING_PARAMETERS
                #define RECORD_IN(w)
                #endif
                """;
    }

    /** Gives a kernel its RECORDING_PARAMETERS, of which the first is an argument of its own. */
    public void bind(Kernel kernel, int first) {
        kernel.arg(StageKernels.own(first), contacts)
                .arg(StageKernels.own(first + 1), slots)
                .arg(StageKernels.own(first + 2), records.buffer())
                .arg(StageKernels.own(first + 3), hits)
                .arg(StageKernels.own(first + 4), room())
                .arg(StageKernels.own(first + 5), walls ? 1 : 0)
                .arg(StageKernels.own(first + 6), step)
                .arg(StageKernels.own(first + 7), all ? 1 : 0)
                .arg(StageKernels.own(first + 8), hitSpeed);
    }

    /**
     * Prepares the next step.
     *
     * @param stepsMade before it, since the world was made
     * @param wanted whether it has to record all pairs in touch
     * @param speed that counts as a hit; negative: that of the pair
     */
    public void prepare(DeviceArrays arrays, int stepsMade, boolean wanted, float speed) {
        step = FIRST_STEP + stepsMade;
        boolean forgetsHits = 2L * Integer.BYTES * arrays.idCapacity() > hits.bytes();
        all |= wanted || forgetsHits; // until the step has been made: it may be refused at first
        hitSpeed = speed;
        ensure(arrays);
    }

    /** Takes note that the step has been made. */
    public void stepMade() {
        all = false;
    }

    /** Makes room for what other arrays have room for, so that no step lacks room for its records. */
    public void ensure(DeviceArrays arrays) {
        long room = arrays.contactCapacity() + (walls ? (long) RECORDS_PER_SLOT * arrays.slotCapacity() : 0);
        contacts = ensure("touches", contacts, CONTACT_BYTES * arrays.contactCapacity());
        slots = ensure("touches of walls", slots, SLOT_BYTES * arrays.slotCapacity());
        records.ensure(room);
        DeviceBuffer before = hits;
        hits = ensure("hits of circles", hits, 2L * Integer.BYTES * arrays.idCapacity());
        if (hits != before) {
            hits.write(0, IntBuffer.wrap(new int[Math.multiplyExact(2, arrays.idCapacity())]));
        }
    }

    private DeviceBuffer ensure(String name, DeviceBuffer buffer, long bytes) {
        return GrownBuffer.of(session, name, buffer, bytes, bytes);
    }

    /** Whether walls are recorded. */
    public boolean hasWalls() {
        return walls;
    }

    /** By contact. */
    public DeviceBuffer contacts() {
        return contacts;
    }

    /** By slot and axis. */
    public DeviceBuffer slots() {
        return slots;
    }

    /** The records of the last step. */
    public DeviceBuffer records() {
        return records.buffer();
    }

    /** Records that there is room for. */
    public int room() {
        return records.room();
    }

    /** Reads the first records into an array. */
    public void read(int[] to, int count) {
        records.read(to, count);
    }

    @Override
    public void close() {
        GrownBuffer.close(contacts, slots, hits);
        records.close();
    }
}
