package io.github.circles2d.bench.broadphase;

/**
 * Sweep and prune along x: intervals in the order in which they begin; each is tested with those that begin before it ends.
 *
 * <p>Bytes: 24 per circle to compute where its interval begins, 32 to put it in order, 16 per test, 16 per element that the
 * insertion sort moves, {@link RadixSort#BYTES} per circle for the radix sort.
 */
final class SweepAndPrune implements BroadPhase {
    /** How the intervals get into order. */
    enum Sorting {
        /** From the order of the step before: cheap if few circles have overtaken others. */
        INSERTION,
        /** A radix sort in every step. */
        RADIX
    }

    private final Sorting sorting;
    private final Counts counts = new Counts();
    private final Sorted sorted = new Sorted();
    private final RadixSort radix = new RadixSort();
    private float[] reach = new float[0];

    /** By place: where the interval begins. */
    private float[] begin = new float[0];

    /** By place: the circle. */
    private int[] order = new int[0];

    private boolean hasOrder;

    SweepAndPrune(Sorting sorting) {
        this.sorting = sorting;
    }

    @Override
    public void start(float[] reach) {
        this.reach = reach.clone();
        int n = reach.length;
        begin = new float[n];
        order = new int[n];
        radix.ensure(n);
        sorted.ensure(n);
        hasOrder = false;
    }

    @Override
    public void findPairs(float[] x, float[] y, PairList pairs) {
        int before = pairs.size();
        if (!hasOrder || sorting == Sorting.RADIX) {
            sortByRadix(x);
        }
        if (sorting == Sorting.INSERTION) {
            sortByInsertion(x);
        }
        for (int k = 0; k < reach.length; k++) {
            int i = order[k];
            sorted.put(k, i, x[i], y[i], reach[i]);
        }
        sweep(pairs);
        counts.bytes += 32L * reach.length + (long) PairList.BYTES * (pairs.size() - before);
    }

    /** By a key, which is less precise than the coordinate: intervals that begin close together may change places. */
    private void sortByRadix(float[] x) {
        int n = reach.length;
        float least = Float.POSITIVE_INFINITY;
        float greatest = Float.NEGATIVE_INFINITY;
        for (int i = 0; i < n; i++) {
            float b = x[i] - reach[i];
            least = Math.min(least, b);
            greatest = Math.max(greatest, b);
        }
        Scale scale = new Scale(least, greatest, RadixSort.BITS);
        for (int i = 0; i < n; i++) {
            radix.keys[i] = scale.of(x[i] - reach[i]);
            radix.numbers[i] = i;
        }
        radix.sort(n);
        System.arraycopy(radix.numbers, 0, order, 0, n);
        for (int k = 0; k < n; k++) {
            begin[k] = x[order[k]] - reach[order[k]];
        }
        hasOrder = true;
        counts.bytes += (24L + 8 + RadixSort.BYTES) * n;
    }

    private void sortByInsertion(float[] x) {
        long swaps = 0;
        for (int k = 0; k < reach.length; k++) {
            int i = order[k];
            float b = x[i] - reach[i];
            int p = k;
            while (p > 0 && begin[p - 1] > b) {
                begin[p] = begin[p - 1];
                order[p] = order[p - 1];
                p--;
            }
            begin[p] = b;
            order[p] = i;
            swaps += k - p;
        }
        counts.swaps += swaps;
        counts.bytes += 24L * reach.length + 16 * swaps;
    }

    private void sweep(PairList pairs) {
        int n = reach.length;
        float[] begins = begin;
        float[] xs = sorted.x;
        float[] ys = sorted.y;
        float[] reaches = sorted.reach;
        long tests = 0;
        for (int k = 0; k < n; k++) {
            float cx = xs[k];
            float cy = ys[k];
            float cr = reaches[k];
            // SLACK also covers what a key is less precise than a coordinate.
            float end = cx + cr + SLACK;
            int m = k + 1;
            while (m < n && begins[m] <= end) {
                if (Circles.near(cx, cy, cr, xs[m], ys[m], reaches[m])) {
                    pairs.add(sorted.number[k], sorted.number[m]);
                }
                m++;
            }
            tests += m - k - 1;
        }
        counts.tests += tests;
        counts.bytes += 16 * tests;
    }

    @Override
    public Counts counts() {
        return counts;
    }

    @Override
    public boolean isIncremental() {
        return sorting == Sorting.INSERTION;
    }
}
