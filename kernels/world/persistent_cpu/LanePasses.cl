// uses: world/persistent_cpu/LaneContacts.cl world/persistent_cpu/LaneTouches.cl
// The passes over wide contacts (LaneContacts.cl).

// Applies impulses p along normals to the velocities of a wide contact's circles, in those lanes that move. Taking +0 away
// and adding -0 change no bit of the others.
INLINE void apply(const World *w, uint4 i, uint4 j, const Halves *vi, const Halves *vj, float4 nx, float4 ny, float4 wi,
                  float4 wj, float4 p, int4 leaves) {
    float4 none = (float4)(0.0f);
    Halves taken = halvesOf(choose4(leaves, none, velocityChange4(nx, wi, p)), choose4(leaves, none, velocityChange4(ny, wi, p)));
    Halves given = halvesOf(choose4(leaves, -none, velocityChange4(nx, wj, p)), choose4(leaves, -none, velocityChange4(ny, wj, p)));
    Halves lower = halvesMinus(vi, &taken);
    Halves higher = halvesPlus(vj, &given);
    giveHalves(w->motion, i, j, &lower, &higher, ZW);
}

// Whether a circle of a contact is loaded.
INLINE int4 someLoaded(const World *w, uint4 i, uint4 j) {
    global const float4 *load = w->load;
    float4 lower = (float4)(load[i.x].z, load[i.y].z, load[i.z].z, load[i.w].z);
    float4 higher = (float4)(load[j.x].z, load[j.y].z, load[j.z].z, load[j.w].z);
    return lower + higher > 0.0f;
}

// The contacts of a wide contact as a pass finds them.
INLINE Found4 foundWide(const World *w, int wide, int4 loaded) {
    Found4 f;
    f.separation = stateOf(w, wide)[2];
    f.restitution = baseOf(w, wide)[3];
    f.threshold = shapeOf(w, wide)[1];
    f.flight = massesOf(w, wide)[2];
    f.mass = shapeOf(w, wide)[0];
    f.normalImpulse = stateOf(w, wide)[3];
    f.loaded = loaded;
    return f;
}

// What is added along the normals in a sub-step to the speeds of those circles of pairs that are not static.
float4 fallsOfPairs(const World *w, uint4 i, uint4 j, float4 invMassA, float4 invMassB, float4 nx, float4 ny) {
    float2 x = gainOfPair(w, i.x, invMassA.x, j.x, invMassB.x);
    float2 y = gainOfPair(w, i.y, invMassA.y, j.y, invMassB.y);
    float2 z = gainOfPair(w, i.z, invMassA.z, j.z, invMassB.z);
    float2 u = gainOfPair(w, i.w, invMassA.w, j.w, invMassB.w);
    return nx * (float4)(x.x, y.x, z.x, u.x) + ny * (float4)(x.y, y.y, z.y, u.y);
}

// visit4, with a short way for a wide contact of which no lane flies free, as hardly any does: what only free flight needs is
// not even computed there.
INLINE void visitWide(Ready4 *ready, float4 vn, bool relaxing, Visited4 *visited) {
    if (someLane(vn * vn > ready->flight)) {
        visit4(ready, vn, relaxing, visited);
    } else {
        ready->flight = (float4)(INFINITY);
        visit4(ready, vn, relaxing, visited);
    }
}

// The biased pass over a wide contact. driving: whether that of the step is not 0, so that a loop decides it once.
INLINE void solveWide(const World *w, int wide, bool driving) {
    uint4 i = slotsOf(w, wide, 0);
    uint4 j = slotsOf(w, wide, 1);
    global float4 *masses = massesOf(w, wide);
    global float4 *contact = stateOf(w, wide);
    Halves vi = takeHalves(w->motion, i, ZW);
    Halves vj = takeHalves(w->motion, j, ZW);
    Halves relative = halvesMinus(&vj, &vi);
    Halves ui = takeHalves(w->load, i, XY);
    Halves uj = takeHalves(w->load, j, XY);
    Halves relativeBefore = halvesMinus(&uj, &ui);
    float4 nx = contact[0], ny = contact[1];
    float4 vn = along4(nx, ny, firstOf(&relative), secondOf(&relative));
    float4 beforeX = firstOf(&relativeBefore), beforeY = secondOf(&relativeBefore);
    Found4 found = foundWide(w, wide, someLoaded(w, i, j));
    found.pushSpeed = pushSpeed4(&w->k, baseOf(w, wide)[2]);
    found.before = along4(nx, ny, beforeX, beforeY);
    found.squaredSpeed = beforeX * beforeX + beforeY * beforeY;
    float4 fall = nx * w->k.gravityStepX + ny * w->k.gravityStepY;
    if (driving) fall = fallsOfPairs(w, i, j, masses[0], masses[1], nx, ny);
    found.halfFall = halfFall4(fall, masses[0], masses[1]);
    Ready4 ready;
    makeReadyToSolve4(&w->k, contactSoftness(&w->k), &found, &ready);
    Visited4 visited;
    visitWide(&ready, vn, false, &visited);
    masses[3] = ready.bounce;
    contact[3] = visited.normalImpulse;
    apply(w, i, j, &vi, &vj, nx, ny, masses[0], masses[1], visited.impulse, visited.leaves);
#ifdef RECORDING
    noteSolved(w, wide, found.before, found.separation, &visited);
#endif
}

// Stores the impulse of a contact for the step to come, where it presses. No branch: whether it does is hard to guess.
INLINE void storeImpulseOfLane(const World *w, int place, int lo, int hi, float normalImpulse, int presses) {
    int before = w->firstCached[lo];
    w->impulseCache[place] = cacheEntry(w->id[hi], normalImpulse, before);
    w->firstCached[lo] = presses ? place : before;
}

// Measures a wide contact again. This needs no velocities, so it runs ahead of what changes those: roots and divisions take
// long, but those of several wide contacts at a time hardly longer.
INLINE void measureWide(const World *w, int wide) {
    uint4 i = slotsOf(w, wide, 0);
    uint4 j = slotsOf(w, wide, 1);
    global const float4 *base = baseOf(w, wide);
    global float4 *contact = stateOf(w, wide);
    Halves di = takeHalves(w->motion, i, XY);
    Halves dj = takeHalves(w->motion, j, XY);
    Halves moved = halvesMinus(&dj, &di);
    float4 nx = contact[0], ny = contact[1], s;
    measure4(base[0], base[1], firstOf(&moved), secondOf(&moved), base[2], &nx, &ny, &s);
    contact[0] = nx;
    contact[1] = ny;
    contact[2] = s;
}

// The relaxing pass over a wide contact that has been measured again; sums up for what follows.
INLINE void relaxWide(const World *w, int wide, bool last) {
    uint4 i = slotsOf(w, wide, 0);
    uint4 j = slotsOf(w, wide, 1);
    global const float4 *masses = massesOf(w, wide);
    global float4 *contact = stateOf(w, wide);
    Halves vi = takeHalves(w->motion, i, ZW);
    Halves vj = takeHalves(w->motion, j, ZW);
    Halves relative = halvesMinus(&vj, &vi);
    float4 nx = contact[0], ny = contact[1], wi = masses[0], wj = masses[1];
    float4 vn = along4(nx, ny, firstOf(&relative), secondOf(&relative));
    Found4 found = foundWide(w, wide, (int4)(0));
    Ready4 ready;
    makeReadyToRelax4(&w->k, &found, masses[3], &ready);
    Visited4 visited;
    // Hardly any contact flies free: whether its circles are loaded is read only if one may.
    if (someLane(vn * vn > ready.flight && !ready.still)) {
        found.loaded = someLoaded(w, i, j);
        makeReadyToRelax4(&w->k, &found, masses[3], &ready);
        visit4(&ready, vn, true, &visited);
    } else {
        ready.flight = (float4)(INFINITY);
        visit4(&ready, vn, true, &visited);
    }
#ifdef RECORDING
    noteRelaxed(w, wide, found.normalImpulse, masses[3], &visited);
#endif
    float4 next = visited.normalImpulse;
    apply(w, i, j, &vi, &vj, nx, ny, wi, wj, visited.impulse, visited.leaves);
    contact[3] = next;
    if (last) {
        int4 pressing = visited.solved && next > 0.0f;
        storeImpulseOfLane(w, 4 * wide, i.x, j.x, next.x, pressing.x);
        storeImpulseOfLane(w, 4 * wide + 1, i.y, j.y, next.y, pressing.y);
        storeImpulseOfLane(w, 4 * wide + 2, i.z, j.z, next.z, pressing.z);
        storeImpulseOfLane(w, 4 * wide + 3, i.w, j.w, next.w, pressing.w);
        return;
    }
    float4 zero = (float4)(0.0f);
    int4 carrying = visited.solved && carries4(next, vn + visited.impulse * (wi + wj), ready.restingLimit);
    float4 gathered = choose4(carrying, next, zero);
    addToLoads(w, i, j, nx * gathered, ny * gathered, zero, choose4(carrying, (float4)(1.0f), zero));
}

void solveRow(const World *shared, int row) {
    World w = *shared;
    int end = w.groupStart[2 * row + 1];
    int from = w.groupStart[2 * row];
    if (w.k.driving) {
        for (int wide = from; wide < end; wide++) solveWide(&w, wide, true);
    } else {
        for (int wide = from; wide < end; wide++) solveWide(&w, wide, false);
    }
}

#define MEASURED_AHEAD 32 // wide contacts

void relaxRow(const World *shared, int row, bool last) {
    World w = *shared;
    int end = w.groupStart[2 * row + 1];
    for (int from = w.groupStart[2 * row]; from < end; from += MEASURED_AHEAD) {
        int to = min(end, from + MEASURED_AHEAD);
        for (int wide = from; wide < to; wide++) measureWide(&w, wide);
        for (int wide = from; wide < to; wide++) relaxWide(&w, wide, last);
    }
}
