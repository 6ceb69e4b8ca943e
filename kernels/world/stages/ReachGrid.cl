// uses: world/shared/Reach.cl world/shared/PairRule.cl world/stages/World.cl
// Fast circles that reach far, by their reach. The Java class world.jvm.grid.ReachGrid explains it. Grid empties the buckets.

// More of a level's cells are far. It changes the time alone.
#define FAR_CELLS 3.0f

// By bucket: the slot that came last, or NONE.
volatile global int *lastReached(const World *w) { return (volatile global int *) w->lastReached; }

// From there on circles of a level look for it, and it does not look for them.
float farIn(const World *w, int level) { return FAR_CELLS / w->levels->inverseEdge[level]; }

// Returns the bit of its class.
int addReach(const World *w, int slot, float4 c, float reach) {
    int top = topExponent(w->levels->rmax);
    int k = reachClassOf(reach, top);
    float inverseEdge = inverseReachEdge(k, top);
    int bucket = reachBucket(reachCell(c.x, w->levels->minX, inverseEdge), reachCell(c.y, w->levels->minY, inverseEdge), k,
                             reachBuckets(w->circles));
    w->reachedBefore[slot] = atomic_xchg(&lastReached(w)[bucket], slot);
    return 1 << k;
}

// looks: is fast and not static. Returns the bit of its class if it is in the grid, else 0.
int noteReach(const World *w, int slot, bool looks) {
    float4 c = w->circle[slot];
    float reach = reachOf(c.RADIUS, w->motionClamp[slot].PATH_LENGTH, w->sight[slot].SIGHT_INVERSE_MASS == 0.0f);
    w->reach[slot] = (float4)(c.x, c.y, reach, looks ? 1.0f : 0.0f);
    return looks && reach > farIn(w, w->levels->used[0]) ? addReach(w, slot, c, reach) : 0;
}

void noteClasses(const World *w, int classes) {
    if (classes != 0) atomic_or(&w->status[REACHES], classes);
}

typedef struct {
    int column, row, endColumn, endRow;
} ReachCells;

ReachCells reachCellsIn(const World *w, float left, float right, float low, float high, float inverseEdge) {
    ReachCells cells;
    cells.column = reachCell(left, w->levels->minX, inverseEdge);
    cells.row = reachCell(low, w->levels->minY, inverseEdge);
    cells.endColumn = reachCell(right, w->levels->minX, inverseEdge) + 1;
    cells.endRow = reachCell(high, w->levels->minY, inverseEdge) + 1;
    return cells;
}

#ifdef EDGES
#define IMAGES 9

// How much coordinates may be off along an axis that wraps.
float roundingAlong(float min_, float period) { return period < INFINITY ? 0x1p-20f * (fabs(min_) + period) : 0.0f; }

// Around each image: one on each side along an axis that wraps, or none if they would show the same circles again.
ReachCells reachCellsAround(const World *w, int image, float x, float y, float far, float inverseEdge) {
    constant Levels *l = w->levels;
    int u = (image + 1) % 3 - 1;
    int v = image / 3 == 2 ? -1 : image / 3;
    float farX = far + roundingAlong(l->minX, l->periodX);
    float farY = far + roundingAlong(l->minY, l->periodY);
    float atX = u == 0 ? x : x + (float) u * l->periodX;
    float atY = v == 0 ? y : y + (float) v * l->periodY;
    float maxX = l->minX + l->periodX;
    float maxY = l->minY + l->periodY;
    bool allX = 2.0f * farX >= l->periodX;
    bool allY = 2.0f * farY >= l->periodY;
    bool isNeeded = (u == 0 || !(allX || atX + farX < l->minX || atX - farX >= maxX)) &&
                    (v == 0 || !(allY || atY + farY < l->minY || atY - farY >= maxY));
    ReachCells none = {0, 0, 0, 0};
    return isNeeded ? reachCellsIn(w, allX ? l->minX : atX - farX, allX ? maxX : atX + farX, allY ? l->minY : atY - farY,
                                   allY ? maxY : atY + farY, inverseEdge)
                    : none;
}
#else
#define IMAGES 1
#define reachCellsAround(w, image, x, y, far, inverseEdge) reachCellsIn(w, (x) - (far), (x) + (far), (y) - (far), (y) + (far), inverseEdge)
#endif
