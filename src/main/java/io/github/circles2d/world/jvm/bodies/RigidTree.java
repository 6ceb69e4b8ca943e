package io.github.circles2d.world.jvm.bodies;

import java.util.Arrays;

/** A tree over boxes, to find those that meet another one. It decides nothing: who asks looks closer. */
final class RigidTree {
    /** Boxes of a leaf, at most. */
    private static final int LEAF = 4;

    /** How often boxes move before the tree is built anew. */
    private static final int MOST_MOVES = 15;

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

    /** The boxes over which it was built, and how often they have moved since. */
    private int built;

    private int moves;

    /** Boxes that a search has found. */
    static final class Found {
        int[] box = new int[16];
        int count;

        private void add(int which) {
            if (count == box.length) {
                box = Arrays.copyOf(box, 2 * count);
            }
            box[count++] = which;
        }

        long bytes() {
            return 4L * box.length;
        }
    }

    /** Makes room for boxes. */
    void ensure(int count) {
        if (4 * count > box.length) {
            box = new float[8 * count];
            order = new int[2 * count];
        }
    }

    /** Makes the tree over the first boxes. Those of few steps lie nearly as before, and so may the tree: it is only more or less good. */
    void build(int count) {
        if (count == built && moves < MOST_MOVES) {
            moves++;
            measure();
            return;
        }
        for (int k = 0; k < count; k++) {
            order[k] = k;
        }
        nodes = 0;
        if (count > 0) {
            split(0, count);
        }
        built = count;
        moves = 0;
    }

    /** Measures the nodes again, each behind those below it. */
    private void measure() {
        for (int node = nodes - 1; node >= 0; node--) {
            if (from[node] < to[node]) {
                enclose(node, from[node], to[node]);
            } else {
                int n = 4 * node;
                int one = 4 * (node + 1);
                int two = 4 * skip[node + 1];
                nodeBox[n] = Math.min(nodeBox[one], nodeBox[two]);
                nodeBox[n + 1] = Math.min(nodeBox[one + 1], nodeBox[two + 1]);
                nodeBox[n + 2] = Math.max(nodeBox[one + 2], nodeBox[two + 2]);
                nodeBox[n + 3] = Math.max(nodeBox[one + 3], nodeBox[two + 3]);
            }
        }
    }

    /** Measures a node by its boxes. */
    private void enclose(int node, int low, int high) {
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
        enclose(node, low, high);
        from[node] = low;
        to[node] = high;
        if (high - low > LEAF) {
            to[node] = low; // its children have them
            int middle = low + high >>> 1;
            float width = nodeBox[4 * node + 2] - nodeBox[4 * node];
            float height = nodeBox[4 * node + 3] - nodeBox[4 * node + 1];
            select(low, high - 1, middle, width > height ? 0 : 1);
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

    /** Finds those that meet a box, by boxes inside those of the tree or by these; adds them to those found. */
    void find(float[] boxes, float minX, float minY, float maxX, float maxY, Found found) {
        int node = 0;
        while (node < nodes) {
            int n = 4 * node;
            if (nodeBox[n] <= maxX && nodeBox[n + 1] <= maxY && nodeBox[n + 2] >= minX && nodeBox[n + 3] >= minY) {
                for (int k = from[node]; k < to[node]; k++) {
                    int b = 4 * order[k];
                    if (boxes[b] <= maxX && boxes[b + 1] <= maxY && boxes[b + 2] >= minX && boxes[b + 3] >= minY) {
                        found.add(order[k]);
                    }
                }
                node++;
            } else {
                node = skip[node];
            }
        }
    }

    long bytes() {
        return 4L * (box.length + order.length + 7L * skip.length);
    }
}
