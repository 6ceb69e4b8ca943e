// uses: world/tiles/TileContacts.cl
// Stage Contacts by tiles: lists the tiles of a step in which some hold too much. These are cut in two until all fit, down to 2 x 2 cells.
//
// Where cells share buckets, as in a straight row of many circles in an arena as wide, the smallest may hold too much of many sheets. Circles
// of two sheets do not meet, so the tile has layers then, each with the sheets whose keys lie in one part of all keys. Keys are
// counted from the sheet of the region's first cell: cells behind the seam of the torus belong to the next sheet.

// A listed tile in 31 bits: its first block of 2 x 2 cells, fewer than 2^26 (the Java class Limits); log2 of columns and rows.
#define CUT_BLOCK 0x3ffffff
#define CUT_COLUMNS_SHIFT 26
#define CUT_ROWS_SHIFT 29

// Its layer, and log2 of how many there are.
#define LAYER_NUMBER 0xff
#define LAYERS_SHIFT 8

// Circles in all layers of a region: no cell may have more than a link has room for.
#define MOST_IN_LAYERS LINK_PLACE
#define LAYER_CELLS ((2 + 2 * HALO_COLUMNS) * (2 + 2 * HALO_ROWS))

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
    int cut = isListed ? recordOf(w, tile)[RECORD_CUT] : 0;
    int3 place = placeOfBlock(w, cut & CUT_BLOCK);
    Region r = regionAt(w, place.x, place.y, place.z, cut >> CUT_COLUMNS_SHIFT & 7, cut >> CUT_ROWS_SHIFT);
    int layers = isListed ? recordOf(w, tile)[RECORD_LAYER] : 0;
    r.layer = layers & LAYER_NUMBER;
    r.layersLog = layers >> LAYERS_SHIFT;
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

// A tile may own contacts of circles that its neighbours own.
bool ownsAny(const World *w, const Region *r) {
    Region own = *r;
    own.firstColumn = wrapped(r->firstColumn + r->left, r->torusColumns);
    own.firstRow = wrapped(r->firstRow + r->bottom, r->torusRows);
    own.columns = r->width;
    own.rows = r->height;
    if (circlesInRegion(w, &own) > 0) return true;
    int sum = 0;
    for (int colour = 0; colour < 4; colour++) {
        Groups g = {r->left + (colour & 1), r->bottom + (colour >> 1), r->width >> 1, r->height >> 1};
        for (int line = 0; line < g.down; line++) sum += contactsInRow(w, r, &g, line);
    }
    return sum > 0;
}

// log2 of how many take it, each with an eighth of its room to spare, since keys are spread evenly; 0 where there is but one. Not where an
// axis wraps: keys of the first sheets do not follow those of the last.
int layersFor(const World *w, const Region *r, int circles, int contacts) {
    int l = r->level;
    bool has = w->levels->folded[l] && w->levels->sheetsX[l] == ENDLESS && w->levels->sheetsY[l] == ENDLESS;
    if (!has || r->ringX || r->ringY || circles > MOST_IN_LAYERS) return 0;
    int log = 0;
    while (log < LAYERS_SHIFT && (circles >> log > TILE_CIRCLES - TILE_CIRCLES / 8 || contacts >> log > TILE_CONTACTS - TILE_CONTACTS / 8)) log++;
    return log;
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
    int layers = 0;
    bool cut = false;
    Region r;
    for (;;) {
        r = regionAt(w, l, column >> wl << wl, row >> hl << hl, wl, hl);
        int circles = circlesInRegion(w, &r);
        if (circles == 0) return;
        if (circles <= TILE_CIRCLES && contactsInRegion(w, &r) <= TILE_CONTACTS) break;
        if (!halve(w, l, &wl, &hl)) {
            layers = layersFor(w, &r, circles, contactsInRegion(w, &r));
            cut |= layers > 0;
            break;
        }
        cut = true;
    }
    if (((column & ((1 << wl) - 1)) | (row & ((1 << hl) - 1))) != 0) return;
    if (cut) w->status[TILES_CUT] = 1; // whole, it would be refused even if it owns nothing
    if (!ownsAny(w, &r)) return;
    int tile = atomic_add(&w->status[TILES_LISTED], 1 << layers);
    for (int layer = 0; layer < 1 << layers && tile + layer < w->levels->tileCount; layer++) {
        global int *record = recordOf(w, tile + layer);
        record[RECORD_CUT] = block | wl << CUT_COLUMNS_SHIFT | hl << CUT_ROWS_SHIFT;
        record[RECORD_LAYER] = layer | layers << LAYERS_SHIFT;
    }
}

// Counts those without room, too. Index space: a block of 2 x 2 cells. Cost: rows of regions around it.
kernel void contacts_cutTiles(WORLD_PARAMETERS) {
    World w = WORLD;
    int block = (int) get_global_id(0);
    if (block < likeGroups(&w) >> 2 && !refused(&w)) cutTile(&w, block);
}
