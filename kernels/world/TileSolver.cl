// Stage Solver for tiles: the passes of Solver.cl, tile by tile. A sub-step has two launches. Push reads drive, burden and held
// and writes pushedVelocity, pushedDisplacement and impulse; it ends with the move and the walls. Relax measures the contacts
// anew, goes back to held, and begins the next sub-step.

// A tile in local memory, by the numbers of its record.
typedef struct {
    float2 velocity[TILE_CIRCLES];
    float2 load[TILE_CIRCLES]; // in the biased pass the velocity before any impulse, in the relaxing pass sums of impulses
    float2 displacement[TILE_CIRCLES]; // in the relaxing pass
    float inverseMass[TILE_CIRCLES];
    uchar flags[TILE_CIRCLES];
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

// The biased pass over one contact; returns its new impulse and the target speed of its bounce.
float2 pushInTile(const World *w, local Tile *t, int2 p, float4 n, float4 shape) {
    float2 bi = t->load[p.x];
    float2 bj = t->load[p.y];
    float wi = t->inverseMass[p.x];
    float wj = t->inverseMass[p.y];
    bool loaded = ((t->flags[p.x] | t->flags[p.y]) & LOADED) != 0;
    float2 vi = t->velocity[p.x];
    float2 vj = t->velocity[p.y];
    float next, bounce, impulse;
    bool moves = pushImpulse(w, n, shape.x, shape.y, shape.w, shape.z, along(n.x, n.y, vj.x - vi.x, vj.y - vi.y),
                             along(n.x, n.y, bj.x - bi.x, bj.y - bi.y), loaded, &next, &bounce, &impulse);
    if (moves) applyTo(t, p, vi, vj, n.x, n.y, wi, wj, impulse);
    return (float2)(next, bounce);
}

// The relaxing pass over one contact: returns its new impulse.
float relaxInTile(const World *w, local Tile *t, int2 p, float4 n, float e, float thr2, float mass, float bounce,
                  bool last) {
    float wi = t->inverseMass[p.x];
    float wj = t->inverseMass[p.y];
    bool unloaded = ((t->flags[p.x] | t->flags[p.y]) & LOADED) == 0;
    float2 vi = t->velocity[p.x];
    float2 vj = t->velocity[p.y];
    float vn = along(n.x, n.y, vj.x - vi.x, vj.y - vi.y);
    float next, impulse;
    bool solved;
    bool moves = relaxImpulse(w, n, e, thr2, mass, vn, bounce, unloaded, &next, &impulse, &solved);
    if (moves) applyTo(t, p, vi, vj, n.x, n.y, wi, wj, impulse);
    if (solved && !last && carries(next, n.z, vn + impulse * (wi + wj), thr2)) {
        float2 lo = t->load[p.x];
        float2 hi = t->load[p.y];
        t->load[p.x] = (float2)(lo.x - n.x * next, lo.y - n.y * next);
        t->load[p.y] = (float2)(hi.x + n.x * next, hi.y + n.y * next);
        t->flags[p.x] |= CARRIED;
        t->flags[p.y] |= CARRIED;
    }
    return next;
}

// A pass over the contacts of a tile.
typedef struct {
    global int *record;
    size_t offset; // of its contacts
    bool relaxing, first, last; // first: of the step's biased passes; last: of its relaxing ones
} Pass;

// What a pass reads of a contact.
typedef struct {
    int2 contact;   // as in the record, or NO_CONTACT
    float4 normal;  // normal x, y, separation; before the relaxing pass has measured, as tileBase
    float4 shape;   // as tileShape
    float2 impulse; // accumulated, and in the relaxing pass the target speed of a bounce
} Reading;

#define NO_CONTACT ((int2)(0, -1))

// The contact of a part that is this work-item's.
int2 contactOf(local const Tile *t, const Pass *pass, int part) {
    if (part >= t->parts) return NO_CONTACT;
    int k = t->partStart[part] + (int) get_local_id(0);
    return k < t->partStart[part + 1] ? contactsOf(pass->record)[k] : NO_CONTACT;
}

size_t placeOf(local const Tile *t, const Pass *pass, int part) {
    return pass->offset + t->partStart[part] + (int) get_local_id(0);
}

void readContact(const World *w, local const Tile *t, const Pass *pass, int part, int2 contact, Reading *reading) {
    reading->contact = contact;
    if (contact.y < 0) return;
    size_t at = placeOf(t, pass, part);
    size_t owned = contact.x < 0 ? (size_t) (contact.x & ~NOT_OWN) : at;
    if (pass->relaxing) {
        reading->normal = w->tileBase[at];
        reading->impulse = w->impulse[owned];
        return;
    }
    float4 normal = w->tileNormal[at];
    reading->normal = normal;
    reading->shape = w->tileShape[at];
    if (pass->first) {
        reading->impulse.x = normal.w;
        // From now on the record says where the owner of the contact keeps its impulse.
        if (contact.x < 0) contactsOf(pass->record)[at - pass->offset].x = w->position[owned] | NOT_OWN;
    } else {
        reading->impulse.x = w->held[owned];
    }
}

// Measures a contact that has been read, after the circles have moved.
void measureContact(const World *w, local const Tile *t, const Pass *pass, int part, Reading *reading) {
    if (reading->contact.y < 0) return;
    int2 p = (int2)(reading->contact.y & 0xffff, reading->contact.y >> 16);
    float4 b = reading->normal;
    size_t at = placeOf(t, pass, part);
    float4 n;
    if (!measure(&n, b.x, b.y, b.z, t->displacement[p.x], t->displacement[p.y])) n.xy = w->tileNormal[at].xy;
    n.w = 0.0f;
    if (!pass->last) w->tileNormal[at] = n;
    reading->normal = n;
    reading->shape = (float4)(b.w, thresholdOf(w, b.z, b.w), 0.0f, 1.0f / (t->inverseMass[p.x] + t->inverseMass[p.y]));
}

// Remembers a contact's impulse for the step to come. Several of one circle may at the same time, in no order: they are
// looked up by id.
void rememberHeld(const World *w, const Pass *pass, int2 p, int c, float lambda) {
    int lo = pass->record[RECORD_SLOTS + p.x] & SLOT_MASK;
    int hi = pass->record[RECORD_SLOTS + p.y] & SLOT_MASK;
    int next = atomic_xchg(&w->homeMemory[lo], c);
    w->old[c] = (int4)(w->id[hi], as_int(lambda), next, 0);
}

void solveContact(const World *w, local Tile *t, const Pass *pass, int part, const Reading *reading) {
    int2 contact = reading->contact;
    int2 p = (int2)(contact.y & 0xffff, contact.y >> 16);
    float4 n = (float4)(reading->normal.x, reading->normal.y, reading->normal.z, reading->impulse.x);
    float4 shape = reading->shape;
    if (!pass->relaxing) {
        float2 next = pushInTile(w, t, p, n, shape);
        if (contact.x >= 0) w->impulse[placeOf(t, pass, part)] = next;
        return;
    }
    float next = relaxInTile(w, t, p, n, shape.x, shape.y, shape.w, reading->impulse.y, pass->last);
    if (contact.x < 0) return;
    if (!pass->last) {
        w->held[placeOf(t, pass, part)] = next;
    } else if (next > 0.0f) {
        rememberHeld(w, pass, p, contact.x, next);
    }
}

// Solves the contacts of a part of a round, which have been read before; reads those of the part after the next, of which the
// places are known, and the places of two parts later; and measures those of the next part.
void solvePart(const World *w, local Tile *t, const Pass *pass, int part, Reading *reading, int2 *next, Reading *other) {
    barrier(CLK_LOCAL_MEM_FENCE);
    if (reading->contact.y >= 0) solveContact(w, t, pass, part, reading);
    readContact(w, t, pass, part + 2, *next, reading);
    *next = contactOf(t, pass, part + 4);
    if (pass->relaxing) measureContact(w, t, pass, part + 1, other);
}

// Solves the contacts of a tile, part by part, two in turn, so that what each needs is on its way for the time of two.
void solveParts(const World *w, local Tile *t, int tile, bool relaxing, bool first, bool last) {
    Pass pass;
    pass.record = recordOf(w, tile);
    pass.offset = contactOffset(tile);
    pass.relaxing = relaxing;
    pass.first = first;
    pass.last = last;
    int parts = t->parts;
    Reading even, odd;
    readContact(w, t, &pass, 0, contactOf(t, &pass, 0), &even);
    readContact(w, t, &pass, 1, contactOf(t, &pass, 1), &odd);
    int2 nextEven = contactOf(t, &pass, 2);
    int2 nextOdd = contactOf(t, &pass, 3);
    barrier(CLK_LOCAL_MEM_FENCE);
    if (relaxing) measureContact(w, t, &pass, 0, &even);
#pragma unroll 1
    for (int part = 0; part < parts; part += 2) {
        solvePart(w, t, &pass, part, &even, &nextEven, &odd);
        solvePart(w, t, &pass, part + 1, &odd, &nextOdd, &even);
    }
    barrier(CLK_LOCAL_MEM_FENCE);
}

// The biased pass of a tile.
void pushTile(const World *w, local Tile *t, int tile, int subStep) {
    global int *slots = recordOf(w, tile) + RECORD_SLOTS;
    int circles = t->circles;
#pragma unroll 1
    TILE_EACH(i, circles) {
        int slot = slots[i] & SLOT_MASK;
        float4 drive = w->drive[slot];
        float burden = w->burden[slot];
        t->velocity[i] = drive.xy;
        t->load[i] = drive.zw;
        t->inverseMass[i] = fabs(burden);
        t->flags[i] = as_int(burden) < 0 ? LOADED : 0;
        if (subStep == 0 && slots[i] >= 0) w->homeMemory[slot] = NONE;
    }
    solveParts(w, t, tile, false, subStep == 0, false);
#pragma unroll 1
    TILE_EACH(i, circles) {
        if (slots[i] >= 0) endPush(w, slots + i, t->velocity[i], t->inverseMass[i], t->flags[i] & LOADED);
    }
}

// The relaxing pass of a tile; in the last sub-step the circles go home.
void relaxTile(const World *w, local Tile *t, int tile, bool last) {
    global int *slots = recordOf(w, tile) + RECORD_SLOTS;
    int circles = t->circles;
#pragma unroll 1
    TILE_EACH(i, circles) {
        int slot = slots[i] & SLOT_MASK;
        float4 v = w->pushedVelocity[slot];
        t->displacement[i] = w->pushedDisplacement[slot];
        t->velocity[i] = v.xy;
        t->load[i] = (float2)(0.0f);
        t->inverseMass[i] = v.z;
        t->flags[i] = v.w > 0.0f ? LOADED : 0;
    }
    solveParts(w, t, tile, true, false, last);
#pragma unroll 1
    TILE_EACH(i, circles) {
        int place = slots[i];
        if (place < 0) continue;
        int slot = place & SLOT_MASK;
        float2 d = t->displacement[i];
        float2 v = t->velocity[i];
        if (last) {
            goHome(w, slot, w->circle[slot], (float4)(d.x, d.y, v.x, v.y), w->traits[slot]);
        } else {
            startCircle(w, slots + i, slot, (place & AT_WALL) != 0, d, v, t->inverseMass[i], t->load[i],
                        (t->flags[i] & CARRIED) != 0);
        }
    }
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
