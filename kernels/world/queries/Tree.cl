// uses: world/shared/CircleMath.cl world/stages/Scan.cl
// A tree of boxes over the circles at home, as the Java class CircleTree: sixteen circles a box, four boxes a box of the next level.
// Circles are sorted by cells in the order of a Hilbert curve; no answer depends on the order within a cell.

// extent: least x, least y, greatest x, greatest y, the last two negated, as sortable bits; whether a cell is crowded.
#define LEAST_X 0
#define LEAST_Y 1
#define GREATEST_X 2
#define GREATEST_Y 3
#define CELL_CROWDED 4

// Ints in the order of the floats, and back.
int sortable(float f) {
    int bits = as_int(f);
    return bits ^ ((bits >> 31) & INT_MAX);
}

float unsorted(int bits) { return as_float(bits ^ ((bits >> 31) & INT_MAX)); }

// Index space: EXTENT_ITEMS.
kernel void queries_extent(global const int *homeId, global const float4 *homeCircle, int slots, global int *extent) {
    local int found[4];
    int item = (int) get_local_id(0);
    if (item < 4) found[item] = INT_MAX;
    barrier(CLK_LOCAL_MEM_FENCE);
    int4 own = (int4)(INT_MAX);
    for (int slot = (int) get_global_id(0); slot < slots; slot += (int) get_global_size(0)) {
        if (homeId[slot] < 0) continue;
        float4 c = homeCircle[slot];
        own = min(own, (int4)(sortable(c.x), sortable(c.y), sortable(-c.x), sortable(-c.y)));
    }
    atomic_min(&found[LEAST_X], own.x);
    atomic_min(&found[LEAST_Y], own.y);
    atomic_min(&found[GREATEST_X], own.z);
    atomic_min(&found[GREATEST_Y], own.w);
    barrier(CLK_LOCAL_MEM_FENCE);
    if (item == 0) {
        for (int k = 0; k < 4; k++) atomic_min(&extent[k], found[k]);
    }
}

int cellBetween(float at, float low, float high, int bits) {
    float width = high - low;
    if (!(width > 0.0f)) return 0;
    return clamp((int) ((at - low) / width * (float) (1 << bits)), 0, (1 << bits) - 1);
}

// Through 2^bits columns and rows.
int hilbertPlace(int column, int row, int bits) {
    int place = 0;
    for (int bit = bits - 1; bit >= 0; bit--) {
        int right = column >> bit & 1;
        int upper = row >> bit & 1;
        place = place << 2 | (3 * right ^ upper);
        if (upper == 0) {
            int from = right ? ~column : column;
            column = right ? ~row : row;
            row = from;
        }
    }
    return place;
}

// Index space: slots at home.
kernel void queries_tally(global const int *homeId, global const float4 *homeCircle, int slots, int bits,
                          global int *extent, global int *cellOf, global int *rank, global int *tally) {
    int slot = (int) get_global_id(0);
    if (slot >= slots || homeId[slot] < 0) return;
    float4 c = homeCircle[slot];
    int column = cellBetween(c.x, unsorted(extent[LEAST_X]), -unsorted(extent[GREATEST_X]), bits);
    int row = cellBetween(c.y, unsorted(extent[LEAST_Y]), -unsorted(extent[GREATEST_Y]), bits);
    int place = hilbertPlace(column, row, bits);
    int before = atomic_inc(&tally[place]);
    cellOf[slot] = place;
    rank[slot] = before;
    if (before == MOST_IN_A_CELL) extent[CELL_CROWDED] = 1;
}

// x, y, radius, id. Index space: slots at home.
kernel void queries_place(global const int *homeId, global const float4 *homeCircle, int slots,
                          global const int *cellOf, global const int *rank, global const int *cellStart,
                          global float4 *circle, global int *id) {
    int slot = (int) get_global_id(0);
    if (slot >= slots || homeId[slot] < 0) return;
    int place = cellStart[cellOf[slot]] + rank[slot];
    circle[place] = homeCircle[slot];
    id[place] = homeId[slot];
}

// Least x, y, greatest x, y; from numbers, since Oclgrind 21.10 crashes on a vector of vectors.
float4 enclosing(float4 a, float4 b) {
    return (float4)(minf(a.x, b.x), minf(a.y, b.y), maxf(a.z, b.z), maxf(a.w, b.w));
}

// Larger by what covers the rounding of exact tests. Index space: a box.
kernel void queries_boxCircles(global const float4 *circle, int circles, int boxes, global float4 *box) {
    int b = (int) get_global_id(0);
    if (b >= boxes) return;
    float4 around = (float4)(INFINITY, INFINITY, -INFINITY, -INFINITY);
    int end = min(CIRCLES_A_BOX * (b + 1), circles);
    for (int k = CIRCLES_A_BOX * b; k < end; k++) {
        float4 c = circle[k];
        float reachX = c.z + (fabs(c.x) + c.z) * TREE_MARGIN;
        float reachY = c.z + (fabs(c.y) + c.z) * TREE_MARGIN;
        around = enclosing(around, (float4)(c.x - reachX, c.y - reachY, c.x + reachX, c.y + reachY));
    }
    box[b] = around;
}

// below: where the level below begins, and how many boxes it has. Index space: a box.
kernel void queries_boxBoxes(global float4 *box, int below, int boxesBelow, int start, int boxes) {
    int b = (int) get_global_id(0);
    if (b >= boxes) return;
    float4 around = box[below + BOXES_A_BOX * b];
    int end = min(BOXES_A_BOX * (b + 1), boxesBelow);
    for (int k = BOXES_A_BOX * b + 1; k < end; k++) {
        around = enclosing(around, box[below + k]);
    }
    box[start + b] = around;
}
