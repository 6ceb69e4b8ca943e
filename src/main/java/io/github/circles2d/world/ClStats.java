package io.github.circles2d.world;

import io.github.circles2d.opencl.Kernel;
import java.nio.IntBuffer;

/** Counts what the last step did, when asked: from the grid and the contact list that it has left behind. */
final class ClStats {
    private final ClKernels kernels;
    private final ClBuffers buffers;
    private final Kernel candidates;
    private final Kernel degrees;

    ClStats(ClKernels kernels, ClBuffers buffers) {
        this.kernels = kernels;
        this.buffers = buffers;
        candidates = kernels.staged("contacts_candidates");
        degrees = kernels.plain("contacts_degrees");
    }

    int contacts(Levels levels) {
        if (levels.buckets() == 0) {
            return 0;
        }
        int[] count = new int[levels.buckets() + 1];
        buffers.get(ClBuffers.GROUP_START).read(IntBuffer.wrap(count));
        return count[levels.buckets()];
    }

    long candidatePairs(Levels levels, int circles) {
        if (levels.buckets() == 0) {
            return 0;
        }
        kernels.bind(buffers, circles, circles);
        candidates.run(circles);
        long sum = 0;
        for (int tested : ClReadback.ints(buffers.get(ClBuffers.RANK), circles)) {
            sum += tested;
        }
        return sum;
    }

    int greatestContacts(Levels levels, int circles) {
        int contacts = contacts(levels);
        if (contacts == 0) {
            return 0;
        }
        buffers.get(ClBuffers.RANK).write(0, IntBuffer.wrap(new int[circles]));
        degrees.arg(0, buffers.get(ClBuffers.PAIR))
                .arg(1, contacts)
                .arg(2, buffers.get(ClBuffers.RANK))
                .run(contacts);
        int greatest = 0;
        for (int degree : ClReadback.ints(buffers.get(ClBuffers.RANK), circles)) {
            greatest = Math.max(greatest, degree);
        }
        return greatest;
    }
}
