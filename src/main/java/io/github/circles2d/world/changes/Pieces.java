package io.github.circles2d.world.changes;

import io.github.circles2d.world.circles.Handle;
import io.github.circles2d.world.circles.KindTable;
import io.github.circles2d.world.joints.JointTables;
import io.github.circles2d.world.model.Limits;
import io.github.circles2d.world.model.TerrainLimits;
import io.github.circles2d.world.shared.CallLog;
import io.github.circles2d.world.shared.Copies;
import io.github.circles2d.world.shared.Guard;
import io.github.circles2d.world.shared.LoggedCall;
import io.github.circles2d.world.shared.PendingWork;
import io.github.circles2d.world.shared.WorldSettings;
import io.github.circles2d.world.terrain.BodyPoses;
import io.github.circles2d.world.terrain.ChainPath;
import io.github.circles2d.world.terrain.PieceRead;
import io.github.circles2d.world.terrain.PieceTable;
import io.github.circles2d.world.terrain.TerrainTables;

/** The calls on pieces of terrain. A change acts from the next step on. */
public final class Pieces {
    private static final int SEGMENT_STRIDE = 4;

    private final Guard guard;
    private final TerrainTables terrain;
    private final PieceTable table;
    private final JointTables joints;
    private final CallLog log;
    private final PendingWork pending;
    private final Copies copies;
    private final WorldSettings settings;
    private final PieceRead read;

    /** A copy of the caller's array. */
    private float[] copied = new float[0];

    public Pieces(
            Guard guard,
            TerrainTables terrain,
            JointTables joints,
            CallLog log,
            PendingWork pending,
            Copies copies,
            WorldSettings settings) {
        this.guard = guard;
        this.terrain = terrain;
        this.joints = joints;
        this.log = log;
        this.pending = pending;
        this.copies = copies;
        this.settings = settings;
        table = terrain.pieces;
        read = new PieceRead(terrain);
    }

    /** Adds a segment to a body, in the frame of the body, and returns its handle. */
    public long addSegment(long body, int kind, float x1, float y1, float x2, float y2, float thickness) {
        guard.enter();
        try {
            int of = Bodies.find(terrain, body);
            KindTable.check(kind);
            TerrainLimits.segment(x1, y1, x2, y2, thickness, settings.bounds());
            begin(1);
            log.segment(of, kind, x1, y1, x2, y2, thickness);
            guard.changing = true;
            long handle = table.ids.handle(terrain.addSegment(of, kind, x1, y1, x2, y2, thickness + 0f));
            guard.changing = false;
            return handle;
        } catch (RuntimeException | Error e) {
            throw guard.failed(e);
        } finally {
            guard.user = null;
        }
    }

    /** Adds segments without thickness, four elements each; the handles are optional. */
    public int addSegments(long body, float[] ends, int kind, long[] handles) {
        guard.enter();
        try {
            int of = Bodies.find(terrain, body);
            KindTable.check(kind);
            int n = copy(ends);
            checkHandles(handles, n);
            for (int k = 0; k < n; k++) {
                checkSegment(k);
            }
            begin(n);
            for (int k = 0; k < n; k++) {
                int at = SEGMENT_STRIDE * k;
                log.segment(of, kind, copied[at], copied[at + 1], copied[at + 2], copied[at + 3], 0f);
            }
            guard.changing = true;
            for (int k = 0; k < n; k++) {
                int at = SEGMENT_STRIDE * k;
                int piece =
                        terrain.addSegment(of, kind, copied[at], copied[at + 1], copied[at + 2], copied[at + 3], 0f);
                if (handles != null) {
                    handles[k] = table.ids.handle(piece);
                }
            }
            guard.changing = false;
            return n;
        } catch (RuntimeException | Error e) {
            throw guard.failed(e);
        } finally {
            guard.user = null;
        }
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

    private void checkSegment(int k) {
        int at = SEGMENT_STRIDE * k;
        try {
            TerrainLimits.segment(copied[at], copied[at + 1], copied[at + 2], copied[at + 3], 0f, settings.bounds());
        } catch (IllegalArgumentException e) {
            throw new IllegalArgumentException("segment " + k + ": " + e.getMessage(), e);
        }
    }

    private static void checkHandles(long[] handles, int n) {
        if (handles != null && handles.length < n) {
            throw new IllegalArgumentException(
                    "handles has " + handles.length + " elements, but there are " + n + " pieces");
        }
    }

    /** Adds an arc, counterclockwise between two angles in radians, and returns its handle. inside: circles are inside it. */
    public long addArc(long body, int kind, float x, float y, float radius, float from, float to, boolean inside) {
        guard.enter();
        try {
            int of = Bodies.find(terrain, body);
            KindTable.check(kind);
            Limits.within("from", from, -Limits.ANGLE, Limits.ANGLE);
            Limits.within("to", to, -Limits.ANGLE, Limits.ANGLE);
            long opening = TerrainLimits.opening(from, to);
            TerrainLimits.arc(x, y, radius, (int) (opening >>> 1), settings.bounds());
            begin(1);
            log.arc(of, kind, x, y, radius, from, to, inside);
            guard.changing = true;
            long handle = table.ids.handle(terrain.addArc(of, kind, x, y, radius, from, opening, inside));
            guard.changing = false;
            return handle;
        } catch (RuntimeException | Error e) {
            throw guard.failed(e);
        } finally {
            guard.user = null;
        }
    }

    /** Adds the pieces of a chain, and returns how many; the handles are optional. */
    public int addChain(long body, ChainPath chain, int kind, long[] handles) {
        guard.enter();
        try {
            int of = Bodies.find(terrain, body);
            KindTable.check(kind);
            boolean closed = chain.isClosed();
            int n = chain.pieces();
            if (n == 0) {
                throw new IllegalArgumentException("the chain has 1 point, but must have at least 2");
            }
            checkHandles(handles, n);
            chain.check(n, settings.bounds());
            begin(n);
            log.chain(of, kind, chain, n, closed);
            guard.changing = true;
            terrain.addChain(of, kind, chain, n, closed, handles);
            guard.changing = false;
            return n;
        } catch (RuntimeException | Error e) {
            throw guard.failed(e);
        } finally {
            guard.user = null;
        }
    }

    /** Makes room for pieces, whose values have been checked. */
    private void begin(int more) {
        if (more > TerrainLimits.PIECES - table.ids.size()) {
            throw new IllegalArgumentException("a world has at most " + TerrainLimits.PIECES
                    + " pieces of terrain, not " + (table.ids.size() + more));
        }
        table.ensure(more);
        copies.forgetSaved();
    }

    /** Removes a piece. */
    public void remove(long handle) {
        guard.enter();
        try {
            int piece = find(handle);
            copies.forgetSaved();
            log.call(LoggedCall.REMOVE_PIECE, piece, 0);
            guard.changing = true;
            terrain.remove(piece);
            guard.changing = false;
        } catch (RuntimeException | Error thrown) {
            throw guard.failed(thrown);
        } finally {
            guard.user = null;
        }
    }

    /** Removes all pieces and bodies. */
    public void clear() {
        guard.enter();
        try {
            pending.settleJoints();
            joints.departures().ensure(joints.table.places.count());
            copies.forgetSaved();
            log.call(LoggedCall.CLEAR_TERRAIN, 0, 0);
            guard.changing = true;
            joints.departures().removeOfBodies();
            terrain.clear();
            guard.changing = false;
        } catch (RuntimeException | Error thrown) {
            throw guard.failed(thrown);
        } finally {
            guard.user = null;
        }
    }

    public void setKind(long handle, int kind) {
        guard.enter();
        try {
            int piece = find(handle);
            KindTable.check(kind);
            copies.forgetSaved();
            log.call(LoggedCall.PIECE_KIND, piece, kind);
            guard.changing = true;
            terrain.setKind(piece, kind);
            guard.changing = false;
        } catch (RuntimeException | Error thrown) {
            throw guard.failed(thrown);
        } finally {
            guard.user = null;
        }
    }

    private int find(long handle) {
        int piece = table.ids.find(handle);
        if (piece < 0) {
            throw new IllegalArgumentException(
                    "no piece of terrain has the handle " + handle + Handle.reason(handle, Handle.PIECE));
        }
        return piece;
    }

    public boolean contains(long handle) {
        guard.check();
        return table.ids.find(handle) >= 0;
    }

    /** One more than the greatest id that a piece has had. */
    public int idLimit() {
        guard.check();
        return table.ids.end();
    }

    /** The handle of the piece that has an id; 0 if there is none. */
    public long handle(int id) {
        guard.check();
        return table.ids.handleOrNone(id);
    }

    /** The number of pieces. */
    public int size() {
        guard.check();
        return table.ids.size();
    }

    public int kindOf(long handle) {
        guard.check();
        return table.kindOf(find(handle));
    }

    /** The handle of the body of a piece. */
    public long bodyOf(long handle) {
        guard.check();
        return terrain.bodies.ids.handle(table.bodyOf(find(handle)));
    }

    /** What pieces look like, in the order of ids, and their handles, which are optional; returns how many there are. */
    public int read(float[] to, long[] handles) {
        guard.enter();
        try {
            int n = checkRead(to, handles);
            read.read(to, handles);
            return n;
        } catch (RuntimeException | Error e) {
            throw guard.failed(e);
        } finally {
            guard.user = null;
        }
    }

    /** The same with bodies on the way from before a step to after it, whose poses are kept in the third ones. */
    public int readBetween(
            BodyPoses before, BodyPoses after, float alpha, BodyPoses between, float[] to, long[] handles) {
        guard.enter();
        try {
            int n = checkRead(to, handles);
            between.keepBetween(before, after, alpha, terrain.bodies, terrain.bounds());
            read.read(between, to, handles);
            return n;
        } catch (RuntimeException | Error e) {
            throw guard.failed(e);
        } finally {
            guard.user = null;
        }
    }

    private int checkRead(float[] to, long[] handles) {
        int n = table.ids.size();
        if (Limits.notNull("pieces", to).length < PieceRead.STRIDE * n) {
            throw new IllegalArgumentException("pieces has " + to.length + " elements, but there are " + n
                    + " pieces of " + PieceRead.STRIDE + " elements");
        }
        checkHandles(handles, n);
        return n;
    }
}
