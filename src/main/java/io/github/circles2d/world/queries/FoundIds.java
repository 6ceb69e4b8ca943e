package io.github.circles2d.world.queries;

import java.util.Arrays;

/** Ids that a search has found, each once, and their order. */
final class FoundIds {
    private static final int WORD_SHIFT = 6;

    /** So many words of a bit set take about as long to look at as it takes to sort one id. */
    private static final int WORDS_AN_ID = 16;

    /** Steps of a Shell sort (M. Ciura, 2001). */
    private static final int[] GAPS = {1750, 701, 301, 132, 57, 23, 10, 4, 1};

    private int[] id = new int[Capacity.atLeast(0, 0)];
    private int count;

    /** A bit for each id; all 0 between two calls. */
    private long[] bits = new long[0];

    void clear() {
        count = 0;
    }

    int count() {
        return count;
    }

    int id(int k) {
        return id[k];
    }

    void add(int found) {
        if (count == id.length) {
            id = Arrays.copyOf(id, Capacity.atLeast(count + 1, id.length));
        }
        id[count++] = found;
    }

    /** Ids are less than the limit. */
    void sort(int limit) {
        int words = (limit >>> WORD_SHIFT) + 1;
        if ((long) count * WORDS_AN_ID < words || count <= WORDS_AN_ID) {
            sortFew();
        } else {
            sortMany(words);
        }
    }

    private void sortFew() {
        for (int gap : GAPS) {
            for (int k = gap; k < count; k++) {
                int moving = id[k];
                int to = k;
                while (to >= gap && id[to - gap] > moving) {
                    id[to] = id[to - gap];
                    to -= gap;
                }
                id[to] = moving;
            }
        }
    }

    private void sortMany(int words) {
        if (bits.length < words) {
            bits = new long[Capacity.atLeast(words, bits.length)];
        }
        for (int k = 0; k < count; k++) {
            bits[id[k] >>> WORD_SHIFT] |= 1L << id[k];
        }
        int k = 0;
        for (int word = 0; word < words; word++) {
            for (long left = bits[word]; left != 0; left &= left - 1) {
                id[k++] = (word << WORD_SHIFT) + Long.numberOfTrailingZeros(left);
            }
            bits[word] = 0;
        }
    }
}
