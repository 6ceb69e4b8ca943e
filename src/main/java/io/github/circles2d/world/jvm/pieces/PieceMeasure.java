package io.github.circles2d.world.jvm.pieces;

import static io.github.circles2d.world.jvm.state.PieceContactRow.BASE_X;
import static io.github.circles2d.world.jvm.state.PieceContactRow.BASE_Y;
import static io.github.circles2d.world.jvm.state.PieceContactRow.BOUNCE;
import static io.github.circles2d.world.jvm.state.PieceContactRow.CURVE;
import static io.github.circles2d.world.jvm.state.PieceContactRow.FEATURE;
import static io.github.circles2d.world.jvm.state.PieceContactRow.GAP;
import static io.github.circles2d.world.jvm.state.PieceContactRow.IMPULSE;
import static io.github.circles2d.world.jvm.state.PieceContactRow.MOTION;
import static io.github.circles2d.world.jvm.state.PieceContactRow.NX;
import static io.github.circles2d.world.jvm.state.PieceContactRow.NY;
import static io.github.circles2d.world.jvm.state.PieceContactRow.OX;
import static io.github.circles2d.world.jvm.state.PieceContactRow.OY;
import static io.github.circles2d.world.jvm.state.PieceContactRow.PIECE;
import static io.github.circles2d.world.jvm.state.PieceContactRow.RESPONSE;
import static io.github.circles2d.world.jvm.state.PieceContactRow.ROWS;
import static io.github.circles2d.world.jvm.state.PieceContactRow.SHAPE;
import static io.github.circles2d.world.jvm.state.PieceContactRow.SIDE;
import static io.github.circles2d.world.model.CircleRow.DX;
import static io.github.circles2d.world.model.CircleRow.DY;
import static io.github.circles2d.world.model.CircleRow.RADIUS;
import static io.github.circles2d.world.model.CircleRow.X;
import static io.github.circles2d.world.model.CircleRow.Y;

import io.github.circles2d.world.jvm.state.PieceContactRow;
import io.github.circles2d.world.jvm.state.PieceContacts;
import io.github.circles2d.world.jvm.state.State;
import io.github.circles2d.world.model.BodyRow;
import io.github.circles2d.world.model.CircleMath;
import io.github.circles2d.world.model.CircleRow;
import io.github.circles2d.world.model.ContactRows;
import io.github.circles2d.world.model.KindTerrain;
import io.github.circles2d.world.model.PairTable;
import io.github.circles2d.world.model.PieceGap;
import io.github.circles2d.world.model.PieceRow;
import io.github.circles2d.world.model.StepConstants;
import io.github.circles2d.world.model.TerrainStep;

/**
 * Where circles are against the pieces of terrain near them, at the boundaries of sub-steps: distances, normals, and how surfaces move. {@link PieceGap}
 * has the formulas. Each worker has its own.
 */
public final class PieceMeasure {
    private final State state;
    private final PieceContacts contacts;
    private final PieceGap found = new PieceGap();

    /** Within a step. */
    TerrainStep terrain;

    int subSteps;

    /** Where a place is in the frame of a body at the start of the step. */
    float localX;

    float localY;

    /** Velocity of the surface of a piece. */
    float surfaceX;

    float surfaceY;

    PieceMeasure(State state) {
        this(state, state.pieces);
    }

    PieceMeasure(State state, PieceContacts contacts) {
        this.state = state;
        this.contacts = contacts;
    }

    void begin(TerrainStep next, StepConstants k) {
        terrain = next;
        subSteps = k.subSteps;
    }

    /** The base of a circle against (X, Y) of a piece. */
    static float offsetX(State state, int slot, float[] rows, int row) {
        return offsetX(state, state.circle[CircleRow.of(slot) + X], rows, row);
    }

    static float offsetY(State state, int slot, float[] rows, int row) {
        return offsetY(state, state.circle[CircleRow.of(slot) + Y], rows, row);
    }

    /** A coordinate of anything, likewise. */
    public static float offsetX(State state, float x, float[] rows, int row) {
        float at = rows[row + PieceRow.X];
        if (!state.wraps) {
            return x - at;
        }
        float mid = rows[row + PieceRow.MID_X];
        return CircleMath.shortWay(x - mid, state.periodX) + (mid - at);
    }

    public static float offsetY(State state, float y, float[] rows, int row) {
        float at = rows[row + PieceRow.Y];
        if (!state.wraps) {
            return y - at;
        }
        float mid = rows[row + PieceRow.MID_Y];
        return CircleMath.shortWay(y - mid, state.periodY) + (mid - at);
    }

    /** Brings a place, against (X, Y) of a piece, to the frame of the start of the step. */
    void toFrame(int row, int motion, float ox, float oy, float dx, float dy, int boundary) {
        if (motion == 0) {
            localX = ox + dx;
            localY = oy + dy;
            return;
        }
        float[] bodies = terrain.motion;
        int body = BodyRow.of(motion, subSteps);
        int pose = body + BodyRow.pose(boundary);
        float px = contacts.pieces[row + PieceRow.PIVOT_X];
        float py = contacts.pieces[row + PieceRow.PIVOT_Y];
        float x = (ox - px) + (dx - bodies[pose + BodyRow.DX]);
        float y = (oy - py) + (dy - bodies[pose + BodyRow.DY]);
        float cos = bodies[pose + BodyRow.COS];
        float sin = bodies[pose + BodyRow.SIN];
        localX = (cos * x + sin * y) + px;
        localY = (cos * y - sin * x) + py;
    }

    int motion(int c) {
        return contacts.numbers[PieceContactRow.numbers(c) + MOTION];
    }

    int shape(int c) {
        return contacts.numbers[PieceContactRow.numbers(c) + SHAPE];
    }

    /** Measures all contacts of a circle at a boundary of sub-steps, and forgets the impulses of those that are none there. */
    void measure(int slot, int boundary) {
        int s = CircleRow.of(slot);
        contacts.measured[CircleRow.vector(slot)] = state.motion[s + DX];
        contacts.measured[CircleRow.vector(slot) + 1] = state.motion[s + DY];
        int from = contacts.first[slot];
        measure(slot, from, from + contacts.count[slot], boundary);
    }

    /** The same of some contacts, which a circle may have. */
    void measure(int slot, int from, int to, int boundary) {
        int s = CircleRow.of(slot);
        float dx = state.motion[s + DX];
        float dy = state.motion[s + DY];
        float r = state.circle[s + RADIUS];
        boolean vertices = false;
        for (int c = from; c < to; c++) {
            vertices |= measure(slot, c, boundary, dx, dy, r);
        }
        if (vertices && to - from > 1) {
            for (int c = from; c < to; c++) {
                cover(c, from, to, boundary, r);
            }
        }
    }

    /** Whether a circle is where its contacts were measured last, to the bit; between sub-steps, pieces stay where they are. */
    boolean isMeasured(int slot) {
        int s = CircleRow.of(slot);
        int v = CircleRow.vector(slot);
        return Float.floatToRawIntBits(contacts.measured[v]) == Float.floatToRawIntBits(state.motion[s + DX])
                && Float.floatToRawIntBits(contacts.measured[v + 1]) == Float.floatToRawIntBits(state.motion[s + DY]);
    }

    /** The piece is no constraint of the circle now. */
    private void leave(int c) {
        int k = PieceContactRow.of(c);
        contacts.numbers[PieceContactRow.numbers(c) + FEATURE] = PieceGap.NONE;
        contacts.rows[k + IMPULSE] = 0f;
        ContactRows.clear(contacts.rows, k + ROWS, 1);
        contacts.rows[k + BOUNCE] = 0f;
    }

    /** Returns whether the circle is at a vertex. */
    private boolean measure(int slot, int c, int boundary, float dx, float dy, float r) {
        float[] rows = contacts.rows;
        int k = PieceContactRow.of(c);
        int number = PieceContactRow.numbers(c);
        int row = PieceRow.of(c);
        int shape = shape(c);
        int motion = motion(c);
        float side = rows[k + SIDE];
        toFrame(row, motion, rows[k + BASE_X], rows[k + BASE_Y], dx, dy, boundary);
        rows[k + OX] = localX;
        rows[k + OY] = localY;
        if (contacts.numbers[number + RESPONSE] == PairTable.SENSE && !isTwoSided(c, shape)) {
            if (boundary == 0) {
                rows[k + SIDE] = sensedSide(contacts.pieces, row, shape, localX, localY, r, side);
            }
            leave(c);
            return false;
        }
        if (side == 0f) {
            leave(c);
            return false;
        }
        found.measure(contacts.pieces, row, shape, localX, localY, r, side);
        if (found.isAround(contacts.numbers[number + FEATURE], side)) {
            side = isTwoSided(c, shape) ? -side : 0f;
            rows[k + SIDE] = side;
            if (side == 0f) {
                leave(c);
                return false;
            }
            found.measure(contacts.pieces, row, shape, localX, localY, r, side);
        }
        float nx = found.nx;
        float ny = found.ny;
        if (motion != 0) {
            int pose = BodyRow.of(motion, subSteps) + BodyRow.pose(boundary);
            float cos = terrain.motion[pose + BodyRow.COS];
            float sin = terrain.motion[pose + BodyRow.SIN];
            nx = cos * found.nx - sin * found.ny;
            ny = sin * found.nx + cos * found.ny;
        }
        rows[k + NX] = nx;
        rows[k + NY] = ny;
        rows[k + GAP] = found.gap;
        rows[k + CURVE] = found.curve;
        contacts.numbers[number + FEATURE] = found.feature;
        if (found.feature == PieceGap.FACE) {
            return false;
        }
        if (found.feature == PieceGap.NONE) {
            leave(c);
        }
        boolean vertex = found.feature > PieceGap.FACE;
        if (vertex && isTwoSided(c, shape) && found.height != 0f) {
            float now = found.height > 0f ? 1f : -1f;
            if (now != side) {
                rows[k + SIDE] = now;
                forgetMeasured(slot);
            }
        }
        return vertex;
    }

    /** The next measure may differ. Nobody asks of contacts of a circle that sleeps: they have no slot. */
    private void forgetMeasured(int slot) {
        if (contacts.measured.length > 0) {
            contacts.measured[CircleRow.vector(slot)] = Float.NaN;
        }
    }

    private boolean isTwoSided(int c, int shape) {
        return PieceRow.form(shape) == PieceRow.SEGMENT
                && isTwoSided(terrain, contacts.numbers[PieceContactRow.numbers(c) + PIECE], shape);
    }

    public static boolean isTwoSided(TerrainStep terrain, int piece, int shape) {
        int kind = terrain.traits[PieceRow.traits(piece) + PieceRow.KIND];
        return PieceRow.form(shape) == PieceRow.SEGMENT
                && terrain.kinds.rows[KindTerrain.of(kind) + KindTerrain.ONE_WAY] == 0f;
    }

    /** As the step begins: where a circle comes from, which a piece with a front only senses. Who touches it is on its way. */
    public static float sensedSide(float[] pieces, int row, int shape, float ox, float oy, float r, float side) {
        if (PieceGap.distance(pieces, row, shape, ox, oy) <= r) {
            return side;
        }
        return PieceGap.isInFront(pieces, row, shape, ox, oy) ? 1f : 0f;
    }

    /** A vertex under which another piece has its face is no constraint. */
    private void cover(int c, int from, int to, int boundary, float r) {
        int number = PieceContactRow.numbers(c);
        int feature = contacts.numbers[number + FEATURE];
        if (feature <= PieceGap.FACE || contacts.numbers[number + RESPONSE] != PairTable.SOLID) {
            return;
        }
        boolean start = feature == PieceGap.AT_START;
        int k = PieceContactRow.of(c);
        float ex = contacts.rows[k + OX] - vertexX(c, start);
        float ey = contacts.rows[k + OY] - vertexY(c, start);
        for (int other = from; other < to; other++) {
            if (other != c && mayCover(other)) {
                turn(motion(c), motion(other), ex, ey, boundary);
                int j = PieceContactRow.of(other);
                if (covers(c, start, other, contacts.rows[j + OX], contacts.rows[j + OY], localX, localY, r)) {
                    leave(c);
                    return;
                }
            }
        }
    }

    /** Whether a piece is solid, and a circle on a side of it. */
    boolean mayCover(int c) {
        return contacts.rows[PieceContactRow.of(c) + SIDE] != 0f
                && contacts.numbers[PieceContactRow.numbers(c) + RESPONSE] == PairTable.SOLID;
    }

    float vertexX(int c, boolean start) {
        return contacts.pieces[PieceRow.of(c) + (start ? PieceRow.START_X : PieceRow.END_X)];
    }

    float vertexY(int c, boolean start) {
        return contacts.pieces[PieceRow.of(c) + (start ? PieceRow.START_Y : PieceRow.END_Y)];
    }

    /** Whether a piece hides a vertex of another one's from a circle at o, which is (ex, ey) away from the vertex. */
    boolean covers(int c, boolean start, int other, float ox, float oy, float ex, float ey, float r) {
        float thickness = contacts.pieces[PieceRow.of(c) + PieceRow.THICKNESS];
        boolean free = (start ? PieceRow.startJoint(shape(c)) : PieceRow.endJoint(shape(c))) == PieceRow.FREE;
        float side = contacts.rows[PieceContactRow.of(other) + SIDE];
        int row = PieceRow.of(other);
        return PieceGap.covers(contacts.pieces, row, shape(other), ox, oy, side, ox - ex, oy - ey, thickness, free, r);
    }

    /** Turns a way from the frame of a body to that of another one. */
    private void turn(int motion, int to, float x, float y, int boundary) {
        localX = x;
        localY = y;
        if (motion == to) {
            return;
        }
        float[] bodies = terrain.motion;
        if (motion != 0) {
            int pose = BodyRow.of(motion, subSteps) + BodyRow.pose(boundary);
            float cos = bodies[pose + BodyRow.COS];
            float sin = bodies[pose + BodyRow.SIN];
            localX = cos * x - sin * y;
            localY = sin * x + cos * y;
        }
        if (to != 0) {
            int pose = BodyRow.of(to, subSteps) + BodyRow.pose(boundary);
            float cos = bodies[pose + BodyRow.COS];
            float sin = bodies[pose + BodyRow.SIN];
            float worldX = localX;
            float worldY = localY;
            localX = cos * worldX + sin * worldY;
            localY = cos * worldY - sin * worldX;
        }
    }

    /** Whether the frames of two bodies stay parallel within a step, or are one. */
    boolean areParallel(int motion, int other) {
        return motion == other || omega(motion) == 0f && omega(other) == 0f;
    }

    private float omega(int motion) {
        return motion == 0 ? 0f : terrain.motion[BodyRow.of(motion, subSteps) + BodyRow.OMEGA];
    }

    /** How fast the surface of a piece moves where a circle is nearest to it. */
    void findSurface(int slot, int c, int boundary) {
        surfaceX = 0f;
        surfaceY = 0f;
        if (terrain.bodies <= 1) {
            return;
        }
        int motion = motion(c);
        if (motion == 0) {
            return;
        }
        float[] bodies = terrain.motion;
        int body = BodyRow.of(motion, subSteps);
        int pose = body + BodyRow.pose(boundary);
        int row = PieceRow.of(c);
        int s = CircleRow.of(slot);
        int k = PieceContactRow.of(c);
        float reach = state.circle[s + RADIUS] + contacts.rows[k + GAP];
        float px = contacts.pieces[row + PieceRow.PIVOT_X];
        float py = contacts.pieces[row + PieceRow.PIVOT_Y];
        float dx = state.motion[s + DX] - bodies[pose + BodyRow.DX];
        float dy = state.motion[s + DY] - bodies[pose + BodyRow.DY];
        float x = ((contacts.rows[k + BASE_X] - px) + dx) - contacts.rows[k + NX] * reach;
        float y = ((contacts.rows[k + BASE_Y] - py) + dy) - contacts.rows[k + NY] * reach;
        float omega = bodies[body + BodyRow.OMEGA];
        surfaceX = bodies[body + BodyRow.VX] - omega * y;
        surfaceY = bodies[body + BodyRow.VY] + omega * x;
    }

    /** Whether a piece is a constraint of its circle, as measured last. */
    boolean isConstraint(int c) {
        int number = PieceContactRow.numbers(c);
        return contacts.numbers[number + FEATURE] != PieceGap.NONE
                && contacts.numbers[number + RESPONSE] == PairTable.SOLID;
    }
}
