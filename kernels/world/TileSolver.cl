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
float2 pushInTile(const World *w, local Tile *t, int2 p, float4 n, float4 shape, float mass) {
    float2 bi = t->load[p.x];
    float2 bj = t->load[p.y];
    float wi = t->inverseMass[p.x];
    float wj = t->inverseMass[p.y];
    bool loaded = ((t->flags[p.x] | t->flags[p.y]) & LOADED) != 0;
    float2 vi = t->velocity[p.x];
    float2 vj = t->velocity[p.y];
    float next, bounce, impulse;
    bool moves = pushImpulse(w, n, shape.x, shape.y, mass, shape.z, along(n.x, n.y, vj.x - vi.x, vj.y - vi.y),
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
    bool relaxing, last;
} Pass;

// What a pass has read of a contact. Every component that is loaded is used: one that is not would share its register with
// another value, which would then have to wait for the load.
typedef struct {
    int at;         // its place in the tile, or -1
    int number;     // as in the record
    int pair;       // its circles
    float4 normal;  // as tileNormal; before the relaxing pass has measured, as tileBase
    float4 shape;   // as tileShape
    float2 impulse; // accumulated, and in the relaxing pass the target speed of a bounce
} Reading;

// Reads what lies at a contact's own place: this work-item's of a part.
void readContact(const World *w, local const Tile *t, const Pass *pass, int part, Reading *r) {
    r->at = -1;
    if (part >= t->parts) return;
    int at = t->partStart[part] + (int) get_local_id(0);
    if (at >= t->partStart[part + 1]) return;
    r->at = at;
    r->number = numbersOf(pass->record)[at];
    if (pass->relaxing) {
        r->pair = pairsOf(pass->record)[at];
        r->normal = w->tileBase[pass->offset + at];
    } else {
        r->normal = w->tileNormal[pass->offset + at];
        r->shape = w->tileShape[pass->offset + at];
    }
}

// Reads a contact's impulse, where the tile has it that the contact belongs to.
void readImpulse(const World *w, const Pass *pass, Reading *r) {
    if (r->at < 0) return;
    size_t at = r->number < 0 ? (size_t) (r->number & ~NOT_OWN) : pass->offset + r->at;
    if (pass->relaxing) {
        r->impulse = w->impulse[at];
    } else {
        r->impulse.x = w->held[at];
    }
}

// Measures a contact that has been read, after the circles have moved: then shape is restitution, square of the threshold.
void measureContact(const World *w, local const Tile *t, const Pass *pass, Reading *r) {
    if (r->at < 0) return;
    int2 p = (int2)(r->pair & 0xffff, r->pair >> 16);
    float4 b = r->normal;
    float4 n;
    global float4 *normal = w->tileNormal + pass->offset + r->at;
    if (!measure(&n, b.x, b.y, b.z, t->displacement[p.x], t->displacement[p.y])) n.xy = normal->xy;
    n.w = 1.0f / (t->inverseMass[p.x] + t->inverseMass[p.y]);
    if (!pass->last) *normal = n;
    r->normal = n;
    r->shape.x = b.w;
    r->shape.y = thresholdOf(w, b.z, b.w);
}

// Remembers a contact's impulse for the step to come. Several of one circle may at the same time, in no order: they are
// looked up by id.
void rememberHeld(const World *w, const Pass *pass, int2 p, int c, float lambda) {
    int lo = pass->record[RECORD_SLOTS + p.x] & SLOT_MASK;
    int hi = pass->record[RECORD_SLOTS + p.y] & SLOT_MASK;
    int next = atomic_xchg(&w->homeMemory[lo], c);
    w->old[c] = (int4)(w->id[hi], as_int(lambda), next, 0);
}

void solveContact(const World *w, local Tile *t, const Pass *pass, const Reading *r) {
    int pair = pass->relaxing ? r->pair : as_int(r->shape.w);
    int2 p = (int2)(pair & 0xffff, pair >> 16);
    float4 n = (float4)(r->normal.x, r->normal.y, r->normal.z, r->impulse.x);
    if (!pass->relaxing) {
        float2 next = pushInTile(w, t, p, n, r->shape, r->normal.w);
        if (r->number >= 0) w->impulse[pass->offset + r->at] = next;
        return;
    }
    float next = relaxInTile(w, t, p, n, r->shape.x, r->shape.y, r->normal.w, r->impulse.y, pass->last);
    if (r->number < 0) return;
    if (!pass->last) {
        w->held[pass->offset + r->at] = next;
    } else if (next > 0.0f) {
        rememberHeld(w, pass, p, r->number, next);
    }
}

// Solves the contacts of a part of a round; reads those of the fourth part from here, the impulses of the second, and measures
// those of the next.
void solvePart(const World *w, local Tile *t, const Pass *pass, int part, Reading *r, Reading *next, Reading *second) {
    barrier(CLK_LOCAL_MEM_FENCE);
    if (r->at >= 0) solveContact(w, t, pass, r);
    readContact(w, t, pass, part + 4, r);
    readImpulse(w, pass, second);
    if (pass->relaxing) measureContact(w, t, pass, next);
}

// Solves the contacts of a tile, part by part, four in turn, so that what each needs is on its way for the time of several.
void solveParts(const World *w, local Tile *t, int tile, bool relaxing, bool last) {
    Pass pass;
    pass.record = recordOf(w, tile);
    pass.offset = contactOffset(tile);
    pass.relaxing = relaxing;
    pass.last = last;
    int parts = t->parts;
    Reading a, b, c, d;
    readContact(w, t, &pass, 0, &a);
    readContact(w, t, &pass, 1, &b);
    readContact(w, t, &pass, 2, &c);
    readContact(w, t, &pass, 3, &d);
    readImpulse(w, &pass, &a);
    readImpulse(w, &pass, &b);
    barrier(CLK_LOCAL_MEM_FENCE);
    if (relaxing) measureContact(w, t, &pass, &a);
#pragma unroll 1
    for (int part = 0; part < parts; part += 4) {
        solvePart(w, t, &pass, part, &a, &b, &c);
        solvePart(w, t, &pass, part + 1, &b, &c, &d);
        solvePart(w, t, &pass, part + 2, &c, &d, &a);
        solvePart(w, t, &pass, part + 3, &d, &a, &b);
    }
    barrier(CLK_LOCAL_MEM_FENCE);
}

// Notes where the owners of contacts that are not the tile's own keep their impulses.
void findOwners(const World *w, local const Tile *t, int tile) {
    global int *numbers = numbersOf(recordOf(w, tile));
    int contacts = t->circles > 0 ? t->partStart[t->parts] : 0;
    TILE_EACH(at, contacts) {
        int number = numbers[at];
        if (number < 0) numbers[at] = w->position[number & ~NOT_OWN] | NOT_OWN;
    }
    barrier(CLK_LOCAL_MEM_FENCE | CLK_GLOBAL_MEM_FENCE);
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
    if (subStep == 0) findOwners(w, t, tile);
    solveParts(w, t, tile, false, false);
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
    solveParts(w, t, tile, true, last);
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
