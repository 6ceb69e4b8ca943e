package io.github.circles2d.world.device.memory;

import java.nio.IntBuffer;

/** The host's copy of the status. */
public final class Status {
    private final int[] words = new int[StatusWord.WORDS];
    private final IntBuffer view = IntBuffer.wrap(words);

    public int get(StatusWord word) {
        return words[word.index()];
    }

    public boolean has(StatusWord word) {
        return get(word) != 0;
    }

    /** Sets words to 0, until {@link #write} on the host alone. */
    public void clear(StatusWord... cleared) {
        for (StatusWord word : cleared) {
            words[word.index()] = 0;
        }
    }

    /** Sets a word, until {@link #write} on the host alone. */
    public void set(StatusWord word, int value) {
        words[word.index()] = value;
    }

    /** Reads the status, once the device has done what has been enqueued. */
    public void read(DeviceArrays arrays) {
        arrays.get(DeviceArray.STATUS).read(view);
    }

    /** Writes all of it: Oclgrind takes the rest of a buffer that is written in part for uninitialised. */
    public void write(DeviceArrays arrays) {
        arrays.get(DeviceArray.STATUS).write(0, view);
    }
}
