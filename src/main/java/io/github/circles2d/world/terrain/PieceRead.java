package io.github.circles2d.world.terrain;

import io.github.circles2d.world.model.PieceRow;
import io.github.circles2d.world.model.Rotation;
import java.util.Arrays;

/** What pieces look like now, for callers that draw them. */
public final class PieceRead {
    public static final int STRIDE = 13;

    public static final int SHAPE = 0;
    public static final int KIND = 1;

    // of a line; 0 in an arc
    public static final int X1 = 2;
    public static final int Y1 = 3;
    public static final int X2 = 4;
    public static final int Y2 = 5;
    public static final int THICKNESS = 6;

    // of an arc; 0 in a line
    public static final int CENTRE_X = 7;
    public static final int CENTRE_Y = 8;
    public static final int RADIUS = 9;
    public static final int FROM = 10;
    public static final int TO = 11;

    /** Of an arc: 1 if circles are inside it, else 0. */
    public static final int INSIDE = 12;

    private final TerrainTables terrain;
    private final PieceRows writer;
    private final BodyPoses now = new BodyPoses();
    private final float[] rows = new float[PieceRow.STRIDE];

    public PieceRead(TerrainTables terrain) {
        this.terrain = terrain;
        writer = new PieceRows(terrain.pieces);
    }

    /** As of now. Both arrays have room; handles may be null. */
    public void read(float[] to, long[] handles) {
        now.keep(terrain.bodies);
        read(now, to, handles);
    }

    /** With bodies in such poses, which are those of all bodies that there are. */
    public void read(BodyPoses poses, float[] to, long[] handles) {
        PieceTable pieces = terrain.pieces;
        writer.setBounds(terrain.bounds());
        int posed = -1;
        int n = 0;
        for (int piece = 0; piece < pieces.ids.end(); piece++) {
            if (pieces.ids.lives(piece)) {
                int body = pieces.body[piece];
                if (body != posed) {
                    writer.setPose(poses.x(body), poses.y(body), poses.angle(body));
                    posed = body;
                }
                if (handles != null) {
                    handles[n] = pieces.ids.handle(piece);
                }
                write(pieces, piece, to, STRIDE * n++);
            }
        }
    }

    private void write(PieceTable pieces, int piece, float[] to, int at) {
        writer.write(piece, rows, 0);
        Arrays.fill(to, at, at + STRIDE, 0f);
        to[at + SHAPE] = PieceRow.form(pieces.shape(piece));
        to[at + KIND] = pieces.kindOf(piece);
        float x = rows[PieceRow.X];
        float y = rows[PieceRow.Y];
        if (pieces.isArc(piece)) {
            double middle = Math.atan2(rows[PieceRow.TY], rows[PieceRow.TX]);
            double half = Integer.toUnsignedLong(pieces.half[piece]) * Rotation.RADIANS_PER_UNIT;
            to[at + CENTRE_X] = x;
            to[at + CENTRE_Y] = y;
            to[at + RADIUS] = rows[PieceRow.LENGTH];
            to[at + FROM] = (float) (middle - half);
            to[at + TO] = (float) (middle + half);
            to[at + INSIDE] = pieces.isSolidOutside(piece) ? 1f : 0f;
        } else {
            to[at + X1] = x;
            to[at + Y1] = y;
            to[at + X2] = x + rows[PieceRow.END_X];
            to[at + Y2] = y + rows[PieceRow.END_Y];
            to[at + THICKNESS] = rows[PieceRow.THICKNESS];
        }
    }
}
