package io.github.circles2d.bench.broadphase;

import java.util.Arrays;

/**
 * A tree of fat boxes, as Box2D keeps it. A circle that leaves its fat box gets a new one, and looks for its pairs again; pairs
 * of fat boxes are kept, and tested in each step.
 *
 * <p>Bytes: 12 per circle to see if it is still in its box, {@link BoxTree#BYTES} per node that is looked at, and those of
 * {@link KeptPairs}.
 */
final class DynamicTree implements BroadPhase {
    /** What a box is enlarged by on each side, as a share of the reach: Box2D's tenth of a metre for circles of half a metre. */
    static final float FAT = 0.2f;

    private final Counts own = new Counts();
    private final KeptPairs kept = new KeptPairs(own);
    private float[] reach = new float[0];
    private BoxTree tree = new BoxTree(0);

    /** Whether a circle got a new box in this step. */
    private boolean[] moved = new boolean[0];

    private final int[][] found = {new int[64]};
    private boolean hasTree;

    @Override
    public void start(float[] reach) {
        this.reach = reach.clone();
        tree = new BoxTree(reach.length);
        moved = new boolean[reach.length];
        kept.list.clear();
        hasTree = false;
    }

    @Override
    public void findPairs(float[] x, float[] y, PairList pairs) {
        if (update(x, y)) {
            kept.drop(moved);
            findPairsOfMoved();
        }
        hasTree = true;
        kept.test(x, y, reach, pairs);
    }

    /** Gives new boxes where they are needed; false if nowhere. */
    private boolean update(float[] x, float[] y) {
        boolean any = false;
        Arrays.fill(moved, false);
        for (int i = 0; i < reach.length; i++) {
            float r = reach[i] + SLACK;
            if (hasTree && tree.holds(i, x[i] - r, y[i] - r, x[i] + r, y[i] + r)) {
                continue;
            }
            if (hasTree) {
                tree.remove(i);
            }
            float fat = r + FAT * reach[i];
            tree.insert(i, x[i] - fat, y[i] - fat, x[i] + fat, y[i] + fat);
            moved[i] = true;
            any = true;
        }
        own.bytes += 12L * reach.length;
        return any;
    }

    private void findPairsOfMoved() {
        for (int i = 0; i < reach.length; i++) {
            if (moved[i]) {
                int count = tree.overlapping(i, found);
                for (int k = 0; k < count; k++) {
                    int j = found[0][k];
                    // Of two circles with new boxes, the one with the lower number adds the pair.
                    if (moved[j] ? i < j : i != j) {
                        kept.list.add(i, j);
                    }
                }
            }
        }
    }

    @Override
    public Counts counts() {
        Counts all = own.copy();
        all.nodes = tree.visited;
        all.bytes += BoxTree.BYTES * tree.visited;
        return all;
    }

    @Override
    public boolean isIncremental() {
        return true;
    }
}
