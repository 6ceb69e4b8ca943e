// Stage Solver where all circles are of one level: the passes of Solver.cl, tile by tile. The biased pass reads motion,
// traits, load and contact and writes pushedMotion, pushedTraits, pushedWalls and impulse; the relaxing pass goes the other
// way, the last one home.

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
        int column, row;
        groupOfItem(r, colour, true, &column, &row);
        int2 own = share.contacts[colour];
        if (own.x >= own.y) continue;
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
    barrier(CLK_LOCAL_MEM_FENCE);
}

void putCircle(local Tile *t, int i, float4 c, float4 m, float4 traits, float2 load, uchar flags) {
    t->centre[i] = c.xy;
    t->shape[i] = (float2)(c.z, traits.y);
    t->displacement[i] = m.xy;
    t->velocity[i] = m.zw;
    t->inverseMass[i] = traits.x;
    t->load[i] = load;
    t->flags[i] = flags;
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
float2 pushInTile(const World *w, local Tile *t, int2 p, float4 n) {
    float2 si = t->shape[p.x];
    float2 sj = t->shape[p.y];
    float wi = t->inverseMass[p.x];
    float wj = t->inverseMass[p.y];
    float2 bi = t->load[p.x];
    float2 bj = t->load[p.y];
    bool loaded = ((t->flags[p.x] | t->flags[p.y]) & LOADED) != 0;
    float2 vi = t->velocity[p.x];
    float2 vj = t->velocity[p.y];
    float sum = si.x + sj.x;
    float next, bounce, impulse;
    bool moves = pushImpulse(w, n, greatest(si.y, sj.y), w->k->thresholdRate * sum, 1.0f / (wi + wj),
                             pushSpeed(sum, w->k->pushPerLength, w->k->pushPerRoot),
                             along(n.x, n.y, vj.x - vi.x, vj.y - vi.y), along(n.x, n.y, bj.x - bi.x, bj.y - bi.y), loaded,
                             &next, &bounce, &impulse);
    if (moves) applyTo(t, p, vi, vj, n.x, n.y, wi, wj, impulse);
    return (float2)(next, bounce);
}

// The biased pass of a tile: gravity and the walls, then four colours of contacts. first: in the first sub-step.
void pushTile(const World *w, local Tile *t, int tile, bool first) {
    Region r = regionOf(w, tile);
    int circles = mapRegion(w, &r, t);
    if (circles == 0) return;
    Share share = shareOf(w, &r, false);
    if (first) sumRemembered(w, &r, t, circles);
    int row = 0;
    for (int i = (int) get_local_id(0); i < circles; i += TILE_GROUP) {
        while (t->rowStart[row + 1] <= i) row++;
        int slot = slotOfCircle(t, row, i);
        float4 c = w->circle[slot];
        float4 m = w->motion[slot];
        float4 traits = w->traits[slot];
        float4 load = first ? (float4)(t->load[i].x, t->load[i].y, 0.0f, t->flags[i] & CARRIED ? 1.0f : 0.0f)
                            : w->load[slot];
        float2 before, bounce;
        bool loaded;
        accelerate(w, c, &m, &traits, load, &before, &bounce, &loaded);
        putCircle(t, i, c, m, traits, before, loaded ? LOADED : 0);
        if (ownsCircle(&r, t, row, i)) {
            w->pushedTraits[slot] = traits;
            w->pushedWalls[slot] = (float4)(bounce.x, bounce.y, loaded ? 1.0f : 0.0f, 0.0f);
            if (first) w->homeMemory[slot] = NONE;
        }
    }
#pragma unroll
    for (int colour = 0; colour < 4; colour++) {
        barrier(CLK_LOCAL_MEM_FENCE);
        int column;
        groupOfItem(&r, colour, false, &column, &row);
        int2 own = share.contacts[colour];
        if (own.x >= own.y) continue;
        bool owned = ownsGroup(&r, column, row);
        int4 cells = cellsOf(&r, t, column, row);
        // The next contact is read before this one is solved: they wait for each other through their circles alone.
        float4 n = w->contact[own.x];
        uint link = w->link[own.x];
        for (int c = own.x; c < own.y; c++) {
            float4 n1 = n;
            int2 p = circlesOfLink(cells, link);
            if (c + 1 < own.y) {
                n = w->contact[c + 1];
                link = w->link[c + 1];
            }
            float2 after = pushInTile(w, t, p, n1);
            if (owned) w->impulse[c] = after;
        }
    }
    barrier(CLK_LOCAL_MEM_FENCE);
    row = 0;
    for (int i = (int) get_local_id(0); i < circles; i += TILE_GROUP) {
        while (t->rowStart[row + 1] <= i) row++;
        if (!ownsCircle(&r, t, row, i)) continue;
        float2 d = t->displacement[i];
        float2 v = t->velocity[i];
        w->pushedMotion[slotOfCircle(t, row, i)] = (float4)(d.x, d.y, v.x, v.y);
    }
}

// Remembers a contact's impulse for the step to come. Tiles do so at the same time, in no order: a circle's remembered
// contacts are looked up by id.
void rememberShared(const World *w, int c, float lambda) {
    uint2 p = w->pair[c];
    w->oldHi[c] = w->id[p.y];
    w->oldLambda[c] = lambda;
    w->oldNext[c] = atomic_xchg(&w->homeMemory[p.x], c);
}

// The relaxing pass over one contact: returns it as it is afterwards.
float4 relaxInTile(const World *w, local Tile *t, int2 p, int c, float2 pushed, bool last) {
    float2 ci = t->centre[p.x];
    float2 cj = t->centre[p.y];
    float2 si = t->shape[p.x];
    float2 sj = t->shape[p.y];
    float wi = t->inverseMass[p.x];
    float wj = t->inverseMass[p.y];
    bool unloaded = ((t->flags[p.x] | t->flags[p.y]) & LOADED) == 0;
    float2 vi = t->velocity[p.x];
    float2 vj = t->velocity[p.y];
    float sum = si.x + sj.x;
    float4 n;
    if (!measure(&n, cj.x - ci.x, cj.y - ci.y, sum, t->displacement[p.x], t->displacement[p.y])) n.xy = w->contact[c].xy;
    n.w = pushed.x;
    float vn = along(n.x, n.y, vj.x - vi.x, vj.y - vi.y);
    float thr2 = w->k->thresholdRate * sum;
    float next, impulse;
    bool solved;
    bool moves = relaxImpulse(w, n, greatest(si.y, sj.y), thr2, 1.0f / (wi + wj), vn, pushed.y, unloaded, &next, &impulse,
                              &solved);
    if (moves) applyTo(t, p, vi, vj, n.x, n.y, wi, wj, impulse);
    n.w = next;
    if (solved && !last && carries(next, n.z, vn + impulse * (wi + wj), thr2)) {
        float2 lo = t->load[p.x];
        float2 hi = t->load[p.y];
        t->load[p.x] = (float2)(lo.x - n.x * next, lo.y - n.y * next);
        t->load[p.y] = (float2)(hi.x + n.x * next, hi.y + n.y * next);
        t->flags[p.x] |= CARRIED;
        t->flags[p.y] |= CARRIED;
    }
    return n;
}

// The relaxing pass of a tile: moves the circles, then four colours of contacts. last: in the last sub-step.
void relaxTile(const World *w, local Tile *t, int tile, bool last) {
    Region r = regionOf(w, tile);
    if (last && tile == 0 && get_local_id(0) == 0) w->status[STEPS_DONE]++;
    int circles = mapRegion(w, &r, t);
    if (circles == 0) return;
    Share share = shareOf(w, &r, false);
    int row = 0;
    for (int i = (int) get_local_id(0); i < circles; i += TILE_GROUP) {
        while (t->rowStart[row + 1] <= i) row++;
        int slot = slotOfCircle(t, row, i);
        float4 c = w->circle[slot];
        float4 m = w->pushedMotion[slot];
        float4 traits = w->pushedTraits[slot];
        float4 walls = w->pushedWalls[slot];
        bool loaded = walls.z > 0.0f;
        moveCircle(w, c, &m, &traits, walls.xy, loaded);
        putCircle(t, i, c, m, traits, (float2)(0.0f), loaded ? LOADED : 0);
        if (ownsCircle(&r, t, row, i)) w->traits[slot] = traits;
    }
#pragma unroll
    for (int colour = 0; colour < 4; colour++) {
        barrier(CLK_LOCAL_MEM_FENCE);
        int column;
        groupOfItem(&r, colour, false, &column, &row);
        int2 own = share.contacts[colour];
        if (own.x >= own.y) continue;
        bool owned = ownsGroup(&r, column, row);
        int4 cells = cellsOf(&r, t, column, row);
        float2 pushed = w->impulse[own.x];
        uint link = w->link[own.x];
        for (int c = own.x; c < own.y; c++) {
            float2 pushed1 = pushed;
            int2 p = circlesOfLink(cells, link);
            if (c + 1 < own.y) {
                pushed = w->impulse[c + 1];
                link = w->link[c + 1];
            }
            float4 n = relaxInTile(w, t, p, c, pushed1, last);
            if (!owned) continue;
            w->contact[c] = n;
            if (last && n.w > 0.0f) rememberShared(w, c, n.w);
        }
    }
    barrier(CLK_LOCAL_MEM_FENCE);
    row = 0;
    for (int i = (int) get_local_id(0); i < circles; i += TILE_GROUP) {
        while (t->rowStart[row + 1] <= i) row++;
        if (!ownsCircle(&r, t, row, i)) continue;
        int slot = slotOfCircle(t, row, i);
        float2 d = t->displacement[i];
        float2 v = t->velocity[i];
        float4 m = (float4)(d.x, d.y, v.x, v.y);
        if (last) {
            goHome(w, slot, w->circle[slot], m, w->traits[slot]);
        } else {
            float2 load = t->load[i];
            w->motion[slot] = m;
            w->load[slot] = (float4)(load.x, load.y, 0.0f, t->flags[i] & CARRIED ? 1.0f : 0.0f);
        }
    }
}

// Index space: a work-group a tile. Cost of each: see Tiles.cl. The first and the last sub-step have kernels of their own.
#define TILE_KERNEL kernel __attribute__((reqd_work_group_size(TILE_GROUP, 1, 1))) void

TILE_KERNEL solver_pushTileFirst(WORLD_PARAMETERS) {
    World w = WORLD;
    local Tile tile;
    if (outOfRoom(&w)) return;
    pushTile(&w, &tile, (int) get_group_id(0), true);
}

TILE_KERNEL solver_pushTile(WORLD_PARAMETERS) {
    World w = WORLD;
    local Tile tile;
    if (outOfRoom(&w)) return;
    pushTile(&w, &tile, (int) get_group_id(0), false);
}

TILE_KERNEL solver_relaxTile(WORLD_PARAMETERS) {
    World w = WORLD;
    local Tile tile;
    if (outOfRoom(&w)) return;
    relaxTile(&w, &tile, (int) get_group_id(0), false);
}

TILE_KERNEL solver_relaxTileLast(WORLD_PARAMETERS) {
    World w = WORLD;
    local Tile tile;
    if (outOfRoom(&w)) return;
    relaxTile(&w, &tile, (int) get_group_id(0), true);
}
