package io.github.circles2d.thesis;

import io.github.circles2d.opencl.DeviceBuffer;
import io.github.circles2d.opencl.Kernel;
import io.github.circles2d.opencl.KernelSource;
import io.github.circles2d.opencl.Program;
import io.github.circles2d.opencl.Session;
import java.nio.IntBuffer;

/**
 * Strategy 0, computed: no table. The single-precision formula maps some slots wrongly from 2,050 circles on; they are
 * counted on the device and skipped.
 */
public final class ComputedPairs extends PairStrategy {
    /** Creates the strategy. */
    public ComputedPairs() {}

    @Override
    public KernelSource source(int circles) {
        return KernelSource.of(THESIS_KERNELS, "thesis/WrongSlots.cl");
    }

    @Override
    Kernel detect(Program program, State state) {
        return program.kernel("detect_collisions")
                .arg(0, state.circle)
                .arg(1, state.collision)
                .arg(2, state.slots)
                .arg(3, state.circles);
    }

    @Override
    Kernel resolve(Program program, State state, float restitution) {
        return program.kernel("resolve_collisions")
                .arg(0, state.circle)
                .arg(1, state.collision)
                .arg(2, state.velocities)
                .arg(3, state.slots)
                .arg(4, state.circles)
                .arg(5, restitution);
    }

    @Override
    long countWrongSlots(Session session, Program program, State state) {
        try (DeviceBuffer wrong = session.allocate("number of wrong slots", Integer.BYTES);
                Kernel count = program.kernel("count_wrong_slots")) {
            IntBuffer number = IntBuffer.allocate(1);
            wrong.write(0, number);
            count.arg(0, wrong).arg(1, state.slots).arg(2, state.circles).run(state.slots);
            wrong.read(number);
            return number.get(0);
        }
    }
}
