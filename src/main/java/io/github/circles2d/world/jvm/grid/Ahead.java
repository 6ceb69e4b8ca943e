package io.github.circles2d.world.jvm.grid;

import io.github.circles2d.world.jvm.state.State;
import io.github.circles2d.world.jvm.threads.Team;
import java.util.Arrays;

/**
 * The circles of coarser levels that continuous collision has seen near to fast ones. It looks at least as far as {@code CrossContacts}, which
 * therefore does not look in these levels again. Each worker has its own, with records in the order of slots.
 */
public final class Ahead {
    // a record, before the slots that were seen
    private static final int SLOT = 0;
    private static final int LEFT = 1;
    private static final int MANY = 2;
    private static final int HEAD = 3;

    private int[] records = new int[256];
    private int end;

    /** Where the record that is written begins. */
    private int begun;

    /** Where the record begins that is read next. */
    private int next;

    private int left;

    /** One for each worker. */
    public static Ahead[] ofWorkers(Team team) {
        Ahead[] all = new Ahead[team.most()];
        for (int worker = 0; worker < all.length; worker++) {
            all[worker] = new Ahead();
        }
        return all;
    }

    void clear() {
        end = 0;
        next = 0;
    }

    /** Begins the record of a circle. */
    void begin(int slot) {
        ensure(HEAD);
        begun = end;
        records[begun + SLOT] = slot;
        end += HEAD;
    }

    /** Notes circles that were seen, if their reach meets that of the one. */
    void add(int other) {
        ensure(1);
        records[end++] = other;
    }

    void add(int[] others, int many) {
        ensure(many);
        System.arraycopy(others, 0, records, end, many);
        end += many;
    }

    /** Ends a record; left: how many levels are left to look in, the finest ones. */
    void end(int left) {
        records[begun + LEFT] = left;
        records[begun + MANY] = end - begun - HEAD;
    }

    private void ensure(int more) {
        if (end + more > records.length) {
            records = Arrays.copyOf(records, 2 * (end + more));
        }
    }

    /** Reads from the first record on. */
    public void rewind() {
        next = 0;
    }

    /**
     * Adds those of the circles seen to a list that are near to one; circles are asked for in the order of slots.
     *
     * @return how many have been tested, or -1 if nothing was seen of the circle
     */
    public int take(State state, Grid grid, NearSlots near, int slot) {
        if (next == end || records[next + SLOT] != slot) {
            return -1;
        }
        int many = records[next + MANY];
        left = records[next + LEFT];
        near.test(state, grid, slot, records, next + HEAD, many);
        next += HEAD + many;
        return many;
    }

    /** How many levels are left to look in for the circle that was taken last, the finest ones. */
    public int left() {
        return left;
    }

    long bytes() {
        return 4L * records.length;
    }
}
