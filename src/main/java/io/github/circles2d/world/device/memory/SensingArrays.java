package io.github.circles2d.world.device.memory;

import io.github.circles2d.opencl.DeviceBuffer;
import io.github.circles2d.opencl.Session;
import io.github.circles2d.world.model.PairTable;
import io.github.circles2d.world.model.SensorRule;
import io.github.circles2d.world.model.StepReports;
import java.nio.IntBuffer;

/** The memory in which a device finds the pairs that are only sensed, if some are reported; {@code kernels/world/stages/Sensing.cl}. */
public final class SensingArrays implements AutoCloseable {
    private static final int TAKES_PART = 1;
    private static final int SEEKS = 2;
    private static final int ASKS = 4;
    private static final int MEETS_STATIC = 8;
    private static final long START_BYTES = 8;

    private final int[] table = new int[PairTable.WORDS + PairTable.KINDS];
    private int version = -1;
    private final GrownBuffer start;
    private final GrownBuffer seeking;

    /** No memory yet. */
    public SensingArrays(Session session) {
        start = new GrownBuffer(session, "sensing: start");
        seeking = new GrownBuffer(session, "sensing: kinds");
    }

    /** Makes room for the ids that other arrays have room for. */
    public void ensure(DeviceArrays arrays) {
        seeking.ensure((long) Integer.BYTES * table.length);
        start.ensure(START_BYTES * arrays.idCapacity());
    }

    /** Sends who looks for whom, if it is not there yet. */
    public void send(StepReports k) {
        if (version == k.seekingVersion) {
            return;
        }
        System.arraycopy(k.seeking, 0, table, 0, PairTable.WORDS);
        for (int kind = 0; kind < PairTable.KINDS; kind++) {
            int part = 0;
            for (int other = 0; other < PairTable.KINDS; other++) {
                int row = PairTable.get(k.seeking, kind, other);
                part |= row == SensorRule.NONE ? 0 : row == SensorRule.FOUND ? TAKES_PART : TAKES_PART | SEEKS;
                part |= row != SensorRule.NONE && (asks(k, kind) || asks(k, other)) ? MEETS_STATIC : 0;
            }
            part |= asks(k, kind) ? ASKS : 0;
            table[PairTable.WORDS + kind] = part;
        }
        seeking.get().write(0, IntBuffer.wrap(table));
        version = k.seekingVersion;
    }

    private static boolean asks(StepReports k, int kind) {
        return k.asking != null && StepReports.asks(k.asking, kind);
    }

    /** By id: where circles were as the step began. */
    public DeviceBuffer start() {
        return start.get();
    }

    /** By pair of kinds, and by kind: who looks for whom. */
    public DeviceBuffer seeking() {
        return seeking.get();
    }

    @Override
    public void close() {
        start.close();
        seeking.close();
    }
}
