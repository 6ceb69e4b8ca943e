package io.github.circles2d.world.circles;

/**
 * The numbers that callers name circles, bodies, pieces and bodies of terrain, and joints by: ((generation + 1) &lt;&lt; 32 | mark | id), which is
 * never 0. A mark is one or two bits that are in no id, so no handle of one thing is taken for one of another.
 */
public final class Handle {
    public static final int JOINT = 1 << 30;
    public static final int PIECE = 1 << 29;
    public static final int BODY = 1 << 28;

    /** Of a body that is pushed. */
    public static final int RIGID = PIECE | BODY;

    private static final int MARKS = JOINT | PIECE | BODY;

    private static final int GENERATION_SHIFT = 32;
    private static final long ID_MASK = (1L << GENERATION_SHIFT) - 1;

    /** The generation that would make a handle 0 is left out. */
    public static final int LAST_GENERATION = -2;

    private Handle() {}

    public static long of(int generation, int id) {
        return (long) (generation + 1) << GENERATION_SHIFT | id;
    }

    /** The id in a handle that a world has given. */
    public static int id(long handle) {
        return (int) handle & BODY - 1;
    }

    /** Whether a handle is of the form that handles of something have. */
    public static boolean has(long handle, int mark) {
        return ((int) handle & MARKS) == mark;
    }

    /** Whether a handle is of no piece, body or joint. */
    public static boolean mayBeOfCircle(long handle) {
        return ((int) handle & MARKS) == 0;
    }

    /** Why a handle names none of what a caller asks for: it is of something else, or of nothing. Ends a sentence. */
    public static String reason(long handle, int mark) {
        if (handle == 0) {
            return ": 0 is the handle of nothing";
        }
        int found = (int) handle & MARKS;
        return switch (found == mark ? -1 : found) {
            case 0 -> ": it is of a circle, or of nothing";
            case JOINT -> ": it is of a joint";
            case PIECE -> ": it is of a piece of terrain";
            case BODY -> ": it is of a body of terrain";
            case RIGID -> ": it is of a body of World.bodies";
            default -> ": it was removed, or is none of this world's";
        };
    }

    /** The id and its mark, if it has one. Not negative. */
    static long marked(long handle) {
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
