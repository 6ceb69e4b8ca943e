package io.github.circles2d.world.queries;

import java.util.function.IntPredicate;

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

    final Found found = new Found();

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

    /** Finds what the path meets first, so many, in no order. */
    abstract void search(int most, IntPredicate filter);

    /** Finds what the disc touches first, at the same distance what has the lowest id, as number 0. */
    public boolean first(IntPredicate filter) {
        search(1, filter);
        return found.count() > 0;
    }

    /** Finds all that the disc touches, by the distance that it has moved by then, then by id, and returns how many. */
    public int all(IntPredicate filter) {
        search(Integer.MAX_VALUE, filter);
        found.sort();
        return found.count();
    }

    /** The first of a path, or -1; hits takes the hit, or the end of the path, or is null. */
    public final int first(QueryShape shape, float[] query, IntPredicate filter, float[] hits, int to) {
        aim(shape, query, 0);
        boolean hit = first(filter);
        if (hits != null && hit) {
            writeHit(0, hits, to);
        } else if (hits != null) {
            writeMiss(hits, to);
        }
        return hit ? found.id(0) : -1;
    }

    /** Writes the hit of number k, as {@link CastSearch} lays hits out. */
    public abstract void writeHit(int k, float[] to, int at);

    /** Writes where the disc ends if it hits nothing: the length of its path, its end, and a normal of 0. */
    public void writeMiss(float[] to, int at) {
        CastSearch.write(to, at, length, endX, endY, 0, 0);
    }
}
