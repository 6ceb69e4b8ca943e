package io.github.circles2d.world.queries;

/**
 * Searches where the circles are if that is not the host: on a device. It finds what {@link TreeSearch} finds, in the same order and
 * to the bit. A method that returns false has found nothing, for want of memory or because the circles lie where the search would take
 * too long; then the host searches.
 */
public interface RemoteSearch {
    /** Ints of a set of kinds: a bit for each. */
    int KIND_WORDS = 8;

    /** Whether it is worth while for large batches: a device that is the host's own processor gains nothing. */
    boolean pays();

    /**
     * Searches the circles as of now from here on. All steps have been finished.
     *
     * @param state another number whenever circles have changed
     * @return whether it can
     */
    boolean show(long state);

    /**
     * Counts what each query finds.
     *
     * @param queries of checked numbers, one after the other
     * @param n number of queries, at least 1
     * @param kinds {@link #KIND_WORDS} ints with a bit for each kind whose circles count; null for all
     * @param counts takes how many circles each query finds
     * @return whether it has
     */
    boolean count(QueryShape shape, float[] queries, int n, int[] kinds, int[] counts);

    /**
     * Lists what the first of the queries that have been counted find, each in its order.
     *
     * @param n number of queries, at least 1
     * @param ends where the circles of each end: sums of the counts
     * @param places whether {@link #distance}, {@link #x} and {@link #y} are asked for
     * @return whether it has
     */
    boolean list(int n, int[] ends, boolean places);

    /**
     * Finds the first few circles of each query: at a point, nearest to it, or on a path. Those of query q begin at number q * most;
     * behind the last one the ids are -1.
     *
     * @param queries of checked numbers, one after the other
     * @param n number of queries, at least 1
     * @param within greatest distance of {@link QueryShape#NEAREST}
     * @param most how many to find for each, at least 1
     * @param kinds as in {@link #count}
     * @param places whether {@link #distance}, {@link #x} and {@link #y} are asked for
     * @return whether it has
     */
    boolean few(QueryShape shape, float[] queries, int n, float within, int most, int[] kinds, boolean places);

    /** The id of a circle that was found. */
    int id(int k);

    /** The distance of a circle that was found: along a path, or from a point to the edge. */
    double distance(int k);

    /** x of a circle that was found. */
    float x(int k);

    /** y of a circle that was found. */
    float y(int k);
}
