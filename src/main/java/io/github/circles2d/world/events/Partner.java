package io.github.circles2d.world.events;

import io.github.circles2d.world.circles.Handle;
import io.github.circles2d.world.model.AxisEdge;
import io.github.circles2d.world.model.Bounds;
import io.github.circles2d.world.model.Limits;

/**
 * Whom the circle of lower id touches, as one number: the higher id, or above all ids the code of a wall, or above these the code of a piece of
 * terrain. The events of a step are in the order of lower id, partner and rank.
 */
public final class Partner {
    /** The side of a pair of circles. */
    static final int NO_SIDE = -1;

    /** The side of a circle and a piece of terrain, where events are saved. */
    static final int PIECE = SavedTouches.PIECE;

    public static final int WALLS = 4;

    private static final int FIRST_WALL = Limits.CIRCLES;
    private static final int FIRST_PIECE = FIRST_WALL + WALLS;

    private static final int RANK_BITS = 3;
    private static final int ID_BITS = 28;

    private Partner() {}

    /** The code of a wall: axis 0 or 1, side 1 for the lower wall and -1 for the upper. */
    public static int ofWall(int axis, float side) {
        return FIRST_WALL + 2 * axis + (side > 0f ? 0 : 1);
    }

    /** The code of a piece of terrain. */
    public static int ofPiece(int piece) {
        return FIRST_PIECE + piece;
    }

    static boolean isCircle(int partner) {
        return partner < FIRST_WALL;
    }

    static boolean isWall(int partner) {
        return !isCircle(partner) && !isPiece(partner);
    }

    static boolean isPiece(int partner) {
        return partner >= FIRST_PIECE;
    }

    /** The piece of terrain of a code. */
    static int piece(int partner) {
        return partner - FIRST_PIECE;
    }

    /** Whether there is the wall: circles that come to the end of coordinates, on an axis without walls, are not reported. */
    static boolean hasWall(Bounds arena, int wall) {
        return (wall - FIRST_WALL < 2 ? arena.edgeX() : arena.edgeY()) == AxisEdge.WALL;
    }

    /** The side of a wall, {@link #NO_SIDE} or {@link #PIECE}. */
    static int side(int partner) {
        return isCircle(partner) ? NO_SIDE : isPiece(partner) ? PIECE : partner - FIRST_WALL;
    }

    /** By the handle of the other circle or of the piece, or by the side of a wall. */
    static int of(long handle, int side) {
        return side == NO_SIDE ? (int) handle : side == PIECE ? ofPiece(Handle.id(handle)) : FIRST_WALL + side;
    }

    /** What the events of a step are ordered by. */
    static long key(int lower, int partner, int rank) {
        return ((long) lower << ID_BITS | partner) << RANK_BITS | rank;
    }
}
