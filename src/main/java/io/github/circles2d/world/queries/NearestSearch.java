package io.github.circles2d.world.queries;

import java.util.function.IntPredicate;

/** Finds the circles whose edges are nearest to a point. */
public final class NearestSearch {
    /** More than the rounding of a distance, by its share of it. */
    private static final double MARGIN = 0x1p-40;

    private final CircleTree tree;
    private final Frontier frontier = new Frontier();
    private final Found found = new Found();

    /** More than the distances that count. */
    private double farthest;

    /** The distance of the last that is kept, if there are enough; else {@link #farthest}. */
    private double limit;

    public NearestSearch(CircleTree tree) {
        this.tree = tree;
    }

    /**
     * Finds at most so many circles that a disc of the radius within, which may be infinite, overlaps or touches, by the distance from
     * the point to their edges (negative inside a circle), then by id, and returns how many. A null filter is none.
     */
    public int find(float x, float y, float within, int most, IntPredicate filter) {
        found.clear();
        if (tree.size == 0) {
            return 0;
        }
        farthest = within + within * MARGIN;
        limit = farthest;
        frontier.start(tree);
        while (frontier.pop()) {
            if (frontier.distance() > limit) {
                continue;
            }
            if (frontier.level() == Frontier.CIRCLES) {
                look(frontier.group(), x, y, within, most, filter);
                limit = Math.min(farthest, found.last(most));
            } else {
                open(frontier.level(), frontier.group(), x, y);
            }
        }
        found.sort();
        return found.count();
    }

    private void look(int box, float x, float y, float within, int most, IntPredicate filter) {
        int end = Math.min(CircleTree.CIRCLES_A_BOX * (box + 1), tree.size);
        for (int k = CircleTree.CIRCLES_A_BOX * box; k < end; k++) {
            if (CircleTests.overlapsDisc(x, y, within, tree.x[k], tree.y[k], tree.radius[k])
                    && tree.isNearest(k, x, y)
                    && (filter == null || filter.test(tree.id[k]))) {
                double d = CircleTests.edgeDistance(x, y, tree.x[k], tree.y[k], tree.radius[k]);
                found.offer(d, tree.id[k], k, most);
            }
        }
    }

    private void open(int level, int group, double x, double y) {
        frontier.beginGroup();
        int first = CircleTree.BOXES_A_BOX * group;
        int end = Math.min(first + CircleTree.BOXES_A_BOX, tree.boxes[level]);
        for (int b = first; b < end; b++) {
            double d = distance(tree.levelStart[level] + CircleTree.BOX_STRIDE * b, x, y);
            double least = d - Math.abs(d) * MARGIN;
            if (least <= limit) {
                frontier.push(level - 1, b, least);
            }
        }
    }

    /** The distance from a point to the sides of a box; negative inside. No circle in the box has its edge nearer. */
    private double distance(int at, double x, double y) {
        double dx = Math.max(tree.box[at + CircleTree.MIN_X] - x, x - tree.box[at + CircleTree.MAX_X]);
        double dy = Math.max(tree.box[at + CircleTree.MIN_Y] - y, y - tree.box[at + CircleTree.MAX_Y]);
        if (dx <= 0 || dy <= 0) {
            return Math.max(dx, dy);
        }
        return Math.sqrt(dx * dx + dy * dy);
    }

    /** The nearest is number 0. */
    public int id(int k) {
        return found.id(k);
    }

    /** From the point to the edge; negative inside the circle. */
    public double distance(int k) {
        return found.distance(k);
    }
}
