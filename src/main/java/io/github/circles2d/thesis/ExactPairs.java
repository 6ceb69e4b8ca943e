package io.github.circles2d.thesis;

import io.github.circles2d.opencl.KernelSource;

/** Strategy 3, exact: no table, and a closed form that is right for every slot. */
public final class ExactPairs extends PairStrategy {
    public ExactPairs() {
        super("detect_collisions_exact", "resolve_collisions_exact");
    }

    @Override
    public KernelSource source(int circles) {
        return KernelSource.of(THESIS_KERNELS, "thesis/ExactPairs.cl");
    }
}
