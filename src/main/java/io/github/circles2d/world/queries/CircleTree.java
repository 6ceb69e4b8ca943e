package io.github.circles2d.world.queries;

import io.github.circles2d.world.model.Bounds;
import io.github.circles2d.world.model.CircleRow;

/**
 * A tree of boxes over circles. The circles lie in the order of a Hilbert curve; sixteen of them in a row share a box, four boxes in a
 * row share a box of the next level, and so on up to one. Radii may differ by any factor, and circles may crowd anywhere: a box is as
 * large as what it holds.
 *
 * <p>A box is larger than its circles by 2^-21 of each circle's coordinates and radius, which covers the rounding of the exact tests
 * ({@link CircleTests}). So a search that skips boxes which it cannot reach finds the same circles as one that tests them all.
 */
public final class CircleTree {
    /** Circles that share a box of level 0. */
    public static final int CIRCLES_A_BOX = 16;

    /** Boxes that share a box of the next level. */
    public static final int BOXES_A_BOX = 4;

    /** At least the levels that 100 million circles need. */
    static final int LEVELS = 14;

    // a box: its sides
    static final int BOX_STRIDE = 4;
    static final int MIN_X = 0;
    static final int MIN_Y = 1;
    static final int MAX_X = 2;
    static final int MAX_Y = 3;

    /** What a box is larger by than its circles, by the share of their coordinates and radii. */
    public static final float MARGIN = 0x1p-21f;

    private final HilbertOrder hilbertOrder = new HilbertOrder();

    /** Half of the period along x: farther from a place, another image of a circle is nearer; infinite without images. */
    private double halfX = Double.POSITIVE_INFINITY;

    private double halfY = Double.POSITIVE_INFINITY;

    /** Number of circles. */
    int size;

    /** More than the greatest id. */
    int idLimit;

    // by place on the curve
    float[] x = new float[0];
    float[] y = new float[0];
    float[] radius = new float[0];
    int[] id = new int[0];

    /** The boxes of all levels, level 0 first. */
    float[] box = new float[0];

    /** By level: where its boxes begin in {@link #box}. */
    final int[] levelStart = new int[LEVELS];

    /** By level: the number of its boxes. */
    final int[] boxes = new int[LEVELS];

    /** The level that has one box. */
    int top;

    /** Ids ascend. The arrays are not kept. */
    public void build(float[] circles, int[] ids, int n) {
        halfX = Double.POSITIVE_INFINITY;
        halfY = Double.POSITIVE_INFINITY;
        build(circles, ids, n, n == 0 ? 0 : ids[n - 1] + 1);
    }

    /** Circles and their images; ids are less than the limit. */
    void build(TreeSearch.Images images, int limit, Bounds bounds) {
        halfX = 0.5 * bounds.periodX();
        halfY = 0.5 * bounds.periodY();
        build(images.circles(), images.ids(), images.count(), limit);
    }

    /** Whether a circle is the one of its images that is nearest to a place; without images it is. */
    boolean isNearest(int k, double px, double py) {
        double dx = x[k] - px;
        double dy = y[k] - py;
        return dx >= -halfX && dx < halfX && dy >= -halfY && dy < halfY;
    }

    private void build(float[] circles, int[] ids, int n, int limit) {
        size = 0;
        makeRoom(n);
        int[] order = hilbertOrder.order(circles, n);
        for (int k = 0; k < n; k++) {
            int row = CircleRow.of(order[k]);
            x[k] = circles[row + CircleRow.X];
            y[k] = circles[row + CircleRow.Y];
            radius[k] = circles[row + CircleRow.RADIUS];
            id[k] = ids[order[k]];
        }
        idLimit = limit;
        boxCircles(n);
        for (int level = 1; level <= top; level++) {
            boxBoxes(level);
        }
        size = n;
    }

    /** Lays the levels out and makes room. The array that is compared grows last: a growth that fails is tried again. */
    private void makeRoom(int n) {
        int level = 0;
        int count = (n + CIRCLES_A_BOX - 1) / CIRCLES_A_BOX;
        int start = 0;
        while (true) {
            levelStart[level] = start;
            boxes[level] = count;
            start += BOX_STRIDE * count;
            if (count <= 1) {
                break;
            }
            count = (count + BOXES_A_BOX - 1) / BOXES_A_BOX;
            level++;
        }
        top = level;
        if (box.length < start) {
            box = new float[Capacity.atLeast(start, box.length)];
        }
        if (id.length < n) {
            int c = Capacity.atLeast(n, id.length);
            x = new float[c];
            y = new float[c];
            radius = new float[c];
            id = new int[c];
        }
    }

    private void boxCircles(int n) {
        for (int b = 0; b < boxes[0]; b++) {
            float minX = Float.POSITIVE_INFINITY;
            float minY = Float.POSITIVE_INFINITY;
            float maxX = Float.NEGATIVE_INFINITY;
            float maxY = Float.NEGATIVE_INFINITY;
            int end = Math.min(CIRCLES_A_BOX * (b + 1), n);
            for (int k = CIRCLES_A_BOX * b; k < end; k++) {
                float r = radius[k];
                float reachX = r + (Math.abs(x[k]) + r) * MARGIN;
                float reachY = r + (Math.abs(y[k]) + r) * MARGIN;
                minX = Math.min(minX, x[k] - reachX);
                minY = Math.min(minY, y[k] - reachY);
                maxX = Math.max(maxX, x[k] + reachX);
                maxY = Math.max(maxY, y[k] + reachY);
            }
            set(BOX_STRIDE * b, minX, minY, maxX, maxY);
        }
    }

    private void boxBoxes(int level) {
        int below = levelStart[level - 1];
        for (int b = 0; b < boxes[level]; b++) {
            float minX = Float.POSITIVE_INFINITY;
            float minY = Float.POSITIVE_INFINITY;
            float maxX = Float.NEGATIVE_INFINITY;
            float maxY = Float.NEGATIVE_INFINITY;
            int end = Math.min(BOXES_A_BOX * (b + 1), boxes[level - 1]);
            for (int c = BOXES_A_BOX * b; c < end; c++) {
                int at = below + BOX_STRIDE * c;
                minX = Math.min(minX, box[at + MIN_X]);
                minY = Math.min(minY, box[at + MIN_Y]);
                maxX = Math.max(maxX, box[at + MAX_X]);
                maxY = Math.max(maxY, box[at + MAX_Y]);
            }
            set(levelStart[level] + BOX_STRIDE * b, minX, minY, maxX, maxY);
        }
    }

    private void set(int at, float minX, float minY, float maxX, float maxY) {
        box[at + MIN_X] = minX;
        box[at + MIN_Y] = minY;
        box[at + MAX_X] = maxX;
        box[at + MAX_Y] = maxY;
    }

    /** More than the greatest distance along an axis from a point to a circle; the tree has circles. */
    double span(double px, double py) {
        int root = levelStart[top];
        double spanX = Math.max(Math.abs(box[root + MIN_X] - px), Math.abs(box[root + MAX_X] - px));
        double spanY = Math.max(Math.abs(box[root + MIN_Y] - py), Math.abs(box[root + MAX_Y] - py));
        return spanX + spanY;
    }
}
