// Stage Contacts where all circles are of one level: the same list as Contacts.cl makes, made by the groups. The contacts of
// a group are the pairs within its first cell, of that cell and the other three, and of the cell beside it and the one
// above it.

// The slots of a group's four cells: [x, y) each.
typedef struct {
    int2 own, right, above, diagonal;
} GroupCells;

int2 slotsOf(const World *w, int bucket) { return (int2)(w->bucketStart[bucket], w->bucketStart[bucket + 1]); }

GroupCells cellsOfGroup(const World *w, int group) {
    int l = w->levels->used[0];
    int first = w->levels->first[l];
    int cl = w->levels->columnsLog[l];
    int rl = w->levels->rowsLog[l];
    int number = group - first;
    int colour = number >> (cl + rl - 2);
    int within = number & ((1 << (cl + rl - 2)) - 1);
    int column = 2 * (within & ((1 << (cl - 1)) - 1)) + (colour & 1);
    int row = 2 * (within >> (cl - 1)) + (colour >> 1);
    int right = (column + 1) & ((1 << cl) - 1);
    int here = first + (row << cl);
    int above = first + (((row + 1) & ((1 << rl) - 1)) << cl);
    GroupCells cells;
    cells.own = slotsOf(w, here + column);
    cells.right = slotsOf(w, here + right);
    cells.above = slotsOf(w, above + column);
    cells.diagonal = slotsOf(w, above + right);
    return cells;
}

// Tests one circle against the slots [x, y): counts the contacts, or lists them at a place. Returns the next place.
int pairUp(const World *w, int slot, int2 others, bool listing, int place) {
    if (others.x >= others.y) return place;
    float4 c = w->circle[slot];
    float4 m = w->motion[slot];
    float reach = w->reachOf[slot];
    for (int other = others.x; other < others.y; other++) {
        float4 oc = w->circle[other];
        float4 om = w->motion[other];
        float ux = difference(oc.x - c.x, m.x, om.x);
        float uy = difference(oc.y - c.y, m.y, om.y);
        float limit = reach + w->reachOf[other];
        if (!(ux * ux + uy * uy < limit * limit)) continue;
        if (w->traits[slot].x == 0.0f && w->traits[other].x == 0.0f) continue;
        if (listing) {
            uint id = (uint) w->id[slot];
            uint otherId = (uint) w->id[other];
            bool lower = id < otherId;
            w->key[place] = lower ? (ulong) id << 32 | otherId : (ulong) otherId << 32 | id;
            w->pair[place] = lower ? (uint2)((uint) slot, (uint) other) : (uint2)((uint) other, (uint) slot);
        }
        place++;
    }
    return place;
}

int pairUpGroup(const World *w, int group, bool listing, int place) {
    GroupCells cells = cellsOfGroup(w, group);
    for (int slot = cells.own.x; slot < cells.own.y; slot++) {
        place = pairUp(w, slot, (int2)(slot + 1, cells.own.y), listing, place);
        place = pairUp(w, slot, cells.right, listing, place);
        place = pairUp(w, slot, cells.above, listing, place);
        place = pairUp(w, slot, cells.diagonal, listing, place);
    }
    for (int slot = cells.right.x; slot < cells.right.y; slot++) place = pairUp(w, slot, cells.above, listing, place);
    return place;
}

// Counts the contacts of a group.
void countGroup(const World *w, int group) { w->groupStart[group] = pairUpGroup(w, group, false, 0); }

// Notes how many circles a tile's region holds at most, and refuses the step where they are too many.
void checkTile(const World *w, int tile) {
    Region r = regionOf(w, tile);
    int circles = 0;
    int split;
    for (int row = 0; row < r.rows; row++) circles += circlesInRow(w, &r, row, &split);
    atomic_max(&w->status[TILE_PEAK], circles);
    if (circles > TILE_CIRCLES) w->status[OUT_OF_ROOM] = 1;
}

// Index space: a group a work-item; the first of them check the tiles too. Cost: the pairs of circles of 2 x 2 cells.
kernel void contacts_countGroups(WORLD_PARAMETERS) {
    World w = WORLD;
    int group = (int) get_global_id(0);
    if (group >= levels->first[LEVELS] || outOfRoom(&w)) return;
    if (group < tileCount(&w)) checkTile(&w, group);
    countGroup(&w, group);
}

// Lists the contacts of a group in order.
void listGroup(const World *w, int group) {
    int from = w->groupStart[group];
    int to = w->groupStart[group + 1];
    if (from == to) return;
    pairUpGroup(w, group, true, from);
    sortContacts(w->key + from, w->pair + from, to - from);
}

// Index space: a group a work-item. Cost: as contacts_countGroups.
kernel void contacts_listGroups(WORLD_PARAMETERS) {
    World w = WORLD;
    int group = (int) get_global_id(0);
    if (group >= levels->first[LEVELS]) return;
    if (lackContactRoom(&w)) {
        if (group == 0) noteContactsNeeded(&w);
        return;
    }
    if (!outOfRoom(&w)) listGroup(&w, group);
}

// Measures a contact for the first sub-step, and links it to its circles.
void linkContact(const World *w, int c) {
    int l = w->levels->used[0];
    int first = w->levels->first[l];
    int cl = w->levels->columnsLog[l];
    int columnMask = (1 << cl) - 1;
    uint2 p = w->pair[c];
    int low = w->bucketOf[p.x];
    int high = w->bucketOf[p.y];
    int lowColumn = (low - first) & columnMask;
    int highColumn = (high - first) & columnMask;
    int lowRow = (low - first) >> cl;
    int highRow = (high - first) >> cl;
    int column = ringFirst(lowColumn, highColumn, columnMask);
    int row = ringFirst(lowRow, highRow, (1 << w->levels->rowsLog[l]) - 1);
    bool carrying;
    w->contact[c] = newContact(w, p, w->key[c], &carrying);
    w->link[c] = linkOf((lowColumn != column) + 2 * (lowRow != row), (int) p.x - w->bucketStart[low],
                        (highColumn != column) + 2 * (highRow != row), (int) p.y - w->bucketStart[high], carrying);
}

// Index space: any number of work-items, which take the contacts in turn. Cost: its circles, and what was remembered of the
// lower.
kernel void contacts_link(WORLD_PARAMETERS) {
    World w = WORLD;
    if (outOfRoom(&w)) return;
    int contacts = groupStart[levels->first[LEVELS]];
    for (int c = (int) get_global_id(0); c < contacts; c += (int) get_global_size(0)) linkContact(&w, c);
}
