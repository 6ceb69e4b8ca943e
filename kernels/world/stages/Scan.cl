// Exclusive prefix sum of counts, which are left all 0. A work-group takes SCAN_GROUP times SCAN_EACH (4) elements. Arrays have room for a
// multiple of SCAN_EACH, and counts behind the last are 0.

// Over a work-group. cells: two a work-item; each half is read while the other is written.
int scanGroup(int value, local int *cells, int *total) {
    int item = (int) get_local_id(0);
    int size = (int) get_local_size(0);
    int half_ = 0;
    cells[item] = value;
    barrier(CLK_LOCAL_MEM_FENCE);
    for (int step = 1; step < size; step <<= 1) {
        int sum = cells[half_ + item] + (item >= step ? cells[half_ + item - step] : 0);
        half_ = size - half_;
        cells[half_ + item] = sum;
        barrier(CLK_LOCAL_MEM_FENCE);
    }
    *total = cells[half_ + size - 1];
    int before = cells[half_ + item] - value;
    barrier(CLK_LOCAL_MEM_FENCE);
    return before;
}

// Index space: a work-group a block.
kernel __attribute__((reqd_work_group_size(SCAN_GROUP, 1, 1))) void scan_blocks(global const int *counts, int count,
                                                                                global int *blockSums) {
    local int cells[2 * SCAN_GROUP];
    int i = (int) get_global_id(0);
    int4 own = SCAN_EACH * i < count ? vload4(i, counts) : (int4)(0);
    int total;
    scanGroup(own.x + own.y + own.z + own.w, cells, &total);
    if (get_local_id(0) == 0) blockSums[get_group_id(0)] = total;
}

// Clears the counts, unless the step before waits for the host and may need them. Each sums up what stands before its block: cheaper than a
// launch. Index space: a work-group a block.
kernel __attribute__((reqd_work_group_size(SCAN_GROUP, 1, 1))) void scan_starts(global int *counts, int count,
                                                                                global const int *blockSums,
                                                                                global int *starts,
                                                                            global const int *status) {
    local int cells[2 * SCAN_GROUP];
    if (status[EVENTS_LACK]) return;
    int i = (int) get_global_id(0);
    int4 own = SCAN_EACH * i < count ? vload4(i, counts) : (int4)(0);
    int part = 0;
    for (int b = (int) get_local_id(0); b < (int) get_group_id(0); b += SCAN_GROUP) part += blockSums[b];
    int before, total;
    scanGroup(part, cells, &before);
    int4 start;
    start.x = before + scanGroup(own.x + own.y + own.z + own.w, cells, &total);
    start.y = start.x + own.x;
    start.z = start.y + own.y;
    start.w = start.z + own.z;
    if (SCAN_EACH * i < count) {
        vstore4(start, i, starts);
        vstore4((int4)(0), i, counts);
    }
}
