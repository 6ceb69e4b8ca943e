package io.github.circles2d.world;

import java.util.Arrays;

/** Pairs that one thread found: for each the slots of the lower and of the higher id, the group, and the rank in the group. */
final class FoundPairs {
    /** Ints a pair. */
    static final int STRIDE = 4;

    /** Number of pairs; more than there is room for where the list was given up. */
    int count;

    /** Number of pairs whose distance was tested. */
    long tested;

    /** By pair: {@link #STRIDE} ints. */
    int[] records = new int[STRIDE * 256];

    /** Number of pairs from which on the list is given up. */
    int room;

    /** Whether only a share of the pairs of a crowd is kept. */
    boolean thinned;

    /** Greatest number of candidates of one circle, of those whose contacts this thread has filled last. */
    int most;

    /** By group that is being filled: its next contact. */
    final int[] next = new int[JvmContacts.TOGETHER];

    /** By group that is being filled: the end of its contacts. */
    final int[] end = new int[JvmContacts.TOGETHER];

    /** Circles near enough to the one that is looked at, a block at a time. */
    final int[] hits = new int[64];

    void reset(boolean keepsAShare, int newRoom) {
        thinned = keepsAShare;
        room = newRoom;
        count = 0;
        tested = 0;
        most = 0;
    }

    /** Keeps a pair, which has been counted. */
    void add(int lo, int hi, int group, int rank) {
        int k = STRIDE * (count - 1);
        if (k == records.length) {
            records = Arrays.copyOf(records, 2 * records.length);
        }
        records[k] = lo;
        records[k + 1] = hi;
        records[k + 2] = group;
        records[k + 3] = rank;
    }

    /** Memory of the arrays. */
    long bytes() {
        return 4L * records.length;
    }
}
