package io.github.circles2d.world;

import io.github.circles2d.opencl.Kernel;

/** Stage Contacts on a device; {@code kernels/world/Contacts.cl}. The same as {@link JvmContacts}. */
final class ClContacts {
    private final ClBuffers buffers;
    private final ClScan scan;
    private final Kernel crowd;
    private final Kernel count;
    private final Kernel list;
    private final Kernel fill;

    ClContacts(ClKernels kernels, ClBuffers buffers, ClScan scan) {
        this.buffers = buffers;
        this.scan = scan;
        crowd = kernels.staged("contacts_crowd");
        count = kernels.staged("contacts_count");
        list = kernels.staged("contacts_list");
        fill = kernels.staged("contacts_fill");
    }

    /**
     * Lists and fills the contacts.
     *
     * @param thinning whether to thin crowds out
     */
    void list(Levels levels, int circles, boolean thinning) {
        if (thinning) {
            crowd.run(circles);
        }
        count.run(circles);
        scan.run(buffers, levels.buckets() + 1, ClBuffers.GROUP_START);
        list.run(2L * circles);
        ClColours.run(levels, fill);
    }
}
