// Stage Contacts for tiles: from the contacts that Contacts.cl has listed group by group, those in order, with what does not
// change during the step.

// Puts a listed contact in its place within its group, measures it for the first sub-step, and links it to its circles.
void linkContact(const World *w, int listed) {
    if (listed == 0) {
        w->status[TILE_NUMBERS] = 0;
        w->status[TILE_COPIES] = 0;
    }
    int l = w->levels->used[0];
    int first = w->levels->first[l];
    int cl = w->levels->columnsLog[l];
    int columnMask = (1 << cl) - 1;
    uint2 p = w->pair[listed];
    ulong ids = w->key[listed];
    int low = w->bucketOf[p.x];
    int high = w->bucketOf[p.y];
    int lowColumn = (low - first) & columnMask;
    int highColumn = (high - first) & columnMask;
    int lowRow = (low - first) >> cl;
    int highRow = (high - first) >> cl;
    int column = ringFirst(lowColumn, highColumn, columnMask);
    int row = ringFirst(lowRow, highRow, (1 << w->levels->rowsLog[l]) - 1);
    int group = groupOf(w, l, column, row);
    int from = w->groupStart[group];
    int to = w->groupStart[group + 1];
    if (to - from > LONGEST_GROUP) {
        // Only where crowds are thinned out: others have been refused when they were counted.
        refuseTile(w, NO_TILE);
        return;
    }
    int c = from;
    for (int other = from; other < to; other++) c += w->key[other] < ids;

    bool carrying;
    float4 n = newContact(w, p, ids, &carrying);
    w->impulse[c] = (float2)(n.x * n.w, n.y * n.w);
    w->masses[c] = n;
    w->link[c] = linkOf(lowColumn != column, lowRow != row, (int) p.x - w->bucketStart[low], highColumn != column,
                        highRow != row, (int) p.y - w->bucketStart[high], carrying);
}

// Index space: any number of work-items, which take the contacts in turn. Cost: the contacts of a
// group, and those remembered of a circle.
kernel void contacts_link(WORLD_PARAMETERS) {
    World w = WORLD;
    if (refused(&w)) return;
    int contacts = groupStart[levels->first[LEVELS]];
    for (int c = (int) get_global_id(0); c < contacts; c += (int) get_global_size(0)) linkContact(&w, c);
}
