// uses: world/tiles/Tiles.cl
// Stage Contacts by tiles: lists the tiles of a step in which some hold too much. These are cut in two until all fit, down to 2 x 2 cells.

// A listed tile in 31 bits: its first block of 2 x 2 cells, fewer than 2^26 (the Java class Limits); log2 of columns and rows.
#define CUT_BLOCK 0x3ffffff
#define CUT_COLUMNS_SHIFT 26
#define CUT_ROWS_SHIFT 29

// Level, first column, first row.
int3 placeOfBlock(const World *w, int block) {
    int l = levelOfBucket(w, 4 * block);
    int inLevel = block - (w->levels->first[l] >> 2);
    int cl = w->levels->columnsLog[l] - 1;
    return (int3)(l, 2 * (inLevel & ((1 << cl) - 1)), 2 * (inLevel >> cl));
}

// Without cells behind the end of the list.
Region regionOfListed(const World *w, int tile) {
    bool isListed = tile < w->status[TILES_LISTED];
    int cut = isListed ? recordOf(w, tile)[TILE_AT_CUT] : 0;
    int3 place = placeOfBlock(w, cut & CUT_BLOCK);
    Region r = regionAt(w, place.x, place.y, place.z, cut >> CUT_COLUMNS_SHIFT & 7, cut >> CUT_ROWS_SHIFT);
    if (!isListed) r.rows = r.columns = 0;
    return r;
}

// Columns down to 8, then rows, then columns; no widths whose region goes round the torus more than once. Returns false for one of the
// smallest.
bool halve(const World *w, int l, int *wl, int *hl) {
    int narrower = *wl - 1;
    while (narrower > 0 && (1 << narrower) + 2 * HALO_COLUMNS > w->levels->columnCount[l]) narrower--;
    if (narrower >= 3 || (narrower > 0 && *hl == 1)) {
        *wl = narrower;
        return true;
    }
    if (*hl > 1) {
        --*hl;
        return true;
    }
    return false;
}

int circlesInRegion(const World *w, const Region *r) {
    int sum = 0;
    for (int row = 0; row < r->rows; row++) sum += circlesInRow(slotsInRow(w, r, row));
    return sum;
}

int contactsInRegion(const World *w, const Region *r) {
    int sum = 0;
    for (int colour = 0; colour < 4; colour++) {
        Groups g = groupsOfColour(r, colour);
        for (int line = 0; line < g.down; line++) sum += contactsInRow(w, r, &g, line);
    }
    return sum;
}

// If it is its first block.
void cutTile(const World *w, int block) {
    int3 place = placeOfBlock(w, block);
    int l = place.x;
    int column = place.y;
    int row = place.z;
    if (column >= w->levels->columnCount[l] || row >= w->levels->rowCount[l]) return;
    int wl = w->levels->tileColumnsLog[l];
    int hl = w->levels->tileRowsLog[l];
    bool cut = false;
    for (;;) {
        Region r = regionAt(w, l, column >> wl << wl, row >> hl << hl, wl, hl);
        int circles = circlesInRegion(w, &r);
        if (circles == 0) return;
        if (circles <= TILE_CIRCLES && contactsInRegion(w, &r) <= TILE_CONTACTS) break;
        if (!halve(w, l, &wl, &hl)) break;
        cut = true;
    }
    if (((column & ((1 << wl) - 1)) | (row & ((1 << hl) - 1))) != 0) return;
    if (cut) w->status[TILES_CUT] = 1;
    int tile = atomic_inc(&w->status[TILES_LISTED]);
    if (tile < w->levels->tileCount) recordOf(w, tile)[TILE_AT_CUT] = block | wl << CUT_COLUMNS_SHIFT | hl << CUT_ROWS_SHIFT;
}

// Counts those without room, too. Index space: a block of 2 x 2 cells. Cost: rows of regions around it.
kernel void contacts_cutTiles(WORLD_PARAMETERS) {
    World w = WORLD;
    int block = (int) get_global_id(0);
    if (block < likeGroups(&w) >> 2 && !refused(&w)) cutTile(&w, block);
}
