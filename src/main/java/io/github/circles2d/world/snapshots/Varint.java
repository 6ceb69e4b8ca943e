package io.github.circles2d.world.snapshots;

import java.nio.ByteBuffer;

/**
 * Unsigned ints of one to five bytes. They take the low bits of the number first, with a bit in each byte that says whether another
 * byte follows.
 */
final class Varint {
    private static final int BITS = 7;
    private static final int MORE = 1 << BITS;
    private static final int MASK = MORE - 1;

    private Varint() {}

    static void put(ByteBuffer out, int value) {
        int rest = value;
        while ((rest & ~MASK) != 0) {
            out.put((byte) (rest | MORE));
            rest >>>= BITS;
        }
        out.put((byte) rest);
    }

    /** Reads a number of a snapshot. */
    static int get(ByteBuffer in) {
        int value = 0;
        for (int shift = 0; shift < Integer.SIZE; shift += BITS) {
            int b = Byte.toUnsignedInt(in.get());
            value |= (b & MASK) << shift;
            if (b < MORE) {
                SnapshotCodec.require(b >>> Math.min(Integer.SIZE - shift, BITS) == 0, "a number is too long");
                return value;
            }
        }
        throw new IllegalArgumentException("this is no snapshot of a world: a number is too long");
    }
}
