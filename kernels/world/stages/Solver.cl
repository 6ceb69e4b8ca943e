// uses: world/shared/Motion.cl world/shared/Visit.cl world/stages/Contacts.cl world/shared/PairRows.cl world/stages/Touches.cl
// Stage Solver: sub-steps by slots, contacts with a launch per colour. The Java class world.jvm.solver.Solver does the same.

// Without impulses of walls; false if that is not all. m: motion; l: load.
bool startOffWallsAt(const World *w, int slot, float4 c, float4 m, float4 t, float4 l) {
    float2 before, next;
    if (wallsAct(w, slot, t.WALLS)) return false;
    IF_TERRAIN(if (hasPieces(w, slot)) return false;)
    if (!integrateOffWalls(w, slot, c, m, t.INVERSE_MASS, l.IMPULSES, &before, &next)) return false;
    IF_TURNING(w->surfaceSpeed[slot] = startedSpin(w, slot, c.RADIUS, w->surfaceSpeed[slot], w->spinImpulse[slot]);)
    storeWalls(w, slot, t.WALLS, noWalls(&w->k, c));
    w->motion[slot] = (float4)(m.DX, m.DY, next.x, next.y);
    w->wallBounce[slot] = (float2)(0.0f);
    w->load[slot] = (float4)(before.x, before.y, l.LOADED_NEXT > 0.0f ? 1.0f : 0.0f, l.LOADED_NEXT);
    return true;
}

// m: motion; l: load.
void startCircleAt(const World *w, int slot, float4 m, float4 l) {
    float4 c = w->circle[slot];
    float4 t = w->traits[slot];
    if (startOffWallsAt(w, slot, c, m, t, l)) return;
    float4 old = m;
    float2 before, bounce;
    bool loaded;
    IF_TURNING(Turning turning = turningOf(w, slot, t, w->surfaceSpeed[slot]);)
    integrateVelocities(w, slot, c, &m, &t, l, &before, &bounce, &loaded AND_TURNING(&turning) AND_TURNING(w->spinImpulse[slot]));
    IF_RECORDING(noteWallsSolved(w, slot, c, t.INVERSE_MASS, l.IMPULSES, before, old, m AND_TURNING(&turning));)
    IF_TERRAIN(if (hasPieces(w, slot)) solvePieces(w, slot, c, t.RESTITUTION, before, loaded, &m AND_TURNING(&turning));)
    IF_TURNING(w->surfaceSpeed[slot] = turning.s;)
    IF_TURNING(keepWallRows(w, slot, &turning);)
    w->motion[slot] = m;
    w->traits[slot] = t;
    w->wallBounce[slot] = bounce;
    w->load[slot] = (float4)(before.x, before.y, loaded ? 1.0f : 0.0f, l.LOADED_NEXT);
}

// Behind the biased pass. m: motion.
void moveCircleAt(const World *w, int slot, float4 m, float loaded) {
    float4 c = w->circle[slot];
    float4 t = w->traits[slot];
    float2 bounce = w->wallBounce[slot];
    bool isStatic = t.INVERSE_MASS == 0.0f;
    bool atWall = bounce.x != 0.0f || bounce.y != 0.0f || hasWalls(w, c, t.WALLS);
#ifdef TURNING
    Turning turning = turningOf(w, slot, t, moveTurning(w, slot, w->surfaceSpeed[slot]));
    w->spinImpulse[slot] = 0.0f;
    atWall = atWall || wallRowsHold(&turning);
#endif
    IF_TERRAIN(float2 from = m.DISPLACEMENT;)
    IF_TERRAIN(bool atPieces = hasPieces(w, slot);)
    m = integratePositions(w, slot, c, m, isStatic);
    IF_TERRAIN(if (atPieces) m.DISPLACEMENT = movePieces(w, slot, c, from, m.DISPLACEMENT);)
    // Most circles are at no wall, and on a GPU what follows takes longer than all before it.
    if (!isStatic && (atWall || !wallsAreApart(&w->k, c, m))) {
        float2 walls = t.WALLS;
        float2 moving = m.VELOCITY;
        relaxAtWalls(w, c, &m, &t, bounce, loaded > 0.0f AND_TURNING(&turning));
        IF_RECORDING(noteWallsRelaxed(w, slot, c, t.INVERSE_MASS, moving, m AND_TURNING(&turning));)
        IF_TURNING(keepWallRows(w, slot, &turning);)
        storeWalls(w, slot, walls, t.WALLS);
    }
    IF_TERRAIN(if (atPieces) relaxPieces(w, slot, c, t.RESTITUTION, loaded > 0.0f, &m AND_TURNING(&turning));)
    IF_TURNING(w->surfaceSpeed[slot] = turning.s;)
    w->motion[slot] = m;
    w->load[slot] = (float4)(0.0f, 0.0f, loaded, 0.0f);
}

// n: as measured; loads: of both circles, added up.
Pair pairAt(const World *w, int c, float4 n, float loads) {
    float4 b = w->base[c];
    float4 q = w->masses[c];
    Pair p = {.nx = n.NORMAL_X, .ny = n.NORMAL_Y, .separation = n.SEPARATION, .normalImpulse = n.NORMAL_IMPULSE,
              .radii = b.RADII, .restitution = b.PAIR_RESTITUTION, .bounce = q.BOUNCE, .mass = q.EFFECTIVE_MASS,
              .invMassA = q.INVERSE_MASS_A, .invMassB = q.INVERSE_MASS_B, .loaded = loads > 0.0f};
    IF_TURNING(p.held = rowsHold(w->rowImpulses[c]);)
    return p;
}

// In the relaxing pass others write the rest of the load.
float loadedOf(const World *w, uint slot) { return ((global const float *) (w->load + slot))[LOADED_AT]; }

// Takes a contact for a pass.
Pair takeToSolve(const World *w, int c, uint2 pr, Visit *v) {
    float4 la = w->load[pr.LOWER];
    float4 lb = w->load[pr.HIGHER];
    Pair p = pairAt(w, c, w->contact[c], la.LOADED + lb.LOADED);
    float2 fall = fallOfPair(w, pr.LOWER, p.invMassA, pr.HIGHER, p.invMassB);
    readyToSolve(&w->k, &p, lb.BEFORE - la.BEFORE, fall, v);
    return p;
}

// Measures it again. ma, mb: motion.
Pair takeToRelax(const World *w, int c, uint2 pr, float4 ma, float4 mb, Visit *v) {
    float4 n = w->contact[c];
    measureContact(w->base[c], ma, mb, &n);
    Pair p = pairAt(w, c, n, loadedOf(w, pr.LOWER) + loadedOf(w, pr.HIGHER));
    readyToRelax(&w->k, &p, v);
    return p;
}

void visitAt(const World *w, uint2 pr, float4 ma, float4 mb, const Visit *v, bool relaxing, Visited *visited) {
    visitPair(v, ma.VELOCITY, mb.VELOCITY, relaxing, visited);
    if (!visited->leaves) {
        ma.VELOCITY -= changeOfVelocity(v, v->invMassA, visited->impulse);
        mb.VELOCITY += changeOfVelocity(v, v->invMassB, visited->impulse);
        w->motion[pr.LOWER] = ma;
        w->motion[pr.HIGHER] = mb;
    }
}

#ifdef TURNING
// The other rows of a contact of one level; see visitRows.
void visitRowsAt(const World *w, int c, uint2 pr, const Visit *v, const Visited *visited, float along) {
    PairSurface s = surfaceAt(w, c);
    if (!rowsAct(&s)) return;
    RowImpulses i = w->rowImpulses[c];
    float4 q = w->masses[c];
    float4 ma = w->motion[pr.LOWER];
    float4 mb = w->motion[pr.HIGHER];
    Bodies b = {.va = ma.VELOCITY, .vb = mb.VELOCITY, .sa = w->surfaceSpeed[pr.LOWER], .sb = w->surfaceSpeed[pr.HIGHER],
                .wa = q.INVERSE_MASS_A, .wb = q.INVERSE_MASS_B, .ia = w->inverseInertia[pr.LOWER],
                .ib = w->inverseInertia[pr.HIGHER],
                .ra = w->circle[pr.LOWER].RADIUS, .rb = w->circle[pr.HIGHER].RADIUS, .isHeavyA = false, .isHeavyB = false};
    visitRows(&b, &s, &i, v, visited, along);
    ma.VELOCITY = b.va;
    mb.VELOCITY = b.vb;
    w->motion[pr.LOWER] = ma;
    w->motion[pr.HIGHER] = mb;
    w->surfaceSpeed[pr.LOWER] = b.sa;
    w->surfaceSpeed[pr.HIGHER] = b.sb;
    w->rowImpulses[c] = i;
}
#endif

void keepSolved(const World *w, int c, const Visit *v, const Visited *visited) {
    w->masses[c].BOUNCE = v->ready.bounce;
    w->contact[c].NORMAL_IMPULSE = visited->normalImpulse;
    IF_RECORDING(noteSolvedContact(w, w->recording.touch, c, impulseOfFlight(visited));)
}

void keepRelaxed(const World *w, int c, const Pair *p, const Visit *v, const Visited *visited) {
    w->contact[c] = (float4)(p->nx, p->ny, p->separation, visited->normalImpulse);
    IF_RECORDING(noteRelaxedContact(w, w->recording.touch, c, impulseOfBounce(v, visited));)
}

// What the next step starts with, behind the last visit.
void storeVisited(const World *w, int c, uint2 pr, const Visited *visited) {
    float next = visited->normalImpulse;
    IF_TURNING(storeRows(w, c);)
    if (visited->solved && actingImpulse(next, rowsAt(w, c)) > 0.0f) storeImpulse(w, c, w->firstCached + pr.LOWER, (int) w->key[c], next);
}

void solveContact(const World *w, int c) {
    uint2 pr = w->pair[c];
    Visit v;
    Visited visited;
    float4 ma = w->motion[pr.LOWER];
    float4 mb = w->motion[pr.HIGHER];
    takeToSolve(w, c, pr, &v);
    visitAt(w, pr, ma, mb, &v, false, &visited);
    IF_TURNING(float along = speedAlong((float2)(v.nx, v.ny), ma.VELOCITY, mb.VELOCITY);)
    IF_TURNING(if (bouncesFreely(&visited)) visitRowsAt(w, c, pr, &v, &visited, along);)
    keepSolved(w, c, &v, &visited);
}

void relaxContact(const World *w, int c, bool last) {
    uint2 pr = w->pair[c];
    float4 ma = w->motion[pr.LOWER];
    float4 mb = w->motion[pr.HIGHER];
    Visit v;
    Visited visited;
    Pair p = takeToRelax(w, c, pr, ma, mb, &v);
    visitAt(w, pr, ma, mb, &v, true, &visited);
    IF_TURNING(float along = speedAlong((float2)(v.nx, v.ny), ma.VELOCITY, mb.VELOCITY);)
    IF_TURNING(if (!visited.still) visitRowsAt(w, c, pr, &v, &visited, along);)
    if (last) {
        storeVisited(w, c, pr, &visited);
    } else if (carriesOn(&v, &visited, rowsAt(w, c))) {
        gatherLoad(w, pr, loadOf(w, c, (float2)(p.nx, p.ny), visited.normalImpulse), true);
        IF_TURNING(gatherSpin(w, c, pr);)
    }
    keepRelaxed(w, c, &p, &v, &visited);
}

// Index space of both: a group of the colour. Cost: its contacts.

kernel void solver_solve(WORLD_PARAMETERS, int colour RECORDING_PARAMETERS) {
    World w = WORLD;
    RECORD_IN(w);
    int2 contacts = refused(&w) ? (int2)(0) : contactsOfItem(&w, colour);
    for (int c = contacts.x; c < contacts.y; c++) solveContact(&w, c);
}

kernel void solver_relax(WORLD_PARAMETERS, int colour, int last RECORDING_PARAMETERS) {
    World w = WORLD;
    RECORD_IN(w);
    int2 contacts = refused(&w) ? (int2)(0) : contactsOfItem(&w, colour);
    for (int c = contacts.x; c < contacts.y; c++) relaxContact(&w, c, last != 0);
}

// Index space of the others: slots.

kernel void solver_integrateVelocities(WORLD_PARAMETERS, int subStep RECORDING_PARAMETERS) {
    World w = WORLD;
    RECORD_IN(w);
    w.subStep = subStep;
    int slot = (int) get_global_id(0);
    if (slot >= circles || refused(&w)) return;
    startCircleAt(&w, slot, w.motion[slot], w.load[slot]);
}

kernel void solver_integratePositions(WORLD_PARAMETERS, int subStep RECORDING_PARAMETERS) {
    World w = WORLD;
    RECORD_IN(w);
    w.subStep = subStep;
    int slot = (int) get_global_id(0);
    if (slot >= circles || refused(&w)) return;
    moveCircleAt(&w, slot, w.motion[slot], w.load[slot].LOADED);
    w.firstCached[slot] = NONE;
}

kernel void solver_finalizePositions(WORLD_PARAMETERS) {
    World w = WORLD;
    int slot = (int) get_global_id(0);
    if (slot >= circles || refused(&w)) return;
    finalizePositions(&w, slot, w.circle[slot], w.motion[slot], w.traits[slot]);
    w.homeFirstCached[slot] = w.firstCached[slot];
    if (slot == 0) status[STEPS_DONE]++;
}
