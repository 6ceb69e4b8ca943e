// uses: world/shared/Cross.cl world/persistent_cpu/LaneContacts.cl
// Cross contacts, four at a time. A wide cross contact has a light circle in each lane, all different ones; the heavy circles may be the
// same. It lies in memory as any wide contact (LaneContacts.cl), normals from lower to higher id, but for three things: pairOf has light
// circles in place of those of lower id, and heavy ones in place of the others; so has massesOf, and the sign of the light one's
// inverse mass is set if its id is the higher one, that of the heavy one's if the heavy circle is shared; the effective mass is that of
// a contact that is solved. A lane that is not used stands at the light circle of lane 0.
//
// A work-group makes the cross contacts of the light circles of its bands. A heavy circle is shared if it is of the band of one work-group
// and in contacts of another: then all add to its sums by atomic operations, which take several times as long.

#define LIGHT_IS_HIGHER (1UL << 63) // in the slots of a pair: its circle of higher id is the light one
#define SIGN ((int4)((int) 0x80000000))
#define SHARED (-1)

// The work-group of a circle, or SHARED. In an array that is free once circles have been sorted; so is the next.
volatile global int *ownerOf(const World *w, uint slot) { return (volatile global int *) (w->order + slot); }

// The first node of the pairs in which a circle is the light one (see findCrossOf), or NONE.
volatile global int *nodesOf(const World *w, uint slot) { return (volatile global int *) (w->order + slot) + 1; }

// Begins a step for a circle.
void clearCross(const World *w, int slot, int owner) {
    *ownerOf(w, slot) = owner;
    *nodesOf(w, slot) = NONE;
    w->coarser[slot] = 0;
    w->crossLoad[slot] = 0;
    w->claim[slot] = 0;
    w->heavySum[slot] = (long4)(0);
}

INLINE float4 signed4(float4 magnitude, int4 sign) { return as_float4(as_int4(magnitude) ^ sign); }

INLINE float4 magnitude4(float4 x) { return as_float4(as_int4(x) & ~SIGN); }

// Whether a lane has a cross contact whose light circle is the one of higher id; not in a like contact, where no sign is set.
bool isLightHigher(const World *w, int wide, int lane) { return ((global const int *) massesOf(w, wide))[lane] < 0; }

// Fills a wide cross contact. slots: with LIGHT_IS_HIGHER; owner: the work-group. Marks heavy circles of other work-groups as shared.
void fillWideCross(const World *w, int wide, const ulong *ids, const ulong *slots, int used, int owner) {
    ulong plain[4];
    int higher[4];
    for (int l = 0; l < 4; l++) {
        plain[l] = l < used ? slots[l] & ~LIGHT_IS_HIGHER : 0;
        higher[l] = l < used && (slots[l] & LIGHT_IS_HIGHER) ? (int) 0x80000000 : 0;
    }
    fillWide(w, wide, ids, plain, used);
    global uint *pair = pairOf(w, wide);
    uint first = higher[0] ? (uint) plain[0] : (uint) (plain[0] >> 32);
    for (int l = 0; l < 4; l++) {
        uint lower = pair[l];
        uint other = pair[4 + l];
        uint heavy = l < used ? (higher[l] ? lower : other) : first;
        pair[l] = l < used ? (higher[l] ? other : lower) : first;
        pair[4 + l] = heavy;
        if (l < used && *ownerOf(w, heavy) != owner) *ownerOf(w, heavy) = SHARED;
    }
    int4 sign = (int4)(higher[0], higher[1], higher[2], higher[3]);
    global float4 *masses = massesOf(w, wide);
    float4 lower = masses[0];
    float4 other = masses[1];
    masses[0] = signed4(choose4(sign != 0, other, lower), sign);
    masses[1] = choose4(sign != 0, lower, other);
}

// The wide cross contacts of a work-group lie in one piece; where, is noted behind the rows of all levels.
global int *crossRange(const World *w, int group) { return w->groupStart + 2 * (w->levels->first[LEVELS] >> 2) + 2 * group; }

// Counts the circles of the places [from, to) of wide contacts.
void countDegrees(const World *w, int from, int to) {
    for (int place = 4 * from; place < 4 * to; place++) {
        global const uint *pair = pairOf(w, place >> 2) + (place & 3);
        if (pair[0] == pair[4]) continue;
        atomic_inc(&w->rank[pair[0]]);
        atomic_inc(&w->rank[pair[4]]);
    }
}

// How many contacts each circle had in the last step, into rank, which is all zeros. Index space: a row of groups a work-item, then a
// work-group of the step, for its cross contacts. Cost: its contacts.
kernel void persistentCpu_degrees(WORLD_PARAMETERS, int groups) {
    World w = WORLD;
    int rows = levels->first[LEVELS] >> 2;
    int item = (int) get_global_id(0);
    if (item >= rows) {
        global const int *cross = crossRange(&w, item - rows);
        if (item - rows < groups && !hasOneLevel(&w)) countDegrees(&w, cross[0], cross[1]);
        return;
    }
    int l = 0;
    while (l < levels->usedCount - 1 && item >= levels->first[levels->used[l + 1]] >> 2) l++;
    int level = levels->used[l];
    if (item - rowNumber(&w, level, 0) < levels->rowCount[level]) countDegrees(&w, w.groupStart[2 * item], w.groupStart[2 * item + 1]);
}
