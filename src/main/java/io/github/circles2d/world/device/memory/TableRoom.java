package io.github.circles2d.world.device.memory;

/** How much room tables have that lie one behind the other, each where kernels may read vectors: at a multiple of four words. */
final class TableRoom {
    /** A table of a room. */
    interface Table {
        int ordinal();

        /** Words of an element. */
        int words();

        /** Of which of the room's counts it has an element each. */
        Enum<?> count();
    }

    private final String of;
    private final int head;
    private final Table[] tables;
    private final int[] capacity;

    /** Counts how often tables have moved, which then have to be written again. */
    private int version;

    /**
     * No room yet, but for a head before the tables.
     *
     * @param of what the tables are of, for messages
     */
    TableRoom(String of, int head, int counts, Table... tables) {
        this.of = of;
        this.head = head;
        this.tables = tables;
        capacity = new int[counts];
    }

    /** More room, if this is too little; or null. needed: elements, by ordinal of a count. */
    TableRoom with(int... needed) {
        boolean suffices = true;
        for (int k = 0; k < capacity.length; k++) {
            suffices &= needed[k] <= capacity[k];
        }
        if (suffices) {
            return null;
        }
        TableRoom more = new TableRoom(of, head, capacity.length, tables);
        for (int k = 0; k < capacity.length; k++) {
            more.capacity[k] = needed[k] <= capacity[k] ? capacity[k] : DeviceArrays.grown(capacity[k], needed[k]);
        }
        return more;
    }

    /** Becomes as another one. */
    void take(TableRoom other) {
        System.arraycopy(other.capacity, 0, capacity, 0, capacity.length);
        version++;
    }

    int version() {
        return version;
    }

    int capacity(Enum<?> count) {
        return capacity[count.ordinal()];
    }

    /** Words of the head and all tables. */
    int words() {
        return at(tables.length);
    }

    /** Words before a table. */
    int at(Table table) {
        return at(table.ordinal());
    }

    /** Words before a part of a table, which has room for it: others lie behind it. */
    int at(Table table, int from, int to) {
        return at(table) + requireRange(of, table.ordinal(), from, to, words(table));
    }

    /** Words that a table has room for. */
    int words(Table table) {
        return table.words() * capacity(table.count());
    }

    private int at(int end) {
        long sum = head;
        for (int k = 0; k < end; k++) {
            sum += (long) tables[k].words() * capacity(tables[k].count()) + 3 & ~3L;
        }
        return Math.toIntExact(sum);
    }

    /** Refuses a part of a table that is not within it, which would be written over another one. Returns where the part begins. */
    static int requireRange(String of, int table, int from, int to, int room) {
        if (from < 0 || to < from || to > room) {
            throw new IllegalStateException("words " + from + " to " + to + " of table " + table + " of " + of
                    + ", which has room for " + room);
        }
        return from;
    }
}
