package io.github.circles2d.world.terrain;

import io.github.circles2d.world.model.PieceRow;

/**
 * The terrain of a saved state, by the ids of pieces and bodies. Body 0 is the ground, which is always there and never moves. Arrays are reused,
 * and may be longer than their contents.
 */
public final class SavedTerrain {
    /** Floats of the form of a piece: of a line x, y of its ends and the thickness; of an arc x, y, the direction of its middle, the radius. */
    public static final int FORM = 5;

    /** Ids of pieces in use so far. */
    public int pieceIds;

    public int[] pieceGeneration = new int[0];

    /** By piece: its form and {@link PieceRow#SOLID_OUTSIDE}, without joints; {@link PieceRow#NO_PIECE} of a free id. */
    public byte[] shape = new byte[0];

    /** By piece: the number of its kind. */
    public byte[] kind = new byte[0];

    public int[] body = new int[0];

    /** By piece: the one that follows it in its chain, or -1. */
    public int[] after = new int[0];

    /** By piece: {@link #FORM} floats. */
    public float[] form = new float[0];

    /** By piece: half the opening of an arc, in units of an angle without sign; else 0. */
    public int[] half = new int[0];

    /** Ids of bodies in use so far, at least 1. */
    public int bodyIds = 1;

    public int[] bodyGeneration = new int[1];
    public boolean[] bodyLives = new boolean[1];

    public final BodyStates bodies = new BodyStates();

    public SavedTerrain() {
        bodies.setRoom(1);
    }

    /** As it is at first. */
    public void clear() {
        pieceIds = 0;
        bodyIds = 1;
        bodyLives[0] = true;
    }

    public boolean isAsAtFirst() {
        return pieceIds == 0 && bodyIds == 1;
    }

    public boolean lives(int piece) {
        return shape[piece] != PieceRow.NO_PIECE;
    }

    /** Whether there are pieces. */
    public boolean hasPieces() {
        for (int piece = 0; piece < pieceIds; piece++) {
            if (lives(piece)) {
                return true;
            }
        }
        return false;
    }

    /** Makes room, without the contents so far, and sets the numbers. */
    public void setIds(int ofPieces, int ofBodies) {
        if (half.length < ofPieces) {
            // The array that is compared grows last: a growth that fails is tried again.
            int c = Math.max(ofPieces, half.length + (half.length >> 1));
            pieceGeneration = new int[c];
            shape = new byte[c];
            kind = new byte[c];
            body = new int[c];
            after = new int[c];
            form = new float[FORM * c];
            half = new int[c];
        }
        if (bodies.room() < ofBodies) {
            int c = Math.max(ofBodies, bodies.room() + (bodies.room() >> 1));
            bodyGeneration = new int[c];
            bodyLives = new boolean[c];
            bodies.setRoom(c);
        }
        pieceIds = ofPieces;
        bodyIds = ofBodies;
        bodyLives[0] = true;
    }
}
