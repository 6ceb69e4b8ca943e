// uses: world/stages/Grid.cl
// uses: world/persistent_cpu/Together.cl world/persistent_cpu/LaneMover.cl world/persistent_cpu/LaneFinding.cl
// Stage Grid by a few work-groups that meet: what Grid.cl does to a bucket or a circle, each work-group for its part of all; and the
// bands of rows into which the circles are divided from there on.

#define LAG 4 // rows that a sub-step is behind the one before it in a sweep (Lanes.cl)

// The rows of a level that a work-group has, from an even one to an even one, of about the same weight as the others'.
typedef struct {
    int from, to;
    int narrowest; // rows of the narrowest band
} Band;

int onlyLevel(const World *w) { return w->levels->used[0]; }

// Work for a row, in parts of what a circle takes: in the solver where contacts have been listed, else in the search for them,
// which takes the longer the closer the circles stand.
long weightOf(const World *w, int level, int row, bool listed) {
    Cells cells = cellsOf(w, level, row);
    long circles = cells.to - cells.from;
    int number = rowNumber(w, level, row);
    if (listed) return circles + 2 * (w->groupStart[2 * number + 1] - w->groupStart[2 * number]);
    return circles + (2 * circles * circles >> w->levels->columnsLog[level]);
}

// The band of a work-group in a level. least: how many rows it has at least, where there are so many for all.
Band bandOf(const World *w, const Crew *crew, int level, int least, bool listed) {
    int rows = w->levels->rowCount[level];
    Band band = {0, rows, rows};
    if (crew->groups == 1) return band;
    long all = 0;
    for (int row = 0; row < rows; row++) all += weightOf(w, level, row, listed);
    long sum = 0;
    int row = 0;
    int before = 0;
    for (int next = 1; next <= crew->groups; next++) {
        long share = all * next / crew->groups;
        for (; row < rows; row += 2) {
            long two = weightOf(w, level, row, listed) + weightOf(w, level, row + 1, listed);
            if (sum + two / 2 >= share) break; // it is nearer to the share without them
            sum += two;
        }
        int edge = next == crew->groups ? rows : min(max(row, before + least), rows - least * (crew->groups - next));
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
INLINE void countPart(const World *w, const Crew *crew, bool mixed) {
    global int *ends = w->groupStart; // free until contacts are listed
    int least = INT_MAX;
    int most = NONE;
    EACH_OF_PART(slot, w->slots, crew) {
        int bucket = NONE;
        if (w->homeId[slot] >= 0) {
            float4 c = w->homeCircle[slot];
            bucket = bucketIn(w, mixed ? levelOf(w, c.z) : onlyLevel(w), c);
        }
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

// Stage Grid up to the list of each bucket's circles. mixed: whether there are several levels, known where it is compiled.
INLINE void listCircles(World *w, const Crew *crew, bool mixed) {
    w->k.sweeping = 1; // until it is known
    if (crew->group == 0) {
        if (w->k.thinning) w->status[CROWDED] = 0;
        w->status[FAST] = 0;
        w->status[CARRYING] = 0;
        w->status[LONGEST_PATH] = 0;
        w->status[REACHES] = 0;
        w->status[CONTACTS] = 0;
        w->status[PLACES] = 0;
        w->status[MOST_PLACES] = 0;
#ifdef RECORDING
        startRecords(w);
#endif
    }
    countPart(w, crew, mixed);
    awaitCrew(w, crew);
    sumUp(w, crew);
    awaitCrew(w, crew);
    EACH_OF_PART(slot, w->slots, crew) scatterSlot(w, slot);
    awaitCrew(w, crew);
}

// The circles of a band.
Cells cellsOfBand(const World *w, int level, Band band) {
    int first = w->levels->first[level];
    int cl = w->levels->columnsLog[level];
    Cells c = {w->bucketStart[first + (band.from << cl)], w->bucketStart[first + (band.to << cl)]};
    return c;
}

void gatherCircles(const World *w, Cells cells) {
    bool fast = false;
    for (int i = cells.from; i < cells.to; i++) fast |= gatherCircle(w, i);
    if (fast) w->status[FAST] = 1;
}

// Notes circles for the search, which writes where others look up buckets until all have gathered theirs.
void noteCircles(const World *w, Cells cells) {
    for (int slot = cells.from; slot < cells.to; slot++) {
        float4 sight = w->sight[slot];
        noteForSearch(w, slot, sight.x, sight.y, sight.z);
#ifdef RECORDING
        clearWallTouch(w, slot);
#endif
    }
}

// The search reads on to the next multiple of four.
void noteSpareSlots(const World *w) {
    for (int spare = 0; spare < 4; spare++) noteForSearch(w, w->circles + spare, INFINITY, INFINITY, 0.0f);
}

// Stage Grid. Leaves it to a meeting that others see what the last part has written.
Band sortCircles(World *w, const Crew *crew) {
    listCircles(w, crew, false);
    Band band = bandOf(w, crew, onlyLevel(w), 2 * LAG, false);
    Cells cells = cellsOfBand(w, onlyLevel(w), band);
    gatherCircles(w, cells);
    awaitCrew(w, crew);
    noteCircles(w, cells);
    if (crew->group == 0) noteSpareSlots(w);
    return band;
}
