package io.github.circles2d.world.search;

import io.github.circles2d.world.circles.CircleField;
import io.github.circles2d.world.circles.Handle;
import io.github.circles2d.world.model.Limits;
import io.github.circles2d.world.queries.CastSearch;
import io.github.circles2d.world.queries.QueryShape;
import io.github.circles2d.world.queries.Search;
import io.github.circles2d.world.queries.TreeSearch;
import io.github.circles2d.world.shared.LastReading;
import io.github.circles2d.world.shared.WorldParts;

/**
 * The searches for circles, for pieces of terrain, or for bodies, one or many in a call. The device that has the circles answers where that is faster,
 * else the host; both find the same. {@code Queries} documents what each call gives. Where a call takes a filter, null admits all.
 */
public final class Searches {
    /** Kinds of answers. */
    private enum Wanted {
        ALL,
        ONE,
        NEAREST
    }

    private final WorldParts world;
    private final View view;
    private final QueryBatch batch;
    private final HostAnswers host;

    /** Null for pieces of terrain and bodies, which are on the host. */
    private final DeviceAnswers device;

    /** Takes the handle that a single query finds. */
    private final long[] found = new long[1];

    private Searches(WorldParts world, View view, DeviceAnswers device) {
        this.world = world;
        this.view = view;
        this.device = device;
        host = new HostAnswers(view);
        batch = new QueryBatch(world.settings);
    }

    /** Searches for circles. */
    public static Searches forCircles(WorldParts world) {
        return new Searches(world, new CircleView(world), new DeviceAnswers(world));
    }

    /** Searches for pieces of terrain, or bodies that are pushed. */
    public static Searches forThings(WorldParts world, View things) {
        return new Searches(world, things, null);
    }

    /** Does nothing, if a query can be made at all. */
    public void requireOpen() {
        world.guard.check();
    }

    /** Admits those whose kind's category has a bit of a mask, but for the circle that the filter before leaves out. */
    public QueryFilter filter(QueryFilter before, int mask) {
        requireOpen();
        return QueryFilter.masked(world.kinds, view, before, mask);
    }

    /** Admits those that the filter before admits, with another circle left out, which may be gone, or 0 for none. */
    public QueryFilter without(QueryFilter before, long circle) {
        requireOpen();
        if (!Handle.mayBeOfCircle(circle)) {
            throw new IllegalArgumentException(WorldParts.goneCircle(circle));
        }
        return QueryFilter.without(world.kinds, view, before, circle);
    }

    /** The same with a body left out. */
    public QueryFilter withoutBody(QueryFilter before, long body) {
        requireOpen();
        if (body != 0 && !Handle.has(body, Handle.RIGID)) {
            throw new IllegalArgumentException(WorldParts.goneRigid(body));
        }
        return QueryFilter.without(world.kinds, view, before, body);
    }

    /** Answers on any device from now on, whether or not it is the faster way: for tests. */
    public void alwaysOnDevice() {
        device.always();
    }

    /** How many calls the device has answered: for tests. */
    public int answeredOnDevice() {
        return device.answered();
    }

    /** All circles of a query of these numbers and zeros; hits of paths may be null. */
    public int all(
            QueryFilter filter,
            QueryShape shape,
            float a,
            float b,
            float c,
            float d,
            float e,
            long[] to,
            float[] hits) {
        return (int) answer(Wanted.ALL, filter, shape, false, null, 1, a, b, c, d, e, 0, 1, null, to, hits);
    }

    /** The same for each query of a batch. */
    public int all(QueryFilter filter, QueryShape shape, float[] queries, int n, int[] ends, long[] to, float[] hits) {
        return (int) answer(Wanted.ALL, filter, shape, true, queries, n, 0, 0, 0, 0, 0, 0, 1, ends, to, hits);
    }

    /** The circle at a point, or the first on a path; its hit may be null. */
    public long one(QueryFilter filter, QueryShape shape, float a, float b, float c, float d, float e, float[] hit) {
        return answer(Wanted.ONE, filter, shape, false, null, 1, a, b, c, d, e, 0, 1, null, found, hit);
    }

    /** The same for each query of a batch. */
    public int one(QueryFilter filter, QueryShape shape, float[] queries, int n, long[] to, float[] hits) {
        return (int) answer(Wanted.ONE, filter, shape, true, queries, n, 0, 0, 0, 0, 0, 0, 1, null, to, hits);
    }

    /** The piece or body nearest to a point, or 0. */
    public long nearestOne(QueryFilter filter, float x, float y, float within, float[] hit) {
        QueryShape shape = QueryShape.NEAREST;
        found[0] = 0;
        answer(Wanted.NEAREST, filter, shape, false, null, 1, x, y, 0, 0, 0, within, 1, null, found, hit);
        return found[0];
    }

    /** Finds the circles nearest to a point, and their distances, or pieces or bodies, and their hits. */
    public int nearest(QueryFilter filter, float x, float y, float within, int most, long[] to, float[] distances) {
        QueryShape shape = QueryShape.NEAREST;
        return (int)
                answer(Wanted.NEAREST, filter, shape, false, null, 1, x, y, 0, 0, 0, within, most, null, to, distances);
    }

    /** The same for each of many points. */
    public int nearest(
            QueryFilter filter, float[] points, int n, float within, int most, long[] to, float[] distances) {
        QueryShape shape = QueryShape.NEAREST;
        return (int) answer(
                Wanted.NEAREST, filter, shape, true, points, n, 0, 0, 0, 0, 0, within, most, null, to, distances);
    }

    /** A single query has the numbers a to e. Returns the number of circles found; of a single query for one circle, that circle. */
    private long answer(
            Wanted wanted,
            QueryFilter filter,
            QueryShape shape,
            boolean isBatch,
            float[] queries,
            int n,
            float a,
            float b,
            float c,
            float d,
            float e,
            float within,
            int most,
            int[] ends,
            long[] to,
            float[] places) {
        world.guard.enter();
        try {
            if (isBatch) {
                batch.begin(filter, shape, queries, n);
            } else {
                batch.begin(filter, shape, a, b, c, d, e);
            }
            if (wanted == Wanted.ALL) {
                if (isBatch) {
                    batch.takeEnds(ends);
                }
                batch.takeAll(to, places);
            } else if (wanted == Wanted.ONE) {
                batch.takeFew(to, null);
                batch.takeHits(isBatch ? "hits" : "hit", places);
            } else {
                batch.within = Limits.within("within", within, 0, Float.POSITIVE_INFINITY);
                batch.most = Limits.within("most", most, 1, Integer.MAX_VALUE);
                batch.takeFew(to, device == null ? null : places);
                batch.takeHits(isBatch || most > 1 ? "hits" : "hit", device == null ? places : null);
            }
            int count = answer(wanted);
            batch.end();
            return wanted == Wanted.ONE && !isBatch ? to[0] : count;
        } catch (RuntimeException | Error thrown) {
            throw world.guard.failed(batch.named(thrown));
        } finally {
            world.guard.leave();
        }
    }

    private int answer(Wanted wanted) {
        int count = device == null ? DeviceAnswers.LEFT : answer(wanted, device);
        return count == DeviceAnswers.LEFT ? answer(wanted, host) : count;
    }

    private int answer(Wanted wanted, QueryBatch.Answers by) {
        return switch (wanted) {
            case ALL -> by.all(batch);
            case ONE -> by.one(batch);
            case NEAREST -> by.nearest(batch);
        };
    }

    /** Answers queries by a tree on the host. */
    private static final class HostAnswers implements QueryBatch.Answers {
        private final View view;
        private Search search;

        HostAnswers(View view) {
            this.view = view;
        }

        /** Goes on to a query. What there is now is shown once the first one has been checked: a call that is refused waits for nothing. */
        private void take(QueryBatch batch, int q) {
            batch.take(q);
            if (q == 0) {
                search = view.show();
            }
        }

        @Override
        public int all(QueryBatch batch) {
            int room = batch.room();
            int total = 0;
            for (int q = 0; q < batch.n; q++) {
                take(batch, q);
                int count = search.all(batch.shape, batch.numbers, batch.filter);
                int end = batch.end(q, total, count);
                for (int k = total; k < Math.min(end, room); k++) {
                    batch.handles[k] = view.handle(search.id(batch.shape, k - total));
                    if (batch.hits != null) {
                        search.writeHit(k - total, batch.hits, CastSearch.HIT_STRIDE * k);
                    }
                }
                total = end;
            }
            return total;
        }

        @Override
        public int one(QueryBatch batch) {
            int count = 0;
            for (int q = 0; q < batch.n; q++) {
                take(batch, q);
                int id = search.first(batch.shape, batch.numbers, batch.filter, batch.hits, CastSearch.HIT_STRIDE * q);
                batch.handles[q] = id < 0 ? 0 : view.handle(id);
                count += id < 0 ? 0 : 1;
            }
            return count;
        }

        @Override
        public int nearest(QueryBatch batch) {
            int total = 0;
            for (int q = 0; q < batch.n; q++) {
                take(batch, q);
                int count = search.nearest(batch.numbers[0], batch.numbers[1], batch.within, batch.most, batch.filter);
                for (int k = 0; k < count; k++) {
                    batch.takeNearest(q, k, view.handle(search.nearestId(k)), search.nearestDistance(k));
                    if (batch.hits != null) {
                        search.writeNearest(k, batch.hits, CastSearch.HIT_STRIDE * (batch.most * q + k));
                    }
                }
                batch.fillUp(q, count);
                total += count;
            }
            return total;
        }
    }

    /** The circles. The first look after a change reads all of them and builds a tree. */
    private static final class CircleView implements View {
        private final WorldParts world;
        private final TreeSearch search = new TreeSearch();
        private int[] ids = new int[0];

        /** Which reading the tree shows, by {@link LastReading#number}; none at first. */
        private long shown;

        CircleView(WorldParts world) {
            this.world = world;
        }

        @Override
        public Search show() {
            float[] circles = world.last.circles();
            if (shown != world.last.number()) {
                int n = world.handles.size();
                if (ids.length < n) {
                    ids = new int[Math.max(n, ids.length + (ids.length >> 1))];
                }
                int k = 0;
                for (int id = 0; k < n; id++) {
                    if (world.handles.lives(id)) {
                        ids[k++] = id;
                    }
                }
                shown = 0; // until there has been memory for them
                search.build(circles, ids, n, world.settings.bounds());
                shown = world.last.number();
            }
            return search;
        }

        @Override
        public long handle(int id) {
            return world.handles.handle(id);
        }

        @Override
        public int find(long handle) {
            return world.handles.find(handle);
        }

        @Override
        public int kind(int id) {
            return world.handles.fields().getInt(CircleField.KIND, id);
        }
    }
}
