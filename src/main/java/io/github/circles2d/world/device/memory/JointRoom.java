package io.github.circles2d.world.device.memory;

import io.github.circles2d.world.device.memory.JointArray.Count;

/** How much room the tables of joints have. They lie one behind the other, behind those of terrain. */
final class JointRoom {
    private int[] capacity = new int[Count.COUNT];

    /** Counts how often tables have moved, which then have to be written again. */
    private int version;

    /** More room, if this is too little; or null. needed: by ordinal of a {@link Count}. */
    JointRoom with(int[] needed) {
        boolean suffices = true;
        for (int k = 0; k < capacity.length; k++) {
            suffices &= needed[k] <= capacity[k];
        }
        if (suffices) {
            return null;
        }
        JointRoom more = new JointRoom();
        for (int k = 0; k < capacity.length; k++) {
            more.capacity[k] = needed[k] <= capacity[k] ? capacity[k] : DeviceArrays.grown(capacity[k], needed[k]);
        }
        return more;
    }

    /** Becomes as another one. */
    void take(JointRoom other) {
        capacity = other.capacity;
        version++;
    }

    int version() {
        return version;
    }

    int capacity(Count count) {
        return capacity[count.ordinal()];
    }

    /** Words of all tables. */
    int words() {
        return at(JointArray.ALL.length);
    }

    /** Words from the first table to another one: a multiple of 4, for kernels that read vectors. */
    int at(JointArray table) {
        return at(table.ordinal());
    }

    /** Words from the first table to a part of another one, which has room for it: others lie behind it. */
    int at(JointArray table, int from, int to) {
        int room = table.words() * capacity(table.count());
        return at(table) + DeviceArrays.requireRange("joints", table.ordinal(), from, to, room);
    }

    private int at(int tables) {
        long sum = 0;
        for (int k = 0; k < tables; k++) {
            JointArray table = JointArray.ALL[k];
            sum += (long) table.words() * capacity(table.count()) + 3 & ~3L;
        }
        return Math.toIntExact(sum);
    }
}
