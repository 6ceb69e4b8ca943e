package io.github.circles2d.bench.broadphase;

import org.jbox2d.collision.AABB;
import org.jbox2d.collision.broadphase.DynamicTree;
import org.jbox2d.common.Vec2;

/**
 * The tree of JBox2D, called as its world calls it: circles that have left their fat boxes look for pairs. The mean reach is half a
 * metre; boxes are wider than circles by 0.1 m on each side, and by twice the motion of the step on the side that the circle moves
 * to. Bytes are not estimated.
 */
final class Jbox2dBroadPhase implements BroadPhase {
    private final Counts counts = new Counts();
    private final KeptPairs kept = new KeptPairs(counts);
    private final AABB box = new AABB();
    private final Vec2 motion = new Vec2();
    private DynamicTree tree = new DynamicTree();
    private float[] reach = new float[0];
    private int[] proxies = new int[0];
    private boolean[] moved = new boolean[0];
    private float[] lastX = new float[0];
    private float[] lastY = new float[0];
    private float factor;
    private boolean hasProxies;

    @Override
    public void start(float[] reach) {
        this.reach = reach.clone();
        factor = (float) Metres.factor(reach);
        tree = new DynamicTree();
        proxies = new int[reach.length];
        moved = new boolean[reach.length];
        lastX = new float[reach.length];
        lastY = new float[reach.length];
        kept.list.clear();
        hasProxies = false;
    }

    @Override
    public void findPairs(float[] x, float[] y, PairList pairs) {
        for (int i = 0; i < reach.length; i++) {
            float r = (reach[i] + SLACK) * factor;
            box.lowerBound.set(x[i] * factor - r, y[i] * factor - r);
            box.upperBound.set(x[i] * factor + r, y[i] * factor + r);
            moved[i] = hasProxies ? move(i, x[i], y[i]) : create(i);
            lastX[i] = x[i];
            lastY[i] = y[i];
        }
        hasProxies = true;
        kept.drop(moved);
        findPairsOfMoved();
        kept.test(x, y, reach, pairs);
    }

    private boolean create(int i) {
        proxies[i] = tree.createProxy(box, i);
        return true;
    }

    /** Whether the circle got a new box. */
    private boolean move(int i, float x, float y) {
        motion.set((x - lastX[i]) * factor, (y - lastY[i]) * factor);
        return tree.moveProxy(proxies[i], box, motion);
    }

    private void findPairsOfMoved() {
        for (int i = 0; i < reach.length; i++) {
            if (moved[i]) {
                int self = i;
                tree.query(
                        proxy -> {
                            int other = (Integer) tree.getUserData(proxy);
                            if (moved[other] ? self < other : self != other) {
                                kept.list.add(self, other);
                            }
                            return true;
                        },
                        tree.getFatAABB(proxies[i]));
            }
        }
    }

    @Override
    public Counts counts() {
        return counts;
    }

    @Override
    public boolean isIncremental() {
        return true;
    }
}
