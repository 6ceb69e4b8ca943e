package io.github.circles2d.world.search;

import io.github.circles2d.world.queries.Search;

/** Things of a world as they are now, to be searched on the host: circles, pieces of terrain, or bodies. */
public interface View {
    /** Makes the search one of what there is now. */
    Search show();

    long handle(int id);

    /** The id of a handle; negative if it is stale, or of something else. */
    int find(long handle);

    int kind(int id);
}
