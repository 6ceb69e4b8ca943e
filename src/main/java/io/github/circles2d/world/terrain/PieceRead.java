package io.github.circles2d.world.terrain;

import io.github.circles2d.world.model.PieceRow;
import io.github.circles2d.world.model.Rotation;

/** What pieces look like now, for callers that draw them. */
public final class PieceRead {
    public static final int STRIDE = 8;

    public static final int SHAPE = 0;
    public static final int KIND = 1;

    // of a line
    public static final int X1 = 2;
    public static final int Y1 = 3;
    public static final int X2 = 4;
    public static final int Y2 = 5;
    public static final int THICKNESS = 6;

    // of an arc
    public static final int CENTRE_X = 2;
    public static final int CENTRE_Y = 3;
    public static final int RADIUS = 4;
    public static final int FROM = 5;
    public static final int TO = 6;

    /** Of an arc: 1 if circles are inside it, else 0. */
    public static final int INSIDE = 7;

    private final TerrainTables terrain;

    public PieceRead(TerrainTables terrain) {
        this.terrain = terrain;
    }

    /** Both have room, and the tables do; handles may be null. */
    public void read(float[] to, long[] handles) {
        terrain.refresh();
        PieceTable pieces = terrain.pieces;
        int n = 0;
        for (int piece = 0; piece < pieces.ids.end(); piece++) {
            if (pieces.ids.lives(piece)) {
                if (handles != null) {
                    handles[n] = pieces.ids.handle(piece);
                }
                write(pieces, piece, to, STRIDE * n++);
            }
        }
    }

    private static void write(PieceTable pieces, int piece, float[] to, int at) {
        float[] rows = pieces.rows;
        int row = PieceRow.of(piece);
        to[at + SHAPE] = PieceRow.form(pieces.shape(piece));
        to[at + KIND] = pieces.kindOf(piece);
        float x = rows[row + PieceRow.X];
        float y = rows[row + PieceRow.Y];
        if (pieces.isArc(piece)) {
            double middle = Math.atan2(rows[row + PieceRow.TY], rows[row + PieceRow.TX]);
            double half = Integer.toUnsignedLong(pieces.half[piece]) * Rotation.RADIANS_PER_UNIT;
            to[at + CENTRE_X] = x;
            to[at + CENTRE_Y] = y;
            to[at + RADIUS] = rows[row + PieceRow.LENGTH];
            to[at + FROM] = (float) (middle - half);
            to[at + TO] = (float) (middle + half);
            to[at + INSIDE] = pieces.isSolidOutside(piece) ? 1f : 0f;
        } else {
            to[at + X1] = x;
            to[at + Y1] = y;
            to[at + X2] = x + rows[row + PieceRow.END_X];
            to[at + Y2] = y + rows[row + PieceRow.END_Y];
            to[at + THICKNESS] = rows[row + PieceRow.THICKNESS];
            to[at + INSIDE] = 0f;
        }
    }
}
