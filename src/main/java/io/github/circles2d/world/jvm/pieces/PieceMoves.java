package io.github.circles2d.world.jvm.pieces;

import static io.github.circles2d.world.jvm.state.PieceContactRow.ALLOWED;
import static io.github.circles2d.world.jvm.state.PieceContactRow.BASE_X;
import static io.github.circles2d.world.jvm.state.PieceContactRow.BASE_Y;
import static io.github.circles2d.world.jvm.state.PieceContactRow.CURVE;
import static io.github.circles2d.world.jvm.state.PieceContactRow.FEATURE;
import static io.github.circles2d.world.jvm.state.PieceContactRow.GAP;
import static io.github.circles2d.world.jvm.state.PieceContactRow.NX;
import static io.github.circles2d.world.jvm.state.PieceContactRow.NY;
import static io.github.circles2d.world.jvm.state.PieceContactRow.OX;
import static io.github.circles2d.world.jvm.state.PieceContactRow.OY;
import static io.github.circles2d.world.jvm.state.PieceContactRow.RESPONSE;
import static io.github.circles2d.world.jvm.state.PieceContactRow.SIDE;
import static io.github.circles2d.world.model.CircleRow.DX;
import static io.github.circles2d.world.model.CircleRow.DY;
import static io.github.circles2d.world.model.CircleRow.RADIUS;

import io.github.circles2d.world.jvm.state.PieceContactRow;
import io.github.circles2d.world.jvm.state.PieceContacts;
import io.github.circles2d.world.jvm.state.State;
import io.github.circles2d.world.model.BodyRow;
import io.github.circles2d.world.model.CircleMath;
import io.github.circles2d.world.model.CircleRow;
import io.github.circles2d.world.model.PairTable;
import io.github.circles2d.world.model.PieceGap;
import io.github.circles2d.world.model.PieceRow;
import io.github.circles2d.world.model.PieceSweep;
import io.github.circles2d.world.model.Tuning;

/** The move of circles near pieces of terrain: none is passed, or entered. Each worker has its own. */
final class PieceMoves {
    /** In a corner, one piece moves a circle into the other. */
    private static final int ROUNDS = 6;

    private final State state;
    private final PieceContacts contacts;
    private final PieceMeasure measure;

    /** Where a piece stops a circle, in the frame of the start of the step, and after which share of its move. */
    private float stopX;

    private float stopY;

    /** A circle's place before its move, and its move, in the frame of a piece. */
    private float atX;

    private float atY;
    private float wayX;
    private float wayY;

    private float share;

    /** The contact at rest that has stopped a circle, or -1, and what is left of its move. */
    private int stopper;

    private float leftX;
    private float leftY;

    PieceMoves(State state, PieceMeasure measure) {
        this.state = state;
        contacts = state.pieces;
        this.measure = measure;
    }

    /** Ends a circle's move in a sub-step, from a displacement, so that no piece is passed, or entered; and measures the contacts there. */
    void move(int slot, float fromX, float fromY, int sub) {
        if (contacts.count[slot] == 1 && moveOverFace(slot, contacts.first[slot], fromX, fromY)) {
            return;
        }
        boolean stopped = stop(slot, fromX, fromY, sub);
        measure.measure(slot, sub + 1);
        if (stopper >= 0 && slide(slot)) {
            measure.measure(slot, sub + 1);
        }
        for (int round = 0; round < ROUNDS && keepOut(slot); round++) {
            measure.measure(slot, sub + 1);
        }
        if (stopped) {
            touch(slot);
        }
    }

    /** What is left of a move goes on along what has stopped it, a short way: else a circle that is always pressed against it could never leave. */
    private boolean slide(int slot) {
        if (!measure.isConstraint(stopper)
                || contacts.numbers[PieceContactRow.numbers(stopper) + FEATURE] != PieceGap.FACE) {
            return false; // around an end it would pass
        }
        int s = CircleRow.of(slot);
        float nx = contacts.rows[PieceContactRow.of(stopper) + NX];
        float ny = contacts.rows[PieceContactRow.of(stopper) + NY];
        float most = Tuning.CAP * state.circle[s + RADIUS];
        float way = CircleMath.clamp(nx * leftY - ny * leftX, -most, most);
        state.motion[s + DX] -= ny * way;
        state.motion[s + DY] += nx * way;
        return way != 0f;
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
        int shape = measure.shape(c);
        float side = rows[k + SIDE];
        float r = state.circle[s + RADIUS];
        float dx = m[s + DX];
        float dy = m[s + DY];
        if (PieceRow.form(shape) == PieceRow.ARC
                || measure.motion(c) != 0
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
            if (out > 0f && measure.isConstraint(c)) {
                outX += nx * out;
                outY += ny * out;
            }
        }
        if (outX == 0f && outY == 0f) {
            return false;
        }
        state.motion[s + DX] += outX;
        state.motion[s + DY] += outY;
        return !measure.isMeasured(slot); // it may be too little to move it
    }

    /** Where a circle would pass a piece, its move ends; a piece that moves takes it along. Returns whether there was one. */
    private boolean stop(int slot, float fromX, float fromY, int sub) {
        stopper = firstStop(slot, fromX, fromY, sub, true);
        if (stopper < 0) {
            return false;
        }
        if (measure.motion(stopper) != 0) {
            takeAlong(slot, stopper, sub + 1);
            stopper = firstStop(slot, fromX, fromY, sub, false);
        }
        if (stopper >= 0) {
            stopAt(slot, fromX, fromY);
        }
        return true;
    }

    private void stopAt(int slot, float fromX, float fromY) {
        int s = CircleRow.of(slot);
        float toX = state.motion[s + DX];
        float toY = state.motion[s + DY];
        float x = fromX + share * (toX - fromX);
        float y = fromY + share * (toY - fromY);
        state.motion[s + DX] = x;
        state.motion[s + DY] = y;
        leftX = toX - x;
        leftY = toY - y;
    }

    /** The contact that stops a circle first, with its share of the move and the place; -1 if none does. */
    private int firstStop(int slot, float fromX, float fromY, int sub, boolean moving) {
        int s = CircleRow.of(slot);
        float r = state.circle[s + RADIUS];
        float dx = state.motion[s + DX];
        float dy = state.motion[s + DY];
        boolean fast = CircleMath.isLonger(dx - fromX, dy - fromY, Tuning.CAP * r);
        int first = -1;
        share = 1f;
        if (!fast && !(moving && measure.terrain.bodies > 1)) {
            return first;
        }
        for (int c = contacts.first[slot]; c < contacts.first[slot] + contacts.count[slot]; c++) {
            int motion = measure.motion(c);
            float side = contacts.rows[PieceContactRow.of(c) + SIDE];
            if (side == 0f
                    || contacts.numbers[PieceContactRow.numbers(c) + RESPONSE] != PairTable.SOLID
                    || (motion == 0 ? !fast : !moving)) {
                continue;
            }
            way(c, fromX, fromY, dx, dy, sub);
            if (motion == 0 || CircleMath.isLonger(wayX, wayY, Tuning.CAP * r)) {
                first = firstStop(slot, c, fromX, fromY, sub, first);
            }
        }
        return first;
    }

    /** Finds a circle's move in the frame of the body of a piece. */
    private void way(int c, float fromX, float fromY, float dx, float dy, int sub) {
        int row = PieceRow.of(c);
        int motion = measure.motion(c);
        float ox = contacts.rows[PieceContactRow.of(c) + BASE_X];
        float oy = contacts.rows[PieceContactRow.of(c) + BASE_Y];
        measure.toFrame(row, motion, ox, oy, fromX, fromY, sub);
        atX = measure.localX;
        atY = measure.localY;
        measure.toFrame(row, motion, ox, oy, dx, dy, sub + 1);
        wayX = motion == 0 ? dx - fromX : measure.localX - atX;
        wayY = motion == 0 ? dy - fromY : measure.localY - atY;
    }

    /** Along the way that was found. A vertex that is covered stops nobody. */
    private int firstStop(int slot, int c, float fromX, float fromY, int sub, int firstBefore) {
        float r = state.circle[CircleRow.of(slot) + RADIUS];
        int row = PieceRow.of(c);
        int shape = measure.shape(c);
        float side = contacts.rows[PieceContactRow.of(c) + SIDE];
        float x = atX;
        float y = atY;
        float ux = wayX;
        float uy = wayY;
        int first = firstBefore;
        for (int feature = PieceGap.FACE; feature <= PieceGap.AT_END; feature++) {
            boolean start = feature == PieceGap.AT_START;
            float t = feature == PieceGap.FACE
                    ? PieceSweep.timeOfFace(contacts.pieces, row, shape, x, y, ux, uy, r, side)
                    : PieceSweep.timeOfVertex(contacts.pieces, row, shape, start, x, y, ux, uy, r);
            if (t < share
                    && (feature == PieceGap.FACE
                            || !isCovered(slot, c, start, x + t * ux, y + t * uy, t, fromX, fromY, sub))) {
                share = t;
                first = c;
                stopX = x + t * ux;
                stopY = y + t * uy;
            }
        }
        return first;
    }

    /** Whether a vertex is covered that a circle touches at a place, after a share of its move. */
    private boolean isCovered(
            int slot, int c, boolean start, float x, float y, float t, float fromX, float fromY, int sub) {
        int s = CircleRow.of(slot);
        float r = state.circle[s + RADIUS];
        float ex = x - measure.vertexX(c, start);
        float ey = y - measure.vertexY(c, start);
        for (int other = contacts.first[slot]; other < contacts.first[slot] + contacts.count[slot]; other++) {
            if (other != c
                    && measure.mayCover(other)
                    && measure.areParallel(measure.motion(c), measure.motion(other))) {
                way(other, fromX, fromY, state.motion[s + DX], state.motion[s + DY], sub);
                if (measure.covers(c, start, other, atX + t * wayX, atY + t * wayY, ex, ey, r)) {
                    return true;
                }
            }
        }
        return false;
    }

    /** Sets a circle's displacement to the place where a piece that moves has met it, as the piece has it at a boundary. */
    private void takeAlong(int slot, int c, int boundary) {
        int row = PieceRow.of(c);
        int body = BodyRow.of(measure.motion(c), measure.subSteps);
        int pose = body + BodyRow.pose(boundary);
        float[] bodies = measure.terrain.motion;
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
