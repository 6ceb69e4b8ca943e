package io.github.circles2d.world.terrain;

import io.github.circles2d.world.model.PieceRow;

/**
 * Two trees of boxes over pieces, one behind the other: over those of the ground, and over those of bodies.
 *
 * <p>A box holds the whole motion of its pieces in the step. It is larger than that by a share that covers rounding.
 */
final class PieceTree extends BoxTree {
    /** Of coordinates and extents. */
    private static final float MARGIN = 0x1p-21f;

    /** The tree of bodies that have moved is built anew once its boxes are so much larger than they were. */
    private static final double WORN = 2;

    /** By node of the ground, then of bodies. */
    private int groundNodes;

    private int nodes;
    private double sizeAsBuilt;

    /** Those of the pieces of the last call. */
    private float[] rows;

    int nodes() {
        return nodes;
    }

    /** Nodes of the ground. */
    int groundNodes() {
        return groundNodes;
    }

    /** Builds the tree of the ground; that of bodies is gone. There is room. */
    void buildGround(PieceTable pieces) {
        int n = collect(pieces, true);
        groundNodes = nodesOf(n);
        nodes = groundNodes;
        build(0, n);
        refit(0, groundNodes);
    }

    /** Builds the tree of bodies behind it. */
    void buildBodies(PieceTable pieces) {
        int n = collect(pieces, false);
        nodes = groundNodes + nodesOf(n);
        build(groundNodes, n);
        sizeAsBuilt = refit(groundNodes, nodes);
    }

    /** Fits the boxes of bodies to the rows; says whether the tree should be built anew. */
    boolean refitBodies(PieceTable pieces) {
        rows = pieces.rows;
        return refit(groundNodes, nodes) > WORN * sizeAsBuilt;
    }

    private int collect(PieceTable pieces, boolean ofGround) {
        rows = pieces.rows;
        int n = 0;
        for (int piece = 0; piece < pieces.ids.end(); piece++) {
            if (pieces.ids.lives(piece) && (pieces.body[piece] == BodyTable.GROUND) == ofGround) {
                int row = PieceRow.of(piece);
                put(n++, piece, rows[row + PieceRow.MID_X], rows[row + PieceRow.MID_Y]);
            }
        }
        return n;
    }

    @Override
    protected void fit(int piece, int at) {
        int row = PieceRow.of(piece);
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
