package io.github.circles2d.world.search;

import io.github.circles2d.world.queries.CastSearch;
import io.github.circles2d.world.queries.Search;

/** QueryBatch.Answers queries by a tree on the host. */
final class HostAnswers implements QueryBatch.Answers {
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
