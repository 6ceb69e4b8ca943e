package io.github.circles2d.world.jvm.pieces;

import static io.github.circles2d.world.model.CircleRow.BEFORE_X;
import static io.github.circles2d.world.model.CircleRow.DX;
import static io.github.circles2d.world.model.CircleRow.LOADED;
import static io.github.circles2d.world.model.CircleRow.RADIUS;
import static io.github.circles2d.world.model.CircleRow.RESTITUTION;
import static io.github.circles2d.world.model.CircleRow.SURFACE_SPEED;
import static io.github.circles2d.world.model.CircleRow.VX;
import static io.github.circles2d.world.model.CircleRow.VY;
import static io.github.circles2d.world.model.CircleRow.WALL_X;
import static io.github.circles2d.world.model.CircleRow.WALL_Y;
import static io.github.circles2d.world.model.CircleRow.X;
import static io.github.circles2d.world.model.CircleRow.Y;

import io.github.circles2d.world.jvm.state.State;
import io.github.circles2d.world.model.Bounce;
import io.github.circles2d.world.model.CircleRow;
import io.github.circles2d.world.model.Constraints;
import io.github.circles2d.world.model.OneBody;
import io.github.circles2d.world.model.StepConstants;
import io.github.circles2d.world.model.WallMotion;
import io.github.circles2d.world.model.Walls;

/** The visits of walls: of each axis, a circle visits the nearer one. {@link OneBody} has the visit. */
public final class WallVisits {
    private final State state;
    private final OneBody visit = new OneBody();
    public final WallRows rows;

    /** What is told of visits; null if they are not recorded. */
    public WallTouches touches;

    public WallVisits(State state) {
        this.state = state;
        rows = new WallRows(state);
    }

    /** As {@link #solve}, of a circle that stays clear of both walls: their impulses and bounces end. */
    public void leave(int slot, float sideX, float sideY) {
        int s = CircleRow.of(slot);
        // adding zeros, as solve does: the sign of a zero is part of the state
        state.motion[s + VX] += sideX * 0f;
        state.motion[s + VY] += sideY * 0f;
        state.traits[s + WALL_X] = sideX * 0f;
        state.traits[s + WALL_Y] = sideY * 0f;
        state.wallBounce[CircleRow.vector(slot) + X] = 0f;
        state.wallBounce[CircleRow.vector(slot) + Y] = 0f;
    }

    /**
     * The biased pass over the nearer wall of an axis: warm start, then a visit. A wall that moves is where it will be at the end of
     * the sub-step; the visit is made in its frame, by where it is now.
     */
    public void solve(int slot, int axis, float min, float max, StepConstants k, int sub) {
        int s = CircleRow.of(slot);
        float[] m = state.motion;
        float[] traits = state.traits;
        float base = state.circle[s + X + axis];
        float r = state.circle[s + RADIUS];
        float side = Walls.wallSide(base, min, max);
        int wall = WallMotion.of(axis, side);
        float ahead = Walls.wallGap(base, m[s + DX + axis], r, side, min, max) + k.walls.behind(wall, sub);
        float impulse = Walls.wallImpulse(traits[s + WALL_X + axis], side);
        float v = m[s + VX + axis] + side * impulse;
        float before = side * state.load[s + BEFORE_X + axis];
        if (Constraints.staysClear(ahead, impulse, side * v, before, k.h, k.inverseH) != 0) {
            m[s + VX + axis] = v;
            traits[s + WALL_X + axis] = side * impulse;
            state.wallBounce[CircleRow.vector(slot) + axis] = 0f;
            return;
        }
        float gap = ahead + k.walls.sweepFor(wall, r);
        float speed = k.walls.speedFor(wall, r);
        float vn = side * v - speed;
        visit.solve(
                gap,
                r,
                traits[s + RESTITUTION],
                thresholdRate(axis, k),
                state.load[s + LOADED],
                before - speed,
                vn,
                impulse,
                k);
        if (visit.bounced) {
            m[s + DX + axis] -= Bounce.leftBehind(gap, vn, side * visit.impulse, k.dt, r);
        }
        state.wallBounce[CircleRow.vector(slot) + axis] = visit.bounceSpeed;
        m[s + VX + axis] = v + side * visit.impulse;
        traits[s + WALL_X + axis] = side * visit.normalImpulse;
        if (visit.bounced && k.turning) {
            rows.visit(slot, axis, side, visit, visit.bounceSpeed);
        }
    }

    /** The relaxing pass over the nearer wall of an axis. */
    public void relax(int slot, int axis, float min, float max, StepConstants k, int sub) {
        int s = CircleRow.of(slot);
        float[] m = state.motion;
        float[] traits = state.traits;
        float base = state.circle[s + X + axis];
        float r = state.circle[s + RADIUS];
        float side = Walls.wallSide(base, min, max);
        int wall = WallMotion.of(axis, side);
        float gap = Walls.wallGap(base, m[s + DX + axis], r, side, min, max) + k.walls.behind(wall, sub);
        float impulse = Walls.wallImpulse(traits[s + WALL_X + axis], side);
        float bounce = state.wallBounce[CircleRow.vector(slot) + axis];
        if (Constraints.isIdle(gap, impulse, bounce) != 0 && !(k.turning && rows.hold(slot, axis))) {
            return;
        }
        float v = m[s + VX + axis];
        float vn = side * v - k.walls.speedFor(wall, r);
        float slip = touches == null || !k.turning
                ? 0f
                : rows.slip(slot, axis, side, m[s + VX + Y - axis], state.turning.spin[s + SURFACE_SPEED]);
        visit.relax(
                gap,
                r,
                traits[s + RESTITUTION],
                thresholdRate(axis, k),
                state.load[s + LOADED],
                bounce,
                vn,
                impulse,
                k);
        if (!visit.leaves) {
            m[s + VX + axis] = v + side * visit.impulse;
            // the impulse of a bounce is not kept; the sign of its zero is part of the state
            traits[s + WALL_X + axis] = bounce > 0f ? 0f : side * visit.normalImpulse;
        }
        if (k.turning) {
            rows.visit(slot, axis, side, visit, bounce);
        }
        if (touches != null) {
            touches.relaxed(slot, axis, side, v, gap, slip, k);
        }
    }

    private static float thresholdRate(int axis, StepConstants k) {
        return axis == X ? k.thresholdRateX : k.thresholdRateY;
    }
}
