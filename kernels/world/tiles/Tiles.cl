// uses: world/stages/World.cl
// Tiles: a pass over all like contacts in one launch. A work-group copies the circles of a region into local memory, makes the pass there,
// and writes back those of its tile: of its cells, and the contacts of their groups.
//
// A group touches the 2 x 2 cells from its own on, and tiles begin at odd columns and rows. Going back from colour 3 to 0, the cells that a
// result depends on grow by a column at each side a colour, and by a row between colours 2 and 1: a region reaches 3 columns and 1 row
// beyond its tile. What lies there several work-groups compute, to the same bits, so a pass reads one copy of the state and writes another.
// A tile that spans the torus has no border on that axis.
//
// The first tiles begin at column and row -1; the last may be smaller. If some hold too much, a step has a list of tiles (TileCuts.cl).
//
// A contact waits only for those before it that share a circle: its round is the first in which these are done. That gives the bits of the
// order, in half as many dependent steps as colours. A round has parts of a contact a work-item.

// From the host. TILE_GROUP: work-items, but not of whole steps in one launch; HALO_COLUMNS: the 3 columns.
#define HALO_ROWS 1
#define TILE_ROWS (8 + 2 * HALO_ROWS) // of the largest region, see TileSizes
#define TILE_COLUMNS (32 + 2 * HALO_COLUMNS)
#define TILE_CELLS (TILE_COLUMNS * TILE_ROWS)

// Gathered reads would be most of a pass: a tile has copies, in its own order, of what each tile can follow. What a contact's owner alone
// finds out lies by contact, in held and impulse, numbered in a tile's order.
#define NOT_OWN ((int) 0x80000000)

// An entry of TILE_AT_SLOTS: a slot; AT_WALL: it has impulses of walls, or bounces off one, or pieces of terrain are near; NOT_OWN: not the
// tile's.
#define AT_WALL 0x40000000
#define ENTRY_SLOT 0x3fffffff

// All work-items go round equally often, with no barrier behind a condition: compilers that run work-items in loops get that wrong.
#define TILE_EACH(i, count)                                                                                            \
    for (int first_##i = 0, i; first_##i < (count); first_##i += (int) get_local_size(0))                              \
        if ((i = first_##i + (int) get_local_id(0)) < (count))

global int *recordOf(const World *w, int tile) { return w->tiles + (size_t) tile * TILE_WORDS; }
global int2 *placedFrom(const World *w, int firstCopy) { return w->placed + firstCopy; }

// Of lower id and of higher id, by their numbers in the region; its round.
#if TILE_CIRCLES > 0x7ff || TILE_ROUNDS > 0x1ff
#error "circlesOf has no room for so many"
#endif
int circlesOf(int lower, int higher, int round) { return lower | higher << 11 | round << 22; }
int lowerOf(int circles) { return circles & 0x7ff; }
int higherOf(int circles) { return circles >> 11 & 0x7ff; }
int roundOf(int circles) { return circles >> 22 & 0x1ff; }

// In cells of the torus.
typedef struct {
    int level;
    int columnsLog, torusColumns, torusRows; // of the torus
    int firstColumn, firstRow;               // where the region begins
    int columns, rows;                       // of the region
    int left, bottom;                        // where the tile begins in the region
    int width, height;                       // of the tile
    bool ringX, ringY;                       // whether it spans the torus
} Region;

// Beyond its end by less than once around.
int wrapped(int column, int side) { return column < side ? column : column - side; }

// Level after level, the finest first.
int levelOfTile(const World *w, int tile) {
    constant Levels *levels = w->levels;
    int n = 0;
    while (n < levels->usedCount - 1 && tile >= levels->firstTile[levels->used[n + 1]]) n++;
    return levels->used[n];
}

// column, row: from the first tile; wl, hl: log2 of columns and rows.
Region regionAt(const World *w, int l, int column, int row, int wl, int hl) {
    int cl = w->levels->columnsLog[l];
    Region r;
    r.level = l;
    r.columnsLog = cl;
    r.torusColumns = w->levels->columnCount[l];
    r.torusRows = w->levels->rowCount[l];
    r.ringX = wl == cl;
    r.ringY = hl == w->levels->rowsLog[l];
    r.width = min(1 << wl, r.torusColumns - column);
    r.height = min(1 << hl, r.torusRows - row);
    r.left = r.ringX ? 0 : HALO_COLUMNS;
    r.bottom = r.ringY ? 0 : HALO_ROWS;
    r.columns = r.width + 2 * r.left;
    r.rows = r.height + 2 * r.bottom;
    int firstColumn = column - 1 - HALO_COLUMNS;
    int firstRow = row - 1 - HALO_ROWS;
    r.firstColumn = r.ringX ? 0 : firstColumn < 0 ? firstColumn + r.torusColumns : firstColumn;
    r.firstRow = r.ringY ? 0 : firstRow < 0 ? firstRow + r.torusRows : firstRow;
    return r;
}

// Of a tile that is not cut.
Region regionOf(const World *w, int tile) {
    int l = levelOfTile(w, tile);
    int wl = w->levels->tileColumnsLog[l];
    int hl = w->levels->tileRowsLog[l];
    int number = tile - w->levels->firstTile[l];
    int ty = number / w->levels->tilesAcross[l];
    int tx = number - ty * w->levels->tilesAcross[l];
    return regionAt(w, l, tx << wl, ty << hl, wl, hl);
}

bool owns(const Region *r, int column, int row) {
    return column >= r->left && column < r->left + r->width && row >= r->bottom && row < r->bottom + r->height;
}

int groupAt(const World *w, const Region *r, int column, int row) {
    return groupOf(w, r->level, wrapped(r->firstColumn + column, r->torusColumns), wrapped(r->firstRow + row, r->torusRows));
}

// At column 0.
int bucketOfRow(const World *w, const Region *r, int row) {
    return w->levels->first[r->level] + (wrapped(r->firstRow + row, r->torusRows) << r->columnsLog);
}

// [x, y), and behind the edge of the torus [z, w).
int4 slotsInRow(const World *w, const Region *r, int row) {
    int bucket = bucketOfRow(w, r, row);
    int width = r->torusColumns;
    int end = r->firstColumn + r->columns;
    int first = w->bucketStart[bucket];
    return (int4)(w->bucketStart[bucket + r->firstColumn], w->bucketStart[bucket + min(end, width)], first,
                  end <= width ? first : w->bucketStart[bucket + end - width]);
}

int circlesInRow(int4 slots) { return slots.y - slots.x + slots.w - slots.z; }

// In the region of a tile that depends on them.
typedef struct {
    int column, row;  // of the first one
    int across, down; // how many; columns and rows are two apart
} Groups;

Groups groupsOfColour(const Region *r, int colour) {
    Groups g;
    g.column = r->ringX ? colour & 1 : colour;
    g.row = colour >> 1;
    g.across = r->ringX ? r->columns >> 1 : (r->width >> 1) + HALO_COLUMNS - colour;
    g.down = r->ringY ? r->rows >> 1 : (r->height >> 1) + HALO_ROWS - g.row;
    return g;
}

int contactsInGroups(const World *w, int first, int groups) { return w->groupStart[first + groups] - w->groupStart[first]; }

// One behind the other, up to the edge of the torus.
int contactsInRow(const World *w, const Region *r, const Groups *g, int line) {
    int oy = wrapped(r->firstRow + g->row + 2 * line, r->torusRows);
    int ox = wrapped(r->firstColumn + g->column, r->torusColumns);
    int before = min(g->across, (r->torusColumns - ox + 1) >> 1);
    return contactsInGroups(w, groupOf(w, r->level, ox, oy), before) +
           contactsInGroups(w, groupOf(w, r->level, ox & 1, oy), g->across - before);
}

// Tiles must be smaller, or there must be none.
void refuseTile(const World *w, int peak) {
    atomic_max(&w->status[TILE_PEAK], peak);
    atomic_or(&w->status[OUT_OF_ROOM], 1);
}

#define TILE_KERNEL kernel __attribute__((reqd_work_group_size(TILE_GROUP, 1, 1))) void
