package io.github.circles2d.world.jvm;

/** The numbers of a piece contact, of a circle and a piece of terrain near it. */
final class PieceContactRow {
    static final int STRIDE = 16;

    /** 1 or -1: where the circle is; 0: it is behind a piece that has a front. */
    static final int SIDE = 0;

    /** Accumulated; impulses are speeds. */
    static final int IMPULSE = 1;

    static final int FRICTION = 2;
    static final int ROLLING = 3;

    // within a step: as measured last
    static final int NX = 4;
    static final int NY = 5;
    static final int GAP = 6;
    static final int CURVE = 7;

    /** Within a sub-step: target speed of a bounce. */
    static final int BOUNCE = 8;

    /** Within a step: the centre against (X, Y) of the piece, in the frame of the start of the step. */
    static final int OX = 9;

    static final int OY = 10;

    /** Within a sub-step: the gap at its start, if the circle is deep in the piece, else 0. */
    static final int ALLOWED = 11;

    /** Within a step: the base of the circle against (X, Y) of the piece. */
    static final int BASE_X = 12;

    static final int BASE_Y = 13;

    /** Within a step: of the circle and the piece. */
    static final int RESTITUTION = 14;

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

    // the surfaces, within a step in which circles turn: as OneBodyGrip has them, and the belts
    static final int SURFACES = 4;
    static final int MU = 0;
    static final int RESISTANCE = 1;
    static final int INERTIA = 2;
    static final int BELT = 3;

    private PieceContactRow() {}

    static int of(int contact) {
        return STRIDE * contact;
    }

    static int numbers(int contact) {
        return NUMBERS * contact;
    }

    static int surfaces(int contact) {
        return SURFACES * contact;
    }
}
