package io.github.circles2d.world.jvm;

import io.github.circles2d.world.model.CircleMath;
import io.github.circles2d.world.model.StepConstants;
import io.github.circles2d.world.model.Tuning;

/**
 * The contacts' part of stage Solver: what a pass does to a range of contacts, one after the other.
 *
 * <p>Which contacts press and which have a gap is as good as random: the passes decide it without branches where they can
 * ({@link Branchless}), and leave branches to what is rare.
 */
final class ContactPasses {
    private static final int STRIDE = Contacts.STRIDE;

    /** Contacts that the relaxing pass works on at a time. */
    private static final int BLOCK = 256;

    private final State state;
    private final Contacts contacts;

    /** Contacts of a block that are still to do something with. */
    private final int[] listed = new int[BLOCK];

    ContactPasses(State state, Contacts contacts) {
        this.state = state;
        this.contacts = contacts;
    }

    /** Measures contacts for the first sub-step, and adds their impulses to the sums of their circles. */
    void prepare(int from, int to) {
        for (int c = from; c < to; c++) {
            prepareContact(c);
        }
    }

    private void prepareContact(int c) {
        measure(c);
        float[] q = contacts.contact;
        float[] m = state.motion;
        int o = STRIDE * c;
        int i = contacts.pair[2 * c];
        int j = contacts.pair[2 * c + 1];
        float nx = q[o + Contacts.NX];
        float ny = q[o + Contacts.NY];
        float lambda = q[o + Contacts.LAMBDA];
        float vn = CircleMath.along(nx, ny, m[j + 2] - m[i + 2], m[j + 3] - m[i + 3]);
        boolean carries = CircleMath.carries(lambda, q[o + Contacts.S], vn, q[o + Contacts.THRESHOLD]);
        gather(i, j, nx, ny, lambda, carries);
    }

    /** Measures a contact: separation, and the normal where there is a direction. */
    private void measure(int c) {
        float[] q = contacts.contact;
        float[] m = state.motion;
        int o = STRIDE * c;
        int i = contacts.pair[2 * c];
        int j = contacts.pair[2 * c + 1];
        float dx = CircleMath.difference(q[o + Contacts.EX], m[i], m[j]);
        float dy = CircleMath.difference(q[o + Contacts.EY], m[i + 1], m[j + 1]);
        float d = CircleMath.norm(dx, dy);
        float sum = q[o + Contacts.SUM];
        if (d > Tuning.COINCIDENT * sum) {
            q[o + Contacts.NX] = dx / d;
            q[o + Contacts.NY] = dy / d;
        }
        q[o + Contacts.S] = d - sum;
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
    void push(int from, int to, StepConstants k) {
        float[] q = contacts.contact;
        int[] pair = contacts.pair;
        float[] m = state.motion;
        float[] load = state.load;
        for (int c = from; c < to; c++) {
            int o = STRIDE * c;
            int i = pair[2 * c];
            int j = pair[2 * c + 1];
            float nx = q[o + Contacts.NX];
            float ny = q[o + Contacts.NY];
            float s = q[o + Contacts.S];
            float e = q[o + Contacts.E];
            float lambda = q[o + Contacts.LAMBDA];
            float thr2 = q[o + Contacts.THRESHOLD];
            float mass = q[o + Contacts.MASS];
            float vn = CircleMath.along(nx, ny, m[j + 2] - m[i + 2], m[j + 3] - m[i + 3]);
            float bounce = 0f;
            int visit = CircleMath.SOLVE;
            if (e > 0f) {
                int loaded = Branchless.isPositive(load[i + 2] + load[j + 2]);
                float before = CircleMath.along(nx, ny, load[j] - load[i], load[j + 1] - load[i + 1]);
                // most contacts neither bounce nor part: two branches that are seldom taken
                int fast = Branchless.isPositive(vn * vn - thr2) & ~loaded;
                int strikes = Branchless.isPositive(before * before - thr2) & loaded & Branchless.isNegative(before);
                if (strikes != 0) {
                    bounce = CircleMath.bounceSpeed(e, before, s, k.h, thr2);
                }
                if (fast != 0 && lambda == 0f) {
                    visit = CircleMath.freeFlight(vn, s * k.inverseH + vn < 0f, thr2);
                }
            }
            q[o + Contacts.BOUNCE] = bounce;
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
                    float soft = k.massScale * CircleMath.greatest(k.biasRate * s, -q[o + Contacts.PUSH]);
                    float b = Branchless.choose(gap, s * k.inverseH, soft);
                    next = Branchless.positive((lambda - mass * (massScale * vn + b)) - impulseScale * lambda);
                }
                p = next - lambda;
                q[o + Contacts.LAMBDA] = next;
            } else if (visit == CircleMath.BOUNCE) {
                p = CircleMath.freeBounce(e, vn, mass);
            } else {
                continue;
            }
            apply(i, j, nx, ny, q[o + Contacts.W_LO], q[o + Contacts.W_HI], p);
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
    void relax(int from, int to, StepConstants k, boolean last) {
        for (int block = from; block < to; block += BLOCK) {
            int open = measureAll(block, Math.min(to, block + BLOCK));
            int carrying = relaxOpen(open, k, last);
            if (last) {
                remember(carrying);
            } else {
                gather(carrying);
            }
        }
    }

    /** Measures contacts, and lists those that the relaxing pass has to do with; returns their number. */
    private int measureAll(int from, int to) {
        float[] q = contacts.contact;
        int open = 0;
        for (int c = from; c < to; c++) {
            measure(c);
            int o = STRIDE * c;
            listed[open] = c;
            // not those that have a gap and no impulse, and do not bounce
            int idle = Branchless.isPositive(q[o + Contacts.S])
                    & ~Branchless.isPositive(q[o + Contacts.LAMBDA])
                    & ~Branchless.isPositive(q[o + Contacts.BOUNCE]);
            open += 1 + idle;
        }
        return open;
    }

    /** Relaxes the contacts that are listed, and lists those of them that carry; in the last sub-step, those that press. */
    private int relaxOpen(int open, StepConstants k, boolean last) {
        float[] q = contacts.contact;
        int[] pair = contacts.pair;
        float[] m = state.motion;
        float[] load = state.load;
        int touching = last ? 0 : -1;
        int carrying = 0;
        for (int n = 0; n < open; n++) {
            int c = listed[n];
            int o = STRIDE * c;
            int i = pair[2 * c];
            int j = pair[2 * c + 1];
            float s = q[o + Contacts.S];
            float bounce = q[o + Contacts.BOUNCE];
            float lambda = q[o + Contacts.LAMBDA];
            float nx = q[o + Contacts.NX];
            float ny = q[o + Contacts.NY];
            float e = q[o + Contacts.E];
            float thr2 = q[o + Contacts.THRESHOLD];
            float wi = q[o + Contacts.W_LO];
            float wj = q[o + Contacts.W_HI];
            float mass = q[o + Contacts.MASS];
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
            q[o + Contacts.LAMBDA] = next;
            // CircleMath.carries
            float after = vn + p * (wi + wj);
            int rests = Branchless.isNegative(s) & ~Branchless.isPositive(after * after - thr2);
            listed[carrying] = c;
            carrying -= Branchless.isPositive(next) | rests & touching;
        }
        return carrying;
    }

    private void gather(int carrying) {
        float[] q = contacts.contact;
        int[] pair = contacts.pair;
        for (int n = 0; n < carrying; n++) {
            int c = listed[n];
            int o = STRIDE * c;
            float lambda = q[o + Contacts.LAMBDA];
            gather(pair[2 * c], pair[2 * c + 1], q[o + Contacts.NX], q[o + Contacts.NY], lambda, true);
        }
    }

    private void remember(int pressing) {
        for (int n = 0; n < pressing; n++) {
            contacts.remember(listed[n], contacts.contact[STRIDE * listed[n] + Contacts.LAMBDA]);
        }
    }
}
