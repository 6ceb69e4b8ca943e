package io.github.circles2d.world.queries;

import java.util.function.IntPredicate;

/** Finds the circles that a moving disc meets. */
public final class CastSearch extends PathSearch {
    // a hit: how far the disc has moved; where its centre is then; the unit vector from the circle's centre to there
    public static final int HIT_STRIDE = 5;
    public static final int DISTANCE = 0;
    public static final int X = 1;
    public static final int Y = 2;
    public static final int NORMAL_X = 3;
    public static final int NORMAL_Y = 4;

    /** More than the rounding of the exact test, by its share of the greatest length in it. */
    private static final double MARGIN = 0x1p-44;

    private final CircleTree tree;
    private final Frontier frontier = new Frontier();

    /** How far the cast goes at most for what is still looked for. */
    private double limit;

    public CastSearch(CircleTree tree) {
        this.tree = tree;
    }

    @Override
    void search(int most, IntPredicate filter) {
        found.clear();
        if (tree.size == 0) {
            return;
        }
        double margin = reach + (tree.span(startX, startY) + reach) * MARGIN;
        limit = length;
        frontier.start(tree);
        while (frontier.pop()) {
            if (frontier.distance() > limit) {
                continue;
            }
            if (frontier.level() == Frontier.CIRCLES) {
                look(frontier.group(), most, filter);
                limit = Math.min(limit, found.last(most));
            } else {
                open(frontier.level(), frontier.group(), margin);
            }
        }
    }

    private void look(int box, int most, IntPredicate filter) {
        int end = Math.min(CircleTree.CIRCLES_A_BOX * (box + 1), tree.size);
        for (int k = CircleTree.CIRCLES_A_BOX * box; k < end; k++) {
            double d = CircleTests.castDistance(
                    startX, startY, reach, unitX, unitY, length, tree.x[k], tree.y[k], tree.radius[k]);
            if (d != CircleTests.NONE && (filter == null || filter.test(tree.id[k]))) {
                found.offer(d, tree.id[k], k, most);
            }
        }
    }

    /** A 0 in the unit vector makes an infinite inverse, with which the path is in a box's range along that axis for ever, or never. */
    private void open(int level, int group, double margin) {
        frontier.beginGroup();
        double inverseX = 1 / unitX;
        double inverseY = 1 / unitY;
        float[] box = tree.box;
        int first = CircleTree.BOXES_A_BOX * group;
        int end = Math.min(first + CircleTree.BOXES_A_BOX, tree.boxes[level]);
        for (int b = first; b < end; b++) {
            int at = tree.levelStart[level] + CircleTree.BOX_STRIDE * b;
            double lowX = (box[at + CircleTree.MIN_X] - margin - startX) * inverseX;
            double highX = (box[at + CircleTree.MAX_X] + margin - startX) * inverseX;
            double lowY = (box[at + CircleTree.MIN_Y] - margin - startY) * inverseY;
            double highY = (box[at + CircleTree.MAX_Y] + margin - startY) * inverseY;
            double enter = Math.max(Math.max(Math.min(lowX, highX), Math.min(lowY, highY)), 0);
            double leave = Math.min(Math.min(Math.max(lowX, highX), Math.max(lowY, highY)), limit);
            if (!(enter > leave)) {
                frontier.push(level - 1, b, enter);
            }
        }
    }

    /** The nearest is number 0. */
    public int id(int k) {
        return found.id(k);
    }

    /** Writes {@link #HIT_STRIDE} elements. From its own centre the normal points against the path, and up without a path. */
    @Override
    public void writeHit(int k, float[] to, int at) {
        writeHit(found.distance(k), tree.x[found.place(k)], tree.y[found.place(k)], to, at);
    }

    /** Writes the hit of a circle that another search has found after a distance. */
    public void writeHit(double distance, float circleX, float circleY, float[] to, int at) {
        double x = startX + unitX * distance;
        double y = startY + unitY * distance;
        double nx = x - circleX;
        double ny = y - circleY;
        double norm = Math.sqrt(nx * nx + ny * ny);
        if (norm == 0) {
            nx = 0 - unitX;
            ny = length == 0 ? 1 : 0 - unitY;
            norm = 1;
        }
        write(to, at, distance, x, y, nx / norm, ny / norm);
    }

    /** Writes a hit of nothing, infinitely far away. */
    public static void writeNone(float[] to, int at) {
        write(to, at, Double.POSITIVE_INFINITY, 0, 0, 0, 0);
    }

    static void write(float[] to, int at, double distance, double x, double y, double nx, double ny) {
        to[at + DISTANCE] = (float) distance;
        to[at + X] = (float) x;
        to[at + Y] = (float) y;
        to[at + NORMAL_X] = (float) nx;
        to[at + NORMAL_Y] = (float) ny;
    }
}
