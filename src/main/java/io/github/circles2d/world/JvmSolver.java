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

    void solve(int worker, StepConstants k) {
        int from = team.part(state.n, worker);
        int to = team.part(state.n, worker + 1);
        clear(from, to);
        team.sync(worker);
        for (int l = 0; l < levels.usedCount; l++) {
            for (int colour = 0; colour < 4; colour++) {
                prepare(worker, levels.used[l], colour, k);
                team.sync(worker);
            }
        }
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

    /** Fills the contacts of a colour, and measures them for the first sub-step. */
    private void prepare(int worker, int level, int colour, StepConstants k) {
        int groupEnd = shareGroup(level, colour, worker + 1);
        for (int group = shareGroup(level, colour, worker); group < groupEnd; group++) {
            if (contacts.start[group] < contacts.start[group + 1]) {
                contacts.fillGroup(group, k);
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
            if (e > 0f && !loaded && lambda == 0f && CircleMath.separates(vn, thr2)) {
                continue;
            }
            if (e > 0f && !loaded && lambda == 0f && CircleMath.approaches(vn, thr2) && s * k.inverseH + vn < 0f) {
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
            if (lambda == 0f && bounce == 0f) {
                if (s > 0f) {
                    continue;
                }
                if (e > 0f && load[i + 2] + load[j + 2] == 0f) {
                    if (CircleMath.separates(vn, thr2)) {
                        continue;
                    }
                    if (CircleMath.approaches(vn, thr2)) {
                        float wi = q[o + JvmContacts.W_LO];
                        float wj = q[o + JvmContacts.W_HI];
                        float p = CircleMath.freeBounce(e, vn, 1f / (wi + wj));
                        m[i + 2] -= nx * (wi * p);
                        m[i + 3] -= ny * (wi * p);
                        m[j + 2] += nx * (wj * p);
                        m[j + 3] += ny * (wj * p);
                        continue;
                    }
                }
            }
            float wi = q[o + JvmContacts.W_LO];
            float wj = q[o + JvmContacts.W_HI];
            float mass = 1f / (wi + wj);
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
        float[] circle = state.circle;
        float[] load = state.load;
        Bounds bounds = k.bounds;
        for (int slot = from; slot < to; slot++) {
            int s = 4 * slot;
            float w = traits[s];
            float vx = m[s + 2];
            float vy = m[s + 3];
            if (w == 0f) {
                load[s] = vx;
                load[s + 1] = vy;
                load[s + 2] = 0f;
                continue;
            }
            vx += k.gravityStepX;
            vy += k.gravityStepY;
            float wallX = traits[s + 2];
            float wallY = traits[s + 3];
            boolean loaded = load[s + 3] > 0f || wallX != 0f || wallY != 0f;
            float e = traits[s + 1];
            float r = circle[s + 2];
            float thr2 = k.thresholdRate * (2f * r);
            float push = CircleMath.pushSpeed(2f * r, k.pushPerLength, k.pushPerRoot);
            float nextX = vx + w * load[s];
            float nextY = vy + w * load[s + 1];

            // x axis
            {
                float side = CircleMath.wallSide(circle[s], bounds.minX(), bounds.maxX());
                float gap = CircleMath.wallGap(circle[s], m[s], r, side, bounds.minX(), bounds.maxX());
                float lambda = CircleMath.wallImpulse(wallX, side);
                float bounce = e > 0f && loaded ? CircleMath.bounceSpeed(e, side * vx, gap, k.h, thr2) : 0f;
                nextX += side * lambda;
                float vn = side * nextX;
                float p;
                if (e > 0f && !loaded && CircleMath.separates(vn, thr2)) {
                    p = 0f;
                } else if (e > 0f && !loaded && CircleMath.approaches(vn, thr2) && gap * k.inverseH + vn < 0f) {
                    p = CircleMath.freeBounce(e, vn, 1f);
                } else {
                    float next = bounce > 0f
                            ? CircleMath.rigid(lambda, 1f, vn, -bounce)
                            : gap > 0f
                                    ? CircleMath.rigid(lambda, 1f, vn, gap * k.inverseH)
                                    : CircleMath.soft(
                                            lambda,
                                            1f,
                                            vn,
                                            gap,
                                            push,
                                            k.wallBiasRate,
                                            k.wallMassScale,
                                            k.wallImpulseScale);
                    p = next - lambda;
                    lambda = next;
                }
                nextX += side * p;
                traits[s + 2] = side * lambda;
                state.wallBounce[2 * slot] = bounce;
            }
            // y axis
            {
                float side = CircleMath.wallSide(circle[s + 1], bounds.minY(), bounds.maxY());
                float gap = CircleMath.wallGap(circle[s + 1], m[s + 1], r, side, bounds.minY(), bounds.maxY());
                float lambda = CircleMath.wallImpulse(wallY, side);
                float bounce = e > 0f && loaded ? CircleMath.bounceSpeed(e, side * vy, gap, k.h, thr2) : 0f;
                nextY += side * lambda;
                float vn = side * nextY;
                float p;
                if (e > 0f && !loaded && CircleMath.separates(vn, thr2)) {
                    p = 0f;
                } else if (e > 0f && !loaded && CircleMath.approaches(vn, thr2) && gap * k.inverseH + vn < 0f) {
                    p = CircleMath.freeBounce(e, vn, 1f);
                } else {
                    float next = bounce > 0f
                            ? CircleMath.rigid(lambda, 1f, vn, -bounce)
                            : gap > 0f
                                    ? CircleMath.rigid(lambda, 1f, vn, gap * k.inverseH)
                                    : CircleMath.soft(
                                            lambda,
                                            1f,
                                            vn,
                                            gap,
                                            push,
                                            k.wallBiasRate,
                                            k.wallMassScale,
                                            k.wallImpulseScale);
                    p = next - lambda;
                    lambda = next;
                }
                nextY += side * p;
                traits[s + 3] = side * lambda;
                state.wallBounce[2 * slot + 1] = bounce;
            }
            load[s] = vx;
            load[s + 1] = vy;
            load[s + 2] = loaded ? 1f : 0f;
            m[s + 2] = CircleMath.bounded(nextX, -Tuning.GREATEST_SPEED, Tuning.GREATEST_SPEED);
            m[s + 3] = CircleMath.bounded(nextY, -Tuning.GREATEST_SPEED, Tuning.GREATEST_SPEED);
        }
    }

    /** Moves the circles, keeps them within the walls, and makes the relaxing pass over the walls. */
    private void move(int from, int to, StepConstants k, boolean first) {
        float[] m = state.motion;
        float[] traits = state.traits;
        float[] circle = state.circle;
        float[] load = state.load;
        Bounds bounds = k.bounds;
        for (int slot = from; slot < to; slot++) {
            int s = 4 * slot;
            float w = traits[s];
            float vx = CircleMath.bounded(m[s + 2], -Tuning.GREATEST_SPEED, Tuning.GREATEST_SPEED);
            float vy = CircleMath.bounded(m[s + 3], -Tuning.GREATEST_SPEED, Tuning.GREATEST_SPEED);
            float dx = m[s] + vx * k.h;
            float dy = m[s + 1] + vy * k.h;
            float margin = w == 0f ? 0f : circle[s + 2];
            dx = CircleMath.within(circle[s], dx, bounds.minX() + margin, bounds.maxX() - margin);
            dy = CircleMath.within(circle[s + 1], dy, bounds.minY() + margin, bounds.maxY() - margin);
            m[s] = dx;
            m[s + 1] = dy;
            boolean loaded = load[s + 2] > 0f;
            load[s] = 0f;
            load[s + 1] = 0f;
            load[s + 3] = 0f;
            if (first) {
                state.memory[slot] = -1;
                state.fresh[slot] = false;
            }
            if (w != 0f) {
                float e = traits[s + 1];
                float r = circle[s + 2];
                float thr2 = k.thresholdRate * (2f * r);
                float side = CircleMath.wallSide(circle[s], bounds.minX(), bounds.maxX());
                float gap = CircleMath.wallGap(circle[s], dx, r, side, bounds.minX(), bounds.maxX());
                float lambda = CircleMath.wallImpulse(traits[s + 2], side);
                float bounce = state.wallBounce[2 * slot];
                float vn = side * vx;
                if (lambda != 0f || bounce != 0f || gap <= 0f) {
                    boolean free = lambda == 0f && bounce == 0f && e > 0f && !loaded;
                    if (free && CircleMath.separates(vn, thr2)) {
                        // leaves by itself
                    } else if (free && CircleMath.approaches(vn, thr2)) {
                        vx += side * CircleMath.freeBounce(e, vn, 1f);
                    } else {
                        float b = bounce > 0f ? -bounce : gap > 0f ? gap * k.inverseH : 0f;
                        float next = CircleMath.rigid(lambda, 1f, vn, b);
                        vx += side * (next - lambda);
                        traits[s + 2] = bounce > 0f ? 0f : side * next;
                    }
                }
                side = CircleMath.wallSide(circle[s + 1], bounds.minY(), bounds.maxY());
                gap = CircleMath.wallGap(circle[s + 1], dy, r, side, bounds.minY(), bounds.maxY());
                lambda = CircleMath.wallImpulse(traits[s + 3], side);
                bounce = state.wallBounce[2 * slot + 1];
                vn = side * vy;
                if (lambda != 0f || bounce != 0f || gap <= 0f) {
                    boolean free = lambda == 0f && bounce == 0f && e > 0f && !loaded;
                    if (free && CircleMath.separates(vn, thr2)) {
                        // leaves by itself
                    } else if (free && CircleMath.approaches(vn, thr2)) {
                        vy += side * CircleMath.freeBounce(e, vn, 1f);
                    } else {
                        float b = bounce > 0f ? -bounce : gap > 0f ? gap * k.inverseH : 0f;
                        float next = CircleMath.rigid(lambda, 1f, vn, b);
                        vy += side * (next - lambda);
                        traits[s + 3] = bounce > 0f ? 0f : side * next;
                    }
                }
            }
            m[s + 2] = vx;
            m[s + 3] = vy;
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
            m[s + 2] = CircleMath.bounded(m[s + 2], -Tuning.GREATEST_SPEED, Tuning.GREATEST_SPEED);
            m[s + 3] = CircleMath.bounded(m[s + 3], -Tuning.GREATEST_SPEED, Tuning.GREATEST_SPEED);
        }
    }
}
