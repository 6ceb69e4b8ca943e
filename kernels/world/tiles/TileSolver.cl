// uses: world/tiles/TileVisits.cl
// Passes by tiles, two launches a sub-step. Solve reads drive, burden and held, writes solvedMotion, solvedBurden and impulse. Relax
// measures contacts again, goes back to held, and starts the next sub-step.

// Circles or contacts at a time, as a pass begins.
#define TAKEN 4

// Negative if it is not the tile's own.
int ownEntry(global const int *entries, int i, int circles) { return i < circles ? entries[i] : NOT_OWN; }

void noteWall(global int *entries, int i, int entry, bool atWall) {
    int next = atWall ? entry | AT_WALL : entry & ENTRY_SLOT;
    if (next != entry) entries[i] = next;
}

#ifdef TERRAIN
// What walls do not say: of the circles at walls, those near pieces of terrain.
bool isAtPieces(const World *w, int entry) { return entry >= 0 && (entry & AT_WALL) != 0 && hasPieces(w, entry & ENTRY_SLOT); }

// Apart: in the loop of the others they would hold registers.
void endAtPieces(const World *w, local const Tile *t, global int *entries, int subStep) {
    int circles = t->circles;
#pragma unroll 1
    TILE_EACH(i, circles) {
        int entry = entries[i];
        if (!isAtPieces(w, entry)) continue;
        int slot = entry & ENTRY_SLOT;
        endSolve(w, slot, true, w->circle[slot], w->motion[slot], t->velocity[i], t->burden[i] AND_TURNING(t->spin[i]), true);
        if (subStep == 0) w->homeFirstCached[slot] = NONE;
    }
}
#endif

// With several levels, where Solver.cl has it.
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
            // In the relaxing pass neighbours write the rest.
            global const float *load = (global const float *) (w->load + slot[n]);
            loaded[n] = load[LOADED_AT];
            before[n] = relaxing ? (float2)(0.0f) : *(global const float2 *) (load + BEFORE_AT);
            inverseMass[n] = lastingTraits(w, slot[n]).x;
        }
        TOGETHER_EACH(n, TAKEN) {
            int i = togetherItem(first, n);
            if (i >= circles) continue;
            t->velocity[i] = m[n].VELOCITY;
            t->load[i] = relaxing ? m[n].DISPLACEMENT : before[n];
#ifdef TURNING
            t->spin[i] = w->surfaceSpeed[slot[n]];
            t->inertia[i] = w->inverseInertia[slot[n]];
            t->spinLoad[i] = 0.0f;
            IF_RECORDING(if (!relaxing) t->spinLoad[i] = w->spinImpulse[slot[n]];)
#endif
            t->burden[i] = burdenOf(inverseMass[n], loaded[n] > 0.0f);
            if (relaxing && (i & 31) == 0) t->carried[i >> 5] = 0;
        }
    }
}

// With several levels, for crossWorld.
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
            IF_TURNING(w->solvedSpin[slot] = t->spin[i];)
            IF_TURNING(if (loads) w->spinImpulse[slot] = t->spinLoad[i];)
            if (!loads) continue;
            bool carried = (t->carried[i >> 5] >> (i & 31) & 1) != 0;
            global float *load = (global float *) (w->load + slot);
            *(global float2 *) (load + IMPULSES_AT) = t->load[i];
            load[LOADED_NEXT_AT] = carried ? 1.0f : 0.0f;
        }
    }
}

// together: circles that a work-item moves at a time; levels: several, so contacts alone.
void solveTile(const World *w, local Tile *t, int tile, int subStep, int together, bool levels) {
    global int *entries = recordOf(w, tile) + TILE_AT_SLOTS;
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
#ifdef TURNING
            t->spin[i] = w->startSpin[slot[n]];
            t->inertia[i] = w->inverseInertia[slot[n]];
            IF_RECORDING(t->spinLoad[i] = w->spinImpulse[slot[n]];)
#endif
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
#ifdef TERRAIN
        TOGETHER_EACH(n, together) entry[n] = isAtPieces(w, entry[n]) ? NOT_OWN : entry[n];
#endif
        TOGETHER_EACH(n, together) {
            if (entry[n] < 0) continue;
            c[n] = w->circle[entry[n] & ENTRY_SLOT];
            started[n] = w->motion[entry[n] & ENTRY_SLOT];
        }
        TOGETHER_EACH(n, together) {
            if (entry[n] < 0) continue;
            int i = togetherItem(first, n);
            int slot = entry[n] & ENTRY_SLOT;
            bool atWall = endSolve(w, slot, (entry[n] & AT_WALL) != 0, c[n], started[n], t->velocity[i],
                                   t->burden[i] AND_TURNING(t->spin[i]) AND_TERRAIN(false));
            noteWall(entries, i, entry[n], atWall);
            if (subStep == 0) w->homeFirstCached[slot] = NONE;
        }
    }
    IF_TERRAIN(endAtPieces(w, t, entries, subStep);)
}

// Before the pass: no contact waits for another here, so hardly a work-item is idle; in parts of rounds half are.
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
#ifdef SLEEPING
            float mass = copiesOf(w)[copy].COPIED_MASS; // see massOfPair
#else
            float mass = effectiveMass(fabs(t->burden[i]), fabs(t->burden[j]));
#endif
            copiesOf(w)[copy] = (float4)(nx, ny, separation, mass);
        }
    }
}

// Few: in the loop of the others they would hold registers.
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
        noteWall(entries, i, entry,
                 startCircle(w, slot, w->circle[slot], m, w->traits[slot], t->load[i],
                             carried AND_TURNING(t->spin[i]) AND_TURNING(t->spinLoad[i]) AND_TERRAIN(hasPieces(w, slot))));
    }
}

// Then the circles start into the next sub-step, or go home.
void relaxTile(const World *w, local Tile *t, int tile, bool last, int together, bool levels) {
    global int *entries = recordOf(w, tile) + TILE_AT_SLOTS;
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
#ifdef TURNING
            t->spin[i] = w->solvedSpin[slot[n]];
            t->inertia[i] = w->inverseInertia[slot[n]];
            t->spinLoad[i] = 0.0f;
#endif
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
                IF_TURNING(w->surfaceSpeed[slot] = t->spin[i];)
                finalizePositions(w, slot, c[n], m, w->traits[slot]);
            } else if ((entry[n] & AT_WALL) == 0) {
                noteWall(entries, i, entry[n], !startOffWalls(w, slot, c[n], m, fabs(t->burden[i]), t->load[i],
                                                          carried AND_TURNING(t->spin[i]) AND_TURNING(t->spinLoad[i])));
            }
        }
    }
    if (!last) startAtWalls(w, t, entries);
}

// Behind the last sub-step.
INLINE RowImpulses heldRowsAt(const World *w, int c) {
#ifdef TURNING
    return rowsBefore(w, w->k.subSteps)[c];
#else
    return (RowImpulses)(0.0f);
#endif
}

void storeHeldImpulse(const World *w, int c) {
    float normalImpulse = w->held[c];
    RowImpulses rows = heldRowsAt(w, c);
    if (!(actingImpulse(normalImpulse, rows) > 0.0f)) return;
    uint2 p = w->ordered[c];
    IF_TURNING(w->rowCache[c] = rows;)
    storeImpulse(w, c, w->homeFirstCached + p.LOWER, w->id[p.HIGHER], normalImpulse);
}

// Index space: any; work-items take contacts in turn.
kernel void solver_storeImpulses(WORLD_PARAMETERS) {
    World w = WORLD;
    if (refused(&w)) return;
    int contacts = likeContacts(&w);
    for (int c = (int) get_global_id(0); c < contacts; c += (int) get_global_size(0)) storeHeldImpulse(&w, c);
}

// Whether nothing that a tile owns moves, so that all sub-steps are alike: its first solving pass and its last relaxing pass do.
bool isStillTile(const World *w, int tile) { return recordOf(w, tile)[TILE_AT_STILL] != 0; }

// Index space of both: a work-group a tile. Cost: the circles of its region, and its parts of rounds.

TILE_KERNEL solver_solveTile(WORLD_PARAMETERS, int subStep RECORDING_PARAMETERS) {
    World w = WORLD;
    RECORD_IN(w);
    w.subStep = subStep;
    SET_TOUCH_NUMBERS_OF_ONE_LEVEL(w);
    local Tile t;
    int tile = (int) get_group_id(0);
    takeTile(&w, &t, tile, refused(&w) || (subStep > 0 && isStillTile(&w, tile)));
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
    IF_TURNING(w.relaxed = subStep;)
    takeTile(&w, &t, tile, idle || (!last && isStillTile(&w, tile)));
    relaxTile(&w, &t, tile, last, 2, false);
}
