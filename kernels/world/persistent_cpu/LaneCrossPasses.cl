// uses: world/shared/Real.cl*4 world/stages/CrossTurns.cl world/persistent_cpu/LaneCross.cl world/persistent_cpu/LanePasses.cl
// The passes over wide cross contacts (LaneCross.cl). Light circles change a velocity of their own, which starts as that of the circle;
// heavy circles are seen as they were before, and take the sums afterwards.

// What a pass sees of a wide cross contact. Normals point to the heavy circles.
typedef struct {
    uint4 light, heavy;
    float4 nx, ny;
    float4 lightMass, heavyMass; // inverse
    int4 shared;                 // whether the heavy circle is
    Halves velocity;             // of the light circles
    float4 vn;
} Cross4;

// Vectors of two, put together as in takeTwo.
INLINE float4 takeTwoOf(global const float2 *from, uint one, uint other) {
    float2 a = from[one], b = from[other];
    return (float4)(a.x, a.y, b.x, b.y);
}

// Lane 0 last.
INLINE void giveLight(const World *w, uint4 i, const Halves *v) {
    w->lightVelocity[i.w] = (float2)(v->b.z, v->b.w);
    w->lightVelocity[i.z] = (float2)(v->b.x, v->b.y);
    w->lightVelocity[i.y] = (float2)(v->a.z, v->a.w);
    w->lightVelocity[i.x] = (float2)(v->a.x, v->a.y);
}

INLINE Cross4 crossAt(const World *w, int wide) {
    global const float4 *masses = massesOf(w, wide);
    global const float4 *contact = stateOf(w, wide);
    Cross4 x;
    x.light = slotsOf(w, wide, 0);
    x.heavy = slotsOf(w, wide, 1);
    int4 sign = as_int4(masses[0]) & SIGN;
    x.nx = signed4(contact[0], sign);
    x.ny = signed4(contact[1], sign);
    x.lightMass = magnitude4(masses[0]);
    x.heavyMass = magnitude4(masses[1]);
    x.shared = as_int4(masses[1]) < 0;
    return x;
}

INLINE void seeVelocities(const World *w, Cross4 *c) {
    c->velocity.a = takeTwoOf(w->lightVelocity, c->light.x, c->light.y);
    c->velocity.b = takeTwoOf(w->lightVelocity, c->light.z, c->light.w);
    Halves heavy = takeHalves(w->motion, c->heavy, ZW);
    Halves relative = halvesMinus(&heavy, &c->velocity);
    c->vn = along4(c->nx, c->ny, firstOf(&relative), secondOf(&relative));
}

// Adds x and y to two sums of a heavy circle, which have a range. axis: the first of them.
INLINE void addToSums(const World *w, uint heavy, int axis, bool shared, float range, float x, float y) {
    global long *sums = (global long *) (w->heavySum + heavy) + axis;
    float scale = scaleOf(range);
    if (shared) {
        addFixed(sums, toFixed(x, scale));
        addFixed(sums + 1, toFixed(y, scale));
    } else {
        sums[0] += toFixed(x, scale);
        sums[1] += toFixed(y, scale);
    }
}

// What visits give heavy circles, unless they are static: velocity x, y.
INLINE void addVelocity(const World *w, uint heavy, float inverseMass, bool shared, float x, float y) {
    if (inverseMass == 0.0f) return;
    addToSums(w, heavy, 0, shared, velocityRange(w->circle[heavy].z, w->k.inverseH), x, y);
}

// Impulse x, y.
INLINE void addImpulse(const World *w, uint heavy, float inverseMass, bool shared, float x, float y) {
    if (inverseMass == 0.0f) return;
    addToSums(w, heavy, 2, shared, impulseRange(w->circle[heavy].z, w->k.inverseH, inverseMass), x, y);
}

// Adds impulses along the normals to the sums of a wide cross contact's circles, and marks as loaded those where they carry. Nothing else
// of a load is written: others mark the same heavy circles at the same time.
INLINE void gatherCross(const World *w, const Cross4 *c, float4 normalImpulse, int4 carrying) {
    float4 x = c->nx * normalImpulse, y = c->ny * normalImpulse;
    Halves taken = halvesOf(x, y);
    vstore2(vload2(0, halfOf(w->load, c->light.x, XY)) - (float2)(taken.a.x, taken.a.y), 0, halfOf(w->load, c->light.x, XY));
    vstore2(vload2(0, halfOf(w->load, c->light.y, XY)) - (float2)(taken.a.z, taken.a.w), 0, halfOf(w->load, c->light.y, XY));
    vstore2(vload2(0, halfOf(w->load, c->light.z, XY)) - (float2)(taken.b.x, taken.b.y), 0, halfOf(w->load, c->light.z, XY));
    vstore2(vload2(0, halfOf(w->load, c->light.w, XY)) - (float2)(taken.b.z, taken.b.w), 0, halfOf(w->load, c->light.w, XY));
    addImpulse(w, c->heavy.x, c->heavyMass.x, c->shared.x, x.x, y.x);
    addImpulse(w, c->heavy.y, c->heavyMass.y, c->shared.y, x.y, y.y);
    addImpulse(w, c->heavy.z, c->heavyMass.z, c->shared.z, x.z, y.z);
    addImpulse(w, c->heavy.w, c->heavyMass.w, c->shared.w, x.w, y.w);
    if (carrying.x) ((global float *) (w->load + c->light.x))[3] = ((global float *) (w->load + c->heavy.x))[3] = 1.0f;
    if (carrying.y) ((global float *) (w->load + c->light.y))[3] = ((global float *) (w->load + c->heavy.y))[3] = 1.0f;
    if (carrying.z) ((global float *) (w->load + c->light.z))[3] = ((global float *) (w->load + c->heavy.z))[3] = 1.0f;
    if (carrying.w) ((global float *) (w->load + c->light.w))[3] = ((global float *) (w->load + c->heavy.w))[3] = 1.0f;
}

// Before the first sub-step: finds which heavy circles are shared, and adds to the loads and the sums of impulses of all circles.
void prepareCross(const World *shared, int from, int to) {
    World own = *shared;
    const World *w = &own;
    for (int wide = from; wide < to; wide++) {
        global float4 *masses = massesOf(w, wide);
        uint4 heavy = slotsOf(w, wide, 1);
        int4 sharing = (int4)(*ownerOf(w, heavy.x), *ownerOf(w, heavy.y), *ownerOf(w, heavy.z), *ownerOf(w, heavy.w)) == SHARED;
        masses[1] = signed4(masses[1], sharing & SIGN);
        Cross4 c = crossAt(w, wide);
        int4 used = shapeOf(w, wide)[0] > 0.0f;
        if (used.x) atomic_add(&w->crossLoad[heavy.x], loadOfHeavy(c.lightMass.x, c.heavyMass.x));
        if (used.y) atomic_add(&w->crossLoad[heavy.y], loadOfHeavy(c.lightMass.y, c.heavyMass.y));
        if (used.z) atomic_add(&w->crossLoad[heavy.z], loadOfHeavy(c.lightMass.z, c.heavyMass.z));
        if (used.w) atomic_add(&w->crossLoad[heavy.w], loadOfHeavy(c.lightMass.w, c.heavyMass.w));
        gatherCross(w, &c, stateOf(w, wide)[3], masses[3] > 0.0f);
    }
}

// Once all loads are known: the effective masses.
void setCrossMasses(const World *shared, int from, int to) {
    World own = *shared;
    const World *w = &own;
    for (int wide = from; wide < to; wide++) {
        uint4 heavy = slotsOf(w, wide, 1);
        float4 lightMass = magnitude4(massesOf(w, wide)[0]), heavyMass = magnitude4(massesOf(w, wide)[1]);
        float4 mass = (float4)(crossMass(lightMass.x, heavyMass.x, crossShare(w->crossLoad[heavy.x])),
                               crossMass(lightMass.y, heavyMass.y, crossShare(w->crossLoad[heavy.y])),
                               crossMass(lightMass.z, heavyMass.z, crossShare(w->crossLoad[heavy.z])),
                               crossMass(lightMass.w, heavyMass.w, crossShare(w->crossLoad[heavy.w])));
        global float4 *shape = shapeOf(w, wide);
        shape[0] = choose4(shape[0] > 0.0f, mass, (float4)(0.0f));
    }
}

// Applies impulses to the velocities of the light circles, and adds them to the sums of the heavy ones, in those lanes that move.
INLINE void applyCross(const World *w, const Cross4 *c, const Visited4 *visited) {
    float4 none = (float4)(0.0f);
    float4 p = choose4(visited->leaves, none, visited->impulse);
    Halves taken = halvesOf(choose4(visited->leaves, none, velocityChange4(c->nx, c->lightMass, p)),
                            choose4(visited->leaves, none, velocityChange4(c->ny, c->lightMass, p)));
    Halves light = halvesMinus(&c->velocity, &taken);
    giveLight(w, c->light, &light);
    if (!someLane(p != 0.0f)) return;
    float4 x = velocityChange4(c->nx, c->heavyMass, p), y = velocityChange4(c->ny, c->heavyMass, p);
    addVelocity(w, c->heavy.x, c->heavyMass.x, c->shared.x, x.x, y.x);
    addVelocity(w, c->heavy.y, c->heavyMass.y, c->shared.y, x.y, y.y);
    addVelocity(w, c->heavy.z, c->heavyMass.z, c->shared.z, x.z, y.z);
    addVelocity(w, c->heavy.w, c->heavyMass.w, c->shared.w, x.w, y.w);
}

// Lets lanes that are to bounce off a heavy circle wait for their turn. separation: see waitsForTurn.
INLINE void waitForTurns(const World *w, const Cross4 *c, float4 restitution, float4 separation, bool relaxing, Visited4 *v) {
    int4 bounces = !(v->leaves || v->solved);
    if (!someLane(bounces)) return;
    if (bounces.x && waitsForTurn(w, c->light.x, c->heavy.x, restitution.x, c->heavyMass.x, separation.x, relaxing)) v->leaves.x = -1;
    if (bounces.y && waitsForTurn(w, c->light.y, c->heavy.y, restitution.y, c->heavyMass.y, separation.y, relaxing)) v->leaves.y = -1;
    if (bounces.z && waitsForTurn(w, c->light.z, c->heavy.z, restitution.z, c->heavyMass.z, separation.z, relaxing)) v->leaves.z = -1;
    if (bounces.w && waitsForTurn(w, c->light.w, c->heavy.w, restitution.w, c->heavyMass.w, separation.w, relaxing)) v->leaves.w = -1;
}

// The biased pass over a wide cross contact. driving: whether that of the step is not 0.
INLINE void solveWideCross(const World *w, int wide, bool driving) {
    Cross4 c = crossAt(w, wide);
    seeVelocities(w, &c);
    Halves ui = takeHalves(w->load, c.light, XY);
    Halves uj = takeHalves(w->load, c.heavy, XY);
    Halves relativeBefore = halvesMinus(&uj, &ui);
    float4 beforeX = firstOf(&relativeBefore), beforeY = secondOf(&relativeBefore);
    Found4 found = foundWide(w, wide, someLoaded(w, c.light, c.heavy));
    found.pushSpeed = pushSpeed4(&w->k, baseOf(w, wide)[2]);
    found.before = along4(c.nx, c.ny, beforeX, beforeY);
    found.squaredSpeed = beforeX * beforeX + beforeY * beforeY;
    float4 fall = c.nx * w->k.gravityStepX + c.ny * w->k.gravityStepY;
    if (driving) fall = fallsOfPairs(w, c.light, c.heavy, c.lightMass, c.heavyMass, c.nx, c.ny);
    found.halfFall = halfFall4(fall, c.lightMass, c.heavyMass);
    Ready4 ready;
    makeReadyToSolve4(&w->k, contactSoftness(&w->k), &found, &ready);
    Visited4 visited;
    ready.bounceMass = effectiveMass4(c.lightMass, c.heavyMass);
    visitWide(&ready, c.vn, false, &visited);
    waitForTurns(w, &c, found.restitution, found.separation + c.vn * w->k.h, false, &visited);
    massesOf(w, wide)[3] = ready.bounce;
    stateOf(w, wide)[3] = visited.normalImpulse;
    applyCross(w, &c, &visited);
#ifdef RECORDING
    noteSolved(w, wide, found.before, found.separation, &visited);
#endif
}

// Measures a wide cross contact again; see measureWide.
INLINE void measureWideCross(const World *w, int wide) {
    uint4 i = slotsOf(w, wide, 0);
    uint4 j = slotsOf(w, wide, 1);
    global const float4 *base = baseOf(w, wide);
    global float4 *contact = stateOf(w, wide);
    int4 sign = as_int4(massesOf(w, wide)[0]) & SIGN;
    Halves di = takeHalves(w->motion, i, XY);
    Halves dj = takeHalves(w->motion, j, XY);
    Halves moved = halvesMinus(&dj, &di);
    float4 nx = contact[0], ny = contact[1], s;
    measure4(base[0], base[1], signed4(firstOf(&moved), sign), signed4(secondOf(&moved), sign), base[2], &nx, &ny, &s);
    contact[0] = nx;
    contact[1] = ny;
    contact[2] = s;
}

// Stores the impulse of a cross contact for the step to come, while others do the same for the same circle.
INLINE void storeImpulseOfCross(const World *w, int place, uint light, uint heavy, bool isLightHigher, float normalImpulse) {
    uint lower = isLightHigher ? heavy : light;
    uint higher = isLightHigher ? light : heavy;
    int next = atomic_xchg((volatile global int *) w->firstCached + lower, place);
    w->impulseCache[place] = cacheEntry(w->id[higher], normalImpulse, next);
}

// The relaxing pass over a wide cross contact that has been measured again; sums up for what follows.
INLINE void relaxWideCross(const World *w, int wide, bool last) {
    Cross4 c = crossAt(w, wide);
    seeVelocities(w, &c);
    global const float4 *masses = massesOf(w, wide);
    Found4 found = foundWide(w, wide, (int4)(0));
    Ready4 ready;
    makeReadyToRelax4(&w->k, &found, masses[3], &ready);
    Visited4 visited;
    if (someLane(c.vn * c.vn > ready.flight && !ready.still)) {
        found.loaded = someLoaded(w, c.light, c.heavy);
        makeReadyToRelax4(&w->k, &found, masses[3], &ready);
        ready.bounceMass = effectiveMass4(c.lightMass, c.heavyMass);
        visit4(&ready, c.vn, true, &visited);
        waitForTurns(w, &c, found.restitution, found.separation, true, &visited);
    } else {
        ready.flight = (float4)(INFINITY);
        visit4(&ready, c.vn, true, &visited);
    }
#ifdef RECORDING
    noteRelaxed(w, wide, found.normalImpulse, masses[3], &visited);
#endif
    float4 next = visited.normalImpulse;
    applyCross(w, &c, &visited);
    stateOf(w, wide)[3] = next;
    if (last) {
        int4 pressing = visited.solved && next > 0.0f;
        int4 isLightHigher = as_int4(masses[0]) < 0;
        if (pressing.x) storeImpulseOfCross(w, 4 * wide, c.light.x, c.heavy.x, isLightHigher.x, next.x);
        if (pressing.y) storeImpulseOfCross(w, 4 * wide + 1, c.light.y, c.heavy.y, isLightHigher.y, next.y);
        if (pressing.z) storeImpulseOfCross(w, 4 * wide + 2, c.light.z, c.heavy.z, isLightHigher.z, next.z);
        if (pressing.w) storeImpulseOfCross(w, 4 * wide + 3, c.light.w, c.heavy.w, isLightHigher.w, next.w);
        return;
    }
    float4 after = c.vn + visited.impulse * (c.lightMass + c.heavyMass);
    int4 carrying = visited.solved && carries4(next, after, ready.restingLimit);
    if (someLane(carrying)) gatherCross(w, &c, choose4(carrying, next, (float4)(0.0f)), carrying);
}

void solveWideCrosses(const World *shared, int from, int to) {
    World w = *shared;
    if (w.k.driving) {
        for (int wide = from; wide < to; wide++) solveWideCross(&w, wide, true);
    } else {
        for (int wide = from; wide < to; wide++) solveWideCross(&w, wide, false);
    }
}

void relaxWideCrosses(const World *shared, int start, int end, bool last) {
    World w = *shared;
    for (int from = start; from < end; from += MEASURED_AHEAD) {
        int to = min(end, from + MEASURED_AHEAD);
        for (int wide = from; wide < to; wide++) measureWideCross(&w, wide);
        for (int wide = from; wide < to; wide++) relaxWideCross(&w, wide, last);
    }
}

// Begins a pass over cross contacts for circles.
void beginCross(const World *w, Cells cells) {
    for (int slot = cells.from; slot < cells.to; slot++) w->lightVelocity[slot] = w->motion[slot].zw;
}

// Ends a pass for circles: they take what it has given them, velocities and, for the sub-step to come, impulses.
INLINE void takeFromCross(const World *shared, Cells cells, bool velocities, bool impulses) {
    World own = *shared;
    const World *w = &own;
    for (int slot = cells.from; slot < cells.to; slot++) {
        float2 v = velocities ? w->lightVelocity[slot] : (float2)(0.0f);
        if (w->crossLoad[slot] > 0 && w->traits[slot].x != 0.0f) {
            float inverse = w->traits[slot].x;
            long4 sum = w->heavySum[slot];
            w->heavySum[slot] = (long4)(0);
            float radius = w->circle[slot].z;
            float unit = unitOf(velocityRange(radius, w->k.inverseH));
            v = (float2)(v.x + fromFixed(sum.x, unit), v.y + fromFixed(sum.y, unit));
            if (impulses) {
                w->claim[slot] = 0;
                float impulseUnit = unitOf(impulseRange(radius, w->k.inverseH, inverse));
                float2 l = vload2(0, halfOf(w->load, (uint) slot, XY));
                vstore2((float2)(l.x + fromFixed(sum.z, impulseUnit), l.y + fromFixed(sum.w, impulseUnit)), 0,
                        halfOf(w->load, (uint) slot, XY));
            }
        }
        if (velocities) vstore2(v, 0, halfOf(w->motion, (uint) slot, ZW));
    }
}
