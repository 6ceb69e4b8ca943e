// uses: world/shared/PairRule.cl*4 world/stages/PairFilter.cl
// uses: world/persistent_cpu/LaneMover.cl world/persistent_cpu/LaneContacts.cl world/persistent_cpu/LaneCross.cl
// uses: world/persistent_cpu/LaneTouches.cl
// Finds the contacts of a row of groups and lays them out as wide contacts. A group finds the pairs whose lesser column and
// lesser row are its own in its 2 x 2 cells, so each pair is found once, and by the work-group that will solve it. Groups of
// the same parity of columns share no circle: their contacts, each group's in order, are dealt to wide contacts in turn. The
// more groups are dealt together, the fewer lanes stay empty.

#define HITS 512            // pairs of one group; what is more crowded goes the way of crowds
#define DEALT_TOGETHER 64   // groups
#define GATHERED (2 * HITS) // pairs of these

// What a work-group looks for contacts with.
typedef struct {
    global const float *x, *y, *speculativeDistance; // by working slot
    ulong hit[HITS + 4];               // of the group: slot above slot
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

// Puts the pairs that were hit among those gathered, in order of their ids. filtering: see mayMeetIf; cross: whether they are cross
// contacts of one light circle, which looked; see LIGHT_IS_HIGHER.
INLINE void gatherHits(const World *w, Search *f, int hits, bool filtering, bool cross) {
    int from = f->gathered;
    int count = from;
    for (int k = 0; k < hits; k++) {
        int slot = (int) (f->hit[k] >> 32);
        int other = (int) f->hit[k];
        if (!mayMeetIf(w, filtering, slot, w->traits[slot].x, other, w->traits[other].x)) continue;
        int id = w->id[slot];
        int otherId = w->id[other];
        // Exchanged where the other has the lower id; no branch, which would be taken as if by chance.
        int exchange = (slot ^ other) & ((otherId - id) >> 31);
        ulong ids = (ulong) min(id, otherId) << 32 | (uint) max(id, otherId);
        ulong slots = (ulong) (slot ^ exchange) << 32 | (uint) (other ^ exchange);
        if (cross && otherId < id) slots |= LIGHT_IS_HIGHER;
        // Exchanged with every pair that comes after it. No branch: where it comes to stand is as good as random.
        for (int p = from; p < count; p++) {
            ulong nextIds = f->ids[p];
            ulong nextSlots = f->slots[p];
            bool before = ids < nextIds;
            f->ids[p] = before ? ids : nextIds;
            f->slots[p] = before ? slots : nextSlots;
            ids = before ? nextIds : ids;
            slots = before ? nextSlots : slots;
        }
        f->ids[count] = ids;
        f->slots[count++] = slots;
    }
    f->gathered = count;
    if (count > from) f->start[++f->groups] = count;
}

// Deals what has been gathered to wide contacts: the first contact of each group, then the second of each. A wide contact may
// hold the end of one round and the start of the next, as long as so many groups are left that none of them is in it twice.
// cross: whether a group has the cross contacts of one light circle.
INLINE void dealAs(const World *w, Search *f, bool cross) {
    int next[DEALT_TOGETHER], end[DEALT_TOGETHER];
    int open = f->groups;
    for (int g = 0; g < open; g++) {
        next[g] = f->start[g];
        end[g] = f->start[g + 1];
    }
    ulong ids[4], slots[4];
    int lanes = 0;
    while (open > 0) {
        int left = 0;
        for (int g = 0; g < open; g++) {
            int from = next[g];
            ids[lanes] = f->ids[from];
            slots[lanes++] = f->slots[from];
            next[left] = from + 1;
            int last = end[g];
            end[left] = last;
            left += from + 1 < last;
            if (lanes == 4 || (g == open - 1 && left < 4)) {
                if (f->wide < f->endWide) {
                    if (cross) {
                        fillWideCross(w, f->wide, ids, slots, lanes, f->owner);
                    } else {
                        fillWide(w, f->wide, ids, slots, lanes);
                    }
                }
#ifdef RECORDING
                if (f->wide < f->endWide) f->met += clearTouch(w, f->wide, ids, lanes);
#endif
                f->wide++;
                lanes = 0;
            }
        }
        open = left;
    }
    f->contacts += f->gathered;
    f->gathered = 0;
    f->groups = 0;
}

void deal(const World *w, Search *f) { dealAs(w, f, false); }

// Whether what has been gathered has to be dealt before another group is.
bool hasToDeal(const Search *f) { return f->groups == DEALT_TOGETHER || f->gathered > GATHERED - HITS; }

// Tests the pairs of the group of a row and column; returns how many are near.
INLINE int findGroup(const World *w, Search *f, int l, int row, int column) {
    int cl = w->levels->columnsLog[l];
    global const int *own = w->bucketStart + w->levels->first[l] + (row << cl);
    global const int *above =
        w->bucketStart + w->levels->first[l] + (neighbour(row, 1, w->levels->rowCount[l]) << cl);
    int right = neighbour(column, 1, w->levels->columnCount[l]);
    int from = own[column];
    int to = own[column + 1];
    int rightFrom = own[right];
    int rightTo = own[right + 1];
    int aboveFrom = above[column];
    int aboveTo = above[column + 1];
    // Slots from the group's column on, then those of the column to its right; where that is the first of the row, all apart.
    bool joined = right > 0;
    if (joined && from == rightTo) return 0; // every pair has a circle in the group's own row
    int hits = 0;
    for (int slot = from; slot < to; slot++) {
        hits = scanSlots(w, f, hits, slot, slot + 1, joined ? rightTo : to);
        hits = scanSlots(w, f, hits, slot, aboveFrom, joined ? above[right + 1] : aboveTo);
        if (joined) continue;
        hits = scanSlots(w, f, hits, slot, rightFrom, rightTo);
        hits = scanSlots(w, f, hits, slot, above[right], above[right + 1]);
    }
    for (int slot = rightFrom; slot < rightTo; slot++) hits = scanSlots(w, f, hits, slot, aboveFrom, aboveTo);
    return hits;
}

// Finds and fills the contacts of a row of groups of a level.
void findRow(const World *shared, Search *f, int l, int row) {
    World own = *shared;
    const World *w = &own;
    int first = f->wide;
    Cells cells = cellsOf(w, l, row);
    // A row without circles has no groups with contacts: an arena that is smaller than its torus leaves many empty.
    int columns = cells.from < cells.to ? w->levels->columnCount[l] : 0;
    for (int odd = 0; odd < 2; odd++) {
        for (int column = odd; column < columns && !f->crowded; column += 2) {
            int hits = findGroup(w, f, l, row, column);
            if (w->k.filtering) {
                gatherHits(w, f, hits, true, false);
            } else {
                gatherHits(w, f, hits, false, false);
            }
            if (hasToDeal(f) || column + 2 >= columns) deal(w, f);
        }
    }
    noteRow(w, rowNumber(w, l, row), min(first, f->endWide), min(f->wide, f->endWide));
}
