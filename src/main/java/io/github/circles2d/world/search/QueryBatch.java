package io.github.circles2d.world.search;

import io.github.circles2d.world.model.Bounds;
import io.github.circles2d.world.model.Limits;
import io.github.circles2d.world.queries.CastSearch;
import io.github.circles2d.world.queries.QueryShape;
import io.github.circles2d.world.shared.WorldSettings;

/** The queries of a call, and the caller's arrays for what they find. A single query is a batch of one. */
final class QueryBatch {
    /** Says that no query of the batch is at fault. */
    private static final int NONE = -1;

    private final WorldSettings settings;
    private final float[] single = new float[QueryShape.MOST_NUMBERS];
    private final int[] singleEnd = new int[1];

    QueryShape shape;
    QueryFilter filter;

    /** Whether the caller made a batch: then exceptions name the query, and what has no result is filled up. */
    boolean isBatch;

    float[] queries;
    int n;

    /** How far the nearest may be. */
    float within;

    /** How many are looked for at most; 1 unless the nearest are. */
    int most;

    int[] ends;
    long[] handles;
    float[] hits;
    float[] distances;

    /** The numbers of the query that is being answered. Another thread may write into the caller's. */
    final float[] numbers = new float[QueryShape.MOST_NUMBERS];

    /** The query that is being answered, or {@link #NONE}. */
    int query = NONE;

    QueryBatch(WorldSettings settings) {
        this.settings = settings;
    }

    void begin(QueryFilter only, QueryShape what, float[] numbers, int count) {
        end();
        Limits.notNull(what.plural(), numbers);
        int has = numbers.length / what.stride();
        if (count < 0 || count > has) {
            throw new IllegalArgumentException("n is " + count + ", but must be from 0 to " + has + ", as "
                    + what.plural() + " has elements for " + has);
        }
        shape = what;
        filter = only;
        isBatch = true;
        queries = numbers;
        n = count;
        most = 1;
    }

    /** Begins with a single query: its numbers, and zeros. */
    void begin(QueryFilter only, QueryShape what, float a, float b, float c, float d, float e) {
        single[0] = a;
        single[1] = b;
        single[2] = c;
        single[3] = d;
        single[4] = e;
        begin(only, what, single, 1);
        isBatch = false;
        ends = singleEnd;
    }

    /** Lets go of the caller's arrays. */
    void end() {
        queries = null;
        filter = null;
        ends = null;
        handles = null;
        hits = null;
        distances = null;
        query = NONE;
    }

    // ---- arguments

    /** Takes the arrays of queries that find all. */
    void takeAll(long[] to, float[] hitsTo) {
        handles = Limits.notNull("handles", to);
        hits = hitsTo;
    }

    void takeEnds(int[] to) {
        ends = Limits.notNull("ends", to);
        requireRoom("ends", to.length, n);
    }

    /** Takes the arrays of queries that find a few each. */
    void takeFew(long[] to, float[] distancesTo) {
        handles = Limits.notNull("handles", to);
        requireRoom("handles", to.length, (long) n * most);
        if (distancesTo != null) {
            requireRoom("distances", distancesTo.length, (long) n * most);
        }
        distances = distancesTo;
    }

    /** Takes the array for the first hits, or those of the nearest. */
    void takeHits(String name, float[] to) {
        if (to != null) {
            requireRoom(name, to.length, (long) CastSearch.HIT_STRIDE * n * most);
        }
        hits = to;
    }

    private static void requireRoom(String what, int has, long needs) {
        if (has < needs) {
            throw new IllegalArgumentException(what + " has room for " + has + " elements, but needs " + needs);
        }
    }

    // ---- queries

    /** Where the numbers of a query begin. */
    int at(int q) {
        return shape.stride() * q;
    }

    /** Goes on to a query: takes its {@link #numbers}, checks them, and brings the place inside the bounds where an axis wraps. */
    void take(int q) {
        query = q;
        System.arraycopy(queries, at(q), numbers, 0, shape.stride());
        shape.check(numbers, 0);
        Bounds bounds = settings.bounds();
        if (shape == QueryShape.BOX) {
            shift(0, 0.5f * numbers[0] + 0.5f * numbers[2], bounds.placeX(0.5f * numbers[0] + 0.5f * numbers[2]));
            shift(1, 0.5f * numbers[1] + 0.5f * numbers[3], bounds.placeY(0.5f * numbers[1] + 0.5f * numbers[3]));
        } else {
            numbers[0] = bounds.placeX(numbers[0]);
            numbers[1] = bounds.placeY(numbers[1]);
        }
    }

    /** Moves a box along an axis, by the way of its centre. */
    private void shift(int axis, float from, float to) {
        if (to != from) {
            numbers[axis] += to - from;
            numbers[axis + 2] += to - from;
        }
    }

    /** How many results of queries that find all there is room for. */
    int room() {
        return hits == null ? handles.length : Math.min(handles.length, hits.length / CastSearch.HIT_STRIDE);
    }

    /** Takes how many a query finds, behind so many of those before. Returns where its results end. */
    int end(int q, int total, int count) {
        query = q;
        if (count > Integer.MAX_VALUE - total) {
            throw new IllegalArgumentException("the queries up to this one find more than " + Integer.MAX_VALUE
                    + " circles, but must find less in one call");
        }
        int end = total + count;
        ends[q] = end;
        return end;
    }

    /** Takes number k of the nearest of a query. */
    void takeNearest(int q, int k, long handle, double distance) {
        handles[most * q + k] = handle;
        if (distances != null) {
            distances[most * q + k] = (float) distance;
        }
    }

    /** Fills the places up that the nearest of a query leave, in a batch. */
    void fillUp(int q, int count) {
        for (int k = count; isBatch && k < most; k++) {
            takeNearest(q, k, 0, Double.POSITIVE_INFINITY);
            if (hits != null) {
                CastSearch.writeNone(hits, CastSearch.HIT_STRIDE * (most * q + k));
            }
        }
    }

    /** Adds to a refusal which query of a batch is refused. */
    Throwable named(Throwable e) {
        return isBatch && query != NONE && e instanceof IllegalArgumentException
                ? new IllegalArgumentException("query " + query + ": " + e.getMessage(), e)
                : e;
    }

    /** What answers the queries of a batch, and returns how much they find. */
    interface Answers {
        /** Queries that find all. */
        int all(QueryBatch batch);

        /** Queries that find one each or none; how many find one. A single query's handle is in element 0. */
        int one(QueryBatch batch);

        /** Queries for the nearest. */
        int nearest(QueryBatch batch);
    }
}
