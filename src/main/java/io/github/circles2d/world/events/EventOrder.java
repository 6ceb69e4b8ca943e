package io.github.circles2d.world.events;

import io.github.circles2d.world.circles.Handle;
import io.github.circles2d.world.circles.SavedTouches;
import io.github.circles2d.world.model.Limits;

/** The order of a step's events: lower id, higher id or the code of a wall or of a piece of terrain, rank. */
final class EventOrder {
    /** The side of a pair of circles. */
    static final int NO_SIDE = -1;

    /** The side of a circle and a piece of terrain, where events are saved. */
    static final int PIECE = SavedTouches.PIECE;

    private static final int RANK_BITS = 3;
    private static final int ID_BITS = 28;

    private EventOrder() {}

    static long key(int lower, int higher, int rank) {
        return ((long) lower << ID_BITS | higher) << RANK_BITS | rank;
    }

    static boolean isCircle(int higher) {
        return higher < Limits.CIRCLES;
    }

    static boolean isWall(int higher) {
        return !isCircle(higher) && !PieceCode.isPiece(higher);
    }

    /** The side of a wall, {@link #NO_SIDE} or {@link #PIECE}. */
    static int side(int higher) {
        return isCircle(higher) ? NO_SIDE : PieceCode.isPiece(higher) ? PIECE : higher - Limits.CIRCLES;
    }

    /** The partner of a circle of lower id: by the handle of the other circle or of the piece, or by the side of a wall. */
    static int higher(long handle, int side) {
        return side == NO_SIDE ? (int) handle : side == PIECE ? PieceCode.of(Handle.id(handle)) : Limits.CIRCLES + side;
    }
}
