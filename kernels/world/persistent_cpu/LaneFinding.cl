// uses: world/persistent_cpu/LaneMover.cl world/persistent_cpu/LaneCrowds.cl world/persistent_cpu/LaneCross.cl
// uses: world/persistent_cpu/LaneTouches.cl
// Finds the contacts of a row of groups and lays them out as wide contacts. A group finds the pairs whose lesser column and
// lesser row are its own in its 2 x 2 cells, so each pair is found once, and by the work-group that will solve it. Groups of
// the same parity of columns share no circle: their contacts, each group's in order, are dealt to wide contacts in turn. The
// more groups are dealt together, the fewer lanes stay empty.

// Orders pairs by their ids, where they are too many for gatherHits to do it (Shell sort).
void sortPairs(ulong *ids, ulong *slots, int count) {
    for (int gap = count / 2; gap > 0; gap = gap > 2 ? gap * 5 / 11 : gap - 1) {
        for (int k = gap; k < count; k++) {
            ulong id = ids[k];
            ulong slot = slots[k];
            int p = k;
            for (; p >= gap && ids[p - gap] > id; p -= gap) {
                ids[p] = ids[p - gap];
                slots[p] = slots[p - gap];
            }
            ids[p] = id;
            slots[p] = slot;
        }
    }
}

#define SORTED_AS_THEY_COME 32 // pairs of a group

// Puts the pairs that were hit among those gathered, in order of their ids. choosing: whether some may not meet for their kinds, or are
// left out in a crowd; cross: whether they are cross contacts of one light circle, which looked; see LIGHT_IS_HIGHER.
INLINE void gatherHits(const World *w, Search *f, int hits, bool choosing, bool cross) {
    bool asTheyCome = hits <= SORTED_AS_THEY_COME;
    int from = f->gathered;
    int count = from;
    for (int k = 0; k < hits; k++) {
        int slot = (int) (f->hit[k] >> 32);
        int other = (int) f->hit[k];
        if (!mayMeetIf(w, choosing && w->k.filtering, slot, w->traits[slot].x, other, w->traits[other].x)) continue;
        if (choosing && !keepsPairByLanes(w, slot, other)) continue;
        int id = w->id[slot];
        int otherId = w->id[other];
        // Exchanged where the other has the lower id; no branch, which would be taken as if by chance.
        int exchange = (slot ^ other) & ((otherId - id) >> 31);
        ulong ids = (ulong) min(id, otherId) << 32 | (uint) max(id, otherId);
        ulong slots = (ulong) (slot ^ exchange) << 32 | (uint) (other ^ exchange);
        if (cross && otherId < id) slots |= LIGHT_IS_HIGHER;
        // Exchanged with every pair that comes after it. No branch: where it comes to stand is as good as random.
        for (int p = from; p < count && asTheyCome; p++) {
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
    if (!asTheyCome) sortPairs(f->ids + from, f->slots + from, count - from);
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
            if (w->k.filtering || w->k.thinning) {
                gatherHits(w, f, hits, true, false);
            } else {
                gatherHits(w, f, hits, false, false);
            }
            if (hasToDeal(f) || column + 2 >= columns) deal(w, f);
        }
    }
    noteRow(w, rowNumber(w, l, row), min(first, f->endWide), min(f->wide, f->endWide));
}
