// Stage Grid: copies the circles into the working arrays, sorted by (level, bucket) and by id within a bucket. A counting
// sort: clear, count, sum up (Scan.cl), scatter, order each bucket, which undoes whatever order the work-items met in.

// Index space: a bucket a work-item, and one more for the end.
kernel void grid_clear(WORLD_PARAMETERS) {
    int i = (int) get_global_id(0);
    if (i > levels->first[LEVELS]) return;
    bucketStart[i] = 0;
    groupStart[i] = 0;
    groupFill[i] = 0;
}

// Counts the circles of each bucket. Index space: a slot at home a work-item.
kernel void grid_count(WORLD_PARAMETERS) {
    World w = WORLD;
    int slot = (int) get_global_id(0);
    if (slot >= slots || outOfRoom(&w)) return;
    if (homeId[slot] < 0) {
        bucketBefore[slot] = NONE;
        return;
    }
    float4 c = homeCircle[slot];
    int l = level(c.z, levels->rmax);
    int bucket = levels->first[l] + columnOf(&w, l, c.x) + (rowOf(&w, l, c.y) << levels->columnsLog[l]);
    bucketBefore[slot] = bucket;
    rank[slot] = atomic_inc(&bucketStart[bucket]);
}

// Puts each circle at a place of its bucket. Index space: a slot at home a work-item.
kernel void grid_scatter(WORLD_PARAMETERS) {
    World w = WORLD;
    int slot = (int) get_global_id(0);
    if (slot >= slots || outOfRoom(&w)) return;
    int bucket = bucketBefore[slot];
    if (bucket >= 0) order[bucketStart[bucket] + rank[slot]] = slot;
}

void siftDown(global int *order, global const int *id, int top, int size) {
    int value = order[top];
    for (int child = 2 * top + 1; child < size; child = 2 * top + 1) {
        if (child + 1 < size && id[order[child + 1]] > id[order[child]]) child++;
        if (id[order[child]] <= id[value]) break;
        order[top] = order[child];
        top = child;
    }
    order[top] = value;
}

// Orders each bucket by id: insertion sort, or heap sort where a bucket is long. Index space: a bucket a work-item.
kernel void grid_sort(WORLD_PARAMETERS) {
    World w = WORLD;
    int bucket = (int) get_global_id(0);
    if (bucket >= levels->first[LEVELS] || outOfRoom(&w)) return;
    int from = bucketStart[bucket];
    int size = bucketStart[bucket + 1] - from;
    global int *part = order + from;
    if (size > 64) {
        for (int top = size / 2 - 1; top >= 0; top--) siftDown(part, homeId, top, size);
        for (int end = size - 1; end > 0; end--) {
            int last = part[end];
            part[end] = part[0];
            part[0] = last;
            siftDown(part, homeId, 0, end);
        }
    } else {
        for (int i = 1; i < size; i++) {
            int slot = part[i];
            int p = i;
            while (p > 0 && homeId[part[p - 1]] > homeId[slot]) {
                part[p] = part[p - 1];
                p--;
            }
            part[p] = slot;
        }
    }
    for (int i = 0; i < size; i++) bucketOf[from + i] = bucket;
}

// Copies the circles in their new order. Index space: a working slot a work-item.
kernel void grid_gather(WORLD_PARAMETERS) {
    World w = WORLD;
    int slot = (int) get_global_id(0);
    if (slot >= circles || outOfRoom(&w)) return;
    int from = order[slot];
    float4 c = homeCircle[from];
    float4 m = homeMotion[from];
    circle[slot] = c;
    motion[slot] = m;
    traits[slot] = homeTraits[from];
    id[slot] = homeId[from];
    memory[slot] = homeMemory[from];
    load[slot] = (float4)(0.0f);
    reachOf[slot] = reach(c.z, m.z, m.w, k->dt, MARGIN, CAP);
}
