package io.github.circles2d.thesis;

import io.github.circles2d.opencl.HostBuffer;
import io.github.circles2d.opencl.Kernel;
import io.github.circles2d.opencl.KernelSource;
import io.github.circles2d.opencl.Program;
import io.github.circles2d.opencl.Session;

/**
 * Strategy 0, computed: no table. The single-precision formula maps some slots wrongly from 2,050 circles on; they are
 * counted on the device and skipped.
 */
public final class ComputedPairs extends PairStrategy {
    public ComputedPairs() {
        super("detect_collisions", "resolve_collisions");
    }

    @Override
    public KernelSource source(int circles) {
        return KernelSource.of(THESIS_KERNELS, "thesis/WrongSlots.cl");
    }

    @Override
    long countWrongSlots(Session session, Program program, State state) {
        if (state.slots == 0) {
            return 0;
        }
        // Before the first step the collision buffer is free: its first int holds the count.
        try (HostBuffer number = session.hostBuffer(Integer.BYTES);
                Kernel count = program.kernel("count_wrong_slots")) {
            state.collision.write(0, number, 0, Integer.BYTES);
            count.arg(0, state.collision)
                    .arg(1, state.slots)
                    .arg(2, state.circles)
                    .run(state.slots);
            state.collision.read(0, number, 0, Integer.BYTES);
            return number.ints().get(0);
        }
    }
}
