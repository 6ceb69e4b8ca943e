package io.github.circles2d.bench.broadphase;

/**
 * Sweep and prune with spatial subdivision, after F. Liu, T. Harada, Y. Lee and Y. J. Kim, "Real-time Collision Culling of a
 * Million Bodies on Graphics Processing Units", 2010. The plane has one axis besides that of the sweep, so the cells are strips
 * along the sweep. A circle has an entry in each strip that it reaches into. One sort by strip and start of the interval puts
 * the strips behind each other, and one sweep goes through all of them. A pair counts in the first strip that both reach into.
 *
 * <p>Bytes: 24 per circle to find its strips, {@link RadixSort#BYTES} + 40 per entry, 16 per test.
 */
final class SubdividedSweepAndPrune implements BroadPhase {
    /** Height of a strip in mean reaches: less makes more entries, more makes more tests. */
    static final float STRIP = 4;

    /** Bits of a key that stay for the start of the interval, at the least. */
    private static final int LEAST_BITS = 16;

    private final Counts counts = new Counts();
    private final Sorted sorted = new Sorted();
    private final RadixSort radix = new RadixSort();
    private float[] reach = new float[0];

    /** By entry: the first strip that its circle reaches into. */
    private int[] firstStrip = new int[0];

    private float perHeight;
    private int stripBits;

    @Override
    public void start(float[] reach) {
        this.reach = reach.clone();
        double sum = 0;
        for (float r : reach) {
            sum += r;
        }
        // A reach may go beyond the unit square: one strip more on either side.
        int strips = (int) Math.max(1, Math.min(reach.length / (STRIP * sum), 1 << RadixSort.BITS - LEAST_BITS - 1));
        perHeight = strips;
        stripBits = 32 - Integer.numberOfLeadingZeros(strips + 1);
    }

    @Override
    public void findPairs(float[] x, float[] y, PairList pairs) {
        int before = pairs.size();
        int xBits = RadixSort.BITS - stripBits;
        Scale scale = scale(x, xBits);
        int entries = makeEntries(x, y, scale, xBits);
        radix.sort(entries);
        gather(x, y, entries);
        sweep(entries, scale, xBits, pairs);
        counts.bytes += 24L * reach.length
                + (RadixSort.BYTES + 40L) * entries
                + (long) PairList.BYTES * (pairs.size() - before);
    }

    private Scale scale(float[] x, int bits) {
        float least = Float.POSITIVE_INFINITY;
        float greatest = Float.NEGATIVE_INFINITY;
        for (int i = 0; i < reach.length; i++) {
            least = Math.min(least, x[i] - reach[i]);
            greatest = Math.max(greatest, x[i] + reach[i]);
        }
        return new Scale(least, greatest, bits);
    }

    /** The strip of a height; those that lie outside the square belong to the first or to the last one. */
    private int strip(float y) {
        return Math.max(0, Math.min((int) perHeight, (int) (y * perHeight)));
    }

    private int makeEntries(float[] x, float[] y, Scale scale, int xBits) {
        int entries = 0;
        for (int i = 0; i < reach.length; i++) {
            int first = strip(y[i] - reach[i] - SLACK);
            int last = strip(y[i] + reach[i] + SLACK);
            int begin = scale.of(x[i] - reach[i]);
            radix.ensure(entries + last - first + 1);
            for (int strip = first; strip <= last; strip++) {
                radix.keys[entries] = strip << xBits | begin;
                radix.numbers[entries] = i;
                entries++;
            }
        }
        return entries;
    }

    private void gather(float[] x, float[] y, int entries) {
        sorted.ensure(entries);
        if (firstStrip.length < entries) {
            firstStrip = new int[sorted.number.length];
        }
        for (int k = 0; k < entries; k++) {
            int i = radix.numbers[k];
            sorted.put(k, i, x[i], y[i], reach[i]);
            firstStrip[k] = strip(y[i] - reach[i] - SLACK);
        }
    }

    private void sweep(int entries, Scale scale, int xBits, PairList pairs) {
        int[] keys = radix.keys;
        float[] xs = sorted.x;
        float[] ys = sorted.y;
        float[] reaches = sorted.reach;
        long tests = 0;
        for (int k = 0; k < entries; k++) {
            float cx = xs[k];
            float cy = ys[k];
            float cr = reaches[k];
            int strip = keys[k] >>> xBits;
            int end = strip << xBits | scale.of(cx + cr + SLACK);
            int m = k + 1;
            while (m < entries && keys[m] <= end) {
                if (Circles.near(cx, cy, cr, xs[m], ys[m], reaches[m])
                        && Math.max(firstStrip[k], firstStrip[m]) == strip) {
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
        return false;
    }
}
