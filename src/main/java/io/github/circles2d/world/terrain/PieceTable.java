package io.github.circles2d.world.terrain;

import io.github.circles2d.world.circles.Handle;
import io.github.circles2d.world.circles.IdTable;
import io.github.circles2d.world.circles.StateHash;
import io.github.circles2d.world.model.PieceRow;
import io.github.circles2d.world.model.TerrainStep;
import java.util.Arrays;
import java.util.function.IntConsumer;

/**
 * The pieces of terrain: of each its body, its form in the frame of the body, its neighbours in a chain, and its row for steps
 * ({@link PieceRow}), which follows from these and the pose of the body.
 */
public final class PieceTable {
    // a form: of a line; of an arc the centre, the direction of its middle, the radius
    static final int FORM = SavedTerrain.FORM;
    static final int X = 0;
    static final int Y = 1;
    static final int X2 = 2;
    static final int Y2 = 3;
    static final int THICKNESS = 4;
    static final int MIDDLE_X = 2;
    static final int MIDDLE_Y = 3;
    static final int RADIUS = 4;

    /** Sine of the least angle by which a chain turns to its right; by less it is straight. */
    private static final double STRAIGHT = 0x1p-13;

    /** Is told of a piece whose contacts so far do not count. */
    private IntConsumer renewed = piece -> {};

    public final IdTable ids = new IdTable(Handle.PIECE);

    float[] form = new float[0];

    /** Of an arc: half its opening, in units of an angle, without sign; 2^31 is a circle. */
    int[] half = new int[0];

    int[] body = new int[0];

    /** The piece before it in its chain, or -1. */
    int[] before = new int[0];

    int[] after = new int[0];

    // the pieces of each body, in a list
    private int[] nextOfBody = new int[0];
    private int[] previousOfBody = new int[0];

    public int[] traits = new int[0];
    public float[] rows = new float[0];

    private final BodyTable bodies;
    private final PieceRows filler = new PieceRows(this);
    private int lastSerial;

    /** Rows and traits that have changed since the last step: from the first one to before the last one. */
    private int changedFrom = Integer.MAX_VALUE;

    private int changedTo;

    private int names;

    /** Of the names that it was computed with. */
    private long hash;

    private int hashedNames;

    PieceTable(BodyTable bodies) {
        this.bodies = bodies;
    }

    /** Makes room for more pieces. If there is none, nothing has changed. */
    public void ensure(int more) {
        int needed = ids.size() + more;
        if (needed > ids.room()) {
            setRoom(Math.max(Math.max(needed, 16), ids.room() + (ids.room() >> 1)));
        }
    }

    private void setRoom(int c) {
        form = Arrays.copyOf(form, FORM * c);
        half = Arrays.copyOf(half, c);
        body = Arrays.copyOf(body, c);
        before = Arrays.copyOf(before, c);
        after = Arrays.copyOf(after, c);
        nextOfBody = Arrays.copyOf(nextOfBody, c);
        previousOfBody = Arrays.copyOf(previousOfBody, c);
        traits = Arrays.copyOf(traits, PieceRow.TRAITS * c);
        rows = Arrays.copyOf(rows, PieceRow.STRIDE * c);
        ids.setRoom(c);
    }

    PieceRows filler() {
        return filler;
    }

    int nextOfBody(int piece) {
        return nextOfBody[piece];
    }

    public int bodyOf(int piece) {
        return body[piece];
    }

    /** Counts how often a piece has come or gone, or has got a kind. */
    public int names() {
        return names;
    }

    public int kindOf(int piece) {
        return traits[PieceRow.traits(piece) + PieceRow.KIND];
    }

    /** Whether a piece has a kind. */
    public boolean has(int kind) {
        for (int piece = 0; piece < ids.end(); piece++) {
            if (ids.has(piece) && kindOf(piece) == kind) {
                return true;
            }
        }
        return false;
    }

    /** Names who is told of pieces whose contacts so far do not count. */
    public void watch(IntConsumer whom) {
        renewed = whom;
    }

    int serial(int piece) {
        return traits[PieceRow.traits(piece) + PieceRow.SERIAL];
    }

    int shape(int piece) {
        return traits[PieceRow.traits(piece) + PieceRow.SHAPE];
    }

    private void setShape(int piece, int shape) {
        traits[PieceRow.traits(piece) + PieceRow.SHAPE] = shape;
    }

    boolean isArc(int piece) {
        return PieceRow.form(shape(piece)) == PieceRow.ARC;
    }

    boolean isSolidOutside(int piece) {
        return (shape(piece) & PieceRow.SOLID_OUTSIDE) != 0;
    }

    boolean isAllAround(int piece) {
        return isArc(piece) && half[piece] == Integer.MIN_VALUE;
    }

    // ---- changes, for which there is room

    /** A two-sided segment, or a line of a chain. */
    int addLine(int ofBody, int kind, int shape, float x1, float y1, float x2, float y2, float thickness) {
        int piece = add(ofBody, kind, shape);
        int at = FORM * piece;
        form[at + X] = x1;
        form[at + Y] = y1;
        form[at + X2] = x2;
        form[at + Y2] = y2;
        form[at + THICKNESS] = thickness;
        half[piece] = 0;
        return piece;
    }

    int addArc(
            int ofBody,
            int kind,
            int shape,
            float centreX,
            float centreY,
            float middleX,
            float middleY,
            float radius,
            int halfOpening) {
        int piece = add(ofBody, kind, shape);
        int at = FORM * piece;
        form[at + X] = centreX;
        form[at + Y] = centreY;
        form[at + MIDDLE_X] = middleX;
        form[at + MIDDLE_Y] = middleY;
        form[at + RADIUS] = radius;
        half[piece] = halfOpening;
        return piece;
    }

    private int add(int ofBody, int kind, int shape) {
        int piece = ids.add();
        body[piece] = ofBody;
        before[piece] = -1;
        after[piece] = -1;
        link(piece);
        traits[PieceRow.traits(piece) + PieceRow.KIND] = kind;
        traits[PieceRow.traits(piece) + PieceRow.MOTION] = 0;
        setShape(piece, shape);
        renew(piece);
        names++;
        return piece;
    }

    /** Puts a piece first in the list of its body. */
    private void link(int piece) {
        int first = bodies.firstPiece[body[piece]];
        nextOfBody[piece] = first;
        previousOfBody[piece] = -1;
        if (first >= 0) {
            previousOfBody[first] = piece;
        }
        bodies.firstPiece[body[piece]] = piece;
    }

    private void unlink(int piece) {
        int next = nextOfBody[piece];
        int previous = previousOfBody[piece];
        if (next >= 0) {
            previousOfBody[next] = previous;
        }
        if (previous >= 0) {
            nextOfBody[previous] = next;
        } else {
            bodies.firstPiece[body[piece]] = next;
        }
    }

    /** Contacts of the piece so far do not count. */
    void renew(int piece) {
        renewed.accept(piece);
        traits[PieceRow.traits(piece) + PieceRow.SERIAL] = ++lastSerial;
        changed(piece);
    }

    public void setKind(int piece, int kind) {
        traits[PieceRow.traits(piece) + PieceRow.KIND] = kind;
        names++;
        changed(piece);
    }

    /** Joins the end of a piece to the start of another; both have their forms. */
    void join(int piece, int next) {
        after[piece] = next;
        before[next] = piece;
        filler.takeTangent(piece, 1);
        double x = filler.tangentX;
        double y = filler.tangentY;
        filler.takeTangent(next, -1);
        double cross = x * filler.tangentY - y * filler.tangentX;
        double dot = x * filler.tangentX + y * filler.tangentY;
        int joint = cross >= 0 || dot > 0 && cross > -STRAIGHT ? PieceRow.CONVEX : PieceRow.CONCAVE;
        setJoint(piece, PieceRow.END_LOG, joint);
        setJoint(next, PieceRow.START_LOG, joint);
    }

    private void setJoint(int piece, int log, int joint) {
        setShape(piece, shape(piece) & ~(PieceRow.JOINT << log) | joint << log);
        changed(piece);
    }

    /** Removes a piece; the ends of its neighbours are free then. */
    void remove(int piece) {
        int previous = before[piece];
        int next = after[piece];
        if (previous >= 0) {
            after[previous] = -1;
            setJoint(previous, PieceRow.END_LOG, PieceRow.FREE);
        }
        if (next >= 0) {
            before[next] = -1;
            setJoint(next, PieceRow.START_LOG, PieceRow.FREE);
        }
        unlink(piece);
        ids.remove(piece);
        setShape(piece, PieceRow.NO_PIECE);
        renew(piece);
        names++;
        if (previous >= 0 && previous != piece) {
            filler.fill(previous);
        }
    }

    // ---- states

    /** What of a shape is not a joint. */
    private static int withoutJoints(int shape) {
        return shape & (PieceRow.FORM | PieceRow.SOLID_OUTSIDE);
    }

    /** The part of the pieces in the hash of the state: one number for each. What is in it changes as seldom as the names. */
    long hash() {
        if (hashedNames != names) {
            hash = computeHash();
            hashedNames = names;
        }
        return hash;
    }

    private long computeHash() {
        long sum = 0;
        for (int piece = 0; piece < ids.end(); piece++) {
            if (ids.lives(piece)) {
                long h = StateHash.absorb(StateHash.absorb(StateHash.piece(), piece), withoutJoints(shape(piece)));
                h = StateHash.absorb(StateHash.absorb(h, kindOf(piece)), body[piece]);
                h = StateHash.absorb(StateHash.absorb(h, after[piece]), half[piece]);
                for (int k = FORM * piece; k < FORM * (piece + 1); k++) {
                    h = StateHash.absorb(h, form[k]);
                }
                sum += h;
            }
        }
        return sum;
    }

    void save(SavedTerrain to) {
        int n = ids.end();
        ids.save(to.pieceGeneration);
        for (int piece = 0; piece < n; piece++) {
            to.shape[piece] = (byte) withoutJoints(shape(piece));
            to.kind[piece] = (byte) kindOf(piece);
        }
        System.arraycopy(body, 0, to.body, 0, n);
        System.arraycopy(after, 0, to.after, 0, n);
        System.arraycopy(half, 0, to.half, 0, n);
        System.arraycopy(form, 0, to.form, 0, FORM * n);
    }

    /** Makes room for pieces of a saved state. */
    void makeRoom(int pieces) {
        if (pieces > ids.room()) {
            setRoom(pieces);
        }
    }

    /** Whether the saved pieces are those that are there, by their bits. */
    boolean areThose(SavedTerrain from) {
        boolean same = from.pieceIds == ids.end();
        for (int piece = 0; same && piece < from.pieceIds; piece++) {
            same = ids.isSame(piece, from.lives(piece), from.pieceGeneration[piece])
                    && (!ids.lives(piece) || isThat(from, piece));
        }
        return same;
    }

    private boolean isThat(SavedTerrain from, int piece) {
        boolean same = from.shape[piece] == withoutJoints(shape(piece))
                && Byte.toUnsignedInt(from.kind[piece]) == kindOf(piece)
                && from.body[piece] == body[piece]
                && from.after[piece] == after[piece]
                && from.half[piece] == half[piece];
        for (int k = FORM * piece; same && k < FORM * (piece + 1); k++) {
            same = Float.floatToRawIntBits(from.form[k]) == Float.floatToRawIntBits(form[k]);
        }
        return same;
    }

    /** Takes over saved pieces, whose bodies are there; there is room. Rows have to be filled. */
    void load(SavedTerrain from) {
        int n = from.pieceIds;
        int before = ids.end();
        ids.load(from.pieceGeneration, n);
        System.arraycopy(from.body, 0, body, 0, n);
        System.arraycopy(from.half, 0, half, 0, n);
        System.arraycopy(from.form, 0, form, 0, FORM * n);
        for (int piece = 0; piece < n; piece++) {
            this.before[piece] = -1;
            after[piece] = -1;
            setShape(piece, from.shape[piece]);
            traits[PieceRow.traits(piece) + PieceRow.KIND] = Byte.toUnsignedInt(from.kind[piece]);
            traits[PieceRow.traits(piece) + PieceRow.MOTION] = 0;
            renew(piece);
            if (from.lives(piece)) {
                ids.revive(piece);
                link(piece);
            }
        }
        for (int piece = n; piece < before; piece++) {
            setShape(piece, PieceRow.NO_PIECE);
            renew(piece);
        }
        changedFrom = 0; // what has changed behind the last piece is no step's any more
        changedTo = n;
        for (int piece = 0; piece < n; piece++) {
            if (from.lives(piece) && from.after[piece] >= 0) {
                join(piece, from.after[piece]);
            }
        }
        names++;
    }

    // ---- rows

    void changed(int piece) {
        changedFrom = Math.min(changedFrom, piece);
        changedTo = Math.max(changedTo, piece + 1);
    }

    /** Tells a step of the rows. */
    void publish(TerrainStep step) {
        step.pieces = ids.end();
        step.rows = rows;
        step.traits = traits;
        if (changedTo > 0) {
            step.changedFrom = changedFrom;
            step.changedTo = changedTo;
            step.version++;
            changedFrom = Integer.MAX_VALUE;
            changedTo = 0;
        }
    }
}
