package io.github.circles2d.world.search;

import io.github.circles2d.world.queries.BodySearch;
import io.github.circles2d.world.shared.WorldParts;

/** The bodies that are pushed. */
public final class BodyView implements View {
    private final WorldParts world;
    private final BodySearch search = new BodySearch();

    /** Which bodies the search shows, by the version of the table; none at first. */
    private long shown = -1;

    public BodyView(WorldParts world) {
        this.world = world;
    }

    @Override
    public BodySearch show() {
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
    public int find(long handle) {
        return world.rigids.ids.find(handle);
    }

    @Override
    public int kind(int body) {
        return world.rigids.step.kind[body];
    }

    /** Finds the bodies whose outlines are so near to a place, the nearest first, and returns how many. */
    public int near(float x, float y, float within) {
        return show().nearest(x, y, within, Integer.MAX_VALUE, null);
    }

    /** The body with a number from 0 to those that {@link #near} has found, until something else is searched. */
    public int id(int k) {
        return search.nearestId(k);
    }

    /** Writes how far away it is, the nearest point of its outline and the normal there, as {@code CastSearch} lays hits out. */
    public void read(int k, float[] to) {
        search.writeNearest(k, to, 0);
    }
}
