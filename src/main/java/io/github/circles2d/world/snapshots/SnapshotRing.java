package io.github.circles2d.world.snapshots;

import io.github.circles2d.world.circles.WorldParameters;
import java.nio.Buffer;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;

/**
 * The states of the last frames, as {@link SnapshotCodec} writes them, but without checks: nobody else has the bytes. The numbers of
 * frames ascend. Memory of a frame that has gone is used for the next.
 */
public final class SnapshotRing {
    /** A frame gets a share of one over this more than its bytes, so that a pile that grows does not need new memory each time. */
    private static final int SPARE = 32;

    // By place. The oldest frame is at the place first, and the others follow it in a circle.
    private final ByteBuffer[] bytes;
    private final WorldParameters[] parameters;
    private final int[] number;

    private int first;
    private int size;

    /** Without frames, and without memory for them. */
    public SnapshotRing(int frames) {
        bytes = new ByteBuffer[frames];
        parameters = new WorldParameters[frames];
        number = new int[frames];
    }

    /** Drops all frames. */
    public void clear() {
        size = 0;
    }

    /** The number of frames. */
    public int size() {
        return size;
    }

    /** The number of a frame; 0 is the oldest. */
    public int frame(int k) {
        return number[place(k)];
    }

    private int place(int k) {
        int place = first + k;
        return place < number.length ? place : place - number.length;
    }

    /** Memory of the frames. */
    public long bytes() {
        long sum = 0;
        for (ByteBuffer buffer : bytes) {
            sum += buffer == null ? 0 : buffer.capacity();
        }
        return sum;
    }

    public boolean has(int frame) {
        int k = search(frame);
        return k < size && frame(k) == frame;
    }

    /** The place of a frame. */
    public int find(int frame) {
        int k = search(frame);
        if (k == size || frame(k) != frame) {
            throw new IllegalArgumentException(
                    "frame " + frame + " is not there: " + (size == 0 ? "no frame has been saved" : describe()));
        }
        return place(k);
    }

    private String describe() {
        String range = frame(0) + " to " + frame(size - 1);
        boolean gaps = (long) frame(size - 1) - frame(0) >= size;
        return gaps ? "there are " + size + " of the frames from " + range : "there are the frames from " + range;
    }

    /** How many frames have lower numbers. */
    private int search(int frame) {
        int low = 0;
        int high = size;
        while (low < high) {
            int middle = (low + high) >>> 1;
            if (frame(middle) < frame) {
                low = middle + 1;
            } else {
                high = middle;
            }
        }
        return low;
    }

    /**
     * Saves an encoded state and its parameters. Frames from its number on go, and the oldest one if there is no place. If memory is short, nothing
     * changes.
     */
    public void save(int frame, ByteBuffer state, WorldParameters itsParameters) {
        int before = search(frame);
        int place = place(before);
        int length = state.limit();
        if (bytes[place] == null || bytes[place].capacity() < length) {
            bytes[place] = room(length);
        }
        if (before == number.length) {
            first = place(1);
            before--;
        }
        ((Buffer) bytes[place]).clear();
        bytes[place].put(state.array(), 0, length);
        ((Buffer) bytes[place]).flip();
        parameters[place] = itsParameters;
        number[place] = frame;
        size = before + 1;
    }

    private static ByteBuffer room(int length) {
        int more = (int) Math.min(Integer.MAX_VALUE - 8L, length + (long) length / SPARE);
        return ByteBuffer.allocate(more).order(ByteOrder.LITTLE_ENDIAN);
    }

    /** Reads the frame of a place. */
    public void load(int place, SavedState s) {
        ((Buffer) bytes[place]).rewind();
        SnapshotCodec.decode(bytes[place], s, parameters[place]);
    }
}
