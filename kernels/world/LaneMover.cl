// The circles' part of stage Solver for a row of cells: accelerate, moveCircle and goHome of Solver.cl, but for circles that
// are out of reach of the walls, with what is left of them there. Loops have a copy of the World of their own, whose pointers
// stay in registers; what is called for circles at walls gets the shared one: a copy that others know stays in memory.

typedef struct {
    int from, to; // slots
} Cells;

Cells cellsOf(const World *w, int row) {
    int l = w->levels->used[0];
    global const int *start = w->bucketStart + w->levels->first[l] + (row << w->levels->columnsLog[l]);
    Cells c = {start[0], start[1 << w->levels->columnsLog[l]]};
    return c;
}

// wallSide and wallGap of the nearer wall of both axes.
void nearerWalls(const StepConstants *k, float4 c, float2 d, float2 *side, float2 *gap) {
    side->x = wallSide(c.x, k->minX, k->maxX);
    side->y = wallSide(c.y, k->minY, k->maxY);
    gap->x = wallGap(c.x, d.x, c.z, side->x, k->minX, k->maxX);
    gap->y = wallGap(c.y, d.y, c.z, side->y, k->minY, k->maxY);
}

// Gravity, the impulses of the sub-step before, and the biased pass over the walls.
void accelerateRow(const World *shared, int row) {
    World own = *shared;
    const World *w = &own;
    const StepConstants *k = &w->k;
    Cells cells = cellsOf(w, row);
    for (int slot = cells.from; slot < cells.to; slot++) {
        float4 c = w->circle[slot];
        float4 m = w->motion[slot];
        float4 t = w->traits[slot];
        float4 l = w->load[slot];
        float2 side, gap;
        nearerWalls(k, c, m.xy, &side, &gap);
        float2 before = m.zw + (float2)(k->gravityStepX, k->gravityStepY);
        float2 v = (float2)(limitSpeed(before.x + t.x * l.x), limitSpeed(before.y + t.x * l.y));
        float2 approach = side * v;
        bool clear = (t.x != 0.0f) & (t.z == 0.0f) & (t.w == 0.0f) & (gap.x > 0.0f) & (gap.y > 0.0f) &
                     (gap.x * k->inverseH + approach.x >= 0.0f) & (gap.y * k->inverseH + approach.y >= 0.0f) &
                     (gap.x + side.x * before.x * k->h >= 0.0f) & (gap.y + side.y * before.y * k->h >= 0.0f);
        float2 bounce = (float2)(0.0f);
        bool loaded = l.w > 0.0f;
        if (clear) {
            // No wall has an impulse, or gets one. Adding zeros, as the long way does: the sign of a zero is part of the state.
            m.zw = v + side * 0.0f;
            t.zw = side * 0.0f;
        } else {
            accelerate(shared, c, &m, &t, l, &before, &bounce, &loaded);
        }
        w->motion[slot] = m;
        w->traits[slot] = t;
        w->wallBounce[slot] = bounce;
        w->load[slot] = (float4)(before.x, before.y, loaded ? 1.0f : 0.0f, l.w);
    }
}

// Moves circles, keeps them within the walls, and makes the relaxing pass over the walls. first: forgets the impulses of the
// step before, which have been recalled.
void moveRow(const World *shared, int row, bool first) {
    World own = *shared;
    const World *w = &own;
    const StepConstants *k = &w->k;
    Cells cells = cellsOf(w, row);
    for (int slot = cells.from; slot < cells.to; slot++) {
        float4 c = w->circle[slot];
        float4 m = w->motion[slot];
        float4 t = w->traits[slot];
        float2 bounce = w->wallBounce[slot];
        float loaded = w->load[slot].z;
        float2 v = (float2)(limitSpeed(m.z), limitSpeed(m.w));
        float2 d = m.xy + v * k->h;
        float2 side, gap;
        nearerWalls(k, c, d, &side, &gap);
        float allowance = w->k.sweeping ? w->leash[slot].z : LEASH * c.z;
        float x = c.x + d.x;
        float y = c.y + d.y;
        bool clear = (t.x != 0.0f) & (t.z == 0.0f) & (t.w == 0.0f) & (bounce.x == 0.0f) & (bounce.y == 0.0f) &
                     (gap.x > 0.0f) & (gap.y > 0.0f) & (x >= k->minX + c.z) & (x <= k->maxX - c.z) &
                     (y >= k->minY + c.z) & (y <= k->maxY - c.z) & (d.x * d.x + d.y * d.y <= allowance * allowance);
        if (clear) {
            w->motion[slot] = (float4)(d.x, d.y, v.x, v.y);
        } else {
            moveCircle(shared, slot, c, &m, &t, bounce, loaded > 0.0f);
            w->motion[slot] = m;
            w->traits[slot] = t;
        }
        w->load[slot] = (float4)(0.0f, 0.0f, loaded, 0.0f);
        if (first) w->memory[slot] = NONE;
    }
}

// Ends the step for circles.
void finishRow(const World *shared, int row) {
    World own = *shared;
    const World *w = &own;
    Cells cells = cellsOf(w, row);
    for (int slot = cells.from; slot < cells.to; slot++) {
        goHome(w, slot, w->circle[slot], w->motion[slot], w->traits[slot]);
        w->homeMemory[slot] = w->memory[slot];
    }
}
