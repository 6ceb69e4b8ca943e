package io.github.circles2d.world.circles;

import java.nio.Buffer;
import java.nio.ByteBuffer;
import java.nio.FloatBuffer;
import java.nio.IntBuffer;

/**
 * Copies between arrays and places of buffers, whose position and limit stay. Android 13 has no such calls of buffers, and none that
 * return a buffer's own type, as {@code FloatBuffer.clear()} does. So the JVM back end calls those of {@link Buffer}.
 */
public final class BulkCopies {
    private BulkCopies() {}

    /** Copies elements of a buffer, from the first on, to the start of an array. */
    public static void get(FloatBuffer from, float[] to, int length) {
        Buffer buffer = from;
        int position = buffer.position();
        buffer.position(0);
        from.get(to, 0, length);
        buffer.position(position);
    }

    /** Copies the first elements of an array to the start of a buffer. */
    public static void put(FloatBuffer to, float[] from, int length) {
        Buffer buffer = to;
        int position = buffer.position();
        buffer.position(0);
        to.put(from, 0, length);
        buffer.position(position);
    }

    /** Copies elements within a buffer to a lower place, through an array of any length but 0. */
    static void moveDown(FloatBuffer values, int from, int to, int length, float[] through) {
        Buffer buffer = values;
        int position = buffer.position();
        for (int done = 0; done < length; done += through.length) {
            int some = Math.min(through.length, length - done);
            buffer.position(from + done);
            values.get(through, 0, some);
            buffer.position(to + done);
            values.put(through, 0, some);
        }
        buffer.position(position);
    }

    /** Copies elements of a buffer to a place in an array. */
    public static void get(IntBuffer from, int first, int[] to, int at, int length) {
        Buffer buffer = from;
        int position = buffer.position();
        buffer.position(first);
        from.get(to, at, length);
        buffer.position(position);
    }

    /** Fills an array with the first bytes of a buffer. */
    public static void get(ByteBuffer from, byte[] to) {
        Buffer buffer = from;
        int position = buffer.position();
        buffer.position(0);
        from.get(to);
        buffer.position(position);
    }
}
