// Stage Solver: moves the circles through the sub-steps of a step, and writes them home. The Java class JvmSolver is the
// same, function by function.

// One axis of a circle against the wall that it is nearer to: biased pass. before: velocity along the axis before any
// impulse; next: after those of its contacts; stored: the wall's impulse, positive for the lower wall. Returns the new
// velocity along the axis.
float pushFromWall(const World *w, float x, float dx, float before, float next, float r, float e, bool loaded, float min,
                   float max, float *stored, float *bounceOut) {
    constant StepConstants *k = w->k;
    float thr2 = k->thresholdRate * (2.0f * r);
    float side = wallSide(x, min, max);
    float gap = wallGap(x, dx, r, side, min, max);
    float lambda = wallImpulse(*stored, side);
    float bounce = e > 0.0f && loaded ? bounceSpeed(e, side * before, gap, k->h, thr2) : 0.0f;
    next += side * lambda;
    float vn = side * next;
    float p;
    if (e > 0.0f && !loaded && separates(vn, thr2)) {
        p = 0.0f;
    } else if (e > 0.0f && !loaded && approaches(vn, thr2) && gap * k->inverseH + vn < 0.0f) {
        p = freeBounce(e, vn, 1.0f);
    } else {
        float after;
        if (bounce > 0.0f) {
            after = rigid(lambda, 1.0f, vn, -bounce);
        } else if (gap > 0.0f) {
            after = rigid(lambda, 1.0f, vn, gap * k->inverseH);
        } else {
            after = soft(lambda, 1.0f, vn, gap, pushSpeed(2.0f * r, k->pushPerLength, k->pushPerRoot), k->wallBiasRate,
                         k->wallMassScale, k->wallImpulseScale);
        }
        p = after - lambda;
        lambda = after;
    }
    *stored = side * lambda;
    *bounceOut = bounce;
    return next + side * p;
}

// Gravity, the impulses of the sub-step before, and the biased pass over the walls. Index space: a working slot a
// work-item.
kernel void solver_accelerate(WORLD_PARAMETERS) {
    World w = WORLD;
    int slot = (int) get_global_id(0);
    if (slot >= circles || outOfRoom(&w)) return;
    float4 t = traits[slot];
    float4 m = motion[slot];
    float4 l = load[slot];
    if (t.x == 0.0f) {
        load[slot] = (float4)(m.z, m.w, 0.0f, l.w);
        return;
    }
    float4 c = circle[slot];
    float vx = m.z + k->gravityStepX;
    float vy = m.w + k->gravityStepY;
    bool loaded = l.w > 0.0f || t.z != 0.0f || t.w != 0.0f;
    float bounceX, bounceY;
    float wallX = t.z;
    float wallY = t.w;
    float nextX = pushFromWall(&w, c.x, m.x, vx, vx + t.x * l.x, c.z, t.y, loaded, k->minX, k->maxX, &wallX, &bounceX);
    float nextY = pushFromWall(&w, c.y, m.y, vy, vy + t.x * l.y, c.z, t.y, loaded, k->minY, k->maxY, &wallY, &bounceY);
    traits[slot] = (float4)(t.x, t.y, wallX, wallY);
    wallBounce[slot] = (float2)(bounceX, bounceY);
    load[slot] = (float4)(vx, vy, loaded ? 1.0f : 0.0f, l.w);
    motion[slot] = (float4)(m.x, m.y, bounded(nextX, -GREATEST_SPEED, GREATEST_SPEED),
                            bounded(nextY, -GREATEST_SPEED, GREATEST_SPEED));
}

void applyImpulse(const World *w, uint2 pr, float4 mi, float4 mj, float nx, float ny, float wi, float wj, float p) {
    mi.z -= nx * (wi * p);
    mi.w -= ny * (wi * p);
    mj.z += nx * (wj * p);
    mj.w += ny * (wj * p);
    w->motion[pr.x] = mi;
    w->motion[pr.y] = mj;
}

// The biased pass over one contact: stops approaches, pushes overlaps out, bounces.
void pushContact(const World *w, int c) {
    constant StepConstants *k = w->k;
    uint2 pr = w->pair[c];
    float4 b = w->base[c];
    float4 q = w->masses[c];
    float4 n = w->contact[c];
    float4 mi = w->motion[pr.x];
    float4 mj = w->motion[pr.y];
    float4 li = w->load[pr.x];
    float4 lj = w->load[pr.y];
    float e = b.w;
    float s = n.z;
    float lambda = n.w;
    float thr2 = k->thresholdRate * b.z;
    float mass = 1.0f / (q.x + q.y);
    float vn = along(n.x, n.y, mj.z - mi.z, mj.w - mi.w);
    float bounce = 0.0f;
    bool loaded = li.z + lj.z > 0.0f;
    if (e > 0.0f && loaded) {
        float before = along(n.x, n.y, lj.x - li.x, lj.y - li.y);
        bounce = bounceSpeed(e, before, s, k->h, thr2);
    }
    w->masses[c].w = bounce;
    bool freeFlight = e > 0.0f && !loaded && lambda == 0.0f;
    if (freeFlight && separates(vn, thr2)) return;
    float p;
    if (freeFlight && approaches(vn, thr2) && s * k->inverseH + vn < 0.0f) {
        p = freeBounce(e, vn, mass);
    } else {
        float next;
        if (bounce > 0.0f) {
            next = rigid(lambda, mass, vn, -bounce);
        } else if (s > 0.0f) {
            next = rigid(lambda, mass, vn, s * k->inverseH);
        } else {
            next = soft(lambda, mass, vn, s, q.z, k->biasRate, k->massScale, k->impulseScale);
        }
        p = next - lambda;
        w->contact[c].w = next;
    }
    applyImpulse(w, pr, mi, mj, n.x, n.y, q.x, q.y, p);
}

// Index space: a group of one colour a work-item. Cost: its contacts.
kernel void solver_push(WORLD_PARAMETERS, int firstGroup, int groups) {
    World w = WORLD;
    int g = (int) get_global_id(0);
    if (g >= groups || outOfRoom(&w)) return;
    int to = groupStart[firstGroup + g + 1];
    for (int c = groupStart[firstGroup + g]; c < to; c++) pushContact(&w, c);
}

// One axis of a circle against its wall: relaxing pass. Returns the new velocity along the axis.
float relaxAtWall(const World *w, float x, float dx, float v, float r, float e, bool loaded, float bounce, float min,
                  float max, float *stored) {
    constant StepConstants *k = w->k;
    float thr2 = k->thresholdRate * (2.0f * r);
    float side = wallSide(x, min, max);
    float gap = wallGap(x, dx, r, side, min, max);
    float lambda = wallImpulse(*stored, side);
    float vn = side * v;
    if (lambda == 0.0f && bounce == 0.0f && gap > 0.0f) return v;
    bool freeFlight = lambda == 0.0f && bounce == 0.0f && e > 0.0f && !loaded;
    if (freeFlight && separates(vn, thr2)) return v;
    if (freeFlight && approaches(vn, thr2)) return v + side * freeBounce(e, vn, 1.0f);
    float b = bounce > 0.0f ? -bounce : gap > 0.0f ? gap * k->inverseH : 0.0f;
    float next = rigid(lambda, 1.0f, vn, b);
    *stored = bounce > 0.0f ? 0.0f : side * next;
    return v + side * (next - lambda);
}

// Moves the circles, keeps them within the walls, and makes the relaxing pass over the walls. Index space: a working slot
// a work-item.
kernel void solver_move(WORLD_PARAMETERS) {
    World w = WORLD;
    int slot = (int) get_global_id(0);
    if (slot >= circles || outOfRoom(&w)) return;
    float4 c = circle[slot];
    float4 m = motion[slot];
    float4 t = traits[slot];
    bool loaded = load[slot].z > 0.0f;
    float vx = bounded(m.z, -GREATEST_SPEED, GREATEST_SPEED);
    float vy = bounded(m.w, -GREATEST_SPEED, GREATEST_SPEED);
    float edge = t.x == 0.0f ? 0.0f : c.z;
    float dx = within(c.x, m.x + vx * k->h, k->minX + edge, k->maxX - edge);
    float dy = within(c.y, m.y + vy * k->h, k->minY + edge, k->maxY - edge);
    load[slot] = (float4)(0.0f, 0.0f, load[slot].z, 0.0f);
    memory[slot] = NONE;
    if (t.x != 0.0f) {
        float2 bounce = wallBounce[slot];
        float wallX = t.z;
        float wallY = t.w;
        vx = relaxAtWall(&w, c.x, dx, vx, c.z, t.y, loaded, bounce.x, k->minX, k->maxX, &wallX);
        vy = relaxAtWall(&w, c.y, dy, vy, c.z, t.y, loaded, bounce.y, k->minY, k->maxY, &wallY);
        traits[slot] = (float4)(t.x, t.y, wallX, wallY);
    }
    motion[slot] = (float4)(dx, dy, vx, vy);
}

// Remembers a contact's impulse for the step to come.
void remember(const World *w, int c, uint2 pr, float lambda) {
    w->oldHi[c] = (int) w->key[c];
    w->oldLambda[c] = lambda;
    w->oldNext[c] = w->memory[pr.x];
    w->memory[pr.x] = c;
}

// The relaxing pass over one contact: measures it anew, takes the push-out speed away again, and sums up for what follows.
void relaxContact(const World *w, int c, bool last) {
    constant StepConstants *k = w->k;
    uint2 pr = w->pair[c];
    float4 b = w->base[c];
    float4 q = w->masses[c];
    float4 n = w->contact[c];
    float4 mi = w->motion[pr.x];
    float4 mj = w->motion[pr.y];
    float e = b.w;
    float sum = b.z;
    float bounce = q.w;
    float lambda = n.w;
    float dx = difference(b.x, mi.x, mj.x);
    float dy = difference(b.y, mi.y, mj.y);
    float d = norm(dx, dy);
    if (d > COINCIDENT * sum) {
        n.x = dx / d;
        n.y = dy / d;
    }
    float s = d - sum;
    n.z = s;
    w->contact[c] = n;
    float vn = along(n.x, n.y, mj.z - mi.z, mj.w - mi.w);
    float thr2 = k->thresholdRate * sum;
    float mass = 1.0f / (q.x + q.y);
    if (lambda == 0.0f && bounce == 0.0f) {
        if (s > 0.0f) return;
        if (e > 0.0f && w->load[pr.x].z + w->load[pr.y].z == 0.0f) {
            if (separates(vn, thr2)) return;
            if (approaches(vn, thr2)) {
                applyImpulse(w, pr, mi, mj, n.x, n.y, q.x, q.y, freeBounce(e, vn, mass));
                return;
            }
        }
    }
    float bias = bounce > 0.0f ? -bounce : s > 0.0f ? s * k->inverseH : 0.0f;
    float next = rigid(lambda, mass, vn, bias);
    float p = next - lambda;
    applyImpulse(w, pr, mi, mj, n.x, n.y, q.x, q.y, p);
    if (bounce > 0.0f) next = 0.0f;
    w->contact[c].w = next;
    if (last) {
        if (next > 0.0f) remember(w, c, pr, next);
    } else if (carries(next, s, vn + p * (q.x + q.y), thr2)) {
        gatherLoad(w, pr, n.x, n.y, next, true);
    }
}

// Index space: a group of one colour a work-item. Cost: its contacts.
kernel void solver_relax(WORLD_PARAMETERS, int firstGroup, int groups, int last) {
    World w = WORLD;
    int g = (int) get_global_id(0);
    if (g >= groups || outOfRoom(&w)) return;
    int to = groupStart[firstGroup + g + 1];
    for (int c = groupStart[firstGroup + g]; c < to; c++) relaxContact(&w, c, last != 0);
}

// Ends the step: the base takes the displacement, the displacement what that lost, and all of it goes home. Index space: a
// working slot a work-item.
kernel void solver_finish(WORLD_PARAMETERS) {
    World w = WORLD;
    int slot = (int) get_global_id(0);
    if (slot >= circles || outOfRoom(&w)) return;
    float4 c = circle[slot];
    float4 m = motion[slot];
    float4 t = traits[slot];
    float edge = t.x == 0.0f ? 0.0f : c.z;
    float x = c.x + m.x;
    float y = c.y + m.y;
    float keptX = bounded(x, k->minX + edge, k->maxX - edge);
    float keptY = bounded(y, k->minY + edge, k->maxY - edge);
    homeMotion[slot] = (float4)(keptX == x ? lostByRounding(c.x, m.x, x) : 0.0f,
                                keptY == y ? lostByRounding(c.y, m.y, y) : 0.0f,
                                bounded(m.z, -GREATEST_SPEED, GREATEST_SPEED),
                                bounded(m.w, -GREATEST_SPEED, GREATEST_SPEED));
    homeCircle[slot] = (float4)(keptX, keptY, c.z, c.w);
    homeTraits[slot] = t;
    homeId[slot] = id[slot];
    homeMemory[slot] = memory[slot];
    slotOf[id[slot]] = slot;
    if (slot == 0) status[STEPS_DONE]++;
}
