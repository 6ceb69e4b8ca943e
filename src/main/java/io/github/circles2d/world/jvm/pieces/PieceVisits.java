package io.github.circles2d.world.jvm.pieces;

import static io.github.circles2d.world.jvm.state.PieceContactRow.ALLOWED;
import static io.github.circles2d.world.jvm.state.PieceContactRow.BOUNCE;
import static io.github.circles2d.world.jvm.state.PieceContactRow.CURVE;
import static io.github.circles2d.world.jvm.state.PieceContactRow.GAP;
import static io.github.circles2d.world.jvm.state.PieceContactRow.IMPULSE;
import static io.github.circles2d.world.jvm.state.PieceContactRow.NX;
import static io.github.circles2d.world.jvm.state.PieceContactRow.NY;
import static io.github.circles2d.world.jvm.state.PieceContactRow.ROWS;
import static io.github.circles2d.world.model.CircleRow.BEFORE_X;
import static io.github.circles2d.world.model.CircleRow.BEFORE_Y;
import static io.github.circles2d.world.model.CircleRow.DX;
import static io.github.circles2d.world.model.CircleRow.DY;
import static io.github.circles2d.world.model.CircleRow.INVERSE_INERTIA;
import static io.github.circles2d.world.model.CircleRow.INVERSE_MASS;
import static io.github.circles2d.world.model.CircleRow.LOADED;
import static io.github.circles2d.world.model.CircleRow.RADIUS;
import static io.github.circles2d.world.model.CircleRow.SURFACE_SPEED;
import static io.github.circles2d.world.model.CircleRow.VX;
import static io.github.circles2d.world.model.CircleRow.VY;

import io.github.circles2d.world.jvm.state.PieceContactRow;
import io.github.circles2d.world.jvm.state.PieceContacts;
import io.github.circles2d.world.jvm.state.State;
import io.github.circles2d.world.jvm.state.Turning;
import io.github.circles2d.world.model.Bounce;
import io.github.circles2d.world.model.CircleMath;
import io.github.circles2d.world.model.CircleRow;
import io.github.circles2d.world.model.Constraints;
import io.github.circles2d.world.model.ContactRows;
import io.github.circles2d.world.model.KindSurface;
import io.github.circles2d.world.model.OneBody;
import io.github.circles2d.world.model.OneBodyRows;
import io.github.circles2d.world.model.PieceGap;
import io.github.circles2d.world.model.PieceRow;
import io.github.circles2d.world.model.StepConstants;
import io.github.circles2d.world.model.TerrainStep;
import io.github.circles2d.world.model.Tuning;

/** The visits of pieces of terrain, by the circles that are near them. {@link OneBody} has the visit. Each worker has its own. */
public final class PieceVisits {
    private final State state;
    private final PieceContacts contacts;
    private final PieceMeasure measure;
    private final PieceMoves moves;
    private final OneBody visit = new OneBody();
    private final OneBodyRows otherRows = new OneBodyRows();

    /** What is told of visits; null if they are not recorded. */
    public PieceTouches touches;

    public PieceVisits(State state) {
        this.state = state;
        contacts = state.pieces;
        measure = new PieceMeasure(state);
        moves = new PieceMoves(state, measure);
    }

    public void begin(TerrainStep next, StepConstants k) {
        measure.begin(next, k);
    }

    /** {@link PieceMoves#move} */
    public void move(int slot, float fromX, float fromY, int sub) {
        moves.move(slot, fromX, fromY, sub);
    }

    public boolean any(int slot) {
        return contacts.count[slot] > 0;
    }

    private float acting(int row) {
        return ContactRows.actingImpulse(contacts.rows[row + IMPULSE], contacts.rows, row + ROWS, 1);
    }

    /** Whether the contact of a circle and a piece acts. */
    public boolean act(int slot) {
        for (int c = contacts.first[slot]; c < contacts.first[slot] + contacts.count[slot]; c++) {
            if (acting(PieceContactRow.of(c)) > 0f) {
                return true;
            }
        }
        return false;
    }

    /** The biased pass over the pieces of a circle: warm start, then a visit of each. */
    public void solve(int slot, StepConstants k, int sub) {
        if (sub == 0 || !measure.isMeasured(slot)) {
            measure.measure(slot, sub);
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
            rows[row + ALLOWED] = measure.isConstraint(c) ? CircleMath.min(rows[row + GAP], 0f) : 0f;
            if (rows[row + ALLOWED] < -Tuning.JAMMED * r) {
                rows[row + IMPULSE] = 0f;
            }
            if (measure.isConstraint(c) && acting(row) > 0f) {
                m[s + VX] += rows[row + NX] * rows[row + IMPULSE];
                m[s + VY] += rows[row + NY] * rows[row + IMPULSE];
                if (k.turning && ContactRows.any(rows, row + ROWS, 1)) {
                    takeRows(s, c);
                    otherRows.warmStart();
                    giveRows(s, c);
                }
            } else {
                ContactRows.clear(rows, row + ROWS, 1);
            }
        }
        for (int c = from; c < to; c++) {
            if (measure.isConstraint(c)) {
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
        measure.findSurface(slot, c, sub);
        float nx = rows[row + NX];
        float ny = rows[row + NY];
        float gap = rows[row + GAP];
        float impulse = rows[row + IMPULSE];
        float r = state.circle[s + RADIUS];
        float ux = m[s + VX] - measure.surfaceX;
        float uy = m[s + VY] - measure.surfaceY;
        rows[row + BOUNCE] = 0f;
        if (gap > Tuning.MARGIN * r && impulse == 0f && CircleMath.isLonger(ux * k.h, uy * k.h, Tuning.CAP * r)) {
            return; // the move ends there instead
        }
        float along = nx * uy - ny * ux;
        float vn = (nx * ux + ny * uy) - PieceGap.turned(rows[row + CURVE], along, k.h);
        float before =
                nx * (state.load[s + BEFORE_X] - measure.surfaceX) + ny * (state.load[s + BEFORE_Y] - measure.surfaceY);
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
            float way = nx * (state.load[s + BEFORE_Y] - measure.surfaceY)
                    - ny * (state.load[s + BEFORE_X] - measure.surfaceX);
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
            visitRows(s, c, along, visit.bounceSpeed);
        }
    }

    /** The relaxing pass over the pieces of a circle. */
    public void relax(int slot, StepConstants k, int sub) {
        int from = contacts.first[slot];
        int to = from + contacts.count[slot];
        for (int c = from; c < to; c++) {
            if (measure.isConstraint(c)) {
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
        boolean held = ContactRows.any(rows, row + ROWS, 1);
        if (Constraints.isIdle(gap, impulse, bounce) != 0 && !held) {
            return;
        }
        measure.findSurface(slot, c, sub + 1);
        float nx = rows[row + NX];
        float ny = rows[row + NY];
        float r = state.circle[s + RADIUS];
        float ux = m[s + VX] - measure.surfaceX;
        float uy = m[s + VY] - measure.surfaceY;
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
            visitRows(s, c, along, bounce);
        }
    }

    /** Tells of a visit before its effect: the approach, what it gives along the normal, and how fast surfaces slide. */
    private void tell(int slot, int c, float vn, float impulse, float slip) {
        int row = PieceContactRow.of(c);
        float surface = contacts.rows[row + NX] * measure.surfaceX + contacts.rows[row + NY] * measure.surfaceY;
        touches.visited(slot, c, vn, impulse, slip, surface);
    }

    // ---- other rows than the normal one

    private void visitRows(int s, int c, float along, float bounce) {
        takeRows(s, c);
        if (otherRows.act()) {
            otherRows.visit(visit, along, bounce);
            giveRows(s, c);
        }
    }

    /** How fast surfaces slide, if they have friction; along: against the surface, spin: surface speed of the circle. */
    private float slip(int c, float along, float spin, StepConstants k) {
        if (!k.turning) {
            return 0f;
        }
        otherRows.recall(contacts.surfaces, PieceContactRow.surfaces(c));
        return otherRows.slip(along, spin);
    }

    /** What the surfaces of a contact are in this step. */
    private void findSurfaces(int s, int c) {
        Turning t = state.turning;
        int kind = KindSurface.of(measure.terrain.traits[PieceRow.traits(contacts.piece(c)) + PieceRow.KIND]);
        int own = KindSurface.of(CircleRow.slot(s));
        float belts = t.surfaces[kind + KindSurface.BELT] + t.circleSurfaces[own + KindSurface.BELT];
        otherRows.between(
                t.circleSurfaces,
                own,
                t.surfaces,
                kind,
                belts,
                t.spin[s + INVERSE_INERTIA],
                state.traits[s + INVERSE_MASS]);
        otherRows.keep(contacts.surfaces, PieceContactRow.surfaces(c));
    }

    private void takeRows(int s, int c) {
        otherRows.recall(contacts.surfaces, PieceContactRow.surfaces(c));
        otherRows.surfaceSpeed = state.turning.spin[s + SURFACE_SPEED];
        otherRows.take(contacts.rows, PieceContactRow.of(c) + ROWS, 1);
    }

    private void giveRows(int s, int c) {
        int row = PieceContactRow.of(c);
        state.turning.spin[s + SURFACE_SPEED] = otherRows.surfaceSpeed;
        otherRows.give(contacts.rows, row + ROWS, 1);
        otherRows.push(state.motion, s + VX, contacts.rows[row + NX], contacts.rows[row + NY]);
    }
}
