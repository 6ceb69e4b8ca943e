package io.github.circles2d.world.device.memory;

import io.github.circles2d.opencl.DeviceBuffer;
import io.github.circles2d.opencl.Session;
import io.github.circles2d.world.model.PairTable;
import io.github.circles2d.world.model.SensorRule;
import io.github.circles2d.world.model.StepConstants;
import java.nio.IntBuffer;

/** The memory in which a device finds the pairs that are only sensed, if some are reported; {@code kernels/world/stages/Sensing.cl}. */
public final class SensingArrays implements AutoCloseable {
    /** Ints of a record. */
    public static final int RECORD = 12;

    // Ints of a record, from its beginning: ids, and the numbers of circle a, of lower id, and of circle b.
    public static final int AT_ID = 0;
    public static final int AT_OTHER = 1;
    public static final int AT_A = 2;
    public static final int AT_B = 7;

    // Floats of a circle in a record: where the step began, its path, its radius.
    public static final int X = 0;
    public static final int Y = 1;
    public static final int PATH_X = 2;
    public static final int PATH_Y = 3;
    public static final int RADIUS = 4;

    private static final int TAKES_PART = 1;
    private static final int SEEKS = 2;
    private static final long START_BYTES = 8;
    private static final int LEAST_RECORDS = 256;

    private final Session session;
    private final int[] table = new int[PairTable.WORDS + PairTable.KINDS];
    private int version = -1;
    private DeviceBuffer start;
    private DeviceBuffer seeking;
    private final RecordBuffer records;

    /** No memory yet. */
    public SensingArrays(Session session) {
        this.session = session;
        records = new RecordBuffer(session, "sensing: records", RECORD);
    }

    /** Makes room for the ids that other arrays have room for. */
    public void ensure(DeviceArrays arrays) {
        seeking = ensure("sensing: kinds", seeking, (long) Integer.BYTES * table.length);
        start = ensure("sensing: start", start, START_BYTES * arrays.idCapacity());
        records.ensure(LEAST_RECORDS);
    }

    /** Makes room for records. */
    public void ensureRecords(int count) {
        if (count > Integer.MAX_VALUE / (2 * RECORD)) {
            throw new IllegalStateException(count + " pairs are sensed in a step, but must be at most "
                    + Integer.MAX_VALUE / (2 * RECORD) + " on a device");
        }
        records.ensure(count + (count >> 1));
    }

    private DeviceBuffer ensure(String name, DeviceBuffer buffer, long bytes) {
        return GrownBuffer.of(session, name, buffer, bytes, bytes);
    }

    /** Sends who looks for whom, if it is not there yet. */
    public void send(StepConstants k) {
        if (version == k.seekingVersion) {
            return;
        }
        System.arraycopy(k.seeking, 0, table, 0, PairTable.WORDS);
        for (int kind = 0; kind < PairTable.KINDS; kind++) {
            int part = 0;
            for (int other = 0; other < PairTable.KINDS; other++) {
                int row = PairTable.get(k.seeking, kind, other);
                part |= row == SensorRule.NONE ? 0 : row == SensorRule.FOUND ? TAKES_PART : TAKES_PART | SEEKS;
            }
            table[PairTable.WORDS + kind] = part;
        }
        seeking.write(0, IntBuffer.wrap(table));
        version = k.seekingVersion;
    }

    /** By id: where circles were as the step began. */
    public DeviceBuffer start() {
        return start;
    }

    /** By pair of kinds, and by kind: who looks for whom. */
    public DeviceBuffer seeking() {
        return seeking;
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
        GrownBuffer.close(start, seeking);
        records.close();
    }
}
