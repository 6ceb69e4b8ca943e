package io.github.circles2d.world.jvm.solver;

import io.github.circles2d.world.jvm.grid.NearSlots;
import java.util.Arrays;

/** The cross contacts that one worker found. */
final class FoundCross {
    private static final int SHORT = 24;

    /** By contact: the slot of the light circle. */
    int[] light = new int[64];

    /** By contact: its place among those of its light circle. */
    int[] rank = new int[64];

    /** By contact: id and slot of the heavy circle, one above the other. */
    long[] heavy = new long[64];

    int count;

    /** Number of contacts from which on they are given up. */
    private int room;

    /** Whether they were given up. */
    boolean overflowed;

    /** Greatest number of candidates of one circle so far. */
    int most;

    /** Pairs whose distance was tested. */
    long tested;

    /** Whether in some contact the coarser circle is the light one: then no one has put all of its contacts in order. */
    boolean anyFromFiner;

    /** Heavy circles among the slots of the worker. */
    int heavyCircles;

    /** The circles near the one that is looked at. */
    final NearSlots near = new NearSlots();

    void begin(int newRoom) {
        room = newRoom;
        overflowed = false;
        count = 0;
        most = 0;
        tested = 0;
        anyFromFiner = false;
        heavyCircles = 0;
        near.count = 0;
    }

    long bytes() {
        return 16L * heavy.length + 4L * near.slots.length;
    }

    /** Adds a contact of the circle that is looked at. */
    void add(int lightSlot, long heavyIdAndSlot) {
        if (count == room) {
            overflowed = true;
            return;
        }
        if (count == light.length) {
            rank = Arrays.copyOf(rank, 2 * count);
            heavy = Arrays.copyOf(heavy, 2 * count);
            light = Arrays.copyOf(light, 2 * count);
        }
        light[count] = lightSlot;
        heavy[count++] = heavyIdAndSlot;
    }

    /** Adds a contact in which the circle that is looked at is the heavy one. */
    void addFromFiner(int lightSlot, long heavyIdAndSlot, int itsRank) {
        anyFromFiner = true;
        add(lightSlot, heavyIdAndSlot);
        if (!overflowed) {
            rank[count - 1] = itsRank;
        }
    }

    /** Puts the last contacts, which are of one light circle, in the order of the heavy ones' ids. */
    void sort(int from) {
        if (count - from > SHORT) {
            Arrays.sort(heavy, from, count);
            return;
        }
        for (int k = from + 1; k < count; k++) {
            long key = heavy[k];
            int p = k;
            while (p > from && heavy[p - 1] > key) {
                heavy[p] = heavy[p - 1];
                p--;
            }
            heavy[p] = key;
        }
    }

    /** Numbers the last contacts, which are of one light circle. */
    void rank(int from, int first) {
        for (int k = from; k < count; k++) {
            rank[k] = first + (k - from);
        }
    }
}
