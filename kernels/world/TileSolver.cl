// Stage Solver for tiles: the passes of Solver.cl, tile by tile. A sub-step has three launches. Push reads motion, traits,
// load and held and writes pushedVelocity, pushedDisplacement and impulse; it ends with what is a circle's own business, its
// move and the walls. Measure, a contact a work-item, takes what is costly about a contact out of the chain of dependent
// contacts. Relax goes back to motion, load and held. Traits change between traits and pushedTraits every sub-step.

// Sums up, for each circle of the region, the impulses with which its contacts start the step, in their order.
void sumRemembered(const World *w, local Tile *t, int circles) {
    for (int i = (int) get_local_id(0); i < circles; i += TILE_GROUP) {
        t->load[i] = (float2)(0.0f);
        t->flags[i] = 0;
    }
#pragma unroll 1
    for (int colour = 0; colour < 4; colour++) {
        barrier(CLK_LOCAL_MEM_FENCE);
        int4 share = t->share[colour][get_local_id(0)];
        for (int c = share.x & ~NOT_OWN; c < share.y; c++) {
            float4 n = w->contact[c];
            uint link = w->link[c];
            int2 p = circlesOfLink(share, link);
            uchar carried = link & LINK_CARRYING ? CARRIED : 0;
            if (p.x < TILE_CIRCLES) {
                float2 lo = t->load[p.x];
                t->load[p.x] = (float2)(lo.x - n.x * n.w, lo.y - n.y * n.w);
                t->flags[p.x] |= carried;
            }
            if (p.y < TILE_CIRCLES) {
                float2 hi = t->load[p.y];
                t->load[p.y] = (float2)(hi.x + n.x * n.w, hi.y + n.y * n.w);
                t->flags[p.y] |= carried;
            }
        }
    }
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

// What a pass reads of a contact, ahead of need: while one contact is solved, the next is on its way.
typedef struct {
    float4 normal, shape;
    float2 impulse; // accumulated, and in the relaxing pass the target speed of a bounce
    uint link;
} Ahead;

// The contact that follows c in a work-item's share of a pass; -1 after the last.
int following(local const Tile *t, int colour, int c, int end) {
    if (c + 1 < end) return c + 1;
    if (colour == 3) return -1;
    int4 next = t->share[colour + 1][get_local_id(0)];
    int first = next.x & ~NOT_OWN;
    return first < next.y ? first : -1;
}

void lookAhead(const World *w, int c, bool relaxing, Ahead *ahead) {
    if (c < 0) return;
    ahead->normal = w->contact[c];
    ahead->shape = w->shape[c];
    ahead->impulse = relaxing ? w->impulse[c] : (float2)(w->held[c], 0.0f);
    ahead->link = w->link[c];
}

// The biased pass over the groups of a region.
void pushGroups(const World *w, local Tile *t) {
    Ahead ahead;
    int item = (int) get_local_id(0);
    lookAhead(w, following(t, -1, 0, 0), false, &ahead);
#pragma unroll 1
    for (int colour = 0; colour < 4; colour++) {
        barrier(CLK_LOCAL_MEM_FENCE);
        int4 share = t->share[colour][item];
        int first = share.x & ~NOT_OWN;
        if (first >= share.y) lookAhead(w, following(t, colour, first, share.y), false, &ahead);
        for (int c = first; c < share.y; c++) {
            Ahead now = ahead;
            lookAhead(w, following(t, colour, c, share.y), false, &ahead);
            float4 n = (float4)(now.normal.x, now.normal.y, now.normal.z, now.impulse.x);
            float2 after = pushInTile(w, t, circlesOfLink(share, now.link), n, now.shape);
            if (share.x >= 0) w->impulse[c] = after;
        }
    }
    barrier(CLK_LOCAL_MEM_FENCE);
}

// The biased pass of a tile: gravity and the walls, four colours of contacts, the circles' move.
void pushTile(const World *w, local Tile *t, int circles, int subStep) {
    bool first = subStep == 0;
    global const float4 *oldTraits = subStep & 1 ? w->pushedTraits : w->traits;
    global float4 *newTraits = subStep & 1 ? w->traits : w->pushedTraits;
#pragma unroll 1
    for (int i = (int) get_local_id(0); i < circles; i += TILE_GROUP) {
        int slot = t->slot[i] & ~NOT_OWN;
        float4 c = w->circle[slot];
        float4 m = w->motion[slot];
        float4 traits = oldTraits[slot];
        float4 load = first ? (float4)(t->load[i].x, t->load[i].y, 0.0f, t->flags[i] & CARRIED ? 1.0f : 0.0f)
                            : w->load[slot];
        float2 before, bounce;
        bool loaded;
        accelerate(w, c, &m, &traits, load, &before, &bounce, &loaded);
        t->velocity[i] = m.zw;
        t->load[i] = before;
        t->inverseMass[i] = traits.x;
        t->flags[i] = loaded ? LOADED : 0;
        if (t->slot[i] >= 0) {
            newTraits[slot] = traits;
            w->wallBounce[slot] = bounce;
            if (first) w->homeMemory[slot] = NONE;
        }
    }
    pushGroups(w, t);
#pragma unroll 1
    for (int i = (int) get_local_id(0); i < circles; i += TILE_GROUP) {
        int slot = t->slot[i];
        if (slot < 0) continue;
        float4 m = w->motion[slot];
        m.zw = t->velocity[i];
        float4 traits = newTraits[slot];
        bool loaded = t->flags[i] & LOADED;
        moveCircle(w, w->circle[slot], &m, &traits, w->wallBounce[slot], loaded);
        newTraits[slot] = traits;
        w->pushedVelocity[slot] = (float4)(m.z, m.w, traits.x, loaded ? 1.0f : 0.0f);
        w->pushedDisplacement[slot] = m.xy;
    }
}

// Measures a contact after the circles have moved.
void measureContact(const World *w, int c) {
    uint2 p = w->ordered[c];
    float4 ci = w->circle[p.x];
    float4 cj = w->circle[p.y];
    float4 n;
    if (!measure(&n, cj.x - ci.x, cj.y - ci.y, ci.z + cj.z, w->pushedDisplacement[p.x], w->pushedDisplacement[p.y])) {
        n.xy = w->contact[c].xy;
    }
    n.w = 0.0f;
    w->contact[c] = n;
}

// Index space: any number of work-items, which take the contacts in turn.
kernel void solver_measure(WORLD_PARAMETERS) {
    World w = WORLD;
    if (outOfRoom(&w)) return;
    int contacts = groupStart[levels->first[LEVELS]];
    for (int c = (int) get_global_id(0); c < contacts; c += (int) get_global_size(0)) measureContact(&w, c);
}

// The relaxing pass over one contact: returns its new impulse.
float relaxInTile(const World *w, local Tile *t, int2 p, float4 n, float4 shape, float bounce, bool last) {
    float wi = t->inverseMass[p.x];
    float wj = t->inverseMass[p.y];
    bool unloaded = ((t->flags[p.x] | t->flags[p.y]) & LOADED) == 0;
    float2 vi = t->velocity[p.x];
    float2 vj = t->velocity[p.y];
    float vn = along(n.x, n.y, vj.x - vi.x, vj.y - vi.y);
    float next, impulse;
    bool solved;
    bool moves = relaxImpulse(w, n, shape.x, shape.y, shape.w, vn, bounce, unloaded, &next, &impulse, &solved);
    if (moves) applyTo(t, p, vi, vj, n.x, n.y, wi, wj, impulse);
    if (solved && !last && carries(next, n.z, vn + impulse * (wi + wj), shape.y)) {
        float2 lo = t->load[p.x];
        float2 hi = t->load[p.y];
        t->load[p.x] = (float2)(lo.x - n.x * next, lo.y - n.y * next);
        t->load[p.y] = (float2)(hi.x + n.x * next, hi.y + n.y * next);
        t->flags[p.x] |= CARRIED;
        t->flags[p.y] |= CARRIED;
    }
    return next;
}

// The relaxing pass over the groups of a region.
void relaxGroups(const World *w, local Tile *t, bool last) {
    Ahead ahead;
    int item = (int) get_local_id(0);
    lookAhead(w, following(t, -1, 0, 0), true, &ahead);
#pragma unroll 1
    for (int colour = 0; colour < 4; colour++) {
        barrier(CLK_LOCAL_MEM_FENCE);
        int4 share = t->share[colour][item];
        int first = share.x & ~NOT_OWN;
        if (first >= share.y) lookAhead(w, following(t, colour, first, share.y), true, &ahead);
        for (int c = first; c < share.y; c++) {
            Ahead now = ahead;
            lookAhead(w, following(t, colour, c, share.y), true, &ahead);
            float4 n = (float4)(now.normal.x, now.normal.y, now.normal.z, now.impulse.x);
            float next = relaxInTile(w, t, circlesOfLink(share, now.link), n, now.shape, now.impulse.y, last);
            if (share.x >= 0) w->held[c] = next;
        }
    }
    barrier(CLK_LOCAL_MEM_FENCE);
}

// The relaxing pass of a tile: four colours of contacts; in the last sub-step the circles go home.
void relaxTile(const World *w, local Tile *t, int circles, int subStep, bool last) {
#pragma unroll 1
    for (int i = (int) get_local_id(0); i < circles; i += TILE_GROUP) {
        float4 v = w->pushedVelocity[t->slot[i] & ~NOT_OWN];
        t->velocity[i] = v.xy;
        t->load[i] = (float2)(0.0f);
        t->inverseMass[i] = v.z;
        t->flags[i] = v.w > 0.0f ? LOADED : 0;
    }
    relaxGroups(w, t, last);
    global const float4 *newTraits = subStep & 1 ? w->traits : w->pushedTraits;
#pragma unroll 1
    for (int i = (int) get_local_id(0); i < circles; i += TILE_GROUP) {
        int slot = t->slot[i];
        if (slot < 0) continue;
        float2 d = w->pushedDisplacement[slot];
        float2 v = t->velocity[i];
        float4 m = (float4)(d.x, d.y, v.x, v.y);
        if (last) {
            goHome(w, slot, w->circle[slot], m, newTraits[slot]);
        } else {
            float2 load = t->load[i];
            w->motion[slot] = m;
            w->load[slot] = (float4)(load.x, load.y, 0.0f, t->flags[i] & CARRIED ? 1.0f : 0.0f);
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
    if (outOfRoom(&w)) return;
    int contacts = groupStart[levels->first[LEVELS]];
    for (int c = (int) get_global_id(0); c < contacts; c += (int) get_global_size(0)) rememberHeld(&w, c);
}

// Takes a tile: numbers its circles and shares out its groups; at the start of a step, the load of its circles too. Returns
// how many circles its region has.
int takeTile(const World *w, local Tile *t, int tile, bool start) {
    Region r = regionOf(w, tile);
    int circles = mapRegion(w, &r, t);
    if (circles == 0) return 0;
    if (start) {
        shareGroups(w, &r, t, true);
        sumRemembered(w, t, circles);
    }
    shareGroups(w, &r, t, false);
    return circles;
}

// Index space of each: a work-group a tile. Cost: see Tiles.cl. The first and the last sub-step have kernels of their own.
#define TILE_KERNEL kernel __attribute__((reqd_work_group_size(TILE_GROUP, 1, 1))) void

TILE_KERNEL solver_pushTileFirst(WORLD_PARAMETERS) {
    World w = WORLD;
    local Tile t;
    if (outOfRoom(&w)) return;
    int circlesHere = takeTile(&w, &t, (int) get_group_id(0), true);
    if (circlesHere > 0) pushTile(&w, &t, circlesHere, 0);
}

TILE_KERNEL solver_pushTile(WORLD_PARAMETERS, int subStep) {
    World w = WORLD;
    local Tile t;
    if (outOfRoom(&w) || subStep == 0) return;
    int circlesHere = takeTile(&w, &t, (int) get_group_id(0), false);
    if (circlesHere > 0) pushTile(&w, &t, circlesHere, subStep);
}

TILE_KERNEL solver_relaxTile(WORLD_PARAMETERS, int subStep) {
    World w = WORLD;
    local Tile t;
    if (outOfRoom(&w)) return;
    int circlesHere = takeTile(&w, &t, (int) get_group_id(0), false);
    if (circlesHere > 0) relaxTile(&w, &t, circlesHere, subStep, false);
}

TILE_KERNEL solver_relaxTileLast(WORLD_PARAMETERS, int subStep) {
    World w = WORLD;
    local Tile t;
    if (outOfRoom(&w)) return;
    if (get_global_id(0) == 0) status[STEPS_DONE]++;
    int circlesHere = takeTile(&w, &t, (int) get_group_id(0), false);
    if (circlesHere > 0) relaxTile(&w, &t, circlesHere, subStep, true);
}
