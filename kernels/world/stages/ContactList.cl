// uses: world/shared/CrossRule.cl world/stages/World.cl
// Stage Contacts, its lists, in the one order that every sum follows: colour, group, lower id, higher id; behind them cross contacts, by
// light circle. The Java classes Contacts and CrossContacts explain it.

// What a work-group has found: who looked, whom it saw. Beyond this room it is recorded at once.
#define FINDINGS 1024
typedef struct {
    int2 slots[FINDINGS];
    int count;
    int first; // its number among all
} Findings;

// A longer row or group sends the step the way of crowds at once: tiles take none.
#define LONGEST_ROW 1024
#define LONGEST_GROUP 4095

int levelOfSlot(const World *w, int slot) {
    return hasOneLevel(w) ? w->levels->used[0] : levelOf(w, w->circle[slot].RADIUS);
}

// If the step does not thin crowds out.
void refuseCrowd(const World *w) {
    if (w->k.thinning) return;
    w->status[CROWDED] = 1;
    w->status[OUT_OF_ROOM] = 1; // the counts are of no use
}

// Counts for the circle that looked, and for the load of the heavy one.
int recordCross(const World *w, int finer, int coarser) {
    float finerMass = w->sight[finer].SIGHT_INVERSE_MASS;
    float coarserMass = w->sight[coarser].SIGHT_INVERSE_MASS;
    bool isLight = isFinerLight(finerMass, coarserMass);
    int heavy = isLight ? coarser : finer;
    atomic_add(&w->crossLoad[heavy], isLight ? loadOfHeavy(finerMass, coarserMass) : loadOfHeavy(coarserMass, finerMass));
    if (atomic_inc(&w->coarser[finer]) >= CROWD) refuseCrowd(w);
    return crossGroupOf(w, isLight ? finer : coarser);
}

// Counts contact k in its group. column, row: of the circle that looked, in the level of the other; oneLevel: known when most kernels are
// compiled, for fewer registers.
void recordContactAt(const World *w, int k, int slot, int other, int level, int column, int row, bool oneLevel) {
    constant Levels *levels = w->levels;
    int cl = levels->columnsLog[level];
    int bucket = w->bucketOf[other] - levels->first[level];
    int ox = ringFirst(column, bucket & ((1 << cl) - 1), levels->columnCount[level]);
    int oy = ringFirst(row, bucket >> cl, levels->rowCount[level]);
    bool isLike = oneLevel || w->bucketOf[slot] >= levels->first[level];
    int group = isLike ? groupOf(w, level, ox, oy) : recordCross(w, slot, other);
    int rank = atomic_inc(&w->tally[group]);
    if (rank >= LONGEST_GROUP && isLike) refuseCrowd(w);
    if ((uint) k < (uint) w->contactRoom) foundOf(w)[k] = (int4)(slot, other, group, rank);
}

void recordContact(const World *w, int k, int slot, int other, bool oneLevel) {
    int level = levelOfSlot(w, other);
    float4 own = w->sight[slot];
    recordContactAt(w, k, slot, other, level, ringOf(axisX(w, level), own.x), ringOf(axisY(w, level), own.y), oneLevel);
}

// One use of the counter that all work-groups share. All work-items of the work-group.
void recordFindings(const World *w, local Findings *found, bool oneLevel) {
    barrier(CLK_LOCAL_MEM_FENCE);
    if (get_local_id(0) == 0) found->first = atomic_add(&w->status[FOUND], min(found->count, FINDINGS));
    barrier(CLK_LOCAL_MEM_FENCE);
    int count = min(found->count, FINDINGS);
    for (int k = (int) get_local_id(0); k < count; k += (int) get_local_size(0)) {
        recordContact(w, found->first + k, found->slots[k].x, found->slots[k].y, oneLevel);
    }
}

// Piece contacts have as much room.
bool lackContactRoom(const World *w) {
    IF_TERRAIN(if (w->status[PIECES_FOUND] > w->contactRoom) return true;)
#ifdef SLEEPING
    // Impulses of pairs at rest come behind those of contacts.
    return contactsListed(w) + w->status[KEPT_COUNT] > w->contactRoom;
#else
    return contactsListed(w) > w->contactRoom;
#endif
}

void noteContacts(const World *w) {
    if (refused(w)) return;
    w->status[CONTACTS] = contactsListed(w);
    if (lackContactRoom(w)) w->status[OUT_OF_ROOM] = 1;
}

void listContact(const World *w, int k) {
    int4 found = foundOf(w)[k];
    int place = w->groupStart[found.z] + found.w;
    uint own = (uint) w->id[found.x];
    uint other = (uint) w->id[found.y];
    ulong ids = (ulong) min(own, other) << 32 | max(own, other);
    uint2 slots = own < other ? (uint2)((uint) found.x, (uint) found.y) : (uint2)((uint) found.y, (uint) found.x);
    if (w->k.tiled && place < w->groupStart[likeGroups(w)]) {
        listedOf(w)[place] = (ulong2)(ids, as_ulong(slots));
    } else {
        w->key[place] = ids;
        w->pair[place] = slots;
    }
}

// Group by group, in no order within a group. Index space: any; work-items take contacts in turn.
kernel void contacts_list(WORLD_PARAMETERS) {
    World w = WORLD;
    if (get_global_id(0) == 0) noteContacts(&w);
    if (lackContactRoom(&w) || refused(&w)) return;
    int contacts = contactsListed(&w);
    for (int k = (int) get_global_id(0); k < contacts; k += (int) get_global_size(0)) listContact(&w, k);
}

void siftContactDown(global ulong *key, global uint2 *pair, int top, int size) {
    ulong key1 = key[top];
    uint2 pair1 = pair[top];
    for (int child = 2 * top + 1; child < size; child = 2 * top + 1) {
        if (child + 1 < size && key[child + 1] > key[child]) child++;
        if (key[child] <= key1) break;
        key[top] = key[child];
        pair[top] = pair[child];
        top = child;
    }
    key[top] = key1;
    pair[top] = pair1;
}

// By (lower id, higher id): insertion sort; heap sort if they are many.
void sortContacts(global ulong *key, global uint2 *pair, int size) {
    if (size > 48) {
        for (int top = size / 2 - 1; top >= 0; top--) siftContactDown(key, pair, top, size);
        for (int end = size - 1; end > 0; end--) {
            ulong key1 = key[end];
            uint2 pair1 = pair[end];
            key[end] = key[0];
            pair[end] = pair[0];
            key[0] = key1;
            pair[0] = pair1;
            siftContactDown(key, pair, 0, end);
        }
        return;
    }
    for (int i = 1; i < size; i++) {
        ulong key1 = key[i];
        uint2 pair1 = pair[i];
        int p = i;
        while (p > 0 && key[p - 1] > key1) {
            key[p] = key[p - 1];
            pair[p] = pair[p - 1];
            p--;
        }
        key[p] = key1;
        pair[p] = pair1;
    }
}
