// uses: world/shared/PairRule.cl world/shared/Drive.cl world/stages/Carrying.cl world/stages/Grid.cl
// uses: world/stages/PairFilter.cl world/stages/ReachGrid.cl world/stages/CellScan.cl
// Stage ContinuousCollision keeps fast circles from passing through others. The Java class of this name explains it, function by function.
// Steps without fast circles leave it out: Grid has set their motion clamps.

// BLOCK_LOG is 2: blocks have 4 x 4 cells, as many rows as a SlotRange joins.

// Circles at which a fast one stops; when a static one takes it along; which one.
typedef enum { STOPS, CARRY_TIMES, CARRIERS } Look;

// least: by how much it must move against another to matter.
typedef struct {
    float x, y, r, px, py, path, speculativeDistance, least;
    int slot;
    bool isStatic;
} Runner;

Runner runnerOf(const World *w, int slot) {
    float4 c = w->circle[slot];
    float4 plan = w->motionClamp[slot];
    float4 sight = w->sight[slot];
    bool isStatic = sight.SIGHT_INVERSE_MASS == 0.0f;
    Runner s = {c.x, c.y, c.RADIUS, plan.PATH_X, plan.PATH_Y, plan.PATH_LENGTH, sight.SIGHT_DISTANCE,
                CAP * (isStatic ? leastRadius(w) : c.RADIUS), slot, isStatic};
    return s;
}

// Of circles that are not static. Floats from 0 on sort like their bits.
void noteLongestPath(const World *w, const SlotRange *slots) {
    float longest = 0.0f;
    for (int i = 0; i < slots->end.w; i++) {
        int slot = slotInRange(slots, i);
        if (w->sight[slot].SIGHT_INVERSE_MASS != 0.0f) longest = maxf(w->motionClamp[slot].PATH_LENGTH, longest);
    }
    if (longest > 0.0f) atomic_max(&w->status[LONGEST_PATH], as_int(longest));
}

// The range of the paths in a block of cells.
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
    SlotRange slots = joinedRanges((int4)(from[0], from[1 << cl], from[2 << cl], from[3 << cl]),
                                   (int4)(to[0], to[1 << cl], to[2 << cl], to[3 << cl]));
    for (int i = 0; i < slots.end.w; i++) {
        float2 path = w->motionClamp[slotInRange(&slots, i)].PATH;
        range.MIN_PATH_X = minf(path.x, range.MIN_PATH_X);
        range.MAX_PATH_X = maxf(path.x, range.MAX_PATH_X);
        range.MIN_PATH_Y = minf(path.y, range.MIN_PATH_Y);
        range.MAX_PATH_Y = maxf(path.y, range.MAX_PATH_Y);
    }
    w->blockRange[block] = range;
    if (w->status[CARRYING]) noteLongestPath(w, &slots);
}

// Fewer than circles.
int blocksOfCells(const World *w) { return w->levels->first[LEVELS] >> (2 * BLOCK_LOG); }

// Whether it is fast.
bool looksAhead(const World *w, int slot) { return w->near[slot].CONTACT_SHARE < NOT_FAST; }
bool looksForStops(const World *w, int slot) { return looksAhead(w, slot) && w->sight[slot].SIGHT_INVERSE_MASS != 0.0f; }

// Index space: slots.
kernel void continuousCollision_prepare(WORLD_PARAMETERS) {
    World w = WORLD;
    local int classes;
    int i = (int) get_global_id(0);
    if (get_local_id(0) == 0) classes = 0;
    barrier(CLK_LOCAL_MEM_FENCE);
    if (i < circles && !refused(&w)) {
        int own = noteReach(&w, i, looksForStops(&w, i));
        if (own != 0) atomic_or(&classes, own);
        if (i < blocksOfCells(&w)) summarize(&w, i);
    }
    barrier(CLK_LOCAL_MEM_FENCE);
    if (get_local_id(0) == 0) noteClasses(&w, classes);
}

// Work-items change these at once, as bits.
volatile global int *contactTimeOf(const World *w, int slot) { return (volatile global int *) (w->near + slot); }
volatile global int *restraintOf(const World *w, int slot) { return contactTimeOf(w, slot) + 1; }

void restrain(const World *w, int slot, float most, bool stands) {
    volatile global int *allowance = restraintOf(w, slot);
    int seen = atomic_or(allowance, 0);
    for (;;) {
        float before = as_float(seen);
        float least_ = minf(most, fabs(before));
        int next = as_int(stands || before < 0.0f ? -least_ : least_);
        if (next == seen) return;
        int found = atomic_cmpxchg(allowance, seen, next);
        if (found == seen) return;
        seen = found;
    }
}

void shorten(const World *w, int slot, float t) { atomic_min(&w->timeOfImpact[slot], as_int(t)); }

// Whether a circle is static to steps: its mass is infinite, or it sleeps.
bool standsAt(const World *w, int slot, float mass) {
#ifdef SLEEPING
    return w->sight[slot].SIGHT_INVERSE_MASS == 0.0f;
#else
    return mass == INFINITY; // spares a read
#endif
}

void meet(const World *w, const Runner *s, int other) {
    float4 c = w->circle[other];
    float4 plan = w->motionClamp[other];
    float ux = s->px - plan.PATH_X;
    float uy = s->py - plan.PATH_Y;
    if (!isLonger(ux, uy, s->least)) return;
    bool stands = standsAt(w, other, c.MASS);
    if (!mayMeet(w, s->slot, 1.0f, other, stands ? 0.0f : 1.0f)) return;
    if (!stands && !sweeps(s->r, c.RADIUS)) return;
    float dx = ACROSS_X(w, c.x - s->x);
    float dy = ACROSS_Y(w, c.y - s->y);
    if (stands && isNear(dx, dy, s->r + s->path, c.RADIUS)) {
        restrain(w, s->slot, CLAMP_ALLOWANCE * s->r, false);
    }
    // First what most pairs fail.
    float graze = deepestGraze(s->r, c.RADIUS);
    float t = timeOfImpactBeyond(dx, dy, ux, uy, s->r + c.RADIUS, graze);
    if (!(t < 1.0f) || (stands && isFast(plan.PATH_LENGTH, s->r))) return;
    bool near = isNear(dx, dy, s->speculativeDistance, w->sight[other].SIGHT_DISTANCE);
    if (near && !isLonger(ux, uy, (0.5f * CAP) * (s->r + c.RADIUS))) return;
    float lost = 1.0f - maxf(w->traits[s->slot].RESTITUTION, w->traits[other].RESTITUTION);
    bool dull = isLonger(lost * ux, lost * uy, DULL * s->r);
    if (!stands && dull && isLonger(ux, uy, s->r) && !isFast(plan.PATH_LENGTH, c.RADIUS)) {
        t = beforeSlow(t, dx, dy, s->px, s->py, plan.PATH_X, plan.PATH_Y, (s->r + c.RADIUS) + graze);
    }
    float slack = stands ? MARGIN : HOLD;
    if (near && isNear(dx, dy, s->r + slack * s->r, c.RADIUS + slack * c.RADIUS)) {
        atomic_min(contactTimeOf(w, s->slot), as_int(t));
        restrain(w, s->slot, holdAllowance(s->r, s->path, c.RADIUS, stands, dull), stands);
    } else if (stands) {
        if (plan.PATH_LENGTH == 0.0f) shorten(w, s->slot, t);
    } else if (plan.PATH_LENGTH <= s->path || !isFast(plan.PATH_LENGTH, c.RADIUS)) {
        shorten(w, s->slot, t);
        if (isFast(plan.PATH_LENGTH, c.RADIUS)) shorten(w, other, t);
    }
}

bool mayTouchBy(const World *w, const Runner *s, float4 other, float4 plan) {
    return mayTouch(ACROSS_X(w, other.x - s->x), ACROSS_Y(w, other.y - s->y), s->px - plan.PATH_X, s->py - plan.PATH_Y,
                    s->r + other.RADIUS);
}

// Most do not touch by their paths.
void meetIfNear(const World *w, const Runner *s, int other) {
    float4 c = w->circle[other];
    if (mayTouchBy(w, s, c, w->motionClamp[other]) || standsAt(w, other, c.MASS)) meet(w, s, other);
}

// If the other one reaches far: either way round.
void meetBoth(const World *w, const Runner *s, bool looks, int other) {
    float4 c = w->circle[other];
    bool touches = mayTouchBy(w, s, c, w->motionClamp[other]);
    if (looks && (touches || standsAt(w, other, c.MASS))) meet(w, s, other);
    if (touches || s->isStatic) {
        Runner o = runnerOf(w, other);
        meet(w, &o, s->slot);
    }
}

void meetNear(const World *w, const Runner *s, float reach, int from, int to) {
    for (int other = from; other < to; other++) {
        float4 o = w->reach[other];
        if (isNear(ACROSS_X(w, o.x - s->x), ACROSS_Y(w, o.y - s->y), reach, o.REACH) && other != s->slot) meetIfNear(w, s, other);
    }
}

// Its faster circle finds a pair, or both do.
void meetCarrier(const World *w, const Runner *s, int other, bool note) {
    float4 c = w->circle[other];
    float4 plan = w->motionClamp[other];
    bool isStatic = standsAt(w, other, c.MASS);
    if (!mayMeet(w, s->slot, s->isStatic ? 0.0f : 1.0f, other, isStatic ? 0.0f : 1.0f)) return;
    if (s->isStatic) {
        if (plan.PATH_LENGTH <= s->path + CAP * c.RADIUS) meetCarried(w, s->slot, other, note);
    } else if (isStatic && plan.PATH_LENGTH > 0.0f && isLonger(s->px - plan.PATH_X, s->py - plan.PATH_Y, s->least)) {
        meetCarried(w, other, s->slot, note);
    }
}

void meetCarriers(const World *w, const Runner *s, int from, int to, bool note) {
    for (int other = from; other < to; other++) {
        if (other != s->slot) meetCarrier(w, s, other, note);
    }
}

// From one on, in its block and on the ring.
int inBlock(int column, int side, int most) {
    int blockEnd = (column | ((1 << BLOCK_LOG) - 1)) + 1;
    return min(min(blockEnd, side) - column, most);
}

// In one block, or up to the seam.
void lookAtCells(const World *w, const Runner *s, float reach, const CellRange *r, int row, int column, int columns, int overX, int overY,
                 Look look) {
    for (int u = 0; u < columns;) {
        int many = columns - u;
        int2 slots = slotsInCells(w, r, row, column + u, &many, overX, overY, true);
        u += many;
        if (look == STOPS) {
            meetNear(w, s, reach, slots.x, slots.y);
        } else {
            meetCarriers(w, s, slots.x, slots.y, look == CARRIERS);
        }
    }
}

// Block by block.
void lookAt(const World *w, const Runner *s, float reach, const CellRange *range, Look look) {
    int level = range->level;
    int cl = w->levels->columnsLog[level];
    int columns = w->levels->columnCount[level];
    int rows = w->levels->rowCount[level];
    int first = w->levels->first[level];
    for (int v = range->row; v < range->endRow;) {
        int row = onRing(v, rows);
        int rowsOfBlock = inBlock(row, rows, range->endRow - v);
        for (int u = range->column; u < range->endColumn;) {
            int column = onRing(u, columns);
            int columnsOfBlock = inBlock(column, columns, range->endColumn - u);
            float4 paths = w->blockRange[(first >> (2 * BLOCK_LOG)) + (row >> BLOCK_LOG << (cl - BLOCK_LOG)) +
                                         (column >> BLOCK_LOG)];
            if (s->isStatic || differ(s->px, s->py, paths.MIN_PATH_X, paths.MAX_PATH_X, paths.MIN_PATH_Y, paths.MAX_PATH_Y, s->least)) {
                int overX = onRing(range->column, columns) + (u - range->column) >= columns ? 1 : 0;
                int overY = onRing(range->row, rows) + (v - range->row) >= rows ? 1 : 0;
                for (int r = row; r < row + rowsOfBlock; r++) {
                    lookAtCells(w, s, reach, range, r, column, columnsOfBlock, overX, overY, look);
                }
            }
            u += columnsOfBlock;
        }
        v += rowsOfBlock;
    }
}

// Row by row if there are several levels: few circles of a block move alike there.
INLINE void lookInLevel(const World *w, const Runner *s, float reach, int level) {
    float margin = sightMargin(s->r, s->path, w->levels->top[level]);
    CellRange range = cellsAround(w, level, minf(s->x, s->x + s->px) - margin, maxf(s->x, s->x + s->px) + margin,
                                  minf(s->y, s->y + s->py) - margin, maxf(s->y, s->y + s->py) + margin);
    if (hasOneLevel(w)) {
        lookAt(w, s, reach, &range, STOPS);
        return;
    }
    CellCursor at = firstCells(&range);
    int2 slots;
    while (nextCells(w, &range, &at, true, &slots)) meetNear(w, s, reach, slots.x, slots.y);
}

// Those of slots behind one.
void meetInBucket(const World *w, const Runner *s, float reach, bool looks, int after, int bucket) {
    for (int other = lastReached(w)[bucket]; other != NONE; other = w->reachedBefore[other]) {
        float4 o = w->reach[other];
        if (other <= after || other == s->slot) continue;
        if (isNear(ACROSS_X(w, o.x - s->x), ACROSS_Y(w, o.y - s->y), reach, o.REACH)) meetBoth(w, s, looks, other);
    }
}

// Those that reach far in a circle's level, and no less far than it. Of two that would find each other, the one of the lower slot does.
void lookForReaching(const World *w, const Runner *s, float reach, bool looks) {
    int top = topExponent(w->levels->rmax);
    int buckets = reachBuckets(w->circles);
    // One that reaches far itself looks for all of them.
    bool isHere = looks && reach > farIn(w, w->levels->used[0]);
    float far = isHere ? 0.0f : farIn(w, levelOf(w, s->r));
    int own = reachClassOf(reach, top);
#pragma unroll 1
    for (int j = own; j >= 0; j--) {
        if ((w->status[REACHES] >> j & 1) == 0 || !(topReach(j, top) > far)) continue;
        float around = 1.001f * (reach + topReach(j, top)); // no rounding hides a circle at the edge
        int after = isHere && j == own ? s->slot : NONE;
#pragma unroll 1
        for (int image = 0; image < IMAGES; image++) {
            ReachCells cells = reachCellsAround(w, image, s->x, s->y, around, inverseReachEdge(j, top));
#pragma unroll 1
            for (int row = cells.row; row < cells.endRow; row++) {
                for (int column = cells.column; column < cells.endColumn; column++) {
                    meetInBucket(w, s, reach, looks, after, reachBucket(column, row, j, buckets));
                }
            }
        }
    }
}

// A fast circle looks for others in levels in which it does not reach far, and every circle for those that reach far.
int partsOfLook(const World *w) { return w->levels->usedCount + 1; }

bool hasPartOfLook(const World *w, int slot, int part) {
    if (part == w->levels->usedCount) return w->status[REACHES] != 0;
    float4 own = w->reach[slot]; // others may be changing what looksForStops reads
    return own.LOOKS != 0.0f && !(own.REACH > farIn(w, w->levels->used[part]));
}

INLINE void lookForStops(const World *w, const Runner *s, int part) {
    float reach = w->reach[s->slot].REACH;
    if (part == w->levels->usedCount) {
        lookForReaching(w, s, reach, w->reach[s->slot].LOOKS != 0.0f);
    } else {
        lookInLevel(w, s, reach, w->levels->used[part]);
    }
}

// Numbered part after part.
int partsOfAllLooks(const World *w) { return partsOfLook(w) * w->circles; }

void makePartOfLook(const World *w, int number) {
    int part = number / w->circles;
    int slot = number - part * w->circles;
    if (!hasPartOfLook(w, slot, part)) return;
    Runner s = runnerOf(w, slot);
    lookForStops(w, &s, part);
}

void lookForCarriers(const World *w, int slot, Look look) {
    Runner s = runnerOf(w, slot);
    for (int l = 0; l < w->levels->usedCount; l++) {
        int level = w->levels->used[l];
        float top = w->levels->top[level];
        float path = s.isStatic ? carriedPath(s.path, as_float(w->status[LONGEST_PATH]), top) : s.path;
        float margin = sightMargin(s.r, path, top);
        float minY = w->levels->minY;
        float edge = w->levels->inverseEdge[level];
        int rows = w->levels->rowCount[level];
        float below = minf(s.y, s.y + s.py) - margin;
        int r0 = firstOf(axisY(w, level), below);
        int r1 = lastOf(axisY(w, level), below, maxf(s.y, s.y + s.py) + margin);
        // A static circle may cross the arena: piece by piece, unless its rows meet again on the ring.
        bool byPieces = s.isStatic && isWalled(axisY(w, level)) && r1 - r0 < rows;
        int rowsAtOnce = byPieces ? 1 << BLOCK_LOG : rows;
        for (int v = r0; v <= min(r1, r0 + rows - 1); v += rowsAtOnce) {
            int end = min(v + rowsAtOnce, byPieces ? r1 + 1 : r0 + rows);
            float low = byPieces ? minY + (float) v / edge - margin : -INFINITY;
            float high = byPieces ? minY + (float) end / edge + margin : INFINITY;
            float left = leastBetween(s.x, s.px, s.y, s.py, low, high) - margin;
            float right = greatestBetween(s.x, s.px, s.y, s.py, low, high) + margin;
            CellRange range = cellsAround(w, level, left, right, below, maxf(s.y, s.y + s.py) + margin);
            range.row = v;
            range.endRow = min(end, r1 + 1);
            if (byPieces) range.sheets.y = v / rows;
            lookAt(w, &s, 0.0f, &range, look);
        }
    }
}

// Index space: a slot and a part of its look, part after part, faster than all levels by one. Cost: the cells around it.
kernel void continuousCollision_look(WORLD_PARAMETERS) {
    World w = WORLD;
    int number = (int) get_global_id(0);
    if (number < partsOfAllLooks(&w) && !refused(&w)) makePartOfLook(&w, number);
}

// note: see meetCarried. Index space: any; few work-items take slots in turn, since they are quick to say that no static circle moves. Cost:
// the cells around a path.
kernel void continuousCollision_carry(WORLD_PARAMETERS, int note) {
    World w = WORLD;
    if (!status[CARRYING] || refused(&w)) return;
    for (int slot = (int) get_global_id(0); slot < circles; slot += (int) get_global_size(0)) {
        if (looksAhead(&w, slot)) lookForCarriers(&w, slot, note ? CARRIERS : CARRY_TIMES);
    }
}

// A circle that stops loses time, and so what gravity would give it then. After all have looked.
void setMotionClamp(const World *w, int slot) {
    // Grid has set the clamps of most.
    if (freeShare(w, slot) >= 1.0f && carryTime(w, slot) > 1.0f) return;
    float4 sight = w->sight[slot];
    if (sight.SIGHT_INVERSE_MASS == 0.0f) return;
    const StepConstants *k = &w->k;
    float4 plan = w->motionClamp[slot];
    float r = w->circle[slot].RADIUS;
    float free = as_float(w->timeOfImpact[slot]);
    float2 near = w->near[slot];
    float limit = minf(near.CONTACT_SHARE, 1.0f);
    float allowance = limit < 1.0f ? near.CONTACT_ALLOWANCE : plan.ALLOWANCE;
    float2 path = plan.PATH;
    int carrier = w->carrier[slot];
    float own = minf(freeShare(w, slot), carryTime(w, slot));
    bool stops = free < limit || carryTime(w, slot) < 1.0f;
    if (carrier != NOBODY || stops) {
        path = (float2)(own * path.x, own * path.y);
        allowance = 0.0f;
        if (carrier != NOBODY) {
            float4 carried = w->motionClamp[carrier];
            float rest = 1.0f - carryTime(w, slot);
            path = (float2)(path.x + rest * carried.PATH_X, path.y + rest * carried.PATH_Y);
            allowance = isFast(carried.PATH_LENGTH, r) ? CARRIED : 0.0f;
        }
    } else if (allowance >= 0.0f) {
        path = (float2)(limit * path.x, limit * path.y);
    }
    if (stops) {
        w->sight[slot].SIGHT_DISTANCE = speculativeDistance(r, 0.0f);
        float2 gain = gainOf(w, w->id[slot], sight.SIGHT_INVERSE_MASS);
        w->motion[slot].VX -= (1.0f - own) * (gain.x * k->subSteps);
        w->motion[slot].VY -= (1.0f - own) * (gain.y * k->subSteps);
    }
    w->motionClamp[slot] = (float4)(path.x, path.y, allowance, limit);
}

// Index space: slots.
kernel void continuousCollision_clamp(WORLD_PARAMETERS) {
    World w = WORLD;
    int slot = (int) get_global_id(0);
    if (slot < circles && !refused(&w)) setMotionClamp(&w, slot);
}
