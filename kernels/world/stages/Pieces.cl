// uses: world/shared/Paths.cl world/shared/PieceVisit.cl world/stages/PairFilter.cl world/stages/World.cl
// Stage Pieces finds the pieces of terrain that circles are near to, by the tree of their boxes. The Java class PieceSearch explains it.
//
// Contacts of a circle lie one behind the other, in the order of pieces' ids; where, is of no matter. A step that has no room for them is
// refused.

#ifdef TERRAIN
#define SIGHT_SLACK 1.125f // for rounding
#define PIECES_KEPT 8 // for more of them a circle walks twice

typedef struct {
    float4 c;
    float sight;
    int kind;              // of the circle
    int first;             // in the list; NONE as long as they are only counted
    int count;             // those found; in the list each is once, before it may be there with its images
    int kept[PIECES_KEPT]; // the first of those that are counted
} PieceSeeker;

int responseToPiece(const World *w, int kind, int kindOfPiece) {
    return w->k.filtering == 0 ? PAIR_SOLID : responseOfKinds(w, kind, kindOfPiece);
}

// Keeps the order. Returns whether it was not there.
bool insertPiece(const World *w, const PieceSeeker *s, int piece) {
    int at = s->first + s->count;
    while (at > s->first && w->piece[at - 1].TOUCHED_PIECE > piece) at--;
    if (at > s->first && w->piece[at - 1].TOUCHED_PIECE == piece) return false;
    for (int k = s->first + s->count; k > at; k--) w->piece[k] = w->piece[k - 1];
    int4 traits = pieceTraits(w, piece);
    int4 touched;
    touched.TOUCHED_PIECE = piece;
    touched.TOUCHED_SERIAL = traits.TRAIT_SERIAL;
    touched.TOUCHED_RESPONSE = responseToPiece(w, s->kind, traits.TRAIT_KIND);
    touched.TOUCHED_FEATURE = AT_FACE;
    w->piece[at] = touched;
    return true;
}

void notePiece(const World *w, PieceSeeker *s, int piece) {
    if (s->first == NONE) {
        if (s->count < PIECES_KEPT) s->kept[s->count] = piece;
        s->count++;
    } else if (insertPiece(w, s, piece)) {
        s->count++;
    }
}

bool isNearPiece(const World *w, const PieceSeeker *s, int piece) {
    global const float *row = pieceRow(w, piece);
    int4 traits = pieceTraits(w, piece);
    float2 o = offsetOf(w, s->c, row);
    return distanceOfPiece(row, traits.TRAIT_SHAPE, o.x, o.y) < s->sight + row[PIECE_MOST] &&
           responseToPiece(w, s->kind, traits.TRAIT_KIND) != PAIR_IGNORE;
}

// What boxes meet. x, y: of the circle or its image; mx, my: how far it looks.
void walkPieces(const World *w, PieceSeeker *s, float x, float y, float mx, float my) {
    global const float4 *boxes = (global const float4 *) (w->terrain + w->terrain[TERRAIN_BOXES]);
    global const int2 *links = (global const int2 *) (w->terrain + w->terrain[TERRAIN_LINKS]);
    int nodes = w->terrain[TERRAIN_NODES];
    float minX = x - mx;
    float minY = y - my;
    float maxX = x + mx;
    float maxY = y + my;
#pragma unroll 1
    for (int node = 0; node < nodes;) {
        float4 box = boxes[node];
        int2 link = links[node];
        if (box.x <= maxX && box.y <= maxY && box.z >= minX && box.w >= minY) {
            if (link.y >= 0 && isNearPiece(w, s, link.y)) notePiece(w, s, link.y);
            node++;
        } else {
            node = link.x;
        }
    }
}

void lookForPieces(const World *w, PieceSeeker *s) {
    float m = SIGHT_SLACK * s->sight;
    int timesX = 0;
    int timesY = 0;
#ifdef EDGES
    timesX = w->levels->periodX < INFINITY ? 1 : 0;
    timesY = w->levels->periodY < INFINITY ? 1 : 0;
#endif
#pragma unroll 1
    for (int u = -timesX; u <= timesX; u++) {
#pragma unroll 1
        for (int v = -timesY; v <= timesY; v++) {
            float x = u == 0 ? s->c.x : s->c.x + (float) u * w->levels->periodX;
            float y = v == 0 ? s->c.y : s->c.y + (float) v * w->levels->periodY;
            // An image is off by a rounding.
            float mx = u == 0 ? m : m + fabs(x) * 0x1p-22f + w->levels->periodX * 0x1p-22f;
            float my = v == 0 ? m : m + fabs(y) * 0x1p-22f + w->levels->periodY * 0x1p-22f;
            walkPieces(w, s, x, y, mx, my);
        }
    }
}

// Where a circle is as it comes near.
float sideOfPiece(const World *w, float4 c, int piece) {
    global const float *row = pieceRow(w, piece);
    int4 traits = pieceTraits(w, piece);
    float2 o = offsetOf(w, c, row);
    bool front = isInFront(row, traits.TRAIT_SHAPE, o.x, o.y);
    bool oneWay = isOneWay(w, traits.TRAIT_KIND);
    if (formOf(traits.TRAIT_SHAPE) == PIECE_SEGMENT && !oneWay) return front ? 1.0f : -1.0f;
    if (!front || !oneWay) return front ? 1.0f : 0.0f;
    PieceGap g;
    measurePiece(row, traits.TRAIT_SHAPE, o.x, o.y, c.RADIUS, 1.0f, &g);
    return g.gap >= 0.0f ? 1.0f : 0.0f;
}

// Contacts go on from the step before. old: their range at home.
void goOnTouching(const World *w, const PieceSeeker *s, int2 old) {
    int from = old.PIECES_FIRST;
    int end = old.PIECES_FIRST + old.PIECES_COUNT;
#pragma unroll 1
    for (int k = s->first; k < s->first + s->count; k++) {
        int4 touched = w->piece[k];
        while (from < end && w->homePiece[from].TOUCHED_PIECE < touched.TOUCHED_PIECE) from++;
        float2 push = (float2)(0.0f);
        RowImpulses rows = (RowImpulses)(0.0f);
        if (from < end) {
            int2 before = w->homePiece[from];
            if (before.TOUCHED_PIECE == touched.TOUCHED_PIECE && before.TOUCHED_SERIAL == touched.TOUCHED_SERIAL) {
                push = w->homePush[from];
                rows = w->homePieceRows[from];
            }
        }
        // measurePieces finds the side of a piece with a front that only senses.
        bool sought = touched.TOUCHED_RESPONSE == PAIR_SOLID || isTwoSided(w, pieceTraits(w, touched.TOUCHED_PIECE));
        if (push.PUSH_SIDE == 0.0f && sought) push.PUSH_SIDE = sideOfPiece(w, s->c, touched.TOUCHED_PIECE);
        w->push[k] = push;
        w->pieceRows[k] = rows;
        w->standing[k] = (float4)(0.0f);
    }
}

// path: how far the circle goes.
PieceSeeker seekerOfPieces(const World *w, int slot, float path) {
    PieceSeeker s;
    s.c = w->circle[slot];
    s.sight = sight(s.c.RADIUS, path);
    s.kind = w->fields[w->id[slot]].kind;
    s.first = NONE;
    s.count = 0;
    return s;
}

// Lists the pieces. Returns whether there are some, and room for them.
bool listPieces(const World *w, PieceSeeker *s) {
    // A loop, so that what looks for them is there once.
#pragma unroll 1
    for (int found = 0;;) {
        lookForPieces(w, s);
        if (s->first != NONE) return true;
        found = s->count;
        if (found == 0) return false;
        int first = atomic_add(&w->status[PIECES_FOUND], found);
        if (first > w->contactRoom - found) return false;
        s->first = first;
        s->count = 0;
        if (found > PIECES_KEPT) continue;
        for (int k = 0; k < found; k++) notePiece(w, s, s->kept[k]);
        return true;
    }
}

#ifdef SLEEPING
// One that sleeps keeps those that it had: no visit sees them.
void keepPieces(const World *w, int slot, int2 old) {
    int count = old.PIECES_COUNT;
    if (count == 0) return;
    int first = atomic_add(&w->status[PIECES_FOUND], count);
    if (first > w->contactRoom - count) return;
#pragma unroll 1
    for (int k = 0; k < count; k++) {
        w->piece[first + k].TOUCHED = w->homePiece[old.PIECES_FIRST + k];
        w->push[first + k] = w->homePush[old.PIECES_FIRST + k];
        w->pieceRows[first + k] = w->homePieceRows[old.PIECES_FIRST + k];
    }
    w->pieces[slot] = (int2)(first, ~count);
}
#endif

// Finds the contacts of a circle.
void findPieces(const World *w, int slot) {
    int2 old = w->pieces[slot];
    w->pieces[slot] = (int2)(0);
    if (w->sight[slot].SIGHT_INVERSE_MASS == 0.0f) {
        IF_SLEEPING(keepPieces(w, slot, old);)
        return;
    }
    float2 way = w->motionClamp[slot].PATH;
    PieceSeeker s = seekerOfPieces(w, slot, lengthf(way.x, way.y));
    if (!listPieces(w, &s)) return;
    goOnTouching(w, &s, old);
    w->pieces[slot] = (int2)(s.first, s.count);
}

// Index space: slots. Cost: the nodes of the tree that are near, twice where many pieces are.
kernel void pieces_find(WORLD_PARAMETERS) {
    World w = WORLD;
    int slot = (int) get_global_id(0);
    if (slot < circles && !refused(&w)) findPieces(&w, slot);
}
#endif
