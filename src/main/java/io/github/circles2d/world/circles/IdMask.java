package io.github.circles2d.world.circles;

import java.nio.FloatBuffer;
import java.util.Arrays;

/**
 * A set of ids, and what it says of values that lie by id: which of them are those of a circle. It has a bit for each id: id k is
 * bit k % 64 of word k / 64.
 */
public final class IdMask {
    private static final int WORD_SHIFT = 6;
    private static final int IDS_IN_WORD = 1 << WORD_SHIFT;

    /** Values from which on a bulk copy is faster than one by one. */
    private static final int LONG_RUN = 64;

    /** What a bulk copy goes through. */
    private float[] moving = new float[0];

    private long[] words = new long[0];
    private int end;

    public static int words(int end) {
        return (end + IDS_IN_WORD - 1) >>> WORD_SHIFT;
    }

    /** Makes room for {@link #copy}; the ids stay. If there is none, nothing has changed. */
    public void makeRoom(HandleTable handles) {
        if (words.length < words(handles.end())) {
            words = Arrays.copyOf(words, words(handles.end()) * 3 / 2);
        }
    }

    public void copy(HandleTable handles) {
        words = handles.copyLiving(words);
        end = handles.end();
    }

    /** More than all ids that may be in the set. */
    public int end() {
        return end;
    }

    public boolean has(int id) {
        return id < end && (words[id >>> WORD_SHIFT] >>> id & 1) != 0;
    }

    /** Takes an id out, if it is in the set. */
    void remove(int id) {
        if (id < end) {
            words[id >>> WORD_SHIFT] &= ~(1L << id);
        }
    }

    /** Further elements become 0. */
    public void copyTo(long[] to) {
        int used = words(end);
        System.arraycopy(words, 0, to, 0, used);
        Arrays.fill(to, used, to.length, 0);
    }

    /** Moves the values of the ids in the set together, in place, each elements an id. If there is too little memory, none has moved. */
    public void closeGaps(FloatBuffer values, int each) {
        if (moving.length == 0) {
            moving = new float[1024];
        }
        int written = 0;
        for (int id = 0; id < end; ) {
            if (!has(id)) {
                id++;
                continue;
            }
            int first = id;
            while (has(id)) {
                id++;
            }
            int length = (id - first) * each;
            move(values, first * each, written, length);
            written += length;
        }
    }

    private void move(FloatBuffer values, int from, int to, int length) {
        if (from == to) {
            return;
        }
        if (length >= LONG_RUN) {
            BulkCopies.moveDown(values, from, to, length, moving);
        } else {
            for (int k = 0; k < length; k++) {
                values.put(to + k, values.get(from + k));
            }
        }
    }

    /** The values of other ids become NaN. */
    public void markGaps(FloatBuffer values, int each) {
        for (int word = 0; word < words(end); word++) {
            for (long free = ~words[word]; free != 0; free &= free - 1) {
                int id = (word << WORD_SHIFT) + Long.numberOfTrailingZeros(free);
                for (int k = each * id; k < each * (id + 1) && id < end; k++) {
                    values.put(k, Float.NaN);
                }
            }
        }
    }

    /** The inverse of {@link #closeGaps}: values of other ids become NaN. */
    public void spread(float[] values, int each, int count) {
        Arrays.fill(values, each * end, values.length, Float.NaN);
        int k = each * count;
        for (int id = end - 1; k < each * (id + 1); id--) {
            if (has(id)) {
                k -= each;
                System.arraycopy(values, k, values, each * id, each);
            } else {
                Arrays.fill(values, each * id, each * (id + 1), Float.NaN);
            }
        }
    }
}
