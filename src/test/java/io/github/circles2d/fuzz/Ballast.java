package io.github.circles2d.fuzz;

import java.util.Random;

/** Fills the heap but for some bytes. It works in a JVM that has one small heap for little else. */
final class Ballast implements MemoryEnd {
    private static final int MOST_SPARE = 18;

    private static final int LARGEST = 1 << 20;
    private static final int LEAST = 256;

    /** Each size that is tried costs a collection. */
    private static final int STEP = 64;

    /** Room for all pieces, so that holding one takes no memory. */
    private final byte[][] pieces = new byte[1 << 16][];

    private int count;

    /** Once for a call, of three at one. */
    @Override
    public void begin(Random random, int attempt) {
        if (attempt == 0 && random.nextInt(3) == 0) {
            fill(1 << random.nextInt(MOST_SPARE));
        }
    }

    /** Fills the heap. As much as the spare bytes stays free, and what the collector does not find at once. */
    void fill(int spare) {
        byte[] reserve = new byte[spare];
        for (int size = LARGEST; size >= LEAST && count < pieces.length; ) {
            byte[] piece = allocate(size);
            if (piece == null) {
                size /= STEP;
            } else {
                pieces[count++] = piece;
            }
        }
        if (reserve.length != spare) { // it is held until here
            throw new IllegalStateException();
        }
    }

    private static byte[] allocate(int size) {
        try {
            return new byte[size];
        } catch (OutOfMemoryError e) {
            return null;
        }
    }

    @Override
    public boolean end() {
        boolean isFull = count > 0;
        for (int k = 0; k < count; k++) {
            pieces[k] = null;
        }
        count = 0;
        return isFull;
    }
}
