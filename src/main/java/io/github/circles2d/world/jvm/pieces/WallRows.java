package io.github.circles2d.world.jvm.pieces;

import static io.github.circles2d.world.model.CircleRow.INVERSE_INERTIA;
import static io.github.circles2d.world.model.CircleRow.INVERSE_MASS;
import static io.github.circles2d.world.model.CircleRow.SURFACE_SPEED;
import static io.github.circles2d.world.model.CircleRow.VX;
import static io.github.circles2d.world.model.CircleRow.WALL_X;
import static io.github.circles2d.world.model.CircleRow.WALL_Y;
import static io.github.circles2d.world.model.CircleRow.X;
import static io.github.circles2d.world.model.CircleRow.Y;

import io.github.circles2d.world.jvm.state.State;
import io.github.circles2d.world.jvm.state.Turning;
import io.github.circles2d.world.model.CircleRow;
import io.github.circles2d.world.model.ContactRows;
import io.github.circles2d.world.model.KindSurface;
import io.github.circles2d.world.model.OneBody;
import io.github.circles2d.world.model.OneBodyRows;
import io.github.circles2d.world.model.WallMotion;
import io.github.circles2d.world.model.Walls;

/** The rows behind the normal one of contacts with walls. {@link OneBodyRows} has the visit. */
public final class WallRows {
    private final State state;
    private final OneBodyRows rows = new OneBodyRows();

    WallRows(State state) {
        this.state = state;
    }

    private static int at(int slot, int axis) {
        return ContactRows.ofWalls(slot) + ContactRows.ofWall(0, axis);
    }

    /** Whether some row of the nearer wall of an axis has acted, which a visit may have to take back. */
    boolean hold(int slot, int axis) {
        return ContactRows.any(state.turning.wallRows, at(slot, axis), ContactRows.OF_WALL);
    }

    /** The same of both axes. */
    public boolean hold(int slot) {
        return hold(slot, X) | hold(slot, Y);
    }

    /** {@link ContactRows#actingImpulse} of the nearer wall of an axis. */
    public float acting(int slot, int axis, float normalImpulse) {
        return ContactRows.actingImpulse(normalImpulse, state.turning.wallRows, at(slot, axis), ContactRows.OF_WALL);
    }

    /** Whether some wall acts. */
    private boolean act(int slot) {
        int s = CircleRow.of(slot);
        return acting(slot, X, Math.abs(state.traits[s + WALL_X])) > 0f
                || acting(slot, Y, Math.abs(state.traits[s + WALL_Y])) > 0f;
    }

    /** The warm start of both axes. */
    public void start(int slot, float sideX, float sideY) {
        if (act(slot)) {
            start(slot, X, sideX);
            start(slot, Y, sideY);
        }
    }

    /** Before {@link WallVisits#leave}. */
    public void leave(int slot) {
        if (act(slot)) {
            state.turning.forget(slot);
        }
    }

    private void start(int slot, int axis, float side) {
        if (!hold(slot, axis)) {
            return;
        }
        float normalImpulse = Walls.wallImpulse(state.traits[CircleRow.of(slot) + WALL_X + axis], side);
        if (acting(slot, axis, normalImpulse) > 0f) {
            take(slot, axis, side);
            rows.warmStart();
            give(slot, axis, side);
        } else {
            ContactRows.clear(state.turning.wallRows, at(slot, axis), ContactRows.OF_WALL);
        }
    }

    /** A visit of the nearer wall of an axis, behind that of its normal impulse; bounce: target speed. */
    void visit(int slot, int axis, float side, OneBody normal, float bounce) {
        float along = along(axis, side, state.motion[CircleRow.of(slot) + VX + other(axis)]);
        take(slot, axis, side);
        if (rows.act()) {
            rows.visit(normal, along, bounce);
            give(slot, axis, side);
        }
    }

    /** How fast the surfaces slide, if they have friction; v: velocity along the wall, spin: surface speed. */
    public float slip(int slot, int axis, float side, float v, float spin) {
        take(slot, axis, side);
        return rows.slip(along(axis, side, v), spin);
    }

    private static int surface(int axis, float side) {
        return KindSurface.ofWall(WallMotion.of(axis, side));
    }

    /** The speed against the wall along the tangent, of a velocity along the wall. */
    private float along(int axis, float side, float v) {
        return Walls.tangentAlong(axis, side) * (v - state.turning.surfaces[surface(axis, side) + KindSurface.BELT]);
    }

    private void take(int slot, int axis, float side) {
        Turning t = state.turning;
        int s = CircleRow.of(slot);
        int own = KindSurface.of(slot);
        rows.between(
                t.circleSurfaces,
                own,
                t.surfaces,
                surface(axis, side),
                t.circleSurfaces[own + KindSurface.BELT],
                t.spin[s + INVERSE_INERTIA],
                state.traits[s + INVERSE_MASS]);
        rows.surfaceSpeed = t.spin[s + SURFACE_SPEED];
        rows.take(t.wallRows, at(slot, axis), ContactRows.OF_WALL);
    }

    private void give(int slot, int axis, float side) {
        int s = CircleRow.of(slot);
        state.turning.spin[s + SURFACE_SPEED] = rows.surfaceSpeed;
        rows.give(state.turning.wallRows, at(slot, axis), ContactRows.OF_WALL);
        rows.pushAtWall(state.motion, s + VX, axis, side);
    }

    private static int other(int axis) {
        return Y - axis;
    }
}
