package io.github.circles2d.world.terrain;

import io.github.circles2d.world.model.PieceRow;
import java.util.Arrays;

/**
 * Two trees of boxes over pieces, one behind the other: over those of the ground, and over those of bodies. A node comes before the nodes
 * below it, and says which node follows them. So a search needs no stack:
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
 * <p>A box holds the whole motion of its pieces in the step. It is larger than that by a share that covers rounding.
 */
public final class PieceTree {
    public static final int BOX_STRIDE = 4;
    public static final int MIN_X = 0;
    public static final int MIN_Y = 1;
    public static final int MAX_X = 2;
    public static final int MAX_Y = 3;

    public static final int LINK_STRIDE = 2;

    /** The node that follows if a node is left out. */
    public static final int SKIP = 0;

    /** The piece of a node, or -1. */
    public static final int PIECE = 1;

    /** Of coordinates and extents. */
    private static final float MARGIN = 0x1p-21f;

    /** The tree of bodies that have moved is built anew once its boxes are so much larger than they were. */
    private static final double WORN = 2;

    float[] boxes = new float[0];
    int[] links = new int[0];

    /** By node of the ground, then of bodies. */
    private int groundNodes;

    private int nodes;
    private int[] order = new int[0];

    // by place in the order: the middle, side by side, since rows are far apart
    private float[] middleX = new float[0];
    private float[] middleY = new float[0];
    private double sizeAsBuilt;

    PieceTree() {}

    int nodes() {
        return nodes;
    }

    /** Nodes of the ground. */
    int groundNodes() {
        return groundNodes;
    }

    private static int nodesOf(int pieces) {
        return pieces == 0 ? 0 : 2 * pieces - 1;
    }

    /** Makes room for trees over so many pieces in all. If there is none, nothing has changed. */
    void ensure(int pieces) {
        if (order.length < pieces) {
            int c = Math.max(pieces, order.length + (order.length >> 1));
            float[] newBoxes = Arrays.copyOf(boxes, BOX_STRIDE * nodesOf(c));
            int[] newLinks = Arrays.copyOf(links, LINK_STRIDE * nodesOf(c));
            float[] newMiddleX = new float[c];
            float[] newMiddleY = new float[c];
            int[] newOrder = new int[c];
            boxes = newBoxes;
            links = newLinks;
            middleX = newMiddleX;
            middleY = newMiddleY;
            order = newOrder;
        }
    }

    /** Builds the tree of the ground; that of bodies is gone. There is room. */
    void buildGround(PieceTable pieces) {
        int n = collect(pieces, true);
        groundNodes = nodesOf(n);
        nodes = groundNodes;
        build(0, n);
        refit(pieces.rows, 0, groundNodes);
    }

    /** Builds the tree of bodies behind it. */
    void buildBodies(PieceTable pieces) {
        int n = collect(pieces, false);
        nodes = groundNodes + nodesOf(n);
        build(groundNodes, n);
        sizeAsBuilt = refit(pieces.rows, groundNodes, nodes);
    }

    /** Fits the boxes of bodies to the rows; says whether the tree should be built anew. */
    boolean refitBodies(PieceTable pieces) {
        return refit(pieces.rows, groundNodes, nodes) > WORN * sizeAsBuilt;
    }

    private int collect(PieceTable pieces, boolean ofGround) {
        int n = 0;
        for (int piece = 0; piece < pieces.ids.end(); piece++) {
            if (pieces.ids.lives(piece) && (pieces.body[piece] == BodyTable.GROUND) == ofGround) {
                middleX[n] = pieces.rows[PieceRow.of(piece) + PieceRow.MID_X];
                middleY[n] = pieces.rows[PieceRow.of(piece) + PieceRow.MID_Y];
                order[n++] = piece;
            }
        }
        return n;
    }

    private void build(int first, int n) {
        if (n > 0) {
            build(first, 0, n);
        }
    }

    /** Halves the pieces along the axis along which their middles lie farther apart. The depth is the logarithm of their number. */
    private void build(int node, int from, int to) {
        int n = to - from;
        links[LINK_STRIDE * node + SKIP] = node + nodesOf(n);
        if (n == 1) {
            links[LINK_STRIDE * node + PIECE] = order[from];
            return;
        }
        links[LINK_STRIDE * node + PIECE] = -1;
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

    /** Brings the least pieces to the left of a place, by Hoare's selection. */
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
        int piece = order[i];
        order[i] = order[j];
        order[j] = piece;
        float x = middleX[i];
        middleX[i] = middleX[j];
        middleX[j] = x;
        float y = middleY[i];
        middleY[i] = middleY[j];
        middleY[j] = y;
    }

    /** Computes the boxes of nodes, those below first; returns the sum of their sides. */
    private double refit(float[] rows, int from, int to) {
        double sum = 0;
        for (int node = to - 1; node >= from; node--) {
            int at = BOX_STRIDE * node;
            int piece = links[LINK_STRIDE * node + PIECE];
            if (piece >= 0) {
                fit(rows, PieceRow.of(piece), at);
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

    private void fit(float[] rows, int row, int at) {
        float x = rows[row + PieceRow.MID_X];
        float y = rows[row + PieceRow.MID_Y];
        float reachX = rows[row + PieceRow.HALF_X] + rows[row + PieceRow.MOST];
        float reachY = rows[row + PieceRow.HALF_Y] + rows[row + PieceRow.MOST];
        reachX += (Math.abs(x) + reachX) * MARGIN;
        reachY += (Math.abs(y) + reachY) * MARGIN;
        boxes[at + MIN_X] = x - reachX;
        boxes[at + MIN_Y] = y - reachY;
        boxes[at + MAX_X] = x + reachX;
        boxes[at + MAX_Y] = y + reachY;
    }
}
