package io.github.circles2d.world;

/**
 * Stage Solver: moves the circles through one step of a number of sub-steps.
 *
 * <p>Soft contacts with warm starting, one biased and one relaxing pass over the contacts a sub-step (after E. Catto,
 * "Solver2D", 2024), with restitution inside the sub-step. See the package's documentation for the order. The contacts are
 * here, the circles in {@link JvmMover}.
 *
 * <p>Which contacts press and which have a gap is as good as random: the passes decide it without branches where they can
 * ({@link Branchless}), and leave branches to what is rare.
 */
final class JvmSolver {
    private static final int STRIDE = JvmContacts.STRIDE;

    private final JvmState state;
    private final JvmContacts contacts;
    private final Levels levels;
    private final Team team;
    private final JvmMover mover;

    JvmSolver(JvmState state, JvmContacts contacts, Levels levels, Team team) {
        this.state = state;
        this.contacts = contacts;
        this.levels = levels;
        this.team = team;
        mover = new JvmMover(state);
    }

    /** Fills the contacts, and measures them for the first sub-step. */
    void prepare(int worker, StepConstants k) {
        mover.clear(team.part(state.n, worker), team.part(state.n, worker + 1));
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
            mover.accelerate(from, to, k);
            team.sync(worker);
            for (int l = 0; l < levels.usedCount; l++) {
                for (int colour = 0; colour < 4; colour++) {
                    push(worker, levels.used[l], colour, k);
                    team.sync(worker);
                }
            }
            mover.move(from, to, k, sub == 0);
            team.sync(worker);
            for (int l = 0; l < levels.usedCount; l++) {
                for (int colour = 0; colour < 4; colour++) {
                    relax(worker, levels.used[l], colour, k, last);
                    team.sync(worker);
                }
            }
        }
        mover.finish(from, to, k);
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
        int end = shareGroup(level, colour, worker + 1);
        int group = shareGroup(level, colour, worker);
        while (group < end) {
            int next = Math.min(end, group + JvmContacts.TOGETHER);
            contacts.fillGroups(worker, group, next, k);
            for (int c = contacts.start[group]; c < contacts.start[next]; c++) {
                prepareContact(c, k);
            }
            group = next;
        }
    }

    private void prepareContact(int c, StepConstants k) {
        measure(c);
        float[] q = contacts.contact;
        float[] m = state.motion;
        int o = STRIDE * c;
        int i = contacts.pair[2 * c];
        int j = contacts.pair[2 * c + 1];
        float nx = q[o + JvmContacts.NX];
        float ny = q[o + JvmContacts.NY];
        float lambda = q[o + JvmContacts.LAMBDA];
        float vn = CircleMath.along(nx, ny, m[j + 2] - m[i + 2], m[j + 3] - m[i + 3]);
        boolean carries = CircleMath.carries(lambda, q[o + JvmContacts.S], vn, q[o + JvmContacts.THRESHOLD]);
        gather(i, j, nx, ny, lambda, carries);
    }

    /** Measures a contact: separation, and the normal where there is a direction. */
    private void measure(int c) {
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
        q[o + JvmContacts.S] = d - sum;
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
            float lambda = q[o + JvmContacts.LAMBDA];
            float thr2 = q[o + JvmContacts.THRESHOLD];
            float mass = q[o + JvmContacts.MASS];
            float vn = CircleMath.along(nx, ny, m[j + 2] - m[i + 2], m[j + 3] - m[i + 3]);
            float bounce = 0f;
            int visit = CircleMath.SOLVE;
            if (e > 0f) {
                if (load[i + 2] + load[j + 2] > 0f) {
                    float before = CircleMath.along(nx, ny, load[j] - load[i], load[j + 1] - load[i + 1]);
                    bounce = CircleMath.bounceSpeed(e, before, s, k.h, thr2);
                } else if (lambda == 0f) {
                    visit = CircleMath.freeFlight(vn, s * k.inverseH + vn < 0f, thr2);
                }
            }
            q[o + JvmContacts.BOUNCE] = bounce;
            float p;
            if (visit == CircleMath.SOLVE) {
                float next;
                if (bounce > 0f) {
                    next = CircleMath.rigid(lambda, mass, vn, -bounce);
                } else {
                    // CircleMath.rigid where there is a gap, else CircleMath.soft, of which it is the case of scales 1
                    // and 0
                    int gap = Branchless.isPositive(s);
                    float massScale = Branchless.choose(gap, 1f, k.massScale);
                    float impulseScale = Branchless.choose(gap, 0f, k.impulseScale);
                    float soft = k.massScale * CircleMath.greatest(k.biasRate * s, -q[o + JvmContacts.PUSH]);
                    float b = Branchless.choose(gap, s * k.inverseH, soft);
                    next = Branchless.positive((lambda - mass * (massScale * vn + b)) - impulseScale * lambda);
                }
                p = next - lambda;
                q[o + JvmContacts.LAMBDA] = next;
            } else if (visit == CircleMath.BOUNCE) {
                p = CircleMath.freeBounce(e, vn, mass);
            } else {
                continue;
            }
            apply(i, j, nx, ny, q[o + JvmContacts.W_LO], q[o + JvmContacts.W_HI], p);
        }
    }

    private void apply(int i, int j, float nx, float ny, float wi, float wj, float p) {
        float[] m = state.motion;
        m[i + 2] -= nx * (wi * p);
        m[i + 3] -= ny * (wi * p);
        m[j + 2] += nx * (wj * p);
        m[j + 3] += ny * (wj * p);
    }

    /** The relaxing pass: measures the contacts anew, takes the push-out speed away again, and sums up for what follows. */
    private void relax(int worker, int level, int colour, StepConstants k, boolean last) {
        int from = share(level, colour, worker);
        int to = share(level, colour, worker + 1);
        // in a loop of its own: nothing here waits for the contact before
        for (int c = from; c < to; c++) {
            measure(c);
        }
        float[] q = contacts.contact;
        int[] pair = contacts.pair;
        float[] m = state.motion;
        float[] load = state.load;
        for (int c = from; c < to; c++) {
            int o = STRIDE * c;
            float s = q[o + JvmContacts.S];
            float bounce = q[o + JvmContacts.BOUNCE];
            float lambda = q[o + JvmContacts.LAMBDA];
            if (lambda == 0f && s > 0f && bounce == 0f) {
                continue;
            }
            int i = pair[2 * c];
            int j = pair[2 * c + 1];
            float nx = q[o + JvmContacts.NX];
            float ny = q[o + JvmContacts.NY];
            float e = q[o + JvmContacts.E];
            float thr2 = q[o + JvmContacts.THRESHOLD];
            float wi = q[o + JvmContacts.W_LO];
            float wj = q[o + JvmContacts.W_HI];
            float mass = q[o + JvmContacts.MASS];
            float vn = CircleMath.along(nx, ny, m[j + 2] - m[i + 2], m[j + 3] - m[i + 3]);
            if (e > 0f && lambda == 0f && bounce == 0f && load[i + 2] + load[j + 2] == 0f) {
                int visit = CircleMath.freeFlight(vn, true, thr2);
                if (visit == CircleMath.BOUNCE) {
                    apply(i, j, nx, ny, wi, wj, CircleMath.freeBounce(e, vn, mass));
                }
                if (visit != CircleMath.SOLVE) {
                    continue;
                }
            }
            float next;
            if (bounce > 0f) {
                next = CircleMath.rigid(lambda, mass, vn, -bounce);
            } else {
                float b = Branchless.choose(Branchless.isPositive(s), s * k.inverseH, 0f);
                next = Branchless.positive(lambda - mass * (vn + b));
            }
            float p = next - lambda;
            apply(i, j, nx, ny, wi, wj, p);
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
}
