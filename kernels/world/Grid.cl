// Stage Grid: copies the circles into the working arrays, sorted by (level, bucket) and by id within a bucket. A counting
// sort: clear, count, sum up (Scan.cl), scatter, order each bucket, which undoes whatever order the work-items met in.
// Describes each circle for the stages that follow, and refuses the step where one is too fast for it.

void clearBucket(const World *w, int i) {
    w->bucketStart[i] = 0;
    w->groupStart[i] = 0;
    w->groupFill[i] = 0;
    if (i == 0 && !refused(w)) {
        // What a step that takes fast circles, or crowds, or tiles, tells the host is about the last one alone.
        if (w->k.sweeping) w->status[FAST] = 0;
        if (w->k.thinning) w->status[CROWDED] = 0;
        w->status[TILE_PEAK] = 0;
    }
}

// Index space: a bucket a work-item, and one more for the end.
kernel void grid_clear(WORLD_PARAMETERS) {
    World w = WORLD;
    int i = (int) get_global_id(0);
    if (i <= levels->first[LEVELS]) clearBucket(&w, i);
}

void countSlot(const World *w, int slot) {
    if (w->homeId[slot] < 0) {
        w->bucketBefore[slot] = NONE;
        return;
    }
    float4 c = w->homeCircle[slot];
    int l = levelOf(w, c.z);
    int bucket = w->levels->first[l] + columnOf(w, l, c.x) + (rowOf(w, l, c.y) << w->levels->columnsLog[l]);
    w->bucketBefore[slot] = bucket;
    w->rank[slot] = atomic_inc(&w->bucketStart[bucket]);
}

// Counts the circles of each bucket. Index space: a slot at home a work-item.
kernel void grid_count(WORLD_PARAMETERS) {
    World w = WORLD;
    int slot = (int) get_global_id(0);
    if (slot < slots && !refused(&w)) countSlot(&w, slot);
}

void scatterSlot(const World *w, int slot) {
    int bucket = w->bucketBefore[slot];
    if (bucket >= 0) w->order[w->bucketStart[bucket] + w->rank[slot]] = slot;
}

// Puts each circle at a place of its bucket. Index space: a slot at home a work-item.
kernel void grid_scatter(WORLD_PARAMETERS) {
    World w = WORLD;
    int slot = (int) get_global_id(0);
    if (slot < slots && !refused(&w)) scatterSlot(&w, slot);
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

// Orders a bucket by id: insertion sort, or heap sort where it is long.
void sortBucket(const World *w, int bucket) {
    int from = w->bucketStart[bucket];
    int size = w->bucketStart[bucket + 1] - from;
    global int *part = w->order + from;
    global const int *homeId = w->homeId;
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
    for (int i = 0; i < size; i++) w->bucketOf[from + i] = bucket;
}

// Index space: a bucket a work-item. Cost: its circles.
kernel void grid_sort(WORLD_PARAMETERS) {
    World w = WORLD;
    int bucket = (int) get_global_id(0);
    if (bucket < levels->first[LEVELS] && !refused(&w)) sortBucket(&w, bucket);
}

// Copies a circle to its new place, and describes it. A step that has been refused because of a fast circle may come here
// again: to the same result.
void gatherCircle(const World *w, int slot) {
    int from = w->order[slot];
    float4 c = w->homeCircle[from];
    float4 m = w->homeMotion[from];
    float4 t = w->homeTraits[from];
    bool fixed = t.x == 0.0f;
    float px = plan(m.z, w->k.dt, fixed ? 0.0f : w->k.fallX);
    float py = plan(m.w, w->k.dt, fixed ? 0.0f : w->k.fallY);
    float path = norm(px, py);
    w->circle[slot] = c;
    w->motion[slot] = m;
    w->traits[slot] = t;
    w->id[slot] = w->homeId[from];
    w->memory[slot] = w->homeMemory[from];
    w->load[slot] = (float4)(0.0f);
    w->leash[slot] = (float4)(px, py, LEASH * c.z, path);
    w->sight[slot] = (float4)(c.x, c.y, reach(c.z, path), t.x);
    if (w->k.sweeping) {
        w->share[slot] = as_int(1.0f);
        w->near[slot] = 1.0f;
    }
    if (!fixed && isFast(path, c.z)) w->status[FAST] = 1;
}

// Index space: a working slot a work-item.
kernel void grid_gather(WORLD_PARAMETERS) {
    World w = WORLD;
    int slot = (int) get_global_id(0);
    if (slot < circles && !outOfRoom(&w) && !tooCrowded(&w)) gatherCircle(&w, slot);
}
