package io.github.circles2d.world;

/**
 * Stage Solver: moves the circles through one step of a number of sub-steps.
 *
 * <p>Soft contacts with warm starting, one biased and one relaxing pass over the contacts a sub-step (after E. Catto,
 * "Solver2D", 2024), with restitution inside the sub-step. See the package's documentation for the order.
 */
final class JvmSolver {
    private static final int STRIDE = JvmContacts.STRIDE;

    private final JvmState state;
    private final JvmContacts contacts;
    private final Levels levels;
    private final Team team;

    JvmSolver(JvmState state, JvmContacts contacts, Levels levels, Team team) {
        this.state = state;
        this.contacts = contacts;
        this.levels = levels;
        this.team = team;
    }

    /** Fills the contacts, and measures them for the first sub-step. */
    void prepare(int worker, StepConstants k) {
        clear(team.part(state.n, worker), team.part(state.n, worker + 1));
        team.sync(worker);
        for (int l = 0; l < levels.usedCount; l++) {
            for (int colour = 0; colour < 4; colour++) {
                prepare(worker, levels.used[l], colour, k);
                team.sync(worker);
            }
        }
    }

    void solve(int worker, StepConstants k) {
        int from = team.part(state.n, worker);
        int to = team.part(state.n, worker + 1);
        for (int sub = 0; sub < k.subSteps; sub++) {
            boolean last = sub == k.subSteps - 1;
            accelerate(from, to, k);
            team.sync(worker);
            for (int l = 0; l < levels.usedCount; l++) {
                for (int colour = 0; colour < 4; colour++) {
                    push(worker, levels.used[l], colour, k);
                    team.sync(worker);
                }
            }
            move(from, to, k, sub == 0);
            team.sync(worker);
            for (int l = 0; l < levels.usedCount; l++) {
                for (int colour = 0; colour < 4; colour++) {
                    relax(worker, levels.used[l], colour, k, last);
                    team.sync(worker);
                }
            }
        }
        finish(from, to, k);
        team.sync(worker);
    }

    // ---- contacts
    // ----------------------------------------------------------------------------------------------------

    /** First contact of a worker's share of a colour: shares begin where a group begins. */
    private int share(int level, int colour, int worker) {
        return contacts.start[shareGroup(level, colour, worker)];
    }

    private int shareGroup(int level, int colour, int worker) {
        int low = levels.firstOfColour(level, colour);
        int high = levels.firstOfColour(level, colour + 1);
        if (worker == 0) {
            return low;
        }
        if (worker == team.size()) {
            return high;
        }
        int[] start = contacts.start;
        int target = start[low] + team.part(start[high] - start[low], worker);
        while (low < high) {
            int middle = (low + high) >>> 1;
            if (start[middle] < target) {
                low = middle + 1;
            } else {
                high = middle;
            }
        }
        return low;
    }

    private void prepare(int worker, int level, int colour, StepConstants k) {
        int groupEnd = shareGroup(level, colour, worker + 1);
        for (int group = shareGroup(level, colour, worker); group < groupEnd; group++) {
            if (contacts.start[group] < contacts.start[group + 1]) {
                contacts.fillGroup(worker, group, k);
                for (int c = contacts.start[group]; c < contacts.start[group + 1]; c++) {
                    prepareContact(c, k);
                }
            }
        }
    }

    private void prepareContact(int c, StepConstants k) {
        float[] q = contacts.contact;
        float[] m = state.motion;
        int o = STRIDE * c;
        int i = contacts.pair[2 * c];
        int j = contacts.pair[2 * c + 1];
        float dx = CircleMath.difference(q[o + JvmContacts.EX], m[i], m[j]);
        float dy = CircleMath.difference(q[o + JvmContacts.EY], m[i + 1], m[j + 1]);
        float d = CircleMath.norm(dx, dy);
        float sum = q[o + JvmContacts.SUM];
        if (d > Tuning.COINCIDENT * sum) {
            q[o + JvmContacts.NX] = dx / d;
            q[o + JvmContacts.NY] = dy / d;
        }
        float nx = q[o + JvmContacts.NX];
        float ny = q[o + JvmContacts.NY];
        float s = d - sum;
        q[o + JvmContacts.S] = s;
        float vn = CircleMath.along(nx, ny, m[j + 2] - m[i + 2], m[j + 3] - m[i + 3]);
        float lambda = q[o + JvmContacts.LAMBDA];
        gather(i, j, nx, ny, lambda, CircleMath.carries(lambda, s, vn, k.thresholdRate * sum));
    }

    /** Adds a contact's impulse to the sums of its circles, and marks them as loaded where it carries. */
    private void gather(int i, int j, float nx, float ny, float lambda, boolean carries) {
        float[] load = state.load;
        load[i] -= nx * lambda;
        load[i + 1] -= ny * lambda;
        load[j] += nx * lambda;
        load[j + 1] += ny * lambda;
        if (carries) {
            load[i + 3] = 1f;
            load[j + 3] = 1f;
        }
    }

    /** The biased pass: stops approaches, pushes overlaps out, bounces. */
    private void push(int worker, int level, int colour, StepConstants k) {
        int from = share(level, colour, worker);
        int to = share(level, colour, worker + 1);
        float[] q = contacts.contact;
        int[] pair = contacts.pair;
        float[] m = state.motion;
        float[] load = state.load;
        for (int c = from; c < to; c++) {
            int o = STRIDE * c;
            int i = pair[2 * c];
            int j = pair[2 * c + 1];
            float nx = q[o + JvmContacts.NX];
            float ny = q[o + JvmContacts.NY];
            float s = q[o + JvmContacts.S];
            float e = q[o + JvmContacts.E];
            float wi = q[o + JvmContacts.W_LO];
            float wj = q[o + JvmContacts.W_HI];
            float lambda = q[o + JvmContacts.LAMBDA];
            float thr2 = k.thresholdRate * q[o + JvmContacts.SUM];
            float mass = 1f / (wi + wj);
            float vn = CircleMath.along(nx, ny, m[j + 2] - m[i + 2], m[j + 3] - m[i + 3]);
            float bounce = 0f;
            float p;
            boolean loaded = load[i + 2] + load[j + 2] > 0f;
            if (e > 0f && loaded) {
                float before = CircleMath.along(nx, ny, load[j] - load[i], load[j + 1] - load[i + 1]);
                bounce = CircleMath.bounceSpeed(e, before, s, k.h, thr2);
            }
            q[o + JvmContacts.BOUNCE] = bounce;
            int visit = CircleMath.SOLVE;
            if (e > 0f && !loaded && lambda == 0f) {
                visit = CircleMath.freeFlight(vn, s * k.inverseH + vn < 0f, thr2);
            }
            if (visit == CircleMath.LEAVE) {
                continue;
            }
            if (visit == CircleMath.BOUNCE) {
                p = CircleMath.freeBounce(e, vn, mass);
            } else {
                float next;
                if (bounce > 0f) {
                    next = CircleMath.rigid(lambda, mass, vn, -bounce);
                } else if (s > 0f) {
                    next = CircleMath.rigid(lambda, mass, vn, s * k.inverseH);
                } else {
                    next = CircleMath.soft(
                            lambda, mass, vn, s, q[o + JvmContacts.PUSH], k.biasRate, k.massScale, k.impulseScale);
                }
                p = next - lambda;
                q[o + JvmContacts.LAMBDA] = next;
            }
            m[i + 2] -= nx * (wi * p);
            m[i + 3] -= ny * (wi * p);
            m[j + 2] += nx * (wj * p);
            m[j + 3] += ny * (wj * p);
        }
    }

    /** The relaxing pass: measures the contacts anew, takes the push-out speed away again, and sums up for what follows. */
    private void relax(int worker, int level, int colour, StepConstants k, boolean last) {
        int from = share(level, colour, worker);
        int to = share(level, colour, worker + 1);
        float[] q = contacts.contact;
        int[] pair = contacts.pair;
        float[] m = state.motion;
        float[] load = state.load;
        for (int c = from; c < to; c++) {
            int o = STRIDE * c;
            int i = pair[2 * c];
            int j = pair[2 * c + 1];
            float nx = q[o + JvmContacts.NX];
            float ny = q[o + JvmContacts.NY];
            float e = q[o + JvmContacts.E];
            float sum = q[o + JvmContacts.SUM];
            float bounce = q[o + JvmContacts.BOUNCE];
            float lambda = q[o + JvmContacts.LAMBDA];
            float dx = CircleMath.difference(q[o + JvmContacts.EX], m[i], m[j]);
            float dy = CircleMath.difference(q[o + JvmContacts.EY], m[i + 1], m[j + 1]);
            float d = CircleMath.norm(dx, dy);
            if (d > Tuning.COINCIDENT * sum) {
                nx = dx / d;
                ny = dy / d;
            }
            float s = d - sum;
            q[o + JvmContacts.NX] = nx;
            q[o + JvmContacts.NY] = ny;
            q[o + JvmContacts.S] = s;
            float vn = CircleMath.along(nx, ny, m[j + 2] - m[i + 2], m[j + 3] - m[i + 3]);
            float thr2 = k.thresholdRate * sum;
            int visit = CircleMath.SOLVE;
            if (lambda == 0f && bounce == 0f) {
                if (s > 0f) {
                    continue;
                }
                if (e > 0f && load[i + 2] + load[j + 2] == 0f) {
                    visit = CircleMath.freeFlight(vn, true, thr2);
                    if (visit == CircleMath.LEAVE) {
                        continue;
                    }
                }
            }
            float wi = q[o + JvmContacts.W_LO];
            float wj = q[o + JvmContacts.W_HI];
            float mass = 1f / (wi + wj);
            if (visit == CircleMath.BOUNCE) {
                float p = CircleMath.freeBounce(e, vn, mass);
                m[i + 2] -= nx * (wi * p);
                m[i + 3] -= ny * (wi * p);
                m[j + 2] += nx * (wj * p);
                m[j + 3] += ny * (wj * p);
                continue;
            }
            float b = bounce > 0f ? -bounce : s > 0f ? s * k.inverseH : 0f;
            float next = CircleMath.rigid(lambda, mass, vn, b);
            float p = next - lambda;
            m[i + 2] -= nx * (wi * p);
            m[i + 3] -= ny * (wi * p);
            m[j + 2] += nx * (wj * p);
            m[j + 3] += ny * (wj * p);
            if (bounce > 0f) {
                next = 0f;
            }
            q[o + JvmContacts.LAMBDA] = next;
            if (last) {
                if (next > 0f) {
                    contacts.remember(c, next);
                }
            } else if (CircleMath.carries(next, s, vn + p * (wi + wj), thr2)) {
                gather(i, j, nx, ny, next, true);
            }
        }
    }

    // ---- circles
    // -----------------------------------------------------------------------------------------------------

    private void clear(int from, int to) {
        java.util.Arrays.fill(state.load, 4 * from, 4 * to, 0f);
    }

    /** Gravity, the impulses of the sub-step before, and the biased pass over the walls. */
    private void accelerate(int from, int to, StepConstants k) {
        float[] m = state.motion;
        float[] traits = state.traits;
        float[] load = state.load;
        for (int slot = from; slot < to; slot++) {
            int s = 4 * slot;
            float w = traits[s];
            if (w == 0f) {
                load[s] = m[s + 2];
                load[s + 1] = m[s + 3];
                load[s + 2] = 0f;
                continue;
            }
            boolean loaded = load[s + 3] > 0f || traits[s + 2] != 0f || traits[s + 3] != 0f;
            float vx = m[s + 2] + k.gravityStepX;
            float vy = m[s + 3] + k.gravityStepY;
            m[s + 2] = CircleMath.limitSpeed(vx + w * load[s]);
            m[s + 3] = CircleMath.limitSpeed(vy + w * load[s + 1]);
            load[s] = vx;
            load[s + 1] = vy;
            load[s + 2] = loaded ? 1f : 0f;
            pushWall(s, 0, k.bounds.minX(), k.bounds.maxX(), loaded, k);
            pushWall(s, 1, k.bounds.minY(), k.bounds.maxY(), loaded, k);
        }
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
        float thr2 = k.thresholdRate * (2f * r);
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
        }
        m[s + 2 + axis] = v + side * p;
        traits[s + 2 + axis] = side * next;
    }

    /** Moves the circles, keeps them within the walls, and makes the relaxing pass over the walls. */
    private void move(int from, int to, StepConstants k, boolean first) {
        float[] m = state.motion;
        float[] traits = state.traits;
        float[] circle = state.circle;
        float[] load = state.load;
        float[] leash = state.leash;
        Bounds bounds = k.bounds;
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
            m[s] = CircleMath.within(circle[s], dx, bounds.minX() + margin, bounds.maxX() - margin);
            m[s + 1] = CircleMath.within(circle[s + 1], dy, bounds.minY() + margin, bounds.maxY() - margin);
            boolean loaded = load[s + 2] > 0f;
            load[s] = 0f;
            load[s + 1] = 0f;
            load[s + 3] = 0f;
            if (first) {
                state.memory[slot] = -1;
                state.fresh[slot] = false;
            }
            if (w != 0f) {
                relaxWall(s, 0, bounds.minX(), bounds.maxX(), loaded, k);
                relaxWall(s, 1, bounds.minY(), bounds.maxY(), loaded, k);
            }
        }
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
            visit = CircleMath.freeFlight(vn, true, k.thresholdRate * (2f * r));
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
    private void finish(int from, int to, StepConstants k) {
        float[] m = state.motion;
        float[] circle = state.circle;
        Bounds bounds = k.bounds;
        for (int slot = from; slot < to; slot++) {
            int s = 4 * slot;
            float margin = state.traits[s] == 0f ? 0f : circle[s + 2];
            float x = circle[s] + m[s];
            float y = circle[s + 1] + m[s + 1];
            float keptX = CircleMath.bounded(x, bounds.minX() + margin, bounds.maxX() - margin);
            float keptY = CircleMath.bounded(y, bounds.minY() + margin, bounds.maxY() - margin);
            m[s] = keptX == x ? CircleMath.lostByRounding(circle[s], m[s], x) : 0f;
            m[s + 1] = keptY == y ? CircleMath.lostByRounding(circle[s + 1], m[s + 1], y) : 0f;
            circle[s] = keptX;
            circle[s + 1] = keptY;
            m[s + 2] = CircleMath.limitSpeed(m[s + 2]);
            m[s + 3] = CircleMath.limitSpeed(m[s + 3]);
        }
    }
}
