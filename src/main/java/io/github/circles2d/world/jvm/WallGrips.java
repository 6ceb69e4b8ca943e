package io.github.circles2d.world.jvm;

import static io.github.circles2d.world.model.CircleRow.BELT;
import static io.github.circles2d.world.model.CircleRow.FRICTION;
import static io.github.circles2d.world.model.CircleRow.FRICTION_X;
import static io.github.circles2d.world.model.CircleRow.INVERSE_INERTIA;
import static io.github.circles2d.world.model.CircleRow.INVERSE_MASS;
import static io.github.circles2d.world.model.CircleRow.ROLLING_RESISTANCE;
import static io.github.circles2d.world.model.CircleRow.ROLLING_X;
import static io.github.circles2d.world.model.CircleRow.SURFACE_SPEED;
import static io.github.circles2d.world.model.CircleRow.VX;
import static io.github.circles2d.world.model.CircleRow.WALL_X;
import static io.github.circles2d.world.model.CircleRow.X;
import static io.github.circles2d.world.model.CircleRow.Y;

import io.github.circles2d.world.model.CircleRow;
import io.github.circles2d.world.model.OneBodyGrip;
import io.github.circles2d.world.model.StepConstants;
import io.github.circles2d.world.model.Surface;
import io.github.circles2d.world.model.SurfaceSettings;
import io.github.circles2d.world.model.WallMotion;
import io.github.circles2d.world.model.Walls;

/** What the surfaces of walls do to circles. {@link OneBodyGrip} has the visit. */
final class WallGrips {
    private final State state;
    private final OneBodyGrip grip = new OneBodyGrip();

    WallGrips(State state) {
        this.state = state;
    }

    /** Whether the nearer wall of an axis holds a circle, which a visit may have to take back. */
    boolean hold(int slot, int axis) {
        float[] held = state.turning.wallGrip;
        int s = CircleRow.of(slot);
        return held[s + FRICTION_X + axis] != 0f || held[s + ROLLING_X + axis] != 0f;
    }

    /** The same of both axes. */
    boolean hold(int slot) {
        return hold(slot, X) || hold(slot, Y);
    }

    /** The warm start of both axes. */
    void start(int slot, float sideX, float sideY, StepConstants k) {
        start(slot, X, sideX, k);
        start(slot, Y, sideY, k);
    }

    private void start(int slot, int axis, float side, StepConstants k) {
        if (!hold(slot, axis)) {
            return;
        }
        int s = CircleRow.of(slot);
        if (Walls.wallImpulse(state.traits[s + WALL_X + axis], side) > 0f) {
            take(s, axis, side, k);
            grip.warmStart();
            give(s, axis, side);
        } else {
            state.turning.wallGrip[s + FRICTION_X + axis] = 0f;
            state.turning.wallGrip[s + ROLLING_X + axis] = 0f;
        }
    }

    /** A visit of the nearer wall of an axis, by its normal impulse; keep: whether what acts accumulates. */
    void visit(int slot, int axis, float side, float normalImpulse, boolean keep, StepConstants k) {
        int s = CircleRow.of(slot);
        float along = along(axis, side, state.motion[s + VX + other(axis)], k);
        take(s, axis, side, k);
        if (!grip.acts()) {
            return;
        }
        grip.visit(normalImpulse, along, state.turning.skin[s + BELT], keep);
        give(s, axis, side);
    }

    /** How fast the surfaces slide, if they grip; v: velocity along the wall, spin: surface speed. */
    float slip(int slot, int axis, float side, float v, float spin, StepConstants k) {
        if (!k.turning) {
            return 0f;
        }
        float[] skin = state.turning.skin;
        int s = CircleRow.of(slot);
        float friction = Surface.friction(skin[s + FRICTION], k.surfaces.wallFriction(WallMotion.of(axis, side)));
        return Surface.hitSlip(friction, along(axis, side, v, k), 0f, spin, skin[s + BELT]);
    }

    /** The speed against the wall along the tangent, of a velocity along the wall. */
    private static float along(int axis, float side, float v, StepConstants k) {
        return tangent(axis, side) * (v - k.surfaces.wallBelt(WallMotion.of(axis, side)));
    }

    private void take(int s, int axis, float side, StepConstants k) {
        Turning t = state.turning;
        SurfaceSettings walls = k.surfaces;
        int wall = WallMotion.of(axis, side);
        grip.between(
                t.skin[s + FRICTION],
                walls.wallFriction(wall),
                t.skin[s + ROLLING_RESISTANCE],
                walls.wallRollingResistance(wall),
                t.spin[s + INVERSE_INERTIA] / state.traits[s + INVERSE_MASS]);
        grip.surfaceSpeed = t.spin[s + SURFACE_SPEED];
        grip.friction = t.wallGrip[s + FRICTION_X + axis];
        grip.rolling = t.wallGrip[s + ROLLING_X + axis];
    }

    private void give(int s, int axis, float side) {
        Turning t = state.turning;
        t.spin[s + SURFACE_SPEED] = grip.surfaceSpeed;
        t.wallGrip[s + FRICTION_X + axis] = grip.friction;
        t.wallGrip[s + ROLLING_X + axis] = grip.rolling;
        state.motion[s + VX + other(axis)] += tangent(axis, side) * grip.impulse;
    }

    private static int other(int axis) {
        return Y - axis;
    }

    /** The part of the tangent along a wall. */
    private static float tangent(int axis, float side) {
        return axis == X ? side : -side;
    }
}
