package io.github.circles2d.world.device.memory;

import io.github.circles2d.opencl.DeviceBuffer;
import io.github.circles2d.opencl.Session;
import java.nio.IntBuffer;

/** The records that a device writes in a step, in no order: rows of ints, with room that grows. */
final class RecordBuffer implements AutoCloseable {
    private final Session session;
    private final String name;
    private final int ints;
    private DeviceBuffer records;

    /**
     * No memory yet.
     *
     * @param ints of a record
     */
    RecordBuffer(Session session, String name, int ints) {
        this.session = session;
        this.name = name;
        this.ints = ints;
    }

    /** Makes room for records. Those that are there may be lost. */
    void ensure(long count) {
        long bytes = (long) Integer.BYTES * ints * count;
        records = GrownBuffer.of(session, name, records, bytes, bytes);
    }

    /** The buffer, once there has been room. */
    DeviceBuffer buffer() {
        return records;
    }

    /** Records that there is room for. */
    int room() {
        return (int) Math.min(records.bytes() / ((long) Integer.BYTES * ints), Integer.MAX_VALUE);
    }

    /** Reads the first records into an array. */
    void read(int[] to, int count) {
        if (count > 0) {
            records.read(IntBuffer.wrap(to, 0, ints * count));
        }
    }

    @Override
    public void close() {
        GrownBuffer.close(records);
    }
}
