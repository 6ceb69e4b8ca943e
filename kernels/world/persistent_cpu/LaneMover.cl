// uses: world/shared/Motion.cl world/stages/Touches.cl
// The circles' part of stage Solver for some cells. Loops have a copy of the World of their own, whose pointers stay in
// registers; what is called for circles at walls gets the shared one: a copy that others know stays in memory.

typedef struct {
    int from, to; // slots
} Cells;

// The circles of a row of a level.
Cells cellsOf(const World *w, int level, int row) {
    global const int *start = w->bucketStart + w->levels->first[level] + (row << w->levels->columnsLog[level]);
    Cells c = {start[0], start[1 << w->levels->columnsLog[level]]};
    return c;
}

// Gravity, the impulses of the sub-step before, and the biased pass over the walls. driving: see integrateOffWalls.
INLINE void integrateVelocitiesIn(const World *shared, const World *w, Cells cells, bool driving) {
    for (int slot = cells.from; slot < cells.to; slot++) {
        float4 c = w->circle[slot];
        float4 m = w->motion[slot];
        float4 t = w->traits[slot];
        float4 l = w->load[slot];
        float2 before, v;
        float2 bounce = (float2)(0.0f);
        bool loaded = l.w > 0.0f;
        bool clear = integrateOffWalls(w, slot, c, m, t.x, (float2)(l.x, l.y), driving, &before, &v);
        if (clear & (t.z == 0.0f) & (t.w == 0.0f)) {
            m.zw = v;
            t.zw = noWalls(&w->k, c);
        } else {
#ifdef RECORDING
            float4 old = m;
#endif
            integrateVelocities(shared, slot, c, &m, &t, l, &before, &bounce, &loaded);
#ifdef RECORDING
            if (w->recording.walls) noteWallsSolved(shared, w->recording.wallTouch + 2 * slot, c, t.x, l.xy, before, old, m);
#endif
        }
        w->motion[slot] = m;
        w->traits[slot] = t;
        w->wallBounce[slot] = bounce;
        w->load[slot] = (float4)(before.x, before.y, loaded ? 1.0f : 0.0f, l.w);
    }
}

// One loop for each case: a step in which gravity alone acts pays nothing for the other.
void integrateVelocitiesOf(const World *shared, Cells cells) {
    World own = *shared;
    if (own.k.driving) {
        integrateVelocitiesIn(shared, &own, cells, true);
    } else {
        integrateVelocitiesIn(shared, &own, cells, false);
    }
}

// Moves circles, keeps them within the walls, and makes the relaxing pass over the walls. first: forgets the impulses of the
// step before, which contacts have started with.
void integratePositionsOf(const World *shared, Cells cells, bool first) {
    World own = *shared;
    const World *w = &own;
    for (int slot = cells.from; slot < cells.to; slot++) {
        float4 c = w->circle[slot];
        float4 m = w->motion[slot];
        float4 t = w->traits[slot];
        float2 bounce = w->wallBounce[slot];
        float loaded = w->load[slot].z;
        float4 moved;
        bool clear = moveOffWalls(w, slot, c, m, &moved);
        if (clear & (t.x != 0.0f) & (t.z == 0.0f) & (t.w == 0.0f) & (bounce.x == 0.0f) & (bounce.y == 0.0f)) {
            w->motion[slot] = moved;
        } else {
#ifdef RECORDING
            m = integratePositions(shared, slot, c, m, t.x == 0.0f);
            float2 v = m.zw;
            if (t.x != 0.0f) relaxAtWalls(shared, c, &m, &t, bounce, loaded > 0.0f);
            if (w->recording.walls) noteWallsRelaxed(shared, w->recording.wallTouch + 2 * slot, c, t.x, v, m);
#else
            moveCircle(shared, slot, c, &m, &t, bounce, loaded > 0.0f);
#endif
            w->motion[slot] = m;
            w->traits[slot] = t;
        }
        w->load[slot] = (float4)(0.0f, 0.0f, loaded, 0.0f);
        if (first) w->firstCached[slot] = NONE;
    }
}

// Ends the step for circles.
void finish(const World *shared, Cells cells) {
    World own = *shared;
    const World *w = &own;
    for (int slot = cells.from; slot < cells.to; slot++) {
        finalizePositions(w, slot, w->circle[slot], w->motion[slot], w->traits[slot]);
        w->homeFirstCached[slot] = w->firstCached[slot];
#ifdef RECORDING
        if (w->recording.walls) recordWalls(shared, slot);
#endif
    }
}
