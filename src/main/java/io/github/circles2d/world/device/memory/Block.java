package io.github.circles2d.world.device.memory;

import io.github.circles2d.opencl.DeviceBuffer;
import io.github.circles2d.opencl.Session;
import io.github.circles2d.world.device.memory.DeviceArray.Index;
import io.github.circles2d.world.model.Features;
import java.util.EnumMap;
import java.util.Map;

/** A buffer with all arrays of an index, one behind the other. */
final class Block implements AutoCloseable {
    /** Arrays begin at multiples of so many elements, so that each can be a buffer of its own, too. */
    private static final long ALIGNMENT = 1024;

    private final DeviceBuffer buffer;
    private final long stride;
    private final Features features;
    private final Map<DeviceArray, DeviceBuffer> slices = new EnumMap<>(DeviceArray.class);

    /** With the arrays of worlds with these features. */
    Block(Session session, Index index, long elements, Features features) {
        this.features = features;
        stride = (elements + ALIGNMENT - 1) / ALIGNMENT * ALIGNMENT;
        buffer = session.allocate(index.block(), index.elementBytes(features) * stride);
    }

    DeviceBuffer buffer() {
        return buffer;
    }

    /** Elements from the start of an array to that of the next. */
    int stride() {
        return Math.toIntExact(stride);
    }

    boolean has(DeviceArray array) {
        return array.isHeld(features);
    }

    DeviceBuffer get(DeviceArray array) {
        return slices.computeIfAbsent(
                array, a -> buffer.slice(a.kernelName(), a.bytesBefore(features) * stride, a.elementBytes() * stride));
    }

    @Override
    public void close() {
        slices.values().forEach(DeviceBuffer::close);
        buffer.close();
    }
}
