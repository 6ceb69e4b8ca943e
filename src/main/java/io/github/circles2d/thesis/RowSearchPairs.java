package io.github.circles2d.thesis;

import io.github.circles2d.opencl.DeviceBuffer;
import io.github.circles2d.opencl.HostBuffer;
import io.github.circles2d.opencl.KernelSource;
import io.github.circles2d.opencl.Session;

/**
 * Strategy 2, row search: the first and the last slot of every row, two ints each. The last row is empty: it ends before it
 * begins.
 */
public final class RowSearchPairs extends PairStrategy {
    private static final long ROW_BYTES = 2L * Integer.BYTES;

    public RowSearchPairs() {
        super("detect_collisions_precomputed_rows", "resolve_collisions_with_rows");
    }

    @Override
    public KernelSource source(int circles) {
        return KernelSource.of(THESIS_KERNELS).define("ROW_SEARCH_ROUNDS", rounds(circles));
    }

    /** Returns the least r, 1 or more, with n at most 2^r: a number of rounds that is known when the kernel is compiled. */
    static int rounds(int circles) {
        return Integer.SIZE - Integer.numberOfLeadingZeros(Math.max(circles, 2) - 1);
    }

    @Override
    long tableBytes(int circles) {
        return ROW_BYTES * circles;
    }

    @Override
    void open(Session session, int circles) {
        DeviceBuffer rows = makeTable(session, "rows", circles);
        try (HostBuffer table = session.hostBuffer(tableBytes(circles))) {
            for (int i = 0; i < circles; i++) {
                table.ints().put(2 * i, (int) PairSlots.firstOfRow(i, circles));
                table.ints().put(2 * i + 1, (int) (PairSlots.firstOfRow(i + 1, circles) - 1));
            }
            rows.write(0, table, 0, tableBytes(circles));
        }
    }
}
