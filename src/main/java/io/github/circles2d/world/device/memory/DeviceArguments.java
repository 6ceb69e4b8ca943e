package io.github.circles2d.world.device.memory;

import io.github.circles2d.world.device.memory.DeviceArray.Index;
import io.github.circles2d.world.model.Features;
import java.util.ArrayList;
import java.util.List;

/** The buffers that the stages' kernels take as arguments, in their order: arrays of their own, then blocks of arrays. */
final class DeviceArguments {
    /** The arrays that are arguments of their own. */
    static final List<DeviceArray> ARRAYS = arrays();

    /** The blocks. */
    static final List<Index> BLOCKS = blocks();

    /** Number of buffers. */
    static final int COUNT = ARRAYS.size() + BLOCKS.size();

    private DeviceArguments() {}

    private static List<DeviceArray> arrays() {
        List<DeviceArray> arrays = new ArrayList<>();
        for (DeviceArray array : DeviceArray.values()) {
            if (array.index().block() == null && array.isHeld(Features.NONE)) {
                arrays.add(array);
            }
        }
        return arrays;
    }

    private static List<Index> blocks() {
        List<Index> blocks = new ArrayList<>();
        for (Index index : Index.values()) {
            if (index.block() != null) {
                blocks.add(index);
            }
        }
        return blocks;
    }

    /** Of the buffer in which an array lies. */
    static int position(DeviceArray array) {
        Index index = array.index();
        if (index.block() != null) {
            return position(index);
        }
        return ARRAYS.indexOf(array.isHeld(Features.NONE) ? array : DeviceArray.KIND_MOTION);
    }

    static int position(Index block) {
        return ARRAYS.size() + BLOCKS.indexOf(block);
    }
}
