package io.github.circles2d.world.jvm;

import io.github.circles2d.world.model.CircleMath;
import io.github.circles2d.world.model.StepConstants;
import java.util.Arrays;

/** The circles' part of stage Solver: gravity, walls, motion. */
final class CirclePasses {
    private final State state;

    CirclePasses(State state) {
        this.state = state;
    }

    void clear(int from, int to) {
        Arrays.fill(state.load, 4 * from, 4 * to, 0f);
    }

    /** Gravity, the impulses of the sub-step before, and the biased pass over the walls. */
    void accelerate(int from, int to, StepConstants k) {
        float minX = k.bounds.minX();
        float minY = k.bounds.minY();
        float maxX = k.bounds.maxX();
        float maxY = k.bounds.maxY();
        float[] m = state.motion;
        float[] traits = state.traits;
        float[] load = state.load;
        float[] circle = state.circle;
        float[] bounce = state.wallBounce;
        float h = k.h;
        float inverseH = k.inverseH;
        for (int slot = from; slot < to; slot++) {
            int s = 4 * slot;
            float w = traits[s];
            if (w == 0f) {
                load[s] = m[s + 2];
                load[s + 1] = m[s + 3];
                load[s + 2] = 0f;
                continue;
            }
            float wallX = traits[s + 2];
            float wallY = traits[s + 3];
            float vx = m[s + 2] + k.gravityStepX;
            float vy = m[s + 3] + k.gravityStepY;
            float nextX = CircleMath.limitSpeed(vx + w * load[s]);
            float nextY = CircleMath.limitSpeed(vy + w * load[s + 1]);
            m[s + 2] = nextX;
            m[s + 3] = nextY;
            load[s] = vx;
            load[s + 1] = vy;
            float loaded =
                    Branchless.choose(Branchless.isNotZero(wallX) | Branchless.isNotZero(wallY), 1f, load[s + 3]);
            load[s + 2] = loaded;

            float r = circle[s + 2];
            float sideX = side(circle[s], minX, maxX);
            float sideY = side(circle[s + 1], minY, maxY);
            float gapX = gap(circle[s], r, m[s], minX, maxX);
            float gapY = gap(circle[s + 1], r, m[s + 1], minY, maxY);
            int clear = isClear(gapX, sideX * nextX, sideX * vx, h, inverseH)
                    & isClear(gapY, sideY * nextY, sideY * vy, h, inverseH)
                    & ~(Branchless.isNotZero(wallX) | Branchless.isNotZero(wallY));
            if (clear != 0) {
                // adding zeros, as the long way does: the sign of a zero is part of the state
                m[s + 2] = nextX + sideX * 0f;
                m[s + 3] = nextY + sideY * 0f;
                traits[s + 2] = sideX * 0f;
                traits[s + 3] = sideY * 0f;
                bounce[s >> 1] = 0f;
                bounce[(s >> 1) + 1] = 0f;
            } else {
                pushWall(s, 0, minX, maxX, loaded > 0f, k);
                pushWall(s, 1, minY, maxY, loaded > 0f, k);
            }
        }
    }

    /** All bits set where a circle is out of reach of its nearer wall in the biased pass, and stays so. */
    private static int isClear(float gap, float v, float before, float h, float inverseH) {
        return Branchless.isPositive(gap)
                & ~Branchless.isNegative(gap * inverseH + v)
                & ~Branchless.isNegative(gap + before * h);
    }

    /** The biased pass over the nearer wall of an axis: warm start, then as for a contact of effective mass 1. */
    private void pushWall(int s, int axis, float min, float max, boolean loaded, StepConstants k) {
        float[] m = state.motion;
        float[] traits = state.traits;
        float base = state.circle[s + axis];
        float r = state.circle[s + 2];
        float side = CircleMath.wallSide(base, min, max);
        float gap = CircleMath.wallGap(base, m[s + axis], r, side, min, max);
        float lambda = CircleMath.wallImpulse(traits[s + 2 + axis], side);
        float v = m[s + 2 + axis] + side * lambda;
        float vn = side * v;
        float e = traits[s + 1];
        float thr2 = CircleMath.bounceThreshold(2f * r, e, k.thresholdRate, k.restRate);
        float bounce = 0f;
        if (e > 0f && loaded) {
            bounce = CircleMath.bounceSpeed(e, side * state.load[s + axis], gap, k.h, thr2);
        }
        state.wallBounce[(s >> 1) + axis] = bounce;
        float next = lambda;
        float p;
        int visit = e > 0f && !loaded ? CircleMath.freeFlight(vn, gap * k.inverseH + vn < 0f, thr2) : CircleMath.SOLVE;
        if (visit == CircleMath.SOLVE) {
            if (bounce > 0f) {
                next = CircleMath.rigid(lambda, 1f, vn, -bounce);
            } else if (gap > 0f) {
                next = CircleMath.rigid(lambda, 1f, vn, gap * k.inverseH);
            } else {
                float push = CircleMath.pushSpeed(2f * r, k.pushPerLength, k.pushPerRoot);
                next = CircleMath.soft(lambda, 1f, vn, gap, push, k.wallBiasRate, k.wallMassScale, k.wallImpulseScale);
            }
            p = next - lambda;
        } else {
            p = visit == CircleMath.BOUNCE ? CircleMath.freeBounce(e, vn, 1f) : 0f;
            m[s + axis] -= CircleMath.leftBehind(gap, vn, side * p, k.dt, r);
        }
        m[s + 2 + axis] = v + side * p;
        traits[s + 2 + axis] = side * next;
    }

    /** Moves the circles, keeps them within the walls, and makes the relaxing pass over the walls. */
    void move(int from, int to, StepConstants k, boolean first) {
        float[] m = state.motion;
        float[] traits = state.traits;
        float[] circle = state.circle;
        float[] load = state.load;
        float[] leash = state.leash;
        float[] bounce = state.wallBounce;
        float minX = k.bounds.minX();
        float minY = k.bounds.minY();
        float maxX = k.bounds.maxX();
        float maxY = k.bounds.maxY();
        for (int slot = from; slot < to; slot++) {
            int s = 4 * slot;
            float w = traits[s];
            m[s + 2] = CircleMath.limitSpeed(m[s + 2]);
            m[s + 3] = CircleMath.limitSpeed(m[s + 3]);
            float dx = m[s] + m[s + 2] * k.h;
            float dy = m[s + 1] + m[s + 3] * k.h;
            float r = circle[s + 2];
            if (w != 0f && dx * dx + dy * dy > 0f) {
                float allowance = leash[s + 2];
                if (dx * dx + dy * dy > allowance * allowance) {
                    float share = CircleMath.nearest(dx, dy, leash[s], leash[s + 1]);
                    float offX = dx - share * leash[s];
                    float offY = dy - share * leash[s + 1];
                    float off = CircleMath.norm(offX, offY);
                    if (off > allowance) {
                        float keep = allowance / off;
                        dx = share * leash[s] + keep * offX;
                        dy = share * leash[s + 1] + keep * offY;
                    }
                }
            }
            float margin = w == 0f ? 0f : r;
            m[s] = CircleMath.within(circle[s], dx, minX + margin, maxX - margin);
            m[s + 1] = CircleMath.within(circle[s + 1], dy, minY + margin, maxY - margin);
            if (w == 0f) {
                // a fixed circle that is stopped has stopped: what lies on it must not see it go on
                m[s + 2] = m[s] == dx ? m[s + 2] : 0f;
                m[s + 3] = m[s + 1] == dy ? m[s + 3] : 0f;
            }
            boolean loaded = load[s + 2] > 0f;
            load[s] = 0f;
            load[s + 1] = 0f;
            load[s + 3] = 0f;
            if (first) {
                state.memory[slot] = -1;
                state.fresh[slot] = false;
            }
            int clear = Branchless.isPositive(gap(circle[s], r, m[s], minX, maxX))
                    & Branchless.isPositive(gap(circle[s + 1], r, m[s + 1], minY, maxY));
            int pressed = Branchless.isNotZero(traits[s + 2])
                    | Branchless.isNotZero(traits[s + 3])
                    | Branchless.isNotZero(bounce[s >> 1])
                    | Branchless.isNotZero(bounce[(s >> 1) + 1]);
            if ((clear & ~pressed) == 0 && w != 0f) {
                relaxWall(s, 0, minX, maxX, loaded, k);
                relaxWall(s, 1, minY, maxY, loaded, k);
            }
        }
    }

    /** {@link CircleMath#wallSide} of the nearer wall of an axis. */
    private static float side(float base, float min, float max) {
        return Branchless.signOf((max - base) - (base - min));
    }

    /** {@link CircleMath#wallGap} of the nearer wall of an axis. */
    private static float gap(float base, float r, float displacement, float min, float max) {
        return (Math.min(base - min, max - base) - r) + side(base, min, max) * displacement;
    }

    /** The relaxing pass over the nearer wall of an axis. */
    private void relaxWall(int s, int axis, float min, float max, boolean loaded, StepConstants k) {
        float[] m = state.motion;
        float[] traits = state.traits;
        float base = state.circle[s + axis];
        float r = state.circle[s + 2];
        float side = CircleMath.wallSide(base, min, max);
        float gap = CircleMath.wallGap(base, m[s + axis], r, side, min, max);
        float lambda = CircleMath.wallImpulse(traits[s + 2 + axis], side);
        float bounce = state.wallBounce[(s >> 1) + axis];
        if (lambda == 0f && bounce == 0f && gap > 0f) {
            return;
        }
        float v = m[s + 2 + axis];
        float vn = side * v;
        float e = traits[s + 1];
        int visit = CircleMath.SOLVE;
        if (lambda == 0f && bounce == 0f && e > 0f && !loaded) {
            visit = CircleMath.freeFlight(vn, true, CircleMath.bounceThreshold(2f * r, e, k.thresholdRate, k.restRate));
        }
        if (visit == CircleMath.SOLVE) {
            float b = bounce > 0f ? -bounce : gap > 0f ? gap * k.inverseH : 0f;
            float next = CircleMath.rigid(lambda, 1f, vn, b);
            m[s + 2 + axis] = v + side * (next - lambda);
            traits[s + 2 + axis] = bounce > 0f ? 0f : side * next;
        } else if (visit == CircleMath.BOUNCE) {
            m[s + 2 + axis] = v + side * CircleMath.freeBounce(e, vn, 1f);
        }
    }

    /** Ends the step: the base takes the displacement, the displacement what that lost. */
    void finish(int from, int to, StepConstants k) {
        float[] m = state.motion;
        float[] circle = state.circle;
        float minX = k.bounds.minX();
        float minY = k.bounds.minY();
        float maxX = k.bounds.maxX();
        float maxY = k.bounds.maxY();
        for (int slot = from; slot < to; slot++) {
            int s = 4 * slot;
            float margin = state.traits[s] == 0f ? 0f : circle[s + 2];
            float x = circle[s] + m[s];
            float y = circle[s + 1] + m[s + 1];
            float keptX = CircleMath.bounded(x, minX + margin, maxX - margin);
            float keptY = CircleMath.bounded(y, minY + margin, maxY - margin);
            m[s] = keptX == x ? CircleMath.lostByRounding(circle[s], m[s], x) : 0f;
            m[s + 1] = keptY == y ? CircleMath.lostByRounding(circle[s + 1], m[s + 1], y) : 0f;
            circle[s] = keptX;
            circle[s + 1] = keptY;
            m[s + 2] = CircleMath.limitSpeed(m[s + 2]);
            m[s + 3] = CircleMath.limitSpeed(m[s + 3]);
        }
    }
}
