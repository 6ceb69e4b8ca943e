// uses: world/stages/ContinuousCollision.cl world/persistent_cpu/LaneGrid.cl
// Stage ContinuousCollision by a few work-groups that meet. Fast circles look at four others at a time.

// Work-groups take so many slots in turn. Fast circles lie side by side, among the small ones, so equal parts would take unlike times.
#define PIECE 64

// Where reaches are noted, in place of speculative distances, until all have looked.
global float *searchReach(const World *w) { return searchSpeculativeDistance(w); }

// Looks at those slots of [from, to) whose reaches meet that of a circle.
INLINE void meetNearByLanes(const World *w, const Runner *s, float reach, int from, int to) {
    for (int other = from; other < to; other += 4) {
        float4 dx = ACROSS_X4(w, vload4(0, searchX(w) + other) - s->x);
        float4 dy = ACROSS_Y4(w, vload4(0, searchY(w) + other) - s->y);
        float4 limit = reach + vload4(0, searchReach(w) + other);
        int4 hit = isNear4(dx, dy, limit) & ((int4)(0, 1, 2, 3) < (int4)(to - other));
        if (!someLane(hit)) continue;
        int hits[4] = {hit.x, hit.y, hit.z, hit.w};
        for (int l = 0; l < 4; l++) {
            if (hits[l] && other + l != s->slot) meetIfNear(w, s, other + l);
        }
    }
}

// As lookAtRows.
void lookAtRowsByLanes(const World *w, const Runner *s, float reach, int level, int c0, int c1, int r0, int r1) {
    int columns = w->levels->columnCount[level];
    int rows = w->levels->rowCount[level];
    int column = onRing(c0, columns);
    int beyond = column + (c1 - c0 + 1) - columns; // columns on the other side of the edge of the torus
    for (int v = r0; v <= r1; v++) {
        int row = onRing(v, rows) << w->levels->columnsLog[level];
        global const int *start = w->bucketStart + w->levels->first[level] + row;
        meetNearByLanes(w, s, reach, start[column], start[beyond > 0 ? columns : columns + beyond]);
        if (beyond > 0) meetNearByLanes(w, s, reach, start[0], start[beyond]);
    }
}

// Stops of the fast circles among some.
void lookForStopsOf(const World *shared, int from, int to) {
    World own = *shared;
    for (int slot = from; slot < to; slot++) {
        if (own.status[REACHES] == 0 && own.reach[slot].w == 0.0f) continue;
        Runner s = runnerOf(&own, slot);
        for (int part = 0; part < partsOfLook(&own); part++) {
            if (hasPartOfLook(&own, slot, part)) lookForStops(&own, &s, part, true);
        }
    }
}

// Makes the stage, where some circle is fast.
void sweepCircles(World *w, const Crew *crew) {
    w->k.sweeping = w->status[FAST];
    if (!w->k.sweeping) return;
    int classes = 0;
    EACH_OF_PART(slot, w->circles, crew) {
        classes |= noteReach(w, slot, looksForStops(w, slot));
        searchReach(w)[slot] = w->reach[slot].z;
    }
    noteClasses(w, classes);
    bool carrying = w->status[CARRYING] != 0;
    if (carrying) {
        EACH_OF_PART(block, blocksOfCells(w), crew) summarize(w, block);
    }
    awaitCrew(w, crew);
    for (int from = PIECE * crew->group; from < w->circles; from += PIECE * crew->groups) {
        lookForStopsOf(w, from, min(from + PIECE, w->circles));
    }
    awaitCrew(w, crew);
    for (int look = CARRY_TIMES; carrying && look <= CARRIERS; look++) {
        EACH_OF_PART(slot, w->circles, crew) {
            if (looksAhead(w, slot)) lookForCarriers(w, slot, (Look) look);
        }
        awaitCrew(w, crew);
    }
    EACH_OF_PART(slot, w->circles, crew) {
        setMotionClamp(w, slot);
        searchSpeculativeDistance(w)[slot] = w->sight[slot].z;
    }
    awaitCrew(w, crew);
}
