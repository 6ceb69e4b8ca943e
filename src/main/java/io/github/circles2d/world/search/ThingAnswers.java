package io.github.circles2d.world.search;

import io.github.circles2d.world.queries.BoxSearch;
import io.github.circles2d.world.queries.CastSearch;
import io.github.circles2d.world.queries.IdFilter;

/** Answers queries for what is searched in a tree of boxes: pieces of terrain, or bodies. */
final class ThingAnswers implements Answers {
    private final ThingView view;
    private final IdFilter admitted = this::admits;

    /** That of the batch. */
    private CircleFilter filter;

    ThingAnswers(ThingView view) {
        this.view = view;
    }

    private boolean admits(int thing) {
        return view.admits(filter, thing);
    }

    private IdFilter filterOf(QueryBatch batch) {
        filter = batch.filter;
        return filter == null ? null : admitted;
    }

    @Override
    public int all(QueryBatch batch) {
        IdFilter only = filterOf(batch);
        BoxSearch search = view.show();
        int room = batch.room();
        int total = 0;
        for (int q = 0; q < batch.n; q++) {
            batch.take(q);
            int count = search.all(batch.shape, batch.numbers, only);
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
        IdFilter only = filterOf(batch);
        BoxSearch search = view.show();
        int count = 0;
        for (int q = 0; q < batch.n; q++) {
            batch.take(q);
            int thing = search.first(batch.shape, batch.numbers, only, batch.hits, CastSearch.HIT_STRIDE * q);
            batch.handles[q] = thing < 0 ? 0 : view.handle(thing);
            count += thing < 0 ? 0 : 1;
        }
        return count;
    }

    @Override
    public int nearest(QueryBatch batch) {
        IdFilter only = filterOf(batch);
        BoxSearch search = view.show();
        int total = 0;
        for (int q = 0; q < batch.n; q++) {
            batch.take(q);
            int count = search.nearest(batch.numbers[0], batch.numbers[1], batch.within, batch.most, only);
            for (int k = 0; k < count; k++) {
                int place = batch.most * q + k;
                batch.handles[place] = view.handle(search.nearestId(k));
                if (batch.hits != null) {
                    search.writeNearest(k, batch.hits, CastSearch.HIT_STRIDE * place);
                }
            }
            batch.fillUp(q, count);
            total += count;
        }
        return total;
    }
}
