package io.github.circles2d.world.device.memory;

import io.github.circles2d.opencl.KernelSource;
import io.github.circles2d.opencl.ReachableNames;
import io.github.circles2d.world.device.memory.DeviceArray.Index;
import io.github.circles2d.world.model.Features;
import java.util.Arrays;
import java.util.BitSet;
import java.util.List;
import java.util.Set;

/** The buffers that the stages' kernels take as arguments, in their order: arrays of their own, then blocks of arrays. */
final class DeviceArguments {
    /** The arrays that are arguments of their own. */
    static final List<DeviceArray> ARRAYS = Arrays.stream(DeviceArray.values())
            .filter(array -> array.index().block() == null && array.isHeld(Features.NONE))
            .toList();

    /** The blocks. */
    static final List<Index> BLOCKS =
            Arrays.stream(Index.values()).filter(index -> index.block() != null).toList();

    /** Number of buffers. */
    static final int COUNT = ARRAYS.size() + BLOCKS.size();

    private DeviceArguments() {}

    /** Of the buffer in which an array lies. */
    static int position(DeviceArray array) {
        Index index = array.index();
        if (index.block() != null) {
            return position(index);
        }
        return ARRAYS.indexOf(array.isHeld(Features.NONE) ? array : DeviceArray.KIND_MOTION);
    }

    /** The names of a source as {@link #used} needs them. */
    static ReachableNames names(KernelSource source) {
        return ReachableNames.of(source, WorldTables.MACROS_OF_ALL_ARRAYS);
    }

    /** The positions of the buffers that a stage's kernel may use: a launch costs a driver time for each. */
    static BitSet used(ReachableNames names, String kernel) {
        Set<String> reached = names.from(kernel);
        BitSet used = new BitSet(COUNT);
        used.set(position(DeviceArray.CONSTANTS)); // the initialiser reads them
        for (DeviceArray array : DeviceArray.values()) {
            if (reached.contains(array.kernelName())) {
                used.set(position(array));
            }
        }
        return used;
    }

    static int position(Index block) {
        return ARRAYS.size() + BLOCKS.indexOf(block);
    }
}
