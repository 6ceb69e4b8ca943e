package io.github.circles2d.bench.sweep;

import io.github.circles2d.opencl.Device;
import io.github.circles2d.opencl.DeviceBuffer;
import io.github.circles2d.opencl.Kernel;
import io.github.circles2d.opencl.KernelSource;
import io.github.circles2d.opencl.Program;
import io.github.circles2d.opencl.Session;
import java.nio.IntBuffer;

/** Counts wrong slots of the computed indexing by the kernel with which Circles2D counts them, but for many n in a row. */
final class WrongSlots implements AutoCloseable {
    private static final int SLOTS_PER_ITEM = 256;

    private final Session session;
    private final DeviceBuffer number;
    private final Kernel kernel;
    private final IntBuffer value = IntBuffer.allocate(1);

    WrongSlots(Device device) {
        session = Session.open(device);
        number = session.allocate("number of wrong slots", Integer.BYTES);
        Program program = session.build(
                KernelSource.of("CirclePhysV2.cl", "thesis/WrongSlots.cl").define("SLOTS_PER_ITEM", SLOTS_PER_ITEM),
                "-cl-finite-math-only");
        kernel = program.kernel("count_wrong_slots");
    }

    /** The wrong slots of n circles. */
    long count(int n) {
        int slots = Math.toIntExact(n * (n - 1L) / 2);
        number.write(0, value.put(0, 0));
        kernel.arg(0, number).arg(1, slots).arg(2, n).run((slots + SLOTS_PER_ITEM - 1L) / SLOTS_PER_ITEM);
        number.read(value);
        return value.get(0);
    }

    @Override
    public void close() {
        session.close();
    }
}
