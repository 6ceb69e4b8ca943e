// uses: world/stages/ContinuousCollision.cl world/persistent_cpu/LaneGrid.cl
// Stage ContinuousCollision by a few work-groups that meet. Fast circles look at four others at a time.

// How far from its centre a circle gets in the step, and a hundredth more: circles that are farther apart than both do not touch, however
// a time of impact is rounded.
float reachOf(float r, float path) { return 1.01f * (r + path); }

// Where reaches are noted, in place of speculative distances, until all have looked.
global float *searchReach(const World *w) { return searchSpeculativeDistance(w); }

// Looks at those slots of [from, to) that a circle may touch in the step.
INLINE void meetByLanes(const World *w, const Runner *s, int from, int to) {
    float reach = reachOf(s->r, s->path);
    for (int other = from; other < to; other += 4) {
        float4 dx = ACROSS_X4(w, vload4(0, searchX(w) + other) - s->x);
        float4 dy = ACROSS_Y4(w, vload4(0, searchY(w) + other) - s->y);
        float4 limit = reach + vload4(0, searchReach(w) + other);
        int4 hit = isNear4(dx, dy, limit) & ((int4)(0, 1, 2, 3) < (int4)(to - other));
        if (!someLane(hit)) continue;
        int hits[4] = {hit.x, hit.y, hit.z, hit.w};
        for (int l = 0; l < 4; l++) {
            if (hits[l] && other + l != s->slot && mayMatter(w, s, other + l)) meet(w, s, other + l);
        }
    }
}

// lookAt, row by row: what the paths of the circles in a block have in common spares less than it takes to look at.
void lookAtByLanes(const World *w, const Runner *s, int level, int c0, int c1, int r0, int r1) {
    int columns = w->levels->columnCount[level];
    int rows = w->levels->rowCount[level];
    int column = onRing(c0, columns);
    int beyond = column + (c1 - c0 + 1) - columns; // columns on the other side of the edge of the torus
    for (int v = r0; v <= r1; v++) {
        int row = onRing(v, rows) << w->levels->columnsLog[level];
        global const int *start = w->bucketStart + w->levels->first[level] + row;
        meetByLanes(w, s, start[column], start[beyond > 0 ? columns : columns + beyond]);
        if (beyond > 0) meetByLanes(w, s, start[0], start[beyond]);
    }
}

// Stops of the fast circles among some.
void lookForStops(const World *shared, int from, int to) {
    World own = *shared;
    const World *w = &own;
    for (int slot = from; slot < to; slot++) {
        if (looksAhead(w, slot)) lookAheadBy(w, slot, STOPS, true);
    }
}

// Stage ContinuousCollision, where some circle is fast.
void sweepCircles(World *w, const Crew *crew) {
    w->k.sweeping = w->status[FAST];
    if (!w->k.sweeping) return;
    if (w->status[CARRYING]) {
        EACH_OF_PART(block, w->levels->first[LEVELS] >> (2 * BLOCK_LOG), crew) summarize(w, block);
    }
    EACH_OF_PART(slot, w->circles, crew) searchReach(w)[slot] = reachOf(w->circle[slot].z, w->motionClamp[slot].w);
    awaitCrew(w, crew);
    lookForStops(w, partOf(w->circles, crew->group, crew->groups), partOf(w->circles, crew->group + 1, crew->groups));
    awaitCrew(w, crew);
    if (w->status[CARRYING]) {
        EACH_OF_PART(slot, w->circles, crew) {
            if (looksAhead(w, slot)) lookAhead(w, slot, CARRY_TIMES);
        }
        awaitCrew(w, crew);
        EACH_OF_PART(slot, w->circles, crew) {
            if (looksAhead(w, slot)) lookAhead(w, slot, CARRIERS);
        }
        awaitCrew(w, crew);
    }
    EACH_OF_PART(slot, w->circles, crew) {
        setMotionClamp(w, slot);
        searchSpeculativeDistance(w)[slot] = w->sight[slot].z;
    }
    awaitCrew(w, crew);
}
