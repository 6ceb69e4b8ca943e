// uses: world/tiles/TileCircles.cl world/tiles/TileContacts.cl world/tiles/TileCuts.cl
// Stage Contacts by tiles: orders a tile's contacts once a step, starts its circles, writes its record. Cost: the circles of a region, and
// its contacts one after another in their groups.

typedef struct {
    union {
        struct {
            uint place[TILE_ROUNDS + 1];       // by round: of its next own contact (lower half), next other one
            uchar roundParts[TILE_ROUNDS + 1]; // by round: its parts
        } met;
        struct { // when all have been placed
            float radius[TILE_CIRCLES], inverseMass[TILE_CIRCLES], restitution[TILE_CIRCLES];
            int slot[TILE_CIRCLES];
        } circle;
    } of;
    ushort cellStart[TILE_CELLS + 1]; // by cell: its first circle, row by row
    int rowStart[TILE_ROWS + 1];      // by row: its first circle
    int4 rowSlots[TILE_ROWS];         // by row: see slotsInRow
    float2 load[TILE_CIRCLES];        // by circle: sums of impulses; later its base
    IF_TURNING(float spin[TILE_CIRCLES];) // by circle: sums of impulses on the surface speed
    ushort progress[TILE_CIRCLES];     // by circle: see below
    int roundCount[TILE_ROUNDS + 1];   // by round: own contacts (lower half), others
    short ownNumber[TILE_ROUNDS + 1];  // by round: number of an own contact minus its place
    int firstNumber; // of the tile's own contacts
    int firstCopy;
    int contacts; // all that the tile depends on
    int met;      // so far
    int overfull; // too many rounds
    int crowded;  // a circle has too many contacts
    int idle;     // the step had been refused
    int moves;    // a circle of its own may move
} Arrangement;

// The first round in which a circle is free, its contacts so far (at most MOST_MET), whether one carries.
#define FREE_ROUND 0x1ff
#define MET_SHIFT 9
#define MOST_MET 0x3f
#define HAS_CARRIED 0x8000
#if TILE_ROUNDS > FREE_ROUND || CROWD >= MOST_MET
#error "a circle's progress has no room for so many"
#endif

int metSoFar(int progress) { return progress >> MET_SHIFT & MOST_MET; }

int progressAfter(int progress, int round, int carried) {
    int met = min(metSoFar(progress) + 1, MOST_MET);
    return (progress & HAS_CARRIED) | carried | met << MET_SHIFT | (round + 1);
}

// All work-items of the work-group; returns how many there are.
int numberCircles(const World *w, const Region *r, local Arrangement *a, global int *record) {
    int item = (int) get_local_id(0);
    barrier(CLK_LOCAL_MEM_FENCE);
    if (item < r->rows) a->rowSlots[item] = slotsInRow(w, r, item);
    if (item == 0) {
        a->contacts = 0;
        a->met = 0;
        a->overfull = 0;
        a->crowded = 0;
        a->moves = 0;
    }
    barrier(CLK_LOCAL_MEM_FENCE);
    if (item <= r->rows) {
        int sum = 0;
#pragma unroll 4
        for (int before = 0; before < item; before++) {
            sum += circlesInRow(a->rowSlots[before]);
        }
        a->rowStart[item] = sum;
    }
    barrier(CLK_LOCAL_MEM_FENCE);
    int circles = a->rowStart[r->rows];
    int cells = circles > TILE_CIRCLES ? 0 : r->columns * r->rows;
#pragma unroll 1
    TILE_EACH(cell, cells) {
        int row = cell / r->columns;
        int inRow = cell - row * r->columns;
        int column = wrapped(r->firstColumn + inRow, r->torusColumns);
        int4 slots = a->rowSlots[row];
        int bucket = bucketOfRow(w, r, row) + column;
        int from = w->bucketStart[bucket];
        int to = w->bucketStart[bucket + 1];
        int i = a->rowStart[row] + from - (column >= r->firstColumn ? slots.x : slots.z - (slots.y - slots.x));
        a->cellStart[cell] = (ushort) i;
        int own = owns(r, inRow, row) ? 0 : NOT_OWN;
        for (int slot = from; slot < to; slot++) record[TILE_AT_SLOTS + i++] = slot | own;
    }
    TILE_EACH(i, min(circles, TILE_CIRCLES)) {
        a->load[i] = (float2)(0.0f);
        IF_TURNING(a->spin[i] = 0.0f;)
        a->progress[i] = 0;
    }
    TILE_EACH(i, TILE_ROUNDS + 1) a->roundCount[i] = 0;
    return circles;
}

int circleOfLink(const Region *r, local const Arrangement *a, int column, int row, uint part) {
    if (part & LINK_COLUMN) column++;
    if (part & LINK_ROW) row++;
    if (r->ringX) column = wrapped(column, r->torusColumns);
    if (r->ringY) row = wrapped(row, r->torusRows);
    return a->cellStart[row * r->columns + column] + (int) (part & LINK_PLACE);
}

// A contact as met, in 32 bits: its group by column (6) and row (4) in the region, its place there (13), its round (9).
#define MET_COLUMN(met) ((int) ((met) & 0x3f))
#define MET_ROW(met) ((int) ((met) >> 6 & 0xf))
#define MET_IN_GROUP(met) ((int) ((met) >> 10 & 0x1fff))
#define MET_ROUND(met) ((int) ((met) >> 23))
#if TILE_COLUMNS > 0x40 || TILE_ROWS > 0x10 || LONGEST_GROUP > 0x1fff
#error "a contact that is met has no room for so many"
#endif
#if TILE_CONTACTS > 0x7fff
#error "places of contacts have no room for so many"
#endif

uint meeting(int column, int row, int inGroup, int round) {
    return (uint) (column | row << 6 | inGroup << 10) | (uint) round << 23;
}

// Where their copies are to be.
global uint *metFrom(const World *w, int firstCopy) { return metOf(w) + 2 * (size_t) firstCopy; }

// Returns whether there is room.
bool takeCopies(const World *w, const Region *r, local Arrangement *a, bool any) {
#pragma unroll 1
    for (int colour = 0; colour < 4; colour++) {
        Groups g = groupsOfColour(r, colour);
        int lines = any ? g.down : 0;
        TILE_EACH(line, lines) atomic_add(&a->contacts, contactsInRow(w, r, &g, line));
    }
    barrier(CLK_LOCAL_MEM_FENCE);
    int contacts = a->contacts;
    bool fits = any && contacts <= TILE_CONTACTS;
    if (get_local_id(0) == 0) {
        a->firstCopy = fits ? atomic_add(&w->status[TILE_COPIES], wholeLines(contacts)) : 0;
    }
    barrier(CLK_LOCAL_MEM_FENCE);
    // Negative if all want more than there can be.
    return fits && (contacts == 0 || (a->firstCopy >= 0 && a->firstCopy <= w->copyRoom - contacts));
}

// k: its place among those met.
void takeContact(const Region *r, local Arrangement *a, global uint *met, int k, int column, int row, int inGroup,
                 uint link, float2 impulse AND_TURNING(float2 spins)) {
    int lo = circleOfLink(r, a, column, row, link);
    int hi = circleOfLink(r, a, column, row, link >> 16);
    int progressLo = a->progress[lo];
    int progressHi = a->progress[hi];
    float2 loadLo = a->load[lo];
    float2 loadHi = a->load[hi];
    a->load[lo] = loadLo - impulse;
    a->load[hi] = loadHi + impulse;
    IF_TURNING(a->spin[lo] += spins.x;)
    IF_TURNING(a->spin[hi] += spins.y;)
    int round = max(progressLo & FREE_ROUND, progressHi & FREE_ROUND);
    if (round >= TILE_ROUNDS) {
        a->overfull = 1;
        return;
    }
    int carried = link & LINK_CARRYING ? HAS_CARRIED : 0;
    a->progress[lo] = (ushort) progressAfter(progressLo, round, carried);
    a->progress[hi] = (ushort) progressAfter(progressHi, round, carried);
    if (max(metSoFar(progressLo), metSoFar(progressHi)) >= CROWD) a->crowded = 1;
    met[k] = meeting(column, row, inGroup, round);
    atomic_add(&a->roundCount[round], owns(r, column, row) ? 1 : 1 << 16);
}

// Contacts that a work-item takes at a time.
#define ARRANGED 3

// Contacts of a group that are read at a time.
#define GROUP_TOGETHER 6

// All that a tile depends on, or none.
void takeContacts(const World *w, const Region *r, local Arrangement *a, bool any) {
    global uint *met = metFrom(w, a->firstCopy);
#pragma unroll 1
    for (int colour = 0; colour < 4; colour++) {
        barrier(CLK_LOCAL_MEM_FENCE);
        Groups of = groupsOfColour(r, colour);
        int groups = any ? of.across * of.down : 0;
#pragma unroll 1
        TILE_EACH(g, groups) {
            int line = g / of.across;
            int column = of.column + 2 * (g - line * of.across);
            int row = of.row + 2 * line;
            int group = groupAt(w, r, column, row);
            int first = w->groupStart[group];
            int size = w->groupStart[group + 1] - first;
            int k0 = size > 0 ? atomic_add(&a->met, size) : 0;
#pragma unroll 1
            for (int from = 0; from < size; from += GROUP_TOGETHER) {
                uint link[GROUP_TOGETHER];
                float2 impulse[GROUP_TOGETHER];
                IF_TURNING(float2 spins[GROUP_TOGETHER];)
#pragma unroll
                for (int k = 0; k < GROUP_TOGETHER; k++) {
                    int c = first + min(from + k, size - 1);
                    link[k] = w->link[c];
                    impulse[k] = startImpulsesOf(w)[c];
                    IF_TURNING(spins[k] = w->startSpins[c];)
                }
#pragma unroll
                for (int k = 0; k < GROUP_TOGETHER; k++) {
                    if (from + k >= size) continue;
                    takeContact(r, a, met, k0 + from + k, column, row, from + k, link[k], impulse[k] AND_TURNING(spins[k]));
                }
            }
        }
    }
    barrier(CLK_LOCAL_MEM_FENCE | CLK_GLOBAL_MEM_FENCE);
}

int contactsOfRound(int count) { return (count & 0xffff) + (count >> 16); }

// In the tile's order and in the numbers of all contacts. rounds: one more than there is room for, or 0.
void placeRounds(const World *w, local Arrangement *a, global int *record, int rounds) {
    int size = (int) get_local_size(0);
    TILE_EACH(round, rounds) a->of.met.roundParts[round] = (uchar) ((contactsOfRound(a->roundCount[round]) + size - 1) / size);
    barrier(CLK_LOCAL_MEM_FENCE);
    TILE_EACH(round, rounds) {
        // Only rounds behind the last are empty.
        if (round > 0 && a->roundCount[round - 1] == 0) continue;
        int sums = 0;
        int part = 0;
#pragma unroll 4
        for (int before = 0; before < round; before++) {
            sums += a->roundCount[before];
            part += a->of.met.roundParts[before];
        }
        int start = contactsOfRound(sums);
        int own = sums & 0xffff;
        int count = a->roundCount[round];
        a->of.met.place[round] = (uint) (start | (start + (count & 0xffff)) << 16);
        a->ownNumber[round] = (short) (own - start);
        for (int first = 0; first < contactsOfRound(count); first += size) record[TILE_AT_STARTS + part++] = start + first;
        if (count > 0) continue;
        record[TILE_AT_STARTS + part] = start;
        record[TILE_AT_PARTS] = part;
        a->firstNumber = atomic_add(&w->status[TILE_NUMBERS], own);
        record[TILE_AT_COPIES] = a->firstCopy;
    }
    barrier(CLK_LOCAL_MEM_FENCE);
}

// By rounds, a round's own ones first, which get their numbers.
void recordContacts(const World *w, const Region *r, local Arrangement *a, global int *record, int circles) {
    global int2 *placed = placedFrom(w, a->firstCopy);
    global const uint *metContacts = metFrom(w, a->firstCopy);
    placeRounds(w, a, record, circles > 0 ? TILE_ROUNDS + 1 : 0);
    if (get_local_id(0) == 0) record[TILE_AT_CIRCLES] = circles;
    int contacts = circles > 0 ? a->contacts : 0;
    TILE_TOGETHER(first, contacts, ARRANGED) {
        uint met[MOST_TOGETHER];
        int c[MOST_TOGETHER];
        uint link[MOST_TOGETHER];
        TOGETHER_EACH(n, ARRANGED) {
            if (togetherItem(first, n) >= contacts) continue;
            met[n] = metContacts[togetherItem(first, n)];
            c[n] = w->groupStart[groupAt(w, r, MET_COLUMN(met[n]), MET_ROW(met[n]))] + MET_IN_GROUP(met[n]);
        }
        TOGETHER_EACH(n, ARRANGED) {
            if (togetherItem(first, n) < contacts) link[n] = w->link[c[n]];
        }
        TOGETHER_EACH(n, ARRANGED) {
            if (togetherItem(first, n) >= contacts) continue;
            int column = MET_COLUMN(met[n]);
            int row = MET_ROW(met[n]);
            int round = MET_ROUND(met[n]);
            int lo = circleOfLink(r, a, column, row, link[n]);
            int hi = circleOfLink(r, a, column, row, link[n] >> 16);
            bool own = owns(r, column, row);
            uint places = atomic_add(&a->of.met.place[round], own ? 1u : 1u << 16);
            int place = (int) (own ? places & 0xffff : places >> 16);
            if (own) numbersOf(w)[c[n]] = a->firstNumber + a->ownNumber[round] + place;
            placed[place] = (int2)(own ? c[n] : c[n] | NOT_OWN, circlesOf(lo, hi, round)); // not yet its number
        }
    }
    barrier(CLK_LOCAL_MEM_FENCE | CLK_GLOBAL_MEM_FENCE);
}

// With several levels, or joints: sums for cross contacts and joints to add to. Refuses a crowd, with the contacts found in coarser levels.
void gatherLoads(const World *w, local const Arrangement *a, global const int *record, int circles) {
    TILE_EACH(i, circles) {
        int slot = record[TILE_AT_SLOTS + i];
        if (slot < 0) continue;
        int progress = a->progress[i];
        w->solvedMotion[slot] = w->motion[slot];
        w->load[slot] = (float4)(a->load[i].x, a->load[i].y, 0.0f, progress & HAS_CARRIED ? 1.0f : 0.0f);
        IF_TURNING(w->spinImpulse[slot] = a->spin[i];)
        IF_TURNING(w->solvedSpin[slot] = w->surfaceSpeed[slot];)
        if (metSoFar(progress) + (hasOneLevel(w) ? 0 : w->coarser[slot]) > CROWD && w->k.thinning == 0) w->status[CROWDED] = 1;
        IF_RECORDING(clearWallTouch(w, slot);)
    }
}

#ifdef TERRAIN
// Starts the tile's own circles near pieces of terrain. Apart: in the loop of the others they would hold registers.
void startAtPieces(const World *w, local Arrangement *a, global int *entries, int circles) {
#pragma unroll 1
    TILE_EACH(i, circles) {
        int slot = entries[i];
        if (slot < 0 || !hasPieces(w, slot)) continue;
        entries[i] = slot | AT_WALL;
        a->moves = 1;
        IF_RECORDING(clearWallTouch(w, slot);)
        startCircle(w, slot, w->circle[slot], w->motion[slot], w->traits[slot], a->load[i],
                    (a->progress[i] & HAS_CARRIED) != 0 AND_TURNING(w->surfaceSpeed[slot]) AND_TURNING(a->spin[i]), true);
    }
}
#endif

bool mayMove(const World *w, int slot, float4 m, float4 t) {
    IF_TURNING(if (w->surfaceSpeed[slot] != 0.0f) return true;)
    return t.INVERSE_MASS != 0.0f || m.VX != 0.0f || m.VY != 0.0f;
}

// Starts the tile's own, if nobody shares passes with like contacts, and keeps what contacts need of all.
void takeCircles(const World *w, local Arrangement *a, global int *record, int circles, int together) {
    global int *entry = record + TILE_AT_SLOTS;
    int left = sharesPasses(w) ? NOT_OWN : 0;
    IF_TERRAIN(if (left == 0) startAtPieces(w, a, entry, circles);)
    TILE_TOGETHER(first, circles, together) {
        int taken[MOST_TOGETHER];
        float4 c[MOST_TOGETHER], t[MOST_TOGETHER], m[MOST_TOGETHER];
        TOGETHER_EACH(n, together) {
            if (togetherItem(first, n) < circles) taken[n] = entry[togetherItem(first, n)] | left;
        }
        TOGETHER_EACH(n, together) {
            if (togetherItem(first, n) >= circles) continue;
            int slot = taken[n] & ENTRY_SLOT;
            c[n] = w->circle[slot];
            t[n] = (float4)(lastingTraits(w, slot), 0.0f, 0.0f);
            if (taken[n] >= 0) {
                t[n] = w->traits[slot];
                m[n] = w->motion[slot];
            }
        }
        TOGETHER_EACH(n, together) {
            int i = togetherItem(first, n);
            if (i >= circles) continue;
            int slot = taken[n] & ENTRY_SLOT;
            IF_TERRAIN(if ((taken[n] & AT_WALL) != 0) taken[n] |= NOT_OWN;) // started
            if (taken[n] >= 0) {
                IF_RECORDING(clearWallTouch(w, slot);)
                if (mayMove(w, slot, m[n], t[n])) a->moves = 1;
                bool carried = (a->progress[i] & HAS_CARRIED) != 0;
                bool atWall = startCircle(w, slot, c[n], m[n], t[n], a->load[i],
                                          carried AND_TURNING(w->surfaceSpeed[slot]) AND_TURNING(a->spin[i]) AND_TERRAIN(false));
                if (atWall) entry[i] = slot | AT_WALL;
            }
            a->load[i] = c[n].xy;
            a->of.circle.radius[i] = c[n].RADIUS;
            a->of.circle.inverseMass[i] = awakeInverseMass(c[n], t[n].INVERSE_MASS); // see massOfPair
            a->of.circle.restitution[i] = t[n].RESTITUTION;
            a->of.circle.slot[i] = slot;
        }
    }
    barrier(CLK_LOCAL_MEM_FENCE);
}

#ifdef TURNING
// Of a contact as it is listed.
void copySurface(const World *w, int copy, int listed) {
    float2 stored = w->pairSurface[listed];
    w->copiedSurface[copy] = stored;
    if (hasRest(stored)) w->copiedRest[copy] = w->pairRest[listed];
}
#endif

void copyContacts(const World *w, local const Arrangement *a, int contacts) {
    global int2 *placed = placedFrom(w, a->firstCopy);
    TILE_TOGETHER(first, contacts, ARRANGED) {
        int2 contact[MOST_TOGETHER];
        float4 normal[MOST_TOGETHER];
        TOGETHER_EACH(n, ARRANGED) {
            if (togetherItem(first, n) < contacts) contact[n] = placed[togetherItem(first, n)];
        }
        TOGETHER_EACH(n, ARRANGED) {
            if (togetherItem(first, n) < contacts) normal[n] = startingOf(w)[contact[n].PLACED_CONTACT & ~NOT_OWN];
        }
        TOGETHER_EACH(n, ARRANGED) {
            int place = togetherItem(first, n);
            int copy = a->firstCopy + place;
            if (place >= contacts) continue;
            int i = lowerOf(contact[n].PLACED_CIRCLES);
            int j = higherOf(contact[n].PLACED_CIRCLES);
            float2 base = a->load[j] - a->load[i];
            w->bases[copy] = (float2)(ACROSS_X(w, base.x), ACROSS_Y(w, base.y));
            w->shape[copy] = (float2)(a->of.circle.radius[i] + a->of.circle.radius[j],
                                      maxf(a->of.circle.restitution[i], a->of.circle.restitution[j]));
            copiesOf(w)[copy] = (float4)(normal[n].NORMAL_X, normal[n].NORMAL_Y, normal[n].SEPARATION,
                                        effectiveMass(a->of.circle.inverseMass[i], a->of.circle.inverseMass[j]));
            IF_TURNING(copySurface(w, copy, contact[n].PLACED_CONTACT & ~NOT_OWN);)
            IF_TURNING(RowImpulses held = w->rowImpulses[contact[n].PLACED_CONTACT & ~NOT_OWN];)
            if (contact[n].PLACED_CONTACT < 0) continue;
            int number = a->firstNumber + a->ownNumber[roundOf(contact[n].PLACED_CIRCLES)] + place;
            placed[place].PLACED_CONTACT = number;
            w->held[number] = normal[n].NORMAL_IMPULSE;
            IF_TURNING(w->heldRows[number] = held;)
            IF_RECORDING(clearTouch(w, number);)
            w->ordered[number] = (uint2)((uint) a->of.circle.slot[i], (uint) a->of.circle.slot[j]);
        }
    }
}

// Numbers that neighbours have given to their contacts. Once a step, after all tiles.
void findNumbers(const World *w, global int2 *placed, int contacts) {
    TILE_EACH(place, contacts) {
        int c = placed[place].PLACED_CONTACT;
        if (c < 0) placed[place].PLACED_CONTACT = numbersOf(w)[c & ~NOT_OWN] | NOT_OWN;
    }
    barrier(CLK_GLOBAL_MEM_FENCE);
}

// Asked while others may refuse it.
bool refusedMeanwhile(const World *w) {
    return tooFast(w) || atomic_or(&w->status[OUT_OF_ROOM], 0) != 0 ||
           (w->k.thinning == 0 && atomic_or(&w->status[CROWDED], 0) != 0);
}

// It does not matter how many more.
#define MOST_COUNTED (1 << 20)

// Refuses the step if they do not fit. idle: do nothing.
void arrangeTile(const World *w, const Region *r, local Arrangement *a, int tile, bool idle, int together) {
    global int *record = recordOf(w, tile);
    int found = numberCircles(w, r, a, record);
    bool any = !idle && found > 0 && found <= TILE_CIRCLES;
    bool placed = takeCopies(w, r, a, any);
    takeContacts(w, r, a, placed);
    int contacts = a->contacts;
    bool crowded = a->crowded && w->k.thinning == 0;
    bool fits = placed && !a->overfull && !crowded;
    int circles = fits ? found : 0;
    recordContacts(w, r, a, record, circles);
    gatherLoads(w, a, record, sharesPasses(w) ? circles : 0);
    takeCircles(w, a, record, circles, together);
    copyContacts(w, a, circles > 0 ? contacts : 0);
    if (get_local_id(0) != 0 || idle || found == 0) return;
    record[TILE_AT_STILL] = fits && contacts == 0 && a->moves == 0 && !sharesPasses(w);
    int peak = max(100 * min(found, MOST_COUNTED) / TILE_CIRCLES, 100 * min(contacts, MOST_COUNTED) / TILE_CONTACTS);
    if (fits) {
        atomic_max(&w->status[TILE_PEAK], peak);
    } else if (found > TILE_CIRCLES || contacts > TILE_CONTACTS) {
        refuseTile(w, peak + 1);
    } else if (crowded) {
        atomic_or(&w->status[CROWDED], 1);
    } else if (placed) {
        refuseTile(w, TILE_NONE);
    } else {
        atomic_or(&w->status[OUT_OF_ROOM], 1); // for copies
    }
}

// Index space: a work-group a tile. listed: tiles of the list.
TILE_KERNEL contacts_arrange(WORLD_PARAMETERS, int listed RECORDING_PARAMETERS) {
    World w = WORLD;
    RECORD_IN(w);
    SET_TOUCH_NUMBERS(w);
    local Arrangement arrangement;
    if (status[EVENTS_LACK]) return; // the records are read once more
    // Others may refuse the step meanwhile: a work-group must see one answer.
    if (get_local_id(0) == 0) {
        if (atomic_max(&w.status[TILE_PEAK], 0) == TILE_NONE) refuseTile(&w, TILE_NONE); // see linkContact
        if (listed && status[TILES_LISTED] > w.levels->tileCount) atomic_or(&status[OUT_OF_ROOM], 1);
        arrangement.idle = refusedMeanwhile(&w);
    }
    barrier(CLK_LOCAL_MEM_FENCE);
    int tile = (int) get_group_id(0);
    Region r = listed ? regionOfListed(&w, tile) : regionOf(&w, tile);
    arrangeTile(&w, &r, &arrangement, tile, arrangement.idle, 2);
}
