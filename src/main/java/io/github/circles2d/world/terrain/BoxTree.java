package io.github.circles2d.world.terrain;

import java.util.Arrays;

/**
 * A tree of boxes over things. A node comes before the nodes below it, and says which node follows them. So a search needs no stack:
 *
 * <pre>{@code
 * for (int i = 0; i < nodes; ) {
 *     if (meets(boxes, 4 * i)) {
 *         if (links[2 * i + 1] >= 0) { ... }
 *         i++;
 *     } else {
 *         i = links[2 * i];
 *     }
 * }
 * }</pre>
 *
 */
public abstract class BoxTree {
    public static final int BOX_STRIDE = 4;
    public static final int MIN_X = 0;
    public static final int MIN_Y = 1;
    public static final int MAX_X = 2;
    public static final int MAX_Y = 3;

    public static final int LINK_STRIDE = 2;

    /** The node that follows if a node is left out. */
    public static final int SKIP = 0;

    /** The thing of a node, or -1. */
    public static final int THING = 1;

    /** By node. */
    public float[] boxes = new float[0];

    /** By node. */
    public int[] links = new int[0];

    private int[] order = new int[0];

    // by place in the order: the middle, side by side
    private float[] middleX = new float[0];
    private float[] middleY = new float[0];

    protected BoxTree() {}

    protected static int nodesOf(int things) {
        return things == 0 ? 0 : 2 * things - 1;
    }

    /** Makes room for trees over so many things in all. If there is none, nothing has changed. */
    public final void ensure(int things) {
        if (order.length < things) {
            int c = Math.max(things, order.length + (order.length >> 1));
            boxes = Arrays.copyOf(boxes, BOX_STRIDE * nodesOf(c));
            links = Arrays.copyOf(links, LINK_STRIDE * nodesOf(c));
            middleX = new float[c];
            middleY = new float[c];
            order = new int[c];
        }
    }

    protected final long treeBytes() {
        return 4L * (boxes.length + links.length) + 12L * order.length;
    }

    /** Puts a thing at a place in the order, and says where its middle is. */
    protected final void put(int place, int thing, float x, float y) {
        middleX[place] = x;
        middleY[place] = y;
        order[place] = thing;
    }

    /** Writes the box of a thing, which begins at an element. */
    protected abstract void fit(int thing, int at);

    /** Builds the tree of the first things of the order behind some nodes; their boxes are not fitted yet. There is room. */
    protected final void build(int first, int n) {
        if (n > 0) {
            build(first, 0, n);
        }
    }

    /** Halves the things along the axis along which their middles lie farther apart. The depth is the logarithm of their number. */
    private void build(int node, int from, int to) {
        int n = to - from;
        links[LINK_STRIDE * node + SKIP] = node + nodesOf(n);
        if (n == 1) {
            links[LINK_STRIDE * node + THING] = order[from];
            return;
        }
        links[LINK_STRIDE * node + THING] = -1;
        int middle = from + to >>> 1;
        select(isWide(from, to) ? middleX : middleY, from, to - 1, middle);
        build(node + 1, from, middle);
        build(node + 1 + nodesOf(middle - from), middle, to);
    }

    private boolean isWide(int from, int to) {
        float minX = Float.POSITIVE_INFINITY;
        float minY = Float.POSITIVE_INFINITY;
        float maxX = Float.NEGATIVE_INFINITY;
        float maxY = Float.NEGATIVE_INFINITY;
        for (int k = from; k < to; k++) {
            minX = Math.min(minX, middleX[k]);
            minY = Math.min(minY, middleY[k]);
            maxX = Math.max(maxX, middleX[k]);
            maxY = Math.max(maxY, middleY[k]);
        }
        return maxX - minX >= maxY - minY;
    }

    /** Brings the least things to the left of a place, by Hoare's selection. */
    private void select(float[] middles, int from, int to, int place) {
        int low = from;
        int high = to;
        while (low < high) {
            float pivot = middles[low + high >>> 1];
            int i = low;
            int j = high;
            while (i <= j) {
                while (middles[i] < pivot) {
                    i++;
                }
                while (middles[j] > pivot) {
                    j--;
                }
                if (i <= j) {
                    swap(i++, j--);
                }
            }
            if (place <= j) {
                high = j;
            } else if (place >= i) {
                low = i;
            } else {
                return;
            }
        }
    }

    private void swap(int i, int j) {
        int thing = order[i];
        order[i] = order[j];
        order[j] = thing;
        float x = middleX[i];
        middleX[i] = middleX[j];
        middleX[j] = x;
        float y = middleY[i];
        middleY[i] = middleY[j];
        middleY[j] = y;
    }

    /** Computes the boxes of nodes, those below first; returns the sum of their sides. */
    protected final double refit(int from, int to) {
        double sum = 0;
        for (int node = to - 1; node >= from; node--) {
            int at = BOX_STRIDE * node;
            int thing = links[LINK_STRIDE * node + THING];
            if (thing >= 0) {
                fit(thing, at);
            } else {
                int left = at + BOX_STRIDE;
                int right = BOX_STRIDE * links[LINK_STRIDE * (node + 1) + SKIP];
                boxes[at + MIN_X] = Math.min(boxes[left + MIN_X], boxes[right + MIN_X]);
                boxes[at + MIN_Y] = Math.min(boxes[left + MIN_Y], boxes[right + MIN_Y]);
                boxes[at + MAX_X] = Math.max(boxes[left + MAX_X], boxes[right + MAX_X]);
                boxes[at + MAX_Y] = Math.max(boxes[left + MAX_Y], boxes[right + MAX_Y]);
            }
            sum += (double) boxes[at + MAX_X] - boxes[at + MIN_X] + boxes[at + MAX_Y] - boxes[at + MIN_Y];
        }
        return sum;
    }
}
