// Tiles: how a pass over all contacts is made in one launch, where all circles are of one level. A work-group takes a tile
// of cells and a region around it, copies the circles of the region into local memory, makes the pass there, colour by
// colour, and writes back what is its own: the circles in the cells of the tile, and the contacts of the groups there.
//
// A group touches the 2 x 2 cells from its own on, so what a colour changes depends on the cells next to it alone. Tiles
// begin at odd columns and rows. Going back from colour 3, whose groups begin at odd columns and rows too, to colour 0, the
// cells that the result depends on grow by a column at each side a colour, and by a row between colours 2 and 1: a region
// reaches 3 columns and 1 row beyond its tile. What lies there is computed by several work-groups, to the same bits. So a
// pass reads one copy of the state and writes another. A tile that spans the torus has no border on that axis.
//
// No kernels here. Cost of a pass: the region's circles are read once, its contacts once.

// TILE_GROUP: work-items of a work-group; no colour has more groups in a region. TILE_CIRCLES: room for circles.
#define TILE_CELLS 400
#define TILE_ROWS 20
#define HALO_COLUMNS 3
#define HALO_ROWS 1
#define TILE_CONTACTS 512 // most contacts of a group: a crowd is better put in order by Contacts.cl
#define CROWDED 0x7fffffff // TILE_PEAK where a group has more

// A tile and the region around it, in cells of the torus.
typedef struct {
    int columnsLog, columnMask, rowMask; // of the torus
    int firstColumn, firstRow;           // where the region begins
    int columns, rows;                   // of the region
    int left, bottom;                    // where the tile begins in the region
    int width, height;                   // of the tile
    bool ringX, ringY;                   // whether it spans the torus
} Region;

// A region in local memory. Its circles are numbered row by row.
typedef struct {
    float2 velocity[TILE_CIRCLES];
    float2 load[TILE_CIRCLES]; // in the biased pass the velocity before any impulse, in the relaxing pass sums of impulses
    float inverseMass[TILE_CIRCLES];
    int slot[TILE_CIRCLES]; // of circles that are not the tile's own: NOT_OWN too
    uchar flags[TILE_CIRCLES];

    int4 share[4][TILE_GROUP]; // by colour and work-item: see shareGroups

    ushort cellStart[TILE_CELLS + 1]; // by cell: its first circle
    int rowStart[TILE_ROWS + 1];      // by row: its first circle
    int rowCount[TILE_ROWS];          // by row: its circles
    int rowSlot[TILE_ROWS];           // by row: the slot of its first circle
    int rowSplit[TILE_ROWS];          // by row: its circles before the edge of the torus
    int rowWrapped[TILE_ROWS];        // by row: the slot of the first circle behind that edge
} Tile;

#define NOT_OWN ((int) 0x80000000)

// Flags of a circle.
#define LOADED 1
#define CARRIED 2

int tileCount(const World *w) {
    int l = w->levels->used[0];
    return 1 << (w->levels->columnsLog[l] - w->levels->tileColumnsLog + w->levels->rowsLog[l] - w->levels->tileRowsLog);
}

Region regionOf(const World *w, int tile) {
    int l = w->levels->used[0];
    int cl = w->levels->columnsLog[l];
    int rl = w->levels->rowsLog[l];
    int wl = w->levels->tileColumnsLog;
    int hl = w->levels->tileRowsLog;
    Region r;
    r.columnsLog = cl;
    r.columnMask = (1 << cl) - 1;
    r.rowMask = (1 << rl) - 1;
    r.ringX = wl == cl;
    r.ringY = hl == rl;
    r.width = 1 << wl;
    r.height = 1 << hl;
    r.left = r.ringX ? 0 : HALO_COLUMNS;
    r.bottom = r.ringY ? 0 : HALO_ROWS;
    r.columns = r.width + 2 * r.left;
    r.rows = r.height + 2 * r.bottom;
    int tx = tile & ((1 << (cl - wl)) - 1);
    int ty = tile >> (cl - wl);
    r.firstColumn = r.ringX ? 0 : ((tx << wl) + 1 - HALO_COLUMNS) & r.columnMask;
    r.firstRow = r.ringY ? 0 : ((ty << hl) + 1 - HALO_ROWS) & r.rowMask;
    return r;
}

// The bucket in which a row of a region begins on the torus, at column 0.
int bucketOfRow(const World *w, const Region *r, int row) {
    return w->levels->first[w->levels->used[0]] + (((r->firstRow + row) & r->rowMask) << r->columnsLog);
}

// The circles in a row of a region; *split: those before the edge of the torus.
int circlesInRow(const World *w, const Region *r, int row, int *split) {
    int bucket = bucketOfRow(w, r, row);
    int width = 1 << r->columnsLog;
    int end = r->firstColumn + r->columns;
    int from = w->bucketStart[bucket + r->firstColumn];
    *split = w->bucketStart[bucket + min(end, width)] - from;
    return end <= width ? *split : *split + w->bucketStart[bucket + end - width] - w->bucketStart[bucket];
}

// Numbers the circles of a region. All work-items of the work-group; returns how many circles there are.
int mapRegion(const World *w, const Region *r, local Tile *t) {
    int item = (int) get_local_id(0);
    int width = 1 << r->columnsLog;
    barrier(CLK_LOCAL_MEM_FENCE);
    if (item < r->rows) {
        int bucket = bucketOfRow(w, r, item);
        int split;
        t->rowCount[item] = circlesInRow(w, r, item, &split);
        t->rowSplit[item] = split;
        t->rowSlot[item] = w->bucketStart[bucket + r->firstColumn];
        t->rowWrapped[item] = w->bucketStart[bucket];
    }
    barrier(CLK_LOCAL_MEM_FENCE);
    if (item <= r->rows) {
        int sum = 0;
#pragma unroll 1
        for (int before = 0; before < item; before++) sum += t->rowCount[before];
        t->rowStart[item] = sum;
    }
    barrier(CLK_LOCAL_MEM_FENCE);
    int cells = r->columns * r->rows;
    int circles = t->rowStart[r->rows];
    if (item == 0) t->cellStart[cells] = (ushort) circles;
    for (int cell = item; cell < cells; cell += TILE_GROUP) {
        int row = cell / r->columns;
        int inRow = cell - row * r->columns;
        int column = r->firstColumn + inRow;
        int bucket = bucketOfRow(w, r, row) + (column & r->columnMask);
        int from = w->bucketStart[bucket];
        int to = w->bucketStart[bucket + 1];
        int i = t->rowStart[row] + from - (column < width ? t->rowSlot[row] : t->rowWrapped[row] - t->rowSplit[row]);
        t->cellStart[cell] = (ushort) i;
        bool own = row >= r->bottom && row < r->bottom + r->height && inRow >= r->left && inRow < r->left + r->width;
        for (int slot = from; slot < to; slot++) t->slot[i++] = own ? slot : slot | NOT_OWN;
    }
    barrier(CLK_LOCAL_MEM_FENCE);
    return circles;
}

// The group that a work-item takes of a colour in a pass: its column and row in the region. Returns whether there is one.
// Column and row -1 mean the cell before the region, which only a sum over the region's own circles needs.
bool groupOfItem(const Region *r, int colour, bool sums, int *column, int *row) {
    int item = (int) get_local_id(0);
    int px = colour & 1;
    int py = colour >> 1;
    int across, down;
    if (r->ringX) {
        across = r->columns >> 1;
        *column = px;
    } else if (sums) {
        across = (r->columns >> 1) + px;
        *column = -px;
    } else {
        across = (r->width >> 1) + HALO_COLUMNS - colour;
        *column = colour;
    }
    if (r->ringY) {
        down = r->rows >> 1;
        *row = py;
    } else if (sums) {
        down = (r->rows >> 1) + py;
        *row = -py;
    } else {
        down = (r->height >> 1) + HALO_ROWS - py;
        *row = py;
    }
    int line = item / across;
    *column += 2 * (item - line * across);
    *row += 2 * line;
    return line < down;
}

bool ownsGroup(const Region *r, int column, int row) {
    return column >= r->left && column < r->left + r->width && row >= r->bottom && row < r->bottom + r->height;
}

// The first circle of a cell; outside of the region a number that no circle has.
int cellStartOf(const Region *r, local const Tile *t, int column, int row) {
    if (r->ringX) column &= r->columnMask;
    if (r->ringY) row &= r->rowMask;
    bool inside = column >= 0 && column < r->columns && row >= 0 && row < r->rows;
    return inside ? t->cellStart[row * r->columns + column] : 0xffff;
}

// Notes the work-item's group of each colour: the first contact (and NOT_OWN) and the end of its contacts, the first circles
// of its cells (0, 0) and (1, 0) in 16 bits each, of (0, 1) and (1, 1). Nobody else reads it.
void shareGroups(const World *w, const Region *r, local Tile *t, bool sums) {
    int l = w->levels->used[0];
#pragma unroll 1
    for (int colour = 0; colour < 4; colour++) {
        int column, row;
        int4 share = (int4)(0);
        if (groupOfItem(r, colour, sums, &column, &row)) {
            int group = groupOf(w, l, (r->firstColumn + column) & r->columnMask, (r->firstRow + row) & r->rowMask);
            share.x = w->groupStart[group];
            share.y = w->groupStart[group + 1];
            if (!ownsGroup(r, column, row)) share.x |= NOT_OWN;
            share.z = cellStartOf(r, t, column, row) | cellStartOf(r, t, column + 1, row) << 16;
            share.w = cellStartOf(r, t, column, row + 1) | cellStartOf(r, t, column + 1, row + 1) << 16;
        }
        t->share[colour][get_local_id(0)] = share;
    }
}

// A contact's circles as seen from its group, in 32 bits: for the lower id and for the higher, the place in its cell (13
// bits) and the cell (column, row); and whether the contact carries as the step begins.
#define LINK_PLACE 0x1fff
#define LINK_COLUMN 0x2000
#define LINK_ROW 0x4000
#define LINK_CARRYING 0x8000

uint linkOf(int lowColumn, int lowRow, int lowPlace, int highColumn, int highRow, int highPlace, bool carrying) {
    return (uint) (lowPlace & LINK_PLACE) | (lowColumn ? LINK_COLUMN : 0) | (lowRow ? LINK_ROW : 0) |
           (carrying ? LINK_CARRYING : 0) |
           (uint) ((highPlace & LINK_PLACE) | (highColumn ? LINK_COLUMN : 0) | (highRow ? LINK_ROW : 0)) << 16;
}

int circleOfLink(int4 share, uint part) {
    uint cells = (uint) (part & LINK_ROW ? share.w : share.z);
    return (int) ((part & LINK_COLUMN ? cells >> 16 : cells & 0xffff) + (part & LINK_PLACE));
}

// The circles of a contact, the lower id first. Outside of the region: TILE_CIRCLES or more.
int2 circlesOfLink(int4 share, uint link) {
    return (int2)(circleOfLink(share, link), circleOfLink(share, link >> 16));
}
