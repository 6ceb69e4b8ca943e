// Stage Solver for tiles: the passes of Solver.cl, tile by tile. A sub-step has three launches. Push reads drive, burden and
// held and writes pushedMotion, pushedBurden and impulse; it ends with the circles' move. Measure, a contact a work-item, takes what is
// costly about a contact out of the chain of dependent contacts. Relax goes back to held, and starts the next sub-step.

// A tile in local memory, by the numbers of its record.
typedef struct {
    float2 velocity[TILE_CIRCLES];
    float2 load[TILE_CIRCLES]; // in the biased pass the velocity before any impulse, in the relaxing pass sums of impulses
    float burden[TILE_CIRCLES];
    uchar carried[TILE_CIRCLES];   // in the relaxing pass: 1 where a contact carries
    int partStart[TILE_PARTS + 2]; // by part of a round
    int circles, parts;
} Tile;

// Takes a tile from its record. idle: as one without circles.
void takeTile(const World *w, local Tile *t, int tile, bool idle) {
    global int *record = recordOf(w, tile);
    int circles = idle ? 0 : record[RECORD_CIRCLES];
    int parts = circles > 0 ? record[RECORD_PARTS] : 0;
    barrier(CLK_LOCAL_MEM_FENCE);
    if (get_local_id(0) == 0) {
        t->circles = circles;
        t->parts = parts;
    }
    TILE_EACH(part, parts + 1) t->partStart[part] = circles > 0 ? record[RECORD_STARTS + part] : 0;
    barrier(CLK_LOCAL_MEM_FENCE);
}

void applyTo(local Tile *t, int2 p, float2 vi, float2 vj, float nx, float ny, float wi, float wj, float impulse) {
    vi.x -= nx * (wi * impulse);
    vi.y -= ny * (wi * impulse);
    vj.x += nx * (wj * impulse);
    vj.y += ny * (wj * impulse);
    t->velocity[p.x] = vi;
    t->velocity[p.y] = vj;
}

// The biased pass over one contact; returns its new impulse and the target speed of its bounce. The same as pushImpulse of
// Solver.cl, to the bit, without its branches: they would be most of the time.
float2 pushInTile(const World *w, local Tile *t, int2 p, float4 n, float4 shape) {
    const StepConstants *k = &w->k;
    float e = shape.x;
    float thr2 = shape.y;
    float s = n.z;
    float lambda = n.w;
    float mass = shape.w;
    float2 bi = t->load[p.x];
    float2 bj = t->load[p.y];
    float wi = t->burden[p.x];
    float wj = t->burden[p.y];
    float2 vi = t->velocity[p.x];
    float2 vj = t->velocity[p.y];
    bool loaded = isLoaded(wi) || isLoaded(wj);
    float vn = along(n.x, n.y, vj.x - vi.x, vj.y - vi.y);
    float before = along(n.x, n.y, bj.x - bi.x, bj.y - bi.y);
    float speculative = s * k->inverseH;
    float bounce = bounceSpeed(e, before, s, k->h, thr2);
    bounce = e > 0.0f && loaded ? bounce : 0.0f;
    bool flies = e > 0.0f && !loaded && lambda == 0.0f && vn * vn > thr2;
    bool leaves = flies && vn > 0.0f;
    bool bounces = flies && !leaves && speculative + vn < 0.0f;
    // A rigid contact is a soft one with these numbers.
    bool rigidly = bounce > 0.0f || s > 0.0f;
    float massScale = rigidly ? 1.0f : k->massScale;
    float softer = rigidly ? 0.0f : k->impulseScale * lambda;
    float bias = k->massScale * greatest(k->biasRate * s, -shape.z);
    bias = bounce > 0.0f ? -bounce : s > 0.0f ? speculative : bias;
    float next = greatest((lambda - mass * (massScale * vn + bias)) - softer, 0.0f);
    next = leaves || bounces ? lambda : next;
    float impulse = bounces ? freeBounce(e, vn, mass) : next - lambda;
    if (!leaves) applyTo(t, p, vi, vj, n.x, n.y, fabs(wi), fabs(wj), impulse);
    return (float2)(next, bounce);
}

// The relaxing pass over one contact: returns its new impulse. The same as relaxImpulse of Solver.cl, to the bit.
float relaxInTile(const World *w, local Tile *t, int2 p, float4 n, float4 shape, float bounce, bool last) {
    float e = shape.x;
    float thr2 = shape.y;
    float s = n.z;
    float lambda = n.w;
    float mass = shape.w;
    float wi = t->burden[p.x];
    float wj = t->burden[p.y];
    bool unloaded = !(isLoaded(wi) || isLoaded(wj));
    wi = fabs(wi);
    wj = fabs(wj);
    float2 vi = t->velocity[p.x];
    float2 vj = t->velocity[p.y];
    float vn = along(n.x, n.y, vj.x - vi.x, vj.y - vi.y);
    bool idle = lambda == 0.0f && bounce == 0.0f;
    bool flies = idle && e > 0.0f && unloaded && vn * vn > thr2;
    bool leaves = idle && (s > 0.0f || (flies && vn > 0.0f));
    bool bounces = flies && !leaves;
    float bias = bounce > 0.0f ? -bounce : s > 0.0f ? s * w->k.inverseH : 0.0f;
    float next = rigid(lambda, mass, vn, bias);
    float impulse = bounces ? freeBounce(e, vn, mass) : next - lambda;
    next = leaves || bounces ? lambda : bounce > 0.0f ? 0.0f : next;
    if (leaves) return next;
    applyTo(t, p, vi, vj, n.x, n.y, wi, wj, impulse);
    if (!bounces && !last && carries(next, s, vn + impulse * (wi + wj), thr2)) {
        float2 lo = t->load[p.x];
        float2 hi = t->load[p.y];
        t->load[p.x] = (float2)(lo.x - n.x * next, lo.y - n.y * next);
        t->load[p.y] = (float2)(hi.x + n.x * next, hi.y + n.y * next);
        t->carried[p.x] = 1;
        t->carried[p.y] = 1;
    }
    return next;
}

// What a pass reads of a contact.
typedef struct {
    int2 contact; // as in the record, or NO_CONTACT
    float4 normal, shape;
    float2 impulse; // accumulated, and in the relaxing pass the target speed of a bounce
} Reading;

#define NO_CONTACT ((int2)(0, -1))

// The contact of a part that is this work-item's.
int2 contactOf(local const Tile *t, global const int2 *contacts, int part) {
    if (part >= t->parts) return NO_CONTACT;
    int k = t->partStart[part] + (int) get_local_id(0);
    return k < t->partStart[part + 1] ? contacts[k] : NO_CONTACT;
}

void readContact(const World *w, int2 contact, bool relaxing, Reading *reading) {
    reading->contact = contact;
    if (contact.y < 0) return;
    int c = contact.x & ~NOT_OWN;
    reading->normal = w->contact[c];
    reading->shape = w->shape[c];
    reading->impulse = relaxing ? w->impulse[c] : (float2)(w->held[c], 0.0f);
}

void solveContact(const World *w, local Tile *t, const Reading *reading, bool relaxing, bool last) {
    int2 contact = reading->contact;
    int2 p = (int2)(contact.y & 0xffff, contact.y >> 16);
    float4 n = (float4)(reading->normal.x, reading->normal.y, reading->normal.z, reading->impulse.x);
    if (relaxing) {
        float next = relaxInTile(w, t, p, n, reading->shape, reading->impulse.y, last);
        if (contact.x >= 0) w->held[contact.x] = next;
    } else {
        float2 next = pushInTile(w, t, p, n, reading->shape);
        if (contact.x >= 0) w->impulse[contact.x] = next;
    }
}

// Solves the contacts of a part of a round, which have been read before; reads those of the part after the next, of which the
// places are known, and the places of two parts later.
void solvePart(const World *w, local Tile *t, global const int2 *contacts, int part, bool relaxing, bool last,
               Reading *reading, int2 *next) {
    barrier(CLK_LOCAL_MEM_FENCE);
    if (reading->contact.y >= 0) solveContact(w, t, reading, relaxing, last);
    readContact(w, *next, relaxing, reading);
    *next = contactOf(t, contacts, part + 4);
}

// Solves the contacts of a tile, part by part, two in turn, so that what each needs is on its way for the time of two.
void solveParts(const World *w, local Tile *t, global const int2 *contacts, bool relaxing, bool last) {
    int parts = t->parts;
    Reading even, odd;
    readContact(w, contactOf(t, contacts, 0), relaxing, &even);
    readContact(w, contactOf(t, contacts, 1), relaxing, &odd);
    int2 nextEven = contactOf(t, contacts, 2);
    int2 nextOdd = contactOf(t, contacts, 3);
#pragma unroll 1
    for (int part = 0; part < parts; part += 2) {
        solvePart(w, t, contacts, part, relaxing, last, &even, &nextEven);
        solvePart(w, t, contacts, part + 1, relaxing, last, &odd, &nextOdd);
    }
    barrier(CLK_LOCAL_MEM_FENCE);
}

// The biased pass of a tile.
void pushTile(const World *w, local Tile *t, int tile, int subStep) {
    global const int *slots = recordOf(w, tile) + RECORD_SLOTS;
    int circles = t->circles;
    TILE_TOGETHER(first, circles) {
        int slot[TOGETHER];
        float4 drive[TOGETHER];
        float burden[TOGETHER];
        TOGETHER_EACH(n) slot[n] = slots[min(togetherItem(first, n), circles - 1)] & ~NOT_OWN;
        TOGETHER_EACH(n) {
            drive[n] = w->drive[slot[n]];
            burden[n] = w->burden[slot[n]];
        }
        TOGETHER_EACH(n) {
            int i = togetherItem(first, n);
            if (i >= circles) continue;
            t->velocity[i] = drive[n].xy;
            t->load[i] = drive[n].zw;
            t->burden[i] = burden[n];
        }
    }
    solveParts(w, t, contactsOf(recordOf(w, tile)), false, false);
    TILE_TOGETHER(first, circles) {
        int slot[TOGETHER];
        float4 c[TOGETHER];
        float2 d[TOGETHER];
        float4 traits[TOGETHER];
        float2 bounce[TOGETHER];
        TOGETHER_EACH(n) slot[n] = slots[min(togetherItem(first, n), circles - 1)];
        TOGETHER_EACH(n) {
            if (slot[n] < 0) continue;
            c[n] = w->circle[slot[n]];
            d[n] = w->motion[slot[n]].xy;
            traits[n] = w->traits[slot[n]];
            bounce[n] = w->wallBounce[slot[n]];
        }
        TOGETHER_EACH(n) {
            int i = togetherItem(first, n);
            if (i >= circles || slot[n] < 0) continue;
            endPush(w, slot[n], c[n], d[n], t->velocity[i], traits[n], bounce[n], t->burden[i]);
            if (subStep == 0) w->homeMemory[slot[n]] = NONE;
        }
    }
}

// Measures a contact after the circles have moved.
void measureContact(const World *w, int c) {
    uint2 p = w->ordered[c];
    float4 ci = w->circle[p.x];
    float4 cj = w->circle[p.y];
    float4 n;
    if (!measure(&n, cj.x - ci.x, cj.y - ci.y, ci.z + cj.z, w->pushedMotion[p.x].xy, w->pushedMotion[p.y].xy)) {
        n.xy = w->contact[c].xy;
    }
    n.w = 0.0f;
    w->contact[c] = n;
}

// Index space: any number of work-items, which take the contacts in turn.
kernel void solver_measure(WORLD_PARAMETERS) {
    World w = WORLD;
    if (refused(&w)) return;
    int contacts = groupStart[levels->first[LEVELS]];
    for (int c = (int) get_global_id(0); c < contacts; c += (int) get_global_size(0)) measureContact(&w, c);
}

// The relaxing pass of a tile: the contacts, then the circles' start into the next sub-step; or, after the last, their way
// home.
void relaxTile(const World *w, local Tile *t, int tile, bool last) {
    global const int *slots = recordOf(w, tile) + RECORD_SLOTS;
    int circles = t->circles;
    TILE_TOGETHER(first, circles) {
        int slot[TOGETHER];
        float2 v[TOGETHER];
        float burden[TOGETHER];
        TOGETHER_EACH(n) slot[n] = slots[min(togetherItem(first, n), circles - 1)] & ~NOT_OWN;
        TOGETHER_EACH(n) {
            v[n] = w->pushedMotion[slot[n]].zw;
            burden[n] = w->pushedBurden[slot[n]];
        }
        TOGETHER_EACH(n) {
            int i = togetherItem(first, n);
            if (i >= circles) continue;
            t->velocity[i] = v[n];
            t->load[i] = (float2)(0.0f);
            t->burden[i] = burden[n];
            t->carried[i] = 0;
        }
    }
    solveParts(w, t, contactsOf(recordOf(w, tile)), true, last);
    TILE_TOGETHER(first, circles) {
        int slot[TOGETHER];
        float4 c[TOGETHER];
        float4 m[TOGETHER];
        float4 traits[TOGETHER];
        TOGETHER_EACH(n) slot[n] = slots[min(togetherItem(first, n), circles - 1)];
        TOGETHER_EACH(n) {
            if (slot[n] < 0) continue;
            c[n] = w->circle[slot[n]];
            m[n] = w->pushedMotion[slot[n]];
            traits[n] = w->traits[slot[n]];
        }
        TOGETHER_EACH(n) {
            int i = togetherItem(first, n);
            if (i >= circles || slot[n] < 0) continue;
            m[n].zw = t->velocity[i];
            if (last) {
                goHome(w, slot[n], c[n], m[n], traits[n]);
            } else {
                startCircle(w, slot[n], c[n], m[n], traits[n], t->load[i], t->carried[i]);
            }
        }
    }
}

// Remembers a contact's impulse for the step to come. Several of one circle may at the same time, in no order: they are
// looked up by id.
void rememberHeld(const World *w, int c) {
    float lambda = w->held[c];
    if (!(lambda > 0.0f)) return;
    uint2 p = w->ordered[c];
    int next = atomic_xchg(&w->homeMemory[p.x], c);
    w->old[c] = (int4)(w->id[p.y], as_int(lambda), next, 0);
}

// Index space: any number of work-items, which take the contacts in turn.
kernel void solver_remember(WORLD_PARAMETERS) {
    World w = WORLD;
    if (refused(&w)) return;
    int contacts = groupStart[levels->first[LEVELS]];
    for (int c = (int) get_global_id(0); c < contacts; c += (int) get_global_size(0)) rememberHeld(&w, c);
}

// Index space of each: a work-group a tile. Cost: see Tiles.cl.

TILE_KERNEL solver_pushTile(WORLD_PARAMETERS, int subStep) {
    World w = WORLD;
    local Tile t;
    int tile = (int) get_group_id(0);
    takeTile(&w, &t, tile, refused(&w));
    pushTile(&w, &t, tile, subStep);
}

TILE_KERNEL solver_relaxTile(WORLD_PARAMETERS, int last) {
    World w = WORLD;
    local Tile t;
    int tile = (int) get_group_id(0);
    bool idle = refused(&w);
    if (last && get_global_id(0) == 0 && !idle) status[STEPS_DONE]++;
    takeTile(&w, &t, tile, idle);
    relaxTile(&w, &t, tile, last);
}
