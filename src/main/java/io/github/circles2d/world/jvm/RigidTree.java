package io.github.circles2d.world.jvm;

import java.util.Arrays;

/** A tree over boxes, to find those that meet another one. It decides nothing: who asks looks closer. */
final class RigidTree {
    /** Boxes of a leaf, at most. */
    private static final int LEAF = 4;

    /** By box: least x and y, greatest x and y. */
    float[] box = new float[0];

    private int[] order = new int[0];

    // by node, in the order of a walk: its box, the node that follows if it is left out, and where its boxes lie in the
    // order
    private float[] nodeBox = new float[0];
    private int[] skip = new int[0];
    private int[] from = new int[0];
    private int[] to = new int[0];
    private int nodes;

    /** What was found last. */
    int[] found = new int[16];

    int foundCount;

    /** Makes room for boxes. */
    void ensure(int count) {
        if (4 * count > box.length) {
            box = new float[8 * count];
            order = new int[2 * count];
        }
    }

    /** Builds the tree over the first boxes. */
    void build(int count) {
        for (int k = 0; k < count; k++) {
            order[k] = k;
        }
        nodes = 0;
        if (count > 0) {
            split(0, count);
        }
    }

    private void split(int low, int high) {
        int node = nodes++;
        if (node == skip.length) {
            int n = Math.max(32, 2 * node);
            nodeBox = Arrays.copyOf(nodeBox, 4 * n);
            skip = Arrays.copyOf(skip, n);
            from = Arrays.copyOf(from, n);
            to = Arrays.copyOf(to, n);
        }
        float minX = Float.POSITIVE_INFINITY;
        float minY = Float.POSITIVE_INFINITY;
        float maxX = Float.NEGATIVE_INFINITY;
        float maxY = Float.NEGATIVE_INFINITY;
        for (int k = low; k < high; k++) {
            int b = 4 * order[k];
            minX = Math.min(minX, box[b]);
            minY = Math.min(minY, box[b + 1]);
            maxX = Math.max(maxX, box[b + 2]);
            maxY = Math.max(maxY, box[b + 3]);
        }
        nodeBox[4 * node] = minX;
        nodeBox[4 * node + 1] = minY;
        nodeBox[4 * node + 2] = maxX;
        nodeBox[4 * node + 3] = maxY;
        from[node] = low;
        to[node] = high;
        if (high - low > LEAF) {
            to[node] = low; // its children have them
            int middle = low + high >>> 1;
            select(low, high - 1, middle, maxX - minX > maxY - minY ? 0 : 1);
            split(low, middle);
            split(middle, high);
        }
        skip[node] = nodes;
    }

    private float middle(int k, int axis) {
        int b = 4 * order[k] + axis;
        return box[b] + box[b + 2];
    }

    /** Brings the box of a rank to its place, and lesser ones before it. */
    private void select(int low, int high, int rank, int axis) {
        while (low < high) {
            float pivot = middle(low + high >>> 1, axis);
            int a = low;
            int b = high;
            while (a <= b) {
                while (middle(a, axis) < pivot) {
                    a++;
                }
                while (middle(b, axis) > pivot) {
                    b--;
                }
                if (a <= b) {
                    int kept = order[a];
                    order[a++] = order[b];
                    order[b--] = kept;
                }
            }
            if (rank <= b) {
                high = b;
            } else if (rank >= a) {
                low = a;
            } else {
                return;
            }
        }
    }

    /** Finds the boxes that meet a box; adds them to those found. */
    void find(float minX, float minY, float maxX, float maxY) {
        int node = 0;
        while (node < nodes) {
            int n = 4 * node;
            if (nodeBox[n] <= maxX && nodeBox[n + 1] <= maxY && nodeBox[n + 2] >= minX && nodeBox[n + 3] >= minY) {
                for (int k = from[node]; k < to[node]; k++) {
                    int b = 4 * order[k];
                    if (box[b] <= maxX && box[b + 1] <= maxY && box[b + 2] >= minX && box[b + 3] >= minY) {
                        if (foundCount == found.length) {
                            found = Arrays.copyOf(found, 2 * foundCount);
                        }
                        found[foundCount++] = order[k];
                    }
                }
                node++;
            } else {
                node = skip[node];
            }
        }
    }

    long bytes() {
        return 4L * (box.length + order.length + 7L * skip.length + found.length);
    }
}
