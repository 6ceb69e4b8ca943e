package io.github.circles2d.world.search;

import io.github.circles2d.world.circles.CircleField;
import io.github.circles2d.world.queries.Search;
import io.github.circles2d.world.queries.TreeSearch;
import io.github.circles2d.world.shared.LastReading;
import io.github.circles2d.world.shared.WorldParts;

/** The circles. The first look after a change reads all of them and builds a tree. */
final class CircleView implements View {
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
