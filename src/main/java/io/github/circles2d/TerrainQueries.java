package io.github.circles2d;

import io.github.circles2d.world.search.QueryFilter;
import io.github.circles2d.world.search.Searches;

/**
 * Questions about where the pieces of {@link Terrain} are: which overlap a disc or a box, which are nearest to a point, and which a ray or a
 * moving disc meets. {@link Queries#terrain} gives this object.
 *
 * <pre>{@code
 * TerrainQueries ground = world.queries().terrain();
 * float[] hit = new float[Queries.HIT_STRIDE];
 * long wall = ground.rayCast(x, y, 100, 0, hit); // the piece, or 0
 * if (wall != 0) {
 *     spark(hit[Queries.X], hit[Queries.Y], hit[Queries.NORMAL_X], hit[Queries.NORMAL_Y]);
 * }
 * }</pre>
 *
 * <p>What {@link Queries} says of circles holds for pieces: masks, the order of results, batches, arrays, exactness and misuse. A piece is found
 * where it is now: where its body is after all steps that were asked for, with the changes that wait for the next step. Its handle is that of
 * {@link Terrain}. The host answers on every back end; it neither waits for steps nor reads circles.
 *
 * <p><b>Sides:</b> overlaps and the nearest find a piece from all sides. A ray or a disc meets a piece that has a free side only where it
 * comes from that side: a line of a chain, an arc, or a piece of a kind that is {@linkplain Kind#setOneWay one-way}. From behind it
 * passes, and may meet an arc from within later. It does not slip between two pieces of a chain.
 *
 * <p><b>Hits</b> have the elements of {@link Queries#HIT_STRIDE}. ({@link Queries#X}, {@link Queries#Y}) is the end of the ray or the centre of the
 * disc when it meets the piece, and the normal leads from the piece to there: the disc touches it at the centre minus its radius times the
 * normal. The normal of a hit of a ray is that of the side that it meets.
 *
 * <p><b>Edges:</b> along an axis that {@linkplain World.Builder#edges wraps}, overlaps and the nearest find each piece once, whichever way
 * round. Rays and discs go on beyond the seam, for half of the extent of the bounds, and find a piece once for each way on which they meet it.
 */
public final class TerrainQueries extends ShapeQueries {
    TerrainQueries(Searches searches, QueryFilter filter) {
        super(searches, filter);
    }

    /**
     * The same queries of some pieces alone, as {@link Queries#withMask} of some circles.
     *
     * @param mask the bits of the categories to find: -1 for all categories but 0, and 0 for no piece
     * @return queries with this mask; a mask of this object no longer counts for them
     */
    public TerrainQueries withMask(int mask) {
        return new TerrainQueries(searches, searches.filter(null, mask));
    }

    /**
     * Finds the piece nearest to a point, as under a mouse.
     *
     * @param x x of the point
     * @param y y of the point
     * @param within greatest distance, at least 0; positive infinity for any
     * @return the handle, or 0 if there is no piece; of several at the same distance that of the lowest id
     * @throws IllegalArgumentException if a value is out of range
     */
    public long pick(float x, float y, float within) {
        return searches.nearestOne(filter, x, y, within, null);
    }

    /**
     * Finds the piece nearest to each of many points.
     *
     * @param points x and y of one after the other
     * @param n number of points, at least 0
     * @param within greatest distance, at least 0; positive infinity for any
     * @param handles takes the handle of each, or 0; at least n elements
     * @return near how many of them there is a piece
     * @throws IllegalArgumentException if a value is out of range, or an array is too short
     */
    public int pick(float[] points, int n, float within, long[] handles) {
        return searches.nearest(filter, points, n, within, 1, handles, null);
    }

    /**
     * Finds the pieces nearest to a point. The distance is that from the point to their surfaces, negative inside one that is thick.
     *
     * @param x x of the point
     * @param y y of the point
     * @param within greatest distance, at least 0; positive infinity for any
     * @param most how many pieces to find, at least 1
     * @param handles takes their handles, by distance, then by id; at least {@code most} elements
     * @param hits takes {@link Queries#HIT_STRIDE} elements for each: the distance, the nearest point of the surface, and the unit vector from
     *     there to the point (of a point on the surface, that of the front); may be null
     * @return how many were found
     * @throws IllegalArgumentException if a value is out of range, or an array is too short
     */
    public int nearest(float x, float y, float within, int most, long[] handles, float[] hits) {
        return searches.nearest(filter, x, y, within, most, handles, hits);
    }

    /**
     * Finds the pieces nearest to each of many points. Those of point q begin at number q * most of the arrays.
     *
     * @param points x and y of one after the other
     * @param n number of points, at least 0
     * @param within greatest distance, at least 0; positive infinity for any
     * @param most how many pieces to find for each, at least 1
     * @param handles takes their handles, by distance, then by id, and then 0 up to the number that may be found; at least
     *     n * most elements
     * @param hits takes their hits as {@link #nearest(float, float, float, int, long[], float[])} does, and then infinite distances, likewise;
     *     may be null
     * @return how many were found for all points together
     * @throws IllegalArgumentException if a value is out of range, or an array is too short
     */
    public int nearest(float[] points, int n, float within, int most, long[] handles, float[] hits) {
        return searches.nearest(filter, points, n, within, most, handles, hits);
    }
}
