package io.github.circles2d.world.jvm.solver;

/** Contacts that the relaxing pass works on at a time, by what is still to do with them. */
final class RelaxedBlock {
    static final int SIZE = 256;

    /** Those to visit; once they are, those of them that carry, unless the visits have done all. */
    final int[] listed = new int[SIZE];

    /** Number of those that carry. */
    int carrying;

    /** Those that got an impulse and do not keep it: {@link Touches} takes it. */
    final int[] unkept = new int[SIZE];

    int unkeptCount;

    void begin() {
        carrying = 0;
        unkeptCount = 0;
    }

    void addUnkept(int c) {
        unkept[unkeptCount++] = c;
    }
}
