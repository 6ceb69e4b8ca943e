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

// Keeps those that a circle has hit and is a light circle for, if it is of the finest level; notes the others. Returns how many it keeps.
INLINE int sortHits(const World *w, Search *f, int slot, int hits, bool finest) {
    int kept = 0;
    int found = 0;
    float own = w->traits[slot].x;
    for (int k = 0; k < hits; k++) {
        uint other = (uint) f->hit[k];
        float others = w->traits[other].x;
        if (!mayMeet(w, slot, own, (int) other, others) || !keepsPairByLanes(w, slot, (int) other)) continue;
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
        for (int c = k; c < w->levels->usedCount; c++) hits = scanAround(w, f, hits, slot, w->levels->used[c]);
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
