package io.github.circles2d.world.events;

import io.github.circles2d.world.model.Limits;

/** The order of a step's events: lower id, higher id or the code of a wall, rank. */
final class EventOrder {
    /** The side of a pair of circles. */
    static final int NO_SIDE = -1;

    private static final int RANK_BITS = 3;
    private static final int ID_BITS = 28;

    private EventOrder() {}

    static long key(int lower, int higher, int rank) {
        return ((long) lower << ID_BITS | higher) << RANK_BITS | rank;
    }

    static boolean isWall(int higher) {
        return higher >= Limits.CIRCLES;
    }

    /** The side of a wall, or {@link #NO_SIDE}. */
    static int side(int higher) {
        return isWall(higher) ? higher - Limits.CIRCLES : NO_SIDE;
    }

    /** The partner of a circle of lower id: by the handle of the other circle, or by the side of a wall. */
    static int higher(long handle, int side) {
        return side == NO_SIDE ? (int) handle : Limits.CIRCLES + side;
    }
}
