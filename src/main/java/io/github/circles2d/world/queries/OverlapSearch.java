package io.github.circles2d.world.queries;

import java.util.Arrays;
import java.util.function.IntPredicate;

/** Finds the circles that a disc or a box overlaps or touches, and the circle at a point. */
public final class OverlapSearch {
    /** What the sides of a searched area are moved outwards by, so that rounding them to floats leaves nothing out. */
    private static final double MARGIN = 0x1p-21;

    private final CircleTree tree;
    private final FoundIds found = new FoundIds();
    private int[] near = new int[Capacity.atLeast(0, 0)];
    private final int[] waitingLevel = new int[CircleTree.BOXES_A_BOX * CircleTree.LEVELS];
    private final int[] waitingGroup = new int[waitingLevel.length];

    public OverlapSearch(CircleTree tree) {
        this.tree = tree;
    }

    /** Finds what a disc overlaps or touches, and returns how many. Numbers are finite. A null filter is none. */
    public int disc(float x, float y, float radius, IntPredicate filter) {
        found.clear();
        int boxes = nearDisc(x, y, radius);
        for (int b = 0; b < boxes; b++) {
            int end = end(near[b]);
            for (int k = first(near[b]); k < end; k++) {
                if (CircleTests.overlapsDisc(x, y, radius, tree.x[k], tree.y[k], tree.radius[k])
                        && tree.isNearest(k, x, y)) {
                    addIfAdmitted(k, filter);
                }
            }
        }
        found.sort(tree.idLimit);
        return found.count();
    }

    /** The same of a box. */
    public int box(float minX, float minY, float maxX, float maxY, IntPredicate filter) {
        found.clear();
        int boxes = near(minX, minY, maxX, maxY);
        for (int b = 0; b < boxes; b++) {
            int end = end(near[b]);
            for (int k = first(near[b]); k < end; k++) {
                if (CircleTests.overlapsBox(minX, minY, maxX, maxY, tree.x[k], tree.y[k], tree.radius[k])
                        && tree.isNearest(k, 0.5 * minX + 0.5 * maxX, 0.5 * minY + 0.5 * maxY)) {
                    addIfAdmitted(k, filter);
                }
            }
        }
        found.sort(tree.idLimit);
        return found.count();
    }

    /** They ascend. */
    public int id(int k) {
        return found.id(k);
    }

    /**
     * The circle at a point, also on its edge; of several, the one whose centre is nearest, then of the lowest id. -1 if there is none.
     */
    public int pick(float x, float y, IntPredicate filter) {
        int boxes = nearDisc(x, y, 0);
        int best = -1;
        double least = Double.POSITIVE_INFINITY;
        for (int b = 0; b < boxes; b++) {
            int end = end(near[b]);
            for (int k = first(near[b]); k < end; k++) {
                double square = CircleTests.squaredDistance(x, y, tree.x[k], tree.y[k]);
                boolean better = square < least || square == least && tree.id[k] < best;
                if (better
                        && CircleTests.overlapsDisc(x, y, 0, tree.x[k], tree.y[k], tree.radius[k])
                        && tree.isNearest(k, x, y)
                        && (filter == null || filter.test(tree.id[k]))) {
                    best = tree.id[k];
                    least = square;
                }
            }
        }
        return best;
    }

    /** How many circles a search for what a disc overlaps looks at. */
    int circlesNear(float x, float y, float radius) {
        return CircleTree.CIRCLES_A_BOX * nearDisc(x, y, radius);
    }

    private void addIfAdmitted(int k, IntPredicate filter) {
        if (filter == null || filter.test(tree.id[k])) {
            found.add(tree.id[k]);
        }
    }

    private static int first(int box) {
        return CircleTree.CIRCLES_A_BOX * box;
    }

    private int end(int box) {
        return Math.min(CircleTree.CIRCLES_A_BOX * (box + 1), tree.size);
    }

    private int nearDisc(double x, double y, double radius) {
        double marginX = (Math.abs(x) + radius) * MARGIN + radius;
        double marginY = (Math.abs(y) + radius) * MARGIN + radius;
        return near((float) (x - marginX), (float) (y - marginY), (float) (x + marginX), (float) (y + marginY));
    }

    /** Lists the boxes of level 0 that an area overlaps in {@link #near}, and returns their number. */
    private int near(float minX, float minY, float maxX, float maxY) {
        int count = 0;
        if (tree.size == 0) {
            return count;
        }
        float[] box = tree.box;
        waitingLevel[0] = tree.top;
        waitingGroup[0] = 0;
        int waiting = 1;
        while (waiting > 0) {
            int level = waitingLevel[--waiting];
            int first = CircleTree.BOXES_A_BOX * waitingGroup[waiting];
            int end = Math.min(first + CircleTree.BOXES_A_BOX, tree.boxes[level]);
            for (int b = first; b < end; b++) {
                int at = tree.levelStart[level] + CircleTree.BOX_STRIDE * b;
                if (box[at + CircleTree.MIN_X] <= maxX
                        && box[at + CircleTree.MAX_X] >= minX
                        && box[at + CircleTree.MIN_Y] <= maxY
                        && box[at + CircleTree.MAX_Y] >= minY) {
                    if (level > 0) {
                        waitingLevel[waiting] = level - 1;
                        waitingGroup[waiting++] = b;
                    } else {
                        if (count == near.length) {
                            near = Arrays.copyOf(near, Capacity.atLeast(count + 1, near.length));
                        }
                        near[count++] = b;
                    }
                }
            }
        }
        return count;
    }
}
