package io.github.circles2d;

import io.github.circles2d.world.Simulation;
import io.github.circles2d.world.circles.Handle;
import io.github.circles2d.world.model.PieceRow;
import io.github.circles2d.world.shared.Call;
import io.github.circles2d.world.terrain.PieceRead;

/**
 * The ground of a {@link World}: pieces that circles lie on, roll along and bounce off, and that never yield. {@link World#terrain} gives
 * this object.
 *
 * <pre>{@code
 * Terrain terrain = world.terrain();
 * terrain.addChain(Chain.of(100, 0, 60, 0, 50, 10, 0, 10)); // from right to left: circles are above
 * terrain.addSegment(20, 30, 30, 28);
 * TerrainBody lift = terrain.addBody(80, 0, 0);
 * lift.addSegment(-3, 0, 3, 0);
 * lift.setVelocity(0, 2);
 * }</pre>
 *
 * <p><b>Pieces:</b> a <em>segment</em> has two ends, two sides, and a thickness if it is to be a capsule. A {@link Chain} makes lines and arcs that
 * circles touch from one side and that are smooth where they meet. An <em>arc</em> is exact: a ball keeps its speed in a loop. Circles
 * touch it from the side that {@link ArcSide} says.
 *
 * <p><img src="doc-files/terrain-sides.svg" alt="Circles touch a chain from its right, a segment from both sides, an arc from the side that it says, a one-way piece from the front">
 *
 * <p><b>Kinds:</b> each piece is of a {@link Kind}. Its friction, rolling resistance, belt, restitution, categories and matrix mean for a piece
 * what they mean for circles; groups do not count. A segment's belt runs around it, and a chain's against the direction in which it is
 * drawn ({@link Kind#setBeltSpeed}). {@link Kind#setOneWay} lets circles pass from behind.
 *
 * <p><b>Bodies:</b> pieces belong to the ground, which never moves, or to a {@link TerrainBody}, which does.
 *
 * <p><b>Handles</b> of pieces and of bodies are longs, never 0, stale once the piece or body has gone. No handle of a circle or joint is equal
 * to one of them, so a call refuses one for the other.
 *
 * <p><b>Edges:</b> walls hold circles, not terrain: pieces may go beyond them. Along an axis that wraps, pieces wrap, too; a piece is at
 * most half as long as the axis.
 *
 * <p><b>Limits:</b> a world has at most 2^20 pieces and 2^20 bodies. Coordinates and lengths are up to 1e9. Two pieces that meet at 5 degrees
 * or less do not hold a fast circle that is wedged between them: put a piece across. A world without pieces pays nothing for this. A change acts from the next step on. Terrain is in snapshots, in logs and in the hash. {@link World#clear} leaves it as it
 * is. The rules of {@link World} for threads, failures and closed worlds hold here, too.
 */
public final class Terrain {
    /**
     * Elements of a piece, as {@link #readPieces} and {@link FixedStep#pieces} give it: from {@link #FORM} to {@link #INSIDE}. Each has its
     * place. Those of arcs are 0 in segments and lines, those of segments and lines 0 in arcs.
     */
    public static final int PIECE_STRIDE = PieceRead.STRIDE;

    /** In a piece: its form, which is {@link #SEGMENT}, {@link #LINE} or {@link #ARC}. */
    public static final int FORM = PieceRead.SHAPE;

    /** In a piece: the number of its kind, 0 to 255. */
    public static final int KIND = PieceRead.KIND;

    /** In a segment or a line: x of its start. */
    public static final int X1 = PieceRead.X1;

    /** In a segment or a line: y of its start. */
    public static final int Y1 = PieceRead.Y1;

    /** In a segment or a line: x of its end. */
    public static final int X2 = PieceRead.X2;

    /** In a segment or a line: y of its end. */
    public static final int Y2 = PieceRead.Y2;

    /** In a segment: the radius around it; in a line or an arc: 0. */
    public static final int THICKNESS = PieceRead.THICKNESS;

    /** In an arc: x of the centre. */
    public static final int CENTRE_X = PieceRead.CENTRE_X;

    /** In an arc: y of the centre. */
    public static final int CENTRE_Y = PieceRead.CENTRE_Y;

    /** In an arc: its radius. */
    public static final int RADIUS = PieceRead.RADIUS;

    /** In an arc: the angle where it begins, in radians. */
    public static final int FROM = PieceRead.FROM;

    /** In an arc: the angle where it ends, anticlockwise from {@link #FROM}, in radians, and greater by 2 pi at most. */
    public static final int TO = PieceRead.TO;

    /** In an arc: 1 if circles are inside it, else 0; in a segment or a line: 0. */
    public static final int INSIDE = PieceRead.INSIDE;

    /** Form: a segment, with two sides. */
    public static final int SEGMENT = PieceRow.SEGMENT;

    /** Form: a line of a chain. Circles are at its right, from its start to its end. */
    public static final int LINE = PieceRow.LINE;

    /** Form: an arc, alone or of a chain. */
    public static final int ARC = PieceRow.ARC;

    private final Simulation simulation;

    /** The objects that callers have, by id of the body. */
    private TerrainBody[] bodies = new TerrainBody[1];

    Terrain(Simulation simulation) {
        this.simulation = simulation;
        bodies[0] = new TerrainBody(simulation)
                .of(simulation.bodies.ground()); // memory may end in the first call of a body
    }

    // ---- bodies

    /** {@return the body that never moves, and cannot be removed: always the same object} Its coordinates are the world's. */
    public TerrainBody ground() {
        return object(simulation.bodies.ground());
    }

    /**
     * Adds a body at rest, without pieces.
     *
     * @param x x of its pivot, up to 1e9 in magnitude
     * @param y y of its pivot, likewise
     * @param angle its angle in radians, up to 1e6 in magnitude
     * @return the body
     * @throws IllegalArgumentException if a value is out of range, or there are 2^20 bodies
     */
    public TerrainBody addBody(float x, float y, float angle) {
        makeRoom(simulation.bodyIds.limit());
        TerrainBody body = new TerrainBody(simulation);
        long handle = simulation.bodies.add(x, y, angle);
        bodies[Handle.id(handle)] = body.of(handle);
        return body;
    }

    /**
     * The body that has a handle.
     *
     * @param handle the handle of a body
     * @return always the same object for a handle
     * @throws IllegalArgumentException if the body has been removed, or the handle is none
     */
    public TerrainBody body(long handle) {
        simulation.bodies.require(handle);
        return object(handle);
    }

    /**
     * The body that a piece belongs to.
     *
     * @param piece the handle of a piece
     * @return the ground, or another body
     * @throws IllegalArgumentException if the piece has been removed, or the handle is none
     */
    public TerrainBody bodyOf(long piece) {
        return object(simulation.pieces.bodyOf(piece));
    }

    private void makeRoom(int id) {
        if (id >= bodies.length) {
            TerrainBody[] more = new TerrainBody[Math.max(id + 1, 2 * bodies.length)];
            System.arraycopy(bodies, 0, more, 0, bodies.length);
            bodies = more;
        }
    }

    private TerrainBody object(long handle) {
        int id = Handle.id(handle);
        makeRoom(id);
        if (bodies[id] == null || bodies[id].handle() != handle) {
            bodies[id] = new TerrainBody(simulation).of(handle);
        }
        return bodies[id];
    }

    // ---- pieces

    /**
     * Adds a segment of kind 0 to the ground, without thickness. It has two sides.
     *
     * @param x1 x of an end, up to 1e9 in magnitude
     * @param y1 y of it
     * @param x2 x of the other end
     * @param y2 y of it
     * @return the handle of the piece
     * @throws IllegalArgumentException if a value is out of range, the segment is not longer than 2^-20 of its coordinates, or it is longer
     *     than half an axis that wraps
     */
    public long addSegment(float x1, float y1, float x2, float y2) {
        return addSegment(x1, y1, x2, y2, 0, 0);
    }

    /**
     * Adds a segment to the ground. It has two sides.
     *
     * @param x1 x of an end, up to 1e9 in magnitude
     * @param y1 y of it
     * @param x2 x of the other end
     * @param y2 y of it
     * @param thickness radius around the segment, which makes it a capsule; at least 0
     * @param kind the number of its kind, 0 to 255
     * @return the handle of the piece
     * @throws IllegalArgumentException as {@link #addSegment(float, float, float, float)}, or if there is no such kind
     */
    public long addSegment(float x1, float y1, float x2, float y2, float thickness, int kind) {
        return simulation.pieces.addSegment(simulation.bodies.ground(), kind, x1, y1, x2, y2, thickness);
    }

    /**
     * Adds an arc of kind 0 to the ground.
     *
     * @param x x of the centre, up to 1e9 in magnitude
     * @param y y of the centre
     * @param radius more than 2^-20 of the coordinates of the centre
     * @param from where the arc begins, an angle in radians
     * @param to where it ends, anticlockwise from there; more than {@code from}, by 2 pi for a circle
     * @param side the side that circles touch
     * @return the handle of the piece
     * @throws IllegalArgumentException if a value is out of range, or the arc is wider than half an axis that wraps
     */
    public long addArc(float x, float y, float radius, float from, float to, ArcSide side) {
        return ground().addArc(x, y, radius, from, to, side, 0);
    }

    /**
     * Adds an arc to the ground.
     *
     * @param x x of the centre, up to 1e9 in magnitude
     * @param y y of the centre
     * @param radius more than 2^-20 of the coordinates of the centre
     * @param from where the arc begins, an angle in radians
     * @param to where it ends, anticlockwise from there; more than {@code from}, by 2 pi for a circle
     * @param side the side that circles touch
     * @param kind the number of its kind, 0 to 255
     * @return the handle of the piece
     * @throws IllegalArgumentException as {@link #addArc(float, float, float, float, float, ArcSide)}, or if there is no such kind
     */
    public long addArc(float x, float y, float radius, float from, float to, ArcSide side, int kind) {
        return ground().addArc(x, y, radius, from, to, side, kind);
    }

    /**
     * Adds the pieces of a chain to the ground, of kind 0.
     *
     * @param chain the chain; it may be changed and used again
     * @return the number of pieces
     * @throws IllegalArgumentException if the chain has none, or a piece is longer than half an axis that wraps
     */
    public int addChain(Chain chain) {
        return ground().addChain(chain, 0, null);
    }

    /**
     * Adds the pieces of a chain to the ground.
     *
     * @param chain the chain; it may be changed and used again
     * @param kind the number of their kind, 0 to 255
     * @param handles takes the handles of the pieces in their order; may be null
     * @return the number of pieces
     * @throws IllegalArgumentException as {@link #addChain(Chain)}, or if there is no such kind, or the array is too short
     */
    public int addChain(Chain chain, int kind, long[] handles) {
        return ground().addChain(chain, kind, handles);
    }

    /**
     * Adds many segments without thickness to the ground, all or none.
     *
     * @param ends x1, y1, x2 and y2 of one after the other, as {@link #addSegment(float, float, float, float)} takes them
     * @param kind the number of their kind, 0 to 255
     * @param handles takes the handles of the pieces; may be null
     * @return the number of segments
     * @throws IllegalArgumentException if a segment is refused, with its index; if there is no such kind; or if an array has a wrong length
     */
    public int addSegments(float[] ends, int kind, long[] handles) {
        return ground().addSegments(ends, kind, handles);
    }

    /**
     * Removes a piece. The ends of its neighbours in a chain are free then. What lies on it falls.
     *
     * @param piece the handle of a piece
     * @throws IllegalArgumentException if the piece has been removed, or the handle is none
     */
    public void remove(long piece) {
        simulation.calls.change(Call.REMOVE_PIECE, piece);
    }

    /** Removes all pieces, and all bodies but the ground. */
    public void clear() {
        simulation.calls.make(Call.CLEAR_TERRAIN);
    }

    /**
     * Whether a handle is that of a piece of this world.
     *
     * @param piece any number
     * @return false if it is stale or never was a handle
     */
    public boolean contains(long piece) {
        return simulation.pieceIds.contains(piece);
    }

    /**
     * The id of a handle: its lower 28 bits. Two pieces that are there at the same time have different ids. When a piece has been removed,
     * a new one takes its id over.
     *
     * @param piece the handle of a piece, stale or not
     * @return its id, at least 0
     */
    public static int id(long piece) {
        return Handle.id(piece);
    }

    /** {@return how long the caller's arrays by id of pieces must be: one more than the greatest id that a piece has had; at least {@link #size}} */
    public int idLimit() {
        return simulation.pieceIds.limit();
    }

    /**
     * The handle of the piece that has an id now.
     *
     * @param id an id, at least 0 and less than {@link #idLimit}
     * @return the handle; 0 if no piece has the id
     * @throws IllegalArgumentException if the id is out of range
     */
    public long handle(int id) {
        return simulation.pieceIds.handle(id);
    }

    /** {@return the number of pieces, at least 0} */
    public int size() {
        return simulation.pieceIds.size();
    }

    /**
     * Gives a piece another kind.
     *
     * @param piece the handle of a piece
     * @param kind the number of the kind, 0 to 255
     * @throws IllegalArgumentException if the piece has been removed, or there is no such kind
     */
    public void setKind(long piece, int kind) {
        simulation.calls.change(Call.PIECE_KIND, piece, kind, 0, 0);
    }

    /**
     * The kind of a piece.
     *
     * @param piece the handle of a piece
     * @return the number of its kind
     * @throws IllegalArgumentException if the piece has been removed, or the handle is none
     */
    public int kindOf(long piece) {
        return simulation.pieces.kindOf(piece);
    }

    /**
     * What all pieces look like now, in the order of their ids, for drawing. A piece has {@link #PIECE_STRIDE} elements: its {@link #FORM} and
     * its {@link #KIND}, and then of a segment or a line its ends, {@link #X1}, {@link #Y1}, {@link #X2} and {@link #Y2}, and its {@link
     * #THICKNESS}; of an arc {@link #CENTRE_X}, {@link #CENTRE_Y}, {@link #RADIUS}, {@link #FROM}, {@link #TO} and {@link #INSIDE}.
     *
     * <pre>{@code
     * float[] pieces = new float[terrain.size() * Terrain.PIECE_STRIDE];
     * int count = terrain.readPieces(pieces, null);
     * for (int row = 0; row < count * Terrain.PIECE_STRIDE; row += Terrain.PIECE_STRIDE) {
     *     if (pieces[row + Terrain.FORM] != Terrain.ARC) { // a segment, or a line of a chain
     *         draw(pieces[row + Terrain.X1], pieces[row + Terrain.Y1], pieces[row + Terrain.X2], pieces[row + Terrain.Y2]);
     *     }
     * }
     * }</pre>
     *
     * @param pieces takes {@link #PIECE_STRIDE} elements a piece
     * @param handles takes their handles; may be null
     * @return the number of pieces
     * @throws IllegalArgumentException if an array is too short
     */
    public int readPieces(float[] pieces, long[] handles) {
        return simulation.pieces.read(pieces, handles);
    }
}
