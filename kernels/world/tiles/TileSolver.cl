// uses: world/tiles/TileOrder.cl
// Stage Solver for tiles: the passes of Solver.cl, tile by tile. A sub-step has two launches. Solve reads drive, burden and
// held and writes solvedMotion, solvedBurden and impulse; it ends with the circles' move. Relax measures the contacts anew,
// goes back to held, and starts the next sub-step. Speed is how many tiles a device has room for at once, and how much they
// read, so: few registers, little local memory, and what is quickly worked out is not stored; no branches in the chain of
// contacts that wait for each other, and nothing that could be done outside of it.

// The circle of contacts that are none: at rest, never written.
#define NO_CIRCLE TILE_CIRCLES

// A tile in local memory, by the numbers of its record.
typedef struct {
    float2 velocity[TILE_CIRCLES + 1];
    float2 load[TILE_CIRCLES + 1]; // in the biased pass the velocity before any impulse; in the relaxing pass the displacement
                                   // while contacts are measured, then sums of impulses
    float burden[TILE_CIRCLES + 1];
    uint carried[(TILE_CIRCLES + 31) / 32]; // in the relaxing pass, a bit a circle: whether a contact carries
    ushort partStart[TILE_PARTS + 2];       // by part of a round, and the end
    int circles, parts, contacts;
    int firstCopy;
} Tile;

// Takes a tile from its record. idle: as one without circles.
void takeTile(const World *w, local Tile *t, int tile, bool idle) {
    global int *record = recordOf(w, tile);
    int circles = idle ? 0 : record[RECORD_CIRCLES];
    int parts = circles > 0 ? record[RECORD_PARTS] : 0;
    barrier(CLK_LOCAL_MEM_FENCE);
    if (get_local_id(0) == 0) {
        t->circles = circles;
        t->parts = parts;
        t->contacts = circles > 0 ? record[RECORD_STARTS + parts] : 0;
        t->firstCopy = circles > 0 ? record[RECORD_COPIES] : 0;
        t->velocity[NO_CIRCLE] = t->load[NO_CIRCLE] = (float2)(0.0f);
        t->burden[NO_CIRCLE] = 0.0f;
    }
    TILE_EACH(part, parts + 1) t->partStart[part] = (ushort) (circles > 0 ? record[RECORD_STARTS + part] : 0);
    barrier(CLK_LOCAL_MEM_FENCE);
}

// The part of a round of which a work-item looks its contact up next.
typedef struct {
    int part, from, to;
} Cursor;

void setCursor(local const Tile *t, Cursor *cursor, int part) {
    cursor->part = part;
    cursor->from = t->partStart[min(part, t->parts)];
    cursor->to = t->partStart[min(part + 1, t->parts)];
}

// A contact that is to be read: as it is placed, or NO_CONTACT; where the tile has its copy.
typedef struct {
    int2 contact;
    int copy;
} Entry;

#define NO_CONTACT ((int2)(0, (int) 0x80000000 | circlesOf(NO_CIRCLE, NO_CIRCLE, 0)))

bool isContact(int2 contact) { return contact.PLACED_CIRCLES >= 0; }

// Asks for a cache line that will be read: only a hint, which OpenCL has no portable form of that compilers heed.
#if PTX
#define PREFETCH(address) asm volatile("prefetch.global.L2 [%0];" ::"l"(address))
#else
#define PREFETCH(address) ((void) (address))
#endif

// The contact of a part that is this work-item's; moves on to the next part, of which it reads the end ahead.
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

// What a pass reads of a contact.
typedef struct {
    int2 contact;   // as it is placed, or NO_CONTACT
    float4 normal;  // as in contact
    float2 shape;
    float2 impulse; // in the biased pass the accumulated one alone
#ifdef RECORDING
    float2 touchNow, touchSoFar; // of an own contact, in the relaxing pass
#endif
} Reading;

void readContact(const World *w, Entry entry, bool relaxing, Reading *reading) {
    reading->contact = entry.contact;
    if (!isContact(entry.contact)) return;
    int c = entry.contact.PLACED_CONTACT & ~NOT_OWN;
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

// A contact that is ready to be visited.
typedef struct {
    int2 contact;
    Visit visit;
#ifdef RECORDING
    float separation, radii;
    float before; // in the biased pass: normal speed before any impulse
    float2 touchNow, touchSoFar;
#endif
} TileVisit;

void readyContact(const World *w, local const Tile *t, const Reading *r, bool relaxing, TileVisit *v) {
    int i = lowerOf(r->contact.PLACED_CIRCLES);
    int j = higherOf(r->contact.PLACED_CIRCLES);
    float burdenA = t->burden[i];
    float burdenB = t->burden[j];
    Pair p;
    p.nx = r->normal.NORMAL_X;
    p.ny = r->normal.NORMAL_Y;
    p.separation = r->normal.SEPARATION;
    p.radii = r->shape.SHAPE_RADII;
    p.restitution = r->shape.SHAPE_RESTITUTION;
    p.invMassA = fabs(burdenA);
    p.invMassB = fabs(burdenB);
    p.mass = r->normal.COPIED_MASS;
    p.normalImpulse = r->impulse.STORED_IMPULSE;
    p.bounce = r->impulse.STORED_BOUNCE;
    p.loaded = isLoaded(burdenA) || isLoaded(burdenB);
    v->contact = r->contact;
    if (relaxing) {
        readyToRelax(&w->k, &p, &v->visit);
    } else {
        float2 fall = (float2)(w->k.gravityStepX, w->k.gravityStepY);
        if (isContact(r->contact) && needsGain(w, p.invMassA, p.invMassB)) {
            uint2 pair = w->ordered[r->contact.PLACED_CONTACT & ~NOT_OWN];
            fall = gainOfPair(w, pair.LOWER, p.invMassA, pair.HIGHER, p.invMassB);
        }
        float before = readyToSolve(&w->k, &p, t->load[j] - t->load[i], fall, &v->visit);
#ifdef RECORDING
        v->before = before;
#endif
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

// Visits a contact, with as few branches as can be: they would be most of the time.
void visitContact(const World *w, local Tile *t, const TileVisit *v, bool relaxing, bool last) {
    int i = lowerOf(v->contact.PLACED_CIRCLES);
    int j = higherOf(v->contact.PLACED_CIRCLES);
    float2 va = t->velocity[i];
    float2 vb = t->velocity[j];
    float2 loadA = relaxing && !last ? t->load[i] : (float2)(0.0f);
    float2 loadB = relaxing && !last ? t->load[j] : (float2)(0.0f);
    Visited visited;
    float vn = visitPair(&v->visit, va, vb, relaxing, &visited);
    float next = visited.normalImpulse;
    bool there = isContact(v->contact);
    if (there && !visited.leaves) {
        t->velocity[i] = va - changeOfVelocity(&v->visit, v->visit.invMassA, visited.impulse);
        t->velocity[j] = vb + changeOfVelocity(&v->visit, v->visit.invMassB, visited.impulse);
    }
    if (relaxing && !last && there && carriesOn(&v->visit, vn, &visited)) {
        float2 g = loadAlong(v->visit.nx, v->visit.ny, next);
        t->load[i] = loadA - g;
        t->load[j] = loadB + g;
        atomic_or(&t->carried[i >> 5], 1u << (i & 31));
        atomic_or(&t->carried[j >> 5], 1u << (j & 31));
    }
    if (!there || v->contact.PLACED_CONTACT < 0) return;
#ifdef RECORDING
    if (relaxing) {
        noteRelaxed(w, v->contact.PLACED_CONTACT, v->touchNow, v->touchSoFar, v->visit.ready.normalImpulse, v->visit.ready.bounce, v->visit.nx, v->visit.ny,
                    v->separation, v->radii, &visited);
    } else {
        noteSolved(w, v->contact.PLACED_CONTACT, v->before, v->visit.nx, v->visit.ny, v->separation, v->radii, &visited);
    }
#endif
    if (relaxing) {
        w->held[v->contact.PLACED_CONTACT] = next;
    } else {
        w->impulse[v->contact.PLACED_CONTACT] = (float2)(next, v->visit.ready.bounce);
    }
}

// Solves a part of a round, whose contacts are ready; makes those of the next part ready, reads those of the second from here,
// and looks up those of the third.
void solvePart(const World *w, local Tile *t, global const int2 *contacts, bool relaxing, bool last, TileVisit *visit,
               Reading *reading, Entry *next, Cursor *cursor) {
    barrier(CLK_LOCAL_MEM_FENCE);
    visitContact(w, t, visit, relaxing, last);
    readyContact(w, t, reading, relaxing, visit);
    readContact(w, *next, relaxing, reading);
    *next = nextContact(w, t, contacts, cursor);
}

// Solves the contacts of a tile, part by part. What each needs is on its way for the time of the part before.
void solveParts(const World *w, local Tile *t, global const int2 *contacts, bool relaxing, bool last) {
    int parts = t->parts;
    Cursor cursor;
    setCursor(t, &cursor, 0);
    Reading reading;
    TileVisit visit;
    reading.normal = (float4)(0.0f);
    reading.shape = reading.impulse = (float2)(0.0f);
#ifdef RECORDING
    reading.touchNow = reading.touchSoFar = (float2)(0.0f);
#endif
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

// How many circles or contacts a work-item takes at a time as a pass begins.
#define TAKEN 4

// The entry of a circle of a region that is the tile's own, or a negative number.
int ownEntry(global const int *entries, int i, int circles) { return i < circles ? entries[i] : NOT_OWN; }

// Notes whether a circle is at a wall.
void noteWall(global int *entries, int i, int entry, bool atWall) {
    int next = atWall ? entry | AT_WALL : entry & ENTRY_SLOT;
    if (next != entry) entries[i] = next;
}

// Takes the circles of a region as a pass finds them where there are several levels: in motion and load, as for Solver.cl.
void takeMotion(const World *w, local Tile *t, global const int *entries, bool relaxing) {
    int circles = t->circles;
    TILE_TOGETHER(first, circles, TAKEN) {
        int slot[MOST_TOGETHER];
        float4 m[MOST_TOGETHER];
        float2 before[MOST_TOGETHER];
        float inverseMass[MOST_TOGETHER], loaded[MOST_TOGETHER];
        TOGETHER_EACH(n, TAKEN) slot[n] = entries[min(togetherItem(first, n), circles - 1)] & ENTRY_SLOT;
        TOGETHER_EACH(n, TAKEN) {
            m[n] = w->motion[slot[n]];
            // Not the rest of it: in the relaxing pass neighbours write that.
            global const float *load = (global const float *) (w->load + slot[n]);
            loaded[n] = load[2];
            before[n] = relaxing ? (float2)(0.0f) : *(global const float2 *) load;
            inverseMass[n] = lastingTraits(w, slot[n]).x;
        }
        TOGETHER_EACH(n, TAKEN) {
            int i = togetherItem(first, n);
            if (i >= circles) continue;
            t->velocity[i] = m[n].VELOCITY;
            t->load[i] = relaxing ? m[n].DISPLACEMENT : before[n];
            t->burden[i] = burdenOf(inverseMass[n], loaded[n] > 0.0f);
            if (relaxing && (i & 31) == 0) t->carried[i >> 5] = 0;
        }
    }
}

// Leaves a tile's own circles behind a pass where there are several levels: for the cross contacts, see crossWorld. loads: whether
// their sums of impulses too.
void leaveMotion(const World *w, local const Tile *t, global const int *entries, bool loads) {
    int circles = t->circles;
    TILE_TOGETHER(first, circles, 2) {
        int entry[MOST_TOGETHER];
        float2 d[MOST_TOGETHER];
        TOGETHER_EACH(n, 2) entry[n] = ownEntry(entries, togetherItem(first, n), circles);
        TOGETHER_EACH(n, 2) {
            if (entry[n] >= 0) d[n] = w->motion[entry[n] & ENTRY_SLOT].DISPLACEMENT;
        }
        TOGETHER_EACH(n, 2) {
            if (entry[n] < 0) continue;
            int i = togetherItem(first, n);
            int slot = entry[n] & ENTRY_SLOT;
            float2 v = t->velocity[i];
            w->solvedMotion[slot] = (float4)(d[n].x, d[n].y, v.x, v.y);
            if (!loads) continue;
            bool carried = (t->carried[i >> 5] >> (i & 31) & 1) != 0;
            global float *load = (global float *) (w->load + slot);
            *(global float2 *) load = t->load[i];
            load[3] = carried ? 1.0f : 0.0f;
        }
    }
}

// The biased pass of a tile. together: how many circles a work-item moves at a time; levels: whether there are several, and so the
// contacts alone are solved here.
void solveTile(const World *w, local Tile *t, int tile, int subStep, int together, bool levels) {
    global int *entries = recordOf(w, tile) + RECORD_SLOTS;
    int circles = t->circles;
    findNumbers(w, placedFrom(w, t->firstCopy), subStep == 0 ? t->contacts : 0);
    if (levels) takeMotion(w, t, entries, false);
    int started = levels ? 0 : circles;
    TILE_TOGETHER(first, started, TAKEN) {
        int slot[MOST_TOGETHER];
        float4 drive[MOST_TOGETHER];
        float burden[MOST_TOGETHER];
        TOGETHER_EACH(n, TAKEN) slot[n] = entries[min(togetherItem(first, n), circles - 1)] & ENTRY_SLOT;
        TOGETHER_EACH(n, TAKEN) {
            drive[n] = w->drive[slot[n]];
            burden[n] = w->burden[slot[n]];
        }
        TOGETHER_EACH(n, TAKEN) {
            int i = togetherItem(first, n);
            if (i >= circles) continue;
            t->velocity[i] = drive[n].START_VELOCITY;
            t->load[i] = drive[n].START_BEFORE;
            t->burden[i] = burden[n];
        }
    }
    solveParts(w, t, placedFrom(w, t->firstCopy), false, false);
    if (levels) {
        leaveMotion(w, t, entries, false);
        return;
    }
    TILE_TOGETHER(first, circles, together) {
        int entry[MOST_TOGETHER];
        float4 c[MOST_TOGETHER], started[MOST_TOGETHER];
        TOGETHER_EACH(n, together) entry[n] = ownEntry(entries, togetherItem(first, n), circles);
        TOGETHER_EACH(n, together) {
            if (entry[n] < 0) continue;
            c[n] = w->circle[entry[n] & ENTRY_SLOT];
            started[n] = w->motion[entry[n] & ENTRY_SLOT];
        }
        TOGETHER_EACH(n, together) {
            if (entry[n] < 0) continue;
            int i = togetherItem(first, n);
            int slot = entry[n] & ENTRY_SLOT;
            bool atWall = endSolve(w, slot, (entry[n] & AT_WALL) != 0, c[n], started[n], t->velocity[i], t->burden[i]);
            noteWall(entries, i, entry[n], atWall);
            if (subStep == 0) w->homeFirstCached[slot] = NONE;
        }
    }
}

// Measures the contacts of a tile after the circles have moved. Before the pass, since no contact has to wait for another here:
// hardly a work-item is idle, while in the parts of rounds half of them are.
void measureContacts(const World *w, local Tile *t) {
    global const int2 *placed = placedFrom(w, t->firstCopy);
    int contacts = t->contacts;
    TILE_TOGETHER(first, contacts, TAKEN) {
        int circles[MOST_TOGETHER];
        float2 base[MOST_TOGETHER];
        float sum[MOST_TOGETHER];
        TOGETHER_EACH(n, TAKEN) {
            int place = min(togetherItem(first, n), contacts - 1);
            circles[n] = placed[place].PLACED_CIRCLES;
            base[n] = w->bases[t->firstCopy + place];
            sum[n] = w->shape[t->firstCopy + place].SHAPE_RADII;
        }
        TOGETHER_EACH(n, TAKEN) {
            int copy = t->firstCopy + togetherItem(first, n);
            if (togetherItem(first, n) >= contacts) continue;
            int i = lowerOf(circles[n]);
            int j = higherOf(circles[n]);
            float2 moved = t->load[j] - t->load[i];
            float nx = 0.0f, ny = 0.0f, separation;
            if (!measure(base[n].x, base[n].y, moved.x, moved.y, sum[n], &nx, &ny, &separation)) {
                nx = copiesOf(w)[copy].NORMAL_X;
                ny = copiesOf(w)[copy].NORMAL_Y;
            }
            copiesOf(w)[copy] = (float4)(nx, ny, separation, effectiveMass(fabs(t->burden[i]), fabs(t->burden[j])));
        }
    }
}

// Starts the circles of a tile that are noted to be at walls. They are few: in a loop of their own they do not hold the registers
// of those that a work-item starts together.
void startAtWalls(const World *w, local Tile *t, global int *entries) {
    int circles = t->circles;
#pragma unroll 1
    TILE_EACH(i, circles) {
        int entry = entries[i];
        if (entry < 0 || (entry & AT_WALL) == 0) continue;
        int slot = entry & ENTRY_SLOT;
        float2 d = w->solvedMotion[slot].DISPLACEMENT;
        float2 v = t->velocity[i];
        bool carried = (t->carried[i >> 5] >> (i & 31) & 1) != 0;
        float4 m = (float4)(d.x, d.y, v.x, v.y);
        noteWall(entries, i, entry, startCircle(w, slot, w->circle[slot], m, w->traits[slot], t->load[i], carried));
    }
}

// The relaxing pass of a tile: the contacts, then the circles' start into the next sub-step; or, after the last, their way
// home. together: how many of them a work-item starts at a time; levels: whether there are several, and so the contacts alone are
// relaxed here.
void relaxTile(const World *w, local Tile *t, int tile, bool last, int together, bool levels) {
    global int *entries = recordOf(w, tile) + RECORD_SLOTS;
    int circles = t->circles;
    if (levels) takeMotion(w, t, entries, true);
    int moved = levels ? 0 : circles;
    TILE_TOGETHER(first, moved, TAKEN) {
        int slot[MOST_TOGETHER];
        float4 m[MOST_TOGETHER];
        float burden[MOST_TOGETHER];
        TOGETHER_EACH(n, TAKEN) slot[n] = entries[min(togetherItem(first, n), circles - 1)] & ENTRY_SLOT;
        TOGETHER_EACH(n, TAKEN) {
            m[n] = w->solvedMotion[slot[n]];
            burden[n] = w->solvedBurden[slot[n]];
        }
        TOGETHER_EACH(n, TAKEN) {
            int i = togetherItem(first, n);
            if (i >= circles) continue;
            t->load[i] = m[n].DISPLACEMENT;
            t->velocity[i] = m[n].VELOCITY;
            t->burden[i] = burden[n];
            if ((i & 31) == 0) t->carried[i >> 5] = 0;
        }
    }
    barrier(CLK_LOCAL_MEM_FENCE);
    measureContacts(w, t);
    barrier(CLK_LOCAL_MEM_FENCE | CLK_GLOBAL_MEM_FENCE);
    TILE_EACH(i, circles) t->load[i] = (float2)(0.0f);
    solveParts(w, t, placedFrom(w, t->firstCopy), true, last);
    if (levels) {
        leaveMotion(w, t, entries, !last);
        return;
    }
    TILE_TOGETHER(first, circles, together) {
        int entry[MOST_TOGETHER];
        float4 c[MOST_TOGETHER];
        float2 d[MOST_TOGETHER];
        TOGETHER_EACH(n, together) entry[n] = ownEntry(entries, togetherItem(first, n), circles);
        TOGETHER_EACH(n, together) {
            if (entry[n] < 0) continue;
            c[n] = w->circle[entry[n] & ENTRY_SLOT];
            d[n] = w->solvedMotion[entry[n] & ENTRY_SLOT].DISPLACEMENT;
        }
        TOGETHER_EACH(n, together) {
            if (entry[n] < 0) continue;
            int i = togetherItem(first, n);
            int slot = entry[n] & ENTRY_SLOT;
            float2 v = t->velocity[i];
            float4 m = (float4)(d[n].x, d[n].y, v.x, v.y);
            bool carried = (t->carried[i >> 5] >> (i & 31) & 1) != 0;
            if (last) {
                finalizePositions(w, slot, c[n], m, w->traits[slot]);
            } else if ((entry[n] & AT_WALL) == 0) {
                noteWall(entries, i, entry[n], !startOffWalls(w, slot, c[n], m, fabs(t->burden[i]), t->load[i], carried));
            }
        }
    }
    if (!last) startAtWalls(w, t, entries);
}

// Stores a contact's impulse for the step to come. Several of one circle may at the same time, in no order: they are
// looked up by id.
void storeHeldImpulse(const World *w, int c) {
    float normalImpulse = w->held[c];
    if (!(normalImpulse > 0.0f)) return;
    uint2 p = w->ordered[c];
    storeImpulse(w, c, w->homeFirstCached + p.LOWER, w->id[p.HIGHER], normalImpulse);
}

// Index space: any number of work-items, which take the contacts in turn.
kernel void solver_storeImpulses(WORLD_PARAMETERS) {
    World w = WORLD;
    if (refused(&w)) return;
    int contacts = likeContacts(&w);
    for (int c = (int) get_global_id(0); c < contacts; c += (int) get_global_size(0)) storeHeldImpulse(&w, c);
}

// Index space of each: a work-group a tile. Cost: the circles of its region, and the parts of its rounds one after another.

TILE_KERNEL solver_solveTile(WORLD_PARAMETERS, int subStep RECORDING_PARAMETERS) {
    World w = WORLD;
    RECORD_IN(w);
    w.subStep = subStep;
    SET_TOUCH_NUMBERS_OF_ONE_LEVEL(w);
    local Tile t;
    int tile = (int) get_group_id(0);
    takeTile(&w, &t, tile, refused(&w));
    solveTile(&w, &t, tile, subStep, 4, false);
}

TILE_KERNEL solver_relaxTile(WORLD_PARAMETERS, int subStep RECORDING_PARAMETERS) {
    World w = WORLD;
    RECORD_IN(w);
    SET_TOUCH_NUMBERS_OF_ONE_LEVEL(w);
    bool last = subStep == w.k.subSteps - 1;
    w.subStep = subStep + 1; // which the circles start into
    local Tile t;
    int tile = (int) get_group_id(0);
    bool idle = refused(&w);
    if (last && get_global_id(0) == 0 && !idle) status[STEPS_DONE]++;
    takeTile(&w, &t, tile, idle);
    relaxTile(&w, &t, tile, last, 2, false);
}
