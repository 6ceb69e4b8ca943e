// uses: world/persistent_cpu/LaneFinding.cl world/persistent_cpu/LaneCross.cl
// Finds the cross contacts. A circle looks in 3 x 3 cells of each coarser level, as far as they matter. If it is of the finest level and
// the light one of a pair, the pair goes to the light circle's group at once. All other pairs are noted with their light circles, which
// may be those of other work-groups, and are dealt once all work-groups have looked.

// A pair in a list of those of its light circle: the next node, the slot of the heavy circle. Nodes lie where keys of contacts would, from
// the end of a work-group's region on, and need no more room than the contacts that they become.
void notePair(const World *w, Search *f, uint light, uint heavy) {
    if ((f->nodes & 3) == 0) f->endWide--;
    int node = 4 * f->endWide + (f->nodes & 3);
    f->nodes++;
    if (f->endWide < f->wide) return; // out of room
    uint next = (uint) atomic_xchg(nodesOf(w, light), node);
    w->key[node] = (ulong) next << 32 | heavy;
}

// Tests a circle against those of the columns next to one, of some row of a coarser level; returns how many it has hit so far. left, right:
// whether it may be near any of the column on that side.
INLINE int scanCoarserRow(const World *w, Search *f, int hits, int slot, int l, int row, int column, bool left, bool right) {
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
// coarser circle is half a cell at most. place: the circle's, in cells; own: its speculative distance in cells.
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

// Tests a circle against those of 3 x 3 cells of a coarser level, as far as it may be near them.
INLINE int scanCoarser(const World *w, Search *f, int hits, int slot, int l) {
    float x = f->x[slot], y = f->y[slot];
    float inverseEdge = w->levels->inverseEdge[l];
    float own = f->speculativeDistance[slot] * inverseEdge;
    int rows = w->levels->rowCount[l];
    int column = columnOf(w, l, x);
    int row = rowOf(w, l, y);
    Sides h = sidesOf((x - w->levels->minX) * inverseEdge, cell(x, w->levels->minX, inverseEdge), own);
    Sides v = sidesOf((y - w->levels->minY) * inverseEdge, cell(y, w->levels->minY, inverseEdge), own);
    int nearer = v.isNearer ? 1 : -1;
    hits = scanCoarserRow(w, f, hits, slot, l, row, column, h.before, h.behind);
    hits = scanCoarserRow(w, f, hits, slot, l, neighbour(row, nearer, rows), column, h.before, h.behind);
    if (v.before && v.behind) hits = scanCoarserRow(w, f, hits, slot, l, neighbour(row, -nearer, rows), column, h.before, h.behind);
    return hits;
}

// Keeps those that a circle has hit and is a light circle for, if it is of the finest level; notes the others. Returns how many it keeps.
INLINE int sortHits(const World *w, Search *f, int slot, int hits, bool finest) {
    int kept = 0;
    int found = 0;
    float own = w->traits[slot].x;
    for (int k = 0; k < hits; k++) {
        uint other = (uint) f->hit[k];
        float others = w->traits[other].x;
        if (!mayMeet(w, slot, own, (int) other, others)) continue;
        found++;
        bool isLight = isFinerLight(own, others);
        if (isLight && finest) {
            f->hit[kept++] = f->hit[k];
        } else {
            notePair(w, f, isLight ? (uint) slot : other, isLight ? other : (uint) slot);
        }
    }
    w->coarser[slot] = found;
    return kept;
}

// Finds the cross contacts of the circles of a level with coarser ones, number k and up of those used.
void findCross(const World *shared, Search *f, Cells cells, int k) {
    World own = *shared;
    const World *w = &own;
    for (int slot = cells.from; slot < cells.to; slot++) {
        int hits = 0;
        for (int c = k; c < w->levels->usedCount; c++) hits = scanCoarser(w, f, hits, slot, w->levels->used[c]);
        if (hits == 0) continue;
        gatherHits(w, f, sortHits(w, f, slot, hits, k == 1), false, true);
        if (hasToDeal(f)) dealAs(w, f, true);
    }
    dealAs(w, f, true);
}

// Deals the pairs that were noted with the light circles of a level.
void dealNoted(const World *shared, Search *f, Cells cells) {
    World own = *shared;
    const World *w = &own;
    for (int slot = cells.from; slot < cells.to; slot++) {
        int node = *nodesOf(w, slot);
        if (node == NONE) continue;
        int hits = 0;
        for (; node != NONE && hits < HITS; hits++) {
            ulong pair = w->key[node];
            f->hit[hits] = (ulong) slot << 32 | (uint) pair;
            node = (int) (pair >> 32);
        }
        if (node != NONE) f->crowded = true;
        gatherHits(w, f, hits, false, true);
        if (hasToDeal(f)) dealAs(w, f, true);
    }
    dealAs(w, f, true);
}
