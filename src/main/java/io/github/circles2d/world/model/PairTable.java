package io.github.circles2d.world.model;

/**
 * A number from 0 to 3 for each pair of kinds, packed into ints: sixteen numbers in each. The number of a pair is the same in either
 * order. {@code PairFilter.cl} reads such a table too.
 */
public final class PairTable {
    /** Number of kinds. */
    public static final int KINDS = 256;

    private static final int IN_WORD_LOG = 4;
    private static final int IN_WORD = 1 << IN_WORD_LOG;
    private static final int ROW = KINDS / IN_WORD;

    /** Ints of a table. */
    public static final int WORDS = KINDS * ROW;

    // ---- what the circles of two kinds do to each other; solid must be 0, so that a table of zeros filters nothing
    // --------------------------------------------------------------------------------------------------

    /** They push each other. */
    public static final int SOLID = 0;

    /** They do not see each other. */
    public static final int IGNORE = 1;

    /** They are to be noticed, and do not push each other. */
    public static final int SENSE = 2;

    private PairTable() {}

    /** The number of a pair. */
    public static int get(int[] table, int a, int b) {
        return table[ROW * a + (b >> IN_WORD_LOG)] >>> 2 * (b & IN_WORD - 1) & 3;
    }

    /** Sets the number of a pair. */
    public static void set(int[] table, int a, int b, int number) {
        setOne(table, a, b, number);
        setOne(table, b, a, number);
    }

    /** Sets the number of a pair in one order alone, for a table in which the order matters. */
    public static void setOne(int[] table, int a, int b, int number) {
        int shift = 2 * (b & IN_WORD - 1);
        int at = ROW * a + (b >> IN_WORD_LOG);
        table[at] = table[at] & ~(3 << shift) | number << shift;
    }
}
