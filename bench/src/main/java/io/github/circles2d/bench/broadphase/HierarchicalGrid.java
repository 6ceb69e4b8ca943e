package io.github.circles2d.bench.broadphase;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * A grid for each factor of four between the radii, as World has them if no size outnumbers the others. A circle is paired within
 * its own grid, and with all larger circles in the grids of these: small circles, which are many, look for large ones, which are
 * few.
 */
final class HierarchicalGrid implements BroadPhase {
    /** A grid and the greatest reach that its circles may have. */
    private record Level(CellGrid grid, float greatest) {}

    /** The smallest radius of a grid over the greatest: more grids mean fewer tests, but more cells to look at. */
    private static final float SPAN = 0.25f;

    private final Counts counts = new Counts();
    private float[] reach = new float[0];

    /** Those that have circles, from the largest circles to the smallest. */
    private List<Level> levels = List.of();

    @Override
    public void start(float[] reach) {
        this.reach = reach.clone();
        float greatest = 0;
        for (float r : reach) {
            greatest = Math.max(greatest, r);
        }
        int[] left = new int[reach.length];
        Arrays.setAll(left, i -> i);
        levels = new ArrayList<>();
        for (float top = greatest; left.length > 0; top *= SPAN) {
            float bottom = SPAN * top;
            int[] members = Arrays.stream(left).filter(i -> reach[i] > bottom).toArray();
            left = Arrays.stream(left).filter(i -> reach[i] <= bottom).toArray();
            if (members.length > 0) {
                levels.add(new Level(new CellGrid(members, top, counts), top));
            }
        }
    }

    @Override
    public void findPairs(float[] x, float[] y, PairList pairs) {
        int before = pairs.size();
        for (Level level : levels) {
            level.grid().sort(x, y, reach);
        }
        for (int finer = 0; finer < levels.size(); finer++) {
            levels.get(finer).grid().pairWithin(pairs);
            for (Level coarser : levels.subList(0, finer)) {
                coarser.grid().pairWith(levels.get(finer).grid(), coarser.greatest(), pairs);
            }
        }
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
