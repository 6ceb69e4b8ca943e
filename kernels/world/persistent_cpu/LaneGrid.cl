// uses: world/stages/Grid.cl world/stages/ContinuousCollision.cl
// uses: world/persistent_cpu/Together.cl world/persistent_cpu/LaneMover.cl world/persistent_cpu/LaneFinding.cl
// Stages Grid and ContinuousCollision by a few work-groups that meet: what Grid.cl and ContinuousCollision.cl do to a bucket or
// a circle, each work-group for its part of all; and the bands of rows into which the circles are divided from there on.

#define LAG 4 // rows that a sub-step is behind the one before it in a sweep (Lanes.cl)

// The rows of a work-group, from an even one to an even one, of about the same weight as the others'.
typedef struct {
    int from, to;
    int narrowest; // rows of the narrowest band
} Band;

// Work for a row, in parts of what a circle takes: in the solver where contacts have been listed, else in the search for them,
// which takes the longer the closer the circles stand.
long weightOf(const World *w, int row, bool listed) {
    Cells cells = cellsOf(w, row);
    long circles = cells.to - cells.from;
    if (listed) return circles + 2 * (w->groupStart[2 * row + 1] - w->groupStart[2 * row]);
    return circles + (2 * circles * circles >> w->levels->columnsLog[w->levels->used[0]]);
}

// The host sees to it that several work-groups have 2 * LAG rows each.
Band bandOf(const World *w, const Crew *crew, bool listed) {
    int rows = w->levels->rowCount[w->levels->used[0]];
    Band band = {0, rows, rows};
    if (crew->groups == 1) return band;
    long all = 0;
    for (int row = 0; row < rows; row++) all += weightOf(w, row, listed);
    long sum = 0;
    int row = 0;
    int before = 0;
    for (int next = 1; next <= crew->groups; next++) {
        long share = all * next / crew->groups;
        for (; row < rows; row += 2) {
            long two = weightOf(w, row, listed) + weightOf(w, row + 1, listed);
            if (sum + two / 2 >= share) break; // it is nearer to the share without them
            sum += two;
        }
        int edge = next == crew->groups ? rows : min(max(row, before + 2 * LAG), rows - 2 * LAG * (crew->groups - next));
        if (next - 1 == crew->group) {
            band.from = before;
            band.to = edge;
        }
        band.narrowest = min(band.narrowest, edge - before);
        before = edge;
    }
    return band;
}

// Counts the circles of each bucket. Circles lie in the order of the step before, so hardly any bucket has some of two parts:
// atomic operations, which take longer than all the rest, are for those that may.
void countPart(const World *w, const Crew *crew) {
    global int *ends = w->groupStart; // free until contacts are listed
    int least = INT_MAX;
    int most = NONE;
    EACH_OF_PART(slot, w->slots, crew) {
        int bucket = w->homeId[slot] < 0 ? NONE : bucketIn(w, w->levels->used[0], w->homeCircle[slot]);
        w->bucketBefore[slot] = bucket;
        if (bucket == NONE) continue;
        least = min(least, bucket);
        most = max(most, bucket);
    }
    ends[2 * crew->group] = least;
    ends[2 * crew->group + 1] = most;
    awaitCrew(w, crew);
    int from = 0;
    int to = INT_MAX;
    for (int g = 0; g < crew->group; g++) from = max(from, ends[2 * g + 1] + 1);
    for (int g = crew->group + 1; g < crew->groups; g++) to = min(to, ends[2 * g]);
    EACH_OF_PART(slot, w->slots, crew) {
        int bucket = w->bucketBefore[slot];
        if (bucket == NONE) continue;
        bool own = from <= bucket && bucket < to;
        w->rank[slot] = own ? w->tally[bucket]++ : atomic_inc(&w->tally[bucket]);
    }
}

// Where the circles of each bucket start, from the counts in the tally, which is cleared.
void sumUp(const World *w, const Crew *crew) {
    int count = w->levels->first[LEVELS] + 1;
    global int *totals = w->groupStart; // free until contacts are listed
    int sum = 0;
    EACH_OF_PART(i, count, crew) sum += w->tally[i];
    totals[crew->group] = sum;
    awaitCrew(w, crew);
    int before = 0;
    for (int g = 0; g < crew->group; g++) before += totals[g];
    EACH_OF_PART(i, count, crew) {
        w->bucketStart[i] = before;
        before += w->tally[i];
        w->tally[i] = 0;
    }
}

// Notes a circle for the search for contacts.
void noteForSearch(const World *w, int slot, float x, float y, float speculativeDistance) {
    searchX(w)[slot] = x;
    searchY(w)[slot] = y;
    searchSpeculativeDistance(w)[slot] = speculativeDistance;
}

// Stage Grid. Leaves it to a meeting that others see what the last part has written.
Band sortCircles(World *w, const Crew *crew) {
    w->k.sweeping = 1; // until it is known
    if (crew->group == 0) {
        w->status[FAST] = 0;
        w->status[CARRYING] = 0;
        w->status[LONGEST_PATH] = 0;
        w->status[CONTACTS] = 0;
        w->status[PLACES] = 0;
        w->status[MOST_PLACES] = 0;
#ifdef RECORDING
        startRecords(w);
#endif
    }
    countPart(w, crew);
    awaitCrew(w, crew);
    sumUp(w, crew);
    awaitCrew(w, crew);
    EACH_OF_PART(slot, w->slots, crew) scatterSlot(w, slot);
    awaitCrew(w, crew);
    Band band = bandOf(w, crew, false);
    int first = w->levels->first[w->levels->used[0]];
    int cl = w->levels->columnsLog[w->levels->used[0]];
    int from = w->bucketStart[first + (band.from << cl)];
    int to = w->bucketStart[first + (band.to << cl)];
    bool fast = false;
    for (int i = from; i < to; i++) fast |= gatherCircle(w, i);
    if (fast) w->status[FAST] = 1;
    awaitCrew(w, crew); // the search writes where others may still look up buckets
    for (int slot = from; slot < to; slot++) {
        float4 sight = w->sight[slot];
        noteForSearch(w, slot, sight.x, sight.y, sight.z);
#ifdef RECORDING
        clearWallTouch(w, slot);
#endif
    }
    if (crew->group == 0) {
        // The search reads on to the next multiple of four.
        for (int spare = 0; spare < 4; spare++) noteForSearch(w, w->circles + spare, INFINITY, INFINITY, 0.0f);
    }
    return band;
}

// Stage ContinuousCollision, where some circle is fast.
void sweepCircles(World *w, const Crew *crew) {
    w->k.sweeping = w->status[FAST];
    if (!w->k.sweeping) return;
    EACH_OF_PART(block, w->levels->first[LEVELS] >> (2 * BLOCK_LOG), crew) summarize(w, block);
    awaitCrew(w, crew);
    EACH_OF_PART(slot, w->circles, crew) {
        if (looksAhead(w, slot)) lookAhead(w, slot, STOPS);
    }
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
