// Stage Solver: moves the circles through the sub-steps of a step, and writes them home. The Java class JvmSolver is the
// same, function by function.

// One axis of a circle against the wall that it is nearer to: biased pass. before: velocity along the axis before any
// impulse; v: after those of its contacts; stored: the wall's impulse, positive for the lower wall. Returns the new velocity
// along the axis.
float pushFromWall(const World *w, float x, float *dx, float before, float v, float r, float e, bool loaded, float min,
                   float max, float *stored, float *bounceOut) {
    const StepConstants *k = &w->k;
    float side = wallSide(x, min, max);
    float gap = wallGap(x, *dx, r, side, min, max);
    float lambda = wallImpulse(*stored, side);
    v += side * lambda;
    float vn = side * v;
    float thr2 = thresholdOf(w, 2.0f * r, e);
    float bounce = e > 0.0f && loaded ? bounceSpeed(e, side * before, gap, k->h, thr2) : 0.0f;
    int visit = e > 0.0f && !loaded ? freeFlight(vn, gap * k->inverseH + vn < 0.0f, thr2) : SOLVE;
    float next = lambda;
    float p;
    if (visit == SOLVE) {
        if (bounce > 0.0f) {
            next = rigid(lambda, 1.0f, vn, -bounce);
        } else if (gap > 0.0f) {
            next = rigid(lambda, 1.0f, vn, gap * k->inverseH);
        } else {
            next = soft(lambda, 1.0f, vn, gap, pushSpeed(2.0f * r, k->pushPerLength, k->pushPerRoot), k->wallBiasRate,
                        k->wallMassScale, k->wallImpulseScale);
        }
        p = next - lambda;
    } else {
        p = visit == BOUNCE ? freeBounce(e, vn, 1.0f) : 0.0f;
        *dx -= leftBehind(gap, vn, side * p, k->dt, r);
    }
    *stored = side * next;
    *bounceOut = bounce;
    return v + side * p;
}

// Gravity, the impulses of the sub-step before, and the biased pass over the walls, for one circle: changes motion m and
// the wall impulses in traits t; l: its sums of impulses, and whether one of its contacts carries. Gives the velocity
// before any impulse, the target speeds of bounces off walls, and whether the circle is loaded.
void accelerate(const World *w, float4 c, float4 *m, float4 *t, float4 l, float2 *before, float2 *bounce, bool *loaded) {
    const StepConstants *k = &w->k;
    if (t->x == 0.0f) {
        *before = (float2)(m->z, m->w);
        *bounce = (float2)(0.0f);
        *loaded = false;
        return;
    }
    float vx = m->z + k->gravityStepX;
    float vy = m->w + k->gravityStepY;
    *before = (float2)(vx, vy);
    *loaded = l.w > 0.0f || t->z != 0.0f || t->w != 0.0f;
    float nextX, nextY;
    // A loop over the axes: half the instructions to fetch.
#pragma unroll 1
    for (int axis = 0; axis < 2; axis++) {
        bool y = axis != 0;
        float v = y ? vy : vx;
        float wall = y ? t->w : t->z;
        float target;
        float dx = y ? m->y : m->x;
        float next = pushFromWall(w, y ? c.y : c.x, &dx, v, limitSpeed(v + t->x * (y ? l.y : l.x)), c.z, t->y,
                                  *loaded, y ? k->minY : k->minX, y ? k->maxY : k->maxX, &wall, &target);
        if (y) {
            nextY = next;
            m->y = dx;
            t->w = wall;
            bounce->y = target;
        } else {
            nextX = next;
            m->x = dx;
            t->z = wall;
            bounce->x = target;
        }
    }
    m->z = nextX;
    m->w = nextY;
}

// Index space: a working slot a work-item.
kernel void solver_accelerate(WORLD_PARAMETERS) {
    World w = WORLD;
    int slot = (int) get_global_id(0);
    if (slot >= circles || refused(&w)) return;
    float4 m = motion[slot];
    float4 t = traits[slot];
    float4 l = load[slot];
    float2 before, bounce;
    bool loaded;
    accelerate(&w, circle[slot], &m, &t, l, &before, &bounce, &loaded);
    motion[slot] = m;
    traits[slot] = t;
    wallBounce[slot] = bounce;
    load[slot] = (float4)(before.x, before.y, loaded ? 1.0f : 0.0f, l.w);
}

void applyImpulse(const World *w, uint2 pr, float4 mi, float4 mj, float nx, float ny, float wi, float wj, float p) {
    mi.z -= nx * (wi * p);
    mi.w -= ny * (wi * p);
    mj.z += nx * (wj * p);
    mj.w += ny * (wj * p);
    w->motion[pr.x] = mi;
    w->motion[pr.y] = mj;
}

// The biased pass over one contact: stops approaches, pushes overlaps out, bounces. n: normal x, y, separation, accumulated
// impulse; vn: normal speed; before: the same before any impulse; push: greatest push-out speed. Gives the new accumulated
// impulse, the target speed of a bounce, and the impulse p to apply; returns false where there is none to apply.
bool pushImpulse(const World *w, float4 n, float e, float thr2, float mass, float push, float vn, float before,
                 bool loaded, float *next, float *bounce, float *p) {
    const StepConstants *k = &w->k;
    float s = n.z;
    float lambda = n.w;
    *next = lambda;
    *bounce = e > 0.0f && loaded ? bounceSpeed(e, before, s, k->h, thr2) : 0.0f;
    bool free = e > 0.0f && !loaded && lambda == 0.0f;
    int visit = free ? freeFlight(vn, s * k->inverseH + vn < 0.0f, thr2) : SOLVE;
    if (visit == LEAVE) return false;
    if (visit == BOUNCE) {
        *p = freeBounce(e, vn, mass);
        return true;
    }
    if (*bounce > 0.0f) {
        *next = rigid(lambda, mass, vn, -*bounce);
    } else if (s > 0.0f) {
        *next = rigid(lambda, mass, vn, s * k->inverseH);
    } else {
        *next = soft(lambda, mass, vn, s, push, k->biasRate, k->massScale, k->impulseScale);
    }
    *p = *next - lambda;
    return true;
}

void pushContact(const World *w, int c) {
    uint2 pr = w->pair[c];
    float4 b = w->base[c];
    float4 q = w->masses[c];
    float4 n = w->contact[c];
    float4 mi = w->motion[pr.x];
    float4 mj = w->motion[pr.y];
    float4 li = w->load[pr.x];
    float4 lj = w->load[pr.y];
    float vn = along(n.x, n.y, mj.z - mi.z, mj.w - mi.w);
    float before = along(n.x, n.y, lj.x - li.x, lj.y - li.y);
    float next, bounce, p;
    bool moves = pushImpulse(w, n, b.w, thresholdOf(w, b.z, b.w), 1.0f / (q.x + q.y), q.z, vn, before,
                             li.z + lj.z > 0.0f, &next, &bounce, &p);
    w->masses[c].w = bounce;
    w->contact[c].w = next;
    if (moves) applyImpulse(w, pr, mi, mj, n.x, n.y, q.x, q.y, p);
}

// Index space: a group of one colour a work-item. Cost: its contacts.
kernel void solver_push(WORLD_PARAMETERS, int level, int colour) {
    World w = WORLD;
    int g = (int) get_global_id(0);
    if (g >= groupsOfColour(&w, level) || refused(&w)) return;
    int group = firstOfColour(&w, level, colour) + g;
    int to = groupStart[group + 1];
    for (int c = groupStart[group]; c < to; c++) pushContact(&w, c);
}

// One axis of a circle against its wall: relaxing pass. Returns the new velocity along the axis.
float relaxAtWall(const World *w, float x, float dx, float v, float r, float e, bool loaded, float bounce, float min,
                  float max, float *stored) {
    const StepConstants *k = &w->k;
    float side = wallSide(x, min, max);
    float gap = wallGap(x, dx, r, side, min, max);
    float lambda = wallImpulse(*stored, side);
    float vn = side * v;
    if (lambda == 0.0f && bounce == 0.0f && gap > 0.0f) return v;
    bool free = lambda == 0.0f && bounce == 0.0f && e > 0.0f && !loaded;
    int visit = free ? freeFlight(vn, true, thresholdOf(w, 2.0f * r, e)) : SOLVE;
    if (visit == LEAVE) return v;
    if (visit == BOUNCE) return v + side * freeBounce(e, vn, 1.0f);
    float b = bounce > 0.0f ? -bounce : gap > 0.0f ? gap * k->inverseH : 0.0f;
    float next = rigid(lambda, 1.0f, vn, b);
    *stored = bounce > 0.0f ? 0.0f : side * next;
    return v + side * (next - lambda);
}

// Keeps a circle's displacement on its leash: no farther from the free part of its path than it is allowed.
float2 onLeash(const World *w, int slot, float r, float dx, float dy) {
    float allowance = LEASH * r;
    float square = dx * dx + dy * dy;
    if (w->k.sweeping) allowance = w->leash[slot].z;
    if (!(square > 0.0f) || !(square > allowance * allowance)) return (float2)(dx, dy);
    float4 leash = w->leash[slot];
    float share = nearest(dx, dy, leash.x, leash.y);
    float offX = dx - share * leash.x;
    float offY = dy - share * leash.y;
    float off = norm(offX, offY);
    if (!(off > allowance)) return (float2)(dx, dy);
    float keep = allowance / off;
    return (float2)(share * leash.x + keep * offX, share * leash.y + keep * offY);
}

// Moves a circle, and keeps it within the walls. m: its motion; returns what that becomes.
float4 displace(const World *w, int slot, float4 c, float4 m, bool fixed) {
    const StepConstants *k = &w->k;
    float vx = limitSpeed(m.z);
    float vy = limitSpeed(m.w);
    float2 d = (float2)(m.x + vx * k->h, m.y + vy * k->h);
    if (!fixed) d = onLeash(w, slot, c.z, d.x, d.y);
    float edge = fixed ? 0.0f : c.z;
    float dx = within(c.x, d.x, k->minX + edge, k->maxX - edge);
    float dy = within(c.y, d.y, k->minY + edge, k->maxY - edge);
    if (fixed) {
        // a fixed circle that is stopped has stopped: what lies on it must not see it go on
        vx = dx == d.x ? vx : 0.0f;
        vy = dy == d.y ? vy : 0.0f;
    }
    return (float4)(dx, dy, vx, vy);
}

// The relaxing pass over the walls for a circle that has moved: changes the velocity in motion m and the wall impulses in
// traits t.
void relaxAtWalls(const World *w, float4 c, float4 *m, float4 *t, float2 bounce, bool loaded) {
    const StepConstants *k = &w->k;
#pragma unroll 1
    for (int axis = 0; axis < 2; axis++) {
        bool y = axis != 0;
        float wall = y ? t->w : t->z;
        float next = relaxAtWall(w, y ? c.y : c.x, y ? m->y : m->x, y ? m->w : m->z, c.z, t->y, loaded,
                                 y ? bounce.y : bounce.x, y ? k->minY : k->minX, y ? k->maxY : k->maxX, &wall);
        if (y) {
            m->w = next;
            t->w = wall;
        } else {
            m->z = next;
            t->z = wall;
        }
    }
}

// Moves a circle, keeps it within the walls, and makes the relaxing pass over the walls: changes motion m and the wall
// impulses in traits t.
void moveCircle(const World *w, int slot, float4 c, float4 *m, float4 *t, float2 bounce, bool loaded) {
    bool fixed = t->x == 0.0f;
    *m = displace(w, slot, c, *m, fixed);
    if (!fixed) relaxAtWalls(w, c, m, t, bounce, loaded);
}

// Index space: a working slot a work-item.
kernel void solver_move(WORLD_PARAMETERS) {
    World w = WORLD;
    int slot = (int) get_global_id(0);
    if (slot >= circles || refused(&w)) return;
    float4 m = motion[slot];
    float4 t = traits[slot];
    float loaded = load[slot].z;
    moveCircle(&w, slot, circle[slot], &m, &t, wallBounce[slot], loaded > 0.0f);
    motion[slot] = m;
    traits[slot] = t;
    load[slot] = (float4)(0.0f, 0.0f, loaded, 0.0f);
    memory[slot] = NONE;
}

// Remembers a contact's impulse for the step to come.
void remember(const World *w, int c, uint2 pr, float lambda) {
    w->old[c] = (int4)((int) w->key[c], as_int(lambda), w->memory[pr.x], 0);
    w->memory[pr.x] = c;
}

// The relaxing pass over one contact, measured anew: takes the push-out speed away again. unloaded: neither circle is
// loaded. Gives the new accumulated impulse, the impulse p to apply, and whether the contact was solved rather than left
// alone or bounced; returns false where there is no impulse to apply.
bool relaxImpulse(const World *w, float4 n, float e, float thr2, float mass, float vn, float bounce, bool unloaded,
                  float *next, float *p, bool *solved) {
    float s = n.z;
    float lambda = n.w;
    *next = lambda;
    *solved = false;
    if (lambda == 0.0f && bounce == 0.0f) {
        if (s > 0.0f) return false;
        if (e > 0.0f && unloaded) {
            int visit = freeFlight(vn, true, thr2);
            if (visit == LEAVE) return false;
            if (visit == BOUNCE) {
                *p = freeBounce(e, vn, mass);
                return true;
            }
        }
    }
    float bias = bounce > 0.0f ? -bounce : s > 0.0f ? s * w->k.inverseH : 0.0f;
    *next = rigid(lambda, mass, vn, bias);
    *p = *next - lambda;
    if (bounce > 0.0f) *next = 0.0f;
    *solved = true;
    return true;
}

// Measures a contact anew, makes the relaxing pass over it, and sums up for what follows.
void relaxContact(const World *w, int c, bool last) {
    uint2 pr = w->pair[c];
    float4 b = w->base[c];
    float4 q = w->masses[c];
    float4 n = w->contact[c];
    float4 mi = w->motion[pr.x];
    float4 mj = w->motion[pr.y];
    measure(&n, b.x, b.y, b.z, mi.xy, mj.xy);
    float vn = along(n.x, n.y, mj.z - mi.z, mj.w - mi.w);
    float thr2 = thresholdOf(w, b.z, b.w);
    float next, p;
    bool solved;
    bool moves = relaxImpulse(w, n, b.w, thr2, 1.0f / (q.x + q.y), vn, q.w, w->load[pr.x].z + w->load[pr.y].z == 0.0f,
                              &next, &p, &solved);
    w->contact[c] = (float4)(n.x, n.y, n.z, next);
    if (moves) applyImpulse(w, pr, mi, mj, n.x, n.y, q.x, q.y, p);
    if (!solved) return;
    if (last) {
        if (next > 0.0f) remember(w, c, pr, next);
    } else if (carries(next, n.z, vn + p * (q.x + q.y), thr2)) {
        gatherLoad(w, pr, n.x, n.y, next, true);
    }
}

// Index space: a group of one colour a work-item. Cost: its contacts.
kernel void solver_relax(WORLD_PARAMETERS, int level, int colour, int last) {
    World w = WORLD;
    int g = (int) get_global_id(0);
    if (g >= groupsOfColour(&w, level) || refused(&w)) return;
    int group = firstOfColour(&w, level, colour) + g;
    int to = groupStart[group + 1];
    for (int c = groupStart[group]; c < to; c++) relaxContact(&w, c, last != 0);
}

// Ends the step for one circle: the base takes the displacement, the displacement what that lost, and all of it goes home.
void goHome(const World *w, int slot, float4 c, float4 m, float4 t) {
    const StepConstants *k = &w->k;
    float edge = t.x == 0.0f ? 0.0f : c.z;
    float x = c.x + m.x;
    float y = c.y + m.y;
    float keptX = bounded(x, k->minX + edge, k->maxX - edge);
    float keptY = bounded(y, k->minY + edge, k->maxY - edge);
    int id = w->id[slot];
    w->homeMotion[slot] = (float4)(keptX == x ? lostByRounding(c.x, m.x, x) : 0.0f,
                                   keptY == y ? lostByRounding(c.y, m.y, y) : 0.0f,
                                   limitSpeed(m.z), limitSpeed(m.w));
    w->homeCircle[slot] = (float4)(keptX, keptY, c.z, c.w);
    w->homeTraits[slot] = t;
    w->homeId[slot] = id;
    w->slotOf[id] = slot;
}

// Index space: a working slot a work-item.
kernel void solver_finish(WORLD_PARAMETERS) {
    World w = WORLD;
    int slot = (int) get_global_id(0);
    if (slot >= circles || refused(&w)) return;
    goHome(&w, slot, circle[slot], motion[slot], traits[slot]);
    homeMemory[slot] = memory[slot];
    if (slot == 0) status[STEPS_DONE]++;
}
