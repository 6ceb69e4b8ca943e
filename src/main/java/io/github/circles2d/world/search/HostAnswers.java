package io.github.circles2d.world.search;

import io.github.circles2d.world.queries.CastSearch;
import io.github.circles2d.world.queries.QueryShape;
import io.github.circles2d.world.queries.TreeSearch;
import io.github.circles2d.world.shared.LastReading;
import io.github.circles2d.world.shared.WorldParts;

/** Answers queries by a tree on the host. The first after a change reads all circles and builds it. */
final class HostAnswers implements Answers {
    private final WorldParts world;
    private final TreeSearch search = new TreeSearch();
    private int[] ids = new int[0];

    /** Which reading the tree shows, by {@link LastReading#number}; none at first. */
    private long shown;

    HostAnswers(WorldParts world) {
        this.world = world;
    }

    @Override
    public int all(QueryBatch batch) {
        int room = batch.room();
        int total = 0;
        for (int q = 0; q < batch.n; q++) {
            batch.take(q);
            show();
            int count = search.all(batch.shape, batch.numbers, batch.filter);
            int end = batch.end(q, total, count);
            take(batch, total, Math.min(end, room));
            total = end;
        }
        return total;
    }

    private void take(QueryBatch batch, int from, int end) {
        for (int k = from; k < end; k++) {
            batch.handles[k] = world.handles.handle(search.id(batch.shape, k - from));
            if (batch.hits != null) {
                search.writeHit(k - from, batch.hits, CastSearch.HIT_STRIDE * k);
            }
        }
    }

    @Override
    public int one(QueryBatch batch) {
        int count = 0;
        for (int q = 0; q < batch.n; q++) {
            batch.take(q);
            show();
            int id = batch.shape == QueryShape.POINT
                    ? search.pick(batch.numbers, batch.filter)
                    : search.first(batch.shape, batch.numbers, batch.filter, batch.hits, CastSearch.HIT_STRIDE * q);
            batch.handles[q] = id < 0 ? 0 : world.handles.handle(id);
            count += id < 0 ? 0 : 1;
        }
        return count;
    }

    @Override
    public int nearest(QueryBatch batch) {
        int total = 0;
        for (int q = 0; q < batch.n; q++) {
            batch.take(q);
            show();
            int count = search.nearest(batch.numbers, batch.within, batch.most, batch.filter);
            for (int k = 0; k < count; k++) {
                batch.takeNearest(q, k, world.handles.handle(search.nearestId(k)), search.nearestDistance(k));
            }
            batch.fillUp(q, count);
            total += count;
        }
        return total;
    }

    /** Makes the tree that of the circles as of now. */
    private void show() {
        float[] circles = world.last.circles();
        if (shown == world.last.number()) {
            return;
        }
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
        shown = 0;
        search.build(circles, ids, n, world.settings.bounds());
        shown = world.last.number();
    }
}
