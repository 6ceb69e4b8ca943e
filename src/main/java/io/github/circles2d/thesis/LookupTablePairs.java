package io.github.circles2d.thesis;

import io.github.circles2d.opencl.DeviceBuffer;
import io.github.circles2d.opencl.HostBuffer;
import io.github.circles2d.opencl.KernelSource;
import io.github.circles2d.opencl.Session;
import java.nio.IntBuffer;

/** Strategy 1, look-up table: the pair of every slot, (i, j) as two ints. */
public final class LookupTablePairs extends PairStrategy {
    /** The table goes to the device in pieces of this many slots. */
    private static final int PIECE = 1 << 19;

    public LookupTablePairs() {
        super("detect_collisions_precomputed_pairs", "resolve_collisions_with_pairs");
    }

    @Override
    public KernelSource source(int circles) {
        return KernelSource.of(THESIS_KERNELS);
    }

    @Override
    long tableBytes(int circles) {
        return MemoryNeed.SLOT_BYTES * PairSlots.count(circles);
    }

    @Override
    void open(Session session, int circles) {
        DeviceBuffer indexes = makeTable(session, "indexes", circles);
        long slots = PairSlots.count(circles);
        try (HostBuffer piece = session.hostBuffer(MemoryNeed.SLOT_BYTES * Math.min(slots, PIECE))) {
            IntBuffer pairs = piece.ints();
            int inPiece = 0;
            long written = 0;
            for (int i = 0; i < circles; i++) {
                for (int j = i + 1; j < circles; j++) {
                    pairs.put(2 * inPiece, i).put(2 * inPiece + 1, j);
                    inPiece++;
                    if (inPiece == PIECE || written + inPiece == slots) {
                        indexes.write(MemoryNeed.SLOT_BYTES * written, piece, 0, MemoryNeed.SLOT_BYTES * inPiece);
                        written += inPiece;
                        inPiece = 0;
                    }
                }
            }
        }
    }

    @Override
    boolean takesCircles() {
        return false;
    }
}
