package io.github.circles2d.world.jvm;

import io.github.circles2d.world.model.ContactRows;
import io.github.circles2d.world.model.OneBodyRows;

/** The numbers of a piece contact, of a circle and a piece of terrain near it. */
final class PieceContactRow {
    static final int STRIDE = 14 + ContactRows.COUNT;

    /** 1 or -1: where the circle is; 0: it is behind a piece that has a front. */
    static final int SIDE = 0;

    /** Accumulated; impulses are speeds. */
    static final int IMPULSE = 1;

    /** The accumulated impulses of the other rows, by {@link ContactRows}. */
    static final int ROWS = 2;

    /** Floats from the start on that stay from step to step. */
    static final int KEPT = ROWS + ContactRows.COUNT;

    // within a step: as measured last
    static final int NX = KEPT;
    static final int NY = NX + 1;
    static final int GAP = NX + 2;
    static final int CURVE = NX + 3;

    /** Within a sub-step: target speed of a bounce. */
    static final int BOUNCE = NX + 4;

    /** Within a step: the centre against (X, Y) of the piece, in the frame of the start of the step. */
    static final int OX = NX + 5;

    static final int OY = NX + 6;

    /** Within a sub-step: the gap at its start, if the circle is deep in the piece, else 0. */
    static final int ALLOWED = NX + 7;

    /** Within a step: the base of the circle against (X, Y) of the piece. */
    static final int BASE_X = NX + 8;

    static final int BASE_Y = NX + 9;

    /** Within a step: of the circle and the piece. */
    static final int RESTITUTION = NX + 10;

    // the whole numbers
    static final int NUMBERS = 6;
    static final int PIECE = 0;
    static final int SERIAL = 1;

    /** Within a step: {@code PairTable.SOLID} or {@code SENSE}. */
    static final int RESPONSE = 2;

    /** Within a step: {@code PieceGap.feature}, or none if the piece is no constraint. */
    static final int FEATURE = 3;

    /** Within a step: as the piece has them. */
    static final int SHAPE = 4;

    static final int MOTION = 5;

    private PieceContactRow() {}

    static int of(int contact) {
        return STRIDE * contact;
    }

    static int numbers(int contact) {
        return NUMBERS * contact;
    }

    /** The surfaces, within a step in which circles can rotate: what {@link OneBodyRows} keeps. */
    static int surfaces(int contact) {
        return OneBodyRows.KEPT * contact;
    }
}
