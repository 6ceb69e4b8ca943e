// uses: world/stages/World.cl world/shared/Paths.cl world/shared/TimeOfImpact.cl world/shared/Wall.cl world/shared/Drive.cl world/shared/Turning.cl world/shared/Sleep.cl
// Stage Grid sorts circles by (level, bucket, sheet if there are any, id), and describes them. A counting sort; then each circle finds its
// place in its bucket, which undoes the order of work-items. Refuses a step with a circle that is too fast for it.

// Steps that take fast circles, crowds or tiles tell the host about the last one alone.
void startStep(const World *w) {
    if (refused(w)) return;
    if (w->k.sweeping) w->status[FAST] = 0;
    if (w->k.thinning) w->status[CROWDED] = 0;
    w->status[CARRYING] = 0;
    w->status[LONGEST_PATH] = 0;
    w->status[REACHES] = 0;
    w->status[TILE_PEAK] = 0;
    w->status[TILES_LISTED] = 0;
    w->status[TILES_CUT] = 0;
    w->status[FOUND] = 0;
    IF_TERRAIN(w->status[PIECES_FOUND] = 0;)
#ifdef SLEEPING
    w->status[SLEEPERS] = 0;
    w->status[RESTLESS] = 0;
    w->status[AWAKE] = 0;
    w->status[WOKEN_COUNT] = 0;
    w->status[KEPT_COUNT] = 0;
#endif
}

int bucketIn(const World *w, int l, float4 c) {
    return w->levels->first[l] + ringOf(axisX(w, l), c.x) + (ringOf(axisY(w, l), c.y) << w->levels->columnsLog[l]);
}

void countSlot(const World *w, int slot) {
    if (w->homeId[slot] < 0) {
        w->bucketBefore[slot] = NONE;
        return;
    }
    float4 c = w->homeCircle[slot];
    int bucket = bucketIn(w, levelOf(w, c.RADIUS), c);
    w->bucketBefore[slot] = bucket;
    w->rank[slot] = atomic_inc(&w->tally[bucket]);
}

// Index space: slots at home.
kernel void grid_count(WORLD_PARAMETERS) {
    World w = WORLD;
    int slot = (int) get_global_id(0);
    if (slot == 0) startStep(&w);
    if (slot < slots && !refused(&w)) countSlot(&w, slot);
}

int sheetKeyOfSlot(const World *w, int slot) {
    float4 c = w->homeCircle[slot];
    int level = levelOf(w, c.RADIUS);
    int key = w->levels->folded[level] ? sheetKeyOf(w, level, sheetOf(axisX(w, level), c.x), sheetOf(axisY(w, level), c.y)) : 0;
    float own = awakeInverseMass(c, w->homeTraits[slot].INVERSE_MASS); // who sleeps may wake within the step
    return key + (own == 0.0f ? 1 : 0);
}

void scatterSlot(const World *w, int slot) {
    int bucket = w->bucketBefore[slot];
    if (bucket < 0) return;
    int place = w->bucketStart[bucket] + w->rank[slot];
    w->order[place] = (int2)(w->homeId[slot], slot);
    if (w->levels->haveSheets) w->listedSheet[place] = sheetKeyOfSlot(w, slot);
}

// Index space: slots at home.
kernel void grid_scatter(WORLD_PARAMETERS) {
    World w = WORLD;
    int slot = (int) get_global_id(0);
    if (slot < slots && !refused(&w)) scatterSlot(&w, slot);
}

// Several at a time: a read takes long, and most buckets have few.
int countLower(const World *w, int from, int to, int id) {
    int sum = 0;
    for (int i = from; i < to; i += 4) {
        int a = w->order[i].LISTED_ID;
        int b = w->order[min(i + 1, to - 1)].LISTED_ID;
        int c = w->order[min(i + 2, to - 1)].LISTED_ID;
        int d = w->order[min(i + 3, to - 1)].LISTED_ID;
        sum += (a < id) + (i + 1 < to && b < id) + (i + 2 < to && c < id) + (i + 3 < to && d < id);
    }
    return sum;
}

// Of a lower key, or of its own and with a lower id.
int countBefore(const World *w, int from, int to, int key, int id) {
    int sum = 0;
    for (int i = from; i < to; i++) {
        int other = w->listedSheet[i];
        sum += other < key || (other == key && w->order[i].LISTED_ID < id);
    }
    return sum;
}

// About: a static circle is fast if it is for circles of this radius.
float leastRadius(const World *w) { return 0.5f * w->levels->top[w->levels->used[0]]; }

// 1 if the circle does not fly far.
float timeOfWalls(const World *w, float4 c, float px, float py, bool far) {
    if (!far) return 1.0f;
    const StepConstants *k = &w->k;
    float tx = timeOfWall(c.x, px, c.RADIUS, k->minX, k->maxX, travelFor(w, 0, c.RADIUS), travelFor(w, 1, c.RADIUS));
    float ty = timeOfWall(c.y, py, c.RADIUS, k->minY, k->maxY, travelFor(w, 2, c.RADIUS), travelFor(w, 3, c.RADIUS));
    return maxf(minf(tx, ty), 0.0f);
}

// Plans the motion of a circle, and describes it for searches. Returns whether it is fast.
INLINE bool describeCircle(const World *w, int slot, int id, float4 c, float4 m, float inverseMass_) {
    bool isStatic = inverseMass_ == 0.0f;
    float px = plan(m.VX, w->k.dt, isStatic ? 0.0f : w->k.fallX);
    float py = plan(m.VY, w->k.dt, isStatic ? 0.0f : w->k.fallY);
    if (w->k.driving && !isStatic) {
        float2 driven = drivenPath(w, id, inverseMass_, m);
        px = driven.x;
        py = driven.y;
    }
#ifdef EDGES
    float within_ = minf(shareOfPeriod(px, w->levels->periodX), shareOfPeriod(py, w->levels->periodY));
    px = within_ * px;
    py = within_ * py;
#endif
    float path = lengthf(px, py);
    if (isStatic) {
        // It stops at the bounds.
        px = within(c.x, px, w->k.minX, w->k.maxX);
        py = within(c.y, py, w->k.minY, w->k.maxY);
        path = lengthf(px, py);
    } else if (path > c.RADIUS) {
        px = besideWalls(c.x, px, c.RADIUS, w->k.minX, w->k.maxX);
        py = besideWalls(c.y, py, c.RADIUS, w->k.minY, w->k.maxY);
        path = lengthf(px, py);
    }
    float share = isStatic ? 1.0f : travelShare(path, c.RADIUS);
    px = share * px;
    py = share * py;
    path = share * path;
    bool fast = isFast(path, isStatic ? leastRadius(w) : c.RADIUS);
    w->motionClamp[slot] = (float4)(px, py, CLAMP_ALLOWANCE * c.RADIUS, path);
    w->sight[slot] = (float4)(c.x, c.y, speculativeDistance(c.RADIUS, path), inverseMass_);
    if (w->k.sweeping) {
        w->timeOfImpact[slot] = as_int(timeOfWalls(w, c, px, py, !isStatic && path > c.RADIUS));
        w->near[slot] = (float2)(fast ? 1.0f : NOT_FAST, INFINITY);
        w->carryTime[slot] = as_int(NOT_CARRIED);
        w->carrier[slot] = NOBODY;
        w->lastReached[slot] = (int2)(NONE);
        if (isStatic && path > 0.0f) w->status[CARRYING] = 1;
    }
    return fast;
}

#ifdef SLEEPING
void gatherSleep(const World *w, int slot, int from) {
    int4 sleep = w->homeSleep[from];
    w->sleep[slot] = sleep;
    w->waking[slot] = (int2)(0);
    w->heavySum[slot] = (long4)(0);
}
#endif

// Returns whether it is fast.
bool gatherCircle(const World *w, int i) {
    int2 listed = w->order[i];
    int from = listed.LISTED_SLOT;
    int bucket = w->bucketBefore[from];
    float4 c = w->homeCircle[from];
    float4 m = w->homeMotion[from];
    float4 t = w->homeTraits[from];
    int firstCached = w->homeFirstCached[from];
    int start = w->bucketStart[bucket];
    int end = w->bucketStart[bucket + 1];
    int slot;
    if (w->levels->haveSheets) {
        int key = w->listedSheet[i];
        slot = start + countBefore(w, start, end, key, listed.LISTED_ID);
        w->sheetKey[slot] = key;
    } else {
        slot = start + countLower(w, start, end, listed.LISTED_ID);
    }
    w->circle[slot] = c;
    w->motion[slot] = m;
    w->traits[slot] = t;
    w->id[slot] = listed.LISTED_ID;
    w->firstCached[slot] = firstCached;
    w->bucketOf[slot] = bucket;
#if defined(JOINTS) || defined(SLEEPING)
    workingSlotOf(w)[from] = slot;
#endif
    if (!w->k.tiled) w->load[slot] = (float4)(0.0f);
    IF_TURNING(gatherTurning(w, slot, from, listed.LISTED_ID, c, t.INVERSE_MASS);)
    IF_TURNING(w->heavySpin[slot] = (long2)(0);)
    IF_TERRAIN(w->pieces[slot] = w->homePieces[from];)
    if (!hasOneLevel(w)) {
        w->crossLoad[slot] = 0;
        w->claim[slot] = 0;
        w->coarser[slot] = 0;
        w->heavySum[slot] = (long4)(0);
    }
    IF_SLEEPING(gatherSleep(w, slot, from);)
    return describeCircle(w, slot, listed.LISTED_ID, c, m, t.INVERSE_MASS);
}

// The step was refused before.
bool gridIsEmpty(const World *w) {
    return w->bucketStart[w->levels->first[LEVELS]] == 0 || w->status[EVENTS_LACK] != 0;
}

#ifdef SLEEPING
#define WAKING_PARAMETER , int waking // whether the step can wake circles; else it does not take any that sleep
#else
#define WAKING_PARAMETER
#endif

// Index space: slots. Cost: the circles of its bucket.
kernel void grid_gather(WORLD_PARAMETERS WAKING_PARAMETER) {
    World w = WORLD;
    // For all of the work-group: a store of every fast circle to one place takes longer than all the rest.
    local int fast;
    int i = (int) get_global_id(0);
    if (get_local_id(0) == 0) fast = 0;
    IF_SLEEPING(local int sleepers;)
    IF_SLEEPING(if (get_local_id(0) == 0) sleepers = 0;)
    barrier(CLK_LOCAL_MEM_FENCE);
    if (i < circles && !gridIsEmpty(&w)) {
        if (gatherCircle(&w, i)) fast = 1;
        IF_SLEEPING(if (isAsleep(w.homeSleep[w.order[i].LISTED_SLOT].REST)) sleepers = 1;)
    }
    barrier(CLK_LOCAL_MEM_FENCE);
    if (get_local_id(0) == 0 && fast) status[FAST] = 1;
#ifdef SLEEPING
    if (get_local_id(0) == 0 && sleepers) {
        status[SLEEPERS] = 1;
        if (!waking) status[OUT_OF_ROOM] = 1;
    }
#endif
}
