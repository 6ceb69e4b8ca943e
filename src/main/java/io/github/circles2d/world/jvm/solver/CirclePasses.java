package io.github.circles2d.world.jvm.solver;

import static io.github.circles2d.world.model.CircleRow.ALLOWANCE;
import static io.github.circles2d.world.model.CircleRow.BEFORE_X;
import static io.github.circles2d.world.model.CircleRow.BEFORE_Y;
import static io.github.circles2d.world.model.CircleRow.DX;
import static io.github.circles2d.world.model.CircleRow.DY;
import static io.github.circles2d.world.model.CircleRow.IMPULSE_X;
import static io.github.circles2d.world.model.CircleRow.IMPULSE_Y;
import static io.github.circles2d.world.model.CircleRow.INVERSE_MASS;
import static io.github.circles2d.world.model.CircleRow.LIMIT;
import static io.github.circles2d.world.model.CircleRow.LOADED;
import static io.github.circles2d.world.model.CircleRow.LOADED_NEXT;
import static io.github.circles2d.world.model.CircleRow.PATH_X;
import static io.github.circles2d.world.model.CircleRow.PATH_Y;
import static io.github.circles2d.world.model.CircleRow.RADIUS;
import static io.github.circles2d.world.model.CircleRow.VX;
import static io.github.circles2d.world.model.CircleRow.VY;
import static io.github.circles2d.world.model.CircleRow.WALL_X;
import static io.github.circles2d.world.model.CircleRow.WALL_Y;
import static io.github.circles2d.world.model.CircleRow.X;
import static io.github.circles2d.world.model.CircleRow.Y;

import io.github.circles2d.world.jvm.pieces.PieceTouches;
import io.github.circles2d.world.jvm.pieces.PieceVisits;
import io.github.circles2d.world.jvm.pieces.WallVisits;
import io.github.circles2d.world.jvm.state.State;
import io.github.circles2d.world.jvm.state.Turning;
import io.github.circles2d.world.model.Bounds;
import io.github.circles2d.world.model.Branchless;
import io.github.circles2d.world.model.CircleMath;
import io.github.circles2d.world.model.CircleRow;
import io.github.circles2d.world.model.Constraints;
import io.github.circles2d.world.model.Paths;
import io.github.circles2d.world.model.StepConstants;
import io.github.circles2d.world.model.TerrainStep;
import io.github.circles2d.world.model.Tuning;
import io.github.circles2d.world.model.Velocity;
import io.github.circles2d.world.model.WallMotion;
import io.github.circles2d.world.model.Walls;
import java.util.Arrays;

/** The circles' part of stage Solver: gravity, motion, and when a circle visits walls. Each worker has its own. */
final class CirclePasses {
    private final State state;
    final WallVisits walls;

    /** Null in a step without terrain. */
    private PieceVisits pieces;

    /** What is told of visits of pieces; null if they are not recorded. */
    PieceTouches pieceTouches;

    CirclePasses(State state) {
        this.state = state;
        walls = new WallVisits(state);
    }

    /** Begins a step with terrain, or with none. */
    void beginTerrain(TerrainStep terrain, StepConstants k) {
        if (!k.terrain) {
            pieces = null;
        } else {
            pieces = pieces == null ? new PieceVisits(state) : pieces;
            pieces.begin(terrain, k);
            pieces.touches = pieceTouches;
        }
    }

    void begin(int from, int to, StepConstants k) {
        Arrays.fill(state.load, CircleRow.of(from), CircleRow.of(to), 0f);
        if (state.sleepers != null) {
            state.sleepers.noteStarts(from, to);
        }
        if (k.turning) {
            state.turning.begin(from, to);
        }
        for (int slot = from; slot < to; slot++) {
            state.room[slot] = room(slot, k);
        }
    }

    private float room(int slot, StepConstants k) {
        int s = CircleRow.of(slot);
        boolean away = !k.walls.any()
                && state.traits[s + WALL_X] == 0f
                && state.traits[s + WALL_Y] == 0f
                && !(pieces != null && pieces.any(slot))
                && !(k.turning && walls.rows.hold(slot));
        float x = state.circle[s + X];
        float y = state.circle[s + Y];
        float roomX = CircleMath.min(x - k.bounds.minX(), k.bounds.maxX() - x);
        float roomY = CircleMath.min(y - k.bounds.minY(), k.bounds.maxY() - y);
        return away ? CircleMath.max(CircleMath.min(roomX, roomY) - state.circle[s + RADIUS], 0f) : 0f;
    }

    /** Gravity, the impulses of the sub-step before, and the biased pass over the walls. */
    void integrateVelocities(int from, int to, StepConstants k, int sub) {
        float minX = k.bounds.minX();
        float minY = k.bounds.minY();
        float maxX = k.bounds.maxX();
        float maxY = k.bounds.maxY();
        float[] m = state.motion;
        float[] traits = state.traits;
        float[] load = state.load;
        float[] circle = state.circle;
        float[] room = state.room;
        Turning turning = k.turning ? state.turning : null;
        float h = k.h;
        float inverseH = k.inverseH;
        for (int slot = from; slot < to; slot++) {
            int s = CircleRow.of(slot);
            float w = traits[s + INVERSE_MASS];
            if (w == 0f) {
                load[s + BEFORE_X] = m[s + VX];
                load[s + BEFORE_Y] = m[s + VY];
                load[s + LOADED] = 0f;
                if (turning != null) {
                    turning.startStatic(slot);
                }
                continue;
            }
            float wallX = traits[s + WALL_X];
            float wallY = traits[s + WALL_Y];
            float vx = m[s + VX] + k.gravityStepX;
            float vy = m[s + VY] + k.gravityStepY;
            if (state.kindMotion != null) {
                int row = state.motionRow(slot);
                float factor = state.dampingFactor(slot, row, k);
                vx = Velocity.beforeImpulse(m[s + VX], state.gainX(slot, k), factor);
                vy = Velocity.beforeImpulse(m[s + VY], state.gainY(slot, k), factor);
                float share = Velocity.shareWithin(vx, vy, state.greatestSpeed(slot, row));
                vx = share * vx;
                vy = share * vy;
            }
            float nextX = Velocity.limitSpeed(vx + w * load[s + IMPULSE_X]);
            float nextY = Velocity.limitSpeed(vy + w * load[s + IMPULSE_Y]);
            m[s + VX] = nextX;
            m[s + VY] = nextY;
            load[s + BEFORE_X] = vx;
            load[s + BEFORE_Y] = vy;
            float way = Math.abs(m[s + DX])
                    + Math.abs(m[s + DY])
                    + h * ((Math.abs(nextX) + Math.abs(nextY)) + (Math.abs(vx) + Math.abs(vy)));
            if (2f * way < room[slot]) {
                // nearly all circles: whatever the rounding, walls do nothing
                load[s + LOADED] = load[s + LOADED_NEXT];
                if (turning != null) {
                    turning.start(slot, k);
                }
                // as the next time, but for a zero as a velocity
                if (sub == 0 || nextX == 0f || nextY == 0f) {
                    walls.leave(
                            slot, Walls.wallSide(circle[s + X], minX, maxX), Walls.wallSide(circle[s + Y], minY, maxY));
                }
                continue;
            }
            room[slot] = 0f;
            boolean near = pieces != null && pieces.any(slot);
            float actingX = turning == null ? wallX : walls.rows.acting(slot, X, Math.abs(wallX));
            float actingY = turning == null ? wallY : walls.rows.acting(slot, Y, Math.abs(wallY));
            load[s + LOADED] = Branchless.choose(
                    Branchless.isNotZero(actingX) | Branchless.isNotZero(actingY), 1f, load[s + LOADED_NEXT]);
            if (near && pieces.act(slot)) {
                load[s + LOADED] = 1f;
            }

            float r = circle[s + RADIUS];
            float sideX = Walls.wallSide(circle[s + X], minX, maxX);
            float sideY = Walls.wallSide(circle[s + Y], minY, maxY);
            float impulseX = Walls.wallImpulse(wallX, sideX);
            float impulseY = Walls.wallImpulse(wallY, sideY);
            if (turning != null) {
                turning.start(slot, k);
                walls.rows.start(slot, sideX, sideY);
                nextX = m[s + VX];
                nextY = m[s + VY];
                impulseX = walls.rows.acting(slot, X, impulseX);
                impulseY = walls.rows.acting(slot, Y, impulseY);
            }
            float gapX = Walls.wallGap(circle[s + X], m[s + DX], r, sideX, minX, maxX);
            float gapY = Walls.wallGap(circle[s + Y], m[s + DY], r, sideY, minY, maxY);
            int clear = Constraints.staysClear(gapX, impulseX, sideX * nextX, sideX * vx, h, inverseH)
                    & Constraints.staysClear(gapY, impulseY, sideY * nextY, sideY * vy, h, inverseH);
            if (clear != 0) {
                if (turning != null) {
                    walls.rows.leave(slot);
                }
                walls.leave(slot, sideX, sideY);
            } else {
                walls.solve(slot, X, minX, maxX, k, sub);
                // the friction of each wall acts along the other axis
                float gainedX = m[s + VX] - nextX;
                nextY = m[s + VY];
                walls.solve(slot, Y, minY, maxY, k, sub);
                if (walls.touches != null) {
                    float spin = turning == null ? 0f : turning.before(slot);
                    float slipX = turning == null ? 0f : walls.rows.slip(slot, X, sideX, vy, spin);
                    float slipY = turning == null ? 0f : walls.rows.slip(slot, Y, sideY, vx, spin);
                    walls.touches.solved(slot, X, sideX, vx, gainedX, gapX, slipX, k, sub);
                    walls.touches.solved(slot, Y, sideY, vy, m[s + VY] - nextY, gapY, slipY, k, sub);
                }
            }
            if (near) {
                pieces.solve(slot, k, sub);
            }
        }
    }

    /** Moves the circles, keeps them within the walls, and makes the relaxing pass over the walls. */
    void integratePositions(int from, int to, StepConstants k, int sub) {
        float[] m = state.motion;
        float[] traits = state.traits;
        float[] circle = state.circle;
        float[] load = state.load;
        float[] clamp = state.motionClamp;
        float[] room = state.room;
        float minX = k.bounds.minX();
        float minY = k.bounds.minY();
        float maxX = k.bounds.maxX();
        float maxY = k.bounds.maxY();
        boolean still = !k.walls.any();
        Turning turning = k.turning ? state.turning : null;
        if (sub == 0 && from < to) {
            Arrays.fill(state.firstCached, from, to, -1);
            Arrays.fill(state.fresh, from, to, false);
        }
        for (int slot = from; slot < to; slot++) {
            int s = CircleRow.of(slot);
            float w = traits[s + INVERSE_MASS];
            m[s + VX] = Velocity.limitSpeed(m[s + VX]);
            m[s + VY] = Velocity.limitSpeed(m[s + VY]);
            float dx = m[s + DX] + m[s + VX] * k.h;
            float dy = m[s + DY] + m[s + VY] * k.h;
            float allowance = clamp[s + ALLOWANCE];
            load[s + IMPULSE_X] = 0f;
            load[s + IMPULSE_Y] = 0f;
            load[s + LOADED_NEXT] = 0f;
            if (turning != null) {
                turning.move(slot);
            }
            float r = circle[s + RADIUS];
            boolean away = room[slot] > 0f;
            boolean near = !away && pieces != null && pieces.any(slot);
            float fromX = m[s + DX];
            float fromY = m[s + DY];
            if (w != 0f && !(dx * dx + dy * dy <= allowance * Math.abs(allowance))) {
                clampMotion(s, dx, dy);
                dx = m[s + DX];
                dy = m[s + DY];
            }
            // nearly all circles: walls would change nothing
            if (still
                    && w != 0f
                    && isClear(circle[s + X], dx, r, minX, maxX)
                    && isClear(circle[s + Y], dy, r, minY, maxY)
                    && (away || isFree(slot, turning))) {
                m[s + DX] = dx;
                m[s + DY] = dy;
                if (near) {
                    moveBesidePieces(slot, fromX, fromY, k, sub);
                }
                continue;
            }
            room[slot] = 0f;
            float margin = state.margin(s);
            m[s + DX] = CircleMath.within(circle[s + X], dx, minX + margin, maxX - margin);
            m[s + DY] = CircleMath.within(circle[s + Y], dy, minY + margin, maxY - margin);
            if (w == 0f) {
                // circles that lie on a static one must not see it move on when the bounds have stopped it
                m[s + VX] = m[s + DX] == dx ? m[s + VX] : 0f;
                m[s + VY] = m[s + DY] == dy ? m[s + VY] : 0f;
            } else {
                if (k.walls.any()) {
                    m[s + DX] = keepInside(circle[s + X], dx, m[s + DX], margin, X, minX, maxX, k, sub);
                    m[s + DY] = keepInside(circle[s + Y], dy, m[s + DY], margin, Y, minY, maxY, k, sub);
                }
                m[s + VX] = Walls.stopAtFarWall(m[s + VX], dx, m[s + DX], Walls.wallSide(circle[s + X], minX, maxX));
                m[s + VY] = Walls.stopAtFarWall(m[s + VY], dy, m[s + DY], Walls.wallSide(circle[s + Y], minY, maxY));
                if (near) {
                    pieces.move(slot, fromX, fromY, sub);
                }
                walls.relax(slot, X, minX, maxX, k, sub);
                walls.relax(slot, Y, minY, maxY, k, sub);
                if (near) {
                    pieces.relax(slot, k, sub);
                }
            }
        }
    }

    /** The move and the relaxing pass of a circle that is clear of walls until pieces move it. */
    private void moveBesidePieces(int slot, float fromX, float fromY, StepConstants k, int sub) {
        pieces.move(slot, fromX, fromY, sub);
        int s = CircleRow.of(slot);
        float r = state.circle[s + RADIUS];
        float minX = k.bounds.minX();
        float minY = k.bounds.minY();
        float maxX = k.bounds.maxX();
        float maxY = k.bounds.maxY();
        if (!isClear(state.circle[s + X], state.motion[s + DX], r, minX, maxX)
                || !isClear(state.circle[s + Y], state.motion[s + DY], r, minY, maxY)) {
            walls.relax(slot, X, minX, maxX, k, sub);
            walls.relax(slot, Y, minY, maxY, k, sub);
        }
        pieces.relax(slot, k, sub);
    }

    /** Whether walls have left a circle alone. */
    private boolean isFree(int slot, Turning turning) {
        int s = CircleRow.of(slot);
        return state.traits[s + WALL_X] == 0f
                && state.traits[s + WALL_Y] == 0f
                && state.wallBounce[CircleRow.vector(slot) + X] == 0f
                && state.wallBounce[CircleRow.vector(slot) + Y] == 0f
                && !(turning != null && walls.rows.hold(slot));
    }

    /** Whether a circle has a gap to both walls of an axis, neither of which cuts its displacement. */
    private static boolean isClear(float base, float d, float r, float min, float max) {
        return Walls.wallGap(base, d, r, 1f, min, max) > 0f
                && Walls.wallGap(base, d, r, -1f, min, max) > 0f
                && base + d >= min + r
                && base + d <= max - r;
    }

    /** A displacement that walls have cut as if they were at the end of their way: cut where they are in fact. */
    private static float keepInside(
            float base, float d, float kept, float r, int axis, float min, float max, StepConstants k, int sub) {
        return kept == d
                ? kept
                : CircleMath.within(
                        base,
                        d,
                        (min - k.walls.behind(WallMotion.of(axis, 1f), sub)) + r,
                        (max + k.walls.behind(WallMotion.of(axis, -1f), sub)) - r);
    }

    /** Sets a circle's displacement, no farther from the free part of its path than it is allowed. */
    private void clampMotion(int s, float dx, float dy) {
        float pathX = state.motionClamp[s + PATH_X];
        float pathY = state.motionClamp[s + PATH_Y];
        float allowance = state.motionClamp[s + ALLOWANCE];
        if (allowance == Tuning.CARRIED) {
            state.motion[s + DX] = pathX;
            state.motion[s + DY] = pathY;
        } else if (allowance < 0f) {
            float limit = state.motionClamp[s + LIMIT];
            float along = Paths.alongPath(dx, dy, pathX, pathY);
            float x = along > limit ? dx - (along - limit) * pathX : dx;
            float y = along > limit ? dy - (along - limit) * pathY : dy;
            float share = CircleMath.min(Paths.nearest(x, y, pathX, pathY), limit);
            setWithin(s, share * pathX, share * pathY, x, y, along > 0f ? -Tuning.ASIDE * allowance : -allowance);
        } else {
            float share = Paths.nearest(dx, dy, pathX, pathY);
            setWithin(s, share * pathX, share * pathY, dx, dy, allowance);
        }
    }

    /** Sets a circle's displacement, brought as near to a place as is allowed. */
    private void setWithin(int s, float x, float y, float dx, float dy, float allowance) {
        float offX = dx - x;
        float offY = dy - y;
        float off = CircleMath.length(offX, offY);
        boolean within = !(off > allowance);
        float keep = within ? 1f : allowance / off;
        state.motion[s + DX] = within ? dx : x + keep * offX;
        state.motion[s + DY] = within ? dy : y + keep * offY;
    }

    /** Ends the step: the base takes the displacement, the displacement what that lost. */
    void finalizePositions(int from, int to, StepConstants k) {
        float[] m = state.motion;
        float[] circle = state.circle;
        float minX = k.bounds.minX();
        float minY = k.bounds.minY();
        float maxX = k.bounds.maxX();
        float maxY = k.bounds.maxY();
        if (state.sleepers != null) {
            state.sleepers.noteMoves(from, to);
        }
        for (int slot = from; slot < to; slot++) {
            int s = CircleRow.of(slot);
            float margin = state.margin(s);
            float x = circle[s + X] + m[s + DX];
            float y = circle[s + Y] + m[s + DY];
            float keptX = CircleMath.clamp(x, minX + margin, maxX - margin);
            float keptY = CircleMath.clamp(y, minY + margin, maxY - margin);
            m[s + DX] = keptX == x ? CircleMath.lostByRounding(circle[s + X], m[s + DX], x) : 0f;
            m[s + DY] = keptY == y ? CircleMath.lostByRounding(circle[s + Y], m[s + DY], y) : 0f;
            circle[s + X] = keptX;
            circle[s + Y] = keptY;
            m[s + VX] = Velocity.limitSpeed(m[s + VX]);
            m[s + VY] = Velocity.limitSpeed(m[s + VY]);
        }
        if (k.turning) {
            state.turning.end(from, to, k);
        }
        if (state.wraps) {
            bringInside(from, to, k.arena);
        }
    }

    /** Brings circles that have crossed the edge of an axis that wraps to the other side. */
    private void bringInside(int from, int to, Bounds b) {
        for (int slot = from; slot < to; slot++) {
            int s = CircleRow.of(slot);
            bringInside(s + X, s + DX, b.minX(), b.lastX(), state.periodX);
            bringInside(s + Y, s + DY, b.minY(), b.lastY(), state.periodY);
        }
    }

    private void bringInside(int at, int atDisplacement, float min, float last, float period) {
        float x = state.circle[at];
        float laps = CircleMath.laps(x, min, period);
        if (laps != 0f) {
            float away = -(laps * period);
            float near = x + away;
            float rest = state.motion[atDisplacement] + CircleMath.lostByRounding(x, away, near);
            float sum = near + rest;
            float inside = CircleMath.clamp(sum, min, last);
            state.motion[atDisplacement] = inside == sum ? CircleMath.lostByRounding(near, rest, sum) : 0f;
            state.circle[at] = inside;
        }
    }
}
