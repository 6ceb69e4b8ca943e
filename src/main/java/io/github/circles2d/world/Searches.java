package io.github.circles2d.world;

import io.github.circles2d.world.model.Limits;
import io.github.circles2d.world.queries.QueryShape;

/**
 * The searches for circles, one or many in a call. The device that has the circles answers where that is faster, else a tree on the
 * host; both find the same. {@code Queries} documents what each call gives. Where a call takes a filter, null admits all circles.
 */
public final class Searches {
    private final Simulation simulation;
    private final Guard guard;
    private final QueryBatch batch;
    private final HostAnswers host;
    private final DeviceAnswers device;

    /** Takes the handle that a single query finds. */
    private final long[] found = new long[1];

    Searches(Simulation simulation) {
        this.simulation = simulation;
        batch = new QueryBatch(simulation);
        guard = simulation.guard;
        host = new HostAnswers(simulation);
        device = new DeviceAnswers(simulation);
    }

    /** Does nothing, if a query can be made at all. */
    public void requireOpen() {
        guard.enter();
        guard.user = null;
    }

    /** Admits the circles whose kind's category has a bit of a mask. */
    public CategoryFilter filter(int mask) {
        requireOpen();
        return new CategoryFilter(simulation, mask);
    }

    /** Answers on any device from now on, whether or not it is the faster way: for tests. */
    void alwaysOnDevice() {
        device.always();
    }

    /** How many calls the device has answered: for tests. */
    int answeredOnDevice() {
        return device.answered();
    }

    /**
     * Finds all circles of a query.
     *
     * @param a its numbers, and zeros
     * @param hits takes hits of paths; may be null
     */
    public int all(
            CategoryFilter filter,
            QueryShape shape,
            float a,
            float b,
            float c,
            float d,
            float e,
            long[] handles,
            float[] hits) {
        guard.enter();
        try {
            batch.begin(filter, shape, a, b, c, d, e);
            batch.takeAll(handles, hits);
            return answerAll();
        } catch (RuntimeException | Error failure) {
            throw guard.failed(failure);
        } finally {
            guard.user = null;
        }
    }

    /**
     * Finds all circles of each query of a batch.
     *
     * @param hits takes hits of paths; may be null
     */
    public int all(
            CategoryFilter filter, QueryShape shape, float[] queries, int n, int[] ends, long[] handles, float[] hits) {
        guard.enter();
        try {
            batch.begin(filter, shape, queries, n);
            batch.takeEnds(ends);
            batch.takeAll(handles, hits);
            return answerAll();
        } catch (RuntimeException | Error e) {
            throw guard.failed(batch.named(e));
        } finally {
            guard.user = null;
        }
    }

    private int answerAll() {
        int total = device.all(batch);
        if (total == DeviceAnswers.LEFT) {
            total = host.all(batch);
        }
        batch.end();
        return total;
    }

    /**
     * Finds the circle at a point, or the first on a path.
     *
     * @param a the query's numbers, and zeros
     * @param hit takes the hit of a path; may be null
     */
    public long one(CategoryFilter filter, QueryShape shape, float a, float b, float c, float d, float e, float[] hit) {
        guard.enter();
        try {
            batch.begin(filter, shape, a, b, c, d, e);
            batch.takeFew(found, null);
            batch.takeHits("hit", hit);
            answerOne();
            return found[0];
        } catch (RuntimeException | Error failure) {
            throw guard.failed(failure);
        } finally {
            guard.user = null;
        }
    }

    /**
     * Finds the circle at each of many points, or the first on each of many paths.
     *
     * @param hits takes the hits of paths; may be null
     */
    public int one(CategoryFilter filter, QueryShape shape, float[] queries, int n, long[] handles, float[] hits) {
        guard.enter();
        try {
            batch.begin(filter, shape, queries, n);
            batch.takeFew(handles, null);
            batch.takeHits("hits", hits);
            return answerOne();
        } catch (RuntimeException | Error e) {
            throw guard.failed(batch.named(e));
        } finally {
            guard.user = null;
        }
    }

    private int answerOne() {
        int count = device.one(batch);
        if (count == DeviceAnswers.LEFT) {
            count = host.one(batch);
        }
        batch.end();
        return count;
    }

    /** Finds the circles nearest to a point. */
    public int nearest(
            CategoryFilter filter, float x, float y, float within, int most, long[] handles, float[] distances) {
        guard.enter();
        try {
            batch.begin(filter, QueryShape.NEAREST, x, y, 0, 0, 0);
            return answerNearest(within, most, handles, distances);
        } catch (RuntimeException | Error e) {
            throw guard.failed(e);
        } finally {
            guard.user = null;
        }
    }

    /** Finds the circles nearest to each of many points. */
    public int nearest(
            CategoryFilter filter, float[] points, int n, float within, int most, long[] handles, float[] distances) {
        guard.enter();
        try {
            batch.begin(filter, QueryShape.NEAREST, points, n);
            return answerNearest(within, most, handles, distances);
        } catch (RuntimeException | Error e) {
            throw guard.failed(batch.named(e));
        } finally {
            guard.user = null;
        }
    }

    private int answerNearest(float within, int most, long[] handles, float[] distances) {
        batch.within = Limits.within("within", within, 0, Float.POSITIVE_INFINITY);
        batch.most = Limits.within("most", most, 1, Integer.MAX_VALUE);
        batch.takeFew(handles, distances);
        int total = device.nearest(batch);
        if (total == DeviceAnswers.LEFT) {
            total = host.nearest(batch);
        }
        batch.end();
        return total;
    }
}
