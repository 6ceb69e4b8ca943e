// uses: world/shared/Visit.cl world/tiles/TileOrder.cl
// Visits in a tile's local memory. Speed is how many tiles a device has room for, and how much they read: few registers, little local
// memory, nothing stored that is quickly worked out, no branches and no other work in the chain of contacts that wait for each other.

// Of contacts that are none: at rest, never written.
#define NO_CIRCLE TILE_CIRCLES

// By the numbers of its record.
typedef struct {
    float2 velocity[TILE_CIRCLES + 1];
    float2 load[TILE_CIRCLES + 1]; // in the biased pass the velocity before any impulse; in the relaxing pass the displacement
                                   // while contacts are measured, then sums of impulses
    float burden[TILE_CIRCLES + 1];
#ifdef TURNING
    float spin[TILE_CIRCLES + 1];     // surface speed
    float spinLoad[TILE_CIRCLES + 1]; // in the relaxing pass: sums of impulses on it; if touches are recorded, in the biased pass what it
                                      // was before any impulse
    float inertia[TILE_CIRCLES + 1];  // inverse
#endif
    uint carried[(TILE_CIRCLES + 31) / 32]; // a bit a circle: whether a contact carries
    ushort partStart[TILE_PARTS + 2];       // by part of a round, and the end
    int circles, parts, contacts;
    int firstCopy;
} Tile;

// idle: as one without circles.
void takeTile(const World *w, local Tile *t, int tile, bool idle) {
    global int *record = recordOf(w, tile);
    int circles = idle ? 0 : record[TILE_AT_CIRCLES];
    int parts = circles > 0 ? record[TILE_AT_PARTS] : 0;
    barrier(CLK_LOCAL_MEM_FENCE);
    if (get_local_id(0) == 0) {
        t->circles = circles;
        t->parts = parts;
        t->contacts = circles > 0 ? record[TILE_AT_STARTS + parts] : 0;
        t->firstCopy = circles > 0 ? record[TILE_AT_COPIES] : 0;
        t->velocity[NO_CIRCLE] = t->load[NO_CIRCLE] = (float2)(0.0f);
        t->burden[NO_CIRCLE] = 0.0f;
        IF_TURNING(t->spin[NO_CIRCLE] = t->spinLoad[NO_CIRCLE] = t->inertia[NO_CIRCLE] = 0.0f;)
    }
    TILE_EACH(part, parts + 1) t->partStart[part] = (ushort) (circles > 0 ? record[TILE_AT_STARTS + part] : 0);
    barrier(CLK_LOCAL_MEM_FENCE);
}

// Of which a work-item looks its contact up next.
typedef struct {
    int part, from, to;
} Cursor;

void setCursor(local const Tile *t, Cursor *cursor, int part) {
    cursor->part = part;
    cursor->from = t->partStart[min(part, t->parts)];
    cursor->to = t->partStart[min(part + 1, t->parts)];
}

typedef struct {
    int2 contact;
    int copy;
} Entry;

#define NO_CONTACT ((int2)(0, (int) 0x80000000 | circlesOf(NO_CIRCLE, NO_CIRCLE, 0)))

bool isContact(int2 contact) { return contact.PLACED_CIRCLES >= 0; }

// Only a hint, of which OpenCL has no portable form that compilers heed.
#if PTX
#define PREFETCH(address) asm volatile("prefetch.global.L2 [%0];" ::"l"(address))
#else
#define PREFETCH(address) ((void) (address))
#endif

// Moves on to the next part, and reads its end ahead.
Entry nextContact(const World *w, local const Tile *t, global const int2 *contacts, Cursor *cursor) {
    int place = cursor->from + (int) get_local_id(0);
    Entry entry;
    entry.contact = NO_CONTACT;
    entry.copy = t->firstCopy + place;
    if (place < cursor->to) {
        entry.contact = contacts[place];
        PREFETCH(copiesOf(w) + entry.copy);
        PREFETCH(w->shape + entry.copy);
    }
    cursor->part++;
    cursor->from = cursor->to;
    cursor->to = t->partStart[min(cursor->part + 1, t->parts)];
    return entry;
}

typedef struct {
    int2 contact;   // as it is placed, or NO_CONTACT
    float4 normal;  // as in contact
    float2 shape;
    float2 impulse; // in the biased pass without a bounce
#ifdef TURNING
    int copy;
    float2 surface;   // in the relaxing pass: as in copiedSurface
    RowImpulses rows; // in the relaxing pass: of rows, as the one before has left them
#endif
#ifdef RECORDING
    float2 touchNow, touchSoFar; // of an own contact, in the relaxing pass
#endif
} Reading;

#ifdef TURNING
// Impulses of rows as a relaxing pass finds them. Behind it they are where the next one looks.
global RowImpulses *rowsBefore(const World *w, int subStep) { return subStep & 1 ? w->oddRows : w->heldRows; }
global RowImpulses *rowsBehind(const World *w, int subStep) { return subStep & 1 ? w->heldRows : w->oddRows; }
#endif

void readContact(const World *w, Entry entry, bool relaxing, Reading *reading) {
    reading->contact = entry.contact;
    if (!isContact(entry.contact)) return;
    int c = entry.contact.PLACED_CONTACT & ~NOT_OWN;
#ifdef TURNING
    reading->copy = entry.copy;
    if (relaxing) {
        reading->surface = w->copiedSurface[entry.copy];
        reading->rows = rowsBefore(w, w->relaxed)[c];
    }
#endif
    reading->normal = copiesOf(w)[entry.copy];
    reading->shape = w->shape[entry.copy];
    reading->impulse = relaxing ? w->impulse[c] : (float2)(w->held[c], 0.0f);
#ifdef RECORDING
    if (relaxing && entry.contact.PLACED_CONTACT >= 0) {
        reading->touchNow = touchNow(w)[c];
        reading->touchSoFar = touchSoFar(w)[c];
    }
#endif
}

typedef struct {
    int2 contact;
    Visit visit;
#ifdef TURNING
    int copy;
    float2 surface;
    RowImpulses rows;
#endif
#ifdef RECORDING
    float separation, radii;
    float before; // normal speed before any impulse
    float2 touchNow, touchSoFar;
#endif
} TileVisit;

void readyContact(const World *w, local const Tile *t, const Reading *r, bool relaxing, TileVisit *v) {
    int i = lowerOf(r->contact.PLACED_CIRCLES);
    int j = higherOf(r->contact.PLACED_CIRCLES);
    float burdenA = t->burden[i];
    float burdenB = t->burden[j];
    Pair p = {.nx = r->normal.NORMAL_X, .ny = r->normal.NORMAL_Y, .separation = r->normal.SEPARATION,
              .normalImpulse = r->impulse.STORED_IMPULSE, .bounce = r->impulse.STORED_BOUNCE, .mass = r->normal.COPIED_MASS,
              .radii = r->shape.SHAPE_RADII, .restitution = r->shape.SHAPE_RESTITUTION, .invMassA = fabs(burdenA),
              .invMassB = fabs(burdenB), .loaded = isLoaded(burdenA) || isLoaded(burdenB)};
    v->contact = r->contact;
#ifdef TURNING
    v->copy = r->copy;
    v->surface = r->surface;
    v->rows = r->rows;
    p.held = relaxing && rowsHold(r->rows);
#endif
    if (relaxing) {
        readyToRelax(&w->k, &p, &v->visit);
    } else {
        float2 fall = (float2)(w->k.gravityStepX, w->k.gravityStepY);
        if (isContact(r->contact) && needsGain(w, p.invMassA, p.invMassB)) {
            uint2 pair = w->ordered[r->contact.PLACED_CONTACT & ~NOT_OWN];
            fall = gainOfPair(w, pair.LOWER, p.invMassA, pair.HIGHER, p.invMassB);
        }
        float before = readyToSolve(&w->k, &p, t->load[j] - t->load[i], fall, &v->visit);
        IF_RECORDING(v->before = before;)
    }
#ifdef RECORDING
    v->separation = p.separation;
    v->radii = p.radii;
    if (relaxing) {
        v->touchNow = r->touchNow;
        v->touchSoFar = r->touchSoFar;
    }
#endif
}

#ifdef TURNING
PairSurface surfaceInTile(const World *w, const TileVisit *v) { return surfaceOfPair(v->surface, w->copiedRest + v->copy); }

// b: the circles of a contact as its visit has left them.
void visitRowsInTile(const World *w, local const Tile *t, TileVisit *v, int i, int j, float along, bool relaxing, const Visited *visited,
                     Bodies *b) {
    float2 stored = relaxing ? v->surface : w->copiedSurface[v->copy];
    PairSurface s = surfaceOfPair(stored, w->copiedRest + v->copy);
    RowImpulses rows = (RowImpulses)(0.0f);
    if (relaxing) rows = v->rows;
    if (hasRest(stored)) {
        uint2 pair = w->ordered[v->contact.PLACED_CONTACT & ~NOT_OWN];
        b->ra = w->circle[pair.LOWER].RADIUS;
        b->rb = w->circle[pair.HIGHER].RADIUS;
    }
    b->sa = t->spin[i];
    b->sb = t->spin[j];
    b->ia = t->inertia[i];
    b->ib = t->inertia[j];
    b->wa = v->visit.invMassA;
    b->wb = v->visit.invMassB;
    b->isHeavyA = b->isHeavyB = false;
    visitRows(b, &s, &rows, &v->visit, visited, along);
    v->rows = rows;
}
#endif

#if defined(TURNING) && defined(RECORDING)
// In the biased pass: how fast the surfaces of a contact that is there slide, before any impulse.
float slipInTile(const World *w, local const Tile *t, const TileVisit *v, int i, int j) {
    PairSurface s = surfaceOfPair(w->copiedSurface[v->copy], w->copiedRest + v->copy);
    return slipOfPair(&s, (float2)(v->visit.nx, v->visit.ny), t->load[i], t->load[j], t->spinLoad[i], t->spinLoad[j]);
}
#endif

INLINE RowImpulses rowsInTile(const TileVisit *v) {
#ifdef TURNING
    return v->rows;
#else
    return (RowImpulses)(0.0f);
#endif
}

// Branches would be most of the time.
void visitContact(const World *w, local Tile *t, TileVisit *v, bool relaxing, bool last) {
    int i = lowerOf(v->contact.PLACED_CIRCLES);
    int j = higherOf(v->contact.PLACED_CIRCLES);
    float2 va = t->velocity[i];
    float2 vb = t->velocity[j];
    float2 loadA = relaxing && !last ? t->load[i] : (float2)(0.0f);
    float2 loadB = relaxing && !last ? t->load[j] : (float2)(0.0f);
    Visited visited;
    visitPair(&v->visit, va, vb, relaxing, &visited);
    float next = visited.normalImpulse;
    bool there = isContact(v->contact);
#ifdef TURNING
    Bodies b = {.va = va, .vb = vb};
    if (!visited.leaves) {
        b.va = va - changeOfVelocity(&v->visit, v->visit.invMassA, visited.impulse);
        b.vb = vb + changeOfVelocity(&v->visit, v->visit.invMassB, visited.impulse);
    }
    if (there && (relaxing ? !visited.still : bouncesFreely(&visited))) {
        float along = speedAlong((float2)(v->visit.nx, v->visit.ny), va, vb);
        visitRowsInTile(w, t, v, i, j, along, relaxing, &visited, &b);
        t->spin[i] = b.sa;
        t->spin[j] = b.sb;
        t->velocity[i] = b.va;
        t->velocity[j] = b.vb;
    } else if (there && !visited.leaves) {
        t->velocity[i] = b.va;
        t->velocity[j] = b.vb;
    }
#else
    if (there && !visited.leaves) {
        t->velocity[i] = va - changeOfVelocity(&v->visit, v->visit.invMassA, visited.impulse);
        t->velocity[j] = vb + changeOfVelocity(&v->visit, v->visit.invMassB, visited.impulse);
    }
#endif
    if (relaxing && !last && there && carriesOn(&v->visit, &visited, rowsInTile(v))) {
        float2 g = loadAlong(v->visit.nx, v->visit.ny, next);
#ifdef TURNING
        PairSurface s = surfaceInTile(w, v);
        if (rowsAct(&s)) {
            // Only rolling needs the circles.
            uint2 pair = hasRest(v->surface) ? w->ordered[v->contact.PLACED_CONTACT & ~NOT_OWN] : (uint2)(0);
            float2 of = spinImpulses(w, pair, &s, v->rows);
            g += rowLoad((float2)(v->visit.nx, v->visit.ny), v->rows);
            t->spinLoad[i] += of.x;
            t->spinLoad[j] += of.y;
        }
#endif
        t->load[i] = loadA - g;
        t->load[j] = loadB + g;
        atomic_or(&t->carried[i >> 5], 1u << (i & 31));
        atomic_or(&t->carried[j >> 5], 1u << (j & 31));
    }
    if (!there || v->contact.PLACED_CONTACT < 0) return;
#ifdef RECORDING
    if (relaxing) {
        noteRelaxed(w, v->contact.PLACED_CONTACT, v->touchNow, v->touchSoFar, v->visit.ready.normalImpulse, v->visit.ready.bounce,
                    v->visit.nx, v->visit.ny, v->separation, v->radii, &visited);
    } else {
        noteSolved(w, v->contact.PLACED_CONTACT, v->before, v->visit.nx, v->visit.ny, v->separation, v->radii,
                   &visited AND_TURNING(slipInTile(w, t, v, i, j)));
    }
#endif
    if (relaxing) {
        w->held[v->contact.PLACED_CONTACT] = next;
        IF_TURNING(rowsBehind(w, w->relaxed)[v->contact.PLACED_CONTACT] = v->rows;)
    } else {
        w->impulse[v->contact.PLACED_CONTACT] = (float2)(next, v->visit.ready.bounce);
    }
}

// Then it makes those of the next part ready, reads those of the second from here, looks up those of the third.
void solvePart(const World *w, local Tile *t, global const int2 *contacts, bool relaxing, bool last, TileVisit *visit,
               Reading *reading, Entry *next, Cursor *cursor) {
    barrier(CLK_LOCAL_MEM_FENCE);
    visitContact(w, t, visit, relaxing, last);
    readyContact(w, t, reading, relaxing, visit);
    readContact(w, *next, relaxing, reading);
    *next = nextContact(w, t, contacts, cursor);
}

// Part by part; reads are on their way for the time of a part.
void solveParts(const World *w, local Tile *t, global const int2 *contacts, bool relaxing, bool last) {
    int parts = t->parts;
    Cursor cursor;
    setCursor(t, &cursor, 0);
    Reading reading;
    TileVisit visit;
    reading.normal = (float4)(0.0f);
    reading.shape = reading.impulse = (float2)(0.0f);
#ifdef TURNING
    reading.copy = 0;
    reading.surface = (float2)(0.0f);
    reading.rows = (RowImpulses)(0.0f);
#endif
    IF_RECORDING(reading.touchNow = reading.touchSoFar = (float2)(0.0f);)
    readContact(w, nextContact(w, t, contacts, &cursor), relaxing, &reading);
    barrier(CLK_LOCAL_MEM_FENCE);
    readyContact(w, t, &reading, relaxing, &visit);
    readContact(w, nextContact(w, t, contacts, &cursor), relaxing, &reading);
    Entry next = nextContact(w, t, contacts, &cursor);
#pragma unroll 1
    for (int part = 0; part < parts; part++) {
        solvePart(w, t, contacts, relaxing, last, &visit, &reading, &next, &cursor);
    }
    barrier(CLK_LOCAL_MEM_FENCE);
}
