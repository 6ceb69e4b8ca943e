package io.github.circles2d.world.changes;

import static io.github.circles2d.world.shared.Call.real;
import static java.lang.Float.floatToRawIntBits;

import io.github.circles2d.world.circles.KindTable;
import io.github.circles2d.world.joints.JointDepartures;
import io.github.circles2d.world.model.Limits;
import io.github.circles2d.world.model.TerrainLimits;
import io.github.circles2d.world.shared.Call;
import io.github.circles2d.world.shared.Calls;
import io.github.circles2d.world.shared.WorldParts;
import io.github.circles2d.world.terrain.BodyPoses;
import io.github.circles2d.world.terrain.ChainPath;
import io.github.circles2d.world.terrain.PieceRead;
import io.github.circles2d.world.terrain.PieceTable;

/** The calls on pieces of terrain. A change acts from the next step on. */
public final class Pieces implements Calls.Effects {
    private static final int SEGMENT_STRIDE = 4;

    private final WorldParts world;
    private final PieceTable table;
    private final PieceRead read;

    /** A copy of the caller's array. */
    private float[] copied = new float[0];

    /** Those of a segment of many. */
    private final int[] words = new int[Call.MOST_WORDS];

    /** The chain of which a log has the parts; null if none has begun. */
    private ChainPath chain;

    public Pieces(WorldParts world) {
        this.world = world;
        table = world.terrain.pieces;
        read = new PieceRead(world.terrain);
        world.calls.defineAll(this, Call.SEGMENT, Call.CLEAR_TERRAIN);
    }

    /** Adds a segment to a body, in the frame of the body, and returns its handle. */
    public long addSegment(long body, int kind, float x1, float y1, float x2, float y2, float thickness) {
        return world.calls.change(
                Call.SEGMENT,
                body,
                kind,
                floatToRawIntBits(x1),
                floatToRawIntBits(y1),
                floatToRawIntBits(x2),
                floatToRawIntBits(y2),
                floatToRawIntBits(thickness),
                0);
    }

    /** Adds segments without thickness, four elements each; the handles are optional. */
    public int addSegments(long body, float[] ends, int kind, long[] handles) {
        world.guard.enter();
        try (world.guard) {
            int of = world.body(body);
            KindTable.check(kind);
            int n = copy(ends);
            BulkChanges.checkHandles(handles, n, "pieces");
            for (int k = 0; k < n; k++) {
                checkSegment(of, kind, k);
            }
            makeRoom(n);
            world.copies.forgetSaved();
            for (int k = 0; k < n; k++) {
                world.log.write(Call.SEGMENT, segment(of, kind, k));
            }
            world.guard.changing = true;
            wakeCircles();
            for (int k = 0; k < n; k++) {
                long handle = add(Call.SEGMENT, segment(of, kind, k));
                if (handles != null) {
                    handles[k] = handle;
                }
            }
            world.guard.changing = false;
            return n;
        }
    }

    /** The words of segment k of many. */
    private int[] segment(int body, int kind, int k) {
        words[0] = body;
        words[1] = kind;
        for (int i = 0; i < SEGMENT_STRIDE; i++) {
            words[2 + i] = floatToRawIntBits(copied[SEGMENT_STRIDE * k + i]);
        }
        words[2 + SEGMENT_STRIDE] = 0;
        return words;
    }

    /** Another thread may write to the caller's array. */
    private int copy(float[] ends) {
        int length = Limits.notNull("ends", ends).length;
        if (length % SEGMENT_STRIDE != 0) {
            throw new IllegalArgumentException("ends has " + length + " elements, but must have four a segment");
        }
        if (copied.length < length) {
            copied = new float[length];
        }
        System.arraycopy(ends, 0, copied, 0, length);
        return length / SEGMENT_STRIDE;
    }

    private void checkSegment(int body, int kind, int k) {
        try {
            Call.SEGMENT.check(segment(body, kind, k), world.settings);
        } catch (IllegalArgumentException e) {
            throw new IllegalArgumentException("segment " + k + ": " + e.getMessage(), e);
        }
    }

    /** Adds an arc, anticlockwise between two angles in radians, and returns its handle. inside: circles are inside it. */
    public long addArc(long body, int kind, float x, float y, float radius, float from, float to, boolean inside) {
        return world.calls.change(
                Call.ARC,
                body,
                kind,
                floatToRawIntBits(x),
                floatToRawIntBits(y),
                floatToRawIntBits(radius),
                floatToRawIntBits(from),
                floatToRawIntBits(to),
                inside ? 1 : 0);
    }

    /** Adds the pieces of a chain, and returns how many; the handles are optional. */
    public int addChain(long body, ChainPath chain, int kind, long[] handles) {
        world.guard.enter();
        try (world.guard) {
            int of = world.body(body);
            KindTable.check(kind);
            boolean closed = chain.isClosed();
            int n = chain.pieces();
            BulkChanges.checkHandles(handles, n, "pieces");
            checkChain(chain, n);
            makeRoom(n);
            world.copies.forgetSaved();
            logChain(of, kind, chain, n, closed);
            world.guard.changing = true;
            wakeCircles();
            world.terrain.addChain(of, kind, chain, n, closed, handles);
            world.guard.changing = false;
            return n;
        }
    }

    private void checkChain(ChainPath of, int n) {
        if (n == 0) {
            throw new IllegalArgumentException("the chain has 1 point, but must have at least 2");
        }
        of.check(n, world.settings.bounds());
    }

    /** The first pieces of a chain, so many, are to be added. */
    private void logChain(int body, int kind, ChainPath of, int n, boolean closed) {
        world.log.write(Call.CHAIN_START, floatToRawIntBits(of.x(0)), floatToRawIntBits(of.y(0)), 0, 0);
        for (int k = 0; k < n; k++) {
            long turn = of.turn(k);
            if (turn == 0) {
                world.log.write(Call.CHAIN_LINE, floatToRawIntBits(of.x(k + 1)), floatToRawIntBits(of.y(k + 1)), 0, 0);
            } else {
                int x = floatToRawIntBits(of.centreX(k));
                world.log.write(
                        Call.CHAIN_ARC, x, floatToRawIntBits(of.centreY(k)), (int) turn, (int) (turn >> Integer.SIZE));
            }
        }
        world.log.write(Call.CHAIN, body, kind, closed ? 1 : 0, 0);
    }

    /** Circles may lie on what goes, or where something comes. */
    private void wakeCircles() {
        if (world.settings.sleeps()) {
            world.commands.wakeAll();
        }
    }

    private void makeRoom(int more) {
        if (more > TerrainLimits.PIECES - table.ids.size()) {
            throw new IllegalArgumentException("a world has at most " + TerrainLimits.PIECES
                    + " pieces of terrain, not " + (table.ids.size() + more));
        }
        table.ensure(more);
    }

    @Override
    public long make(Call call, int[] w) {
        switch (call) {
            case SEGMENT, ARC -> {
                makeRoom(1);
                world.calls.begin(call, w);
                return add(call, w);
            }
            case CHAIN_START, CHAIN_LINE, CHAIN_ARC -> {
                goOn(call, w);
                world.calls.begin(call, w);
            }
            case CHAIN -> {
                ChainPath whole = begunChain();
                chain = null; // also if it is refused
                if (w[2] == 1) {
                    close(whole);
                }
                checkChain(whole, whole.pieces());
                makeRoom(whole.pieces());
                world.calls.begin(call, w);
                world.terrain.addChain(w[0], w[1], whole, whole.pieces(), w[2] == 1, null);
            }
            case CLEAR_TERRAIN -> {
                world.pending.settleJoints();
                world.joints.departures.ensure(world.joints.table.places.count());
                world.calls.begin(call, w);
                world.joints.departures.removeOfBody(JointDepartures.ALL);
                world.terrain.clear();
            }
            case REMOVE_PIECE -> {
                world.calls.begin(call, w);
                world.terrain.remove(w[0]);
            }
            default -> {
                world.calls.begin(call, w, table.kindOf(w[0]) != w[1]);
                table.setKind(w[0], w[1]);
            }
        }
        return 0;
    }

    /** Adds a segment or an arc, for which there is room, and returns its handle. */
    private long add(Call call, int[] w) {
        if (call == Call.SEGMENT) {
            return table.ids.handle(world.terrain.addSegment(
                    w[0], w[1], real(w[2]), real(w[3]), real(w[4]), real(w[5]), real(w[6]) + 0f));
        }
        long opening = TerrainLimits.opening(real(w[5]), real(w[6]));
        return table.ids.handle(
                world.terrain.addArc(w[0], w[1], real(w[2]), real(w[3]), real(w[4]), real(w[5]), opening, w[7] == 1));
    }

    /** A log has a part of a chain, which changes nothing yet. */
    private void goOn(Call call, int[] w) {
        if (call == Call.CHAIN_START) {
            chain = new ChainPath(real(w[0]), real(w[1]));
        } else if (call == Call.CHAIN_LINE) {
            begunChain().lineTo(real(w[0]), real(w[1]));
        } else {
            begunChain().arcBy(real(w[0]), real(w[1]), Call.value(w[2], w[3]));
        }
    }

    /** A chain whose parts a log has had is not to go on. */
    public void forgetParts() {
        chain = null;
    }

    private ChainPath begunChain() {
        if (chain == null) {
            throw new IllegalArgumentException("a chain goes on that has not begun");
        }
        return chain;
    }

    /** A log has the line that closes a chain, if there is one. */
    private static void close(ChainPath whole) {
        int before = whole.pieces();
        try {
            whole.close();
        } catch (IllegalStateException e) {
            throw new IllegalArgumentException("a chain cannot be closed", e);
        }
        if (whole.pieces() != before) {
            throw new IllegalArgumentException("a chain is closed that has a gap");
        }
    }

    public int kindOf(long handle) {
        world.guard.check();
        return table.kindOf(world.piece(handle));
    }

    /** The handle of the body of a piece. */
    public long bodyOf(long handle) {
        world.guard.check();
        return world.terrain.bodies.ids.handle(table.bodyOf(world.piece(handle)));
    }

    /** What pieces look like, in the order of ids, and their handles, which are optional; returns how many there are. */
    public int read(float[] to, long[] handles) {
        world.guard.enter();
        try (world.guard) {
            int n = checkRead(to, handles);
            read.read(to, handles);
            return n;
        }
    }

    /** The same with bodies on the way from before a step to after it, whose poses are kept in the third ones. */
    public int readBetween(
            BodyPoses before, BodyPoses after, float alpha, BodyPoses between, float[] to, long[] handles) {
        world.guard.enter();
        try (world.guard) {
            int n = checkRead(to, handles);
            between.keepBetween(before, after, alpha, world.terrain.bodies, world.terrain.bounds());
            read.read(between, to, handles);
            return n;
        }
    }

    private int checkRead(float[] to, long[] handles) {
        int n = table.ids.size();
        if (Limits.notNull("pieces", to).length < PieceRead.STRIDE * n) {
            throw new IllegalArgumentException("pieces has " + to.length + " elements, but there are " + n
                    + " pieces of " + PieceRead.STRIDE + " elements");
        }
        BulkChanges.checkHandles(handles, n, "pieces");
        return n;
    }
}
