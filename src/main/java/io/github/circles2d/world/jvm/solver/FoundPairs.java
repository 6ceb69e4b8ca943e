package io.github.circles2d.world.jvm.solver;

import io.github.circles2d.world.jvm.state.HeapSort;
import io.github.circles2d.world.model.GridLevels;
import java.util.Arrays;

/**
 * The pairs that one worker found, in the order of their contacts. The pairs of a few groups wait in other arrays until their order
 * is known.
 */
final class FoundPairs {
    /** Groups whose contacts are laid out together. */
    static final int TOGETHER = 16;

    private static final int SHORT = 24;

    /** Number of pairs in order. */
    int count;

    /** By pair: ids, lower above higher. */
    long[] ids = new long[256];

    /** By pair: slots, in the same order as the ids. */
    long[] slots = new long[256];

    /** Number of pairs whose distance was tested. */
    long tested;

    /** Number of pairs from which on the list is given up. */
    private int room;

    /** Whether the list was given up. */
    boolean overflowed;

    /** Greatest number of candidates of one circle, of those that this worker has counted or whose contacts it has filled last. */
    int most;

    /** By level in use: number of the first pair; one more element for the end. */
    final int[] ofLevel = new int[GridLevels.COUNT + 1];

    private long[] gatheredIds = new long[256];
    private long[] gatheredSlots = new long[256];

    private int gathered;

    /** By gathered group: the first of its pairs; one more element for the end. */
    private final int[] groupStart = new int[TOGETHER + 1];

    /** By gathered group that is not empty: the next of its pairs. */
    private final int[] next = new int[TOGETHER];

    /** By gathered group that is not empty: the end of its pairs. */
    private final int[] end = new int[TOGETHER];

    private int groups;

    // ---- what KeptPairs works with

    /** By which distance pairs may be farther apart than contacts, and whether all such pairs are gathered; 0 for contacts alone. */
    float slack;

    /** Kept pairs of this step and of the one before, as {@link #ids}. */
    long[] kept = new long[256];

    long[] keptBefore = new long[256];
    int keptCount;

    /** Spans of this step: all, those whose pairs are kept, and those of them that were kept before. */
    int spans;

    int spansKept;
    int spansUsed;

    /** What {@link Pairs} works with. */
    final long[] hits = Pairs.newHits();

    void reset(int newRoom) {
        room = newRoom;
        overflowed = false;
        count = 0;
        gathered = 0;
        groups = 0;
        tested = 0;
        most = 0;
    }

    /** Gathers a pair of the group that is being found. */
    void gather(int slot, int id, int other, int otherId) {
        if (gathered == gatheredIds.length) {
            gatheredSlots = Arrays.copyOf(gatheredSlots, 2 * gathered);
            gatheredIds = Arrays.copyOf(gatheredIds, 2 * gathered);
        }
        // exchanged where the other has the lower id; no branch, which would be taken as if by chance
        int exchange = (slot ^ other) & (otherId - id >> 31);
        gatheredIds[gathered] = (long) Math.min(id, otherId) << 32 | Math.max(id, otherId);
        gatheredSlots[gathered++] = (long) (slot ^ exchange) << 32 | (other ^ exchange);
        overflowed |= count + gathered > room;
    }

    /** Ends a group: its pairs are put in order of their ids. */
    void endGroup() {
        int from = groupStart[groups];
        if (gathered == from) {
            return;
        }
        sort(from, gathered);
        groupStart[++groups] = gathered;
        if (groups == TOGETHER) {
            flush();
        }
    }

    private void sort(int from, int to) {
        if (to - from > SHORT) {
            HeapSort.longs(gatheredIds, gatheredSlots, from, to);
            return;
        }
        for (int k = from + 1; k < to; k++) {
            long id = gatheredIds[k];
            long slot = gatheredSlots[k];
            int p = k;
            while (p > from && gatheredIds[p - 1] > id) {
                gatheredIds[p] = gatheredIds[p - 1];
                gatheredSlots[p] = gatheredSlots[p - 1];
                p--;
            }
            gatheredIds[p] = id;
            gatheredSlots[p] = slot;
        }
    }

    /** The first pair of each group, then the second of each: groups share no circle, so a processor works on neighbours at once. */
    void flush() {
        ensure(count + gathered);
        int open = begin();
        while (open > 0) {
            int left = 0;
            for (int k = 0; k < open; k++) {
                int from = next[k];
                ids[count] = gatheredIds[from];
                slots[count++] = gatheredSlots[from];
                if (from + 1 < end[k]) {
                    next[left] = from + 1;
                    end[left++] = end[k];
                }
            }
            open = left;
        }
        gathered = 0;
        groups = 0;
    }

    /** Begins a step in which pairs are kept. */
    void beginKeeping() {
        long[] list = kept;
        kept = keptBefore;
        keptBefore = list;
        keptCount = 0;
        spans = 0;
        spansKept = 0;
        spansUsed = 0;
    }

    /** Keeps pairs of another list. */
    void keep(long[] list, int from, int to) {
        ensureKept(keptCount + to - from);
        System.arraycopy(list, from, kept, keptCount, to - from);
        keptCount += to - from;
    }

    /** As {@link #endGroup}, of one of a few groups whose pairs are kept. */
    void endKeptGroup() {
        int from = groupStart[groups];
        if (gathered > from) {
            sort(from, gathered);
            groupStart[++groups] = gathered;
        }
    }

    /** As {@link #flush}, of groups whose pairs are kept. */
    void flushKept() {
        ensureKept(keptCount + gathered);
        int open = begin();
        while (open > 0) {
            int left = 0;
            for (int k = 0; k < open; k++) {
                int from = next[k];
                kept[keptCount++] = gatheredIds[from];
                if (from + 1 < end[k]) {
                    next[left] = from + 1;
                    end[left++] = end[k];
                }
            }
            open = left;
        }
        gathered = 0;
        groups = 0;
    }

    private void ensureKept(int pairs) {
        if (pairs > kept.length) {
            kept = Arrays.copyOf(kept, Math.max(pairs, kept.length + (kept.length >> 1)));
        }
    }

    /** Notes whether there is still room. */
    void noteRoom() {
        overflowed |= count > room;
    }

    /** Begins to take pairs of each group in turn; returns the number of groups. */
    private int begin() {
        for (int k = 0; k < groups; k++) {
            next[k] = groupStart[k];
            end[k] = groupStart[k + 1];
        }
        return groups;
    }

    void ensure(int pairs) {
        if (pairs > ids.length) {
            int c = Math.max(pairs, ids.length + (ids.length >> 1));
            slots = Arrays.copyOf(slots, c);
            ids = Arrays.copyOf(ids, c);
        }
    }

    long bytes() {
        return 16L * (ids.length + gatheredIds.length) + 8L * (kept.length + keptBefore.length);
    }
}
