package io.github.circles2d.world.jvm;

import static io.github.circles2d.world.jvm.PieceContactRow.ALLOWED;
import static io.github.circles2d.world.jvm.PieceContactRow.BASE_X;
import static io.github.circles2d.world.jvm.PieceContactRow.BASE_Y;
import static io.github.circles2d.world.jvm.PieceContactRow.BOUNCE;
import static io.github.circles2d.world.jvm.PieceContactRow.CURVE;
import static io.github.circles2d.world.jvm.PieceContactRow.FEATURE;
import static io.github.circles2d.world.jvm.PieceContactRow.GAP;
import static io.github.circles2d.world.jvm.PieceContactRow.IMPULSE;
import static io.github.circles2d.world.jvm.PieceContactRow.MOTION;
import static io.github.circles2d.world.jvm.PieceContactRow.NX;
import static io.github.circles2d.world.jvm.PieceContactRow.NY;
import static io.github.circles2d.world.jvm.PieceContactRow.OX;
import static io.github.circles2d.world.jvm.PieceContactRow.OY;
import static io.github.circles2d.world.jvm.PieceContactRow.PIECE;
import static io.github.circles2d.world.jvm.PieceContactRow.RESPONSE;
import static io.github.circles2d.world.jvm.PieceContactRow.ROLLING;
import static io.github.circles2d.world.jvm.PieceContactRow.SHAPE;
import static io.github.circles2d.world.jvm.PieceContactRow.SIDE;
import static io.github.circles2d.world.model.CircleRow.BEFORE_X;
import static io.github.circles2d.world.model.CircleRow.BEFORE_Y;
import static io.github.circles2d.world.model.CircleRow.BELT;
import static io.github.circles2d.world.model.CircleRow.DX;
import static io.github.circles2d.world.model.CircleRow.DY;
import static io.github.circles2d.world.model.CircleRow.INVERSE_INERTIA;
import static io.github.circles2d.world.model.CircleRow.INVERSE_MASS;
import static io.github.circles2d.world.model.CircleRow.LOADED;
import static io.github.circles2d.world.model.CircleRow.RADIUS;
import static io.github.circles2d.world.model.CircleRow.SURFACE_SPEED;
import static io.github.circles2d.world.model.CircleRow.VX;
import static io.github.circles2d.world.model.CircleRow.VY;
import static io.github.circles2d.world.model.CircleRow.X;
import static io.github.circles2d.world.model.CircleRow.Y;

import io.github.circles2d.world.model.BodyRow;
import io.github.circles2d.world.model.Bounce;
import io.github.circles2d.world.model.CircleMath;
import io.github.circles2d.world.model.CircleRow;
import io.github.circles2d.world.model.Constraints;
import io.github.circles2d.world.model.KindSurface;
import io.github.circles2d.world.model.KindTerrain;
import io.github.circles2d.world.model.OneBody;
import io.github.circles2d.world.model.OneBodyGrip;
import io.github.circles2d.world.model.PairTable;
import io.github.circles2d.world.model.PieceGap;
import io.github.circles2d.world.model.PieceRow;
import io.github.circles2d.world.model.PieceSweep;
import io.github.circles2d.world.model.StepConstants;
import io.github.circles2d.world.model.Surface;
import io.github.circles2d.world.model.TerrainStep;
import io.github.circles2d.world.model.Tuning;
import io.github.circles2d.world.model.Wrapping;

/** The visits of pieces of terrain, by the circles that are near them. {@link OneBody} has the visit. Each worker has its own. */
final class PieceVisits {
    /** In a corner, one piece moves a circle into the other. */
    private static final int ROUNDS = 6;

    private final State state;
    private final PieceContacts contacts;
    private final PieceGap found = new PieceGap();
    private final OneBody visit = new OneBody();
    private final OneBodyGrip grip = new OneBodyGrip();

    /** What is told of visits; null if they are not recorded. */
    PieceTouches touches;

    /** Within a step. */
    private TerrainStep terrain;

    private int subSteps;

    /** Where a place is in the frame of a body at the start of the step. */
    private float localX;

    private float localY;

    /** Where a piece stops a circle, in the same frame, and after which share of its move. */
    private float stopX;

    private float stopY;
    private float share;

    /** Velocity of the surface of a piece. */
    private float surfaceX;

    private float surfaceY;

    PieceVisits(State state) {
        this.state = state;
        contacts = state.pieces;
    }

    void begin(TerrainStep next, StepConstants k) {
        terrain = next;
        subSteps = k.subSteps;
    }

    /** The base of a circle against (X, Y) of a piece. */
    static float offsetX(State state, int slot, float[] rows, int row) {
        float x = state.circle[CircleRow.of(slot) + X];
        float at = rows[row + PieceRow.X];
        if (!state.wraps) {
            return x - at;
        }
        float mid = rows[row + PieceRow.MID_X];
        return Wrapping.shortWay(x - mid, state.periodX) + (mid - at);
    }

    static float offsetY(State state, int slot, float[] rows, int row) {
        float y = state.circle[CircleRow.of(slot) + Y];
        float at = rows[row + PieceRow.Y];
        if (!state.wraps) {
            return y - at;
        }
        float mid = rows[row + PieceRow.MID_Y];
        return Wrapping.shortWay(y - mid, state.periodY) + (mid - at);
    }

    boolean any(int slot) {
        return contacts.count[slot] > 0;
    }

    /** Whether a piece presses a circle. */
    boolean press(int slot) {
        for (int c = contacts.first[slot]; c < contacts.first[slot] + contacts.count[slot]; c++) {
            if (contacts.rows[PieceContactRow.of(c) + IMPULSE] > 0f) {
                return true;
            }
        }
        return false;
    }

    // ---- where circles are
    // -------------------------------------------------------------------------------------------

    /** Brings a place, against (X, Y) of a piece, to the frame of the start of the step. */
    private void toFrame(int row, int motion, float ox, float oy, float dx, float dy, int boundary) {
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

    private int motion(int c) {
        return contacts.numbers[PieceContactRow.numbers(c) + MOTION];
    }

    private int shape(int c) {
        return contacts.numbers[PieceContactRow.numbers(c) + SHAPE];
    }

    /** Measures all contacts of a circle at a boundary of sub-steps, and forgets the impulses of those that are none there. */
    private void measure(int slot, int boundary) {
        int s = CircleRow.of(slot);
        float dx = state.motion[s + DX];
        float dy = state.motion[s + DY];
        float r = state.circle[s + RADIUS];
        int from = contacts.first[slot];
        int to = from + contacts.count[slot];
        contacts.measured[CircleRow.vector(slot)] = dx;
        contacts.measured[CircleRow.vector(slot) + 1] = dy;
        boolean vertices = false;
        for (int c = from; c < to; c++) {
            vertices |= measure(slot, c, boundary, dx, dy, r);
        }
        if (vertices && to - from > 1) {
            for (int c = from; c < to; c++) {
                cover(c, from, to, r);
            }
        }
    }

    /** Whether a circle is where its contacts were measured last, to the bit; between sub-steps, pieces stay where they are. */
    private boolean isMeasured(int slot) {
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
        contacts.rows[k + PieceContactRow.FRICTION] = 0f;
        contacts.rows[k + ROLLING] = 0f;
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
                contacts.measured[CircleRow.vector(slot)] = Float.NaN; // the next measure may differ
            }
        }
        return vertex;
    }

    private boolean isTwoSided(int c, int shape) {
        return PieceRow.form(shape) == PieceRow.SEGMENT
                && isTwoSided(terrain, contacts.numbers[PieceContactRow.numbers(c) + PIECE], shape);
    }

    static boolean isTwoSided(TerrainStep terrain, int piece, int shape) {
        int kind = terrain.traits[PieceRow.traits(piece) + PieceRow.KIND];
        return PieceRow.form(shape) == PieceRow.SEGMENT
                && terrain.kinds.rows[KindTerrain.of(kind) + KindTerrain.ONE_WAY] == 0f;
    }

    /** A free vertex under which another piece has its face is no constraint. */
    private void cover(int c, int from, int to, float r) {
        int number = PieceContactRow.numbers(c);
        int feature = contacts.numbers[number + FEATURE];
        if (feature <= PieceGap.FACE || contacts.numbers[number + RESPONSE] != PairTable.SOLID) {
            return;
        }
        int shape = shape(c);
        boolean start = feature == PieceGap.AT_START;
        if ((start ? PieceRow.startJoint(shape) : PieceRow.endJoint(shape)) != PieceRow.FREE) {
            return;
        }
        int row = PieceRow.of(c);
        int k = PieceContactRow.of(c);
        float ex = contacts.pieces[row + (start ? PieceRow.START_X : PieceRow.END_X)];
        float ey = contacts.pieces[row + (start ? PieceRow.START_Y : PieceRow.END_Y)];
        for (int other = from; other < to; other++) {
            int o = PieceContactRow.numbers(other);
            if (contacts.numbers[o + FEATURE] == PieceGap.FACE
                    && contacts.numbers[o + RESPONSE] == PairTable.SOLID
                    && motion(other) == motion(c)) {
                int j = PieceContactRow.of(other);
                float x = (contacts.rows[j + OX] - contacts.rows[k + OX]) + ex;
                float y = (contacts.rows[j + OY] - contacts.rows[k + OY]) + ey;
                float thickness = contacts.pieces[row + PieceRow.THICKNESS];
                float side = contacts.rows[j + SIDE];
                if (PieceGap.covers(
                        contacts.pieces, PieceRow.of(other), shape(other), side, x, y, thickness, Tuning.COVER * r)) {
                    leave(c);
                    return;
                }
            }
        }
    }

    /** How fast the surface of a piece moves where a circle is nearest to it. */
    private void findSurface(int slot, int c, int boundary) {
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

    // ---- visits
    // ---------------------------------------------------------------------------------------------------------

    private boolean isConstraint(int c) {
        int number = PieceContactRow.numbers(c);
        return contacts.numbers[number + FEATURE] != PieceGap.NONE
                && contacts.numbers[number + RESPONSE] == PairTable.SOLID;
    }

    /** The biased pass over the pieces of a circle: warm start, then a visit of each. */
    void solve(int slot, StepConstants k, int sub) {
        if (sub == 0 || !isMeasured(slot)) {
            measure(slot, sub);
        }
        if (sub == 0) {
            begin(slot, k);
        }
        int from = contacts.first[slot];
        int to = from + contacts.count[slot];
        int s = CircleRow.of(slot);
        float[] m = state.motion;
        float[] rows = contacts.rows;
        float r = state.circle[s + RADIUS];
        for (int c = from; c < to; c++) {
            int row = PieceContactRow.of(c);
            rows[row + ALLOWED] = isConstraint(c) ? CircleMath.min(rows[row + GAP], 0f) : 0f;
            if (rows[row + ALLOWED] < -Tuning.JAMMED * r) {
                rows[row + IMPULSE] = 0f;
            }
            if (isConstraint(c) && rows[row + IMPULSE] > 0f) {
                m[s + VX] += rows[row + NX] * rows[row + IMPULSE];
                m[s + VY] += rows[row + NY] * rows[row + IMPULSE];
                if (k.turning && (rows[row + PieceContactRow.FRICTION] != 0f || rows[row + ROLLING] != 0f)) {
                    takeGrip(s, c);
                    grip.warmStart();
                    giveGrip(s, c);
                }
            } else {
                rows[row + PieceContactRow.FRICTION] = 0f;
                rows[row + ROLLING] = 0f;
            }
        }
        for (int c = from; c < to; c++) {
            if (isConstraint(c)) {
                solve(slot, c, k, sub);
            }
        }
    }

    /** Begins a step. */
    private void begin(int slot, StepConstants k) {
        if (touches != null) {
            touches.begin(slot);
        }
        if (k.turning) {
            int s = CircleRow.of(slot);
            for (int c = contacts.first[slot]; c < contacts.first[slot] + contacts.count[slot]; c++) {
                findSurfaces(s, c);
            }
        }
    }

    private void solve(int slot, int c, StepConstants k, int sub) {
        int s = CircleRow.of(slot);
        int row = PieceContactRow.of(c);
        float[] m = state.motion;
        float[] rows = contacts.rows;
        findSurface(slot, c, sub);
        float nx = rows[row + NX];
        float ny = rows[row + NY];
        float gap = rows[row + GAP];
        float impulse = rows[row + IMPULSE];
        float r = state.circle[s + RADIUS];
        float ux = m[s + VX] - surfaceX;
        float uy = m[s + VY] - surfaceY;
        rows[row + BOUNCE] = 0f;
        if (gap > Tuning.MARGIN * r && impulse == 0f && CircleMath.isLonger(ux * k.h, uy * k.h, Tuning.CAP * r)) {
            return; // the move ends there instead
        }
        float along = nx * uy - ny * ux;
        float vn = (nx * ux + ny * uy) - PieceGap.turned(rows[row + CURVE], along, k.h);
        float before = nx * (state.load[s + BEFORE_X] - surfaceX) + ny * (state.load[s + BEFORE_Y] - surfaceY);
        if (Constraints.staysClear(gap, impulse, vn, before, k.h, k.inverseH) != 0) {
            return;
        }
        visit.solve(
                gap,
                r,
                rows[row + PieceContactRow.RESTITUTION],
                k.thresholdRate,
                state.load[s + LOADED],
                before,
                vn,
                impulse,
                k);
        if (touches != null) {
            float way = nx * (state.load[s + BEFORE_Y] - surfaceY) - ny * (state.load[s + BEFORE_X] - surfaceX);
            float spin = k.turning ? state.turning.before(slot) : 0f;
            tell(slot, c, before, impulse + visit.impulse, slip(c, way, spin, k));
        }
        if (visit.bounced) {
            float behind = Bounce.leftBehind(gap, vn, visit.impulse, k.dt, r);
            m[s + DX] -= nx * behind;
            m[s + DY] -= ny * behind;
        }
        rows[row + BOUNCE] = visit.bounceSpeed;
        m[s + VX] += nx * visit.impulse;
        m[s + VY] += ny * visit.impulse;
        rows[row + IMPULSE] = visit.normalImpulse;
        if (visit.bounced && k.turning) {
            grip(s, c, visit.impulse, along, false);
        }
    }

    /** The relaxing pass over the pieces of a circle. */
    void relax(int slot, StepConstants k, int sub) {
        int from = contacts.first[slot];
        int to = from + contacts.count[slot];
        for (int c = from; c < to; c++) {
            if (isConstraint(c)) {
                relax(slot, c, k, sub);
            }
        }
    }

    private void relax(int slot, int c, StepConstants k, int sub) {
        int s = CircleRow.of(slot);
        int row = PieceContactRow.of(c);
        float[] m = state.motion;
        float[] rows = contacts.rows;
        float gap = rows[row + GAP];
        float impulse = rows[row + IMPULSE];
        float bounce = rows[row + BOUNCE];
        boolean held = rows[row + PieceContactRow.FRICTION] != 0f || rows[row + ROLLING] != 0f;
        if (Constraints.isIdle(gap, impulse, bounce) != 0 && !held) {
            return;
        }
        findSurface(slot, c, sub + 1);
        float nx = rows[row + NX];
        float ny = rows[row + NY];
        float r = state.circle[s + RADIUS];
        float ux = m[s + VX] - surfaceX;
        float uy = m[s + VY] - surfaceY;
        float along = nx * uy - ny * ux;
        float vn = nx * ux + ny * uy;
        visit.relax(
                gap,
                r,
                rows[row + PieceContactRow.RESTITUTION],
                k.thresholdRate,
                state.load[s + LOADED],
                bounce,
                vn,
                impulse,
                k);
        if (touches != null) {
            float spin = k.turning ? state.turning.spin[s + SURFACE_SPEED] : 0f;
            tell(slot, c, vn, visit.impulse, slip(c, along, spin, k));
        }
        if (!visit.leaves) {
            m[s + VX] += nx * visit.impulse;
            m[s + VY] += ny * visit.impulse;
            rows[row + IMPULSE] = bounce > 0f ? 0f : visit.normalImpulse; // that of a bounce is not kept
        }
        if (k.turning) {
            float normal = visit.bounced ? visit.impulse : visit.normalImpulse;
            grip(s, c, normal, along, !(visit.bounced || visit.leaves || bounce > 0f));
        }
    }

    /** Tells of a visit before its effect: the approach, what it gives along the normal, and how fast surfaces slide. */
    private void tell(int slot, int c, float vn, float impulse, float slip) {
        int row = PieceContactRow.of(c);
        float surface = contacts.rows[row + NX] * surfaceX + contacts.rows[row + NY] * surfaceY;
        touches.visited(slot, c, vn, impulse, slip, surface);
    }

    // ---- grips
    // ----------------------------------------------------------------------------------------------------------

    private void grip(int s, int c, float normalImpulse, float along, boolean keep) {
        takeGrip(s, c);
        if (grip.acts()) {
            float belt = contacts.surfaces[PieceContactRow.surfaces(c) + PieceContactRow.BELT];
            grip.visit(normalImpulse, along, belt, keep);
            giveGrip(s, c);
        }
    }

    /** How fast surfaces slide, if they grip; along: against the surface, spin: surface speed of the circle. */
    private float slip(int c, float along, float spin, StepConstants k) {
        int surfaces = PieceContactRow.surfaces(c);
        return k.turning
                ? Surface.hitSlip(
                        contacts.surfaces[surfaces + PieceContactRow.MU],
                        along,
                        0f,
                        spin,
                        contacts.surfaces[surfaces + PieceContactRow.BELT])
                : 0f;
    }

    /** What the surfaces of a contact are in this step. */
    private void findSurfaces(int s, int c) {
        Turning t = state.turning;
        int kind = KindSurface.of(terrain.traits[PieceRow.traits(contacts.piece(c)) + PieceRow.KIND]);
        grip.between(
                t.skin[s + CircleRow.FRICTION],
                t.kinds[kind + KindSurface.FRICTION],
                t.skin[s + CircleRow.ROLLING_RESISTANCE],
                t.kinds[kind + KindSurface.ROLLING_RESISTANCE],
                t.spin[s + INVERSE_INERTIA] / state.traits[s + INVERSE_MASS]);
        int surfaces = PieceContactRow.surfaces(c);
        contacts.surfaces[surfaces + PieceContactRow.MU] = grip.mu;
        contacts.surfaces[surfaces + PieceContactRow.RESISTANCE] = grip.resistance;
        contacts.surfaces[surfaces + PieceContactRow.INERTIA] = grip.inertia;
        contacts.surfaces[surfaces + PieceContactRow.BELT] = t.kinds[kind + KindSurface.BELT] + t.skin[s + BELT];
    }

    private void takeGrip(int s, int c) {
        int row = PieceContactRow.of(c);
        int surfaces = PieceContactRow.surfaces(c);
        grip.mu = contacts.surfaces[surfaces + PieceContactRow.MU];
        grip.resistance = contacts.surfaces[surfaces + PieceContactRow.RESISTANCE];
        grip.inertia = contacts.surfaces[surfaces + PieceContactRow.INERTIA];
        grip.surfaceSpeed = state.turning.spin[s + SURFACE_SPEED];
        grip.friction = contacts.rows[row + PieceContactRow.FRICTION];
        grip.rolling = contacts.rows[row + ROLLING];
    }

    private void giveGrip(int s, int c) {
        int row = PieceContactRow.of(c);
        state.turning.spin[s + SURFACE_SPEED] = grip.surfaceSpeed;
        contacts.rows[row + PieceContactRow.FRICTION] = grip.friction;
        contacts.rows[row + ROLLING] = grip.rolling;
        state.motion[s + VX] += -1f * contacts.rows[row + NY] * grip.impulse;
        state.motion[s + VY] += contacts.rows[row + NX] * grip.impulse;
    }

    // ---- the move
    // -------------------------------------------------------------------------------------------------------

    /** Ends a circle's move in a sub-step, from a displacement, so that no piece is passed, or entered; and measures the contacts there. */
    void move(int slot, float fromX, float fromY, int sub) {
        if (contacts.count[slot] == 1 && moveOverFace(slot, contacts.first[slot], fromX, fromY)) {
            return;
        }
        boolean stopped = stop(slot, fromX, fromY, sub);
        measure(slot, sub + 1);
        for (int round = 0; round < ROUNDS && keepOut(slot); round++) {
            measure(slot, sub + 1);
        }
        if (stopped) {
            touch(slot);
        }
    }

    /** The circle touches what has stopped it, also where rounding leaves a gap: else it would stand there for ever. */
    private void touch(int slot) {
        float graze = Tuning.GRAZE * state.circle[CircleRow.of(slot) + RADIUS];
        for (int c = contacts.first[slot]; c < contacts.first[slot] + contacts.count[slot]; c++) {
            int gap = PieceContactRow.of(c) + GAP;
            if (contacts.rows[gap] <= graze) {
                contacts.rows[gap] = CircleMath.min(contacts.rows[gap], 0f);
            }
        }
        contacts.measured[CircleRow.vector(slot)] = Float.NaN; // the next pass measures all again
    }

    /**
     * The same of nearly all circles near a piece: those that move a short way over the face of a line at rest, and see no other piece. Returns
     * false, and changes nothing, if the circle is another.
     */
    private boolean moveOverFace(int slot, int c, float fromX, float fromY) {
        int s = CircleRow.of(slot);
        int k = PieceContactRow.of(c);
        int number = PieceContactRow.numbers(c);
        float[] rows = contacts.rows;
        float[] m = state.motion;
        int shape = shape(c);
        float side = rows[k + SIDE];
        float r = state.circle[s + RADIUS];
        float dx = m[s + DX];
        float dy = m[s + DY];
        if (PieceRow.form(shape) == PieceRow.ARC
                || motion(c) != 0
                || side == 0f
                || contacts.numbers[number + FEATURE] != PieceGap.FACE
                || contacts.numbers[number + RESPONSE] != PairTable.SOLID
                || CircleMath.isLonger(dx - fromX, dy - fromY, Tuning.CAP * r)) {
            return false;
        }
        float[] pieces = contacts.pieces;
        int row = PieceRow.of(c);
        float tx = pieces[row + PieceRow.TX];
        float ty = pieces[row + PieceRow.TY];
        float length = pieces[row + PieceRow.LENGTH];
        float reach = r + pieces[row + PieceRow.THICKNESS];
        float nx = side * ty;
        float ny = side * (-1f * tx);
        float baseX = rows[k + BASE_X];
        float baseY = rows[k + BASE_Y];
        float allowed = rows[k + ALLOWED];
        float x = baseX + dx;
        float y = baseY + dy;
        float gap = 0f;
        for (int round = 0; ; round++) {
            float t = PieceGap.along(tx, ty, x, y);
            if (!(t >= 0f && t <= length)) {
                return false; // it is at a joint, or beyond
            }
            gap = PieceGap.faceGap(side, PieceGap.height(tx, ty, x, y), reach);
            float out = allowed - gap;
            if (round == ROUNDS || !(out > 0f)) {
                break;
            }
            float nextX = dx + (0f + nx * out);
            float nextY = dy + (0f + ny * out);
            boolean stays = nextX == dx && nextY == dy;
            dx = nextX;
            dy = nextY;
            x = baseX + dx;
            y = baseY + dy;
            if (stays) {
                break; // too little to move it
            }
        }
        m[s + DX] = dx;
        m[s + DY] = dy;
        contacts.measured[CircleRow.vector(slot)] = dx;
        contacts.measured[CircleRow.vector(slot) + 1] = dy;
        contacts.numbers[number + FEATURE] = PieceGap.FACE;
        rows[k + OX] = x;
        rows[k + OY] = y;
        rows[k + NX] = nx;
        rows[k + NY] = ny;
        rows[k + GAP] = gap;
        rows[k + CURVE] = 0f;
        return true;
    }

    /** Moves a circle out of the pieces that it is deeper in than before the sub-step; returns whether there were some. */
    private boolean keepOut(int slot) {
        int s = CircleRow.of(slot);
        float[] rows = contacts.rows;
        float outX = 0f;
        float outY = 0f;
        for (int c = contacts.first[slot]; c < contacts.first[slot] + contacts.count[slot]; c++) {
            int row = PieceContactRow.of(c);
            float nx = rows[row + NX];
            float ny = rows[row + NY];
            float out = rows[row + ALLOWED] - (rows[row + GAP] + (nx * outX + ny * outY));
            if (out > 0f && isConstraint(c)) {
                outX += nx * out;
                outY += ny * out;
            }
        }
        if (outX == 0f && outY == 0f) {
            return false;
        }
        state.motion[s + DX] += outX;
        state.motion[s + DY] += outY;
        return !isMeasured(slot); // it may be too little to move it
    }

    /** Where a circle would pass a piece, its move ends; a piece that moves takes it along. Returns whether there was one. */
    private boolean stop(int slot, float fromX, float fromY, int sub) {
        int stopper = firstStop(slot, fromX, fromY, sub, true);
        if (stopper < 0) {
            return false;
        }
        if (motion(stopper) == 0) {
            stopAt(slot, fromX, fromY);
            return true;
        }
        takeAlong(slot, stopper, sub + 1);
        if (firstStop(slot, fromX, fromY, sub, false) >= 0) {
            stopAt(slot, fromX, fromY);
        }
        return true;
    }

    private void stopAt(int slot, float fromX, float fromY) {
        int s = CircleRow.of(slot);
        state.motion[s + DX] = fromX + share * (state.motion[s + DX] - fromX);
        state.motion[s + DY] = fromY + share * (state.motion[s + DY] - fromY);
    }

    /** The contact that stops a circle first, with its share of the move and the place; -1 if none does. */
    private int firstStop(int slot, float fromX, float fromY, int sub, boolean moving) {
        int s = CircleRow.of(slot);
        float r = state.circle[s + RADIUS];
        float dx = state.motion[s + DX];
        float dy = state.motion[s + DY];
        boolean fast = CircleMath.isLonger(dx - fromX, dy - fromY, Tuning.CAP * r);
        int stopper = -1;
        share = 1f;
        if (!fast && !(moving && terrain.bodies > 1)) {
            return stopper;
        }
        for (int c = contacts.first[slot]; c < contacts.first[slot] + contacts.count[slot]; c++) {
            int motion = motion(c);
            float side = contacts.rows[PieceContactRow.of(c) + SIDE];
            if (side == 0f
                    || contacts.numbers[PieceContactRow.numbers(c) + RESPONSE] != PairTable.SOLID
                    || (motion == 0 ? !fast : !moving)) {
                continue;
            }
            int row = PieceRow.of(c);
            float ox = contacts.rows[PieceContactRow.of(c) + BASE_X];
            float oy = contacts.rows[PieceContactRow.of(c) + BASE_Y];
            toFrame(row, motion, ox, oy, fromX, fromY, sub);
            float x = localX;
            float y = localY;
            toFrame(row, motion, ox, oy, dx, dy, sub + 1);
            float ux = motion == 0 ? dx - fromX : localX - x;
            float uy = motion == 0 ? dy - fromY : localY - y;
            if (motion == 0 || CircleMath.isLonger(ux, uy, Tuning.CAP * r)) {
                float t = PieceSweep.time(contacts.pieces, row, shape(c), x, y, ux, uy, r, side);
                if (t < share) {
                    share = t;
                    stopper = c;
                    stopX = x + t * ux;
                    stopY = y + t * uy;
                }
            }
        }
        return stopper;
    }

    /** Sets a circle's displacement to the place where a piece that moves has met it, as the piece has it at a boundary. */
    private void takeAlong(int slot, int c, int boundary) {
        int row = PieceRow.of(c);
        int body = BodyRow.of(motion(c), subSteps);
        int pose = body + BodyRow.pose(boundary);
        float[] bodies = terrain.motion;
        float px = contacts.pieces[row + PieceRow.PIVOT_X];
        float py = contacts.pieces[row + PieceRow.PIVOT_Y];
        float x = stopX - px;
        float y = stopY - py;
        float cos = bodies[pose + BodyRow.COS];
        float sin = bodies[pose + BodyRow.SIN];
        int s = CircleRow.of(slot);
        float ox = contacts.rows[PieceContactRow.of(c) + BASE_X] - px;
        float oy = contacts.rows[PieceContactRow.of(c) + BASE_Y] - py;
        state.motion[s + DX] = ((cos * x - sin * y) - ox) + bodies[pose + BodyRow.DX];
        state.motion[s + DY] = ((sin * x + cos * y) - oy) + bodies[pose + BodyRow.DY];
    }
}
