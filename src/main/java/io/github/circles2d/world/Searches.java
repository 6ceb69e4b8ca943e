package io.github.circles2d.world;

import io.github.circles2d.world.circles.HandleTable;
import io.github.circles2d.world.model.Bounds;
import io.github.circles2d.world.model.Limits;
import io.github.circles2d.world.queries.CastSearch;
import io.github.circles2d.world.queries.CircleTree;
import io.github.circles2d.world.queries.IdFilter;
import io.github.circles2d.world.queries.Images;
import io.github.circles2d.world.queries.NearestSearch;
import io.github.circles2d.world.queries.OverlapSearch;
import java.util.Objects;

/**
 * The searches for circles, one or many in a call. The first after a change reads all circles and builds a {@link CircleTree},
 * which the others use until the next change. {@code Queries} documents what each call gives.
 */
public final class Searches {
    // numbers that describe a query
    public static final int POINT = 2;
    public static final int DISC = 3;
    public static final int BOX = 4;
    public static final int RAY = 4;
    public static final int DISC_CAST = 5;

    /** The filter of searches that name none. */
    private static final IdFilter ALL = null;

    private static final int NO_BATCH = -1;

    private final Simulation simulation;
    private final Guard guard;
    private final HandleTable handles;
    private final LastReading last;
    private final CircleTree tree = new CircleTree();
    private final Images images = new Images();
    private final OverlapSearch overlaps = new OverlapSearch(tree);
    private final NearestSearch nearest = new NearestSearch(tree);
    private final CastSearch casts = new CastSearch(tree);
    private int[] ids = new int[0];

    /** Which reading the tree shows, by {@link LastReading#number}; none at first. */
    private long shown;

    /** The query of a batch that is being answered. */
    private int query = NO_BATCH;

    Searches(Simulation simulation) {
        this.simulation = simulation;
        guard = simulation.guard;
        handles = simulation.handles;
        last = simulation.last;
    }

    /** Finds what a disc overlaps or touches. */
    public int disc(float x, float y, float radius, long[] to) {
        guard.enter();
        try {
            Objects.requireNonNull(to, "handles");
            int count = findDisc(x, y, radius);
            takeOverlaps(count, 0, to);
            return count;
        } catch (RuntimeException | Error e) {
            throw guard.failed(e);
        } finally {
            guard.user = null;
        }
    }

    /** Finds what each of many discs overlaps or touches. */
    public int discs(float[] discs, int n, int[] ends, long[] to) {
        guard.enter();
        try {
            requireQueries("discs", discs, n, DISC);
            requireResults(n, ends, to);
            int total = 0;
            for (query = 0; query < n; query++) {
                int at = DISC * query;
                int count = findDisc(discs[at], discs[at + 1], discs[at + 2]);
                ends[query] = end(total, count);
                takeOverlaps(count, total, to);
                total = ends[query];
            }
            return total;
        } catch (RuntimeException | Error e) {
            throw guard.failed(named(e));
        } finally {
            query = NO_BATCH;
            guard.user = null;
        }
    }

    /** Finds what a box overlaps or touches. */
    public int box(float minX, float minY, float maxX, float maxY, long[] to) {
        guard.enter();
        try {
            Objects.requireNonNull(to, "handles");
            int count = findBox(minX, minY, maxX, maxY);
            takeOverlaps(count, 0, to);
            return count;
        } catch (RuntimeException | Error e) {
            throw guard.failed(e);
        } finally {
            guard.user = null;
        }
    }

    /** Finds what each of many boxes overlaps or touches. */
    public int boxes(float[] boxes, int n, int[] ends, long[] to) {
        guard.enter();
        try {
            requireQueries("boxes", boxes, n, BOX);
            requireResults(n, ends, to);
            int total = 0;
            for (query = 0; query < n; query++) {
                int at = BOX * query;
                int count = findBox(boxes[at], boxes[at + 1], boxes[at + 2], boxes[at + 3]);
                ends[query] = end(total, count);
                takeOverlaps(count, total, to);
                total = ends[query];
            }
            return total;
        } catch (RuntimeException | Error e) {
            throw guard.failed(named(e));
        } finally {
            query = NO_BATCH;
            guard.user = null;
        }
    }

    /** Finds the circle at a point. */
    public long pick(float x, float y) {
        guard.enter();
        try {
            return findAt(x, y);
        } catch (RuntimeException | Error e) {
            throw guard.failed(e);
        } finally {
            guard.user = null;
        }
    }

    /** Finds the circle at each of many points. */
    public int picks(float[] points, int n, long[] to) {
        guard.enter();
        try {
            requireQueries("points", points, n, POINT);
            Objects.requireNonNull(to, "handles");
            requireRoom("handles", to.length, n);
            int hits = 0;
            for (query = 0; query < n; query++) {
                long found = findAt(points[POINT * query], points[POINT * query + 1]);
                to[query] = found;
                hits += found == 0 ? 0 : 1;
            }
            return hits;
        } catch (RuntimeException | Error e) {
            throw guard.failed(named(e));
        } finally {
            query = NO_BATCH;
            guard.user = null;
        }
    }

    /** Finds the circles nearest to a point. */
    public int nearest(float x, float y, float within, int most, long[] to, float[] distances) {
        guard.enter();
        try {
            requireNearest(1, within, most, to, distances);
            int count = findNearest(x, y, within, most);
            takeNearest(count, 0, to, distances);
            return count;
        } catch (RuntimeException | Error e) {
            throw guard.failed(e);
        } finally {
            guard.user = null;
        }
    }

    /** Finds the circles nearest to each of many points. */
    public int nearest(float[] points, int n, float within, int most, long[] to, float[] distances) {
        guard.enter();
        try {
            requireQueries("points", points, n, POINT);
            requireNearest(n, within, most, to, distances);
            int total = 0;
            for (query = 0; query < n; query++) {
                int count = findNearest(points[POINT * query], points[POINT * query + 1], within, most);
                takeNearest(count, most * query, to, distances);
                for (int k = most * query + count; k < most * (query + 1); k++) {
                    to[k] = 0;
                    if (distances != null) {
                        distances[k] = Float.POSITIVE_INFINITY;
                    }
                }
                total += count;
            }
            return total;
        } catch (RuntimeException | Error e) {
            throw guard.failed(named(e));
        } finally {
            query = NO_BATCH;
            guard.user = null;
        }
    }

    /** Finds the first circle that a moving disc meets. */
    public long cast(float x, float y, float radius, float dx, float dy, float[] hit) {
        guard.enter();
        try {
            if (hit != null) {
                requireRoom("hit", hit.length, CastSearch.HIT_STRIDE);
            }
            aim(x, y, radius, dx, dy);
            return takeFirst(hit, 0);
        } catch (RuntimeException | Error e) {
            throw guard.failed(e);
        } finally {
            guard.user = null;
        }
    }

    /**
     * Finds the first circle that each of many moving discs meets.
     *
     * @param stride {@link #RAY} or {@link #DISC_CAST}
     */
    public int casts(float[] queries, int n, int stride, long[] to, float[] hits) {
        guard.enter();
        try {
            requireQueries(stride == RAY ? "rays" : "casts", queries, n, stride);
            Objects.requireNonNull(to, "handles");
            requireRoom("handles", to.length, n);
            if (hits != null) {
                requireRoom("hits", hits.length, (long) CastSearch.HIT_STRIDE * n);
            }
            int count = 0;
            for (query = 0; query < n; query++) {
                aim(queries, stride);
                to[query] = takeFirst(hits, CastSearch.HIT_STRIDE * query);
                count += to[query] == 0 ? 0 : 1;
            }
            return count;
        } catch (RuntimeException | Error e) {
            throw guard.failed(named(e));
        } finally {
            query = NO_BATCH;
            guard.user = null;
        }
    }

    /** Finds all circles that a moving disc meets. */
    public int castAll(float x, float y, float radius, float dx, float dy, long[] to, float[] hits) {
        guard.enter();
        try {
            Objects.requireNonNull(to, "handles");
            aim(x, y, radius, dx, dy);
            int count = casts.all(ALL);
            takeHits(count, 0, to, hits);
            return count;
        } catch (RuntimeException | Error e) {
            throw guard.failed(e);
        } finally {
            guard.user = null;
        }
    }

    /**
     * Finds all circles that each of many moving discs meets.
     *
     * @param stride {@link #RAY} or {@link #DISC_CAST}
     */
    public int castsAll(float[] queries, int n, int stride, int[] ends, long[] to, float[] hits) {
        guard.enter();
        try {
            requireQueries(stride == RAY ? "rays" : "casts", queries, n, stride);
            requireResults(n, ends, to);
            int total = 0;
            for (query = 0; query < n; query++) {
                aim(queries, stride);
                int count = casts.all(ALL);
                ends[query] = end(total, count);
                takeHits(count, total, to, hits);
                total = ends[query];
            }
            return total;
        } catch (RuntimeException | Error e) {
            throw guard.failed(named(e));
        } finally {
            query = NO_BATCH;
            guard.user = null;
        }
    }

    // ---- searching
    // ---------------------------------------------------------------------------------------------------

    /** Makes the tree that of the circles as of now. */
    private void show() {
        float[] circles = last.circles();
        if (shown == last.number()) {
            return;
        }
        int n = handles.size();
        if (ids.length < n) {
            ids = new int[Math.max(n, ids.length + (ids.length >> 1))];
        }
        int k = 0;
        for (int id = 0; k < n; id++) {
            if (handles.lives(id)) {
                ids[k++] = id;
            }
        }
        shown = 0;
        Bounds bounds = simulation.bounds;
        if (bounds.wraps()) {
            images.make(circles, ids, n, bounds);
            tree.build(images, n == 0 ? 0 : ids[n - 1] + 1, bounds);
        } else {
            tree.build(circles, ids, n);
        }
        shown = last.number();
    }

    private int findDisc(float x, float y, float radius) {
        requireFinite("x", x);
        requireFinite("y", y);
        requireRadius(radius);
        show();
        return overlaps.disc(simulation.bounds.placeX(x), simulation.bounds.placeY(y), radius, ALL);
    }

    private int findBox(float minX, float minY, float maxX, float maxY) {
        requireFinite("minX", minX);
        requireFinite("minY", minY);
        Limits.within("maxX", maxX, minX, Float.MAX_VALUE);
        Limits.within("maxY", maxY, minY, Float.MAX_VALUE);
        show();
        float offX = offset(simulation.bounds.placeX(0.5f * minX + 0.5f * maxX), 0.5f * minX + 0.5f * maxX);
        float offY = offset(simulation.bounds.placeY(0.5f * minY + 0.5f * maxY), 0.5f * minY + 0.5f * maxY);
        return overlaps.box(minX + offX, minY + offY, maxX + offX, maxY + offY, ALL);
    }

    /** How far a coordinate has been brought. A zero keeps the sign of what it is added to. */
    private static float offset(float to, float from) {
        return to == from ? -0f : to - from;
    }

    private long findAt(float x, float y) {
        requireFinite("x", x);
        requireFinite("y", y);
        show();
        int id = overlaps.pick(simulation.bounds.placeX(x), simulation.bounds.placeY(y), ALL);
        return id < 0 ? 0 : handles.handle(id);
    }

    private int findNearest(float x, float y, float within, int most) {
        requireFinite("x", x);
        requireFinite("y", y);
        show();
        return nearest.find(simulation.bounds.placeX(x), simulation.bounds.placeY(y), within, most, ALL);
    }

    private void aim(float[] queries, int stride) {
        int at = stride * query;
        boolean ray = stride == RAY;
        aim(
                queries[at],
                queries[at + 1],
                ray ? 0 : queries[at + 2],
                queries[at + stride - 2],
                queries[at + stride - 1]);
    }

    private void aim(float x, float y, float radius, float dx, float dy) {
        requireFinite("x", x);
        requireFinite("y", y);
        requireRadius(radius);
        requireFinite("dx", dx);
        requireFinite("dy", dy);
        show();
        casts.aim(simulation.bounds.placeX(x), simulation.bounds.placeY(y), radius, dx, dy);
    }

    // ---- results
    // -----------------------------------------------------------------------------------------------------

    private void takeOverlaps(int count, int from, long[] to) {
        int end = Math.min(count, to.length - from);
        for (int k = 0; k < end; k++) {
            to[from + k] = handles.handle(overlaps.id(k));
        }
    }

    private void takeNearest(int count, int from, long[] to, float[] distances) {
        for (int k = 0; k < count; k++) {
            to[from + k] = handles.handle(nearest.id(k));
            if (distances != null) {
                distances[from + k] = (float) nearest.distance(k);
            }
        }
    }

    private long takeFirst(float[] hits, int at) {
        boolean hit = casts.first(ALL);
        if (hits != null) {
            if (hit) {
                casts.writeHit(0, hits, at);
            } else {
                casts.writeMiss(hits, at);
            }
        }
        return hit ? handles.handle(casts.id(0)) : 0;
    }

    private void takeHits(int count, int from, long[] to, float[] hits) {
        int room = hits == null ? to.length : Math.min(to.length, hits.length / CastSearch.HIT_STRIDE);
        int end = Math.min(count, room - from);
        for (int k = 0; k < end; k++) {
            to[from + k] = handles.handle(casts.id(k));
            if (hits != null) {
                casts.writeHit(k, hits, CastSearch.HIT_STRIDE * (from + k));
            }
        }
    }

    /** Where the results of a query of a batch end. */
    private static int end(int total, int count) {
        if (count > Integer.MAX_VALUE - total) {
            throw new IllegalArgumentException("the queries up to this one find more than " + Integer.MAX_VALUE
                    + " circles, but must find less in one call");
        }
        return total + count;
    }

    // ---- arguments
    // ---------------------------------------------------------------------------------------------------

    private static void requireFinite(String what, float value) {
        Limits.within(what, value, -Float.MAX_VALUE, Float.MAX_VALUE);
    }

    private static void requireRadius(float radius) {
        Limits.within("radius", radius, 0, Float.MAX_VALUE);
    }

    private static void requireQueries(String what, float[] queries, int n, int stride) {
        Objects.requireNonNull(queries, what);
        if (n < 0 || n > queries.length / stride) {
            throw new IllegalArgumentException("the number of " + what + " is " + n + ", but must be from 0 to "
                    + queries.length / stride + ", for which the array has elements");
        }
    }

    private static void requireResults(int n, int[] ends, long[] to) {
        Objects.requireNonNull(ends, "ends");
        Objects.requireNonNull(to, "handles");
        requireRoom("ends", ends.length, n);
    }

    private static void requireNearest(int n, float within, int most, long[] to, float[] distances) {
        Limits.within("within", within, 0, Float.POSITIVE_INFINITY);
        Limits.within("the greatest number of circles", most, 1, Integer.MAX_VALUE);
        Objects.requireNonNull(to, "handles");
        requireRoom("handles", to.length, (long) n * most);
        if (distances != null) {
            requireRoom("distances", distances.length, (long) n * most);
        }
    }

    private static void requireRoom(String what, int has, long needs) {
        if (has < needs) {
            throw new IllegalArgumentException(what + " has room for " + has + " elements, but needs " + needs);
        }
    }

    /** Adds to a refusal which query of a batch is refused. */
    private Throwable named(Throwable e) {
        return query != NO_BATCH && e instanceof IllegalArgumentException
                ? new IllegalArgumentException("query " + query + ": " + e.getMessage(), e)
                : e;
    }
}
