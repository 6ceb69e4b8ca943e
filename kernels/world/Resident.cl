// Whole steps in one launch, for worlds so small that launches would be most of their time: work-groups that stay resident
// run the stages one after another, with a barrier over all of them between stages. That needs all work-groups to run at
// once, which OpenCL does not promise: the host sees to it that there are no more than the device has room for, and chooses
// this file only for devices where that, and the fence below, are known to hold. One work-group alone runs anywhere.

// Makes what a work-item has written visible to all others, and what they have written to it. OpenCL 1.2 has no such fence
// beyond a work-group; mem_fence leaves the first-level cache stale. From the host: PTX: 1 on NVIDIA devices. On others one
// work-group alone may run this, where mem_fence does.
#if PTX
#define DEVICE_FENCE asm volatile("fence.acq_rel.gpu;" ::: "memory")
#else
#define DEVICE_FENCE mem_fence(CLK_GLOBAL_MEM_FENCE)
#endif

// Waits until all work-groups are here. arrivals: counts them; starts at 0.
void deviceBarrier(volatile global int *arrivals) {
    barrier(CLK_LOCAL_MEM_FENCE | CLK_GLOBAL_MEM_FENCE);
    if (get_local_id(0) == 0) {
        DEVICE_FENCE;
        int groups = (int) get_num_groups(0);
        int target = (atomic_inc(arrivals) / groups + 1) * groups;
        while (*arrivals < target) {
        }
        DEVICE_FENCE;
    }
    barrier(CLK_LOCAL_MEM_FENCE | CLK_GLOBAL_MEM_FENCE);
}

// Ends a work-group. The last one makes the counters ready for the next launch.
void leave(const World *w) {
    barrier(CLK_LOCAL_MEM_FENCE | CLK_GLOBAL_MEM_FENCE);
    if (get_local_id(0) != 0) return;
    if (atomic_inc(&w->status[DEPARTURES]) == (int) get_num_groups(0) - 1) {
        w->status[ARRIVALS] = 0;
        w->status[DEPARTURES] = 0;
    }
}

// Whether a step is refused must look the same to all work-groups, or some would wait for ever: each asks only for what nobody
// writes before the next barrier.

#define EACH(i, count) for (int i = (int) get_global_id(0); i < (count); i += (int) get_global_size(0))

// Exclusive prefix sum of counts, in place, by all work-groups.
void scanAll(const World *w, global int *counts, int count, local int *cells) {
    volatile global int *arrivals = w->status + ARRIVALS;
    int blocks = (count + RESIDENT_GROUP * SCAN_EACH - 1) / (RESIDENT_GROUP * SCAN_EACH);
    for (int block = (int) get_group_id(0); block < blocks; block += (int) get_num_groups(0)) {
        int total = scanBlock(counts, count, block, 0, cells);
        if (get_local_id(0) == 0) w->blockSums[block] = total;
    }
    if (blocks == 1) return;
    deviceBarrier(arrivals);
    // Every work-group sums up what stands before its blocks by itself: cheaper than another barrier.
    int before = 0;
    int summed = 0;
    for (int block = (int) get_group_id(0); block < blocks; block += (int) get_num_groups(0)) {
        int part = 0;
        for (int b = summed + (int) get_local_id(0); b < block; b += RESIDENT_GROUP) part += w->blockSums[b];
        int total;
        scanGroup(part, cells, &total);
        before += total;
        summed = block;
        for (int e = 0; e < SCAN_EACH; e++) {
            int i = (block * SCAN_EACH + e) * RESIDENT_GROUP + (int) get_local_id(0);
            if (i < count) counts[i] += before;
        }
    }
}

// Local memory, as the stages use it one after another.
typedef union {
    int cells[RESIDENT_GROUP];
    Arrangement arrangement;
    struct {
        Tile tile;
        float2 displacement[TILE_CIRCLES]; // of its circles
    } solving;
} Local;

// Stages Grid, Sweep where some circle is fast, and Contacts.
void listAll(World *w, local Local *l) {
    volatile global int *arrivals = w->status + ARRIVALS;
    int buckets = w->levels->first[LEVELS];
    w->k.sweeping = 1; // until it is known
    EACH(i, buckets + 1) clearBucket(w, i);
    deviceBarrier(arrivals);
    EACH(slot, w->slots) countSlot(w, slot);
    deviceBarrier(arrivals);
    scanAll(w, w->bucketStart, buckets + 1, l->cells);
    deviceBarrier(arrivals);
    EACH(slot, w->slots) scatterSlot(w, slot);
    deviceBarrier(arrivals);
    EACH(bucket, buckets) sortBucket(w, bucket);
    deviceBarrier(arrivals);
    EACH(slot, w->circles) gatherCircle(w, slot);
    deviceBarrier(arrivals);
    w->k.sweeping = w->status[FAST];
    if (w->k.sweeping) {
        EACH(block, buckets >> (2 * BLOCK_LOG)) summarize(w, block);
        deviceBarrier(arrivals);
        EACH(slot, w->circles) {
            if (slotIsFast(w, slot)) lookAhead(w, slot);
        }
        deviceBarrier(arrivals);
        EACH(slot, w->circles) layLeash(w, slot);
        deviceBarrier(arrivals);
    }
    EACH(slot, w->circles) seekAll(w, slot, COUNTING);
    deviceBarrier(arrivals);
    scanAll(w, w->groupStart, buckets + 1, l->cells);
    deviceBarrier(arrivals);
    if (get_global_id(0) == 0) noteContacts(w);
    if (!lackContactRoom(w) && !tooCrowded(w)) {
        EACH(slot, w->circles) seekAll(w, slot, LISTING);
    }
    deviceBarrier(arrivals);
    if (outOfRoom(w)) return;
    EACH(c, w->groupStart[buckets]) linkContact(w, c);
    deviceBarrier(arrivals);
    bool crowded = tooCrowded(w);
    deviceBarrier(arrivals);
    if (crowded) return;
    int tiles = tileCount(w);
#pragma unroll 1
    for (int tile = (int) get_group_id(0); tile < tiles; tile += (int) get_num_groups(0)) {
        arrangeTile(w, &l->arrangement, tile, false);
    }
    deviceBarrier(arrivals);
}

// Stage Solver. A work-group that has one tile alone keeps it in local memory for the whole step.
void solveAll(const World *w, local Tile *t, local float2 *displacement) {
    volatile global int *arrivals = w->status + ARRIVALS;
    int tiles = tileCount(w);
    int group = (int) get_group_id(0);
    int groups = (int) get_num_groups(0);
    if (tiles <= groups && group < tiles) takeTile(w, t, group, false);
#pragma unroll 1
    for (int pass = 0; pass < 2 * w->k.subSteps; pass++) {
        int subStep = pass >> 1;
        bool relaxing = pass & 1;
#pragma unroll 1
        for (int tile = group; tile < tiles; tile += groups) {
            if (tiles > groups) takeTile(w, t, tile, false);
            if (relaxing) {
                relaxTile(w, t, displacement, tile, subStep == w->k.subSteps - 1);
            } else {
                pushTile(w, t, tile, subStep);
            }
        }
        deviceBarrier(arrivals);
    }
}

// Index space: no more work-groups than run at once. steps: how many to make, unless one is out of room.
kernel __attribute__((reqd_work_group_size(RESIDENT_GROUP, 1, 1))) void resident_steps(WORLD_PARAMETERS, int steps) {
    World w = WORLD;
    local Local l;
    if (refused(&w)) return;
    // Nobody may run ahead and be out of room before all have looked.
    deviceBarrier(status + ARRIVALS);
#pragma unroll 1
    for (int step = 0; step < steps; step++) {
        listAll(&w, &l);
        if (refused(&w)) break;
        int contacts = groupStart[levels->first[LEVELS]];
        solveAll(&w, &l.solving.tile, l.solving.displacement);
        // Shares the barrier of the next step's beginning, or of the end of the launch.
        EACH(c, contacts) rememberHeld(&w, c);
        if (get_global_id(0) == 0) status[STEPS_DONE]++;
        w.slots = w.circles;
        w.warmScale = 1.0f;
    }
    leave(&w);
}
