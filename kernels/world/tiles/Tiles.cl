// uses: world/stages/World.cl
// Tiles: how a pass over all like contacts, those of circles of one level, is made in one launch. A work-group takes a tile
// of cells of a level and a region around it, copies the circles of the region into local memory, makes the pass there, and writes back
// what is its own: the circles in the cells of the tile, and the contacts of the groups there.
//
// A group touches the 2 x 2 cells from its own on, so what a colour changes depends on the cells next to it alone. Tiles
// begin at odd columns and rows. Going back from colour 3, whose groups begin at odd columns and rows too, to colour 0, the
// cells that the result depends on grow by a column at each side a colour, and by a row between colours 2 and 1: a region
// reaches 3 columns and 1 row beyond its tile. What lies there is computed by several work-groups, to the same bits. So a
// pass reads one copy of the state and writes another. A tile that spans the torus has no border on that axis.
//
// The first tiles begin at column and row -1, and there are as many as it takes to reach the last column and row that a circle
// can be in, or once around the torus where the arena does; the last of those are smaller where the torus is no multiple of a tile.
// Where some hold too much, the step is made with a list of tiles instead, in which these are cut: see TileCuts.cl.
//
// Within a region the contacts need not wait for colours. Each must follow those before it that share a circle with it, no
// others: its round is the first in which all of these are done. That gives the bits of the order, in about half as many
// dependent steps as the longest groups of the colours would take, and all work-items have work. A round is made in parts of no
// more contacts than the work-group has work-items.
//
// This file: regions, and what is recorded of a tile. TileCuts.cl lists tiles, TileContacts.cl and TileOrder.cl write the records,
// TileSolver.cl makes the passes, TileCircles.cl is the circles' part of both.

// From the host: TILE_CIRCLES, TILE_CONTACTS: room for those of a region; TILE_ROUNDS and TILE_PARTS: room for those; TILE_GROUP:
// work-items of a work-group, but where whole steps are made in one launch (Resident.cl); HALO_COLUMNS: the 3 columns from above.
#define HALO_ROWS 1
#define TILE_ROWS (8 + 2 * HALO_ROWS) // of the largest region, see the host class TileSizes
#define TILE_COLUMNS (32 + 2 * HALO_COLUMNS)
#define TILE_CELLS (TILE_COLUMNS * TILE_ROWS)

// As they are listed, group by group, contacts are in the order of all sums. A tile reads them in another order, and gathered
// reads would be most of a pass. So each tile has its own copies, in its order, of what only changes in a way that each can
// follow: base, shape, contact. What a contact's owner alone finds out has a place for each contact: held, impulse.
// Contacts are numbered anew for it, those of a tile in its order.
//
// A tile's record: see the Java class TileRecord. RECORD_SLOTS: by circle, see AT_WALL.
#define NOT_OWN ((int) 0x80000000)

// A circle's entry: its slot; AT_WALL where it has impulses of walls, or bounces off one; NOT_OWN where it is not the tile's.
#define AT_WALL 0x40000000
#define ENTRY_SLOT 0x3fffffff

// The work-items of a work-group take 0 to count - 1 in turn. All of them go round equally often, and no barrier here stands
// behind a condition: compilers that run the work-items of a work-group in loops have been seen to get that wrong.
#define TILE_EACH(i, count)                                                                                            \
    for (int first_##i = 0, i; first_##i < (count); first_##i += (int) get_local_size(0))                              \
        if ((i = first_##i + (int) get_local_id(0)) < (count))

global int *recordOf(const World *w, int tile) { return w->tiles + (size_t) tile * TILE_RECORD; }

// The contacts of a tile, in its order: see the array placed.
global int2 *placedFrom(const World *w, int firstCopy) { return w->placed + firstCopy; }

// The circles of a contact, by their numbers in the region: of lower id, of higher id; and its round.
#if TILE_CIRCLES > 0x7ff || TILE_ROUNDS > 0x1ff
#error "circlesOf has no room for so many"
#endif
int circlesOf(int lower, int higher, int round) { return lower | higher << 11 | round << 22; }

int lowerOf(int circles) { return circles & 0x7ff; }

int higherOf(int circles) { return circles >> 11 & 0x7ff; }

int roundOf(int circles) { return circles >> 22 & 0x1ff; }

// A tile and the region around it, in cells of the torus.
typedef struct {
    int level;
    int columnsLog, torusColumns, torusRows; // of the torus
    int firstColumn, firstRow;               // where the region begins
    int columns, rows;                       // of the region
    int left, bottom;                        // where the tile begins in the region
    int width, height;                       // of the tile
    bool ringX, ringY;                       // whether it spans the torus
} Region;

// The column (or row) of the torus of one that may lie beyond its end, by less than once around.
int wrapped(int column, int side) { return column < side ? column : column - side; }

// Tiles are numbered level after level, the finest first.
int levelOfTile(const World *w, int tile) {
    constant Levels *levels = w->levels;
    int n = 0;
    while (n < levels->usedCount - 1 && tile >= levels->firstTile[levels->used[n + 1]]) n++;
    return levels->used[n];
}

// The region of a tile. column, row: where it begins, counted from the first tile; wl, hl: log2 of its columns and rows.
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

// The region of a tile that is not cut.
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

// The number of the group that begins at a cell of a region.
int groupAt(const World *w, const Region *r, int column, int row) {
    return groupOf(w, r->level, wrapped(r->firstColumn + column, r->torusColumns),
                   wrapped(r->firstRow + row, r->torusRows));
}

// The bucket in which a row of a region begins on the torus, at column 0.
int bucketOfRow(const World *w, const Region *r, int row) {
    return w->levels->first[r->level] + (wrapped(r->firstRow + row, r->torusRows) << r->columnsLog);
}

// The slots in a row of a region, [x, y), and behind the edge of the torus, [z, w).
int4 slotsInRow(const World *w, const Region *r, int row) {
    int bucket = bucketOfRow(w, r, row);
    int width = r->torusColumns;
    int end = r->firstColumn + r->columns;
    int first = w->bucketStart[bucket];
    return (int4)(w->bucketStart[bucket + r->firstColumn], w->bucketStart[bucket + min(end, width)], first,
                  end <= width ? first : w->bucketStart[bucket + end - width]);
}

int circlesInRow(int4 slots) { return slots.y - slots.x + slots.w - slots.z; }

// The groups of a colour that a tile depends on, in its region.
typedef struct {
    int column, row;  // of the first one
    int across, down; // how many there are; those of a row are two columns apart, and rows are
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

// The contacts of a row of them, which are one behind the other up to the edge of the torus.
int contactsInRow(const World *w, const Region *r, const Groups *g, int line) {
    int oy = wrapped(r->firstRow + g->row + 2 * line, r->torusRows);
    int ox = wrapped(r->firstColumn + g->column, r->torusColumns);
    int before = min(g->across, (r->torusColumns - ox + 1) >> 1);
    return contactsInGroups(w, groupOf(w, r->level, ox, oy), before) +
           contactsInGroups(w, groupOf(w, r->level, ox & 1, oy), g->across - before);
}

// Refuses the step: tiles must be smaller, or there must be none.
void refuseTile(const World *w, int peak) {
    atomic_max(&w->status[TILE_PEAK], peak);
    atomic_or(&w->status[OUT_OF_ROOM], 1);
}

#define TILE_KERNEL kernel __attribute__((reqd_work_group_size(TILE_GROUP, 1, 1))) void
