package io.github.circles2d.bench.broadphase;

import java.util.Arrays;

/**
 * A binary tree of boxes, balanced as Box2D's: a leaf goes where it makes the boxes least longer around, and rotations keep the
 * heights of two siblings within one of each other. Leaf i is node i.
 */
final class BoxTree {
    static final int NONE = -1;

    /** Bytes of a node: box, parent, two children and height. */
    static final int BYTES = 32;

    private static final int MIN_X = 0;
    private static final int MIN_Y = 1;
    private static final int MAX_X = 2;
    private static final int MAX_Y = 3;

    private final int leaves;

    /** Four numbers per node. */
    private final float[] box;

    private final int[] parent;
    private final int[] left;
    private final int[] right;
    private final int[] height;

    /** Inner nodes that are not in use, linked by {@link #parent}. */
    private int free;

    private int root = NONE;
    private int[] stack = new int[64];

    /** Nodes that insertions and queries looked at. */
    long visited;

    BoxTree(int leaves) {
        this.leaves = leaves;
        int nodes = 2 * leaves;
        box = new float[4 * nodes];
        parent = new int[nodes];
        left = new int[nodes];
        right = new int[nodes];
        height = new int[nodes];
        for (int node = leaves; node < nodes; node++) {
            parent[node] = node + 1 < nodes ? node + 1 : NONE;
        }
        free = leaves;
    }

    /** Whether a leaf's box holds another. */
    boolean holds(int leaf, float minX, float minY, float maxX, float maxY) {
        int b = 4 * leaf;
        return box[b + MIN_X] <= minX && box[b + MIN_Y] <= minY && box[b + MAX_X] >= maxX && box[b + MAX_Y] >= maxY;
    }

    /** Height of the tree; 0 if it has one leaf. */
    int height() {
        return root == NONE ? 0 : height[root];
    }

    /** Puts a leaf that is not in the tree into it. */
    void insert(int leaf, float minX, float minY, float maxX, float maxY) {
        int b = 4 * leaf;
        box[b + MIN_X] = minX;
        box[b + MIN_Y] = minY;
        box[b + MAX_X] = maxX;
        box[b + MAX_Y] = maxY;
        height[leaf] = 0;
        if (root == NONE) {
            root = leaf;
            parent[leaf] = NONE;
            return;
        }
        int sibling = bestSibling(leaf);
        int inner = free;
        free = parent[inner];
        int above = parent[sibling];
        parent[inner] = above;
        left[inner] = sibling;
        right[inner] = leaf;
        parent[sibling] = inner;
        parent[leaf] = inner;
        if (above == NONE) {
            root = inner;
        } else {
            replaceChild(above, sibling, inner);
        }
        refit(inner);
    }

    private void replaceChild(int above, int old, int fresh) {
        if (left[above] == old) {
            left[above] = fresh;
        } else {
            right[above] = fresh;
        }
    }

    /** Goes down as long as a child costs less than a new parent here, where cost is the growth of half a box's circumference. */
    private int bestSibling(int leaf) {
        int node = root;
        while (node >= leaves) {
            visited += 2;
            float together = joined(node, leaf);
            float inherited = together - around(node);
            int l = left[node];
            int r = right[node];
            float costLeft = inherited + growth(l, leaf);
            float costRight = inherited + growth(r, leaf);
            if (together < costLeft && together < costRight) {
                break;
            }
            node = costLeft < costRight ? l : r;
        }
        return node;
    }

    private float growth(int node, int leaf) {
        return node < leaves ? joined(node, leaf) : joined(node, leaf) - around(node);
    }

    private float around(int node) {
        int b = 4 * node;
        return box[b + MAX_X] - box[b + MIN_X] + (box[b + MAX_Y] - box[b + MIN_Y]);
    }

    private float joined(int a, int c) {
        int p = 4 * a;
        int q = 4 * c;
        return Math.max(box[p + MAX_X], box[q + MAX_X])
                - Math.min(box[p + MIN_X], box[q + MIN_X])
                + (Math.max(box[p + MAX_Y], box[q + MAX_Y]) - Math.min(box[p + MIN_Y], box[q + MIN_Y]));
    }

    /** Takes a leaf out of the tree. */
    void remove(int leaf) {
        int inner = parent[leaf];
        if (inner == NONE) {
            root = NONE;
            return;
        }
        int sibling = left[inner] == leaf ? right[inner] : left[inner];
        int above = parent[inner];
        parent[sibling] = above;
        parent[inner] = free;
        free = inner;
        if (above == NONE) {
            root = sibling;
        } else {
            replaceChild(above, inner, sibling);
            refit(above);
        }
    }

    /** Balances and refits the boxes from a node up to the root. */
    private void refit(int from) {
        for (int node = from; node != NONE; node = parent[node]) {
            node = balance(node);
            fit(node);
            visited++;
        }
    }

    private void fit(int node) {
        int b = 4 * node;
        int l = 4 * left[node];
        int r = 4 * right[node];
        box[b + MIN_X] = Math.min(box[l + MIN_X], box[r + MIN_X]);
        box[b + MIN_Y] = Math.min(box[l + MIN_Y], box[r + MIN_Y]);
        box[b + MAX_X] = Math.max(box[l + MAX_X], box[r + MAX_X]);
        box[b + MAX_Y] = Math.max(box[l + MAX_Y], box[r + MAX_Y]);
        height[node] = 1 + Math.max(height[left[node]], height[right[node]]);
    }

    /** Lifts the higher child of a node into its place if it is higher by two; gives the node that is in that place then. */
    private int balance(int node) {
        int difference = height[right[node]] - height[left[node]];
        if (difference > 1) {
            return lift(node, right[node]);
        }
        return difference < -1 ? lift(node, left[node]) : node;
    }

    /** The lifted child keeps its own higher child, and gives the other one to the node. */
    private int lift(int node, int child) {
        int above = parent[node];
        boolean keepsLeft = height[left[child]] > height[right[child]];
        int kept = keepsLeft ? left[child] : right[child];
        int given = keepsLeft ? right[child] : left[child];
        replaceChild(node, child, given);
        parent[given] = node;
        left[child] = node;
        right[child] = kept;
        parent[node] = child;
        parent[child] = above;
        if (above == NONE) {
            root = child;
        } else {
            replaceChild(above, node, child);
        }
        fit(node);
        return child;
    }

    /** Takes the leaves whose boxes overlap that of a leaf, the leaf itself among them. */
    int overlapping(int leaf, int[][] found) {
        int q = 4 * leaf;
        float minX = box[q + MIN_X];
        float minY = box[q + MIN_Y];
        float maxX = box[q + MAX_X];
        float maxY = box[q + MAX_Y];
        int count = 0;
        int depth = 1;
        stack[0] = root;
        long looked = 0;
        while (depth > 0) {
            int node = stack[--depth];
            int b = 4 * node;
            looked++;
            if (box[b + MIN_X] > maxX || box[b + MIN_Y] > maxY || box[b + MAX_X] < minX || box[b + MAX_Y] < minY) {
                continue;
            }
            if (node < leaves) {
                if (count == found[0].length) {
                    found[0] = Arrays.copyOf(found[0], 2 * count);
                }
                found[0][count++] = node;
            } else {
                if (depth + 2 > stack.length) {
                    stack = Arrays.copyOf(stack, 2 * stack.length);
                }
                stack[depth++] = left[node];
                stack[depth++] = right[node];
            }
        }
        visited += looked;
        return count;
    }
}
