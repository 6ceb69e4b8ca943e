package io.github.circles2d.bench.broadphase;

/** Tests every pair, as the thesis does. Bytes: 12 per circle of the outer loop and per test. */
final class AllPairs implements BroadPhase {
    private final Counts counts = new Counts();
    private float[] reach = new float[0];

    @Override
    public void start(float[] reach) {
        this.reach = reach.clone();
    }

    @Override
    public void findPairs(float[] x, float[] y, PairList pairs) {
        int n = reach.length;
        int before = pairs.size();
        float[] reaches = reach;
        for (int i = 0; i < n; i++) {
            float xi = x[i];
            float yi = y[i];
            float ri = reaches[i];
            for (int j = i + 1; j < n; j++) {
                if (Circles.near(xi, yi, ri, x[j], y[j], reaches[j])) {
                    pairs.add(i, j);
                }
            }
        }
        long tests = (long) n * (n - 1) / 2;
        counts.tests += tests;
        counts.bytes += 12 * (n + tests) + (long) PairList.BYTES * (pairs.size() - before);
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
