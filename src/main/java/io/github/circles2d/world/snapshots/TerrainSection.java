package io.github.circles2d.world.snapshots;

import io.github.circles2d.world.model.Bounds;
import io.github.circles2d.world.model.CircleRow;
import io.github.circles2d.world.model.ContactRows;
import io.github.circles2d.world.model.Limits;
import io.github.circles2d.world.model.PieceRow;
import io.github.circles2d.world.model.TerrainLimits;
import io.github.circles2d.world.terrain.SavedPieceContacts;
import io.github.circles2d.world.terrain.SavedTerrain;
import java.nio.ByteBuffer;
import java.util.Arrays;

/**
 * Terrain in a snapshot: sections of {@link ParameterSections}, if there is or has been some.
 *
 * <pre>
 * section    of terrain: int ids of pieces, ids of bodies; for each body but the ground: byte flags; varint generation if it is not 0; if it
 *            lives: double x, y, int angle; if it moves: float velocity x, y, angular velocity; if it travels: float x, y, int angle;
 *            if it has moved otherwise in the last step: float velocity x, y, angular velocity.
 *            For each piece: byte flags, of which the lowest three are the form and the side; if the flags say so: varint generation, byte
 *            kind, varint body, varint piece that follows in the chain; then of a line float x, y of its ends and, if the flags say so, the
 *            thickness; of an arc float x, y, direction of the middle x, y, radius, int half of the opening
 *            of contacts: int number of contacts; for each, ascending: varint id of the circle minus that of the contact before (0 at first),
 *            varint id of the piece minus that of the contact before if the circle is the same; byte flags, of which the lowest two are the side
 *            plus 1; for each flag: float normal impulse, impulses by {@link ContactRows}
 * </pre>
 */
final class TerrainSection {
    // flags of a body
    private static final int LIVES = 1;
    private static final int HAS_GENERATION = 2;
    private static final int MOVES = 4;
    private static final int TRAVELS = 8;
    private static final int MOVED_OTHERWISE = 16;

    // flags of a piece, above its form and its side
    private static final int SHAPE = PieceRow.FORM | PieceRow.SOLID_OUTSIDE;
    private static final int PIECE_GENERATION = 8;
    private static final int HAS_KIND = 16;
    private static final int HAS_BODY = 32;
    private static final int HAS_AFTER = 64;
    private static final int HAS_THICKNESS = 128;

    /** Of the square of the length of a direction. */
    private static final float UNIT_SLACK = 1e-5f;

    // flags of a contact, above its side
    private static final int SIDE = 3;
    private static final int HAS_IMPULSE = 4;
    private static final int ROW_SHIFT = 3;
    private static final int CONTACT_FLAGS = (1 << ROW_SHIFT + ContactRows.COUNT) - 1;
    private static final int LEAST_CONTACT = 3;

    private TerrainSection() {}

    private static boolean isZero(float value) {
        return Float.floatToRawIntBits(value) == 0;
    }

    // ---- writing

    private static int bodyFlags(SavedTerrain t, int id) {
        int generation = t.bodyGeneration[id] == 0 ? 0 : HAS_GENERATION;
        if (!t.bodyLives[id]) {
            return generation;
        }
        boolean moves = !(isZero(t.bodies.vx[id]) && isZero(t.bodies.vy[id]) && isZero(t.bodies.omega[id]));
        return LIVES
                | generation
                | (moves ? MOVES : 0)
                | (t.bodies.travels[id] ? TRAVELS : 0)
                | (hasMovedOtherwise(t, id) ? MOVED_OTHERWISE : 0);
    }

    /** Whether a body has not moved in the last step as its velocities say. */
    private static boolean hasMovedOtherwise(SavedTerrain t, int id) {
        return t.bodies.lastVx[id] != t.bodies.vx[id]
                || t.bodies.lastVy[id] != t.bodies.vy[id]
                || t.bodies.lastOmega[id] != t.bodies.omega[id];
    }

    private static int pieceFlags(SavedTerrain t, int piece) {
        int generation = t.pieceGeneration[piece] == 0 ? 0 : PIECE_GENERATION;
        if (!t.lives(piece)) {
            return generation;
        }
        boolean thick = PieceRow.form(t.shape[piece]) != PieceRow.ARC && !isZero(t.form[SavedTerrain.FORM * piece + 4]);
        return t.shape[piece]
                | generation
                | (t.kind[piece] == 0 ? 0 : HAS_KIND)
                | (t.body[piece] == 0 ? 0 : HAS_BODY)
                | (t.after[piece] < 0 ? 0 : HAS_AFTER)
                | (thick ? HAS_THICKNESS : 0);
    }

    /** Writes the section of terrain behind its number. */
    static void write(SavedTerrain t, ByteBuffer out) {
        out.putInt(t.pieceIds).putInt(t.bodyIds);
        for (int id = 1; id < t.bodyIds; id++) {
            writeBody(t, id, out);
        }
        for (int piece = 0; piece < t.pieceIds; piece++) {
            writePiece(t, piece, out);
        }
    }

    private static void writeBody(SavedTerrain t, int id, ByteBuffer out) {
        int flags = bodyFlags(t, id);
        out.put((byte) flags);
        if ((flags & HAS_GENERATION) != 0) {
            Varint.put(out, t.bodyGeneration[id]);
        }
        if ((flags & LIVES) != 0) {
            out.putDouble(t.bodies.x[id]).putDouble(t.bodies.y[id]).putInt(t.bodies.angle[id]);
        }
        if ((flags & MOVES) != 0) {
            out.putFloat(t.bodies.vx[id]).putFloat(t.bodies.vy[id]).putFloat(t.bodies.omega[id]);
        }
        if ((flags & TRAVELS) != 0) {
            out.putFloat(t.bodies.targetX[id]).putFloat(t.bodies.targetY[id]).putInt(t.bodies.targetAngle[id]);
        }
        if ((flags & MOVED_OTHERWISE) != 0) {
            out.putFloat(t.bodies.lastVx[id]).putFloat(t.bodies.lastVy[id]).putFloat(t.bodies.lastOmega[id]);
        }
    }

    private static void writePiece(SavedTerrain t, int piece, ByteBuffer out) {
        int flags = pieceFlags(t, piece);
        out.put((byte) flags);
        if ((flags & PIECE_GENERATION) != 0) {
            Varint.put(out, t.pieceGeneration[piece]);
        }
        if ((flags & HAS_KIND) != 0) {
            out.put(t.kind[piece]);
        }
        if ((flags & HAS_BODY) != 0) {
            Varint.put(out, t.body[piece]);
        }
        if ((flags & HAS_AFTER) != 0) {
            Varint.put(out, t.after[piece]);
        }
        for (int k = 0; k < floats(flags); k++) {
            out.putFloat(t.form[SavedTerrain.FORM * piece + k]);
        }
        if ((flags & PieceRow.FORM) == PieceRow.ARC) {
            out.putInt(t.half[piece]);
        }
    }

    /** The floats of a form. */
    private static int floats(int flags) {
        return switch (flags & PieceRow.FORM) {
            case PieceRow.NO_PIECE -> 0;
            case PieceRow.ARC -> SavedTerrain.FORM;
            default -> SavedTerrain.FORM - ((flags & HAS_THICKNESS) == 0 ? 1 : 0);
        };
    }

    private static int more(SavedPieceContacts c, int k) {
        return c.circle[k] - (k == 0 ? 0 : c.circle[k - 1]);
    }

    private static int pieceKey(SavedPieceContacts c, int k, int more) {
        return k > 0 && more == 0 ? c.piece[k] - c.piece[k - 1] : c.piece[k];
    }

    private static int flags(SavedPieceContacts c, int k) {
        int flags = c.side[k] + 1 | (isZero(c.impulse[k]) ? 0 : HAS_IMPULSE);
        for (int row = 0; row < ContactRows.COUNT; row++) {
            flags |= isZero(c.rows[ContactRows.of(k) + row]) ? 0 : 1 << ROW_SHIFT + row;
        }
        return flags;
    }

    /** Writes the section of contacts behind its number. */
    static void write(SavedPieceContacts c, ByteBuffer out) {
        out.putInt(c.count);
        for (int k = 0; k < c.count; k++) {
            int more = more(c, k);
            int flags = flags(c, k);
            Varint.put(out, more);
            Varint.put(out, pieceKey(c, k, more));
            out.put((byte) flags);
            if ((flags & HAS_IMPULSE) != 0) {
                out.putFloat(c.impulse[k]);
            }
            for (int row = 0; row < ContactRows.COUNT; row++) {
                if ((flags >> ROW_SHIFT + row & 1) != 0) {
                    out.putFloat(c.rows[ContactRows.of(k) + row]);
                }
            }
        }
    }

    // ---- reading

    /** Reads the section of terrain behind its number, and checks all but which piece follows which. */
    static void readTerrain(ByteBuffer in, SavedState s) {
        int pieces = in.getInt();
        int bodies = in.getInt();
        boolean fits = pieces >= 0
                && pieces <= TerrainLimits.PIECES
                && bodies >= 1
                && bodies <= TerrainLimits.BODIES
                && pieces + bodies > 1
                && pieces + bodies - 1 <= in.remaining();
        if (!fits) {
            throw SnapshotCodec.refused("it cannot hold " + pieces + " pieces and " + bodies + " bodies of terrain");
        }
        SavedTerrain t = s.terrain;
        t.setIds(pieces, bodies);
        Bounds bounds = s.parameters().bounds();
        for (int id = 1; id < bodies; id++) {
            readBody(in, t, id, bounds);
        }
        for (int piece = 0; piece < pieces; piece++) {
            readPiece(in, t, piece, bounds);
        }
    }

    private static void readBody(ByteBuffer in, SavedTerrain t, int id, Bounds bounds) {
        int flags = SnapshotCodec.getByte(in);
        boolean lives = (flags & LIVES) != 0;
        SnapshotCodec.require(
                flags <= (LIVES | HAS_GENERATION | MOVES | TRAVELS | MOVED_OTHERWISE)
                        && (lives || (flags & ~HAS_GENERATION) == 0),
                "a body of terrain has no such flags");
        t.bodyGeneration[id] = SnapshotCodec.getGeneration(in, (flags & HAS_GENERATION) != 0);
        t.bodyLives[id] = lives;
        t.bodies.x[id] = 0;
        t.bodies.y[id] = 0;
        t.bodies.angle[id] = 0;
        if (lives) {
            t.bodies.x[id] = place(in.getDouble(), bounds.minX(), bounds.maxX(), bounds.periodX());
            t.bodies.y[id] = place(in.getDouble(), bounds.minY(), bounds.maxY(), bounds.periodY());
            t.bodies.angle[id] = in.getInt();
        }
        boolean moves = (flags & MOVES) != 0;
        t.bodies.vx[id] = 0f;
        t.bodies.vy[id] = 0f;
        t.bodies.omega[id] = 0f;
        if (moves) {
            t.bodies.vx[id] = velocity(in.getFloat());
            t.bodies.vy[id] = velocity(in.getFloat());
            t.bodies.omega[id] = velocity(in.getFloat());
            SnapshotCodec.require(
                    t.bodies.vx[id] != 0f || t.bodies.vy[id] != 0f || t.bodies.omega[id] != 0f,
                    "a body of terrain moves that is at rest");
        }
        t.bodies.travels[id] = (flags & TRAVELS) != 0;
        t.bodies.targetX[id] = 0f;
        t.bodies.targetY[id] = 0f;
        t.bodies.targetAngle[id] = 0;
        if (t.bodies.travels[id]) {
            t.bodies.targetX[id] = (float) place(in.getFloat(), bounds.minX(), bounds.maxX(), bounds.periodX());
            t.bodies.targetY[id] = (float) place(in.getFloat(), bounds.minY(), bounds.maxY(), bounds.periodY());
            t.bodies.targetAngle[id] = in.getInt();
        }
        t.bodies.lastVx[id] = t.bodies.vx[id];
        t.bodies.lastVy[id] = t.bodies.vy[id];
        t.bodies.lastOmega[id] = t.bodies.omega[id];
        if ((flags & MOVED_OTHERWISE) != 0) {
            t.bodies.lastVx[id] = velocity(in.getFloat());
            t.bodies.lastVy[id] = velocity(in.getFloat());
            t.bodies.lastOmega[id] = velocity(in.getFloat());
            SnapshotCodec.require(hasMovedOtherwise(t, id), "a body of terrain has not moved otherwise");
        }
    }

    private static double place(double at, double min, double max, double period) {
        boolean wraps = period != Double.POSITIVE_INFINITY;
        double least = wraps ? min : -Limits.COORDINATE;
        double most = wraps ? max : Limits.COORDINATE;
        SnapshotCodec.require(at >= least && at <= most, "a body of terrain is out of range");
        return at;
    }

    private static float velocity(float value) {
        SnapshotCodec.require(
                Math.abs(value) <= Limits.SPEED && Float.floatToRawIntBits(value) != Integer.MIN_VALUE,
                "a velocity of terrain is out of range");
        return value;
    }

    private static void readPiece(ByteBuffer in, SavedTerrain t, int piece, Bounds bounds) {
        int flags = SnapshotCodec.getByte(in);
        t.shape[piece] = (byte) (flags & SHAPE);
        t.kind[piece] = 0;
        t.body[piece] = 0;
        t.after[piece] = -1;
        t.half[piece] = 0;
        int form = flags & PieceRow.FORM;
        boolean fits = form == PieceRow.NO_PIECE && (flags & ~PIECE_GENERATION) == 0
                || form == PieceRow.SEGMENT && (flags & (PieceRow.SOLID_OUTSIDE | HAS_AFTER)) == 0
                || form == PieceRow.LINE && (flags & (PieceRow.SOLID_OUTSIDE | HAS_THICKNESS)) == 0
                || form == PieceRow.ARC && (flags & HAS_THICKNESS) == 0;
        SnapshotCodec.require(fits, "a piece of terrain has no such flags");
        t.pieceGeneration[piece] = SnapshotCodec.getGeneration(in, (flags & PIECE_GENERATION) != 0);
        if ((flags & HAS_KIND) != 0) {
            t.kind[piece] = (byte) SnapshotCodec.getByte(in);
            SnapshotCodec.require(t.kind[piece] != 0, "a piece of terrain has a kind of 0");
        }
        if ((flags & HAS_BODY) != 0) {
            int body = Varint.get(in);
            SnapshotCodec.require(body > 0 && body < t.bodyIds && t.bodyLives[body], "a piece of terrain has no body");
            t.body[piece] = body;
        }
        if ((flags & HAS_AFTER) != 0) {
            int after = Varint.get(in);
            SnapshotCodec.require(after >= 0 && after < t.pieceIds, "a piece of terrain is followed by none");
            t.after[piece] = after;
        }
        int at = SavedTerrain.FORM * piece;
        t.form[at + 4] = 0f;
        for (int k = 0; k < floats(flags); k++) {
            t.form[at + k] = in.getFloat();
        }
        if (form == PieceRow.ARC) {
            t.half[piece] = in.getInt();
            checkArc(t.form, at, t.half[piece], bounds);
        } else if (form != PieceRow.NO_PIECE) {
            TerrainLimits.segment(t.form[at], t.form[at + 1], t.form[at + 2], t.form[at + 3], t.form[at + 4], bounds);
            SnapshotCodec.require(
                    (flags & HAS_THICKNESS) == 0 || !isZero(t.form[at + 4]), "a segment has a thickness of 0");
        }
    }

    private static void checkArc(float[] form, int at, int half, Bounds bounds) {
        float square = form[at + 2] * form[at + 2] + form[at + 3] * form[at + 3];
        SnapshotCodec.require(Math.abs(square - 1f) <= UNIT_SLACK, "the direction of an arc is none");
        SnapshotCodec.require(half > 0 || half == Integer.MIN_VALUE, "the opening of an arc is out of range");
        TerrainLimits.arc(form[at], form[at + 1], form[at + 4], half, bounds);
    }

    /** Each piece follows one at most, of the same body, and both are of chains. */
    static void checkChains(SavedTerrain t) {
        boolean[] follows = new boolean[t.pieceIds];
        for (int piece = 0; piece < t.pieceIds; piece++) {
            int after = t.after[piece];
            if (t.lives(piece) && after >= 0) {
                int form = PieceRow.form(t.shape[after]);
                SnapshotCodec.require(
                        (form == PieceRow.LINE || form == PieceRow.ARC)
                                && t.body[after] == t.body[piece]
                                && !follows[after],
                        "a piece of terrain is followed by one that cannot follow it");
                follows[after] = true;
            }
        }
    }

    /** Reads the section of contacts behind its number, and checks it; circles and terrain have been read. */
    static void readContacts(ByteBuffer in, SavedState s) {
        int count = in.getInt();
        if (!(count > 0 && (long) count * LEAST_CONTACT <= in.remaining())) {
            throw SnapshotCodec.refused("it cannot hold " + count + " contacts with terrain");
        }
        SavedPieceContacts c = s.pieceContacts;
        c.ensure(count);
        long circle = 0;
        long piece = -1;
        for (int k = 0; k < count; k++) {
            long more = Integer.toUnsignedLong(Varint.get(in));
            long key = Integer.toUnsignedLong(Varint.get(in));
            boolean same = k > 0 && more == 0;
            SnapshotCodec.require(!same || key > 0, "its contacts with terrain are not in order");
            circle += more;
            piece = same ? piece + key : key;
            readContact(in, s, circle, piece);
        }
    }

    private static void readContact(ByteBuffer in, SavedState s, long circle, long piece) {
        int index = circle < s.ids ? Arrays.binarySearch(s.id, 0, s.circles, (int) circle) : -1;
        SnapshotCodec.require(
                index >= 0 && s.traits[CircleRow.of(index) + CircleRow.INVERSE_MASS] != 0f,
                "a contact with terrain has no circle that moves");
        SnapshotCodec.require(
                piece < s.terrain.pieceIds && s.terrain.lives((int) piece), "a contact with terrain has no piece");
        int flags = SnapshotCodec.getByte(in);
        int side = (flags & SIDE) - 1;
        boolean twoSided = PieceRow.form(s.terrain.shape[(int) piece]) == PieceRow.SEGMENT;
        SnapshotCodec.require(
                flags <= CONTACT_FLAGS && side <= 1 && (twoSided || side >= 0) && (side != 0 || (flags & ~SIDE) == 0),
                "a contact with terrain has no such flags");
        float impulse = (flags & HAS_IMPULSE) == 0 ? 0f : value(in, 0f);
        float[] rows = s.pieceContacts.next;
        for (int row = 0; row < ContactRows.COUNT; row++) {
            rows[row] = (flags >> ROW_SHIFT + row & 1) == 0 ? 0f : value(in, -Limits.WALL_IMPULSE);
        }
        s.pieceContacts.add((int) circle, (int) piece, 0, side, impulse, rows, 0);
    }

    private static float value(ByteBuffer in, float least) {
        float value = in.getFloat();
        SnapshotCodec.require(!isZero(value), "it has a 0 of a contact with terrain");
        return Limits.within("an impulse of terrain", value, least, Limits.WALL_IMPULSE);
    }
}
