package io.github.circles2d.world.device.memory;

import io.github.circles2d.opencl.KernelSource;
import io.github.circles2d.opencl.ReachableNames;
import java.util.BitSet;
import java.util.Set;

/** Finds out which of the buffers of {@link DeviceArguments} a stage's kernel may use: a launch costs a driver time for each. */
final class UsedArguments {
    private final ReachableNames names;

    UsedArguments(ReachableNames names) {
        this.names = names;
    }

    /** The names of a source as this class needs them. */
    static ReachableNames names(KernelSource source) {
        return ReachableNames.of(source, WorldTables.MACROS_OF_ALL_ARRAYS);
    }

    /** The positions of the buffers. */
    BitSet of(String kernel) {
        Set<String> reached = names.from(kernel);
        BitSet used = new BitSet(DeviceArguments.COUNT);
        used.set(DeviceArguments.position(DeviceArray.CONSTANTS)); // the initialiser reads them
        for (DeviceArray array : DeviceArray.values()) {
            if (reached.contains(array.kernelName())) {
                used.set(DeviceArguments.position(array));
            }
        }
        return used;
    }
}
