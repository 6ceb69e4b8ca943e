package io.github.circles2d.thesis;

import io.github.circles2d.opencl.Kernel;
import io.github.circles2d.opencl.KernelSource;
import io.github.circles2d.opencl.Program;

/** Strategy 3, exact: no table, and a closed form that is right for every slot. */
public final class ExactPairs extends PairStrategy {
    /** Creates the strategy. */
    public ExactPairs() {}

    @Override
    public KernelSource source(int circles) {
        return KernelSource.of(THESIS_KERNELS, "thesis/ExactPairs.cl");
    }

    @Override
    Kernel detect(Program program, State state) {
        return program.kernel("detect_collisions_exact")
                .arg(0, state.circle)
                .arg(1, state.collision)
                .arg(2, state.slots)
                .arg(3, state.circles);
    }

    @Override
    Kernel resolve(Program program, State state, float restitution) {
        return program.kernel("resolve_collisions_exact")
                .arg(0, state.circle)
                .arg(1, state.collision)
                .arg(2, state.velocities)
                .arg(3, state.slots)
                .arg(4, state.circles)
                .arg(5, restitution);
    }
}
