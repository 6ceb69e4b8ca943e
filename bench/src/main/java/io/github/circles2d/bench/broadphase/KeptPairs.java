package io.github.circles2d.bench.broadphase;

/**
 * Pairs of enlarged circles or of fat boxes, kept over steps. In each step they are tested. Bytes: 32 per test, 16 per pair to
 * drop those of circles that have moved.
 */
final class KeptPairs {
    final PairList list = new PairList();
    private final Counts counts;

    KeptPairs(Counts counts) {
        this.counts = counts;
    }

    /** Drops the pairs of circles that are to look for their pairs again. */
    void drop(boolean[] moved) {
        int size = 0;
        for (int p = 0; p < list.size(); p++) {
            if (!moved[list.first(p)] && !moved[list.second(p)]) {
                list.move(p, size++);
            }
        }
        counts.bytes += 16L * list.size();
        list.truncate(size);
    }

    /** Adds those pairs that overlap now to others. */
    void test(float[] x, float[] y, float[] reach, PairList pairs) {
        int before = pairs.size();
        for (int p = 0; p < list.size(); p++) {
            int i = list.first(p);
            int j = list.second(p);
            if (Circles.near(x[i], y[i], reach[i], x[j], y[j], reach[j])) {
                pairs.add(i, j);
            }
        }
        counts.tests += list.size();
        counts.bytes += (PairList.BYTES + 24L) * list.size() + (long) PairList.BYTES * (pairs.size() - before);
    }
}
