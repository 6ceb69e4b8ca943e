// uses: world/shared/PairRule.cl world/shared/Drive.cl world/stages/Grid.cl world/stages/PairFilter.cl
// Stage ContinuousCollision: keeps fast circles from passing through others. The Java class of this name explains what is
// looked for; it is the same, function by function. Made only in steps where some circle is fast: in others every motion clamp
// is as stage Grid has set it.

// From the host: BLOCK_LOG, which is 2: blocks are 4 x 4 cells, as many rows as a piece has ranges.

// What a fast circle looks ahead with. least: by how much it must move against another to matter; pushers: looks for who pushes
// whom.
typedef struct {
    float x, y, r, px, py, path, speculativeDistance, least;
    int slot;
    bool isStatic, pushers;
} Runner;

// The range of the paths of the circles in a block of cells.
void summarize(const World *w, int block) {
    constant Levels *levels = w->levels;
    int l = 0;
    while (l < levels->usedCount - 1 && block >= levels->first[levels->used[l + 1]] >> (2 * BLOCK_LOG)) l++;
    int level = levels->used[l];
    int cl = levels->columnsLog[level];
    int inLevel = block - (levels->first[level] >> (2 * BLOCK_LOG));
    int row = inLevel >> (cl - BLOCK_LOG);
    int column = inLevel & ((1 << (cl - BLOCK_LOG)) - 1);
    float4 range = (float4)(INFINITY, -INFINITY, INFINITY, -INFINITY);
    global const int *from = w->bucketStart + levels->first[level] + (row << BLOCK_LOG << cl) + (column << BLOCK_LOG);
    global const int *to = from + (1 << BLOCK_LOG);
    Piece piece = pieceOfRanges((int4)(from[0], from[1 << cl], from[2 << cl], from[3 << cl]),
                                (int4)(to[0], to[1 << cl], to[2 << cl], to[3 << cl]));
    for (int i = 0; i < piece.end.w; i++) {
        float2 path = w->motionClamp[slotInPiece(&piece, i)].xy;
        range.x = least(path.x, range.x);
        range.y = greatest(path.x, range.y);
        range.z = least(path.y, range.z);
        range.w = greatest(path.y, range.w);
    }
    w->blockRange[block] = range;
}

// Index space: a block a work-item. Cost: its circles.
kernel void continuousCollision_summarize(WORLD_PARAMETERS) {
    World w = WORLD;
    int block = (int) get_global_id(0);
    if (block < levels->first[LEVELS] >> (2 * BLOCK_LOG) && !refused(&w)) summarize(&w, block);
}

// Whether a circle looks ahead: whether it is fast.
bool looksAhead(const World *w, int slot) { return w->near[slot].x < NOT_FAST; }

void restrain(const World *w, int slot, float most, bool stands) {
    float allowance = least(most, fabs(w->near[slot].y));
    w->near[slot].y = stands ? -allowance : allowance;
}

// Floats from 0 on sort like their bits.
void shorten(const World *w, int slot, float t) { atomic_min(&w->timeOfImpact[slot], as_int(t)); }

void meet(const World *w, const Runner *s, int other) {
    float4 c = w->circle[other];
    float4 plan = w->motionClamp[other];
    float ux = s->px - plan.x;
    float uy = s->py - plan.y;
    if (!isLonger(ux, uy, s->least)) return;
    bool pushes = s->isStatic;
    bool stands = inverseMass(c.w) == 0.0f; // spares a read
    if (!mayMeet(w, s->slot, pushes ? 0.0f : 1.0f, other, stands ? 0.0f : 1.0f)) return;
    if (!pushes && !stands && !sweeps(s->r, c.z)) return;
    float dx = c.x - s->x;
    float dy = c.y - s->y;
    if (stands && isNear(dx, dy, (s->r + s->path) + c.z)) {
        restrain(w, s->slot, CLAMP_ALLOWANCE * s->r, w->near[s->slot].y < 0.0f);
    }
    // First what most pairs fail.
    float t = timeOfImpact(dx, dy, ux, uy, s->r + c.z);
    if (!(t < 1.0f)) return;
    bool carries = (pushes && isFast(s->path, c.z)) || (stands && isFast(plan.w, s->r));
    if (isNear(dx, dy, s->speculativeDistance + w->sight[other].z) && !carries &&
        !isLonger(ux, uy, (0.5f * CAP) * (s->r + c.z))) {
        return;
    }
    float slack = pushes || stands ? MARGIN : HOLD;
    if (!carries && isNear(dx, dy, (s->r + slack * s->r) + (c.z + slack * c.z))) {
        if (pushes || s->pushers) return;
        w->near[s->slot].x = least(t, w->near[s->slot].x);
        float most = holdAllowance(s->r, s->path, c.z, stands);
        restrain(w, s->slot, most, stands || w->near[s->slot].y < 0.0f);
    } else if (s->pushers) {
        if (pushes && w->timeOfImpact[other] == as_int(t)) {
            atomic_min(&w->pusher[other], s->slot);
        } else if (stands && plan.w > 0.0f && w->timeOfImpact[s->slot] == as_int(t)) {
            atomic_min(&w->pusher[s->slot], other);
        }
    } else if (pushes || stands) {
        shorten(w, pushes ? other : s->slot, t);
        if (pushes || plan.w > 0.0f) w->status[PUSHED] = 1;
    } else if (plan.w <= s->path || !isFast(plan.w, c.z)) {
        shorten(w, s->slot, t);
        if (isFast(plan.w, c.z)) shorten(w, other, t);
    }
}

// How many columns (or rows) from one on lie in its block, of those on the ring and no more than so many behind it.
int inBlock(int column, int side, int most) {
    int blockEnd = (column | ((1 << BLOCK_LOG) - 1)) + 1;
    return min(min(blockEnd, side) - column, most + 1);
}

void meetAll(const World *w, const Runner *s, int from, int to) {
    for (int other = from; other < to; other++) {
        if (other != s->slot) meet(w, s, other);
    }
}

// Looks at the columns [c0, c1] and rows [r0, r1] of a level, block by block.
void lookAt(const World *w, const Runner *s, int level, int c0, int c1, int r0, int r1) {
    int cl = w->levels->columnsLog[level];
    int columns = w->levels->columnCount[level];
    int rows = w->levels->rowCount[level];
    int first = w->levels->first[level];
    for (int v = r0; v <= r1;) {
        int row = onRing(v, rows);
        int rowsOfBlock = inBlock(row, rows, r1 - v);
        for (int u = c0; u <= c1;) {
            int column = onRing(u, columns);
            int columnsOfBlock = inBlock(column, columns, c1 - u);
            float4 range = w->blockRange[(first >> (2 * BLOCK_LOG)) + (row >> BLOCK_LOG << (cl - BLOCK_LOG)) +
                                         (column >> BLOCK_LOG)];
            if (differ(s->px, s->py, range.x, range.y, range.z, range.w, s->least)) {
                for (int r = row; r < row + rowsOfBlock; r++) {
                    global const int *start = w->bucketStart + first + (r << cl) + column;
                    meetAll(w, s, start[0], start[columnsOfBlock]);
                }
            }
            u += columnsOfBlock;
        }
        v += rowsOfBlock;
    }
}

void lookAhead(const World *w, int slot, bool pushers) {
    float4 c = w->circle[slot];
    float4 plan = w->motionClamp[slot];
    float4 sight = w->sight[slot];
    bool isStatic = sight.w == 0.0f;
    Runner s = {c.x, c.y, c.z, plan.x, plan.y, plan.w, sight.z, CAP * (isStatic ? leastRadius(w) : c.z), slot, isStatic,
                pushers};
    for (int l = 0; l < w->levels->usedCount; l++) {
        int level = w->levels->used[l];
        float top = w->levels->top[level];
        float margin = sightMargin(s.r, s.path, top);
        float minX = w->levels->minX;
        float minY = w->levels->minY;
        float edge = w->levels->inverseEdge[level];
        int c0 = cell(least(s.x, s.x + s.px) - margin, minX, edge);
        int c1 = cell(greatest(s.x, s.x + s.px) + margin, minX, edge);
        int r0 = cell(least(s.y, s.y + s.py) - margin, minY, edge);
        int r1 = cell(greatest(s.y, s.y + s.py) + margin, minY, edge);
        lookAt(w, &s, level, c0, min(c1, c0 + w->levels->columnCount[level] - 1), r0,
               min(r1, r0 + w->levels->rowCount[level] - 1));
    }
}

// Fast circles look for others that they would touch, no faster than themselves. Index space: a working slot a work-item.
// Cost: the cells around its path, for a fast circle.
kernel void continuousCollision_look(WORLD_PARAMETERS) {
    World w = WORLD;
    int slot = (int) get_global_id(0);
    if (slot < circles && !refused(&w) && looksAhead(&w, slot)) lookAhead(&w, slot, false);
}

// Where static circles push others, finds out who pushes whom. Index space and cost: the same.
kernel void continuousCollision_push(WORLD_PARAMETERS) {
    World w = WORLD;
    int slot = (int) get_global_id(0);
    if (slot < circles && status[PUSHED] != 0 && !refused(&w) && looksAhead(&w, slot)) lookAhead(&w, slot, true);
}

// Sets a motion clamp: the free part of the path, and how far the circle may leave it; or, at a static circle, the path, how far
// it may leave that, negative, and the share of it that is free. A circle that stops loses time, and so what gravity would give it
// in that time. After all have looked ahead.
void setMotionClamp(const World *w, int slot) {
    float4 sight = w->sight[slot];
    if (sight.w == 0.0f) return;
    const StepConstants *k = &w->k;
    float4 plan = w->motionClamp[slot];
    float r = w->circle[slot].z;
    float free = as_float(w->timeOfImpact[slot]);
    float2 near = w->near[slot];
    float limit = least(near.x, 1.0f);
    float allowance = limit < 1.0f ? near.y : CLAMP_ALLOWANCE * r;
    float2 path = plan.xy;
    if (free < limit) {
        float rest = 1.0f - free;
        int pusher = w->pusher[slot];
        path = (float2)(free * path.x, free * path.y);
        allowance = 0.0f;
        if (pusher != NOBODY) {
            float4 pushed = w->motionClamp[pusher];
            path = (float2)(path.x + rest * pushed.x, path.y + rest * pushed.y);
            allowance = isFast(pushed.w, r) ? CARRIED : 0.0f;
        }
        w->sight[slot].z = speculativeDistance(r, 0.0f);
        float2 gain = gainOf(w, w->id[slot], sight.w);
        w->motion[slot].z -= rest * (gain.x * k->subSteps);
        w->motion[slot].w -= rest * (gain.y * k->subSteps);
    } else if (allowance >= 0.0f) {
        path = (float2)(limit * path.x, limit * path.y);
    }
    w->motionClamp[slot] = (float4)(path.x, path.y, allowance, limit);
}

// Index space: a working slot a work-item. Constant cost.
kernel void continuousCollision_clamp(WORLD_PARAMETERS) {
    World w = WORLD;
    int slot = (int) get_global_id(0);
    if (slot < circles && !refused(&w)) setMotionClamp(&w, slot);
}
