package io.github.circles2d.world.changes;

import io.github.circles2d.world.circles.IdMask;
import java.util.Arrays;

/** The ids that a call names. */
final class IdSet {
    /** A bit for each id. */
    private long[] words = new long[0];

    /** Makes it empty, with room for ids below a limit. */
    void begin(int ids) {
        int needed = IdMask.words(ids);
        if (words.length < needed) {
            words = new long[needed + (needed >> 1)];
        } else {
            Arrays.fill(words, 0, needed, 0);
        }
    }

    /** Returns false if the id is there already. */
    boolean add(int id) {
        long bit = 1L << id;
        if ((words[id / Long.SIZE] & bit) != 0) {
            return false;
        }
        words[id / Long.SIZE] |= bit;
        return true;
    }
}
