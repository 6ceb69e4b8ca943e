package io.github.circles2d.world.queries;

/** A search along the path of a disc. A ray is the path of a disc of radius 0. */
abstract class PathSearch {
    double startX;
    double startY;
    double reach;
    double endX;
    double endY;
    double unitX;
    double unitY;
    double length;

    /** Describes the path of the next searches: where the disc starts, and how far it moves. All numbers are finite. */
    public void aim(float x, float y, float radius, float dx, float dy) {
        startX = x;
        startY = y;
        reach = radius;
        endX = startX + dx;
        endY = startY + dy;
        length = Math.sqrt((double) dx * dx + (double) dy * dy);
        unitX = length == 0 ? 0 : dx / length;
        unitY = length == 0 ? 0 : dy / length;
    }

    /** Describes the path of a query, likewise. */
    public void aim(QueryShape shape, float[] queries, int at) {
        aim(queries[at], queries[at + 1], shape.radius(queries, at), shape.dx(queries, at), shape.dy(queries, at));
    }
}
