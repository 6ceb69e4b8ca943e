package io.github.circles2d.world.reads;

import io.github.circles2d.world.bodies.KeptContacts;
import io.github.circles2d.world.bodies.OutlineShape;
import io.github.circles2d.world.bodies.RigidStep;
import io.github.circles2d.world.bodies.SavedRigids;
import io.github.circles2d.world.model.Bounds;
import io.github.circles2d.world.model.CircleMath;
import io.github.circles2d.world.model.CircleRow;
import io.github.circles2d.world.model.Limits;
import io.github.circles2d.world.model.PieceGap;
import io.github.circles2d.world.model.PieceRow;
import io.github.circles2d.world.model.Rotation;
import io.github.circles2d.world.shared.WorldParts;
import io.github.circles2d.world.snapshots.SavedState;
import io.github.circles2d.world.terrain.SavedPieceContacts;
import java.util.Arrays;

/** Reads what presses one circle, from the impulses that the next step starts from: circles, pieces of terrain, bodies, walls. */
public final class CircleContacts {
    /** Elements of a contact. */
    public static final int STRIDE = 4;

    /** The unit normal, towards the circle. */
    public static final int NORMAL_X = 0;

    public static final int NORMAL_Y = 1;

    /** How deep the two are in each other; negative over a gap. */
    public static final int DEPTH = 2;

    /** Of a step as the last sub-step was. */
    public static final int IMPULSE = 3;

    private final WorldParts world;
    private final PieceGap gap = new PieceGap();

    // the call under way
    private SavedState state;
    private Bounds bounds;
    private long[] partners;
    private float[] contacts;
    private int found;

    /** The circle: where its row begins, and its numbers. */
    private int row;

    private float x;
    private float y;
    private float radius;

    public CircleContacts(WorldParts world) {
        this.world = world;
    }

    /** The number of contacts; arrays take the first ones. */
    public int of(long circle, long[] partnersTo, float[] contactsTo) {
        world.guard.enter();
        try {
            partners = Limits.notNull("partners", partnersTo);
            int id = world.circle(circle);
            contacts = contactsTo;
            state = world.copies.saved();
            bounds = world.settings.bounds();
            found = 0;
            look(Arrays.binarySearch(state.id, 0, state.circles, id));
            addCircles(id);
            addPieces(id);
            addBodies(id);
            addWalls();
            return found;
        } finally {
            partners = null;
            contacts = null;
            world.guard.leave();
        }
    }

    private void look(int k) {
        row = CircleRow.of(k);
        x = state.circle[row + CircleRow.X];
        y = state.circle[row + CircleRow.Y];
        radius = state.circle[row + CircleRow.RADIUS];
    }

    private void addCircles(int id) {
        for (int k = 0; k < state.impulses; k++) {
            if (state.lo[k] == id) {
                addCircle(state.hi[k], state.normalImpulse[k]);
            } else if (state.hi[k] == id) {
                addCircle(state.lo[k], state.normalImpulse[k]);
            }
        }
    }

    private void addCircle(int other, float impulse) {
        int at = CircleRow.of(Arrays.binarySearch(state.id, 0, state.circles, other));
        float dx = CircleMath.shortWay(x - state.circle[at + CircleRow.X], bounds.periodX());
        float dy = CircleMath.shortWay(y - state.circle[at + CircleRow.Y], bounds.periodY());
        float d = CircleMath.length(dx, dy);
        float depth = (radius + state.circle[at + CircleRow.RADIUS]) - d;
        add(world.handles.handle(other), d == 0f ? 0f : dx / d, d == 0f ? 1f : dy / d, depth, impulse);
    }

    /** What a piece has given is a speed. */
    private void addPieces(int id) {
        SavedPieceContacts of = state.pieceContacts;
        if (of.count > 0) {
            world.terrain.makeRoom(world.settings.subSteps());
            world.terrain.refresh();
        }
        for (int c = 0; c < of.count; c++) {
            if (of.circle[c] == id && of.impulse[c] > 0) {
                measure(of.piece[c], of.side[c]);
                float impulse = state.circle[row + CircleRow.MASS] * of.impulse[c];
                add(world.terrain.pieces.ids.handle(of.piece[c]), gap.nx, gap.ny, 0f - gap.gap, impulse);
            }
        }
    }

    private void measure(int piece, int side) {
        float[] rows = world.input.terrain.rows;
        int at = PieceRow.of(piece);
        float midX = rows[at + PieceRow.MID_X];
        float midY = rows[at + PieceRow.MID_Y];
        float ox = CircleMath.shortWay(x - midX, bounds.periodX()) + (midX - rows[at + PieceRow.X]);
        float oy = CircleMath.shortWay(y - midY, bounds.periodY()) + (midY - rows[at + PieceRow.Y]);
        int shape = world.input.terrain.traits[PieceRow.traits(piece) + PieceRow.SHAPE];
        gap.measure(rows, at, shape, ox, oy, radius, side);
    }

    private void addBodies(int id) {
        KeptContacts of = state.rigids.contacts;
        for (int c = 0; c < of.count; c++) {
            if (of.type(c) == RigidStep.BODY_CIRCLE && of.b(c) == id && of.impulse(c) > 0f) {
                addBody(state.rigids, of.a(c), of.formAndFeature(c), of.impulse(c));
            }
        }
    }

    /** Measured as the outline lies when it is not turned. */
    private void addBody(SavedRigids of, int body, int formAndFeature, float impulse) {
        OutlineShape shape = of.outlines[of.outline[body]];
        int angle = of.values[SavedRigids.VALUES * body + SavedRigids.ANGLE];
        float cos = (float) Rotation.cos(angle);
        float sin = (float) Rotation.sin(angle);
        float dx = CircleMath.shortWay(x - of.real(body, SavedRigids.X), bounds.periodX());
        float dy = CircleMath.shortWay(y - of.real(body, SavedRigids.Y), bounds.periodY());
        float px = cos * dx + sin * dy;
        float py = cos * dy - sin * dx;
        float nx;
        float ny;
        float between;
        int feature = KeptContacts.feature(formAndFeature);
        if (KeptContacts.form(formAndFeature) == KeptContacts.SWAPPED) {
            float[] lines = shape.lines();
            int line = OutlineShape.LINE_STRIDE * feature;
            nx = lines[line + OutlineShape.NX];
            ny = lines[line + OutlineShape.NY];
            between = CircleMath.dot(nx, ny, px - lines[line], py - lines[line + 1])
                    - lines[line + OutlineShape.THICKNESS];
        } else {
            float[] corners = shape.corners();
            int corner = OutlineShape.CORNER_STRIDE * feature;
            float cx = px - corners[corner];
            float cy = py - corners[corner + 1];
            float d = CircleMath.length(cx, cy);
            nx = d == 0f ? 0f : cx / d;
            ny = d == 0f ? 1f : cy / d;
            between = d - (corners[corner + OutlineShape.BEND] + corners[corner + OutlineShape.RADIUS]);
        }
        add(world.rigids.ids.handle(body), cos * nx - sin * ny, sin * nx + cos * ny, radius - between, impulse);
    }

    /** What a wall has given is a speed, positive if it was the lower one. */
    private void addWalls() {
        float speedX = state.traits[row + CircleRow.WALL_X];
        float speedY = state.traits[row + CircleRow.WALL_Y];
        if (speedX != 0f) {
            addWall(speedX > 0f ? 1f : -1f, 0f, speedX > 0f ? x - bounds.minX() : bounds.maxX() - x, speedX);
        }
        if (speedY != 0f) {
            addWall(0f, speedY > 0f ? 1f : -1f, speedY > 0f ? y - bounds.minY() : bounds.maxY() - y, speedY);
        }
    }

    private void addWall(float nx, float ny, float distance, float speed) {
        add(0, nx, ny, radius - distance, state.circle[row + CircleRow.MASS] * Math.abs(speed));
    }

    private void add(long partner, float nx, float ny, float depth, float subStepImpulse) {
        int room = contacts == null ? partners.length : Math.min(partners.length, contacts.length / STRIDE);
        if (found < room) {
            partners[found] = partner;
            if (contacts != null) {
                contacts[STRIDE * found + NORMAL_X] = nx;
                contacts[STRIDE * found + NORMAL_Y] = ny;
                contacts[STRIDE * found + DEPTH] = depth;
                contacts[STRIDE * found + IMPULSE] = world.settings.subSteps() * subStepImpulse;
            }
        }
        found++;
    }
}
