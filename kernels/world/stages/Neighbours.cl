// uses: world/shared/PairRule.cl world/stages/PairFilter.cl world/stages/ContinuousCollision.cl world/stages/ContactList.cl
// Stage Contacts, its search: circles that may meet within the step.

typedef struct {
    float x, y, speculativeDistance, inverseMass;
    int slot, level, column, row;
    int part, parts; // of several work-items that look for one circle
    bool oneLevel;   // see recordContactAt
} Seeker;

// Of a pair in a crowd.
bool keepsPair(const World *w, const Seeker *s, int other) {
    int id = w->id[s->slot];
    int otherId = w->id[other];
    int hash = pairHash(min(id, otherId), max(id, otherId));
    return keeps(hash, min(candidatesOf(w)[s->slot], candidatesOf(w)[other]));
}

// Three cells, v rows above the seeker. With its own row: what is left of its own bucket, and the next. The edge of the torus is no case
// apart: all work-items of a warp take the same way.
SlotRange rangeOf(const World *w, const Seeker *s, int v, bool withOwnRow) {
    global const int *start = w->bucketStart;
    int cl = w->levels->columnsLog[s->level];
    int last = w->levels->columnCount[s->level] - 1;
    int first = w->levels->first[s->level];
    int row = first + (neighbour(s->row, v, w->levels->rowCount[s->level]) << cl);
    int ownRow = first + (s->row << cl);
    int4 from = (int4)(0);
    int4 to = (int4)(0);
    from.x = start[row + max(s->column - 1, 0)];
    to.x = start[row + min(s->column + 1, last) + 1];
    if (s->column == 0 || s->column == last) {
        int beyond = row + (s->column == 0 ? last : 0);
        from.y = start[beyond];
        to.y = start[beyond + 1];
    }
    if (withOwnRow) {
        from.z = s->slot + 1;
        to.z = start[ownRow + min(s->column + 1, last) + 1];
        if (s->column == last) {
            from.w = start[ownRow];
            to.w = start[ownRow + 1];
        }
    }
    return joinedRanges(from, to);
}

// Of the cell's sheet; without static circles for a static seeker.
int2 slotsBeside(const World *w, const Seeker *s, const Sheets *sheets, int u, int v) {
    int columns = w->levels->columnCount[s->level];
    int rows = w->levels->rowCount[s->level];
    int column = neighbour(s->column, u, columns);
    int row = neighbour(s->row, v, rows);
    int overX = (s->column + u >= columns) - (s->column + u < 0);
    int overY = (s->row + v >= rows) - (s->row + v < 0);
    global const int *start = w->bucketStart + w->levels->first[s->level] + (row << w->levels->columnsLog[s->level]) + column;
    return slotsOfSheet(w, start[0], start[1], sheetKeyBeside(w, s->level, sheets, overX, overY), s->inverseMass != 0.0f);
}

// isOwnRow: without what lies before the seeker.
SlotRange rangeOfSheets(const World *w, const Seeker *s, int v, bool isOwnRow) {
    Sheets sheets = sheetsAt(w, s->level, s->x, s->y);
    int2 left = isOwnRow ? (int2)(0) : slotsBeside(w, s, &sheets, -1, v);
    int2 middle = slotsBeside(w, s, &sheets, 0, v);
    int2 right = slotsBeside(w, s, &sheets, 1, v);
    if (isOwnRow) middle.x = s->slot + 1;
    return joinedRanges((int4)(left.x, middle.x, right.x, 0), (int4)(left.y, middle.y, right.y, 0));
}

// Whether the rows v to 1, three cells each, have so few circles that all are looked at: to look for their sheets would take longer.
bool areFewAround(const World *w, const Seeker *s, int v) {
    int last = w->levels->columnCount[s->level] - 1;
    int most = 3 * FEW * (2 - v);
    int sum = 0;
    for (; v <= 1; v++) {
        int row = neighbour(s->row, v, w->levels->rowCount[s->level]);
        global const int *start = w->bucketStart + w->levels->first[s->level] + (row << w->levels->columnsLog[s->level]);
        sum += start[min(s->column + 1, last) + 1] - start[max(s->column - 1, 0)];
        if (s->column == 0) sum += start[last + 1] - start[last];
        if (s->column == last) sum += start[1] - start[0];
    }
    return sum <= most;
}

// Each cell by itself, in the rows v to 1. A static seeker does so to leave static circles out. With one level, back ends test the same pairs:
// the statistics tell how many.
bool looksBySheet(const World *w, const Seeker *s, bool haveSheets, int v) {
    if (!haveSheets) return false;
    return s->inverseMass == 0.0f || (w->levels->folded[s->level] && (s->oneLevel || !areFewAround(w, s, v)));
}

// found: null to count alone.
void seek(const World *w, const Seeker *s, const SlotRange *range, local Findings *found) {
    int count = range->end.w;
    if (found == 0) {
        candidatesOf(w)[s->slot] += count;
        return;
    }
    if (w->k.thinning == 0 && range->longest > LONGEST_ROW) {
        refuseCrowd(w);
        return;
    }
    for (int i = s->part; i < count; i += s->parts) {
        int other = slotInRange(range, i);
        float4 o = w->sight[other];
        if (!isNear(ACROSS_X(w, o.x - s->x), ACROSS_Y(w, o.y - s->y), s->speculativeDistance, o.SIGHT_DISTANCE)) continue;
        if (!mayMeet(w, s->slot, s->inverseMass, other, o.SIGHT_INVERSE_MASS)) continue;
        if (w->k.thinning && !keepsPair(w, s, other)) continue;
        int k = atomic_inc(&found->count);
        if (k < FINDINGS) {
            found->slots[k] = (int2)(s->slot, other);
        } else {
            // By cells that are known here: to work them out again takes a GPU more registers than all else.
            recordContactAt(w, atomic_inc(&w->status[FOUND]), s->slot, other, s->level, s->column, s->row, s->oneLevel);
        }
    }
}

Seeker seekerOf(const World *w, int slot, bool oneLevel) {
    float4 own = w->sight[slot];
    Seeker s = {.x = own.x, .y = own.y, .speculativeDistance = own.SIGHT_DISTANCE, .inverseMass = own.SIGHT_INVERSE_MASS,
                .slot = slot, .part = 0, .parts = 1, .oneLevel = oneLevel};
    return s;
}

void seekIn(const World *w, Seeker *s, int atLevel) {
    s->level = atLevel;
    s->column = ringOf(axisX(w, atLevel), s->x);
    s->row = ringOf(axisY(w, atLevel), s->y);
}

// In its own level half of the cells, so that each pair is seen once; in a coarser one 3 x 3. haveSheets: known to kernels, for fewer
// registers.
INLINE void seekAround(const World *w, Seeker *s, int atLevel, int own, bool haveSheets, local Findings *found) {
    seekIn(w, s, atLevel);
    bool inOwnLevel = atLevel == own;
    bool bySheet = looksBySheet(w, s, haveSheets, inOwnLevel ? 0 : -1);
#pragma unroll 1
    for (int v = inOwnLevel ? (bySheet ? 0 : 1) : -1; v <= 1; v++) {
        SlotRange range;
        if (bySheet) {
            range = rangeOfSheets(w, s, v, inOwnLevel && v == 0);
        } else {
            range = rangeOf(w, s, v, inOwnLevel);
        }
        seek(w, s, &range, found);
    }
}

// part, parts: of several work-items that share in it.
INLINE void seekAll(const World *w, int slot, int part, int parts, bool oneLevel, bool haveSheets, local Findings *found) {
    Seeker s = seekerOf(w, slot, oneLevel);
    s.part = part;
    s.parts = parts;
    int own = levelOfSlot(w, slot);
#pragma unroll 1
    for (int l = w->levels->usedCount - 1; l >= 0 && w->levels->used[l] <= own; l--) {
        seekAround(w, &s, w->levels->used[l], own, haveSheets, found);
    }
}

// How many circles of a range may meet the seeker.
int candidatesIn(const World *w, const Seeker *s, const SlotRange *range) {
    int sum = 0;
    for (int i = 0; i < range->end.w; i++) {
        int other = slotInRange(range, i);
        float4 o = w->sight[other];
        sum += isNear(ACROSS_X(w, o.x - s->x), ACROSS_Y(w, o.y - s->y), s->speculativeDistance, o.SIGHT_DISTANCE) && other != s->slot &&
               mayMeet(w, s->slot, s->inverseMass, other, o.SIGHT_INVERSE_MASS);
    }
    return sum;
}

// Candidates in its own level and coarser ones. Index space: slots. Cost: 3 x 3 cells a level.
kernel void contacts_crowd(WORLD_PARAMETERS) {
    World w = WORLD;
    int slot = (int) get_global_id(0);
    if (slot >= circles || refused(&w)) return;
    Seeker s = seekerOf(&w, slot, hasOneLevel(&w));
    int own = levelOfSlot(&w, slot);
    int sum = 0;
    for (int l = levels->usedCount - 1; l >= 0 && levels->used[l] <= own; l--) {
        seekIn(&w, &s, levels->used[l]);
        bool bySheet = looksBySheet(&w, &s, levels->haveSheets != 0, -1);
        for (int v = -1; v <= 1; v++) {
            SlotRange range = bySheet ? rangeOfSheets(&w, &s, v, false) : rangeOf(&w, &s, v, false);
            sum += candidatesIn(&w, &s, &range);
        }
    }
    candidatesOf(&w)[slot] = sum;
    if (sum > CROWD) status[CROWDED] = 1;
}

// By a work-item a slot, or with several levels a slot and a level: which is several times faster than all levels by one.
INLINE void countContacts(const World *w, bool oneLevel, bool haveSheets, local Findings *found) {
    int l = oneLevel ? 0 : (int) get_global_id(0) / w->circles;
    int slot = (int) get_global_id(0) - l * w->circles;
    if (get_local_id(0) == 0) found->count = 0;
    barrier(CLK_LOCAL_MEM_FENCE);
    bool looks = (oneLevel ? slot < w->circles : l < w->levels->usedCount) && !tooFast(w) && !gridIsEmpty(w);
    if (looks && oneLevel) {
        seekAll(w, slot, 0, 1, true, haveSheets, found);
    } else if (looks) {
        Seeker s = seekerOf(w, slot, false);
        int own = levelOfSlot(w, slot);
        if (w->levels->used[l] <= own) seekAround(w, &s, w->levels->used[l], own, haveSheets, found);
    }
    recordFindings(w, found, oneLevel);
}

// Index space of the next four: slots; with several levels slots and levels, level after level. Cost: 3 x 3 cells.

kernel void contacts_count(WORLD_PARAMETERS) {
    World w = WORLD;
    local Findings found;
    countContacts(&w, true, false, &found);
}

kernel void contacts_countBySheet(WORLD_PARAMETERS) {
    World w = WORLD;
    local Findings found;
    countContacts(&w, true, true, &found);
}

kernel void contacts_countByLevel(WORLD_PARAMETERS) {
    World w = WORLD;
    local Findings found;
    countContacts(&w, false, false, &found);
}

kernel void contacts_countByLevelAndSheet(WORLD_PARAMETERS) {
    World w = WORLD;
    local Findings found;
    countContacts(&w, false, true, &found);
}

// For statistics: pairs that were tested. Index space: slots.
kernel void contacts_candidates(WORLD_PARAMETERS) {
    World w = WORLD;
    int slot = (int) get_global_id(0);
    if (slot >= circles) return;
    candidatesOf(&w)[slot] = 0;
    seekAll(&w, slot, 0, 1, hasOneLevel(&w), levels->haveSheets != 0, 0);
}
