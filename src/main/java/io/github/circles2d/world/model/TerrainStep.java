package io.github.circles2d.world.model;

/**
 * The terrain as a step begins. Meaningless unless {@link StepConstants#terrain}. The arrays belong to the host's tables, which change them between
 * steps; those that devices copy say by a version whether they have changed.
 */
public final class TerrainStep {
    /** Greatest id of a piece, and 1. */
    public int pieces;

    /** {@link PieceRow} */
    public float[] rows = new float[0];

    /** {@link PieceRow#TRAITS} */
    public int[] traits = new int[0];

    /** Of rows and traits. */
    public int version;

    /** The pieces whose rows and traits differ from those of the version before: from the first to before the last. */
    public int changedFrom;

    public int changedTo;

    /** Number of nodes of the tree; see {@code BoxTree}. */
    public int nodes;

    /** Of each node: least x, least y, greatest x, greatest y of its pieces within the step. */
    public float[] boxes = new float[0];

    /** Of each node, in the order of a walk: the node that follows if its box is left out, and its piece, or -1. */
    public int[] links = new int[0];

    /** Of boxes and links. */
    public int treeVersion;

    /** Of links; they stay the same while bodies move. */
    public int linksVersion;

    /** Nodes of the ground, which come first. */
    public int groundNodes;

    /** Of boxes and links of the ground. */
    public int groundVersion;

    /** The first node whose box differs from that of the tree's version before. */
    public int boxesFrom;

    /** Rows of {@link #motion} in use, of which the first is empty. */
    public int bodies;

    /** {@link BodyRow} */
    public float[] motion = new float[0];

    public int motionVersion;

    public final KindTerrain kinds = new KindTerrain();

    /** The first node from one on that has a piece, and whose box meets another one; -1 if there is none. */
    public int find(int from, float minX, float minY, float maxX, float maxY) {
        int node = from;
        while (node < nodes) {
            int b = 4 * node;
            boolean meets = boxes[b] <= maxX && boxes[b + 1] <= maxY && boxes[b + 2] >= minX && boxes[b + 3] >= minY;
            if (meets && piece(node) >= 0) {
                return node;
            }
            node = meets ? node + 1 : links[2 * node];
        }
        return -1;
    }

    /** The piece of a node, or -1. */
    public int piece(int node) {
        return links[2 * node + 1];
    }
}
