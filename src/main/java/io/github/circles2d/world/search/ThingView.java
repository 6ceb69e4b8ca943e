package io.github.circles2d.world.search;

import io.github.circles2d.world.queries.BoxSearch;

/** Things of a world as they are now, to be searched: the host has them on every back end. */
interface ThingView {
    /** Makes the search one of what there is now. */
    BoxSearch show();

    long handle(int thing);

    boolean admits(CircleFilter filter, int thing);
}
