// uses: world/stages/PairFilter.cl world/persistent_cpu/LaneMover.cl world/persistent_cpu/LaneScan.cl
// Crowds by lanes: which pairs a step that thins them out keeps. Circles count their candidates before any pair is listed.

// How many candidates a circle has, in an array that is free once stops are known.
global int *candidatesOf(const World *w) { return w->carrier; }

// Counts the candidates of circles of one level, number k of those used: the circles of it and of coarser ones that they may meet.
void countCandidates(const World *shared, Search *f, Cells cells, int k) {
    World own = *shared;
    const World *w = &own;
    for (int slot = cells.from; slot < cells.to && !f->crowded; slot++) {
        int hits = 0;
        for (int c = k; c < w->levels->usedCount; c++) hits = scanAround(w, f, hits, slot, w->levels->used[c]);
        float inverseMass = w->traits[slot].x;
        int count = 0;
        for (int hit = 0; hit < hits; hit++) {
            int other = (int) f->hit[hit];
            count += other != slot && mayMeet(w, slot, inverseMass, other, w->traits[other].x);
        }
        candidatesOf(w)[slot] = count;
        if (count > CROWD) w->status[CROWDED] = 1;
    }
}

// Whether the step keeps a pair.
INLINE bool keepsPairByLanes(const World *w, int slot, int other) {
    if (!w->k.thinning) return true;
    int fewer = min(candidatesOf(w)[slot], candidatesOf(w)[other]);
    if (fewer <= CROWD) return true;
    int id = w->id[slot];
    int otherId = w->id[other];
    return keeps(pairHash(min(id, otherId), max(id, otherId)), fewer);
}
