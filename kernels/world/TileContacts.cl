// Stage Contacts for tiles: lists the contacts group by group, those of a group by (lower id, higher id); then looks at each.
// The groups stand in no order: a contact's number shows nowhere.

#define LONGEST_GROUP 512  // contacts
#define FULLEST_GROUP 128  // circles; what is more crowded goes the way of crowds
#define NO_ID 0x7fffffff

// The circles of the 2 x 2 cells of a group, to be taken by id.
typedef struct {
    int4 at, end, id; // by cell: the next slot, the last, the id of the next or NO_ID
} Heads;

// The cell that has the lowest id: its column, and twice its row.
int lowestCell(const Heads *h) {
    int xy = h->id.x < h->id.y ? 0 : 1;
    int zw = h->id.z < h->id.w ? 2 : 3;
    return min(h->id.x, h->id.y) < min(h->id.z, h->id.w) ? xy : zw;
}

bool areThrough(const Heads *h) { return min(min(h->id.x, h->id.y), min(h->id.z, h->id.w)) == NO_ID; }

// Takes the next circle of a cell: returns its slot.
int takeFrom(const World *w, Heads *h, int cell) {
    int slot = cell == 0 ? h->at.x : cell == 1 ? h->at.y : cell == 2 ? h->at.z : h->at.w;
    int end = cell == 0 ? h->end.x : cell == 1 ? h->end.y : cell == 2 ? h->end.z : h->end.w;
    int id = slot + 1 < end ? w->id[slot + 1] : NO_ID;
    if (cell == 0) {
        h->at.x = slot + 1;
        h->id.x = id;
    } else if (cell == 1) {
        h->at.y = slot + 1;
        h->id.y = id;
    } else if (cell == 2) {
        h->at.z = slot + 1;
        h->id.z = id;
    } else {
        h->at.w = slot + 1;
        h->id.w = id;
    }
    return slot;
}

int headOf(const Heads *h, int cell) { return cell == 0 ? h->id.x : cell == 1 ? h->id.y : cell == 2 ? h->id.z : h->id.w; }

int startOf(int4 starts, int cell) { return cell == 0 ? starts.x : cell == 1 ? starts.y : cell == 2 ? starts.z : starts.w; }

// The cells of the group that begins in a bucket.
Heads headsOf(const World *w, int bucket) {
    int l = w->levels->used[0];
    int first = w->levels->first[l];
    int cl = w->levels->columnsLog[l];
    int columnMask = (1 << cl) - 1;
    int column = (bucket - first) & columnMask;
    int row = (bucket - first) >> cl;
    int right = (column + 1) & columnMask;
    int own = first + (row << cl);
    int above = first + (((row + 1) & ((1 << w->levels->rowsLog[l]) - 1)) << cl);
    Heads h;
    h.at = (int4)(w->bucketStart[own + column], w->bucketStart[own + right], w->bucketStart[above + column],
                  w->bucketStart[above + right]);
    h.end = (int4)(w->bucketStart[own + column + 1], w->bucketStart[own + right + 1],
                   w->bucketStart[above + column + 1], w->bucketStart[above + right + 1]);
    h.id = (int4)(h.at.x < h.end.x ? w->id[h.at.x] : NO_ID, h.at.y < h.end.y ? w->id[h.at.y] : NO_ID,
                  h.at.z < h.end.z ? w->id[h.at.z] : NO_ID, h.at.w < h.end.w ? w->id[h.at.w] : NO_ID);
    return h;
}

// Visits the contacts of a group in order. from: the first's number, or -1 where they are only counted. Returns how many there
// are.
int visitGroup(const World *w, Heads lows, int from) {
    int4 starts = lows.at;
    int count = 0;
    while (!areThrough(&lows)) {
        int lowCell = lowestCell(&lows);
        int lowId = headOf(&lows, lowCell);
        int low = takeFrom(w, &lows, lowCell);
        float4 s = w->sight[low];
        Heads highs = lows;
        while (!areThrough(&highs)) {
            int highCell = lowestCell(&highs);
            int highId = headOf(&highs, highCell);
            int high = takeFrom(w, &highs, highCell);
            // The lesser column and the lesser row must be the group's own.
            if (lowCell & highCell) continue;
            float4 o = w->sight[high];
            float dx = o.x - s.x;
            float dy = o.y - s.y;
            float limit = s.z + o.z;
            if (!(dx * dx + dy * dy < limit * limit)) continue;
            if (s.w == 0.0f && o.w == 0.0f) continue;
            if (from >= 0) {
                int c = from + count;
                w->key[c] = (ulong) (uint) lowId << 32 | (uint) highId;
                w->pair[c] = (uint2)((uint) low, (uint) high);
                w->link[c] = linkOf(lowCell & 1, lowCell & 2, low - startOf(starts, lowCell), highCell & 1,
                                    highCell & 2, high - startOf(starts, highCell), false);
            }
            count++;
        }
    }
    return count;
}

// Lists the contacts of the groups of as many buckets as the work-group has work-items. room: two ints.
void listGroups(const World *w, int firstBucket, int buckets, local int *room) {
    int bucket = firstBucket + (int) get_local_id(0);
    bool any = bucket < buckets;
    barrier(CLK_LOCAL_MEM_FENCE);
    if (get_local_id(0) == 0) room[0] = 0;
    barrier(CLK_LOCAL_MEM_FENCE);
    Heads heads;
    int count = 0;
    if (any) {
        heads = headsOf(w, bucket);
        int4 circles = heads.end - heads.at;
        any = circles.x + circles.y + circles.z + circles.w <= FULLEST_GROUP;
        if (any) count = visitGroup(w, heads, -1);
        if (!any || count > LONGEST_GROUP) w->status[CROWDED] = 1;
    }
    int before = atomic_add(&room[0], count);
    barrier(CLK_LOCAL_MEM_FENCE);
    if (get_local_id(0) == 0) room[1] = atomic_add(&w->status[CONTACTS], room[0]);
    barrier(CLK_LOCAL_MEM_FENCE);
    if (bucket >= buckets) return;
    int from = room[1] + before;
    int l = w->levels->used[0];
    int inLevel = bucket - w->levels->first[l];
    int cl = w->levels->columnsLog[l];
    int group = groupOf(w, l, inLevel & ((1 << cl) - 1), inLevel >> cl);
    if (from + count > w->contactRoom) {
        w->status[OUT_OF_ROOM] = 1;
        count = 0;
    }
    w->groupStart[group] = from;
    w->groupFill[group] = from + count;
    if (count > 0) visitGroup(w, heads, from);
}

// Index space: a bucket a work-item. Cost: the pairs of circles in 2 x 2 cells, twice.
kernel __attribute__((reqd_work_group_size(TILE_GROUP, 1, 1))) void contacts_group(WORLD_PARAMETERS) {
    World w = WORLD;
    local int room[2];
    // Where the step has been refused earlier, all buckets are empty.
    int buckets = tooFast(&w) ? 0 : levels->first[LEVELS];
    listGroups(&w, (int) (get_group_id(0) * get_local_size(0)), buckets, room);
}

// Measures a listed contact for the first sub-step, with the impulse that it ended the step before with.
void linkContact(const World *w, int c) {
    bool carrying;
    float4 n = newContact(w, w->pair[c], w->key[c], &carrying);
    w->contact[c] = n;
    if (carrying) w->link[c] |= LINK_CARRYING;
}

// Index space: any number of work-items, which take the contacts in turn. Cost: the contacts remembered of a circle.
kernel void contacts_link(WORLD_PARAMETERS) {
    World w = WORLD;
    if (refused(&w)) return;
    int contacts = status[CONTACTS];
    for (int c = (int) get_global_id(0); c < contacts; c += (int) get_global_size(0)) linkContact(&w, c);
}
