package io.github.circles2d.world.search;

import io.github.circles2d.world.queries.CastSearch;
import io.github.circles2d.world.queries.CircleTree;
import io.github.circles2d.world.queries.QueryShape;
import io.github.circles2d.world.queries.RemoteSearch;
import io.github.circles2d.world.shared.WorldParts;

/**
 * Answers queries on the device that has the circles, where that is likely to be the faster way: to read a million circles and to build a
 * tree of them takes a host some 50 ms, and a call of the device a tenth of one.
 *
 * <p>The rule, on a GPU: a batch of at least {@link #LEAST_BATCH} queries among at least {@link #LEAST_CIRCLES} circles; or, among at
 * least {@link #MANY_CIRCLES}, smaller calls that since the last change have not yet taken about as long as it would take to read all
 * circles and build a tree. So whoever asks once or twice in a frame never pays for that, and whoever asks thousands of times one by one
 * pays twice at most. On an NVIDIA H200 10,000 rays among 100,000 circles take 1.0 ms behind a step and 0.7 again, while its host takes
 * 11 to 14 ms for as many among 1,250 to 15,000. The other numbers are estimates, by what a transfer, a launch and a tree cost.
 */
final class DeviceAnswers implements QueryBatch.Answers {
    private static final int LEAST_CIRCLES = 1000;
    private static final int LEAST_BATCH = 512;
    private static final int MANY_CIRCLES = 20_000;

    /** A call takes about as long as it takes to read so many circles and build a tree of them. */
    private static final int CIRCLES_A_CALL = 1000;

    /** What a method returns that leaves the queries to the host. */
    static final int LEFT = -1;

    private final WorldParts world;
    private final CastSearch hits = new CastSearch(new CircleTree());
    private RemoteSearch search;

    // Not the caller's arrays, into which another thread may write.

    /** The numbers of the queries, which have been checked. */
    private float[] queries = new float[QueryShape.MOST_NUMBERS];

    /** By query: where its circles end. */
    private int[] ends = new int[1];

    /** Whether the rule is left out, for tests. */
    private boolean always;

    /** Calls of small batches in the state of {@link #changes}. */
    private int calls;

    private long changes;

    /** Calls that were answered, whatever the state. */
    private int answered;

    DeviceAnswers(WorldParts world) {
        this.world = world;
    }

    /** Answers on any device, whether or not it is the faster way. */
    void always() {
        always = true;
    }

    /** How many calls were answered. */
    int answered() {
        return answered;
    }

    /** Whether the device answers such a batch. Checks all of its queries if so. */
    private boolean takes(QueryBatch batch) {
        search = world.settings.bounds().wraps() ? null : world.pipeline.search(); // kernels do not look across a seam
        if (search == null || batch.n == 0 || !always && !isWorthIt(batch.n)) {
            return false;
        }
        int stride = batch.shape.stride();
        if (queries.length < batch.n * stride) {
            queries = new float[batch.n * stride];
        }
        for (int q = 0; q < batch.n; q++) {
            batch.take(q);
            System.arraycopy(batch.numbers, 0, queries, batch.at(q), stride);
        }
        world.pending.settle();
        return search.show(world.last.changes());
    }

    private boolean isWorthIt(int n) {
        if (world.handles.size() < LEAST_CIRCLES || !search.pays()) {
            return false;
        }
        if (n >= LEAST_BATCH) {
            return true;
        }
        if (changes != world.last.changes()) {
            changes = world.last.changes();
            calls = 0;
        }
        return world.handles.size() >= MANY_CIRCLES && ++calls <= world.handles.size() / CIRCLES_A_CALL;
    }

    private static int[] filter(QueryBatch batch) {
        return batch.filter == null ? null : batch.filter.words();
    }

    /** May be {@link #LEFT}. */
    @Override
    public int all(QueryBatch batch) {
        if (!takes(batch)) {
            return LEFT;
        }
        if (ends.length < batch.n) {
            ends = new int[Math.max(batch.n, ends.length + (ends.length >> 1))];
        }
        if (!search.count(batch.shape, queries, batch.n, filter(batch), ends)) {
            return LEFT;
        }
        int room = batch.room();
        int total = 0;
        int listed = 0;
        for (int q = 0; q < batch.n; q++) {
            listed += total < room ? 1 : 0;
            total = batch.end(q, total, ends[q]);
            ends[q] = total;
        }
        if (listed > 0 && !search.list(listed, ends, batch.hits != null)) {
            return LEFT;
        }
        int from = 0;
        for (int q = 0; q < listed; q++) {
            take(batch, q, from, Math.min(ends[q], room));
            from = ends[q];
        }
        answered++;
        return total;
    }

    private void take(QueryBatch batch, int q, int from, int end) {
        if (batch.hits != null && from < end) {
            hits.aim(batch.shape, queries, batch.at(q));
        }
        for (int k = from; k < end; k++) {
            batch.handles[k] = world.handles.handle(search.id(k));
            if (batch.hits != null) {
                writeHit(batch, k, k);
            }
        }
    }

    private void writeHit(QueryBatch batch, int found, int k) {
        hits.writeHit(search.distance(found), search.x(found), search.y(found), batch.hits, CastSearch.HIT_STRIDE * k);
    }

    /** May be {@link #LEFT}. */
    @Override
    public int one(QueryBatch batch) {
        if (!takes(batch) || !search.few(batch.shape, queries, batch.n, 0, 1, filter(batch), batch.hits != null)) {
            return LEFT;
        }
        int count = 0;
        for (int q = 0; q < batch.n; q++) {
            int id = search.id(q);
            batch.handles[q] = id < 0 ? 0 : world.handles.handle(id);
            count += id < 0 ? 0 : 1;
            if (batch.hits != null) {
                hits.aim(batch.shape, queries, batch.at(q));
                if (id < 0) {
                    hits.writeMiss(batch.hits, CastSearch.HIT_STRIDE * q);
                } else {
                    writeHit(batch, q, q);
                }
            }
        }
        answered++;
        return count;
    }

    /** May be {@link #LEFT}. */
    @Override
    public int nearest(QueryBatch batch) {
        int most = batch.most;
        if (!takes(batch)
                || !search.few(
                        QueryShape.NEAREST,
                        queries,
                        batch.n,
                        batch.within,
                        most,
                        filter(batch),
                        batch.distances != null)) {
            return LEFT;
        }
        int total = 0;
        for (int q = 0; q < batch.n; q++) {
            int count = 0;
            while (count < most && search.id(most * q + count) >= 0) {
                int found = most * q + count;
                double distance = batch.distances == null ? 0 : search.distance(found);
                batch.takeNearest(q, count, world.handles.handle(search.id(found)), distance);
                count++;
            }
            batch.fillUp(q, count);
            total += count;
        }
        answered++;
        return total;
    }
}
