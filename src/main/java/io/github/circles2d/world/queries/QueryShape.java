package io.github.circles2d.world.queries;

import io.github.circles2d.world.model.Limits;

/** What a query is about: which numbers describe it, one row each. Batches have them one query after the other. */
public enum QueryShape {
    /** The circle at a point: x, y. */
    POINT("points", 2),

    /** The circles nearest to a point: x, y. */
    NEAREST("points", 2),

    /** What a disc overlaps: x, y, radius. */
    DISC("discs", 3),

    /** What a box overlaps: minX, minY, maxX, maxY. */
    BOX("boxes", 4),

    /** What a ray meets: x, y, dx, dy. */
    RAY("rays", 4),

    /** What a moving disc meets: x, y, radius, dx, dy. */
    DISC_CAST("casts", 5);

    /** Most numbers of a query. */
    public static final int MOST_NUMBERS = 5;

    private final String plural;
    private final int stride;

    QueryShape(String plural, int stride) {
        this.plural = plural;
        this.stride = stride;
    }

    /** The name of an array of such queries. */
    public String plural() {
        return plural;
    }

    /** How many numbers describe a query. */
    public int stride() {
        return stride;
    }

    /** Whether it is a path, of which hits are told. */
    public boolean isCast() {
        return this == RAY || this == DISC_CAST;
    }

    /** The radius of the query that begins at an element; 0 if it has none. */
    public float radius(float[] queries, int at) {
        return this == DISC || this == DISC_CAST ? queries[at + 2] : 0;
    }

    /** How far the path that begins at an element goes along x. */
    public float dx(float[] queries, int at) {
        return queries[at + stride - 2];
    }

    /** How far the path that begins at an element goes along y. */
    public float dy(float[] queries, int at) {
        return queries[at + stride - 1];
    }

    /** Throws {@link IllegalArgumentException} if a number of the query that begins here is out of range. */
    public void check(float[] queries, int at) {
        if (this == BOX) {
            requireFinite("minX", queries[at]);
            requireFinite("minY", queries[at + 1]);
            Limits.within("maxX", queries[at + 2], queries[at], Float.MAX_VALUE);
            Limits.within("maxY", queries[at + 3], queries[at + 1], Float.MAX_VALUE);
            return;
        }
        requireFinite("x", queries[at]);
        requireFinite("y", queries[at + 1]);
        Limits.within("radius", radius(queries, at), 0, Float.MAX_VALUE);
        if (isCast()) {
            requireFinite("dx", dx(queries, at));
            requireFinite("dy", dy(queries, at));
        }
    }

    private static void requireFinite(String what, float value) {
        Limits.within(what, value, -Float.MAX_VALUE, Float.MAX_VALUE);
    }
}
