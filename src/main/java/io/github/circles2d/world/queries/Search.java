package io.github.circles2d.world.queries;

import java.util.function.IntPredicate;

/**
 * The searches among things that are shown, by the shape of a checked query. What a search has found is numbered from 0 on, until the next one. A null
 * filter admits all.
 */
public interface Search {
    /** Finds all that a query is about, what overlaps by id, what a path meets by distance, then by id, and returns how many. */
    int all(QueryShape shape, float[] query, IntPredicate filter);

    /** What number k of {@link #all} is. */
    int id(QueryShape shape, int k);

    /** Writes the hit of number k of all that a path meets. */
    void writeHit(int k, float[] to, int at);

    /** What is at a point, or what a path meets first, or -1; hits takes the hit of a path, or its end, or is null. */
    int first(QueryShape shape, float[] query, IntPredicate filter, float[] hits, int to);

    /** Finds so many whose surfaces are nearest to a point, by distance, then by id, and returns how many. */
    int nearest(float x, float y, float within, int most, IntPredicate filter);

    /** What number k of the nearest is. */
    int nearestId(int k);

    /** How far away it is; negative inside. */
    double nearestDistance(int k);

    /** Writes that, the nearest point of its surface and the normal there; not of circles. */
    void writeNearest(int k, float[] to, int at);
}
