package io.github.circles2d.bench.broadphase;

import java.util.Iterator;
import org.dyn4j.collision.CollisionPair;
import org.dyn4j.collision.broadphase.AABBExpansionMethod;
import org.dyn4j.collision.broadphase.AABBProducer;
import org.dyn4j.collision.broadphase.BroadphaseDetector;
import org.dyn4j.collision.broadphase.BroadphaseFilter;
import org.dyn4j.collision.broadphase.DynamicAABBTree;
import org.dyn4j.collision.broadphase.StaticValueAABBExpansionMethod;
import org.dyn4j.geometry.AABB;

/**
 * The tree of dyn4j, called as its world calls it: boxes that circles have left are updated, and those alone look for pairs. The
 * mean reach is half a metre, and boxes are 0.2 m wider than circles. Bytes are not estimated. dyn4j's sweep and prune, {@code
 * Sap}, is not here: after some steps it gives some pairs twice.
 */
final class Dyn4jBroadPhase implements BroadPhase {
    private static final double EXPANSION = 0.2;

    private static final class Ball {
        private final int number;
        private final double reach;
        private double x;
        private double y;

        private Ball(int number, double reach) {
            this.number = number;
            this.reach = reach;
        }
    }

    private static final class Boxes implements AABBProducer<Ball> {
        @Override
        public AABB compute(Ball ball) {
            return new AABB(ball.x - ball.reach, ball.y - ball.reach, ball.x + ball.reach, ball.y + ball.reach);
        }

        @Override
        public void compute(Ball ball, AABB result) {
            AABB.setFromPoints(
                    ball.x - ball.reach, ball.y - ball.reach, ball.x + ball.reach, ball.y + ball.reach, result);
        }
    }

    private final Counts counts = new Counts();
    private final KeptPairs kept = new KeptPairs(counts);
    private BroadphaseDetector<Ball> detector;
    private Ball[] balls = new Ball[0];
    private boolean[] moved = new boolean[0];
    private float[] reach = new float[0];
    private double factor;
    private boolean hasBalls;

    @Override
    public void start(float[] reach) {
        this.reach = reach.clone();
        factor = Metres.factor(reach);
        balls = new Ball[reach.length];
        moved = new boolean[reach.length];
        for (int i = 0; i < balls.length; i++) {
            balls[i] = new Ball(i, (reach[i] + SLACK) * factor);
        }
        BroadphaseFilter<Ball> all = (a, b) -> a != b;
        AABBProducer<Ball> boxes = new Boxes();
        AABBExpansionMethod<Ball> expansion = new StaticValueAABBExpansionMethod<>(EXPANSION);
        detector = new DynamicAABBTree<>(all, boxes, expansion, balls.length);
        kept.list.clear();
        hasBalls = false;
    }

    @Override
    public void findPairs(float[] x, float[] y, PairList pairs) {
        for (int i = 0; i < balls.length; i++) {
            balls[i].x = x[i] * factor;
            balls[i].y = y[i] * factor;
        }
        if (hasBalls) {
            detector.update();
        } else {
            for (Ball ball : balls) {
                detector.add(ball);
            }
            hasBalls = true;
        }
        for (int i = 0; i < balls.length; i++) {
            moved[i] = detector.isUpdated(balls[i]);
        }
        kept.drop(moved);
        Iterator<CollisionPair<Ball>> found = detector.detectIterator(false);
        while (found.hasNext()) {
            CollisionPair<Ball> pair = found.next();
            kept.list.add(pair.getFirst().number, pair.getSecond().number);
        }
        detector.clearUpdates();
        kept.test(x, y, reach, pairs);
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
