package io.github.circles2d.world.events;

import io.github.circles2d.world.model.Limits;

/** The codes of pieces of terrain, as partners of circles. They lie above those of the walls. */
public final class PieceCode {
    static final int FIRST = Limits.CIRCLES + WallCode.WALLS;

    private PieceCode() {}

    public static int of(int piece) {
        return FIRST + piece;
    }

    public static boolean isPiece(int code) {
        return code >= FIRST;
    }

    public static int piece(int code) {
        return code - FIRST;
    }
}
