// Sweep and prune with spatial subdivision: entries by strip and start of the interval, a radix sort, one sweep.
// Defines: GROUP (work-items of a group that scans, a power of two), EACH (elements per work-item of a scan),
// CHUNK (elements per work-item of a sort), SLACK (what rounding may move a bound by).
#pragma OPENCL FP_CONTRACT OFF

#define DIGIT_BITS 4
#define DIGITS (1 << DIGIT_BITS)
#define BLOCK (GROUP * EACH)

static int strip_of(float y, int strips) {
    return clamp((int)(y * (float)strips), 0, strips);
}

static int begin_of(float x, float min_x, float per_x, int greatest) {
    return clamp((int)((x - min_x) * per_x), 0, greatest);
}

// Writes the entries of each circle into its slots; a slot that is left over gets the key `pad`, which sorts last.
// Index space: one work-item per circle.
__kernel void make_entries(__global const float *x, __global const float *y, __global const float *reach,
                           __global const int *slot, __global int *keys, __global int *numbers, int circles, int strips,
                           int x_bits, float min_x, float per_x, int pad) {
    const int i = get_global_id(0);
    if (i >= circles) {
        return;
    }
    const float r = reach[i];
    const int first = strip_of(y[i] - r - SLACK, strips);
    const int last = strip_of(y[i] + r + SLACK, strips);
    const int begin = begin_of(x[i] - r, min_x, per_x, (1 << x_bits) - 1);
    for (int k = slot[i]; k < slot[i + 1]; k++) {
        const int strip = first + k - slot[i];
        keys[k] = strip <= last ? strip << x_bits | begin : pad;
        numbers[k] = i;
    }
}

// Counts the digits of each chunk: counts[digit * chunks + chunk]. Index space: one work-item per chunk.
__kernel void count_digits(__global const int *keys, __global int *counts, int entries, int chunks, int shift) {
    const int chunk = get_global_id(0);
    if (chunk >= chunks) {
        return;
    }
    int count[DIGITS];
    for (int d = 0; d < DIGITS; d++) {
        count[d] = 0;
    }
    const int end = min(entries, (chunk + 1) * CHUNK);
    for (int k = chunk * CHUNK; k < end; k++) {
        count[keys[k] >> shift & DIGITS - 1]++;
    }
    for (int d = 0; d < DIGITS; d++) {
        counts[d * chunks + chunk] = count[d];
    }
}

// Moves each entry to where its digit's next one goes; keeps the order of equal digits. Index space: one work-item per chunk.
__kernel void scatter_digits(__global const int *keys, __global const int *numbers, __global const int *starts,
                             __global int *to_keys, __global int *to_numbers, int entries, int chunks, int shift) {
    const int chunk = get_global_id(0);
    if (chunk >= chunks) {
        return;
    }
    int next[DIGITS];
    for (int d = 0; d < DIGITS; d++) {
        next[d] = starts[d * chunks + chunk];
    }
    const int end = min(entries, (chunk + 1) * CHUNK);
    for (int k = chunk * CHUNK; k < end; k++) {
        const int key = keys[k];
        const int to = next[key >> shift & DIGITS - 1]++;
        to_keys[to] = key;
        to_numbers[to] = numbers[k];
    }
}

// Puts the sum of all values before each into its place, within blocks; the sum of a block goes to sums.
// Index space: groups of GROUP work-items, one group per block.
__kernel void scan_blocks(__global int *values, __global int *sums, int length) {
    __local int partial[GROUP];
    const int item = get_local_id(0);
    const int from = get_group_id(0) * BLOCK + item * EACH;
    int own = 0;
    for (int k = from; k < min(from + EACH, length); k++) {
        own += values[k];
    }
    partial[item] = own;
    barrier(CLK_LOCAL_MEM_FENCE);
    for (int step = 1; step < GROUP; step *= 2) {
        const int more = item >= step ? partial[item - step] : 0;
        barrier(CLK_LOCAL_MEM_FENCE);
        partial[item] += more;
        barrier(CLK_LOCAL_MEM_FENCE);
    }
    int sum = partial[item] - own;
    for (int k = from; k < min(from + EACH, length); k++) {
        const int value = values[k];
        values[k] = sum;
        sum += value;
    }
    if (item == GROUP - 1) {
        sums[get_group_id(0)] = partial[item];
    }
}

// Adds what all blocks before it sum up to. Index space: one work-item per value.
__kernel void add_sums(__global int *values, __global const int *sums, int length) {
    const int k = get_global_id(0);
    if (k < length) {
        values[k] += sums[k / BLOCK];
    }
}

// Puts x, y, reach and first strip of each entry's circle side by side. Index space: one work-item per entry.
__kernel void gather(__global const float *x, __global const float *y, __global const float *reach,
                     __global const int *numbers, __global float4 *sorted, int entries, int strips) {
    const int k = get_global_id(0);
    if (k < entries) {
        const int i = numbers[k];
        sorted[k] = (float4)(x[i], y[i], reach[i], as_float(strip_of(y[i] - reach[i] - SLACK, strips)));
    }
}

// Tests an entry with those behind it; writes pairs where `pairs` has room for them, and counts them in any case.
static int sweep(int k, __global const int *keys, __global const float4 *sorted, __global const int *numbers,
                 __global int2 *pairs, int at, int room, int entries, int x_bits, float min_x, float per_x, int pad) {
    const int key = keys[k];
    if (key == pad) {
        return 0;
    }
    const float4 a = sorted[k];
    const int strip = key >> x_bits;
    const int end = strip << x_bits | begin_of(a.x + a.z + SLACK, min_x, per_x, (1 << x_bits) - 1);
    int count = 0;
    for (int m = k + 1; m < entries && keys[m] <= end; m++) {
        const float4 b = sorted[m];
        const float dx = a.x - b.x;
        const float dy = a.y - b.y;
        const float sum = a.z + b.z;
        if (dx * dx + dy * dy < sum * sum && max(as_int(a.w), as_int(b.w)) == strip) {
            if (at + count < room) {
                pairs[at + count] = (int2)(numbers[k], numbers[m]);
            }
            count++;
        }
    }
    return count;
}

// Counts the pairs of each entry; the element behind the last is 0, so that the scan leaves the sum of all there.
// Index space: one work-item per entry, and one more.
__kernel void count_pairs(__global const int *keys, __global const float4 *sorted, __global const int *numbers,
                          __global int2 *pairs, __global int *counts, int entries, int x_bits, float min_x, float per_x,
                          int pad) {
    const int k = get_global_id(0);
    if (k <= entries) {
        counts[k] = k == entries
            ? 0
            : sweep(k, keys, sorted, numbers, pairs, 0, 0, entries, x_bits, min_x, per_x, pad);
    }
}

// Writes the pairs of each entry from its place on. Index space: one work-item per entry.
__kernel void write_pairs(__global const int *keys, __global const float4 *sorted, __global const int *numbers,
                          __global int2 *pairs, __global const int *starts, int room, int entries, int x_bits, float min_x,
                          float per_x, int pad) {
    const int k = get_global_id(0);
    if (k < entries) {
        sweep(k, keys, sorted, numbers, pairs, starts[k], room, entries, x_bits, min_x, per_x, pad);
    }
}
