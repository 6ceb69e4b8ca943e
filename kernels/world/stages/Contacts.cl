// uses: world/shared/PairRule.cl world/shared/Contact.cl world/shared/Cross.cl world/stages/PairFilter.cl world/stages/ContinuousCollision.cl
// Stage Contacts: lists the pairs of circles that may meet within the step, in the one order that every sum follows: by colour, group,
// lower id, higher id; behind them those of circles of different levels, by light circle. The Java class world.jvm.Contacts explains
// groups and colours, CrossContacts those behind them.

// What a circle looks with.
typedef struct {
    float x, y, speculativeDistance, inverseMass;
    int slot, level, column, row;
    int part, parts; // of several work-items that look for one circle: which, and how many
    bool oneLevel;   // see recordContactAt
} Seeker;

// What a work-group has found: the circles that looked, and what they saw. What there is no room for is recorded at once.
#define FINDINGS 1024
typedef struct {
    int2 slots[FINDINGS];
    int count;
    int first; // the number of the first of them among all
} Findings;

// Where a circle finds more circles in a row of cells, the step goes the way of crowds at once; so it does where a group has more
// like contacts: tiles take none with more, of crowds neither.
#define LONGEST_ROW 1024
#define LONGEST_GROUP 4095

int levelOfSlot(const World *w, int slot) {
    return hasOneLevel(w) ? w->levels->used[0] : levelOf(w, w->circle[slot].RADIUS);
}

// Refuses a step that does not thin crowds out.
void refuseCrowd(const World *w) {
    if (w->k.thinning) return;
    w->status[CROWDED] = 1;
    w->status[OUT_OF_ROOM] = 1; // the counts are of no use
}

// The group of a cross contact, which counts for the circle that looked, and for the load of the heavy one.
int recordCross(const World *w, int finer, int coarser) {
    float finerMass = w->sight[finer].SIGHT_INVERSE_MASS;
    float coarserMass = w->sight[coarser].SIGHT_INVERSE_MASS;
    bool isLight = isFinerLight(finerMass, coarserMass);
    int heavy = isLight ? coarser : finer;
    atomic_add(&w->crossLoad[heavy], isLight ? loadOfHeavy(finerMass, coarserMass) : loadOfHeavy(coarserMass, finerMass));
    if (atomic_inc(&w->coarser[finer]) >= CROWD) refuseCrowd(w);
    return crossGroupOf(w, isLight ? finer : coarser);
}

// Counts a contact in its group, and notes it as number k of those found: the circle that looked, the one it saw, the group,
// and how many the group had before. column, row: of the circle that looked, in the level of the other; oneLevel: whether there is no
// more than one, which the kernel of most worlds knows, and has registers less for it.
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
    if ((uint) k < (uint) w->contactRoom) ((global int4 *) w->contact)[k] = (int4)(slot, other, group, rank);
}

void recordContact(const World *w, int k, int slot, int other, bool oneLevel) {
    int level = levelOfSlot(w, other);
    float4 own = w->sight[slot];
    recordContactAt(w, k, slot, other, level, columnOf(w, level, own.x), rowOf(w, level, own.y), oneLevel);
}

// Records what a work-group has found: one after another here, side by side there, and with one use of the counter that all
// work-groups share. All work-items of the work-group.
void recordFindings(const World *w, local Findings *found, bool oneLevel) {
    barrier(CLK_LOCAL_MEM_FENCE);
    if (get_local_id(0) == 0) found->first = atomic_add(&w->status[FOUND], min(found->count, FINDINGS));
    barrier(CLK_LOCAL_MEM_FENCE);
    int count = min(found->count, FINDINGS);
    for (int k = (int) get_local_id(0); k < count; k += (int) get_local_size(0)) {
        recordContact(w, found->first + k, found->slots[k].x, found->slots[k].y, oneLevel);
    }
}

// Whether a pair in a crowd is one of those that are kept.
bool keepsPair(const World *w, const Seeker *s, int other) {
    int id = w->id[s->slot];
    int otherId = w->id[other];
    int hash = pairHash(min(id, otherId), max(id, otherId));
    return keeps(hash, min(w->rank[s->slot], w->rank[other]));
}

// The piece that lies v rows above the seeker. With the seeker's own row: what is left of its own bucket, and the next. Rows
// may span the edge of the torus; so that all work-items of a warp take the same way there, it is not a case of its own.
Piece pieceOf(const World *w, const Seeker *s, int v, bool withOwnRow) {
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
    return pieceOfRanges(from, to);
}

// The slots of the cell that is u columns and v rows from the seeker's own: of its sheet alone, and for a static seeker without static
// circles.
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

// As pieceOf by sheets: the three cells v rows above the seeker; or what is left of its own one and the next.
Piece pieceOfSheets(const World *w, const Seeker *s, int v, bool isOwnRow) {
    Sheets sheets = sheetsAt(w, s->level, s->x, s->y);
    int2 left = isOwnRow ? (int2)(0) : slotsBeside(w, s, &sheets, -1, v);
    int2 middle = slotsBeside(w, s, &sheets, 0, v);
    int2 right = slotsBeside(w, s, &sheets, 1, v);
    if (isOwnRow) middle.x = s->slot + 1;
    return pieceOfRanges((int4)(left.x, middle.x, right.x, 0), (int4)(left.y, middle.y, right.y, 0));
}

// Whether a seeker looks at each cell of a level by itself. haveSheets: whether there are any, which the kernel may know.
bool looksBySheet(const World *w, const Seeker *s, bool haveSheets) {
    return haveSheets && (w->levels->folded[s->level] || s->inverseMass == 0.0f);
}

// Looks at a piece of the neighbourhood, in one loop. found: null where it is but to be known how many there are.
void seek(const World *w, const Seeker *s, const Piece *piece, local Findings *found) {
    int count = piece->end.w;
    if (found == 0) {
        w->rank[s->slot] += count;
        return;
    }
    if (w->k.thinning == 0 && piece->longest > LONGEST_ROW) {
        refuseCrowd(w);
        return;
    }
    for (int i = s->part; i < count; i += s->parts) {
        int other = slotInPiece(piece, i);
        float4 o = w->sight[other];
        if (!isNear(ACROSS_X(w, o.x - s->x), ACROSS_Y(w, o.y - s->y), s->speculativeDistance + o.SIGHT_DISTANCE)) continue;
        if (!mayMeet(w, s->slot, s->inverseMass, other, o.SIGHT_INVERSE_MASS)) continue;
        if (w->k.thinning && !keepsPair(w, s, other)) continue;
        int k = atomic_inc(&found->count);
        if (k < FINDINGS) {
            found->slots[k] = (int2)(s->slot, other);
        } else {
            // By the cells that are known here: to work them out again would take a GPU more registers than all else.
            recordContactAt(w, atomic_inc(&w->status[FOUND]), s->slot, other, s->level, s->column, s->row, s->oneLevel);
        }
    }
}

Seeker seekerOf(const World *w, int slot, bool oneLevel) {
    float4 own = w->sight[slot];
    Seeker s;
    s.x = own.x;
    s.y = own.y;
    s.speculativeDistance = own.SIGHT_DISTANCE;
    s.inverseMass = own.SIGHT_INVERSE_MASS;
    s.slot = slot;
    s.part = 0;
    s.parts = 1;
    s.oneLevel = oneLevel;
    return s;
}

void seekIn(const World *w, Seeker *s, int atLevel) {
    s->level = atLevel;
    s->column = columnOf(w, atLevel, s->x);
    s->row = rowOf(w, atLevel, s->y);
}

// Looks in the cells around a circle. In its own level, half of them, so that each pair is seen once; in a coarser one, 3 x 3 buckets.
// haveSheets: whether there are any, which kernels know: those of worlds without have registers less.
INLINE void seekAround(const World *w, Seeker *s, int atLevel, int own, bool haveSheets, local Findings *found) {
    seekIn(w, s, atLevel);
    bool inOwnLevel = atLevel == own;
    bool bySheet = looksBySheet(w, s, haveSheets);
#pragma unroll 1
    for (int v = inOwnLevel ? (bySheet ? 0 : 1) : -1; v <= 1; v++) {
        Piece piece;
        if (bySheet) {
            piece = pieceOfSheets(w, s, v, inOwnLevel && v == 0);
        } else {
            piece = pieceOf(w, s, v, inOwnLevel);
        }
        seek(w, s, &piece, found);
    }
}

// Looks for the neighbours of a circle; where several work-items share in that: for those of one part.
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

// How many of the slots [from, to) may meet a circle within the step.
int candidatesIn(const World *w, const Seeker *s, int from, int to) {
    int sum = 0;
    for (int other = from; other < to; other++) {
        float4 o = w->sight[other];
        sum += isNear(ACROSS_X(w, o.x - s->x), ACROSS_Y(w, o.y - s->y), s->speculativeDistance + o.SIGHT_DISTANCE) && other != s->slot &&
               mayMeet(w, s->slot, s->inverseMass, other, o.SIGHT_INVERSE_MASS);
    }
    return sum;
}

// Counts the candidates of each circle: those of its own level and of coarser ones that it may meet. Into rank.
// Index space: a working slot a work-item. Cost: the circles of 3 x 3 cells a level.
kernel void contacts_crowd(WORLD_PARAMETERS) {
    World w = WORLD;
    int slot = (int) get_global_id(0);
    if (slot >= circles || refused(&w)) return;
    Seeker s = seekerOf(&w, slot, hasOneLevel(&w));
    int own = levelOfSlot(&w, slot);
    int sum = 0;
    for (int l = levels->usedCount - 1; l >= 0 && levels->used[l] <= own; l--) {
        seekIn(&w, &s, levels->used[l]);
        bool bySheet = looksBySheet(&w, &s, levels->haveSheets != 0);
        Sheets sheets = sheetsAt(&w, s.level, s.x, s.y);
        int cl = levels->columnsLog[s.level];
        for (int v = -1; v <= 1; v++) {
            int row = levels->first[s.level] + (neighbour(s.row, v, levels->rowCount[s.level]) << cl);
            for (int u = -1; u <= 1; u++) {
                int b = row + neighbour(s.column, u, levels->columnCount[s.level]);
                int2 slots = (int2)(w.bucketStart[b], w.bucketStart[b + 1]);
                if (bySheet) slots = slotsBeside(&w, &s, &sheets, u, v);
                sum += candidatesIn(&w, &s, slots.x, slots.y);
            }
        }
    }
    w.rank[slot] = sum;
    if (sum > CROWD) status[CROWDED] = 1;
}

// Finds the contacts, and counts those of each group; notes where there is a crowd, if that is not to be thinned out.
INLINE void countContacts(const World *w, bool haveSheets, local Findings *found) {
    int slot = (int) get_global_id(0);
    if (get_local_id(0) == 0) found->count = 0;
    barrier(CLK_LOCAL_MEM_FENCE);
    if (slot < w->circles && !tooFast(w) && !gridIsEmpty(w)) {
        seekAll(w, slot, 0, 1, true, haveSheets, found);
    }
    recordFindings(w, found, true);
}

// Index space: a working slot a work-item. Cost: the circles of 3 x 3 cells.
kernel void contacts_count(WORLD_PARAMETERS) {
    World w = WORLD;
    local Findings found;
    countContacts(&w, false, &found);
}

// The same, where there are sheets.
kernel void contacts_countBySheet(WORLD_PARAMETERS) {
    World w = WORLD;
    local Findings found;
    countContacts(&w, true, &found);
}

// The same, if there are several levels.
INLINE void countContactsOfLevel(const World *w, bool haveSheets, local Findings *found) {
    int l = (int) get_global_id(0) / w->circles;
    int slot = (int) get_global_id(0) - l * w->circles;
    if (get_local_id(0) == 0) found->count = 0;
    barrier(CLK_LOCAL_MEM_FENCE);
    if (l < w->levels->usedCount && !tooFast(w) && !gridIsEmpty(w)) {
        Seeker s = seekerOf(w, slot, false);
        int own = levelOfSlot(w, slot);
        if (w->levels->used[l] <= own) seekAround(w, &s, w->levels->used[l], own, haveSheets, found);
    }
    recordFindings(w, found, false);
}

// Index space: a working slot and a level a work-item, level after level: a circle that looked in all levels by itself would take
// several times as long. Cost: the circles of 3 x 3 cells.
kernel void contacts_countByLevel(WORLD_PARAMETERS) {
    World w = WORLD;
    local Findings found;
    countContactsOfLevel(&w, false, &found);
}

// The same, where there are sheets.
kernel void contacts_countByLevelAndSheet(WORLD_PARAMETERS) {
    World w = WORLD;
    local Findings found;
    countContactsOfLevel(&w, true, &found);
}

// Whether the contacts that were counted do not fit.
bool lackContactRoom(const World *w) { return contactsListed(w) > w->contactRoom; }

// Notes how many contacts there are, and refuses the step where they do not fit.
void noteContacts(const World *w) {
    if (refused(w)) return;
    w->status[CONTACTS] = contactsListed(w);
    if (lackContactRoom(w)) w->status[OUT_OF_ROOM] = 1;
}

// By tiles, contacts as they are listed: ids as in key, slots as in pair. Together, since a store of 16 bytes to a place of its
// own takes no longer than one of 8.
global ulong2 *listedOf(const World *w) { return (global ulong2 *) w->base; }

// Lists a contact that was found.
void listContact(const World *w, int k) {
    int4 found = ((global const int4 *) w->contact)[k];
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

// Lists the contacts, group by group, in no order within a group; or notes that there is no room for them.
// Index space: any number of work-items, which take the contacts in turn.
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

// Orders contacts by (lower id, higher id): insertion sort, or heap sort where they are many.
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

// The impulse with which a contact ended the step before, or 0.
float cachedImpulse(const World *w, int first, int higherId) {
    for (int c = first; c >= 0;) {
        int4 entry = w->impulseCache[c];
        if (entry.CACHED_HIGHER_ID == higherId) return as_float(entry.CACHED_IMPULSE);
        c = entry.CACHED_NEXT;
    }
    return 0.0f;
}

// The same of a contact that starts a step; 0 if a circle is new.
float warmStartImpulse(const World *w, uint lo, uint hi, ulong ids) {
    return w->firstCached[hi] == FRESH ? 0.0f : cachedImpulse(w, w->firstCached[lo], (int) ids) * w->warmScale;
}

// Adds a contact's impulse to the sums of its circles, and marks them as loaded where it carries.
void gatherLoad(const World *w, uint2 p, float nx, float ny, float normalImpulse, bool carrying) {
    float4 lo = w->load[p.LOWER];
    float4 hi = w->load[p.HIGHER];
    lo.IMPULSES.x -= nx * normalImpulse;
    lo.IMPULSES.y -= ny * normalImpulse;
    hi.IMPULSES.x += nx * normalImpulse;
    hi.IMPULSES.y += ny * normalImpulse;
    if (carrying) {
        lo.LOADED_NEXT = 1.0f;
        hi.LOADED_NEXT = 1.0f;
    }
    w->load[p.LOWER] = lo;
    w->load[p.HIGHER] = hi;
}

// Measures a contact: n. b: difference of the bases x, y, sum of the radii; mi, mj: motion of its circles. Returns whether
// there is a direction.
bool measureContact(float4 b, float4 mi, float4 mj, float4 *n) {
    float x = n->NORMAL_X;
    float y = n->NORMAL_Y;
    float separation;
    bool apart = measure(b.BASE_X, b.BASE_Y, mj.DX - mi.DX, mj.DY - mi.DY, b.RADII, &x, &y, &separation);
    *n = (float4)(x, y, separation, n->NORMAL_IMPULSE);
    return apart;
}

// A contact as it starts the step: normal, separation, the impulse with which it ended the step before; and whether it
// carries. b: difference of the bases x, y, sum of the radii, restitution.
float4 newContact(const World *w, uint2 p, ulong ids, float4 b, bool *carrying) {
    float4 mi = w->motion[p.LOWER];
    float4 mj = w->motion[p.HIGHER];
    float4 n = (float4)(0.0f);
    if (!measureContact(b, mi, mj, &n)) n.NORMAL = partingNormal(ids);
    n.NORMAL_IMPULSE = warmStartImpulse(w, p.LOWER, p.HIGHER, ids);
    float vn = along(n.NORMAL_X, n.NORMAL_Y, mj.VX - mi.VX, mj.VY - mi.VY);
    *carrying = carries(n.NORMAL_IMPULSE, vn, restingLimit(n.SEPARATION, restitutionThreshold(&w->k, b.RADII, b.PAIR_RESTITUTION)));
    return n;
}

// The difference of the bases x, y of a pair, the sum of the radii, the restitution.
float4 baseOfPair(const World *w, uint2 p) {
    float4 ci = w->circle[p.LOWER];
    float4 cj = w->circle[p.HIGHER];
    return (float4)(ACROSS_X(w, cj.x - ci.x), ACROSS_Y(w, cj.y - ci.y), ci.RADIUS + cj.RADIUS, greatest(w->traits[p.LOWER].RESTITUTION, w->traits[p.HIGHER].RESTITUTION));
}

// Fills a contact and measures it for the first sub-step.
void fillContact(const World *w, int c) {
    uint2 p = w->pair[c];
    float4 b = baseOfPair(w, p);
    bool carrying;
    float4 n = newContact(w, p, w->key[c], b, &carrying);
    w->base[c] = b;
    w->masses[c] = (float4)(w->traits[p.LOWER].INVERSE_MASS, w->traits[p.HIGHER].INVERSE_MASS, pushSpeed(&w->k, b.RADII), 0.0f);
    w->contact[c] = n;
    gatherLoad(w, p, n.NORMAL_X, n.NORMAL_Y, n.NORMAL_IMPULSE, carrying);
}

// Counts a like contact as a candidate of its circles, where no other work-item has any of the same circles. Returns the greater count,
// with the contacts that a circle found in coarser levels.
float countCandidate(const World *w, uint2 p) {
    float lo = w->load[p.LOWER].CANDIDATES += 1.0f;
    float hi = w->load[p.HIGHER].CANDIDATES += 1.0f;
    return hasOneLevel(w) ? greatest(lo, hi) : greatest(lo + (float) w->coarser[p.LOWER], hi + (float) w->coarser[p.HIGHER]);
}

// Orders and fills the contacts of the groups of one colour; notes where there is a crowd, if that is not to be thinned out.
// Index space: a group a work-item. Cost: its contacts.
kernel void contacts_fill(WORLD_PARAMETERS, int colour) {
    World w = WORLD;
    int g = (int) get_global_id(0);
    int groups = likeGroups(&w) >> 2;
    if (g >= groups || outOfRoom(&w) || tooFast(&w)) return;
    int group = colour * groups + g;
    int from = w.groupStart[group];
    int to = w.groupStart[group + 1];
    if (from == to) return;
    sortContacts(w.key + from, w.pair + from, to - from);
    float most = 0.0f;
    for (int c = from; c < to; c++) {
        fillContact(&w, c);
        if (w.k.thinning == 0) most = greatest(most, countCandidate(&w, w.pair[c]));
    }
    if (most > (float) CROWD) status[CROWDED] = 1;
}

// How many pairs the broad phase tested for each circle in the last step: into rank. Index space: a working slot a
// work-item.
kernel void contacts_candidates(WORLD_PARAMETERS) {
    World w = WORLD;
    int slot = (int) get_global_id(0);
    if (slot >= circles) return;
    w.rank[slot] = 0;
    seekAll(&w, slot, 0, 1, hasOneLevel(&w), levels->haveSheets != 0, 0);
}

// How many contacts each circle had in the last step. Index space: a contact a work-item.
kernel void contacts_degrees(global const uint2 *pair, int contacts, global int *degree) {
    int c = (int) get_global_id(0);
    if (c >= contacts) return;
    atomic_inc(&degree[pair[c].LOWER]);
    atomic_inc(&degree[pair[c].HIGHER]);
}
