// The passes over bundles of contacts (LaneContacts.cl): what solver_push and solver_relax do to one contact after the other.
// Lane by lane the bits are those of pushImpulse, relaxImpulse and applyImpulse in Solver.cl.

// Applies impulses p along normals to the velocities of a bundle's circles, in those lanes that move. Taking +0 away and adding -0
// change no bit of the others.
INLINE void apply(const World *w, uint4 i, uint4 j, const Halves *vi, const Halves *vj, float4 nx, float4 ny,
                  float4 wi, float4 wj, float4 p, int4 moves) {
    float4 pi = wi * p, pj = wj * p;
    float4 none = (float4)(0.0f);
    Halves taken = halvesOf(choose4(moves, nx * pi, none), choose4(moves, ny * pi, none));
    Halves given = halvesOf(choose4(moves, nx * pj, -none), choose4(moves, ny * pj, -none));
    Halves lower = halvesMinus(vi, &taken);
    Halves higher = halvesPlus(vj, &given);
    giveHalves(w->motion, i, j, &lower, &higher, ZW);
}

// Where some circle of a contact is loaded.
INLINE int4 someLoaded(const World *w, uint4 i, uint4 j) {
    global const float4 *load = w->load;
    float4 lower = (float4)(load[i.x].z, load[i.y].z, load[i.z].z, load[i.w].z);
    float4 higher = (float4)(load[j.x].z, load[j.y].z, load[j.z].z, load[j.w].z);
    return lower + higher > 0.0f;
}

// The biased pass over a bundle.
INLINE void pushBundle(const World *w, int bundle) {
    const StepConstants *k = &w->k;
    uint4 i = slotsOf(w, bundle, 0);
    uint4 j = slotsOf(w, bundle, 1);
    global const float4 *base = baseOf(w, bundle);
    global float4 *masses = massesOf(w, bundle);
    global float4 *contact = stateOf(w, bundle);
    global const float4 *shape = shapeOf(w, bundle);
    Halves vi = takeHalves(w->motion, i, ZW);
    Halves vj = takeHalves(w->motion, j, ZW);
    Halves relative = halvesMinus(&vj, &vi);
    Halves ui = takeHalves(w->load, i, XY);
    Halves uj = takeHalves(w->load, j, XY);
    Halves relativeBefore = halvesMinus(&uj, &ui);
    float4 nx = contact[0], ny = contact[1], s = contact[2], lambda = contact[3];
    float4 e = base[3], mass = shape[0], thr2 = shape[1];
    float4 zero = (float4)(0.0f);
    float4 vn = along4(nx, ny, firstOf(&relative), secondOf(&relative));
    int4 loaded = someLoaded(w, i, j);
    int4 elastic = e > 0.0f;

    // bounceSpeed
    float4 before = along4(nx, ny, firstOf(&relativeBefore), secondOf(&relativeBefore));
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
    apply(w, i, j, &vi, &vj, nx, ny, masses[0], masses[1], p, ~leaves);
}

// Remembers the impulse of a contact for the step to come, where it presses. No branch: whether it does is hard to guess.
INLINE void rememberPlace(const World *w, int place, int lo, int hi, float lambda, int presses) {
    int before = w->memory[lo];
    w->old[place] = (int4)(w->id[hi], as_int(lambda), before, 0);
    w->memory[lo] = presses ? place : before;
}

// Measures a bundle anew. This needs no velocities, so it runs ahead of what changes those: roots and divisions take long, but
// those of several bundles at a time hardly longer.
INLINE void measureBundle(const World *w, int bundle) {
    uint4 i = slotsOf(w, bundle, 0);
    uint4 j = slotsOf(w, bundle, 1);
    global const float4 *base = baseOf(w, bundle);
    global float4 *contact = stateOf(w, bundle);
    Halves di = takeHalves(w->motion, i, XY);
    Halves dj = takeHalves(w->motion, j, XY);
    Halves moved = halvesMinus(&dj, &di);
    float4 nx = contact[0], ny = contact[1], s;
    measure4(base[0] + firstOf(&moved), base[1] + secondOf(&moved), base[2], &nx, &ny, &s);
    contact[0] = nx;
    contact[1] = ny;
    contact[2] = s;
}

// The relaxing pass over a bundle that has been measured anew; sums up for what follows.
INLINE void relaxBundle(const World *w, int bundle, bool last) {
    uint4 i = slotsOf(w, bundle, 0);
    uint4 j = slotsOf(w, bundle, 1);
    global const float4 *base = baseOf(w, bundle);
    global const float4 *masses = massesOf(w, bundle);
    global float4 *contact = stateOf(w, bundle);
    global const float4 *shape = shapeOf(w, bundle);
    float4 nx = contact[0], ny = contact[1], s = contact[2];
    float4 lambda = contact[3], bounce = masses[3];
    // not those that have a gap and no impulse, and do not bounce
    int4 open = ~((s > 0.0f) & (lambda == 0.0f) & (bounce == 0.0f));

    Halves vi = takeHalves(w->motion, i, ZW);
    Halves vj = takeHalves(w->motion, j, ZW);
    Halves relative = halvesMinus(&vj, &vi);
    float4 e = base[3], wi = masses[0], wj = masses[1], mass = shape[0], thr2 = shape[1];
    float4 zero = (float4)(0.0f);
    float4 vn = along4(nx, ny, firstOf(&relative), secondOf(&relative));
    // freeFlight
    int4 free = open & (e > 0.0f) & (lambda == 0.0f) & (bounce == 0.0f) & (vn * vn > thr2);
    if (any(free)) free &= ~someLoaded(w, i, j);
    int4 moves = open & ~(free & (vn > 0.0f));
    float4 bias = choose4(bounce > 0.0f, -bounce, choose4(s > 0.0f, s * w->k.inverseH, zero));
    float4 next = rigid4(lambda, mass, vn, bias);
    float4 p = choose4(free, freeBounce4(e, vn, mass), next - lambda);
    apply(w, i, j, &vi, &vj, nx, ny, wi, wj, p, moves);
    int4 solved = open & ~free;
    next = choose4(bounce > 0.0f, zero, next);
    contact[3] = choose4(solved, next, lambda);
    if (last) {
        int4 pressing = solved & (next > 0.0f);
        rememberPlace(w, 4 * bundle, i.x, j.x, next.x, pressing.x);
        rememberPlace(w, 4 * bundle + 1, i.y, j.y, next.y, pressing.y);
        rememberPlace(w, 4 * bundle + 2, i.z, j.z, next.z, pressing.z);
        rememberPlace(w, 4 * bundle + 3, i.w, j.w, next.w, pressing.w);
        return;
    }
    int4 carrying = solved & carries4(next, s, vn + p * (wi + wj), thr2);
    float4 gathered = choose4(carrying, next, zero);
    addToLoads(w, i, j, nx * gathered, ny * gathered, zero, choose4(carrying, (float4)(1.0f), zero));
}

void pushRow(const World *shared, int row) {
    World w = *shared;
    int end = w.groupStart[2 * row + 1];
    for (int bundle = w.groupStart[2 * row]; bundle < end; bundle++) pushBundle(&w, bundle);
}

#define MEASURED_AHEAD 32 // bundles

void relaxRow(const World *shared, int row, bool last) {
    World w = *shared;
    int end = w.groupStart[2 * row + 1];
    for (int from = w.groupStart[2 * row]; from < end; from += MEASURED_AHEAD) {
        int to = min(end, from + MEASURED_AHEAD);
        for (int bundle = from; bundle < to; bundle++) measureBundle(&w, bundle);
        for (int bundle = from; bundle < to; bundle++) relaxBundle(&w, bundle, last);
    }
}
