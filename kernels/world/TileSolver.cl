// Stage Solver for tiles: the passes of Solver.cl, tile by tile. A sub-step has three launches. Push reads motion, traits,
// load and held and writes pushedVelocity, pushedDisplacement and impulse; it ends with what is a circle's own business, its
// move and the walls. Measure, a contact a work-item, takes what is costly about a contact out of the chain of dependent
// contacts. Relax goes back to motion, load and held. Traits change between traits and pushedTraits every sub-step.

// A work-item's group of each colour: its contacts [x, y), read ahead of need.
typedef struct {
    int2 contacts[4];
} Share;

Share shareOf(const World *w, const Region *r, bool sums) {
    Share share;
    int column, row;
#pragma unroll
    for (int colour = 0; colour < 4; colour++) {
        bool any = groupOfItem(r, colour, sums, &column, &row);
        share.contacts[colour] = any ? contactsOf(w, r, column, row) : (int2)(0, 0);
    }
    return share;
}

// Sums up, for each circle of the region, the impulses with which its contacts start the step, in their order.
void sumRemembered(const World *w, const Region *r, local Tile *t, int circles) {
    Share share = shareOf(w, r, true);
    for (int i = (int) get_local_id(0); i < circles; i += TILE_GROUP) {
        t->load[i] = (float2)(0.0f);
        t->flags[i] = 0;
    }
#pragma unroll
    for (int colour = 0; colour < 4; colour++) {
        barrier(CLK_LOCAL_MEM_FENCE);
        int2 own = share.contacts[colour];
        if (own.x < own.y) {
            int column, row;
            groupOfItem(r, colour, true, &column, &row);
            int4 cells = cellsOf(r, t, column, row);
            for (int c = own.x; c < own.y; c++) {
                float4 n = w->contact[c];
                uint link = w->link[c];
                int2 p = circlesOfLink(cells, link);
                uchar carried = link & LINK_CARRYING ? CARRIED : 0;
                if (p.x >= 0) {
                    float2 lo = t->load[p.x];
                    t->load[p.x] = (float2)(lo.x - n.x * n.w, lo.y - n.y * n.w);
                    t->flags[p.x] |= carried;
                }
                if (p.y >= 0) {
                    float2 hi = t->load[p.y];
                    t->load[p.y] = (float2)(hi.x + n.x * n.w, hi.y + n.y * n.w);
                    t->flags[p.y] |= carried;
                }
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

// The biased pass over a work-item's groups.
void pushGroups(const World *w, const Region *r, local Tile *t, const Share *share) {
#pragma unroll
    for (int colour = 0; colour < 4; colour++) {
        barrier(CLK_LOCAL_MEM_FENCE);
        int2 own = share->contacts[colour];
        if (own.x < own.y) {
            int column, row;
            groupOfItem(r, colour, false, &column, &row);
            bool owned = ownsGroup(r, column, row);
            int4 cells = cellsOf(r, t, column, row);
            // The next contact is read before this one is solved: they depend on each other by their circles alone.
            float4 n = w->contact[own.x];
            float4 shape = w->shape[own.x];
            float held = w->held[own.x];
            uint link = w->link[own.x];
            for (int c = own.x; c < own.y; c++) {
                float4 n1 = (float4)(n.x, n.y, n.z, held);
                float4 shape1 = shape;
                int2 p = circlesOfLink(cells, link);
                if (c + 1 < own.y) {
                    n = w->contact[c + 1];
                    shape = w->shape[c + 1];
                    held = w->held[c + 1];
                    link = w->link[c + 1];
                }
                float2 after = pushInTile(w, t, p, n1, shape1);
                if (owned) w->impulse[c] = after;
            }
        }
    }
    barrier(CLK_LOCAL_MEM_FENCE);
}

// The biased pass of a tile: gravity and the walls, four colours of contacts, the circles' move.
void pushTile(const World *w, local Tile *t, int tile, int subStep) {
    Region r = regionOf(w, tile);
    int circles = mapRegion(w, &r, t);
    if (circles == 0) return;
    Share share = shareOf(w, &r, false);
    bool first = subStep == 0;
    global const float4 *oldTraits = subStep & 1 ? w->pushedTraits : w->traits;
    global float4 *newTraits = subStep & 1 ? w->traits : w->pushedTraits;
    if (first) sumRemembered(w, &r, t, circles);
    int row = 0;
    for (int i = (int) get_local_id(0); i < circles; i += TILE_GROUP) {
        while (t->rowStart[row + 1] <= i) row++;
        int slot = slotOfCircle(t, row, i);
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
        if (ownsCircle(&r, t, row, i)) {
            newTraits[slot] = traits;
            w->wallBounce[slot] = bounce;
            if (first) w->homeMemory[slot] = NONE;
        }
    }
    pushGroups(w, &r, t, &share);
    row = 0;
    for (int i = (int) get_local_id(0); i < circles; i += TILE_GROUP) {
        while (t->rowStart[row + 1] <= i) row++;
        if (!ownsCircle(&r, t, row, i)) continue;
        int slot = slotOfCircle(t, row, i);
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

// Remembers a contact's impulse for the step to come. Tiles do so at the same time, in no order: a circle's remembered
// contacts are looked up by id.
void rememberShared(const World *w, int c, float lambda) {
    uint2 p = w->ordered[c];
    w->oldHi[c] = w->id[p.y];
    w->oldLambda[c] = lambda;
    w->oldNext[c] = atomic_xchg(&w->homeMemory[p.x], c);
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

// The relaxing pass over a work-item's groups.
void relaxGroups(const World *w, const Region *r, local Tile *t, const Share *share, bool last) {
#pragma unroll
    for (int colour = 0; colour < 4; colour++) {
        barrier(CLK_LOCAL_MEM_FENCE);
        int2 own = share->contacts[colour];
        if (own.x < own.y) {
            int column, row;
            groupOfItem(r, colour, false, &column, &row);
            bool owned = ownsGroup(r, column, row);
            int4 cells = cellsOf(r, t, column, row);
            float4 n = w->contact[own.x];
            float4 shape = w->shape[own.x];
            float2 pushed = w->impulse[own.x];
            uint link = w->link[own.x];
            for (int c = own.x; c < own.y; c++) {
                float4 n1 = (float4)(n.x, n.y, n.z, pushed.x);
                float4 shape1 = shape;
                float bounce = pushed.y;
                int2 p = circlesOfLink(cells, link);
                if (c + 1 < own.y) {
                    n = w->contact[c + 1];
                    shape = w->shape[c + 1];
                    pushed = w->impulse[c + 1];
                    link = w->link[c + 1];
                }
                float next = relaxInTile(w, t, p, n1, shape1, bounce, last);
                if (owned) {
                    if (!last) {
                        w->held[c] = next;
                    } else if (next > 0.0f) {
                        rememberShared(w, c, next);
                    }
                }
            }
        }
    }
    barrier(CLK_LOCAL_MEM_FENCE);
}

// The relaxing pass of a tile: four colours of contacts; in the last sub-step the circles go home.
void relaxTile(const World *w, local Tile *t, int tile, int subStep, bool last) {
    Region r = regionOf(w, tile);
    if (last && tile == 0 && get_local_id(0) == 0) w->status[STEPS_DONE]++;
    int circles = mapRegion(w, &r, t);
    if (circles == 0) return;
    Share share = shareOf(w, &r, false);
    int row = 0;
    for (int i = (int) get_local_id(0); i < circles; i += TILE_GROUP) {
        while (t->rowStart[row + 1] <= i) row++;
        float4 v = w->pushedVelocity[slotOfCircle(t, row, i)];
        t->velocity[i] = v.xy;
        t->load[i] = (float2)(0.0f);
        t->inverseMass[i] = v.z;
        t->flags[i] = v.w > 0.0f ? LOADED : 0;
    }
    relaxGroups(w, &r, t, &share, last);
    global const float4 *newTraits = subStep & 1 ? w->traits : w->pushedTraits;
    row = 0;
    for (int i = (int) get_local_id(0); i < circles; i += TILE_GROUP) {
        while (t->rowStart[row + 1] <= i) row++;
        if (!ownsCircle(&r, t, row, i)) continue;
        int slot = slotOfCircle(t, row, i);
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

// Index space of each: a work-group a tile. Cost: see Tiles.cl. The first and the last sub-step have kernels of their own.
#define TILE_KERNEL kernel __attribute__((reqd_work_group_size(TILE_GROUP, 1, 1))) void

TILE_KERNEL solver_pushTileFirst(WORLD_PARAMETERS) {
    World w = WORLD;
    local Tile tile;
    if (outOfRoom(&w)) return;
    pushTile(&w, &tile, (int) get_group_id(0), 0);
}

TILE_KERNEL solver_pushTile(WORLD_PARAMETERS, int subStep) {
    World w = WORLD;
    local Tile tile;
    if (outOfRoom(&w)) return;
    if (subStep > 0) pushTile(&w, &tile, (int) get_group_id(0), subStep);
}

TILE_KERNEL solver_relaxTile(WORLD_PARAMETERS, int subStep) {
    World w = WORLD;
    local Tile tile;
    if (outOfRoom(&w)) return;
    relaxTile(&w, &tile, (int) get_group_id(0), subStep, false);
}

TILE_KERNEL solver_relaxTileLast(WORLD_PARAMETERS, int subStep) {
    World w = WORLD;
    local Tile tile;
    if (outOfRoom(&w)) return;
    relaxTile(&w, &tile, (int) get_group_id(0), subStep, true);
}
