package io.github.circles2d.thesis;

import io.github.circles2d.opencl.Device;
import io.github.circles2d.opencl.DeviceMemoryException;

/** The device memory of a simulation, known before anything is allocated. Immutable. */
public final class MemoryNeed {
    /** Bytes of a minimum translation vector, and of a pair in a table. */
    static final long SLOT_BYTES = 8;

    static final long GRAVITY_BYTES = 8;

    private final PairStrategy strategy;
    private final int circles;
    private final long totalBytes;
    private final long largestBufferBytes;

    private MemoryNeed(PairStrategy strategy, int circles) {
        this.strategy = strategy;
        this.circles = circles;
        long bodies = bodyBytes(circles);
        long collisions = collisionBytes(circles);
        long table = strategy.tableBytes(circles);
        totalBytes = bodies + velocityBytes(circles) + GRAVITY_BYTES + collisions + table;
        largestBufferBytes = Math.max(bodies, Math.max(collisions, table));
    }

    /** Computes the need of a strategy, which may have a table, for a number of circles. */
    public static MemoryNeed of(PairStrategy strategy, int circles) {
        return new MemoryNeed(strategy, circles);
    }

    /**
     * Throws if it does not fit; the message says how many bytes are needed, how many there are, and how many circles
     * would fit.
     */
    public void requireRoom(Device device, long freeBytes) {
        if (fits(device, freeBytes)) {
            return;
        }
        String limit = circles > PairSlots.MAX_CIRCLES
                ? "; besides, an int can number the slots of " + PairSlots.MAX_CIRCLES + " circles at most"
                : "";
        throw new DeviceMemoryException(
                circles + " circles need " + totalBytes + " bytes of device memory, of which " + largestBufferBytes
                        + " in one buffer; " + device.name() + " has " + freeBytes + " bytes free and allows "
                        + device.maxBufferBytes() + " in one buffer" + limit + "; " + mostThatFit(device, freeBytes)
                        + " circles would fit",
                totalBytes,
                Math.min(freeBytes, device.maxBufferBytes()));
    }

    static long bodyBytes(int circles) {
        return (long) CircleList.BODY * Float.BYTES * circles;
    }

    static long velocityBytes(int circles) {
        return (long) CircleList.VELOCITY * Float.BYTES * circles;
    }

    static long collisionBytes(int circles) {
        return SLOT_BYTES * PairSlots.count(circles);
    }

    /** Whether it fits into what is free of a device. */
    public boolean fits(Device device, long freeBytes) {
        return circles <= PairSlots.MAX_CIRCLES
                && totalBytes <= freeBytes
                && largestBufferBytes <= device.maxBufferBytes();
    }

    /** The need grows with the number of circles, so the greatest number that fits can be searched for. */
    private int mostThatFit(Device device, long freeBytes) {
        int fitting = 0;
        int tooMany = PairSlots.MAX_CIRCLES + 1;
        while (tooMany - fitting > 1) {
            int middle = (fitting + tooMany) >>> 1;
            if (of(strategy, middle).fits(device, freeBytes)) {
                fitting = middle;
            } else {
                tooMany = middle;
            }
        }
        return fitting;
    }
}
