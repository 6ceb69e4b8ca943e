package io.github.circles2d;

import io.github.circles2d.world.queries.QueryShape;
import io.github.circles2d.world.search.CategoryFilter;
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
public final class TerrainQueries {
    private final Searches searches;

    /** Which pieces are found; null for all. */
    private final CategoryFilter filter;

    TerrainQueries(Searches searches, CategoryFilter filter) {
        this.searches = searches;
        this.filter = filter;
    }

    /**
     * The same queries of some pieces alone, as {@link Queries#withMask} of some circles.
     *
     * @param mask the bits of the categories to find: -1 for all categories but 0, and 0 for no piece
     * @return queries with this mask; a mask of this object no longer counts for them
     */
    public TerrainQueries withMask(int mask) {
        return new TerrainQueries(searches, searches.filter(mask));
    }

    // ---- overlaps
    // ----------------------------------------------------------------------------------------------------

    /**
     * Finds the pieces that a disc overlaps or touches.
     *
     * @param x x of its centre
     * @param y y of its centre
     * @param radius its radius, at least 0; 0 for the pieces that have a point
     * @param handles takes their handles, the lowest id first; only the first ones if it is too short
     * @return how many there are, which may be more than the array takes
     * @throws IllegalArgumentException if a value is out of range
     */
    public int overlapCircle(float x, float y, float radius, long[] handles) {
        return searches.all(filter, QueryShape.DISC, x, y, radius, 0, 0, handles, null);
    }

    /**
     * Finds the pieces that each of many discs overlaps or touches. See {@link Queries} for batches.
     *
     * @param discs x, y and radius of one after the other
     * @param n number of discs, at least 0
     * @param ends takes where the handles of each end; at least n elements
     * @param handles takes the handles
     * @return how many there are for all discs together
     * @throws IllegalArgumentException if a value is out of range, or there are more than 2^31 - 1 results
     */
    public int overlapCircle(float[] discs, int n, int[] ends, long[] handles) {
        return searches.all(filter, QueryShape.DISC, discs, n, ends, handles, null);
    }

    /**
     * Finds the pieces that a box overlaps or touches; its sides are parallel to the axes.
     *
     * @param minX left side
     * @param minY lower side
     * @param maxX right side, at least minX
     * @param maxY upper side, at least minY
     * @param handles takes their handles, the lowest id first; only the first ones if it is too short
     * @return how many there are, which may be more than the array takes
     * @throws IllegalArgumentException if a value is out of range
     */
    public int overlapBox(float minX, float minY, float maxX, float maxY, long[] handles) {
        return searches.all(filter, QueryShape.BOX, minX, minY, maxX, maxY, 0, handles, null);
    }

    /**
     * Finds the pieces that each of many boxes overlaps or touches. See {@link Queries} for batches.
     *
     * @param boxes minX, minY, maxX and maxY of one after the other
     * @param n number of boxes, at least 0
     * @param ends takes where the handles of each end; at least n elements
     * @param handles takes the handles
     * @return how many there are for all boxes together
     * @throws IllegalArgumentException if a value is out of range, or there are more than 2^31 - 1 results
     */
    public int overlapBox(float[] boxes, int n, int[] ends, long[] handles) {
        return searches.all(filter, QueryShape.BOX, boxes, n, ends, handles, null);
    }

    // ---- points
    // ------------------------------------------------------------------------------------------------------

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

    // ---- rays
    // --------------------------------------------------------------------------------------------------------

    /**
     * Finds the first piece that a ray meets.
     *
     * @param x x of its start
     * @param y y of its start
     * @param dx how far it reaches along x
     * @param dy how far it reaches along y
     * @param hit takes {@link Queries#HIT_STRIDE} elements; if there is no hit, the length of the ray, its end and a normal of 0 (infinite
     *     if that is more than a float holds). May be null
     * @return the handle, or 0 if the ray meets none; of several at the same distance that of the lowest id
     * @throws IllegalArgumentException if a value is not finite, or the array is too short
     */
    public long rayCast(float x, float y, float dx, float dy, float[] hit) {
        return searches.one(filter, QueryShape.RAY, x, y, dx, dy, 0, hit);
    }

    /**
     * Finds the first piece that each of many rays meets.
     *
     * @param rays x, y, dx and dy of one after the other
     * @param n number of rays, at least 0
     * @param handles takes the handle of each first piece, or 0; at least n elements
     * @param hits takes a hit for each ray, with or without a piece, as {@link #rayCast(float, float, float, float, float[])}
     *     does; may be null
     * @return how many rays meet a piece
     * @throws IllegalArgumentException if a value is not finite, or an array is too short
     */
    public int rayCast(float[] rays, int n, long[] handles, float[] hits) {
        return searches.one(filter, QueryShape.RAY, rays, n, handles, hits);
    }

    /**
     * Finds all pieces that a ray meets.
     *
     * @param x x of its start
     * @param y y of its start
     * @param dx how far it reaches along x
     * @param dy how far it reaches along y
     * @param handles takes their handles, by distance, then by id; only the first ones if it is too short
     * @param hits takes their hits, {@link Queries#HIT_STRIDE} elements each; only the first ones, and only as many handles, if it is too
     *     short; may be null
     * @return how many there are, which may be more than the arrays take
     * @throws IllegalArgumentException if a value is not finite
     */
    public int rayCastAll(float x, float y, float dx, float dy, long[] handles, float[] hits) {
        return searches.all(filter, QueryShape.RAY, x, y, dx, dy, 0, handles, hits);
    }

    /**
     * Finds all pieces that each of many rays meets. See {@link Queries} for batches.
     *
     * @param rays x, y, dx and dy of one after the other
     * @param n number of rays, at least 0
     * @param ends takes where the handles of each end; at least n elements
     * @param handles takes the handles
     * @param hits takes the hits, {@link Queries#HIT_STRIDE} elements each; may be null
     * @return how many there are for all rays together
     * @throws IllegalArgumentException if a value is not finite, or there are more than 2^31 - 1 results
     */
    public int rayCastAll(float[] rays, int n, int[] ends, long[] handles, float[] hits) {
        return searches.all(filter, QueryShape.RAY, rays, n, ends, handles, hits);
    }

    // ---- casts of discs
    // ----------------------------------------------------------------------------------------------

    /**
     * Finds the first piece that a moving disc meets.
     *
     * @param x x of its centre at the start
     * @param y y of its centre at the start
     * @param radius its radius, at least 0
     * @param dx how far it moves along x
     * @param dy how far it moves along y
     * @param hit takes {@link Queries#HIT_STRIDE} elements, as for a ray; may be null
     * @return the handle, or 0 if the disc meets none; of several at the same distance that of the lowest id
     * @throws IllegalArgumentException if a value is out of range, or the array is too short
     */
    public long circleCast(float x, float y, float radius, float dx, float dy, float[] hit) {
        return searches.one(filter, QueryShape.DISC_CAST, x, y, radius, dx, dy, hit);
    }

    /**
     * Finds the first piece that each of many moving discs meets.
     *
     * @param casts x, y, radius, dx and dy of one after the other
     * @param n number of discs, at least 0
     * @param handles takes the handle of each first piece, or 0; at least n elements
     * @param hits takes a hit for each disc, with or without a piece, as for rays; may be null
     * @return how many discs meet a piece
     * @throws IllegalArgumentException if a value is out of range, or an array is too short
     */
    public int circleCast(float[] casts, int n, long[] handles, float[] hits) {
        return searches.one(filter, QueryShape.DISC_CAST, casts, n, handles, hits);
    }

    /**
     * Finds all pieces that a moving disc meets; it passes through them.
     *
     * @param x x of its centre at the start
     * @param y y of its centre at the start
     * @param radius its radius, at least 0
     * @param dx how far it moves along x
     * @param dy how far it moves along y
     * @param handles takes their handles, by distance, then by id; only the first ones if it is too short
     * @param hits takes their hits, {@link Queries#HIT_STRIDE} elements each; only the first ones, and only as many handles, if it is too
     *     short; may be null
     * @return how many there are, which may be more than the arrays take
     * @throws IllegalArgumentException if a value is out of range
     */
    public int circleCastAll(float x, float y, float radius, float dx, float dy, long[] handles, float[] hits) {
        return searches.all(filter, QueryShape.DISC_CAST, x, y, radius, dx, dy, handles, hits);
    }

    /**
     * Finds all pieces that each of many moving discs meets. See {@link Queries} for batches.
     *
     * @param casts x, y, radius, dx and dy of one after the other
     * @param n number of discs, at least 0
     * @param ends takes where the handles of each end; at least n elements
     * @param handles takes the handles
     * @param hits takes the hits, {@link Queries#HIT_STRIDE} elements each; may be null
     * @return how many there are for all discs together
     * @throws IllegalArgumentException if a value is out of range, or there are more than 2^31 - 1 results
     */
    public int circleCastAll(float[] casts, int n, int[] ends, long[] handles, float[] hits) {
        return searches.all(filter, QueryShape.DISC_CAST, casts, n, ends, handles, hits);
    }
}
