package io.github.circles2d.world.events;

import io.github.circles2d.world.model.AxisEdge;
import io.github.circles2d.world.model.Bounds;
import io.github.circles2d.world.model.Limits;

/** The codes of the four walls, as partners of circles. They lie above all ids. */
public final class WallCode {
    static final int WALLS = 4;

    private WallCode() {}

    /** The code of a wall: axis 0 or 1, side 1 for the lower wall and -1 for the upper. */
    public static int of(int axis, float side) {
        return Limits.CIRCLES + 2 * axis + (side > 0f ? 0 : 1);
    }

    /** Whether there is a wall: circles that come to the end of coordinates, on an axis without walls, are not reported. */
    static boolean hasWall(Bounds arena, int code) {
        return (code - Limits.CIRCLES < 2 ? arena.edgeX() : arena.edgeY()) == AxisEdge.WALL;
    }
}
