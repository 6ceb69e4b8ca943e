// uses: world/shared/PairRule.cl world/stages/World.cl
// Stage ContinuousCollision: keeps fast circles from passing through others. The Java class of this name explains what is
// looked for; it is the same, function by function. Made only in steps where some circle is fast: in others every motion clamp
// is as stage Grid has set it.

// From the host: BLOCK_LOG, which is 2: blocks are 4 x 4 cells, as many rows as a piece has ranges.

// What a fast circle looks ahead with.
typedef struct {
    float x, y, r, px, py, path, speculativeDistance;
    int slot;
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
bool looksAhead(const World *w, int slot) { return w->near[slot] < NOT_FAST; }

// The same for one that may be looking at the same time.
bool otherLooksAhead(const World *w, int slot) {
    return w->traits[slot].x != 0.0f && isFast(w->motionClamp[slot].w, w->circle[slot].z);
}

void meet(const World *w, const Runner *s, int other) {
    float4 c = w->circle[other];
    float4 plan = w->motionClamp[other];
    float ux = s->px - plan.x;
    float uy = s->py - plan.y;
    if (!mayPass(ux, uy, s->r, c.z)) return;
    float dx = c.x - s->x;
    float dy = c.y - s->y;
    if (isNear(dx, dy, s->speculativeDistance + w->sight[other].z)) {
        w->near[s->slot] = least(timeOfTouch(dx, dy, ux, uy, s->r + c.z), w->near[s->slot]);
    } else if (plan.w <= s->path || !isFast(plan.w, c.z)) {
        float t = timeOfTouch(dx, dy, ux, uy, s->r + c.z);
        if (t < 1.0f) {
            // Floats from 0 to 1 sort like their bits.
            atomic_min(&w->timeOfImpact[s->slot], as_int(t));
            if (otherLooksAhead(w, other)) atomic_min(&w->timeOfImpact[other], as_int(t));
        }
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
    float half_ = 0.5f * s->r;
    for (int v = r0; v <= r1;) {
        int row = onRing(v, rows);
        int rowsOfBlock = inBlock(row, rows, r1 - v);
        for (int u = c0; u <= c1;) {
            int column = onRing(u, columns);
            int columnsOfBlock = inBlock(column, columns, c1 - u);
            float4 range = w->blockRange[(first >> (2 * BLOCK_LOG)) + (row >> BLOCK_LOG << (cl - BLOCK_LOG)) +
                                         (column >> BLOCK_LOG)];
            if (differ(s->px, s->py, range.x, range.y, range.z, range.w, half_)) {
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

void lookAhead(const World *w, int slot) {
    float4 c = w->circle[slot];
    float4 plan = w->motionClamp[slot];
    Runner s = {c.x, c.y, c.z, plan.x, plan.y, plan.w, w->sight[slot].z, slot};
    float limit = travelShare(s.path, s.r);
    float px = limit * s.px;
    float py = limit * s.py;
    for (int l = 0; l < w->levels->usedCount; l++) {
        int level = w->levels->used[l];
        float top = w->levels->top[level];
        if (!sweeps(s.r, top)) continue;
        float margin = (s.r + top) + greatest(limit * s.path, top);
        float minX = w->levels->minX;
        float minY = w->levels->minY;
        float edge = w->levels->inverseEdge[level];
        int c0 = cell(least(s.x, s.x + px) - margin, minX, edge);
        int c1 = cell(greatest(s.x, s.x + px) + margin, minX, edge);
        int r0 = cell(least(s.y, s.y + py) - margin, minY, edge);
        int r1 = cell(greatest(s.y, s.y + py) + margin, minY, edge);
        lookAt(w, &s, level, c0, min(c1, c0 + w->levels->columnCount[level] - 1), r0,
               min(r1, r0 + w->levels->rowCount[level] - 1));
    }
}

// Fast circles look for others that they would touch, no faster than themselves. Index space: a working slot a work-item.
// Cost: the cells around its path, for a fast circle.
kernel void continuousCollision_look(WORLD_PARAMETERS) {
    World w = WORLD;
    int slot = (int) get_global_id(0);
    if (slot < circles && !refused(&w) && looksAhead(&w, slot)) lookAhead(&w, slot);
}

// Sets a motion clamp: the free part of the path, and how far the circle may leave it. After all have looked ahead; stage Contacts
// does it in passing.
void setMotionClamp(const World *w, int slot) {
    float4 plan = w->motionClamp[slot];
    float r = w->circle[slot].z;
    float limit = least(travelShare(plan.w, r), w->near[slot]);
    float free = as_float(w->timeOfImpact[slot]);
    bool stopped = free < limit;
    float kept = stopped ? free : limit;
    w->motionClamp[slot] = (float4)(kept * plan.x, kept * plan.y, stopped ? 0.0f : CLAMP_ALLOWANCE * r, plan.w);
}
