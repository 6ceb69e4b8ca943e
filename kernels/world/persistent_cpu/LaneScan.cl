// uses: world/shared/PairRule.cl*4 world/persistent_cpu/LaneContacts.cl
// Tests circles against those of cells nearby, four at a time, and keeps the pairs that are near.

#define HITS 2048              // pairs of one group, or of one circle; what is closer together goes by colours
#define DEALT_TOGETHER 64      // groups
#define GATHERED (HITS + 1024) // pairs of these

// What a work-group looks for contacts with.
typedef struct {
    global const float *x, *y, *speculativeDistance; // by working slot
    ulong hit[HITS + 4];               // of the group, or of the circle: slot above slot
    ulong ids[GATHERED], slots[GATHERED]; // of groups that are dealt together, by group and in order; lower id's first
    int gathered;
    int start[DEALT_TOGETHER + 1];
    int groups;
    int wide, endWide; // where the next wide contact goes, and where there is no more room
    int owner;         // the work-group; see LaneCross.cl
    int nodes;         // see LaneCross.cl
    int contacts;
    bool crowded;
#ifdef RECORDING
    int met; // see TOUCHES_MET
#endif
} Search;

// Where circles are noted for the search, component by component: arrays that stage Grid is done with.
global float *searchX(const World *w) { return (global float *) w->bucketBefore; }
global float *searchY(const World *w) { return (global float *) w->rank; }
global float *searchSpeculativeDistance(const World *w) { return (global float *) w->bucketOf; }

// Tests a circle against slots [from, to), four at a time, also where there are none: that costs less than to guess wrong
// whether there are. Returns how many pairs of the group there are then.
INLINE int scanSlots(const World *w, Search *f, int hits, int slot, int from, int to) {
    if (hits + (to - from) > HITS) {
        f->crowded = true;
        return hits;
    }
    float x = f->x[slot];
    float y = f->y[slot];
    float speculativeDistance = f->speculativeDistance[slot];
    ulong high = (ulong) slot << 32;
    int other = from;
    do {
        float4 dx = ACROSS_X4(w, vload4(0, f->x + other) - x);
        float4 dy = ACROSS_Y4(w, vload4(0, f->y + other) - y);
        float4 limit = speculativeDistance + vload4(0, f->speculativeDistance + other);
        int4 hit = isNear4(dx, dy, limit) & ((int4)(0, 1, 2, 3) < (int4)(to - other));
        // Whether a pair is near is as good as random: no branch.
        f->hit[hits] = high | other;
        hits -= hit.x;
        f->hit[hits] = high | (other + 1);
        hits -= hit.y;
        f->hit[hits] = high | (other + 2);
        hits -= hit.z;
        f->hit[hits] = high | (other + 3);
        hits -= hit.w;
        other += 4;
    } while (other < to);
    return hits;
}

// Tests a circle against those of the columns next to one, of some row of its level or a coarser one; returns how many it has hit so far.
// left, right: whether it may be near any of the column on that side.
INLINE int scanRow(const World *w, Search *f, int hits, int slot, int l, int row, int column, bool left, bool right) {
    int columns = w->levels->columnCount[l];
    global const int *start = w->bucketStart + w->levels->first[l] + (row << w->levels->columnsLog[l]);
    if (column > 0 && column < columns - 1) return scanSlots(w, f, hits, slot, start[column - left], start[column + 1 + right]);
    for (int u = -1; u <= 1; u++) {
        int beside = neighbour(column, u, columns);
        hits = scanSlots(w, f, hits, slot, start[beside], start[beside + 1]);
    }
    return hits;
}

// Whether a circle may be near any of the cells before its own, and of those behind it, along an axis: the speculative distance of a
// circle of that level is half a cell at most. place: the circle's, in cells; own: its speculative distance in cells.
typedef struct {
    bool before, behind, isNearer; // behind than before
} Sides;

INLINE Sides sidesOf(float place, int cell_, float own) {
    Sides s = {true, true, true};
#ifndef EDGES
    float share = place - (float) cell_;
    float most = (0.501f + own) + 0x1p-20f * place; // some more than half: places are rounded
    s.before = (share < most) | (share >= 1.0f);    // there are no more cells than an int can count
    s.behind = 1.0f - share < most;
    s.isNearer = share >= 0.5f;
#endif
    return s;
}

// Tests a circle against those of 3 x 3 cells of its level or a coarser one, as far as it may be near them. In its own it hits itself.
INLINE int scanAround(const World *w, Search *f, int hits, int slot, int l) {
    float x = f->x[slot], y = f->y[slot];
    float inverseEdge = w->levels->inverseEdge[l];
    float own = f->speculativeDistance[slot] * inverseEdge;
    int rows = w->levels->rowCount[l];
    int column = columnOf(w, l, x);
    int row = rowOf(w, l, y);
    Sides h = sidesOf((x - w->levels->minX) * inverseEdge, cell(x, w->levels->minX, inverseEdge), own);
    Sides v = sidesOf((y - w->levels->minY) * inverseEdge, cell(y, w->levels->minY, inverseEdge), own);
    int nearer = v.isNearer ? 1 : -1;
    hits = scanRow(w, f, hits, slot, l, row, column, h.before, h.behind);
    hits = scanRow(w, f, hits, slot, l, neighbour(row, nearer, rows), column, h.before, h.behind);
    if (v.before && v.behind) hits = scanRow(w, f, hits, slot, l, neighbour(row, -nearer, rows), column, h.before, h.behind);
    return hits;
}
