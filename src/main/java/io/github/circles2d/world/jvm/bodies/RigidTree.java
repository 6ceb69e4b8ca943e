package io.github.circles2d.world.jvm.bodies;

import io.github.circles2d.world.terrain.BoxTree;
import java.util.Arrays;

/** A tree over boxes, to find those that meet another one. It decides nothing: who asks looks closer. */
final class RigidTree extends BoxTree {
    /** How often boxes move before the tree is built anew: those of few steps lie nearly as before. */
    private static final int MOST_MOVES = 15;

    /** Of each box: least x and y, greatest x and y. */
    float[] box = new float[0];

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

    /** Makes room for boxes, which are lost then. */
    void makeRoom(int count) {
        ensure(count);
        if (4 * count > box.length) {
            box = new float[8 * count];
        }
    }

    /** Makes the tree over the first boxes. */
    void build(int count) {
        if (count == built && moves < MOST_MOVES) {
            moves++;
        } else {
            for (int k = 0; k < count; k++) {
                put(k, k, box[4 * k] + box[4 * k + 2], box[4 * k + 1] + box[4 * k + 3]);
            }
            nodes = nodesOf(count);
            build(0, count);
            built = count;
            moves = 0;
        }
        refit(0, nodes);
    }

    @Override
    protected void fit(int which, int at) {
        for (int k = 0; k < BOX_STRIDE; k++) {
            boxes[at + k] = box[BOX_STRIDE * which + k];
        }
    }

    /** Finds those that meet a box, by boxes inside those of the tree or by these; adds them to those found. */
    void find(float[] of, float minX, float minY, float maxX, float maxY, Found found) {
        int node = 0;
        while (node < nodes) {
            if (meets(boxes, BOX_STRIDE * node, minX, minY, maxX, maxY)) {
                int which = links[LINK_STRIDE * node + THING];
                if (which >= 0 && meets(of, BOX_STRIDE * which, minX, minY, maxX, maxY)) {
                    found.add(which);
                }
                node++;
            } else {
                node = links[LINK_STRIDE * node + SKIP];
            }
        }
    }

    private static boolean meets(float[] of, int b, float minX, float minY, float maxX, float maxY) {
        return of[b] <= maxX && of[b + 1] <= maxY && of[b + 2] >= minX && of[b + 3] >= minY;
    }

    long bytes() {
        return 4L * box.length + treeBytes();
    }
}
