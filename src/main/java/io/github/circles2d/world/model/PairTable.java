package io.github.circles2d.world.model;

/** A number from 0 to 3 for each pair of kinds, sixteen in an int, as in {@code PairFilter.cl}. */
public final class PairTable {
    public static final int KINDS = 256;

    private static final int IN_WORD_LOG = 4;
    private static final int IN_WORD = 1 << IN_WORD_LOG;
    private static final int ROW = KINDS / IN_WORD;

    public static final int WORDS = KINDS * ROW;

    /** 0, so that zeros filter nothing. */
    public static final int SOLID = 0;

    public static final int IGNORE = 1;

    public static final int SENSE = 2;

    private PairTable() {}

    public static int get(int[] table, int a, int b) {
        return table[ROW * a + (b >> IN_WORD_LOG)] >>> 2 * (b & IN_WORD - 1) & 3;
    }

    /** In both orders. */
    public static void set(int[] table, int a, int b, int number) {
        setOne(table, a, b, number);
        setOne(table, b, a, number);
    }

    public static void setOne(int[] table, int a, int b, int number) {
        int shift = 2 * (b & IN_WORD - 1);
        int at = ROW * a + (b >> IN_WORD_LOG);
        table[at] = table[at] & ~(3 << shift) | number << shift;
    }
}
