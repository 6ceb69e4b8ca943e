package io.github.circles2d.world.search;

import io.github.circles2d.world.queries.BodySearch;
import io.github.circles2d.world.queries.BoxSearch;
import io.github.circles2d.world.shared.WorldParts;

/** The bodies that are pushed. */
final class BodyView implements ThingView {
    private final WorldParts world;
    private final BodySearch search = new BodySearch();

    /** Which bodies the search shows, by the version of the table; none at first. */
    private long shown = -1;

    BodyView(WorldParts world) {
        this.world = world;
    }

    @Override
    public BoxSearch show() {
        long now = world.rigids.version();
        boolean moved = now != shown;
        shown = -1; // until there has been memory for them
        search.show(world.rigids.step, moved, world.settings.bounds());
        shown = now;
        return search;
    }

    @Override
    public long handle(int body) {
        return world.rigids.ids.handle(body);
    }

    @Override
    public boolean admits(CircleFilter filter, int body) {
        return filter.admitsBody(body, world.rigids.step.kind[body]);
    }
}
