package io.github.circles2d.world.device.plan;

import io.github.circles2d.opencl.Device;
import io.github.circles2d.opencl.Kernel;
import io.github.circles2d.opencl.KernelSource;
import io.github.circles2d.world.device.memory.DeviceArray;
import io.github.circles2d.world.device.memory.EventArrays;
import io.github.circles2d.world.device.memory.StageKernels;
import io.github.circles2d.world.device.memory.TileRecord;
import io.github.circles2d.world.device.memory.TouchArrays;
import java.util.List;
import java.util.Locale;
import java.util.Set;

/**
 * One launch for many steps, by {@link Tiles}, if the world is not too large; {@code kernels/world/persistent_gpu/PersistentGpu.cl}. A
 * launch costs the host several microseconds, and a barrier over resident work-groups costs one or two. In a large world each
 * work-group has several tiles, and barriers cost more than launches.
 */
public final class PersistentGpu implements Plan {
    /** Worlds of more circles use a launch a pass: with several tiles a work-group the barriers cost more than launches. */
    private static final int MOST_CIRCLES = 32_000;

    /** Work-items of a work-group. */
    private static final int GROUP = StageKernels.SMALL_GROUPS ? TileRecord.GROUP : 256;

    private final TileSizes sizes;
    private Stages stages;
    private Kernel steps;

    /** Null if steps do not record what contacts do. */
    private Kernel tell;

    private int mostGroups;

    PersistentGpu(TileSizes sizes) {
        this.sizes = sizes;
    }

    /** Whether a device is known to run work-groups that wait for each other; {@code kernels/world/shared/DeviceBarrier.cl}. */
    public static boolean groupsWait(Device device) {
        return device.vendor().toUpperCase(Locale.ROOT).contains("NVIDIA");
    }

    /** Work-groups that surely run at once, or 1: that a unit runs two depends on registers, and one that does not run is waited for. */
    static int mostGroups(Device device) {
        return groupsWait(device) ? device.computeUnits() : 1;
    }

    @Override
    public List<String> files() {
        return List.of("world/persistent_gpu/PersistentGpu.cl");
    }

    @Override
    public KernelSource define(KernelSource source) {
        return source.define("RESIDENT_GROUP", GROUP);
    }

    @Override
    public boolean usesTileArrays() {
        return true;
    }

    /** It takes the kernel that tells of contacts from {@link Tiles}. */
    @Override
    public Set<String> ownKernels() {
        return Set.of("persistentGpu_steps");
    }

    @Override
    public void load(Stages shared) {
        stages = shared;
        steps = stages.kernel("persistentGpu_steps");
        tell = stages.recording() ? stages.kernel("touches_tellByTile") : null;
        mostGroups = mostGroups(stages.device());
    }

    @Override
    public boolean suits(Steps wanted) {
        return !wanted.sleeping()
                && !wanted.bodies()
                && !wanted.thinning()
                && wanted.circles() <= MOST_CIRCLES
                && sizes.suitTogether(wanted);
    }

    @Override
    public void enqueue(Steps wanted) {
        sizes.choose(wanted, mostGroups);
        stages.prepare(sizes, wanted);
        stages.begin(wanted, true);
        int needed = Math.max(sizes.tiles(), (wanted.circles() + GROUP - 1) / GROUP);
        int groups = Math.min(needed, mostGroups);
        steps.arg(StageKernels.own(0), wanted.count());
        if (stages.recording()) {
            stages.tell(steps, 1)
                    .arg(StageKernels.own(1 + TouchArrays.ARGUMENTS + EventArrays.ARGUMENTS), wanted.sensing() ? 1 : 0);
        }
        steps.run((long) groups * GROUP, GROUP);
    }

    @Override
    public boolean decidesEvents(Steps wanted) {
        return wanted.recording() && !wanted.sensing();
    }

    @Override
    public boolean tells() {
        return true;
    }

    @Override
    public void tell(int circles) {
        stages.tell(tell, 0).run((long) sizes.tiles() * TileRecord.GROUP, TileRecord.GROUP);
    }

    @Override
    public void countDegrees(int contacts) {
        stages.countDegrees(DeviceArray.ORDERED, contacts);
    }
}
