package io.github.circles2d;

import io.github.circles2d.world.queries.QueryShape;
import io.github.circles2d.world.search.QueryFilter;
import io.github.circles2d.world.search.Searches;

/** The queries that are the same of circles, pieces of terrain and bodies: {@link Queries}, {@link TerrainQueries}, {@link BodyQueries}. */
abstract class ShapeQueries {
    final Searches searches;

    /** What is found; null for all. */
    final QueryFilter filter;

    ShapeQueries(Searches searches, QueryFilter filter) {
        this.searches = searches;
        this.filter = filter;
    }

    // ---- overlaps

    /**
     * Finds all that a disc overlaps or touches.
     *
     * @param x x of its centre
     * @param y y of its centre
     * @param radius its radius, at least 0; 0 for a point
     * @param handles takes their handles, the lowest id first; only the first ones if it is too short
     * @return how many there are, which may be more than the array takes
     * @throws IllegalArgumentException if a value is out of range
     */
    public int overlapCircle(float x, float y, float radius, long[] handles) {
        return searches.all(filter, QueryShape.DISC, x, y, radius, 0, 0, handles, null);
    }

    /**
     * Finds all that each of many discs overlaps or touches. See {@link Queries} for batches.
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
     * Finds all that a box overlaps or touches; its sides are parallel to the axes.
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
     * Finds all that each of many boxes overlaps or touches. See {@link Queries} for batches.
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

    // ---- rays

    /**
     * Finds what a ray meets first.
     *
     * @param x x of its start
     * @param y y of its start
     * @param dx how far it reaches along x
     * @param dy how far it reaches along y
     * @param hit takes {@link Queries#HIT_STRIDE} elements; if there is no hit, the length of the ray, its end and a normal of 0 (infinite
     *     if that is more than a float holds). May be null
     * @return the handle, or 0 if the ray meets nothing; of several at the same distance that of the lowest id
     * @throws IllegalArgumentException if a value is not finite, or the array is too short
     */
    public long rayCast(float x, float y, float dx, float dy, float[] hit) {
        return searches.one(filter, QueryShape.RAY, x, y, dx, dy, 0, hit);
    }

    /**
     * Finds what each of many rays meets first.
     *
     * @param rays x, y, dx and dy of one after the other
     * @param n number of rays, at least 0
     * @param handles takes the handle of what each meets first, or 0; at least n elements
     * @param hits takes a hit for each ray, whether or not it meets something, as {@link #rayCast(float, float, float, float, float[])}
     *     does; may be null
     * @return how many rays meet something
     * @throws IllegalArgumentException if a value is not finite, or an array is too short
     */
    public int rayCast(float[] rays, int n, long[] handles, float[] hits) {
        return searches.one(filter, QueryShape.RAY, rays, n, handles, hits);
    }

    /**
     * Finds all that a ray meets.
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
     * Finds all that each of many rays meets. See {@link Queries} for batches.
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

    /**
     * Finds what a moving disc meets first.
     *
     * @param x x of its centre at the start
     * @param y y of its centre at the start
     * @param radius its radius, at least 0
     * @param dx how far it moves along x
     * @param dy how far it moves along y
     * @param hit takes {@link Queries#HIT_STRIDE} elements, as for a ray; may be null
     * @return the handle, or 0 if the disc meets nothing; of several at the same distance that of the lowest id
     * @throws IllegalArgumentException if a value is out of range, or the array is too short
     */
    public long circleCast(float x, float y, float radius, float dx, float dy, float[] hit) {
        return searches.one(filter, QueryShape.DISC_CAST, x, y, radius, dx, dy, hit);
    }

    /**
     * Finds what each of many moving discs meets first.
     *
     * @param casts x, y, radius, dx and dy of one after the other
     * @param n number of discs, at least 0
     * @param handles takes the handle of what each meets first, or 0; at least n elements
     * @param hits takes a hit for each disc, whether or not it meets something, as for rays; may be null
     * @return how many discs meet something
     * @throws IllegalArgumentException if a value is out of range, or an array is too short
     */
    public int circleCast(float[] casts, int n, long[] handles, float[] hits) {
        return searches.one(filter, QueryShape.DISC_CAST, casts, n, handles, hits);
    }

    /**
     * Finds all that a moving disc meets; it passes through them.
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
     * Finds all that each of many moving discs meets. See {@link Queries} for batches.
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
