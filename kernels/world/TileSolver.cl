// Stage Solver for tiles: the passes of Solver.cl, tile by tile. A sub-step has two launches. Push reads drive, burden and
// held and writes pushedMotion, pushedBurden and impulse; it ends with the circles' move. Relax measures the contacts anew,
// goes back to held, and starts the next sub-step. Speed is how many tiles a device has room for at once, and how much they
// read, so: few registers, and what is quickly worked out is not stored; no branches in the chain of contacts that wait for
// each other.

// The circle of contacts that are none: at rest, never written.
#define NO_CIRCLE TILE_CIRCLES

// A tile in local memory, by the numbers of its record.
typedef struct {
    float2 velocity[TILE_CIRCLES + 1];
    float2 load[TILE_CIRCLES + 1]; // in the biased pass the velocity before any impulse, in the relaxing pass sums of impulses
    float burden[TILE_CIRCLES + 1];
    uint carried[(TILE_CIRCLES + 31) / 32]; // in the relaxing pass, a bit a circle: whether a contact carries
    int partStart[TILE_PARTS + 2]; // by part of a round
    int circles, parts;
    int firstCopy;
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
        t->firstCopy = circles > 0 ? record[RECORD_COPIES] : 0;
        t->velocity[NO_CIRCLE] = t->load[NO_CIRCLE] = (float2)(0.0f);
        t->burden[NO_CIRCLE] = 0.0f;
    }
    TILE_EACH(part, parts + 1) t->partStart[part] = circles > 0 ? record[RECORD_STARTS + part] : 0;
    barrier(CLK_LOCAL_MEM_FENCE);
}

// What a pass reads of a contact.
typedef struct {
    int2 contact; // as in the record, or NO_CONTACT
    int copy;     // where the tile has its copy
    float4 normal; // normal, separation, effective mass; in the relaxing pass the base: it is measured anew
    float2 shape;  // in the biased pass: sum of the radii, restitution
    float2 impulse; // accumulated, and in the relaxing pass the target speed of a bounce
} Reading;

// In a reading, where there is none.
#define NO_CONTACT ((int2)(0, (int) (0x80000000u | NO_CIRCLE << 16 | NO_CIRCLE)))

int lowerOf(int2 contact) { return contact.y & 0x7fff; }

int higherOf(int2 contact) { return contact.y >> 16 & 0x7fff; }

// The part of a round of which a work-item looks its contact up next.
typedef struct {
    int part, from, to;
} Cursor;

void setCursor(local const Tile *t, Cursor *cursor, int part) {
    cursor->part = part;
    cursor->from = t->partStart[min(part, t->parts)];
    cursor->to = t->partStart[min(part + 1, t->parts)];
}

// A contact that is to be read.
typedef struct {
    int2 contact;
    int copy;
} Entry;

// Asks for a cache line that will be read: only a hint, which OpenCL has no portable form of that compilers heed.
#if PTX
#define PREFETCH(address) asm volatile("prefetch.global.L2 [%0];" ::"l"(address))
#else
#define PREFETCH(address) ((void) (address))
#endif

// The contact of a part that is this work-item's; moves on to the next part, of which it reads the end ahead.
Entry nextContact(const World *w, local const Tile *t, global const int2 *contacts, bool relaxing, Cursor *cursor) {
    int k = cursor->from + (int) get_local_id(0);
    Entry entry;
    entry.contact = NO_CONTACT;
    entry.copy = t->firstCopy + k;
    if (k < cursor->to) {
        entry.contact = contacts[k];
        PREFETCH(relaxing ? w->base + entry.copy : w->contact + entry.copy);
        if (!relaxing) PREFETCH(w->shape + entry.copy);
    }
    cursor->part++;
    cursor->from = cursor->to;
    cursor->to = t->partStart[min(cursor->part + 1, t->parts)];
    return entry;
}

void readContact(const World *w, Entry entry, bool relaxing, Reading *reading) {
    reading->contact = entry.contact;
    reading->copy = entry.copy;
    if (entry.contact.y < 0) return;
    int c = entry.contact.x & ~NOT_OWN;
    reading->normal = relaxing ? w->base[entry.copy] : w->contact[entry.copy];
    if (!relaxing) reading->shape = w->shape[entry.copy];
    reading->impulse = relaxing ? w->impulse[c] : (float2)(w->held[c], 0.0f);
}

// A contact made ready to be visited: what of pushImpulse and relaxImpulse in Solver.cl does not depend on the velocities.
// Contacts wait for each other only in visitContact, which is what remains. Both together are those functions, to the bit.
typedef struct {
    int2 contact;
    float nx, ny;
    float wi, wj, mass; // inverse masses, effective mass
    float lambda;
    float scale, bias, less; // a soft contact's; a rigid one is soft with 1, its bias, 0
    float flight;            // square of the normal speed beyond which circles fly free of each other; INFINITY: at none
    float gain;              // of the normal speed at a free bounce
    float meeting;           // they bounce freely where the sum of this and the normal speed is negative
    float bounce;            // target speed of a bounce
    float resting;           // in the relaxing pass: square of the normal speed up to which it carries; or -1
    bool still;              // in the relaxing pass: left alone at any speed
} Visit;

// Makes a contact ready for the biased pass.
void readyToPush(const World *w, local const Tile *t, const Reading *r, Visit *v) {
    const StepConstants *k = &w->k;
    int i = lowerOf(r->contact);
    int j = higherOf(r->contact);
    float2 bi = t->load[i];
    float2 bj = t->load[j];
    float wi = t->burden[i];
    float wj = t->burden[j];
    bool loaded = isLoaded(wi) || isLoaded(wj);
    float s = r->normal.z;
    float e = r->shape.y;
    float thr2 = thresholdOf(w, r->shape.x, e);
    float lambda = r->impulse.x;
    float before = along(r->normal.x, r->normal.y, bj.x - bi.x, bj.y - bi.y);
    float bounce = bounceSpeed(e, before, s, k->h, thr2);
    bounce = e > 0.0f && loaded ? bounce : 0.0f;
    float speculative = s * k->inverseH;
    float push = k->massScale * greatest(k->biasRate * s, -pushSpeed(r->shape.x, k->pushPerLength, k->pushPerRoot));
    bool rigidly = bounce > 0.0f || s > 0.0f;
    v->contact = r->contact;
    v->nx = r->normal.x;
    v->ny = r->normal.y;
    v->wi = fabs(wi);
    v->wj = fabs(wj);
    v->mass = r->normal.w;
    v->lambda = lambda;
    v->scale = rigidly ? 1.0f : k->massScale;
    v->bias = bounce > 0.0f ? -bounce : s > 0.0f ? speculative : push;
    v->less = rigidly ? 0.0f : k->impulseScale * lambda;
    v->flight = e > 0.0f && !loaded && lambda == 0.0f ? thr2 : INFINITY;
    v->gain = -(1.0f + e);
    v->meeting = speculative;
    v->bounce = bounce;
    v->resting = -1.0f;
    v->still = false;
}

// Measures a contact after the circles have moved. displacement: of the circles of the tile; mass: effective.
float4 measureInTile(const World *w, local const float2 *displacement, const Reading *r, float mass, bool last) {
    float4 b = r->normal;
    float4 n = (float4)(0.0f);
    if (r->contact.y < 0) return n;
    if (!measure(&n, b.x, b.y, b.z, displacement[lowerOf(r->contact)], displacement[higherOf(r->contact)])) {
        n.xy = w->contact[r->copy].xy;
    }
    n.w = mass;
    if (!last) w->contact[r->copy] = n;
    return n;
}

// Makes a contact ready for the relaxing pass.
void readyToRelax(const World *w, local const Tile *t, local const float2 *displacement, const Reading *r, bool last,
                  Visit *v) {
    int i = lowerOf(r->contact);
    int j = higherOf(r->contact);
    float wi = t->burden[i];
    float wj = t->burden[j];
    bool loaded = isLoaded(wi) || isLoaded(wj);
    v->mass = 1.0f / (fabs(wi) + fabs(wj));
    float4 n = measureInTile(w, displacement, r, v->mass, last);
    float s = n.z;
    float e = r->normal.w;
    float thr2 = thresholdOf(w, r->normal.z, e);
    float lambda = r->impulse.x;
    float bounce = r->impulse.y;
    bool idle = lambda == 0.0f && bounce == 0.0f;
    v->contact = r->contact;
    v->nx = n.x;
    v->ny = n.y;
    v->wi = fabs(wi);
    v->wj = fabs(wj);
    v->lambda = lambda;
    v->scale = 1.0f;
    v->bias = bounce > 0.0f ? -bounce : s > 0.0f ? s * w->k.inverseH : 0.0f;
    v->less = 0.0f;
    v->flight = idle && e > 0.0f && !loaded ? thr2 : INFINITY;
    v->gain = -(1.0f + e);
    v->meeting = -INFINITY;
    v->bounce = bounce;
    v->resting = s < 0.0f ? thr2 : -1.0f;
    v->still = idle && s > 0.0f;
}

// Visits a contact, without branches: they would be most of the time.
void visitContact(const World *w, local Tile *t, const Visit *v, bool relaxing, bool last) {
    int i = lowerOf(v->contact);
    int j = higherOf(v->contact);
    float2 vi = t->velocity[i];
    float2 vj = t->velocity[j];
    float2 loadI = relaxing && !last ? t->load[i] : (float2)(0.0f);
    float2 loadJ = relaxing && !last ? t->load[j] : (float2)(0.0f);
    float vn = along(v->nx, v->ny, vj.x - vi.x, vj.y - vi.y);
    bool flies = vn * vn > v->flight;
    bool leaves = v->still || (flies && vn > 0.0f);
    bool bounces = flies && !leaves && v->meeting + vn < 0.0f;
    bool solved = !leaves && !bounces;
    float next = greatest((v->lambda - v->mass * (v->scale * vn + v->bias)) - v->less, 0.0f);
    float impulse = bounces ? v->gain * vn * v->mass : solved ? next - v->lambda : 0.0f;
    if (relaxing && v->bounce > 0.0f) next = 0.0f;
    if (!solved) next = v->lambda;
    bool there = v->contact.y >= 0;
    if (there && !leaves) {
        t->velocity[i] = (float2)(vi.x - v->nx * (v->wi * impulse), vi.y - v->ny * (v->wi * impulse));
        t->velocity[j] = (float2)(vj.x + v->nx * (v->wj * impulse), vj.y + v->ny * (v->wj * impulse));
    }
    if (relaxing && !last) {
        float after = vn + impulse * (v->wi + v->wj);
        if (there && solved && (next > 0.0f || after * after <= v->resting)) {
            t->load[i] = (float2)(loadI.x - v->nx * next, loadI.y - v->ny * next);
            t->load[j] = (float2)(loadJ.x + v->nx * next, loadJ.y + v->ny * next);
            atomic_or(&t->carried[i >> 5], 1u << (i & 31));
            atomic_or(&t->carried[j >> 5], 1u << (j & 31));
        }
    }
    if (!there || v->contact.x < 0) return;
    if (relaxing) {
        w->held[v->contact.x] = next;
    } else {
        w->impulse[v->contact.x] = (float2)(next, v->bounce);
    }
}

void readyContact(const World *w, local const Tile *t, local const float2 *displacement, const Reading *reading,
                  bool relaxing, bool last, Visit *visit) {
    if (relaxing) {
        readyToRelax(w, t, displacement, reading, last, visit);
    } else {
        readyToPush(w, t, reading, visit);
    }
}

// Solves a part of a round, whose contacts are ready; makes those of the next part ready, reads those of the second from here,
// and looks up those of the third.
void solvePart(const World *w, local Tile *t, local const float2 *displacement, global const int2 *contacts,
               bool relaxing, bool last, Visit *visit, Reading *reading, Entry *next, Cursor *cursor) {
    barrier(CLK_LOCAL_MEM_FENCE);
    visitContact(w, t, visit, relaxing, last);
    readyContact(w, t, displacement, reading, relaxing, last, visit);
    readContact(w, *next, relaxing, reading);
    *next = nextContact(w, t, contacts, relaxing, cursor);
}

// Solves the contacts of a tile, part by part. What each needs is on its way for the time of the part before.
void solveParts(const World *w, local Tile *t, local const float2 *displacement, global const int2 *contacts,
                bool relaxing, bool last) {
    int parts = t->parts;
    Cursor cursor;
    setCursor(t, &cursor, 0);
    Reading reading;
    Visit visit;
    reading.normal = (float4)(0.0f);
    reading.shape = reading.impulse = (float2)(0.0f);
    readContact(w, nextContact(w, t, contacts, relaxing, &cursor), relaxing, &reading);
    barrier(CLK_LOCAL_MEM_FENCE);
    readyContact(w, t, displacement, &reading, relaxing, last, &visit);
    readContact(w, nextContact(w, t, contacts, relaxing, &cursor), relaxing, &reading);
    Entry next = nextContact(w, t, contacts, relaxing, &cursor);
#pragma unroll 1
    for (int part = 0; part < parts; part++) {
        solvePart(w, t, displacement, contacts, relaxing, last, &visit, &reading, &next, &cursor);
    }
    barrier(CLK_LOCAL_MEM_FENCE);
}

// The biased pass of a tile.
void pushTile(const World *w, local Tile *t, int tile, int subStep) {
    global const int *slots = recordOf(w, tile) + RECORD_SLOTS;
    int circles = t->circles;
    findNumbers(w, recordOf(w, tile), subStep == 0 ? t->partStart[t->parts] : 0);
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
    solveParts(w, t, 0, contactsOf(recordOf(w, tile)), false, false);
#pragma unroll 1
    TILE_EACH(i, circles) {
        int slot = slots[i];
        if (slot < 0) continue;
        endPush(w, slot, w->circle[slot], w->motion[slot], t->velocity[i], w->traits[slot], t->burden[i]);
        if (subStep == 0) w->homeMemory[slot] = NONE;
    }
}

// The relaxing pass of a tile: the contacts, then the circles' start into the next sub-step; or, after the last, their way
// home.
void relaxTile(const World *w, local Tile *t, local float2 *displacement, int tile, bool last) {
    global const int *slots = recordOf(w, tile) + RECORD_SLOTS;
    int circles = t->circles;
    TILE_TOGETHER(first, circles) {
        int slot[TOGETHER];
        float4 m[TOGETHER];
        float burden[TOGETHER];
        TOGETHER_EACH(n) slot[n] = slots[min(togetherItem(first, n), circles - 1)] & ~NOT_OWN;
        TOGETHER_EACH(n) {
            m[n] = w->pushedMotion[slot[n]];
            burden[n] = w->pushedBurden[slot[n]];
        }
        TOGETHER_EACH(n) {
            int i = togetherItem(first, n);
            if (i >= circles) continue;
            displacement[i] = m[n].xy;
            t->velocity[i] = m[n].zw;
            t->load[i] = (float2)(0.0f);
            t->burden[i] = burden[n];
            if ((i & 31) == 0) t->carried[i >> 5] = 0;
        }
    }
    solveParts(w, t, displacement, contactsOf(recordOf(w, tile)), true, last);
#pragma unroll 1
    TILE_EACH(i, circles) {
        int slot = slots[i];
        if (slot < 0) continue;
        float2 d = displacement[i];
        float2 v = t->velocity[i];
        float4 m = (float4)(d.x, d.y, v.x, v.y);
        if (last) {
            goHome(w, slot, w->circle[slot], m, w->traits[slot]);
        } else {
            startCircle(w, slot, w->circle[slot], m, w->traits[slot], t->load[i],
                        (t->carried[i >> 5] >> (i & 31) & 1) != 0);
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
    local float2 displacement[TILE_CIRCLES];
    int tile = (int) get_group_id(0);
    bool idle = refused(&w);
    if (last && get_global_id(0) == 0 && !idle) status[STEPS_DONE]++;
    takeTile(&w, &t, tile, idle);
    relaxTile(&w, &t, displacement, tile, last);
}
