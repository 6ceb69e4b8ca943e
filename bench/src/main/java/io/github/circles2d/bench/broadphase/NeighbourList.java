package io.github.circles2d.bench.broadphase;

/**
 * Verlet's neighbour list: pairs of enlarged circles, found by a hierarchical grid and kept until a circle has moved so far that
 * one might be missing.
 *
 * <p>Bytes: 20 per circle and step to see how far it has moved, 12 when a list is made, and those of the grid and of the list.
 */
final class NeighbourList implements BroadPhase {
    /** What a reach is enlarged by, as a share of it: more keeps a list for longer, and makes it longer. */
    static final float SKIN = 0.2f;

    private final HierarchicalGrid grid = new HierarchicalGrid();
    private final Counts own = new Counts();
    private final KeptPairs kept = new KeptPairs(own);
    private float[] reach = new float[0];

    /** Where each circle was when the list was made. */
    private float[] listX = new float[0];

    private float[] listY = new float[0];
    private boolean hasList;

    @Override
    public void start(float[] reach) {
        this.reach = reach.clone();
        listX = new float[reach.length];
        listY = new float[reach.length];
        hasList = false;
        float[] enlarged = reach.clone();
        for (int i = 0; i < enlarged.length; i++) {
            enlarged[i] += SKIN * reach[i] + SLACK;
        }
        grid.start(enlarged);
    }

    @Override
    public void findPairs(float[] x, float[] y, PairList pairs) {
        if (!hasList || isOutdated(x, y)) {
            kept.list.clear();
            grid.findPairs(x, y, kept.list);
            System.arraycopy(x, 0, listX, 0, reach.length);
            System.arraycopy(y, 0, listY, 0, reach.length);
            hasList = true;
            own.bytes += 12L * reach.length;
        }
        kept.test(x, y, reach, pairs);
    }

    /** Two circles that were apart by both skins have to move by one of them. */
    private boolean isOutdated(float[] x, float[] y) {
        int n = reach.length;
        int i = 0;
        while (i < n) {
            float dx = x[i] - listX[i];
            float dy = y[i] - listY[i];
            float skin = SKIN * reach[i];
            if (dx * dx + dy * dy > skin * skin) {
                break;
            }
            i++;
        }
        own.bytes += 20L * Math.min(i + 1, n);
        return i < n;
    }

    @Override
    public Counts counts() {
        return own.plus(grid.counts());
    }

    @Override
    public boolean isIncremental() {
        return true;
    }
}
