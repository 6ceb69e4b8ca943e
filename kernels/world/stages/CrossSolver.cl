// uses: world/shared/Cross.cl world/stages/CrossTurns.cl world/stages/Solver.cl world/stages/Touches.cl
// The cross contacts' part of stage Solver: those of circles of different levels, behind the like contacts of each pass. A pass has two
// launches. In the first, each light circle visits its contacts, and sees the heavy ones as before; its velocity is kept aside, since it
// may be a heavy circle for others. In the second, heavy circles take the sums of what they were given. The Java class
// world.jvm.CrossPasses does the same.

// A cross contact: its circles, of which pair has the one of lower id first.
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

// The arrays as the passes over cross contacts find them. By tiles, each tile has copies of its contacts in the place of others: cross
// contacts lie before these; and a tile leaves the circles' motion apart, since its neighbours may not have read the old one yet.
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

float impulseRangeOf(const World *w, uint slot) { return impulseRange(w->circle[slot].RADIUS, w->k.inverseH, w->traits[slot].INVERSE_MASS); }

global long *sumsOf(const World *w, uint slot) { return (global long *) (w->heavySum + slot); }

// Adds x and y to two sums of a heavy circle, which have a range.
void addToHeavy(global long *sums, float x, float y, float range) {
    float scale = scaleOf(range);
    addFixed(sums, toFixed(x, scale));
    addFixed(sums + 1, toFixed(y, scale));
}

// Adds a contact's impulse to the sums of its circles, and marks them as loaded where it carries. Components are stored one by one:
// others mark the same circles at the same time.
void gatherCrossLoad(const World *w, const Cross *x, float4 n, float normalImpulse, bool carrying) {
    global float *own = (global float *) (w->load + x->light);
    global float *other = (global float *) (w->load + x->heavy);
    float gx = n.NORMAL_X * normalImpulse;
    float gy = n.NORMAL_Y * normalImpulse;
    own[0] = x->isLightLower ? own[0] - gx : own[0] + gx;
    own[1] = x->isLightLower ? own[1] - gy : own[1] + gy;
    if (w->traits[x->heavy].INVERSE_MASS != 0.0f) {
        addToHeavy(sumsOf(w, x->heavy) + 2, x->isLightLower ? gx : -gx, x->isLightLower ? gy : -gy, impulseRangeOf(w, x->heavy));
    }
    if (carrying) {
        own[3] = 1.0f;
        other[3] = 1.0f;
    }
}

void fillCrossContact(const World *w, int c, int light) {
    uint2 p = w->pair[c];
    Cross x = crossOf(w, c, light);
    float4 b = baseOfPair(w, p);
    bool carrying;
    float4 n = newContact(w, p, w->key[c], b, &carrying);
    w->base[c] = b;
    w->masses[c] = (float4)(w->traits[p.LOWER].INVERSE_MASS, w->traits[p.HIGHER].INVERSE_MASS, pushSpeed(&w->k, b.RADII), 0.0f);
    w->contact[c] = n;
    if (w->k.tiled) w->ordered[c] = p;
    gatherCrossLoad(w, &x, n, n.NORMAL_IMPULSE, carrying);
}

// Orders and fills the cross contacts of a light circle.
void fillCrossOf(const World *w, int slot) {
    int from = w->groupStart[crossGroupOf(w, slot)];
    int to = w->groupStart[crossGroupOf(w, slot) + 1];
    if (from == to) return;
    sortContacts(w->key + from, w->pair + from, to - from);
    for (int c = from; c < to; c++) fillCrossContact(w, c, slot);
}

// Index space: a working slot a work-item. Cost: the contacts in which the circle is the light one.
kernel void cross_fill(WORLD_PARAMETERS) {
    World w = WORLD;
    int slot = (int) get_global_id(0);
    if (slot >= circles || outOfRoom(&w) || tooFast(&w)) return;
    w = crossWorld(w);
    fillCrossOf(&w, slot);
}

// Visits a contact, and applies the impulse. v: velocity of the light circle; q, n: masses and contact. Returns the normal speed
// afterwards, as if the heavy circle had taken its part.
float visitCross(const World *w, const Cross *x, float restitution, float4 q, float4 n, Ready *ready, bool relaxing, float2 *v, Visited *visited) {
    float wl = x->isLightLower ? q.INVERSE_MASS_A : q.INVERSE_MASS_B;
    float wh = x->isLightLower ? q.INVERSE_MASS_B : q.INVERSE_MASS_A;
    float2 heavy = w->motion[x->heavy].VELOCITY;
    float2 toward = x->isLightLower ? heavy - *v : *v - heavy;
    float vn = along(n.NORMAL_X, n.NORMAL_Y, toward.x, toward.y);
    ready->mass = crossMass(wl, wh, crossShare(w->crossLoad[x->heavy]));
    visit(ready, vn, relaxing, visited);
    if (!visited->leaves && !visited->solved) {
        visited->leaves = waitsForTurn(w, x->light, x->heavy, restitution, wh, relaxing ? n.SEPARATION : n.SEPARATION + vn * w->k.h, relaxing);
    }
    float impulse = visited->impulse;
    if (!visited->leaves) {
        float lx = velocityChange(n.NORMAL_X, wl, impulse);
        float ly = velocityChange(n.NORMAL_Y, wl, impulse);
        float hx = velocityChange(n.NORMAL_X, wh, impulse);
        float hy = velocityChange(n.NORMAL_Y, wh, impulse);
        *v = x->isLightLower ? (float2)(v->x - lx, v->y - ly) : (float2)(v->x + lx, v->y + ly);
        if (wh != 0.0f) {
            addToHeavy(sumsOf(w, x->heavy), x->isLightLower ? hx : -hx, x->isLightLower ? hy : -hy, velocityRangeOf(w, x->heavy));
        }
    }
    return vn + impulse * (q.INVERSE_MASS_A + q.INVERSE_MASS_B);
}

// The biased pass over one contact. v: velocity of the light circle. Returns the impulse of a free bounce, or 0.
float solveCrossContact(const World *w, int c, int light, float2 *v) {
    Cross x = crossOf(w, c, light);
    float4 q = w->masses[c];
    float4 n = w->contact[c];
    Ready ready;
    readyToSolve(w, c, w->pair[c], q, n, &ready);
    Visited visited;
    visitCross(w, &x, w->base[c].PAIR_RESTITUTION, q, n, &ready, false, v, &visited);
    w->masses[c].BOUNCE = ready.bounce;
    w->contact[c].NORMAL_IMPULSE = visited.normalImpulse;
    return visited.leaves || visited.solved ? 0.0f : visited.impulse;
}

// Stores a contact's impulse for the step to come, while others do the same for the same circle: it is looked up by id.
void storeCrossImpulse(const World *w, int c, uint lower, float normalImpulse) {
    int next = atomic_xchg(&w->firstCached[lower], c);
    w->impulseCache[c] = cacheEntry((int) w->key[c], normalImpulse, next);
}

// Measures a contact again, makes the relaxing pass over it, and sums up for what follows. Returns the impulse of a bounce, or 0.
float relaxCrossContact(const World *w, int c, int light, bool last, float2 *v) {
    Cross x = crossOf(w, c, light);
    uint2 pr = w->pair[c];
    float4 q = w->masses[c];
    float4 n = w->contact[c];
    Ready ready;
    readyToRelax(w, pr, w->base[c], q, w->motion[pr.LOWER], w->motion[pr.HIGHER], &n, &ready);
    Visited visited;
    float vn = visitCross(w, &x, w->base[c].PAIR_RESTITUTION, q, n, &ready, true, v, &visited);
    float next = visited.normalImpulse;
    w->contact[c] = (float4)(n.NORMAL_X, n.NORMAL_Y, n.SEPARATION, next);
    if (!visited.solved) return visited.leaves ? 0.0f : visited.impulse;
    if (last) {
        if (next > 0.0f) storeCrossImpulse(w, c, pr.LOWER, next);
    } else if (carries(next, vn, ready.restingLimit)) {
        gatherCrossLoad(w, &x, n, next, true);
    }
    return ready.bounce > 0.0f ? n.NORMAL_IMPULSE + visited.impulse : 0.0f;
}

// Gives a light circle its velocity behind its visits: kept aside if it is a heavy one for others, which still look at it.
void leaveLight(const World *w, int slot, float2 v) {
    if (w->crossLoad[slot] > 0) {
        w->lightVelocity[slot] = v;
    } else {
        w->motion[slot].VELOCITY = v;
    }
}

// The biased pass over the cross contacts of a light circle.
void solveCrossOf(const World *w, int slot) {
    int from = w->groupStart[crossGroupOf(w, slot)];
    int to = w->groupStart[crossGroupOf(w, slot) + 1];
    if (from == to) return;
    float2 v = w->motion[slot].VELOCITY;
    for (int c = from; c < to; c++) {
        float notKept = solveCrossContact(w, c, slot, &v);
#ifdef RECORDING
        noteSolvedContact(w, w->recording.touch, c, notKept);
#endif
    }
    leaveLight(w, slot, v);
}

// The relaxing pass over the cross contacts of a light circle.
void relaxCrossOf(const World *w, int slot, bool last) {
    int from = w->groupStart[crossGroupOf(w, slot)];
    int to = w->groupStart[crossGroupOf(w, slot) + 1];
    if (from == to) return;
    float2 v = w->motion[slot].VELOCITY;
    for (int c = from; c < to; c++) {
        float bounced = relaxCrossContact(w, c, slot, last, &v);
#ifdef RECORDING
        noteRelaxedContact(w, w->recording.touch, c, bounced);
#endif
    }
    leaveLight(w, slot, v);
}

// Index space of the next: a working slot a work-item. Cost: the contacts in which the circle is the light one.

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

// Whether a circle takes what it is given as the heavy one of a contact.
bool isHeavy(const World *w, int slot) { return w->crossLoad[slot] > 0 && w->traits[slot].INVERSE_MASS != 0.0f; }

// The velocity of a heavy circle behind a pass. v: as like contacts have left it.
float2 velocityTaken(const World *w, int slot, float2 v) {
    if (isLight(w, slot)) v = w->lightVelocity[slot];
    long4 sum = w->heavySum[slot];
    float unit = unitOf(velocityRangeOf(w, (uint) slot));
    return (float2)(v.x + fromFixed(sum.x, unit), v.y + fromFixed(sum.y, unit));
}

// The sum of a heavy circle's impulses for the sub-step to come. impulses: all but those that it is given as the heavy one.
float2 impulsesTaken(const World *w, int slot, float2 impulses) {
    long4 sum = w->heavySum[slot];
    float unit = unitOf(impulseRangeOf(w, (uint) slot));
    return (float2)(impulses.x + fromFixed(sum.z, unit), impulses.y + fromFixed(sum.w, unit));
}

// Gives a heavy circle what a pass has for it: velocity, and impulses for the sub-step to come. Sums are empty afterwards.
void takeCross(const World *w, int slot, bool velocities, bool impulses) {
    if (!isHeavy(w, slot)) return;
    if (velocities) {
        float2 v = w->motion[slot].VELOCITY;
        w->motion[slot].VELOCITY = velocityTaken(w, slot, v);
    }
    if (impulses) {
        float2 sum = w->load[slot].IMPULSES;
        w->load[slot].IMPULSES = impulsesTaken(w, slot, sum);
        w->claim[slot] = 0;
    }
    w->heavySum[slot] = (long4)(0);
}

// Index space: a working slot a work-item.
kernel void cross_take(WORLD_PARAMETERS, int velocities, int impulses) {
    World w = WORLD;
    int slot = (int) get_global_id(0);
    if (slot >= circles || refused(&w)) return;
    takeCross(&w, slot, velocities != 0, impulses != 0);
}
