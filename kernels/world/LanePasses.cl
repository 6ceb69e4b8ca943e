// The passes over bundles of contacts (LaneContacts.cl): what solver_push and solver_relax do to one contact after the other.
// Lane by lane the bits are those of pushImpulse, relaxImpulse and applyImpulse in Solver.cl.

typedef struct {
    float4 x, y;
} FourVelocities;

global float *velocityOf(const World *w, int slot) { return (global float *) (w->motion + slot) + 2; }

FourVelocities takeVelocities(const World *w, int4 at) {
    float2 a = vload2(0, velocityOf(w, at.x)), b = vload2(0, velocityOf(w, at.y));
    float2 c = vload2(0, velocityOf(w, at.z)), d = vload2(0, velocityOf(w, at.w));
    FourVelocities v;
    v.x = (float4)(a.x, b.x, c.x, d.x);
    v.y = (float4)(a.y, b.y, c.y, d.y);
    return v;
}

// As give does it.
void giveVelocities(const World *w, int4 i, int4 j, float4 xi, float4 yi, float4 xj, float4 yj) {
    vstore2((float2)(xi.w, yi.w), 0, velocityOf(w, i.w));
    vstore2((float2)(xj.w, yj.w), 0, velocityOf(w, j.w));
    vstore2((float2)(xi.z, yi.z), 0, velocityOf(w, i.z));
    vstore2((float2)(xj.z, yj.z), 0, velocityOf(w, j.z));
    vstore2((float2)(xi.y, yi.y), 0, velocityOf(w, i.y));
    vstore2((float2)(xj.y, yj.y), 0, velocityOf(w, j.y));
    vstore2((float2)(xi.x, yi.x), 0, velocityOf(w, i.x));
    vstore2((float2)(xj.x, yj.x), 0, velocityOf(w, j.x));
}

// The biased pass over a bundle.
void pushBundle(const World *w, int bundle) {
    const StepConstants *k = &w->k;
    int4 i = pairOf(w, bundle)[0];
    int4 j = pairOf(w, bundle)[1];
    global const float4 *base = baseOf(w, bundle);
    global float4 *masses = massesOf(w, bundle);
    global float4 *contact = stateOf(w, bundle);
    global const float4 *shape = shapeOf(w, bundle);
    FourVelocities vi = takeVelocities(w, i);
    FourVelocities vj = takeVelocities(w, j);
    Four li = take(w->load, i);
    Four lj = take(w->load, j);
    float4 nx = contact[0], ny = contact[1], s = contact[2], lambda = contact[3];
    float4 e = base[3], mass = shape[0], thr2 = shape[1];
    float4 zero = (float4)(0.0f);
    float4 vn = along4(nx, ny, vj.x - vi.x, vj.y - vi.y);
    int4 loaded = li.z + lj.z > 0.0f;
    int4 elastic = e > 0.0f;

    // bounceSpeed
    float4 before = along4(nx, ny, lj.x - li.x, lj.y - li.y);
    int4 strikes = elastic & loaded & (before < 0.0f) & (before * before > thr2) & (s + before * k->h < 0.0f);
    float4 bounce = choose4(strikes, -e * before, zero);

    // freeFlight
    int4 flies = elastic & ~loaded & (vn * vn > thr2) & (lambda == 0.0f);
    int4 leaves = flies & (vn > 0.0f);
    int4 bounces = flies & ~(vn > 0.0f) & (s * k->inverseH + vn < 0.0f);

    float4 next = choose4(bounce > 0.0f, rigid4(lambda, mass, vn, -bounce),
                          rigidOrSoft4(k, lambda, mass, vn, s, masses[2]));
    float4 p = choose4(bounces, freeBounce4(e, vn, mass), next - lambda);
    masses[3] = bounce;
    contact[3] = choose4(leaves | bounces, lambda, next);
    float4 pi = masses[0] * p, pj = masses[1] * p;
    giveVelocities(w, i, j, choose4(leaves, vi.x, vi.x - nx * pi), choose4(leaves, vi.y, vi.y - ny * pi),
                   choose4(leaves, vj.x, vj.x + nx * pj), choose4(leaves, vj.y, vj.y + ny * pj));
}

// Remembers the impulse of a contact for the step to come.
void rememberPlace(const World *w, int place, int lo, int hi, float lambda) {
    w->old[place] = (int4)(w->id[hi], as_int(lambda), w->memory[lo], 0);
    w->memory[lo] = place;
}

// Measures a bundle anew. This needs no velocities, so it runs ahead of what changes those: roots and divisions take long, but
// those of several bundles at a time hardly longer.
void measureBundle(const World *w, int bundle) {
    int4 i = pairOf(w, bundle)[0];
    int4 j = pairOf(w, bundle)[1];
    global const float4 *base = baseOf(w, bundle);
    global float4 *contact = stateOf(w, bundle);
    Four mi = take(w->motion, i);
    Four mj = take(w->motion, j);
    float4 nx = contact[0], ny = contact[1], s;
    measure4(base[0] + (mj.x - mi.x), base[1] + (mj.y - mi.y), base[2], &nx, &ny, &s);
    contact[0] = nx;
    contact[1] = ny;
    contact[2] = s;
}

// The relaxing pass over a bundle that has been measured anew; sums up for what follows.
void relaxBundle(const World *w, int bundle, bool last) {
    int4 i = pairOf(w, bundle)[0];
    int4 j = pairOf(w, bundle)[1];
    global const float4 *base = baseOf(w, bundle);
    global const float4 *masses = massesOf(w, bundle);
    global float4 *contact = stateOf(w, bundle);
    global const float4 *shape = shapeOf(w, bundle);
    float4 nx = contact[0], ny = contact[1], s = contact[2];
    float4 lambda = contact[3], bounce = masses[3];
    // not those that have a gap and no impulse, and do not bounce
    int4 open = ~((s > 0.0f) & (lambda == 0.0f) & (bounce == 0.0f));
    if (!any(open)) return;

    FourVelocities vi = takeVelocities(w, i);
    FourVelocities vj = takeVelocities(w, j);
    Four li = take(w->load, i);
    Four lj = take(w->load, j);
    float4 e = base[3], wi = masses[0], wj = masses[1], mass = shape[0], thr2 = shape[1];
    float4 zero = (float4)(0.0f);
    float4 vn = along4(nx, ny, vj.x - vi.x, vj.y - vi.y);
    // freeFlight
    int4 free = open & (e > 0.0f) & (lambda == 0.0f) & (bounce == 0.0f) & (li.z + lj.z == 0.0f) & (vn * vn > thr2);
    int4 moves = open & ~(free & (vn > 0.0f));
    float4 bias = choose4(bounce > 0.0f, -bounce, choose4(s > 0.0f, s * w->k.inverseH, zero));
    float4 next = rigid4(lambda, mass, vn, bias);
    float4 p = choose4(free, freeBounce4(e, vn, mass), next - lambda);
    float4 pi = wi * p, pj = wj * p;
    giveVelocities(w, i, j, choose4(moves, vi.x - nx * pi, vi.x), choose4(moves, vi.y - ny * pi, vi.y),
                   choose4(moves, vj.x + nx * pj, vj.x), choose4(moves, vj.y + ny * pj, vj.y));
    int4 solved = open & ~free;
    next = choose4(bounce > 0.0f, zero, next);
    contact[3] = choose4(solved, next, lambda);
    if (last) {
        int4 pressing = solved & (next > 0.0f);
        if (pressing.x) rememberPlace(w, 4 * bundle, i.x, j.x, next.x);
        if (pressing.y) rememberPlace(w, 4 * bundle + 1, i.y, j.y, next.y);
        if (pressing.z) rememberPlace(w, 4 * bundle + 2, i.z, j.z, next.z);
        if (pressing.w) rememberPlace(w, 4 * bundle + 3, i.w, j.w, next.w);
        return;
    }
    int4 carrying = solved & carries4(next, s, vn + p * (wi + wj), thr2);
    if (!any(carrying)) return;
    li.x = choose4(carrying, li.x - nx * next, li.x);
    li.y = choose4(carrying, li.y - ny * next, li.y);
    li.w = choose4(carrying, (float4)(1.0f), li.w);
    lj.x = choose4(carrying, lj.x + nx * next, lj.x);
    lj.y = choose4(carrying, lj.y + ny * next, lj.y);
    lj.w = choose4(carrying, (float4)(1.0f), lj.w);
    give(w->load, i, j, &li, &lj);
}

void pushRow(const World *w, int row) {
    int end = w->groupStart[row];
    for (int bundle = w->groupFill[row]; bundle < end; bundle++) pushBundle(w, bundle);
}

#define MEASURED_AHEAD 32 // bundles

void relaxRow(const World *w, int row, bool last) {
    int end = w->groupStart[row];
    for (int from = w->groupFill[row]; from < end; from += MEASURED_AHEAD) {
        int to = min(end, from + MEASURED_AHEAD);
        for (int bundle = from; bundle < to; bundle++) measureBundle(w, bundle);
        for (int bundle = from; bundle < to; bundle++) relaxBundle(w, bundle, last);
    }
}
