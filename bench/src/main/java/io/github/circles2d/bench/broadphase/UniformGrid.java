package io.github.circles2d.bench.broadphase;

/** One grid for all circles, whose cells are as wide as the greatest diameter: the idea of World's grid. */
final class UniformGrid implements BroadPhase {
    private final Counts counts = new Counts();
    private float[] reach = new float[0];
    private CellGrid grid;

    @Override
    public void start(float[] reach) {
        this.reach = reach.clone();
        int[] all = new int[reach.length];
        float greatest = 0;
        for (int i = 0; i < all.length; i++) {
            all[i] = i;
            greatest = Math.max(greatest, reach[i]);
        }
        grid = new CellGrid(all, greatest, counts);
    }

    @Override
    public void findPairs(float[] x, float[] y, PairList pairs) {
        int before = pairs.size();
        grid.sort(x, y, reach);
        grid.pairWithin(pairs);
        counts.bytes += (long) PairList.BYTES * (pairs.size() - before);
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
