// What all stages share: the constants of a step, the shape of the grids, and the buffers. Every kernel takes the same
// list of buffers (WORLD_PARAMETERS), packed into one struct on entry; what a kernel does not use costs nothing.
//
// The state between two steps is at home: circle, motion, traits, id, memory by slot, some slots empty (id -1). Stage Grid
// copies it, sorted, into the working arrays; stage Solver ends the step by writing it home. A step that found no room for
// its contacts writes nothing home: the host makes room and asks for it again.

// Filled by the host class ClParameters, in this order.
typedef struct {
    float dt, h, inverseH, gravityStepX, gravityStepY;
    float biasRate, massScale, impulseScale, wallBiasRate, wallMassScale, wallImpulseScale;
    float thresholdRate, pushPerLength, pushPerRoot, warmScale;
    float minX, minY, maxX, maxY;
    int subSteps;
} StepConstants;

// Filled by the host class ClParameters, in this order.
typedef struct {
    float minX, minY, rmax;
    int usedCount;
    float inverseEdge[LEVELS];
    int columnsLog[LEVELS], rowsLog[LEVELS], used[LEVELS];
    int first[LEVELS + 1];
    int tileColumnsLog, tileRowsLog; // cells of a tile (Tiles.cl)
} Levels;

// status
#define OUT_OF_ROOM 0     // set by a step that found more contacts than there is room for, until the host makes room
#define CONTACTS_NEEDED 1 // how many it found
#define STEPS_DONE 2      // steps written home
#define TILE_PEAK 3       // the fullest tile: percent of the room, or CROWDED
#define ARRIVALS 32       // of work-groups at barriers over all of them, in a cache line of its own

#define WORLD_PARAMETERS                                                                                               \
    constant StepConstants *k, constant Levels *levels, global int *status, int slots, int circles, int contactRoom,   \
        global float4 *homeCircle, global float4 *homeMotion, global float4 *homeTraits, global int *homeId,           \
        global int *homeMemory, global int *slotOf, global int *bucketBefore, global int *rank, global int *order,     \
        global int *bucketStart, global int *bucketOf, global float *reachOf, global float4 *circle,                   \
        global float4 *motion, global float4 *traits, global int *id, global int *memory, global float4 *load,         \
        global float2 *wallBounce, global float4 *pushedTraits, global float4 *pushedVelocity,                         \
        global float2 *pushedDisplacement, global int *groupStart, global int *groupFill, global ulong *key,                   \
        global uint2 *pair, global float4 *base, global float4 *masses, global float4 *contact,                       \
        global uint *link, global uint2 *ordered, global float4 *shape, global float *held, global float2 *impulse,      \
        global int4 *old, global int *blockSums, global int *tiles

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
    global int *bucketBefore, *rank, *order, *bucketStart, *bucketOf;
    global float *reachOf;

    // by working slot, in the order of buckets
    global float4 *circle, *motion, *traits;
    global int *id, *memory;
    global float4 *load; // see the Java class JvmState
    global float2 *wallBounce;
    global float4 *pushedTraits;       // by tiles: every other sub-step's traits
    global float4 *pushedVelocity;     // by tiles, between the passes: velocity x, y, inverse mass, 1 where loaded
    global float2 *pushedDisplacement; // by tiles, between the passes

    // stage Contacts: by group, then by contact
    global int *groupStart, *groupFill;
    global ulong *key;      // lower id, higher id
    global uint2 *pair;     // working slots, in the same order
    global float4 *base;    // difference of the bases x, y, sum of the radii, restitution
    global float4 *masses;  // inverse masses, greatest push-out speed, target speed of a bounce
    global float4 *contact; // normal x, y, separation, accumulated impulse
    global uint *link;      // by tiles: see linkOf
    global uint2 *ordered;  // by tiles: working slots, where pair is in no order within a group
    global float4 *shape;   // by tiles: restitution, square of the threshold, greatest push-out speed, effective mass
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
        *k, levels, status, slots, circles, contactRoom, homeCircle, homeMotion, homeTraits, homeId, homeMemory,        \
            slotOf, bucketBefore, rank, order, bucketStart, bucketOf, reachOf, circle, motion, traits, id, memory,     \
            load, wallBounce, pushedTraits, pushedVelocity, pushedDisplacement, groupStart, groupFill, key, pair, base, masses, contact, link, ordered, shape, held, impulse, old,      \
            blockSums, tiles, k->warmScale                                                                             \
    }

#define NONE (-1)
#define FRESH (-2)

// A step that is out of room computes nothing more, in any of its kernels.
bool outOfRoom(const World *w) { return w->status[OUT_OF_ROOM] != 0; }

int columnOf(const World *w, int atLevel, float x) {
    return cell(x, w->levels->minX, w->levels->inverseEdge[atLevel]) & ((1 << w->levels->columnsLog[atLevel]) - 1);
}

int rowOf(const World *w, int atLevel, float y) {
    return cell(y, w->levels->minY, w->levels->inverseEdge[atLevel]) & ((1 << w->levels->rowsLog[atLevel]) - 1);
}

// The number of a group; those of one colour are consecutive.
int groupOf(const World *w, int atLevel, int ox, int oy) {
    int cl = w->levels->columnsLog[atLevel];
    int colour = (ox & 1) + 2 * (oy & 1);
    return w->levels->first[atLevel] + (colour << (cl + w->levels->rowsLog[atLevel] - 2)) + ((oy >> 1) << (cl - 1)) +
           (ox >> 1);
}
