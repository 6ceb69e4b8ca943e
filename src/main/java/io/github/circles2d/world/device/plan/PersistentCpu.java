package io.github.circles2d.world.device.plan;

import io.github.circles2d.opencl.Device;
import io.github.circles2d.opencl.Kernel;
import io.github.circles2d.opencl.KernelSource;
import io.github.circles2d.world.device.memory.StageKernels;
import io.github.circles2d.world.device.memory.Status;
import io.github.circles2d.world.device.memory.StatusWord;
import io.github.circles2d.world.model.GridLevels;
import java.util.List;

/**
 * One launch for many steps on a processor; {@code kernels/world/persistent_cpu/Lanes.cl}, and {@code MixedLanes.cl} if circles are of
 * several levels. The launch has as many work-groups of one work-item as the processor has threads, and they wait for each other. If
 * they do not run at the same time, the launch says so and changes nothing; later launches have one work-group. If they wait for long
 * because other programs have the processors, there are fewer for a while ({@link Headcount}). Crowds are thinned out in the same launch; those
 * that are too close for it, with thousands of pairs in 2 x 2 cells, are left to another plan for a while.
 */
public final class PersistentCpu implements Plan {
    /** Circles that a work-group has at least: with fewer, waiting for each other costs more than it saves. */
    private static final int LEAST_SHARE = 512;

    /** Rows of cells that a work-group needs at least. */
    private static final int LEAST_ROWS = 8;

    /** Columns that a level has at least: kernels number the rows of all levels as if each had no more. */
    private static final int LEAST_COLUMNS = 4;

    /** Crowds are tried again after so many calls for the state, since one was too close. */
    private static final int RETRY = 256;

    private final WorkGroups workGroups;
    private Stages stages;
    private Kernel steps;
    private Kernel mixedSteps;
    private Kernel degrees;

    /** Work-groups that the last launch could have had use for, and those that it had. */
    private int useful;

    private int groups;

    /** Work-items that count the contacts of the last launch. */
    private int countingItems;

    /** The sums of times that the status told last. */
    private int tookBefore;

    private int waitedBefore;

    /** How many more calls for the state crowds are left to another plan. */
    private int withoutCrowds;

    public PersistentCpu(WorkGroups workGroups) {
        this.workGroups = workGroups;
    }

    /** Whether a device can run it: a processor, on which one work-item is as good as many. */
    public static boolean fits(Device device) {
        return device.kind() == Device.Kind.CPU;
    }

    @Override
    public List<String> files() {
        return List.of("world/persistent_cpu/Lanes.cl", "world/persistent_cpu/MixedLanes.cl");
    }

    /** Stages that kernels by lanes share with others call theirs. */
    @Override
    public KernelSource define(KernelSource source) {
        return source.define("BY_LANES", 1);
    }

    @Override
    public void load(Stages shared) {
        stages = shared;
        steps = stages.kernel("persistentCpu_steps");
        mixedSteps = stages.kernel("persistentCpu_mixedSteps");
        degrees = stages.kernel("persistentCpu_degrees");
    }

    @Override
    public boolean suits(Steps wanted) {
        return !wanted.thinning() || withoutCrowds == 0;
    }

    @Override
    public void enqueue(Steps wanted) {
        stages.begin(wanted, false);
        GridLevels levels = wanted.levels();
        int rows = 0;
        for (int l = 0; l < levels.usedCount; l++) {
            rows = Math.max(rows, levels.rowCount[levels.used[l]]);
        }
        useful = Math.max(1, Math.min(wanted.circles() / LEAST_SHARE, rows / LEAST_ROWS));
        groups = Math.min(workGroups.most(), useful);
        countingItems = levels.buckets() / LEAST_COLUMNS + groups;
        stages.record(wanted.haveOneLevel() ? steps : mixedSteps, 4)
                .arg(StageKernels.own(0), wanted.count())
                .arg(StageKernels.own(1), workGroups.awaited(groups))
                .arg(StageKernels.own(2), workGroups.patience())
                .arg(StageKernels.own(3), workGroups.mostWaiting())
                .run(groups, 1);
    }

    @Override
    public void stepped(Status status, int made) {
        int took = status.get(StatusWord.TOOK);
        int waited = status.get(StatusWord.WAITED);
        workGroups.learn(groups, useful, made, took - tookBefore, waited - waitedBefore);
        tookBefore = took;
        waitedBefore = waited;
        if (status.has(StatusWord.TOO_CLOSE)) {
            withoutCrowds = RETRY;
        }
    }

    @Override
    public void learn(TileUse use, boolean thinning) {
        if (thinning && withoutCrowds > 0) {
            withoutCrowds--;
        }
    }

    @Override
    public void countDegrees(int contacts) {
        degrees.arg(StageKernels.own(0), groups).run(countingItems);
    }

    /** The fullest band says how much room is needed, which is no sign of a crowd; kernels tell of crowds by themselves. */
    @Override
    public boolean wantOfRoomTellsOfCrowds() {
        return false;
    }

    @Override
    public void calledOff() {
        workGroups.calledOff();
    }
}
