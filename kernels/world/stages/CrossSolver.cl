// uses: world/shared/CrossRule.cl world/stages/CrossTurns.cl world/shared/PairRows.cl world/stages/Solver.cl
// Cross contacts, behind the like contacts of each pass, in two launches. Light circles visit theirs and see heavy ones as before; then
// heavy circles take the sums. The Java class world.jvm.solver.CrossBodies does the same.

// pair has the circle of lower id first.
typedef struct {
    uint light, heavy;
    bool isLightLower;
} Cross;

Cross crossOf(const World *w, int c, int light) {
    uint2 p = w->pair[c];
    Cross x;
    x.isLightLower = p.LOWER == (uint) light;
    x.light = (uint) light;
    x.heavy = x.isLightLower ? p.HIGHER : p.LOWER;
    return x;
}

// By tiles, copies lie behind cross contacts, and tiles leave the circles' motion apart: neighbours may not have read the old one yet.
World crossWorld(World w) {
    if (w.k.tiled) {
        int like = likeContacts(&w);
        w.contact -= like;
        w.base -= like;
        w.motion = w.solvedMotion;
    }
    return w;
}

float velocityRangeOf(const World *w, uint slot) { return velocityRange(w->circle[slot].RADIUS, w->k.inverseH); }
float impulseRangeOf(const World *w, uint slot) {
    return impulseRange(w->circle[slot].RADIUS, w->k.inverseH, w->traits[slot].INVERSE_MASS);
}
global long *sumsOf(const World *w, uint slot) { return (global long *) (w->heavySum + slot); }

// range: of the sums.
void addToHeavy(global long *sums, float2 value, float range) {
    float scale = scaleOf(range);
    addFixed(sums, toFixed(value.x, scale));
    addFixed(sums + 1, toFixed(value.y, scale));
}

// g: see loadAlong. Stored one by one: others mark the same circles at the same time.
void gatherCrossLoad(const World *w, const Cross *x, float2 g, bool carrying) {
    global float *own = (global float *) (w->load + x->light);
    global float *other = (global float *) (w->load + x->heavy);
    global float *sum = own + IMPULSES_AT;
    sum[0] = x->isLightLower ? sum[0] - g.x : sum[0] + g.x;
    sum[1] = x->isLightLower ? sum[1] - g.y : sum[1] + g.y;
    if (w->traits[x->heavy].INVERSE_MASS != 0.0f) {
        addToHeavy(sumsOf(w, x->heavy) + 2, x->isLightLower ? g : -g, impulseRangeOf(w, x->heavy));
    }
    if (carrying) {
        own[LOADED_NEXT_AT] = 1.0f;
        other[LOADED_NEXT_AT] = 1.0f;
    }
}

#ifdef TURNING
// By tiles, tiles leave it apart, as the circles' motion.
global float *crossSpeeds(const World *w) { return w->k.tiled ? w->solvedSpin : w->surfaceSpeed; }

// As gatherSpin.
void gatherCrossSpin(const World *w, int c, const Cross *x) {
    PairSurface s = surfaceAt(w, c);
    if (!rowsAct(&s)) return;
    float2 of = spinImpulses(w, w->pair[c], &s, w->rowImpulses[c]);
    w->spinImpulse[x->light] += x->isLightLower ? of.x : of.y;
    if (w->traits[x->heavy].INVERSE_MASS != 0.0f) {
        addFixed((global long *) (w->heavySpin + x->heavy) + 1,
                 toFixed(x->isLightLower ? of.y : of.x, scaleOf(impulseRangeOf(w, x->heavy))));
    }
}

float crossSpeedAlong(const World *w, const Cross *x, float2 n, float2 v) {
    float2 heavy = w->motion[x->heavy].VELOCITY;
    return speedAlong(n, x->isLightLower ? v : heavy, x->isLightLower ? heavy : v);
}

// As visitRowsAt. v, s: velocity and surface speed of the light circle.
void visitCrossRows(const World *w, int c, const Cross *x, const Visit *visit_, const Visited *visited, float along, float2 *v, float *s) {
    PairSurface surface = surfaceAt(w, c);
    if (!rowsAct(&surface)) return;
    RowImpulses i = w->rowImpulses[c];
    float4 q = w->masses[c];
    uint2 pr = w->pair[c];
    bool lower = x->isLightLower;
    float2 vHeavy = w->motion[x->heavy].VELOCITY;
    float sHeavy = crossSpeeds(w)[x->heavy];
    bool moves = w->traits[x->heavy].INVERSE_MASS != 0.0f;
    Bodies b = {.va = lower ? *v : vHeavy, .vb = lower ? vHeavy : *v, .sa = lower ? *s : sHeavy, .sb = lower ? sHeavy : *s,
                .wa = q.INVERSE_MASS_A, .wb = q.INVERSE_MASS_B, .ia = w->inverseInertia[pr.LOWER],
                .ib = w->inverseInertia[pr.HIGHER], .ra = w->circle[pr.LOWER].RADIUS, .rb = w->circle[pr.HIGHER].RADIUS,
                .isHeavyA = !lower, .isHeavyB = lower, .scale = scaleOf(velocityRangeOf(w, x->heavy)),
                .velocitySums = moves ? sumsOf(w, x->heavy) : 0,
                .spinSum = moves ? (global long *) (w->heavySpin + x->heavy) : 0};
    visitRows(&b, &surface, &i, visit_, visited, along);
    *v = lower ? b.va : b.vb;
    *s = lower ? b.sa : b.sb;
    w->rowImpulses[c] = i;
}
#endif

void fillCrossContact(const World *w, int c, int light) {
    Cross x = crossOf(w, c, light);
    IF_TURNING(fillRows(w, c, w->pair[c], (int) w->key[c], x.light, x.heavy, crossShare(w->crossLoad[x.heavy]));)
    IF_TURNING(gatherCrossSpin(w, c, &x);)
    bool carrying;
    float4 n = fillContact(w, c, &carrying);
    if (w->k.tiled) w->ordered[c] = w->pair[c];
    gatherCrossLoad(w, &x, loadOf(w, c, n.NORMAL, n.NORMAL_IMPULSE), carrying);
}

void fillCrossOf(const World *w, int slot) {
    int from = w->groupStart[crossGroupOf(w, slot)];
    int to = w->groupStart[crossGroupOf(w, slot) + 1];
    if (from == to) return;
    sortContacts(w->key + from, w->pair + from, to - from);
    for (int c = from; c < to; c++) fillCrossContact(w, c, slot);
}

// Index space: slots. Cost: the contacts as the light circle.
kernel void cross_fill(WORLD_PARAMETERS) {
    World w = WORLD;
    int slot = (int) get_global_id(0);
    if (slot >= circles || outOfRoom(&w) || tooFast(&w)) return;
    w = crossWorld(w);
    fillCrossOf(&w, slot);
}

// v: velocity of the light circle. The effective mass counts the heavy one as lighter, since others visit it at the same time.
void visitCross(const World *w, const Cross *x, const Pair *p, Visit *visit_, bool relaxing, float2 *v, Visited *visited) {
    float invLight = x->isLightLower ? p->invMassA : p->invMassB;
    float invHeavy = x->isLightLower ? p->invMassB : p->invMassA;
    float2 heavy = w->motion[x->heavy].VELOCITY;
    visit_->ready.mass = crossMass(awakeInverseMass(w->circle[x->light], invLight), awakeInverseMass(w->circle[x->heavy], invHeavy),
                                   crossShare(w->crossLoad[x->heavy])); // see massOfPair
    visitPair(visit_, x->isLightLower ? *v : heavy, x->isLightLower ? heavy : *v, relaxing, visited);
    if (!visited->leaves && !visited->solved) {
        float separation = relaxing ? p->separation : p->separation + visited->vn * w->k.h;
        visited->leaves = waitsForTurn(w, x->light, x->heavy, p->restitution, invHeavy, separation, relaxing);
    }
    if (!visited->leaves) {
        float2 toLight = changeOfVelocity(visit_, invLight, visited->impulse);
        float2 toHeavy = changeOfVelocity(visit_, invHeavy, visited->impulse);
        *v = x->isLightLower ? *v - toLight : *v + toLight;
        if (invHeavy != 0.0f) {
            addToHeavy(sumsOf(w, x->heavy), x->isLightLower ? toHeavy : -toHeavy, velocityRangeOf(w, x->heavy));
        }
    }
}

void solveCrossContact(const World *w, int c, int light, float2 *v AND_TURNING(float *s)) {
    Cross x = crossOf(w, c, light);
    Visit visit_;
    Visited visited;
    Pair p = takeToSolve(w, c, w->pair[c], &visit_);
    IF_TURNING(float along = crossSpeedAlong(w, &x, (float2)(p.nx, p.ny), *v);)
    visitCross(w, &x, &p, &visit_, false, v, &visited);
    IF_TURNING(if (bouncesFreely(&visited)) visitCrossRows(w, c, &x, &visit_, &visited, along, v, s);)
    keepSolved(w, c, &visit_, &visited);
}

void relaxCrossContact(const World *w, int c, int light, bool last, float2 *v AND_TURNING(float *s)) {
    Cross x = crossOf(w, c, light);
    uint2 pr = w->pair[c];
    Visit visit_;
    Visited visited;
    Pair p = takeToRelax(w, c, pr, w->motion[pr.LOWER], w->motion[pr.HIGHER], &visit_);
    IF_TURNING(float along = crossSpeedAlong(w, &x, (float2)(p.nx, p.ny), *v);)
    visitCross(w, &x, &p, &visit_, true, v, &visited);
    IF_TURNING(if (!visited.still) visitCrossRows(w, c, &x, &visit_, &visited, along, v, s);)
    if (last) {
        storeVisited(w, c, pr, &visited);
    } else if (carriesOn(&visit_, &visited, rowsAt(w, c))) {
        gatherCrossLoad(w, &x, loadOf(w, c, (float2)(p.nx, p.ny), visited.normalImpulse), true);
        IF_TURNING(gatherCrossSpin(w, c, &x);)
    }
    keepRelaxed(w, c, &p, &visit_, &visited);
}

// Others still look at the velocity of one that is heavy for them.
void leaveLight(const World *w, int slot, float2 v AND_TURNING(float s)) {
    if (w->crossLoad[slot] > 0) {
        w->lightVelocity[slot] = v;
        IF_TURNING(w->lightSpin[slot] = s;)
    } else {
        w->motion[slot].VELOCITY = v;
        IF_TURNING(crossSpeeds(w)[slot] = s;)
    }
}

// last: of the last sub-step.
INLINE void passCrossOf(const World *w, int slot, bool relaxing, bool last) {
    int from = w->groupStart[crossGroupOf(w, slot)];
    int to = w->groupStart[crossGroupOf(w, slot) + 1];
    if (from == to) return;
    float2 v = w->motion[slot].VELOCITY;
    IF_TURNING(float s = crossSpeeds(w)[slot];)
    for (int c = from; c < to; c++) {
        if (relaxing) {
            relaxCrossContact(w, c, slot, last, &v AND_TURNING(&s));
        } else {
            solveCrossContact(w, c, slot, &v AND_TURNING(&s));
        }
    }
    leaveLight(w, slot, v AND_TURNING(s));
}

void solveCrossOf(const World *w, int slot) { passCrossOf(w, slot, false, false); }
void relaxCrossOf(const World *w, int slot, bool last) { passCrossOf(w, slot, true, last); }

// Index space of both: slots. Cost: the contacts as the light circle.

kernel void cross_solve(WORLD_PARAMETERS RECORDING_PARAMETERS) {
    World w = WORLD;
    RECORD_IN(w);
    int slot = (int) get_global_id(0);
    if (slot >= circles || refused(&w)) return;
    w = crossWorld(w);
    solveCrossOf(&w, slot);
}

kernel void cross_relax(WORLD_PARAMETERS, int last RECORDING_PARAMETERS) {
    World w = WORLD;
    RECORD_IN(w);
    int slot = (int) get_global_id(0);
    if (slot >= circles || refused(&w)) return;
    if (w.k.tiled) w.firstCached = w.homeFirstCached;
    w = crossWorld(w);
    relaxCrossOf(&w, slot, last != 0);
}

bool isLight(const World *w, int slot) {
    return w->groupStart[crossGroupOf(w, slot)] != w->groupStart[crossGroupOf(w, slot) + 1];
}

// A static one takes nothing.
bool isHeavy(const World *w, int slot) { return w->crossLoad[slot] > 0 && w->traits[slot].INVERSE_MASS != 0.0f; }

// v: as like contacts have left it.
float2 velocityTaken(const World *w, int slot, float2 v) {
    if (isLight(w, slot)) v = w->lightVelocity[slot];
    long4 sum = w->heavySum[slot];
    float unit = unitOf(velocityRangeOf(w, (uint) slot));
    return (float2)(v.x + fromFixed(sum.x, unit), v.y + fromFixed(sum.y, unit));
}

// impulses: all others.
float2 impulsesTaken(const World *w, int slot, float2 impulses) {
    long4 sum = w->heavySum[slot];
    float unit = unitOf(impulseRangeOf(w, (uint) slot));
    return (float2)(impulses.x + fromFixed(sum.z, unit), impulses.y + fromFixed(sum.w, unit));
}

#ifdef TURNING
// As takeSums.
void takeSpinSums(const World *w, int slot, bool speeds, bool impulses) {
    long2 sum = w->heavySpin[slot];
    if (speeds) {
        global float *s = crossSpeeds(w) + slot;
        *s = (isLight(w, slot) ? w->lightSpin[slot] : *s) + fromFixed(sum.x, unitOf(velocityRangeOf(w, (uint) slot)));
    }
    if (impulses) w->spinImpulse[slot] += fromFixed(sum.y, unitOf(impulseRangeOf(w, (uint) slot)));
    w->heavySpin[slot] = (long2)(0);
}
#endif

// Gives a heavy circle what a pass has for it; its sums are empty afterwards. m: motion; l: load.
void takeSums(const World *w, int slot, bool velocities, bool impulses, float4 *m, float4 *l) {
    if (hasOneLevel(w) || !isHeavy(w, slot)) return;
    if (velocities) m->VELOCITY = velocityTaken(w, slot, m->VELOCITY);
    if (impulses) {
        l->IMPULSES = impulsesTaken(w, slot, l->IMPULSES);
        w->claim[slot] = 0;
    }
    w->heavySum[slot] = (long4)(0);
    IF_TURNING(takeSpinSums(w, slot, velocities, impulses);)
}

// Index space: slots.
kernel void cross_take(WORLD_PARAMETERS, int velocities, int impulses) {
    World w = WORLD;
    int slot = (int) get_global_id(0);
    if (slot >= circles || refused(&w) || !isHeavy(&w, slot)) return;
    w = crossWorld(w);
    float4 m = w.motion[slot];
    float4 l = w.load[slot];
    takeSums(&w, slot, velocities != 0, impulses != 0, &m, &l);
    w.motion[slot] = m;
    w.load[slot] = l;
}
