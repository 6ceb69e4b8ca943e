package io.github.circles2d.world.device;

import io.github.circles2d.opencl.Device;
import io.github.circles2d.opencl.Kernel;
import io.github.circles2d.world.model.GridLevels;

/**
 * Whole steps in one launch on a processor, where all circles are of one level; {@code kernels/world/Lanes.cl}. The launch has
 * as many work-groups of one work-item as the processor has threads, which wait for each other within it. Should they turn
 * out not to run at once, the launch says so and changes nothing; from then on there is one work-group alone.
 */
final class PersistentCpu {
    /** Circles that a work-group has at least: with fewer, waiting for each other costs more than it saves. */
    private static final int LEAST_SHARE = 512;

    /** Rows of cells that a work-group needs at least. */
    private static final int LEAST_ROWS = 8;

    /** How often a work-group looks for the others before it calls the launch off: about a second. */
    private static final int PATIENCE = 1 << 23;

    private static final System.Logger LOG = System.getLogger(PersistentCpu.class.getName());

    private final Kernel steps;
    private final Kernel degrees;
    private int mostGroups;
    private int rows;

    /** How many more work-groups are waited for than there are, and for how long: for tests. */
    private int missing;

    private int patience = PATIENCE;

    PersistentCpu(StageKernels kernels, Device device) {
        steps = kernels.staged("lanes_steps");
        degrees = kernels.staged("lanes_degrees");
        mostGroups = device.computeUnits();
    }

    /** Whether a device can run the lanes: a processor, on which one work-item is as good as many. */
    static boolean fits(Device device) {
        return device.kind() == Device.Kind.CPU;
    }

    /**
     * Whether kernels may call the system while they wait, in assembler: POCL 3 compiles that, POCL 5 ends the process, and no
     * other is known. Elsewhere who waits keeps his processor.
     */
    static boolean yields(Device device) {
        return device.platform().equals("Portable Computing Language")
                && device.driverVersion().startsWith("3.");
    }

    /** Makes launches wait for a work-group that does not come, until one is called off. */
    void waitForNobody(int looks) {
        missing = 1;
        patience = looks;
    }

    /** Makes launches wait for those that do come, after {@link #waitForNobody}. */
    void waitForAll() {
        missing = 0;
        patience = PATIENCE;
    }

    /** How many work-groups a launch has at most. */
    int mostGroups() {
        return mostGroups;
    }

    /** Sets how many work-groups a launch has at most, which has no effect on results. */
    void mostGroups(int groups) {
        mostGroups = groups;
    }

    /** Whether steps of a world can be made: it has one level. */
    static boolean suits(GridLevels levels) {
        return levels.usedCount == 1;
    }

    void run(GridLevels levels, int circles, int count) {
        rows = levels.rowCount[levels.used[0]];
        int groups = Math.max(1, Math.min(mostGroups, Math.min(circles / LEAST_SHARE, rows / LEAST_ROWS)));
        steps.arg(DeviceArrays.COUNT, count)
                .arg(DeviceArrays.COUNT + 1, groups + missing)
                .arg(DeviceArrays.COUNT + 2, patience)
                .run(groups, 1);
    }

    /** Takes note that a launch was called off. */
    void calledOff() {
        LOG.log(
                System.Logger.Level.WARNING,
                "{0} work-groups of World did not run at once, as they should on so many compute units; it goes on with one",
                mostGroups);
        mostGroups = 1;
        waitForAll();
    }

    /** Counts the contacts of each circle, after a step by lanes; ranks are all zeros before. */
    void countDegrees() {
        degrees.run(rows);
    }
}
