// What all stages share: the constants of a step, the shape of the grids, and the buffers. Every kernel of a stage takes the
// same list of buffers (WORLD_PARAMETERS), packed into one struct on entry; what a kernel does not use costs nothing.
//
// The state between two steps is at home: circle, motion, traits, id, memory by slot, some slots empty (id -1). Stage Grid
// copies it, sorted, into the working arrays; stage Solver ends the step by writing it home. A step that cannot be made as it
// was enqueued is refused: it writes nothing home, nor do those behind it, until the host has enqueued it in another way.

// Filled by the host class ClParameters, in this order.
typedef struct {
    float dt, h, inverseH, gravityStepX, gravityStepY, fallX, fallY;
    float biasRate, massScale, impulseScale, wallBiasRate, wallMassScale, wallImpulseScale;
    float thresholdRate, restRate, pushPerLength, pushPerRoot, warmScale;
    float minX, minY, maxX, maxY;
    int subSteps;
    int sweeping; // 1 where the step has the stage Sweep, else it does not take fast circles
    int thinning; // 1 where the step thins crowds out, else it does not take them
    int tiled;    // 1 where the step is made by tiles
} StepConstants;

// Filled by the host class ClParameters, in this order.
typedef struct {
    float minX, minY, rmax;
    int usedCount;
    float inverseEdge[LEVELS], top[LEVELS];
    int levelOf[LEVELS];
    int columnsLog[LEVELS], rowsLog[LEVELS];   // of the torus, rounded up to powers of two
    int columnCount[LEVELS], rowCount[LEVELS]; // of the torus
    int used[LEVELS];
    int first[LEVELS + 1];
    int tileColumnsLog, tileRowsLog; // cells of a tile (Tiles.cl)
    int tilesAcross, tilesDown;      // tiles that may hold circles
} Levels;

// status
#define OUT_OF_ROOM 0 // set by a step that lacks room for its contacts or copies of them, or found no way to go on with them
#define CONTACTS 1    // contacts of the last step, or of one that was out of room
#define STEPS_DONE 2  // steps written home, since the world was made
#define FAST 3        // 1 where some circle is fast
#define CROWDED 4     // 1 where some circle has so many candidates that pairs are to be thinned out
#define TILE_PEAK 5   // the fullest tile: percent of the room, or NO_TILE
#define TILE_NUMBERS 6 // contacts that tiles have numbered
#define TILE_COPIES 7  // copies of contacts that tiles have made
#define APART 8       // by lanes: 1 where not all work-groups came at once
#define PLACES 9      // by lanes: end of the places of contacts that the last step has used
#define MOST_PLACES 10 // by lanes: places that a work-group needs at most
#define ARRIVALS 32   // of work-groups at barriers over all of them, in a cache line of its own
#define DEPARTURES 33 // of work-groups
#define FOUND 48      // contacts found so far, in no order; away from what every work-item reads
#define MEETING 49    // by lanes: whether all work-groups are here

#define WORLD_PARAMETERS                                                                                               \
    constant StepConstants *k, constant Levels *levels, global int *status, int slots, int circles, int contactRoom,   \
        global float4 *homeCircle, global float4 *homeMotion, global float4 *homeTraits, global int *homeId,           \
        global int *homeMemory, global int *slotOf, global int *bucketBefore, global int *rank, global int2 *order,    \
        global int *bucketStart, global int *bucketOf, global float4 *sight, global float4 *circle,                    \
        global float4 *motion, global float4 *traits, global int *id, global int *memory, global float4 *load,         \
        global float2 *wallBounce, global float4 *leash, global int *share, global float *near,                        \
        global float4 *blockRange, global float4 *drive, global float4 *pushedMotion, global float *burden,            \
        global float *pushedBurden, global int *groupStart, global int *tally, global ulong *key,                  \
        global uint2 *pair, global float4 *base, global float4 *masses, global float4 *contact, global uint *link,     \
        global uint2 *ordered, global float2 *shape, global float *held, global float2 *impulse, global int4 *old,     \
        global int *blockSums, global int *tiles

typedef struct {
    StepConstants k; // by value: read once, not at every use
    constant Levels *levels;
    global int *status;
    int slots;       // slots at home, empty ones included
    int circles;     // circles: working slots
    int contactRoom; // contacts that the contact buffers can hold

    // by slot at home
    global float4 *homeCircle; // x, y of the base, radius, mass
    global float4 *homeMotion; // displacement x, y, velocity x, y
    global float4 *homeTraits; // inverse mass (0: fixed), restitution, wall impulse x, y (positive: lower wall)
    global int *homeId;        // -1: empty
    global int *homeMemory;    // first remembered contact as the lower id; NONE; FRESH: its id's memories are not its own
    global int *slotOf;        // by id: its slot at home, or -1

    // stage Grid: by slot at home, then by bucket, then by working slot
    global int *bucketBefore;
    global int *rank; // later, where crowds are thinned: candidates by working slot
    global int2 *order; // id and slot at home, bucket by bucket
    global int *bucketStart, *bucketOf;
    global float4 *sight; // x, y of the base, reach, inverse mass: what the search for contacts looks at

    // by working slot, in the order of buckets
    global float4 *circle, *motion, *traits;
    global int *id, *memory;
    global float4 *load; // see the Java class JvmState; while contacts are filled, z: candidates so far
    global float2 *wallBounce;

    // stage Sweep, by working slot
    global float4 *leash;      // what it moves if nothing is in its way x, y, allowance, length; later what is free of that
    global int *share;         // bits of the share of its path that it can go
    global float *near;        // the share up to where it touches one that it has a contact with; NOT_FAST where it is not
    global float4 *blockRange; // by block of cells: least and greatest x, least and greatest y of the paths there

    // by tiles, by working slot
    global float4 *drive;        // as the biased pass begins: velocity x, y, the same before any impulse; see TileCircles.cl
    global float4 *pushedMotion; // between the passes
    global float *burden;        // as the biased pass begins: inverse mass, negative where loaded
    global float *pushedBurden;  // between the passes

    // stage Contacts: by group, then by contact
    global int *groupStart;
    global int *tally;      // counts by bucket, later by group; all 0 when a step begins, and when a scan has used them
    global ulong *key;      // lower id, higher id
    global uint2 *pair;     // working slots, in the same order
    global float4 *base;    // difference of the bases x, y, sum of the radii, restitution; by tiles see listedOf,
                            // later basesOf
    global float4 *masses;  // inverse masses, greatest push-out speed, target speed of a bounce;
                            // by tiles, as contacts are listed: contact as the step begins, with its impulse
    global float4 *contact; // normal x, y, separation, accumulated impulse; by tiles, by copy, effective mass instead of impulse;
                            // before that, as ints: see recordContact
    global uint *link;      // by tiles: see linkOf
    global uint2 *ordered;  // by tiles: working slots, where pair is in no order within a group
    global float2 *shape;   // by tiles, by copy: sum of the radii, restitution
    global float *held;     // by tiles: accumulated impulse after a sub-step
    global float2 *impulse; // by tiles, between the passes: accumulated impulse, target speed of a bounce

    // remembered contacts of the step before
    global int4 *old; // by contact: higher id, impulse, the next of the same circle of lower id or NONE

    global int *blockSums;
    global int *tiles; // by tile: a record of TILE_RECORD ints, see Tiles.cl

    float warmScale; // what remembered impulses are multiplied by
} World;

#define WORLD                                                                                                          \
    {                                                                                                                  \
        *k, levels, status, slots, circles, contactRoom, homeCircle, homeMotion, homeTraits, homeId, homeMemory,       \
            slotOf, bucketBefore, rank, order, bucketStart, bucketOf, sight, circle, motion, traits, id, memory,     \
            load, wallBounce, leash, share, near, blockRange, drive, pushedMotion, burden, pushedBurden,               \
            groupStart, tally, key, pair, base, masses, contact, link, ordered, shape, held, impulse, old,         \
            blockSums, tiles, k->warmScale                                                                             \
    }

#define NONE (-1)
#define FRESH (-2)
#define NOT_FAST 2.0f // more than any share

// Why a step is refused. A kernel does not ask for what it may set itself.
bool outOfRoom(const World *w) { return w->status[OUT_OF_ROOM] != 0; }

bool tooFast(const World *w) { return w->k.sweeping == 0 && w->status[FAST] != 0; }

bool tooCrowded(const World *w) { return w->k.thinning == 0 && w->status[CROWDED] != 0; }

// All of it at once: one read after another would be a good part of the time of a short kernel.
bool refused(const World *w) {
    int room = w->status[OUT_OF_ROOM];
    int fast = w->k.sweeping ? 0 : w->status[FAST];
    int crowded = w->k.thinning ? 0 : w->status[CROWDED];
    return (room | fast | crowded) != 0;
}

int levelOf(const World *w, float r) { return w->levels->levelOf[sizeClass(r, w->levels->rmax)]; }

// The column (or row) of the torus of a cell's column (or row).
int onRing(int cell, int side) { return cell < side ? cell : cell % side; }

// The column (or row) of the torus that is at (0), behind (1) or before (-1) another.
int neighbour(int column, int offset, int side) {
    int moved = column + offset;
    return moved < 0 ? side - 1 : moved < side ? moved : 0;
}

int columnOf(const World *w, int atLevel, float x) {
    return onRing(cell(x, w->levels->minX, w->levels->inverseEdge[atLevel]), w->levels->columnCount[atLevel]);
}

int rowOf(const World *w, int atLevel, float y) {
    return onRing(cell(y, w->levels->minY, w->levels->inverseEdge[atLevel]), w->levels->rowCount[atLevel]);
}

// The number of groups of a colour, and the first of them: those of one colour are consecutive.
int groupsOfColour(const World *w, int atLevel) {
    return 1 << (w->levels->columnsLog[atLevel] + w->levels->rowsLog[atLevel] - 2);
}

int firstOfColour(const World *w, int atLevel, int colour) {
    return w->levels->first[atLevel] + colour * groupsOfColour(w, atLevel);
}

// The number of a group.
int groupOf(const World *w, int atLevel, int ox, int oy) {
    int colour = (ox & 1) + 2 * (oy & 1);
    return firstOfColour(w, atLevel, colour) + ((oy >> 1) << (w->levels->columnsLog[atLevel] - 1)) + (ox >> 1);
}

// Up to four ranges of slots, as if they were one. Number i of them is slot i + offset.x where i < end.x, else i + offset.y
// where i < end.y, and so on.
typedef struct {
    int4 offset, end;
    int longest; // slots of the longest range
} Piece;

// The slots [from.x, to.x), [from.y, to.y) and so on.
Piece pieceOfRanges(int4 from, int4 to) {
    int4 count = max(to - from, (int4)(0));
    Piece p;
    p.end.x = count.x;
    p.end.y = p.end.x + count.y;
    p.end.z = p.end.y + count.z;
    p.end.w = p.end.z + count.w;
    p.offset = from - (p.end - count);
    p.longest = max(max(count.x, count.y), max(count.z, count.w));
    return p;
}

int slotInPiece(const Piece *p, int i) {
    return i + (i < p->end.x ? p->offset.x : i < p->end.y ? p->offset.y : i < p->end.z ? p->offset.z : p->offset.w);
}

// The square of the bounce threshold of a pair: sum of the radii, restitution.
float thresholdOf(const World *w, float sum, float e) {
    return bounceThreshold(sum, e, w->k.thresholdRate, w->k.restRate);
}
