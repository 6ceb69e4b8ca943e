package io.github.circles2d.bench.measure;

import io.github.circles2d.PairIndexing;

/**
 * The bytes that the thesis's buffers take, and those that a step must move between the device's memory and its cores at
 * the least: every buffer that a kernel reads or writes passes once a kernel. Circles that are read for many slots are
 * counted once (they stay in a cache), and what the resolving of the few overlapping pairs moves is not counted.
 *
 * @param collisionBytes size of the collision buffer
 * @param tableBytes size of the indexing's table, 0 where it has none
 * @param movedBytes bytes a step
 */
record PairTraffic(long collisionBytes, long tableBytes, long movedBytes) {
    private static final int CIRCLE_BYTES = 16;
    private static final int VELOCITY_BYTES = 8;
    private static final int SLOT_BYTES = 8;
    private static final int ROW_BYTES = 8;

    static PairTraffic of(String indexing, long n) {
        long slots = n * (n - 1) / 2;
        long collision = slots * SLOT_BYTES;
        long table = tableBytes(PairIndexing.valueOf(indexing), n, slots);
        long update = 2 * n * (CIRCLE_BYTES + VELOCITY_BYTES);
        long detect = n * CIRCLE_BYTES + collision + table;
        // The table is read for overlapping pairs alone here.
        long resolve = collision;
        return new PairTraffic(collision, table, update + detect + resolve);
    }

    private static long tableBytes(PairIndexing indexing, long n, long slots) {
        switch (indexing) {
            case LOOKUP_TABLE:
                return slots * SLOT_BYTES;
            case ROW_SEARCH:
                return n * ROW_BYTES;
            default:
                return 0;
        }
    }
}
