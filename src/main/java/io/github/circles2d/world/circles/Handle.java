package io.github.circles2d.world.circles;

/** The numbers that callers name circles, pieces and bodies of terrain, and joints by: ((generation + 1) &lt;&lt; 32 | id), which is never 0. */
public final class Handle {
    private static final int GENERATION_SHIFT = 32;
    private static final long ID_MASK = (1L << GENERATION_SHIFT) - 1;

    /** The generation that would make a handle 0 is left out. */
    static final int LAST_GENERATION = -2;

    private Handle() {}

    public static long of(int generation, int id) {
        return (long) (generation + 1) << GENERATION_SHIFT | id;
    }

    /** Not negative. */
    public static long id(long handle) {
        return handle & ID_MASK;
    }

    public static boolean hasGeneration(long handle, int generation) {
        return generation + 1 == (int) (handle >>> GENERATION_SHIFT);
    }

    /** The generation of what has an id next. */
    public static int next(int generation) {
        return generation == LAST_GENERATION ? 0 : generation + 1;
    }
}
