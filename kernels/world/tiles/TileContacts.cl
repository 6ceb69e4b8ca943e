// uses: world/stages/Contacts.cl world/shared/PairRows.cl world/tiles/Tiles.cl
// Stage Contacts by tiles: puts listed contacts in order within their groups.

// In a cache line: a tile's copies begin with one.
#define LINE_COPIES 8

int wholeLines(int copies) { return (copies + LINE_COPIES - 1) & ~(LINE_COPIES - 1); }

// In 32 bits, from the group's cell: for the lower id and the higher, the place in its cell (13 bits) and the cell; whether it carries.
#define LINK_PLACE 0x1fff
#define LINK_COLUMN 0x2000
#define LINK_ROW 0x4000
#define LINK_CARRYING 0x8000

uint linkOf(int lowColumn, int lowRow, int lowPlace, int highColumn, int highRow, int highPlace, bool carrying) {
    return (uint) (lowPlace & LINK_PLACE) | (lowColumn ? LINK_COLUMN : 0) | (lowRow ? LINK_ROW : 0) |
           (carrying ? LINK_CARRYING : 0) |
           (uint) ((highPlace & LINK_PLACE) | (highColumn ? LINK_COLUMN : 0) | (highRow ? LINK_ROW : 0)) << 16;
}

void linkContact(const World *w, int listed) {
    if (listed == 0) {
        w->status[TILE_NUMBERS] = 0;
        // Cross contacts lie before the copies.
        w->status[TILE_COPIES] = wholeLines(contactsListed(w) - likeContacts(w));
    }
    ulong2 own = listedOf(w)[listed];
    ulong ids = own.x;
    uint2 p = as_uint2(own.y);
    int low = w->bucketOf[p.LOWER];
    int high = w->bucketOf[p.HIGHER];
    int l = levelOfBucket(w, low);
    int first = w->levels->first[l];
    int cl = w->levels->columnsLog[l];
    int columnMask = (1 << cl) - 1;
    int lowColumn = (low - first) & columnMask;
    int highColumn = (high - first) & columnMask;
    int lowRow = (low - first) >> cl;
    int highRow = (high - first) >> cl;
    int column = ringFirst(lowColumn, highColumn, w->levels->columnCount[l]);
    int row = ringFirst(lowRow, highRow, w->levels->rowCount[l]);
    int group = groupOf(w, l, column, row);
    int from = w->groupStart[group];
    int to = w->groupStart[group + 1];
    if (to - from > LONGEST_GROUP) {
        // Only if crowds are thinned out. Those who arrange tiles refuse the step: here others ask whether it has been.
        atomic_max(&w->status[TILE_PEAK], TILE_NONE);
        return;
    }
    int c = from;
    for (int other = from; other < to; other++) c += listedOf(w)[other].x < ids;

    IF_TURNING(PairSurface s = fillRows(w, c, p, (int) ids, p.LOWER, p.HIGHER, 1.0f);)
    IF_TURNING(w->startSpins[c] = rowsAct(&s) ? spinImpulses(w, p, &s, w->rowImpulses[c]) : (float2)(0.0f);)
    bool carrying;
    float4 n = newContact(w, p, ids, baseOfPair(w, p), rowsAt(w, c), &carrying);
    startImpulsesOf(w)[c] = loadOf(w, c, n.NORMAL, n.NORMAL_IMPULSE);
    startingOf(w)[c] = n;
    w->link[c] = linkOf(lowColumn != column, lowRow != row, (int) p.LOWER - w->bucketStart[low], highColumn != column,
                        highRow != row, (int) p.HIGHER - w->bucketStart[high], carrying);
}

// Index space: any; work-items take contacts in turn. Cost: those of a group.
kernel void contacts_link(WORLD_PARAMETERS) {
    World w = WORLD;
    if (refused(&w)) return;
    int contacts = likeContacts(&w);
    for (int c = (int) get_global_id(0); c < contacts; c += (int) get_global_size(0)) linkContact(&w, c);
}
