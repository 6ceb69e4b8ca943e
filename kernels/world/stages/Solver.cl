// uses: world/shared/Motion.cl world/stages/Contacts.cl
// Stage Solver: moves the circles through the sub-steps of a step, and writes them home. The contacts are visited with one launch
// per colour; the Java class world.jvm.Solver does the same.

// Index space: a working slot a work-item.
kernel void solver_integrateVelocities(WORLD_PARAMETERS, int subStep) {
    World w = WORLD;
    w.subStep = subStep;
    int slot = (int) get_global_id(0);
    if (slot >= circles || refused(&w)) return;
    float4 m = w.motion[slot];
    float4 t = w.traits[slot];
    float4 l = w.load[slot];
    float2 before, bounce;
    bool loaded;
    integrateVelocities(&w, slot, w.circle[slot], &m, &t, l, &before, &bounce, &loaded);
    w.motion[slot] = m;
    w.traits[slot] = t;
    w.wallBounce[slot] = bounce;
    w.load[slot] = (float4)(before.x, before.y, loaded ? 1.0f : 0.0f, l.LOADED_NEXT);
}

// A contact as a pass finds it. b: base; q: masses; n: contact; loads: whether its circles are loaded, added up.
Found foundContact(const World *w, float4 b, float4 q, float4 n, float loads) {
    Found f;
    f.separation = n.SEPARATION;
    f.restitution = b.PAIR_RESTITUTION;
    f.threshold = restitutionThreshold(&w->k, b.RADII, b.PAIR_RESTITUTION);
    f.flight = flightThreshold(&w->k, b.RADII, b.PAIR_RESTITUTION);
    f.mass = effectiveMass(q.INVERSE_MASS_A, q.INVERSE_MASS_B);
    f.normalImpulse = n.NORMAL_IMPULSE;
    f.loaded = loads > 0.0f;
    return f;
}

// Visits a contact, and applies the impulse. pr: slots; mi, mj: motion of its circles. Returns the normal speed afterwards.
float visitPair(const World *w, uint2 pr, float4 n, float4 q, float4 mi, float4 mj, const Ready *c, bool relaxing,
                Visited *visited) {
    float vn = along(n.NORMAL_X, n.NORMAL_Y, mj.VX - mi.VX, mj.VY - mi.VY);
    visit(c, vn, relaxing, visited);
    float impulse = visited->impulse;
    if (!visited->leaves) {
        mi.VX -= velocityChange(n.NORMAL_X, q.INVERSE_MASS_A, impulse);
        mi.VY -= velocityChange(n.NORMAL_Y, q.INVERSE_MASS_A, impulse);
        mj.VX += velocityChange(n.NORMAL_X, q.INVERSE_MASS_B, impulse);
        mj.VY += velocityChange(n.NORMAL_Y, q.INVERSE_MASS_B, impulse);
        w->motion[pr.LOWER] = mi;
        w->motion[pr.HIGHER] = mj;
    }
    return vn + impulse * (q.INVERSE_MASS_A + q.INVERSE_MASS_B);
}

// Makes contact c ready for the biased pass. pr, q, n: its pair, masses and contact.
void readyToSolve(const World *w, int c, uint2 pr, float4 q, float4 n, Ready *ready) {
    float4 li = w->load[pr.LOWER];
    float4 lj = w->load[pr.HIGHER];
    Found found = foundContact(w, w->base[c], q, n, li.LOADED + lj.LOADED);
    float2 before = lj.BEFORE - li.BEFORE;
    found.pushSpeed = q.PUSH_SPEED;
    found.before = along(n.NORMAL_X, n.NORMAL_Y, before.x, before.y);
    found.squaredSpeed = before.x * before.x + before.y * before.y;
    float2 fall = gainOfPair(w, pr.LOWER, q.INVERSE_MASS_A, pr.HIGHER, q.INVERSE_MASS_B);
    found.halfFall = halfFall(along(n.NORMAL_X, n.NORMAL_Y, fall.x, fall.y), q.INVERSE_MASS_A, q.INVERSE_MASS_B);
    makeReadyToSolve(&w->k, contactSoftness(&w->k), &found, ready);
}

// The biased pass over one contact. Returns the impulse of a free bounce, which the contact does not keep, or 0.
float solveContact(const World *w, int c) {
    uint2 pr = w->pair[c];
    float4 q = w->masses[c];
    float4 n = w->contact[c];
    Ready ready;
    readyToSolve(w, c, pr, q, n, &ready);
    Visited visited;
    visitPair(w, pr, n, q, w->motion[pr.LOWER], w->motion[pr.HIGHER], &ready, false, &visited);
    w->masses[c].BOUNCE = ready.bounce;
    w->contact[c].NORMAL_IMPULSE = visited.normalImpulse;
    return visited.leaves || visited.solved ? 0.0f : visited.impulse;
}

// Index space: a group of one colour a work-item. Cost: its contacts.
kernel void solver_solve(WORLD_PARAMETERS, int colour) {
    World w = WORLD;
    int g = (int) get_global_id(0);
    int groups = likeGroups(&w) >> 2;
    if (g >= groups || refused(&w)) return;
    int group = colour * groups + g;
    int to = w.groupStart[group + 1];
    for (int c = w.groupStart[group]; c < to; c++) solveContact(&w, c);
}

// Index space: a working slot a work-item.
kernel void solver_integratePositions(WORLD_PARAMETERS, int subStep) {
    World w = WORLD;
    w.subStep = subStep;
    int slot = (int) get_global_id(0);
    if (slot >= circles || refused(&w)) return;
    float4 m = w.motion[slot];
    float4 t = w.traits[slot];
    float loaded = w.load[slot].LOADED;
    moveCircle(&w, slot, w.circle[slot], &m, &t, w.wallBounce[slot], loaded > 0.0f);
    w.motion[slot] = m;
    w.traits[slot] = t;
    w.load[slot] = (float4)(0.0f, 0.0f, loaded, 0.0f);
    w.firstCached[slot] = NONE;
}

// Stores a contact's impulse for the step to come.
void storeImpulse(const World *w, int c, uint2 pr, float normalImpulse) {
    w->impulseCache[c] = cacheEntry((int) w->key[c], normalImpulse, w->firstCached[pr.LOWER]);
    w->firstCached[pr.LOWER] = c;
}

// Whether a circle is loaded, in the relaxing pass: of its load no more than that, since others write the rest.
float loadedOf(const World *w, uint slot) { return ((global const float *) (w->load + slot))[2]; }

// Measures a contact again, and makes it ready for the relaxing pass. b, q, n: its base, masses and contact; mi, mj: motion of its circles.
void readyToRelax(const World *w, uint2 pr, float4 b, float4 q, float4 mi, float4 mj, float4 *n, Ready *ready) {
    measureContact(b, mi, mj, n);
    Found found = foundContact(w, b, q, *n, loadedOf(w, pr.LOWER) + loadedOf(w, pr.HIGHER));
    makeReadyToRelax(&w->k, &found, q.BOUNCE, ready);
}

// Measures a contact again, makes the relaxing pass over it, and sums up for what follows. Returns the impulse of a bounce, which the
// contact does not keep, or 0.
float relaxContact(const World *w, int c, bool last) {
    uint2 pr = w->pair[c];
    float4 b = w->base[c];
    float4 q = w->masses[c];
    float4 n = w->contact[c];
    float4 mi = w->motion[pr.LOWER];
    float4 mj = w->motion[pr.HIGHER];
    Ready ready;
    readyToRelax(w, pr, b, q, mi, mj, &n, &ready);
    Visited visited;
    float vn = visitPair(w, pr, n, q, mi, mj, &ready, true, &visited);
    float next = visited.normalImpulse;
    w->contact[c] = (float4)(n.NORMAL_X, n.NORMAL_Y, n.SEPARATION, next);
    if (!visited.solved) return visited.leaves ? 0.0f : visited.impulse;
    if (last) {
        if (next > 0.0f) storeImpulse(w, c, pr, next);
    } else if (carries(next, vn, ready.restingLimit)) {
        gatherLoad(w, pr, n.NORMAL_X, n.NORMAL_Y, next, true);
    }
    return ready.bounce > 0.0f ? n.NORMAL_IMPULSE + visited.impulse : 0.0f;
}

// Index space: a group of one colour a work-item. Cost: its contacts.
kernel void solver_relax(WORLD_PARAMETERS, int colour, int last) {
    World w = WORLD;
    int g = (int) get_global_id(0);
    int groups = likeGroups(&w) >> 2;
    if (g >= groups || refused(&w)) return;
    int group = colour * groups + g;
    int to = w.groupStart[group + 1];
    for (int c = w.groupStart[group]; c < to; c++) relaxContact(&w, c, last != 0);
}

// Index space: a working slot a work-item.
kernel void solver_finalizePositions(WORLD_PARAMETERS) {
    World w = WORLD;
    int slot = (int) get_global_id(0);
    if (slot >= circles || refused(&w)) return;
    finalizePositions(&w, slot, w.circle[slot], w.motion[slot], w.traits[slot]);
    w.homeFirstCached[slot] = w.firstCached[slot];
    if (slot == 0) status[STEPS_DONE]++;
}
