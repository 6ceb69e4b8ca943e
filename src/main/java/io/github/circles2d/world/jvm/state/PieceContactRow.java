package io.github.circles2d.world.jvm.state;

import io.github.circles2d.world.model.ContactRows;
import io.github.circles2d.world.model.OneBodyRows;

/** The numbers of a piece contact, of a circle and a piece of terrain near it. */
public final class PieceContactRow {
    static final int STRIDE = 14 + ContactRows.COUNT;

    /** 1 or -1: where the circle is; 0: it is behind a piece that has a front. */
    public static final int SIDE = 0;

    /** Accumulated; impulses are speeds. */
    public static final int IMPULSE = 1;

    /** The accumulated impulses of the other rows, by {@link ContactRows}. */
    public static final int ROWS = 2;

    /** Floats from the start on that stay from step to step. */
    public static final int KEPT = ROWS + ContactRows.COUNT;

    // within a step: as measured last
    public static final int NX = KEPT;
    public static final int NY = NX + 1;
    public static final int GAP = NX + 2;
    public static final int CURVE = NX + 3;

    /** Within a sub-step: target speed of a bounce. */
    public static final int BOUNCE = NX + 4;

    /** Within a step: the centre against (X, Y) of the piece, in the frame of the start of the step. */
    public static final int OX = NX + 5;

    public static final int OY = NX + 6;

    /** Within a sub-step: the gap at its start, if the circle is deep in the piece, else 0. */
    public static final int ALLOWED = NX + 7;

    /** Within a step: the base of the circle against (X, Y) of the piece. */
    public static final int BASE_X = NX + 8;

    public static final int BASE_Y = NX + 9;

    /** Within a step: of the circle and the piece. */
    public static final int RESTITUTION = NX + 10;

    // the whole numbers
    static final int NUMBERS = 6;
    public static final int PIECE = 0;
    public static final int SERIAL = 1;

    /** Within a step: {@code PairTable.SOLID} or {@code SENSE}. */
    public static final int RESPONSE = 2;

    /** Within a step: {@code PieceGap.feature}, or none if the piece is no constraint. */
    public static final int FEATURE = 3;

    /** Within a step: as the piece has them. */
    public static final int SHAPE = 4;

    public static final int MOTION = 5;

    private PieceContactRow() {}

    public static int of(int contact) {
        return STRIDE * contact;
    }

    public static int numbers(int contact) {
        return NUMBERS * contact;
    }

    /** The surfaces, within a step in which circles can rotate: what {@link OneBodyRows} keeps. */
    public static int surfaces(int contact) {
        return OneBodyRows.KEPT * contact;
    }
}
