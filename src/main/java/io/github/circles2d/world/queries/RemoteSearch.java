package io.github.circles2d.world.queries;

/**
 * Searches where the circles are if that is not the host: on a device. It finds what {@link TreeSearch} finds, in the same order and
 * to the bit. A method that returns false has found nothing, for want of memory or because the circles lie where the search would take
 * too long; then the host searches.
 */
public interface RemoteSearch {
    /** Ints of a set of kinds: a bit for each. */
    int KIND_WORDS = 8;

    /** In a filter behind the kinds: the id of a circle that does not count, or -1. */
    int LEFT_OUT = KIND_WORDS;

    /** Ints of a filter. */
    int FILTER_WORDS = KIND_WORDS + 1;

    /** Whether it is worth while for large batches: a device that is the host's own processor gains nothing. */
    boolean pays();

    /** Circles as of now from here on, once all steps have been finished. The state is another number whenever they have changed. */
    boolean show(long state);

    /** Counts what n checked queries find. A filter has {@link #FILTER_WORDS} ints, and a null one admits all circles. */
    boolean count(QueryShape shape, float[] queries, int n, int[] filter, int[] counts);

    /** Lists what the first n of them find, each in its order; ends are sums of counts, places ask for distance, x and y. */
    boolean list(int n, int[] ends, boolean places);

    /** The first circles of each query, from number q * most on, then -1; within is the greatest distance of the nearest ones. */
    boolean few(QueryShape shape, float[] queries, int n, float within, int most, int[] filter, boolean places);

    /** The id of a circle that was found. */
    int id(int k);

    /** The distance of a circle that was found: along a path, or from a point to the edge. */
    double distance(int k);

    /** x of a circle that was found. */
    float x(int k);

    /** y of a circle that was found. */
    float y(int k);
}
