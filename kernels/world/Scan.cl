// Exclusive prefix sum of an array of counts, in place. Integers: any order gives the same result. Blocks of SCAN_EACH
// consecutive elements a work-item of a work-group.
#define SCAN_GROUP 256
#define SCAN_EACH 8

// Exclusive prefix sum over a work-group of one value a work-item; *total gets the sum of all.
int scanGroup(int value, local int *cells, int *total) {
    int item = (int) get_local_id(0);
    int size = (int) get_local_size(0);
    cells[item] = value;
    barrier(CLK_LOCAL_MEM_FENCE);
    int sum = value;
    for (int step = 1; step < size; step <<= 1) {
        int before = item >= step ? cells[item - step] : 0;
        barrier(CLK_LOCAL_MEM_FENCE);
        sum += before;
        cells[item] = sum;
        barrier(CLK_LOCAL_MEM_FENCE);
    }
    *total = cells[size - 1];
    barrier(CLK_LOCAL_MEM_FENCE);
    return sum - value;
}

// Scans a block, on top of what stands before it. All work-items of the work-group; returns the block's total.
int scanBlock(global int *counts, int count, int block, int before, local int *cells) {
    int from = (block * (int) get_local_size(0) + (int) get_local_id(0)) * SCAN_EACH;
    int each[SCAN_EACH];
    int sum = 0;
    for (int e = 0; e < SCAN_EACH; e++) {
        each[e] = from + e < count ? counts[from + e] : 0;
        sum += each[e];
    }
    int total;
    before += scanGroup(sum, cells, &total);
    for (int e = 0; e < SCAN_EACH; e++) {
        if (from + e < count) counts[from + e] = before;
        before += each[e];
    }
    return total;
}

// Scans each block by itself and notes its total. Index space: a work-group a block.
kernel __attribute__((reqd_work_group_size(SCAN_GROUP, 1, 1))) void scan_blocks(global int *counts, int count,
                                                                                global int *blockSums) {
    local int cells[SCAN_GROUP];
    int total = scanBlock(counts, count, (int) get_group_id(0), 0, cells);
    if (get_local_id(0) == 0) blockSums[get_group_id(0)] = total;
}

// Scans the totals of the blocks. Index space: one work-group, which loops.
kernel __attribute__((reqd_work_group_size(SCAN_GROUP, 1, 1))) void scan_sums(global int *blockSums, int blocks) {
    local int cells[SCAN_GROUP];
    int carry = 0;
    for (int start = 0; start < blocks; start += SCAN_GROUP) {
        int i = start + (int) get_local_id(0);
        int value = i < blocks ? blockSums[i] : 0;
        int total;
        int before = scanGroup(value, cells, &total);
        if (i < blocks) blockSums[i] = carry + before;
        carry += total;
    }
}

// Adds to each element what stands before its block. Index space: an element a work-item.
kernel void scan_add(global int *counts, int count, global const int *blockSums) {
    int i = (int) get_global_id(0);
    if (i < count) counts[i] += blockSums[i / (SCAN_GROUP * SCAN_EACH)];
}
